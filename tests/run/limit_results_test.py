"""Results of kusabi limit of one and two load cases: no load factor, a fatal loss, an early end, struts. Each can be
read by report, draw and kusabi.py, and says what was computed, and no more.

    python3 limit_results_test.py KUSABI SOURCES
"""
import itertools
import json
import os
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

os.environ["KUSABI"] = KUSABI
sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402: in the folder of the sources

# By hand: a carries a horizontal dead load by the members a-c and a-d, of strength 4 and 3, and the reference load by
# a-b, of strength 5. No factor is carried from a dead load of 7 on; of 6, none remains after the loss of a-c.
CORNER = """name = "corner"
dimension = 2
units = {{ length = "m", force = "kN" }}
[nodes]
a = [0, 0]
b = [0, 1]
c = [1, 0]
d = [2, 0]
[[members]]
yield = {{ tension = 5, compression = 5{residual} }}
between = [["a", "b"]]
[[members]]
yield = {{ tension = 4, compression = 4{residual} }}
between = [["a", "c"]]
[[members]]
yield = {{ tension = 3, compression = 3{residual} }}
between = [["a", "d"]]
[[supports]]
nodes = ["b", "c", "d"]
[[loads]]
kind = "reference"
nodes = ["a"]
force = [0, -1]
"""
DEAD = {"carried": 2, "fatal": 6, "none": 9}
STRUTS = ", residual = 0.3"
NO_TIME = ("--time-limit", "1e-9")


def problem_text(kinds, residual="", uncertain=False):
    """The corner with one load case for each of the kinds of dead load, named by its number."""
    text = CORNER.format(residual=residual)
    for number, kind in enumerate(kinds):
        case = f'case = "{number}"\n' if len(kinds) > 1 else ""
        text += f'[[loads]]\nkind = "dead"\nnodes = ["a"]\nforce = [{DEAD[kind]}, 0]\n{case}'
        if uncertain:
            text += f'[[uncertainty]]\nnodes = ["a"]\naxes = ["x"]\n{case}'
    return text


