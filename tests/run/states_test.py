"""Outputs of a run agree in every state of an answer: table, standard error, result file, report,
Python, exit code. Claims that are not proved are marked as such.

    python3 states_test.py KUSABI SOURCES
"""
import html.parser
import json
import os
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

os.environ["KUSABI"] = KUSABI
sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402: of the sources

CASES = SOURCES / "tests" / "cases"
PROGRAMS = SOURCES / "tests" / "programs"
CERTIFICATE = "a certificate in the folder of the test"
QUALIFIED = "computed, not proved"
# The normal is 45 degrees off the edge of the block, which gives a warning.
OFF = """name = "block"
dimension = 2
units = { length = "m", force = "N" }
[[mesh]]
name = "b"
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [2, 1]
E = 1
nu = 0.3
thickness = 1
plane = "stress"
[[supports]]
nodes = ["b.top"]
fixed = ["x", "y"]
[[contact]]
nodes = ["b.bottom"]
normal = [1, 1]
"""

# The state, its exit code, and a call that ends in it.
STATES = (
    ("solved", 0, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65),
    ("none found", 0, "patterns", EXAMPLES / "two-bars.toml", "--mu", 0.5),
    ("ties", 0, "patterns", EXAMPLES / "two-bars.toml", "--mu", 2),
    ("nodes with a margin below the tolerance", 0, "patterns", CASES / "weakly_coupled_bars.toml", "--mu", 3),
    ("ties, with a certificate", 0, "patterns", EXAMPLES / "two-bars.toml", "--mu", 2, "--certificate", CERTIFICATE),
    ("one exists", 0, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--exists"),
    ("none exists", 0, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.3, "--exists"),
    ("proved in exact arithmetic", 0, "patterns", CASES / "weak_coupling_1e-11.toml", "--mu", 1.83834805972901),
    ("undecided", 3, "patterns", CASES / "lever_1e12.toml", "--mu", 3),
    ("node limit", 3, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--node-limit", 9),
    ("node limit before anything is found", 3, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--node-limit", 1),
    ("coefficients not computed", 3, "patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--sort", "critical",
     "--node-limit", 20),
    ("solved", 0, "rays", EXAMPLES / "plane-truss.toml", "--mu", 0.8),
    ("none found", 0, "rays", EXAMPLES / "two-bars.toml", "--mu", 0.5),
    ("node limit", 3, "rays", EXAMPLES / "plane-truss.toml", "--mu", 0.8, "--method", "tree", "--node-limit", 3),
    ("solved", 0, "critical", EXAMPLES / "plane-truss.toml"),
    ("solved pattern by pattern", 0, "critical", EXAMPLES / "plane-truss.toml", "--method", "newton", "--mu-max", 0.8),
    ("none up to the limit", 0, "critical", EXAMPLES / "plane-truss.toml", "--mu-max", 0.3),
    ("an upper bound that is a tie", 0, "critical", CASES / "self_holding_corner.toml"),
    ("no upper bound, a lower one that is not proved", 3, "critical", CASES / "long_lever_critical.toml"),
    *(("node limit", 3, "critical", EXAMPLES / "space-truss.toml", "--node-limit", limit) for limit in (1, 3, 30)),
    *(("node limit", 3, "critical", EXAMPLES / "space-truss.toml", "--method", "descent", "--node-limit", limit)
      for limit in (1, 30)),
    ("solved", 0, "sweep", EXAMPLES / "plane-truss.toml", "--mu", "0.5:0.8:0.1"),
    ("none found", 0, "sweep", EXAMPLES / "two-bars.toml", "--mu", "0.5,1"),
    ("a point within a bracket", 3, "sweep", EXAMPLES / "two-bars.toml", "--mu", "1,2,3"),
    ("node limit", 3, "sweep", EXAMPLES / "space-truss.toml", "--mu", 0.8, "--node-limit", 3),
    ("solved", 0, "sweep", EXAMPLES / "gust.toml", "--alpha", "0:0.6:0.2"),
    ("carried at no factor", 0, "sweep", CASES / "lambda_zero_not_carried.toml", "--alpha", 1),
    ("nominal", 0, "limit", EXAMPLES / "gust.toml"),
    ("worst case", 0, "limit", EXAMPLES / "gust.toml", "--alpha", 0.5),
    ("carried at no factor", 0, "limit", CASES / "lambda_zero_not_carried.toml", "--alpha", 1),
    ("an interval", 0, "limit", CASES / "uplift.toml", "--alpha", 1.5),
    ("an empty interval", 0, "limit", CASES / "uplift.toml", "--alpha", 2.5),
    ("a lower bound that is not proved", 3, "limit", CASES / "bigm_sentence.toml", "--alpha", 0.317, "--cuts", "none",
     "--big-m", 1e-6),
    ("node limit", 3, "limit", EXAMPLES / "paper" / "limit-3x3.toml", "--alpha", 40, "--cuts", "none", "--big-m", 5,
     "--node-limit", 5),
    ("solved", 0, "mip", PROGRAMS / "assignment.mps"),
    ("infeasible", 0, "mip", CASES / "no_entries.mps"),
    ("node limit", 3, "mip", PROGRAMS / "generalised-assignment.mps", "--node-limit", 2, "--no-dive"),
)


class Header(html.parser.HTMLParser):
    """Sentences at the head of a report, by the id of their element."""

    def __init__(self, text):
        super().__init__()
        self.place, self.found = None, {"verdict": [], "reservations": [], "warnings": []}
        self.feed(text)
        self.found = {place: [each.strip() for each in said] for place, said in self.found.items()}

    def handle_starttag(self, tag, attrs):
        name = dict(attrs).get("id")
        if name in self.found:
            self.place = name
        if self.place and tag in ("p", "li"):
            self.found[self.place].append("")

    def handle_endtag(self, tag):
        if tag in ("ul", "header") or (tag == "p" and self.place == "verdict"):
            self.place = None

    def handle_data(self, data):
        if self.place and self.found[self.place]:
            self.found[self.place][-1] += data


def computed_bounds(answer):
    """Bounds of an answer that are not proved and named in a sentence."""
    kind = answer["kind"]
    named = {"critical": [("critical_friction", "lower"), ("critical_friction", "upper")], "friction-steps": [("infeasible",)],
             "mixed-optimum": [("bound",)], "load-steps": [("nominal",)],
             "member-loss": [("factor", "lower")]}.get(kind, [])
    for way in named:
        bound = answer
        for key in way:
            bound = bound[key]
        if bound is not None and bound["standing"] == "computed":
            yield way


class States(KusabiCase):
    def check_report(self, result):
        page = self.kusabi("report", self.result)
        self.assertEqual(page.returncode, 0, page.stderr)
        said = Header(page.stdout).found
        self.assertEqual(said["verdict"], [result["verdict"]["sentence"]])
        self.assertEqual(said["reservations"], result["verdict"]["reservations"])
        self.assertEqual(said["warnings"], ["Warning: " + each for each in result["warnings"]])

    def check_facts(self, result):
        """Other keys of the result file do not contradict its verdict."""
        verdict, answer = result["verdict"], result["result"]
        if answer["kind"] == "sticking":
            self.assertEqual(answer["standing"] == "computed",
                             any("not proved in exact" in each for each in verdict["reservations"]))
        if verdict["ended"] != "solved":
            self.assertEqual(result["status"], verdict["ended"])
        if answer["kind"] == "sticking":
            self.assertEqual(answer["not_counted"], answer.get("marginal", 0) + answer.get("undecided", 0))
            if "cannot stick" in verdict["sentence"]:
                self.assertTrue(verdict["answered"])
                self.assertEqual(answer["count"], 0)
        if answer["kind"] == "critical":
            if answer["critical_friction"]["upper"] and not answer["patterns"]:
                self.assertTrue(answer["patterns_open"])

    def check(self, code, command, *words):
        words = [self.folder / "certificate" if word == CERTIFICATE else word for word in words]
        run = self.kusabi(command, *words, "--output", self.result)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        result = json.loads(self.result.read_text())
        verdict = result["verdict"]
        self.assertEqual(verdict["exit_code"], code)
        self.assertEqual(verdict["answered"], code == 0)
        lines = run.stdout.splitlines()
        self.assertTrue([line for line in lines if line.startswith(verdict["sentence"])], run.stdout)
        for sentence in verdict["reservations"]:
            self.assertIn(sentence, lines)
        if code == 3:
            self.assertIn(verdict["reservations"][0], run.stderr.splitlines())
        for way in computed_bounds(result["result"]):
            self.assertIn(QUALIFIED, verdict["sentence"], way)
        self.check_facts(result)
        quiet = kusabi.run(command, *words[:1], output=self.result,
                           **{words[i].lstrip("-").replace("-", "_"): words[i + 1] if i + 1 < len(words) and
                              not str(words[i + 1]).startswith("--") else True
                              for i in range(1, len(words)) if str(words[i]).startswith("--")})
        result = json.loads(self.result.read_text())  # of this run: a limit may be reached elsewhere
        verdict = result["verdict"]
        self.assertEqual(quiet.partial, code == 3)
        self.assertEqual(quiet.sentence, verdict["sentence"])
        self.assertEqual(quiet.reservations, verdict["reservations"])
        self.assertEqual(kusabi.load(self.result).partial, code == 3)
        if command != "mip":
            self.check_report(result)

    def test_all_outputs_agree(self):
        for state, code, *call in STATES:
            with self.subTest(state, call=" ".join(map(str, call))):
                self.check(code, *call)

    def test_warnings_are_in_every_output(self):
        place = self.folder / "wrong-normal.toml"
        place.write_text(OFF)
        run = self.kusabi("patterns", place, "--mu", 1.5, "--output", self.result)
        result = json.loads(self.result.read_text())
        self.assertTrue(result["warnings"])
        for warning in result["warnings"]:
            self.assertIn("Warning: " + warning, run.stdout)
            self.assertIn("kusabi: warning: " + warning, run.stderr)
        self.check_report(result)
        self.assertEqual(kusabi.load(self.result).warnings, result["warnings"])
        shown = self.kusabi("show", place).stdout
        self.assertIn("Warning: " + result["warnings"][0], shown)

    def test_critical_coefficients_of_patterns_agree(self):
        """The same coefficient in `patterns --sort critical`, in `sweep`, and by lists of
        `patterns` on either side of it."""
        for name in (CASES / "self_holding_corner.toml", EXAMPLES / "plane-truss.toml"):
            with self.subTest(name):
                most = 3 if "corner" in name.name else 0.8
                signs = lambda each: (tuple(each["contact"]), tuple(each["separated"]), tuple(each.get("inactive", ())))
                listed = self.solve("patterns", name, "--mu", most, "--sort", "critical")["result"]["patterns"]
                swept = {signs(each): each for each in self.solve("sweep", name, "--mu-max", most)["result"]["patterns"]}
                for pattern in listed:
                    begins = pattern["critical_friction"]
                    self.assertLess(abs(begins["lower"] - swept[signs(pattern)]["lower"]), 1e-7)
                    self.assertLess(abs(begins["upper"] - swept[signs(pattern)]["upper"]), 1e-7)
                    for mu, there in ((begins["lower"] * (1 - 1e-5), False), (begins["upper"] * (1 + 1e-5), True)):
                        found = self.solve("patterns", name, "--mu", mu)["result"]["patterns"]
                        self.assertEqual(signs(pattern) in map(signs, found), there, (pattern["contact"], mu))

    def test_a_node_in_a_corner_wedges_from_the_coefficient_of_its_walls(self):
        bracket = self.solve("critical", CASES / "self_holding_corner.toml")["result"]["critical_friction"]
        self.assertLess(bracket["lower"]["value"], 0.44906607)  # tan of half of 180 - 131.6335 degrees, 0.449066066...
        self.assertGreater(bracket["upper"]["value"], 0.44906606)


if __name__ == "__main__":
    main()
