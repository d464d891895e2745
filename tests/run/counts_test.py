"""Counts beyond machine integers: N decoupled subproblems of four sign patterns have 4^N.

    python3 counts_test.py KUSABI SOURCES
"""
import json
import math
import os
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

os.environ["KUSABI"] = KUSABI
sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402: of the sources

PLACES = [(-0.7508869520923733, 1.2716841839593873), (1.0918302742866968, -0.045016548483236773),
          (-0.48813974895335166, 1.3327797252620506), (-1.2191070836644, -0.9267744945162195),
          (-1.754560461192023, 0.5084765069183372)]
BARS = {(0, 4): 1.3596066351552616, (1, 4): 0.5841689551883253, (2, 3): 1.9176055237987346, (0, 3): 0.6992846100676439,
        (0, 2): 0.7241429976140636, (3, 4): 1.5547751645414505, (1, 3): 1.2510263709823728, (1, 2): 1.6779925390555128,
        (2, 4): 1.4665057108419697}
NORMALS = {4: (0.6823311979975341, 0.7310431835666414), 3: (0.8256741340126176, 0.5641473428303231),
           2: (0.8864718339796844, 0.4627825488938562)}


def parts(count):
    """Adjacent trusses of five nodes. One has four sign patterns at 2 (80 digits)."""
    text = 'name = "parts"\ndimension = 2\nunits = { length = "m", force = "kN" }\n\n[nodes]\n'
    for part in range(count):
        text += "".join(f"p{part}n{i} = [{x + 5 * part!r}, {y!r}]\n" for i, (x, y) in enumerate(PLACES))
    every = range(count)
    for (a, b), stiffness in BARS.items():
        between = ", ".join(f'["p{part}n{a}", "p{part}n{b}"]' for part in every)
        text += f"\n[[members]]\nEA = {stiffness!r}\nbetween = [{between}]\n"
    held = ", ".join(f'"p{part}n{node}"' for part in every for node in (0, 1))
    text += f"\n[[supports]]\nnodes = [{held}]\n"
    for node, normal in NORMALS.items():
        names = ", ".join(f'"p{part}n{node}"' for part in every)
        text += f"\n[[contact]]\nnodes = [{names}]\nnormal = {list(normal)}\n"
    return text


class Counts(KusabiCase):
    def asked(self, command, count, *words):
        file = self.folder / "parts.toml"
        file.write_text(parts(count))
        run = self.kusabi(command, file, *words, "--output", self.result)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout, json.loads(self.result.read_text())["result"]

    def test_one_subproblem_has_four_patterns(self):
        self.assertEqual(self.asked("patterns", 1, "--mu", 2)[1]["count"], 4)

    def test_counts_up_to_2_to_the_53_are_numbers(self):
        said, result = self.asked("patterns", 26, "--mu", 2)
        self.assertEqual(result["count"], 2 ** 52)
        self.assertNotIn("count_log10", result)
        self.assertIn(f"It can stick in {2 ** 52} ways", said)

    def test_larger_counts_have_all_digits(self):
        for count in (27, 32, 40):
            with self.subTest(count):
                said, result = self.asked("patterns", count, "--mu", 2)
                self.assertEqual(result["count"], str(4 ** count))
                self.assertNotIn("It cannot stick", said)
                if count <= 32:
                    self.assertIn(f"It can stick in {4 ** count} ways", said)
                self.assertEqual(kusabi.load(self.result).answer["count"], 4 ** count)

    def test_a_report_has_large_counts(self):
        self.asked("patterns", 32, "--mu", 2)
        page = self.folder / "page.html"
        self.assertEqual(self.kusabi("report", self.result, "--output", page).returncode, 0)
        self.assertIn(f"It can stick in {2 ** 64} ways", page.read_text())

    def test_a_sweep_has_large_counts(self):
        said, result = self.asked("sweep", 32, "--mu", "0.5,2", "--csv", self.folder / "steps.csv", "--svg",
                                  self.folder / "steps.svg")
        own = [self.asked("patterns", 1, "--mu", mu)[1]["count"] for mu in (0.5, 2)]
        self.assertEqual([int(point["count"]) for point in result["points"]], [each ** 32 if each else 0 for each in own])
        self.assertEqual(result["at_mu_max"]["known"], str(2 ** 64))
        self.assertIn(f"at 2 there are {2 ** 64} sign patterns", said)
        self.assertIn(f",{2 ** 64},{2 ** 64},0", (self.folder / "steps.csv").read_text())
        self.assertIn("log10", (self.folder / "steps.svg").read_text())
        self.asked("sweep", 32, "--mu", "0.5,2")
        rows = kusabi.load(self.result).rows("points")
        self.assertEqual(rows[-1]["count"], 2 ** 64)

    def test_a_count_of_thousands_of_digits_is_an_integer_in_python(self):
        content = {"command": "patterns", "problem": {}, "status": "solved", "verdict": {"answered": True},
                   "result": {"count": "9" * 5000, "marginal": 0, "undecided": 0}}
        self.result.write_text(json.dumps(content))
        self.assertEqual(kusabi.load(self.result).answer["count"], 10 ** 5000 - 1)


if __name__ == "__main__":
    main()
