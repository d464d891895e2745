"""kusabi limit as an engineer reads it: combinations of actions in the factors of EN 1990, load cases and
nodes by all their names, and the report of a loss of members.

    python3 limit_words_test.py KUSABI SOURCES
"""
import itertools
import json
import pathlib
import subprocess
import sys
import tomllib

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

CASES = SOURCES / "tests" / "cases"
ROOF = CASES / "roof_of_six_actions.toml"

HANGERS = """name = "hangers"
dimension = 2
units = {{ length = "m", force = "kN" }}
[nodes]
"hook, left" = [0, 0]
"hook-right" = [2, 0]
"a b" = [0, 1]
"a" = [2, 1]
"b" = [1, 2]
[[members]]
yield = 10
between = [["hook, left", "a b"], ["hook-right", "a"], ["hook, left", "b"], ["hook-right", "b"]]
[[supports]]
nodes = ["a b", "a", "b"]
[[supports]]
nodes = ["hook, left", "hook-right"]
fixed = ["x"]
[[loads]]
kind = "reference"
nodes = ["hook, left", "hook-right"]
force = [0, -1]
{more}
"""


def plain_loads(file, case, factors):
    """The problem file with the actions of one combination as loads: each times its factor, and the reference action
    as the reference load."""
    text = file.read_text()
    problem = tomllib.loads(text)
    head = text[:text.index("[combinations]")]
    reference = problem["combinations"]["reference"]
    leading = case.removeprefix("6.10 ").split(" leads")[0]
    for action in problem["actions"]:
        name = action["name"]
        factor = factors.get(name, 0)
        if name == reference:
            factor = action["variable"] * (1 if leading == name else action["psi0"])
        for each in action["forces"]:
            head += "[[loads]]\n"
            head += f'kind = "{"reference" if name == reference else "dead"}"\n'
            head += f"nodes = {json.dumps(each['nodes'])}\n"
            head += f"force = {[factor * part for part in each['force']]}\n"
    return head


class LimitCase(KusabiCase):
    def found(self, *words):
        """The result file of a call, and its table."""
        run = self.kusabi("limit", *words, "--output", self.result)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(self.result.read_text()), run.stdout

    def nominal(self, text):
        file = self.folder / "plain.toml"
        file.write_text(text)
        return self.found(file)[0]["result"]["nominal"]


class Actions(LimitCase):
    def test_the_factors_of_each_combination_give_its_worst_case(self):
        found, table = self.found(ROOF)
        self.assertEqual(found["result"]["case"], "6.10 snow leads, crane")
        for case in found["result"]["cases"]:
            factors = {each["action"]: each["factor"] for each in case["critical_factors"]}
            worst = case["maximum"]
            self.assertAlmostEqual(self.nominal(plain_loads(ROOF, case["name"], factors)), worst["upper"]["value"], 6)
        governing = {each["action"]: each["factor"] for each in found["result"]["critical_factors"]}
        self.assertEqual(governing, {"self": 1.35, "ceiling": 1.35, "snow": 1.5, "wind": -1.5 * 0.6,
                                     "crane": 1.5 * 0.7})
        self.assertIn("1.35 self, 1.35 ceiling, -0.9 wind, 1.05 crane; 1.5 snow times the load factor", table)
        self.assertIn("every combination of actions", found["verdict"]["sentence"])
        self.assertIn("6.10 snow leads, crane", found["verdict"]["details"][0])

    def test_no_choice_of_factors_is_worse(self):
        found, _ = self.found(ROOF, "--case", "6.10 snow leads, crane")
        least = min(self.nominal(plain_loads(ROOF, "6.10 snow leads, crane",
                                             dict(zip(("self", "ceiling", "wind", "crane"), factors))))
                    for factors in itertools.product((1, 1.35), (1, 1.35), (-0.9, 0.9), (0, 1.05)))
        self.assertAlmostEqual(found["result"]["maximum"]["upper"]["value"], least, 6)

    def test_an_action_without_psi0_has_no_effect_beside_a_leading_one(self):
        """With snow leading, the hanger of strength 100 carries 100 / (1.5 * 20); with the crew leading, which is
        1.5 * 10, snow accompanies with 1.5 * 0.5 * 20."""
        found, _ = self.found(CASES / "crew_without_psi0.toml")
        worst = {each["name"]: each["maximum"]["upper"]["value"] if "maximum" in each else each["nominal"]
                 for each in found["result"]["cases"]}
        self.assertAlmostEqual(worst["6.10 snow leads"], 100 / 30, 8)
        self.assertAlmostEqual(worst["6.10 crew leads"], (100 - 15) / 15, 8)

    def test_a_reference_action_without_psi0_is_refused_beside_others(self):
        file = self.folder / "roof.toml"
        file.write_text((CASES / "crew_without_psi0.toml").read_text().replace("psi0 = 0.5", "psi0 = 0"))
        self.assertIn("whose psi0 is 0", self.refused("limit", file))
        head, actions = file.read_text().split("[[actions]]", 1)
        file.write_text(head + "[[actions]]" + actions.split("[[actions]]")[0])
        self.assertAlmostEqual(self.found(file)[0]["result"]["nominal"], 100 / 30, 8)

    def test_the_report_has_a_table_of_all_combinations(self):
        self.found(ROOF)
        page = self.kusabi("report", self.result).stdout
        table = page[page.index("Combinations of actions"):]
        for text in ("6.10 wind leads, crew", "-0.9", "1.05", "λ · "):
            self.assertIn(text, table)


