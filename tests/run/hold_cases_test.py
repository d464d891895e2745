"""`kusabi hold` of a file with load cases: what all of them hold, and a row of each. Closed forms of a block on a
rough floor under wind.

    python3 hold_cases_test.py KUSABI SOURCES
"""
import csv
import pathlib
import sys
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main, with_ends  # noqa: E402: beside the folder of this file

#: Weight 1 on a floor; wide, so that it slides before it tips.
BLOCK = """name = "block in the wind"
dimension = 2
units = { length = "m", force = "kN" }

[[mesh]]
name = "b"
corners = [[0, 0], [4, 0], [4, 1], [0, 1]]
divisions = [4, 1]
E = 1e6
nu = 0.3
thickness = 1
plane = "strain"

[[contact]]
nodes = ["b.bottom"]
normal = [0, 1]

[[loads]]
kind = "dead"
nodes = ["b.2,1"]
force = [0, -1]
"""


def wind(case, kind, node, force):
    return f'\n[[loads]]\nkind = "{kind}"\ncase = "{case}"\nnodes = ["b.{node}"]\nforce = [{force}, 0]\n'


#: The wind alone, beside the weight: 0.2 from the left, 0.3 from the right.
DEAD = BLOCK + wind("left", "dead", "0,0", 0.2) + wind("right", "dead", "4,0", -0.3)
#: Its size is the factor; from the left with a wind of 0.1 that does not change.
GUST = BLOCK + wind("left", "dead", "0,0", 0.1) + wind("left", "reference", "0,0", 0.2) + wind("right", "reference", "4,0", -0.3)


class HoldCases(KusabiCase):
    def hold(self, text, *words):
        result = self.solve("hold", self.problem(text), *words)
        self.assertEqual(result["verdict"]["exit_code"], 0, result["verdict"])
        return result

    def test_the_coefficient_is_the_largest_of_the_cases(self):
        result = self.hold(DEAD)
        answer = result["result"]
        self.assertAlmostEqual(answer["holding_friction"]["upper"]["value"], 0.3, delta=1e-9)
        self.assertEqual(answer["case"], "right")
        self.assertEqual([each["case"] for each in answer["cases"]], ["left", "right"])
        for each, wanted in zip(answer["cases"], (0.2, 0.3)):
            self.assertAlmostEqual(each["holding_friction"]["upper"]["value"], wanted, delta=1e-9)
            self.assertEqual([each["holding_friction"][end]["standing"] for end in ("lower", "upper")], ["proved"] * 2)
        text = result["verdict"]["sentence"]
        self.assertIn("It cannot hold the dead load in every one of 2 load cases below friction coefficient 0.29999; at 0.30001 it can.", text)
        self.assertIn('Load case "right" needs most friction.', " ".join(result["verdict"]["details"]))

    def test_a_case_that_holds_nothing_decides(self):
        result = self.hold(DEAD, "--mu", 0.25)
        self.assertEqual(result["result"]["intervals"], [])
        self.assertEqual([len(each["intervals"]) for each in result["result"]["cases"]], [1, 0])
        self.assertIn('It cannot hold the dead load at friction coefficient 0.25 in load case "right".', result["verdict"]["sentence"])

    def test_the_factors_are_those_that_all_cases_hold(self):
        # Left: |0.1 + 0.2 x| <= mu. Right: |0.3 x| <= mu.
        mu = 0.25
        result = self.hold(GUST, "--mu", mu)
        answer = result["result"]
        (common,) = map(with_ends, answer["intervals"])
        self.assertAlmostEqual(common["low"], -mu / 0.3, delta=1e-8)
        self.assertAlmostEqual(common["high"], (mu - 0.1) / 0.2, delta=1e-8)
        self.assertEqual(common["standing"], "proved")
        self.assertEqual(answer["outside"], "proved")
        self.assertEqual(answer["case"], "left")
        self.assertIn('The smallest factor is that of load case "right", the largest factor is that of load case "left".',
                      " ".join(result["verdict"]["details"]))
        for each, (low, high) in zip(answer["cases"], ((-1.75, 0.75), (-mu / 0.3, mu / 0.3))):
            (own,) = map(with_ends, each["intervals"])
            self.assertAlmostEqual(own["low"], low, delta=1e-8)
            self.assertAlmostEqual(own["high"], high, delta=1e-8)

    def test_cases_without_a_common_factor(self):
        # Left: 0.2 x in [-1.1, -0.9], as the wind of 1 does not change. Right: |0.3 x| <= 0.1.
        text = BLOCK + wind("left", "dead", "0,0", 1) + wind("left", "reference", "0,0", 0.2) + wind("right", "reference", "4,0", -0.3)
        result = self.hold(text, "--mu", 0.1)
        self.assertEqual(result["result"]["intervals"], [])
        self.assertIn("It can hold no factor of the reference load at friction coefficient 0.1 in every one of 2 load cases.",
                      result["verdict"]["sentence"])

    def test_one_case_is_that_of_its_own(self):
        both = self.hold(GUST, "--mu", 0.25)["result"]["cases"]
        for each in both:
            alone = self.hold(GUST, "--mu", 0.25, "--case", each["case"])["result"]
            self.assertEqual([with_ends(interval) for interval in each["intervals"]],
                             [{key: value for key, value in with_ends(interval).items() if key not in ("pattern", "state")}
                              for interval in alone["intervals"]])

    def test_no_motion_of_another_case_is_named(self):
        # The larger factors are excluded by "left", the smaller ones by "right": one motion each, of the case shown.
        result = self.hold(GUST, "--mu", 0.25)
        self.assertEqual([round(motion["factor"], 6) for motion in result["result"]["excluding_motions"]], [0.75])
        apart = BLOCK + wind("left", "dead", "0,0", 1) + wind("left", "reference", "0,0", 0.2) + wind("right", "reference", "4,0", -0.3)
        self.assertNotIn("excluding_motions", self.hold(apart, "--mu", 0.1)["result"])

    def test_an_early_end_says_what_is_known(self):
        for words in (("--mu", 0.25), ("--mu", "0.25,0.3"), ()):
            for nodes in (1, 2, 4, 6):
                result = self.solve("hold", self.problem(GUST if words else DEAD), *words, "--node-limit", nodes)
                for answer in result["result"].get("points", [result["result"]]):
                    self.assertEqual([each["case"] for each in answer["cases"]], ["left", "right"])
                self.assertNotIn("needs most", " ".join(result["verdict"]["details"]) if result["status"] != "solved" else "")
        stopped = self.solve("hold", self.problem(GUST), "--mu", 0.25, "--node-limit", 1)["verdict"]["sentence"]
        self.assertIn("It is not known whether it can hold any factor of the reference load", stopped)
        # Whatever the other case holds.
        result = self.solve("hold", self.problem(DEAD.replace("[0.2, 0]", "[0.9, 0]")), "--mu", 0.25, "--node-limit", 2)
        self.assertIn('in load case "left"', result["verdict"]["sentence"])

    def test_a_load_that_nothing_resists_decides(self):
        # Smooth: the block slides off.
        text = BLOCK.replace("normal = [0, 1]", "normal = [0, 1]\nfriction_factor = 0")
        text += wind("calm", "dead", "2,0", 0) + wind("gale", "dead", "0,0", 0.1)
        result = self.hold(text)
        self.assertIn("It cannot hold the dead load in every one of 2 load cases", result["verdict"]["sentence"])

    def test_tables_csv_and_report_have_a_row_of_each_case(self):
        table = self.kusabi("hold", self.problem(GUST), "--mu", 0.25).stdout
        rows = [line.split()[0] for line in table.splitlines() if line.startswith(("left ", "right "))]
        self.assertEqual(rows, ["left", "right"])
        place = self.folder / "held.csv"
        self.hold(GUST, "--mu", "0.25,0.5", "--csv", place)
        with open(place, newline="") as file:
            cells = [(row["case"], float(row["mu"])) for row in csv.DictReader(file)]
        self.assertEqual(cells, [(case, mu) for case in ("", "left", "right") for mu in (0.25, 0.5)])
        for text, words in ((GUST, ("--mu", 0.25)), (DEAD, ())):
            self.solve("hold", self.problem(text), *words)
            page = self.kusabi("report", self.result).stdout
            section = page[page.index('id="load-cases"'):]
            self.assertIn("<td>left</td>", section[:section.index("</section>")])

    def test_what_is_for_one_case_is_refused(self):
        for words in (("--mu", 0.25, "--grip"), ("--certificate", self.folder / "c.cert")):
            self.assertIn('expected --case with one of "left", "right"', self.refused("hold", self.problem(DEAD), *words))
        self.assertIn('there is no dead load in load case "b"',
                      self.refused("hold", self.problem(BLOCK.split("[[loads]]")[0] + wind("a", "dead", "0,0", 1) +
                                                        wind("b", "reference", "0,0", 1))))


