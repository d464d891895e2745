"""kusabi rays --format jsonl: the list in lines is that of the result file, by all methods, on any
number of ranks, also of interrupted and killed runs, and is read by kusabi.py and report.

    python3 ray_lines_test.py KUSABI SOURCES
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402

REFERENCE = json.loads((SOURCES / "tests" / "reference" / "plane-truss.json").read_text())["table"]


def lean(result):
    """A result without statistics and without what lines leave out."""
    content = {key: value for key, value in result.items() if key not in ("statistics", "verdict")}
    content["result"] = dict(content["result"])
    content["result"]["rays"] = [{key: value for key, value in each.items() if key != "displacement"}
                                 for each in content["result"]["rays"]]
    content["result"]["cones"] = [{key: value for key, value in each.items() if key != "rays"}
                                  for each in content["result"]["cones"]]
    return content


class RayLines(KusabiCase):
    def setUp(self):
        super().setUp()
        self.lines = self.folder / "rays.jsonl"

    def truss(self, rows):
        place = self.folder / "truss.toml"
        subprocess.run([KUSABI, "example", "plane-truss", "--rows", str(rows), "--output", place], check=True,
                       capture_output=True)
        return place

    def call(self, *words, ranks=1):
        call = [KUSABI, "rays", *map(str, words), "--format", "jsonl", "--output", str(self.lines)]
        launcher = os.environ.get("KUSABI_MPIRUN", "mpirun").split()
        return [*launcher, "-n", str(ranks), *call] if ranks > 1 else [*call, "--serial"]

    def write(self, *words, ranks=1, exit_code=0):
        run = subprocess.run(self.call(*words, ranks=ranks), capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, exit_code, run.stderr)
        return run

    def parts(self):
        return [path for path in self.folder.iterdir() if ".part." in path.name]

    def entries(self):
        return self.lines.read_text().splitlines()[1:-1]

    def test_lines_are_the_list_of_the_result_file(self):
        for name, mu in (("plane-truss.toml", 0.8), ("two-bars.toml", 2), ("wedge-in-groove.toml", 0.27),
                         ("paper/elastic-body.toml", 0.3), ("../tests/cases/rays_free_pair_of_bars.toml", 1)):
            for method in ("auto", "tree", "double-description"):
                with self.subTest(name, method=method):
                    expected = self.solve("rays", name, "--mu", mu, "--method", method)
                    code = 0 if expected["verdict"]["answered"] else 3
                    self.write(EXAMPLES / name, "--mu", mu, "--method", method, exit_code=code)
                    result = kusabi.load(self.lines)
                    self.assertEqual(lean(result), lean(expected))
                    self.assertEqual(result["verdict"], expected["verdict"])
                    self.assertEqual(list(kusabi.rays(self.lines)), result.answer["rays"])
                    self.assertEqual(self.parts(), [])

    def test_counts_are_those_of_the_reference(self):
        for rows, mu in ((7, "0.7"), (8, "0.65"), (8, "0.8"), (8, "1.0")):
            with self.subTest(rows=rows, mu=mu):
                self.write(self.truss(rows), "--mu", mu, "--method", "tree")
                result = kusabi.load(self.lines)
                known = REFERENCE[str(rows)][mu]
                self.assertEqual(len(result.answer["rays"]), known["rays"])
                self.assertEqual(result.answer["count"], known["rays"])
                self.assertEqual(len(result.answer["cones"]), known["cones"])

    def test_the_rays_do_not_depend_on_method_or_ranks(self):
        truss = self.truss(8)
        lists = set()
        for method in ("auto", "tree", "double-description"):
            for ranks in (1, 2, 3):
                self.write(truss, "--mu", 0.8, "--method", method, ranks=ranks)
                lists.add("\n".join(self.entries()))
        self.assertEqual(len(lists), 1)

    def test_a_stopped_run_is_resumed(self):
        truss = self.truss(8)
        call = (truss, "--mu", 0.8, "--method", "tree")
        self.write(*call)
        whole = self.entries()
        state = ("--resume", self.folder / "state")
        self.write(*call, "--node-limit", 150, *state, ranks=2, exit_code=3)
        first = kusabi.load(self.lines)
        self.assertTrue(first.partial)
        self.assertEqual(first.answer["cones"], [])
        self.assertEqual(len(self.parts()), 2)
        states = {json.dumps(json.loads(each)["reaction"]) for each in whole}
        self.assertGreater(len(first.answer["rays"]), 0)
        self.assertLess({json.dumps(each["reaction"]) for each in first.answer["rays"]}, states)
        # Lines that a killed run has written after its last state are found again.
        part = self.folder / "rays.jsonl.part.1.0"
        part.write_text(part.read_text() + part.read_text().split("\n", 1)[1] + "0f0")
        table = self.write(*call, *state).stdout
        self.assertEqual(self.entries(), whole)
        self.assertEqual(kusabi.load(self.lines).answer["count"], len(whole))
        self.assertEqual(self.parts(), [])
        # Once more: the same answer from the same file.
        self.assertEqual(self.write(*call, *state).stdout, table)
        self.assertEqual(self.entries(), whole)

    def test_a_killed_run_is_resumed(self):
        call = (self.truss(12), "--mu", 1, "--method", "tree", "--quiet")
        self.write(*call)
        whole = self.entries()
        resumed = (*call, "--resume", self.folder / "state", "--checkpoint-interval", 0.1)
        run = subprocess.Popen(self.call(*resumed), stderr=subprocess.DEVNULL)
        checkpoint = None
        while checkpoint is None and run.poll() is None:
            checkpoint = next(self.folder.glob("state.search*"), None)
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        self.write(*resumed, ranks=2)
        self.assertEqual(self.entries(), whole)
        self.assertEqual(kusabi.load(self.lines).answer["count"], len(whole))
        self.assertEqual(self.parts(), [])

    def test_a_time_limit_leaves_a_valid_file(self):
        call = (self.truss(20), "--mu", 1, "--quiet")
        for ranks in (1, 2):
            self.write(*call, "--method", "tree", "--time-limit", 2, ranks=ranks, exit_code=3)
            result = kusabi.load(self.lines)
            self.assertTrue(result.partial)
            self.assertEqual(result["status"], "time-limit")
            self.assertEqual(result.answer["count"], len(result.answer["rays"]))
            self.assertEqual([each["number"] for each in result.answer["rays"]],
                             list(range(1, result.answer["count"] + 1)))
            self.assertEqual(self.parts(), [])

    def test_report_reads_lines(self):
        self.write(EXAMPLES / "plane-truss.toml", "--mu", 0.65)
        run = self.kusabi("report", self.lines)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("16 extremal rays", run.stdout)
        self.lines.write_text("".join(self.lines.read_text().splitlines(keepends=True)[:-1]))
        self.assertIn("expected a result file", self.refused("report", self.lines))
        with self.assertRaises(kusabi.WrongInput):
            list(kusabi.rays(self.lines))

    def test_wrong_calls_are_refused(self):
        good = ("rays", EXAMPLES / "plane-truss.toml", "--mu", 0.65, "--format", "jsonl")
        self.assertIn("requires --output", self.refused(*good))
        output = ("--output", self.lines)
        for more in (("--csv", "-"), ("--whole",), ("--dot", self.folder / "dot"), ("--vtu", self.folder / "vtu")):
            with self.subTest(more):
                self.assertIn("--format jsonl", self.refused(*good, *output, *more))
        self.assertIn("--output -", self.refused(*good, "--output", "-"))


if __name__ == "__main__":
    main()