class Names(LimitCase):
    def test_cases_without_a_common_factor_are_named(self):
        found, table = self.found(CASES / "two_cases_words.toml")
        detail = found["verdict"]["details"][0]
        self.assertEqual(detail, "Load case two is carried only from 1.2044 on, load case one only up to 0.073278.")
        self.assertIn("under the dead load", table)
        found, table = self.found(CASES / "two_cases_words.toml", "--alpha", "0")
        self.assertEqual(found["verdict"]["details"][0], detail)
        self.assertNotIn("admissible", table)

    def test_a_half_width_of_another_case_is_accepted(self):
        file = CASES / "loads_of_two_cases.toml"
        bounds = [self.found(file, "--alpha", "0.03", "--group-alpha", groups, "--case", "one")[0]["result"]["maximum"]["upper"]
                  for groups in ("one 0=0.02,two 1=0.028", "one 0=0.02")]
        self.assertAlmostEqual(*(bound["value"] for bound in bounds), 9)
        self.assertIn("three", self.refused("limit", file, "--alpha", "0.364", "--group-alpha", "three=1",
                                            "--case", "one"))

    def test_names_with_blanks_commas_and_hyphens_are_kept(self):
        file = self.folder / "hangers.toml"
        file.write_text(HANGERS.format(more=""))
        for text, members in (("a b-hook, left", ["hook, left-a b"]),
                              ("hook-right a b", ["hook, left-a b", "hook-right-a", "hook-right-b"]),
                              ("hook-right-b,hook, left-b", ["hook, left-b", "hook-right-b"]),
                              ("a", ["hook-right-a"])):
            found, _ = self.found(file, "--lose", "1", "--keep", text)
            self.assertEqual(sorted(found["result"]["kept"]), members, text)
        self.assertIn("--keep 'c'", self.refused("limit", file, "--lose", "1", "--keep", "a c"))

    def test_half_widths_of_names_with_commas(self):
        file = self.folder / "hangers.toml"
        file.write_text(HANGERS.format(more="""[[uncertainty]]
name = "gust, east=1"
forces = [{ nodes = ["hook, left"], force = [0, -1] }]
[[uncertainty]]
name = "crowd"
forces = [{ nodes = ["hook-right"], force = [0, -1] }]"""))
        found, _ = self.found(file, "--group-alpha", "gust, east=1=3,crowd=2")
        values = {each["name"]: abs(each["value"]) for each in found["result"]["critical_parameters"]}
        self.assertEqual(values, {"gust, east=1": 3, "crowd": 2})

    def test_the_second_name_of_a_node_of_two_meshes_is_a_name(self):
        for mesh, places in (("A", ((0, 0), (1, 0))), ("B", ((1, 0), (2, 0), (1.5, 1)))):
            rows = "".join(f"{i}, {x}, {y}\n" for i, (x, y) in enumerate(places, 1))
            bars = "1, 1, 2\n" if mesh == "A" else "1, 1, 3\n2, 2, 3\n"
            (self.folder / f"{mesh}.inp").write_text(f"*NODE\n{rows}*ELEMENT, TYPE=T2D2, ELSET=BARS\n{bars}")
        file = self.folder / "two.toml"
        file.write_text("""name = "two meshes"
dimension = 2
units = { length = "m", force = "kN" }
[[mesh]]
name = "A"
file = "A.inp"
[[mesh]]
name = "B"
file = "B.inp"
[[material]]
groups = ["A.BARS", "B.BARS"]
EA = 100
yield = 1.0
[[supports]]
nodes = ["A.1", "B.2"]
[[supports]]
nodes = ["B.1"]
fixed = ["y"]
[[loads]]
kind = "reference"
nodes = ["B.3"]
force = [0.3, -1.0]
""")
        first, _ = self.found(file, "--lose", "1", "--keep", "A.2")
        second, _ = self.found(file, "--lose", "1", "--keep", "B.1")
        self.assertEqual(first["result"]["kept"], second["result"]["kept"])
        self.assertEqual(len(first["result"]["kept"]), 2)