class CoefficientsOfSurfaces(KusabiCase):
    def test_are_taken_as_they_are(self):
        # A climber on a ladder of slope T, at the share s of its length: s = f (T + w) / (1 + f w) at the limit.
        floor, wall, slope = 0.5, 0.3, 4 / 3
        text = (EXAMPLES / "statics" / "climber-on-a-ladder.toml").read_text()
        text = text.replace("friction_factor = 0.5 ", f"friction_coefficient = {wall} ")
        self.assertIn("expected it in all of them, or friction_factor", self.refused("show", self.problem(text)))
        text = text.replace("normal = [0, 1]", f"normal = [0, 1]\nfriction_coefficient = {floor}", 1)
        result = self.solve("hold", self.problem(text), "--mu", 1)
        (held,) = map(with_ends, result["result"]["intervals"])
        share = floor * (slope + wall) / (1 + floor * wall)
        self.assertAlmostEqual(held["low"], (0.9 - share) / 0.8, delta=1e-8)
        self.assertIn("at the friction given in the file", result["verdict"]["sentence"])
        result = self.solve("hold", self.problem(text))
        multiple = result["result"]["holding_friction"]["upper"]["value"]
        f, w = multiple * floor, multiple * wall
        self.assertAlmostEqual(f * (slope + w) / (1 + f * w), 0.9, delta=1e-8)
        self.assertIn("times the friction given in the file; at", result["verdict"]["sentence"])


class DrawsWhyNot(KusabiCase):
    def test_a_load_that_cannot_be_held_is_drawn_with_its_motion(self):
        self.solve("hold", "statics/tall-block-on-an-incline.toml")
        picture = self.kusabi("draw", self.result).stdout
        xml.etree.ElementTree.fromstring(picture)
        self.assertIn("motion under the dead load", picture)

    def test_motions_come_after_the_states(self):
        self.solve("hold", self.problem(BLOCK + wind("w", "reference", "0,0", 0.2).replace('case = "w"\n', "")), "--mu", 0.5)
        first, last = (self.kusabi("draw", self.result, "--pattern", number).stdout for number in (1, 3))
        self.assertIn("held at factor", first)
        self.assertIn("motion under factor 2.5", last)


if __name__ == "__main__":
    main()