class LimitResults(KusabiCase):
    def limit(self, text, *words):
        """The result of a call, and its table."""
        run = self.kusabi("limit", self.problem(text), *words, "--output", self.result)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        return json.loads(self.result.read_text()), run.stdout

    def check_readers(self):
        page, picture = self.folder / "page.html", self.folder / "picture.svg"
        report = self.kusabi("report", self.result, "-o", page)
        self.assertEqual(report.returncode, 0, report.stderr)
        draw = self.kusabi("draw", self.result, "-o", picture)
        if draw.returncode != 0:
            self.assertIn("has no collapses", draw.stderr)
        result = kusabi.load(self.result)
        self.assertIn(result.sentence, page.read_text())
        self.assertEqual(len(result.rows()), 3)

    def test_all_can_be_read(self):
        kinds = [(kind,) for kind in DEAD] + list(itertools.permutations(DEAD, 2))
        losses = ((), ("--lose", "1"))
        for which, residual, lose in itertools.product(kinds, ("", STRUTS), losses):
            for end in ((), ("--node-limit", "1"), NO_TIME):
                with self.subTest(which=which, residual=residual, call=(*lose, *end)):
                    self.limit(problem_text(which, residual), *lose, *end)
                    self.check_readers()
        for which in kinds:
            with self.subTest(which=which):
                self.limit(problem_text(which, STRUTS, True), "--alpha", "0.5", "--lose", "1", "--node-limit", "1")
                self.check_readers()

    # The case that is carried at no factor comes before one of which a loss leaves none.
    def test_no_factor_governs(self):
        for which in itertools.permutations(("none", "fatal")):
            found, table = self.limit(problem_text(which), "--lose", "1")
            self.assertEqual(found["result"]["case"], str(which.index("none")))
            self.assertIn(f"load case {which.index('none')}", table)
            self.assertEqual(found["result"]["carried_at_none"], "proved")
            self.assertNotIn("member_loss", found["result"])
            self.assertNotIn("yield", " ".join(found["verdict"]["details"]))

    # The nominal factors at residual strength are not those after a loss, or in the worst case.
    def test_a_stopped_run_gives_no_nominal_factor_for_another_one(self):
        _, table = self.limit(problem_text(["carried"], STRUTS), "--lose", "1", "--node-limit", "1")
        self.assertIn("all at their residual strength: open\n", table)
        self.assertNotIn("a lower value", table)
        for words in (["--lose", "1"], ["--alpha", "0.1"]):
            _, table = self.limit(problem_text(["carried"], STRUTS, True), *words, *NO_TIME)
            self.assertNotIn("a lower value", table)
        _, table = self.limit(problem_text(["carried"], ", residual = 0.9"), "--lose", "1", "--keep", "b")
        self.assertRegex(table, r"all at their residual strength: after the worst loss load factor .*; a lower value\n")

    # No factor was found for all loads, so that those of the nominal loads are not said of them.
    def test_a_stopped_run_says_nothing_of_all_loads(self):
        _, table = self.limit(problem_text(["carried", "carried"], "", True), "--alpha", "0.5", "--lose", "1",
                              *NO_TIME)
        self.assertNotIn("are carried under all admissible loads", table)

    # A bound of one case bounds the least factor, whatever the others are.
    def test_a_stopped_run_keeps_the_upper_bound_of_one_case(self):
        found, table = self.limit(problem_text(["carried", "carried"]), "--lose", "1", "--node-limit", "1")
        self.assertEqual(found["status"], "node-limit")
        result = found["result"]
        self.assertAlmostEqual(result["factor"]["upper"]["value"], 0, 6)
        self.assertIsNone(result["factor"]["lower"])
        self.assertEqual((result["case"], result["lost"]), ("0", ["a-b"]))
        self.assertIn("After the loss of a-b the limit load factor is at most 0.", table)
        found, _ = self.limit(problem_text(["fatal", "carried"]), "--lose", "1", "--node-limit", "1")
        self.assertEqual(found["result"]["fatal"], "proved")
        # The target of the call is that of the file, also before the first answer.
        found, _ = self.limit(problem_text(["carried", "fatal"]), "--lose", "1", "--at-least", "8", *NO_TIME)
        self.assertEqual((found["result"]["target"], found["result"]["reached"]), (8, False))

    def test_a_stopped_run_bounds_the_worst_case_by_the_nominal_one(self):
        found, table = self.limit(problem_text(["carried", "carried"], "", True), "--alpha", "0.5", *NO_TIME)
        self.assertEqual(found["status"], "time-limit")
        self.assertAlmostEqual(found["result"]["maximum"]["upper"]["value"], 5, 6)
        self.assertRegex(found["verdict"]["sentence"], r"; some admissible load is carried at no factor above 5(\.0001)?\.$")

    def test_sentences_name_the_strength_of_struts(self):
        found, _ = self.limit(problem_text(["carried"], STRUTS))
        self.assertRegex(found["verdict"]["sentence"],
                         "^It carries 4.9999 times the reference load, while no strut falls below its residual "
                         r"strength; even with all struts at full strength no factor above 5(\.0001)? is carried\.$")
        found, _ = self.limit(problem_text(["carried"], STRUTS), "--lose", "1")
        self.assertIn("After the loss of a-b, even with all struts at full strength, the limit load factor is at most",
                      found["verdict"]["sentence"])
        self.assertIn("With all struts at their residual strength, after the worst loss, the dead load is carried at no load "
                      "factor.",
                      found["verdict"]["details"])

    # The factors of the simplex method have rounding errors, the bounds include them.
    def test_nominal_factors_are_within_their_proved_bounds(self):
        for name in ("tests/cases/uplift", "tests/cases/unloaded_cables", "examples/gust"):
            run = self.kusabi("limit", SOURCES / f"{name}.toml", "--output", self.result)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads(self.result.read_text())["result"]
            for factor, end in zip(result["nominal_interval"], ("minimum", "maximum")):
                self.assertLessEqual(result[end]["lower"]["value"], factor, name)
                self.assertGreaterEqual(result[end]["upper"]["value"], factor, name)

    def test_the_node_limit_is_exact(self):
        for limit in (1, 3, 5):
            run = self.kusabi("limit", SOURCES / "examples" / "truss-bridge.toml", "--lose", "2", "--node-limit", limit,
                              "--output", self.result)
            self.assertEqual(run.returncode, 3, run.stderr)
            found = json.loads(self.result.read_text())
            self.assertEqual((found["status"], found["statistics"]["member_loss"]["nodes"]), ("node-limit", limit))

    # By hand: no factor is carried after the loss of a-c, in case 1 at both strengths, in case 0 after buckling only.
    def test_a_fatal_loss_is_named_in_the_row_of_its_case(self):
        found, table = self.limit(problem_text(["carried", "fatal"], STRUTS), "--lose", "1")
        rows = {each["name"]: each for each in found["result"]["cases"]}
        self.assertEqual((rows["0"].get("fatal"), rows["1"].get("fatal")), ("proved", "proved"))
        self.assertEqual(found["result"]["case"], "1")
        self.check_readers()
        self.assertEqual((self.folder / "page.html").read_text().count("no factor remains after some loss, proved"), 2)
        self.assertRegex(table, r"\n  1: .*after a loss the dead load is carried at no load factor of either sign, proved")
        self.assertRegex(table, r"\n  0: nominal .*\n    at residual strength: .*after a loss the dead load is carried at no "
                                "load factor of either sign, proved")


if __name__ == "__main__":
    main()