class Loss(LimitCase):
    def test_the_report_shows_the_worst_loss_and_its_collapse(self):
        found, _ = self.found(EXAMPLES / "truss-bridge.toml", "--lose", "1")
        loss = found["result"]["member_loss"]
        names = found["problem"]["structure"]["member_names"]
        self.assertEqual([names[i] for i in loss["lost_index"]], found["result"]["lost"])
        lost = [each["member"] for each in loss["collapse_mode"]["yielding"]]
        self.assertNotIn(found["result"]["lost"][0].split("-"), lost)
        page = self.kusabi("report", self.result).stdout
        self.assertIn("Collapse after the worst loss", page)
        self.assertIn(f"Lost: {found['result']['lost'][0]}", page)
        self.assertIn("bar lost", page)
        singles = page[page.index("Load factor after the loss of one member"):]
        least = min(loss["single"], key=lambda each: each["factor"])["member"]
        self.assertLess(singles.index(least), singles.index("d2-t2"))


class NoDeadLoad(LimitCase):
    TEXT = """name = "hanging node"
dimension = 2
units = {{ length = "m", force = "kN" }}
[nodes]
a = [0, 0]
b = [0, 1]
c = [3, 0]
d = [-2, 0]
[[members]]
yield = 1
between = [["a", "b"]]
[[members]]
yield = 0.25
between = [["a", "c"], ["a", "d"]]
[[supports]]
nodes = ["b", "c", "d"]
[[loads]]
kind = "reference"
nodes = ["a"]
force = [0, -1]
"""

    def test_loads_that_cancel_in_doubles_only_are_loads(self):
        """The sums of 0.1, 0.7, 0.2 and -1, and of 1e16, 1 and -1e16, are zero in doubles and not exactly."""
        for sizes, largest in (((0.1, 0.7, 0.2, -1), 0), ((1e16, 1, -1e16), None)):
            loads = "".join(f'[[loads]]\nkind = "dead"\nnodes = ["a"]\nforce = [{size}, 0]\n' for size in sizes)
            file = self.problem(self.TEXT.format() + loads)
            certificate = self.folder / "cert"
            certificate.unlink(missing_ok=True)
            self.kusabi("limit", file, "--lose", "1", "--certificate", certificate, "--output", self.result)
            lower = json.loads(self.result.read_text())["result"]["factor"]["lower"]
            if largest is None:
                self.assertIsNone(lower)
            if certificate.exists():
                run = self.kusabi("verify", certificate, "--problem", file)
                self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_without_any_dead_load_zero_is_carried_exactly(self):
        certificate = self.folder / "cert"
        found, _ = self.found(self.problem(self.TEXT.format()), "--lose", "1", "--certificate", certificate)
        self.assertEqual(found["result"]["factor"]["lower"]["value"], 0)
        self.assertEqual(self.kusabi("verify", certificate).returncode, 0)


class FewLoads(LimitCase):
    def test_a_stopped_enumeration_of_corners_keeps_the_bound_of_its_cuts(self):
        """Rounds of cuts are left for the 64 corners while the dissipation is limited, which gave no bound."""
        file = CASES / "tower_of_six_loads.toml"
        whole, _ = self.found(file, "--alpha", "1.5")
        run = self.kusabi("limit", file, "--alpha", "1.5", "--node-limit", "2", "--output", self.result)
        self.assertIn(run.returncode, (0, 3))
        worst = json.loads(self.result.read_text())["result"]["maximum"]
        self.assertIsNotNone(worst["lower"])
        self.assertLessEqual(worst["lower"]["value"], whole["result"]["maximum"]["upper"]["value"])
        self.assertGreaterEqual(worst["upper"]["value"], whole["result"]["maximum"]["lower"]["value"])


class Generated(LimitCase):
    """Domes and towers have the numbers of nodes and bars of public examples, and are no mechanisms."""

    @staticmethod
    def example(*words):
        return subprocess.run([KUSABI, "example", *map(str, words)], capture_output=True, text=True, check=False)

    def test_domes_and_towers(self):
        for words, nodes, members in ((("dome", "--rings", 4, "--sectors", 16), 65, 160),
                                      (("dome", "--rings", 4, "--sectors", 24), 97, 240),
                                      (("dome", "--kind", "lantern", "--rings", 7, "--sectors", 24), 192, 528),
                                      (("dome", "--kind", "double-layer", "--rings", 7, "--sectors", 30), 390, 1410),
                                      (("tower", "--storeys", 10), 44, 170)):
            with self.subTest(words):
                file = self.folder / "truss.toml"
                self.assertEqual(self.example(*words, "--output", file).returncode, 0)
                found, _ = self.found(file)
                self.assertEqual((found["problem"]["nodes"], found["problem"]["members"]), (nodes, members))
                self.assertEqual(len(found["problem"]["uncertain_loads"]), 4)
                self.assertGreater(found["result"]["nominal"], 0)

    def test_wrong_sizes_are_refused(self):
        for words in (("dome", "--rings", 1), ("dome", "--sectors", 2), ("dome", "--radius", 0),
                      ("tower", "--storeys", 0), ("tower", "--top", -1)):
            run = self.example(*words)
            self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1))
            self.assertIn(words[1], run.stderr)


main()
