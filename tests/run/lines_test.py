"""kusabi patterns --format jsonl: the list in lines is that of the result file, on any number of
ranks, also of interrupted runs, and is read by kusabi.py, report and draw.

    python3 lines_test.py KUSABI SOURCES
"""
import json
import os
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402

TRUSS = EXAMPLES / "space-truss.toml"
WHOLE = {"displacement", "all_displacements", "support_reactions", "axial_forces", "utilisation", "imbalance", "stresses",
         "von_mises"}


def lean(result):
    """A result without statistics and without what a line leaves out."""
    content = {key: value for key, value in result.items() if key not in ("statistics", "verdict")}
    content["result"] = dict(content["result"])
    content["result"]["patterns"] = [{key: value for key, value in each.items() if key not in WHOLE}
                                     for each in content["result"]["patterns"]]
    return content


class Lines(KusabiCase):
    def setUp(self):
        super().setUp()
        self.lines = self.folder / "result.jsonl"

    def write(self, *words, ranks=1, exit_code=0):
        call = [KUSABI, "patterns", *map(str, words), "--format", "jsonl", "--output", self.lines]
        launcher = os.environ.get("KUSABI_MPIRUN", "mpirun").split()
        run = subprocess.run([*launcher, "-n", str(ranks), *call] if ranks > 1 else [*call, "--serial"],
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, exit_code, run.stderr)
        return run.stdout

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_lines_are_the_list_of_the_result_file(self):
        for name, mu in (("space-truss.toml", 1), ("two-bars.toml", 2), ("paper/elastic-body.toml", 1),
                         ("../tests/cases/plane_truss_and_post.toml", 0.5), ("wedge-in-groove.toml", 0.27)):
            with self.subTest(name):
                expected = self.solve("patterns", name, "--mu", mu)
                self.write(EXAMPLES / name, "--mu", mu)
                result = kusabi.load(self.lines)
                self.assertEqual(lean(result), lean(expected))
                self.assertEqual(result["verdict"]["details"], expected["verdict"]["details"])
                self.assertEqual(list(kusabi.patterns(self.lines)), result.answer["patterns"])
                self.assertEqual(self.files(), ["result.json", "result.jsonl"])

    def test_the_file_does_not_depend_on_the_number_of_ranks(self):
        self.write(TRUSS, "--mu", 1)
        one = self.lines.read_text().splitlines()
        self.write(TRUSS, "--mu", 1, ranks=3)
        three = self.lines.read_text().splitlines()
        self.assertEqual(three[1:], one[1:])
        heads = [json.loads(lines[0]) for lines in (one, three)]
        for head in heads:
            self.assertTrue(head.pop("statistics"))
        self.assertEqual(*heads)

    def test_a_stopped_run_is_resumed(self):
        self.write(TRUSS, "--mu", 1)
        whole = self.lines.read_text().splitlines()[1:]
        state = ("--resume", self.folder / "state")
        self.write(TRUSS, "--mu", 1, "--node-limit", 300, *state, ranks=2, exit_code=3)
        first = kusabi.load(self.lines)
        self.assertTrue(first.partial)
        self.assertIn("result.jsonl.part.1.1", self.files())
        self.assertLess(set(map(json.dumps, first.answer["patterns"])),
                        set(map(json.dumps, kusabi.patterns(self.lines))) | set(json.dumps(json.loads(each)) for each in whole))
        # Lines that a killed run has written after its last state are found again.
        part = self.folder / "result.jsonl.part.1.0"
        part.write_text(part.read_text() + part.read_text().split("\n", 1)[1] + "000000000uu")
        table = self.write(TRUSS, "--mu", 1, *state)
        self.assertEqual(self.lines.read_text().splitlines()[1:], whole)
        self.assertNotIn("part", " ".join(self.files()))
        # Once more: the same answer from the same file.
        self.assertEqual(self.write(TRUSS, "--mu", 1, *state).split("rank")[0], table.split("rank")[0])
        self.assertEqual(self.lines.read_text().splitlines()[1:], whole)

    def test_flat_patterns_in_solid_ones_are_excluded_after_a_resume(self):
        # Of the rest of this list, some flat patterns belong to solid ones.
        for name, mu in (("two-bars.toml", 1), ("plane-truss.toml", 0.48755537)):
            expected = self.solve("patterns", name, "--mu", mu)
            state = ("--resume", self.folder / f"{name}.state")
            for _ in ("first", "again"):
                code = 0 if expected["verdict"]["answered"] else 3
                self.write(EXAMPLES / name, "--mu", mu, *state, exit_code=code)
                self.assertEqual(lean(kusabi.load(self.lines)), lean(expected))

    def test_report_and_draw_read_lines(self):
        self.solve("patterns", "space-truss.toml", "--mu", 0.65, "--whole")
        self.write(TRUSS, "--mu", 0.65)
        for command in ("report", "draw"):
            run = self.kusabi(command, self.lines)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("27", run.stdout)
        cut = self.lines.read_text().splitlines(keepends=True)[:-1]
        self.lines.write_text("".join(cut))
        self.assertIn("expected a result file", self.refused("report", self.lines))
        with self.assertRaises(kusabi.WrongInput):
            kusabi.load(self.lines)
        with self.assertRaises(kusabi.WrongInput):
            list(kusabi.patterns(self.lines))

    def test_wrong_calls_are_refused(self):
        good = ("patterns", TRUSS, "--mu", 0.65, "--format", "jsonl")
        self.assertIn("requires --output", self.refused(*good))
        output = ("--output", self.lines)
        for more in (("--csv", "-"), ("--whole",), ("--group", 1), ("--exists",), ("--sort", "critical"), ("--sort", "margin"),
                     ("--vtu", self.folder / "vtu")):
            with self.subTest(more):
                self.assertIn("--format jsonl", self.refused(*good, *output, *more))
        self.assertIn("--output -", self.refused(*good, "--output", "-"))
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    main()
