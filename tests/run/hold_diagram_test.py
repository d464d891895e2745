"""`kusabi hold --diagram`, and the load that each pattern of `kusabi patterns` holds: closed forms, and intervals of single
loads along lines.

    python3 hold_diagram_test.py KUSABI SOURCES
"""
import csv
import json
import math
import pathlib
import sys
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main, moved, with_ends  # noqa: E402: beside the folder of this file
from hold_test import BELOW_CEILING  # noqa: E402: beside this file

#: A moment and a side force at the tip.
PEG = "peg-under-two-loads.toml"
BOTH = (EXAMPLES / PEG).read_text()
#: Length in the hole over radius.
SLENDERNESS = 0.75 * 2


def jams(mu, moment, side):
    """Whitney: the push is 1 downwards, and moments are in units of radius times push."""
    length = SLENDERNESS / (2 * mu)
    return abs(side) >= 1 / mu or abs(moment + mu * (1 + length) * side) >= length


def contains(piece, x, y, slack):
    """True if a piece contains a point: no normal of its edges separates them by more than the slack."""
    if piece["everything"]:
        return True
    points, rays = piece["vertices"], piece["rays"]
    edges = [(a[0] - b[0], a[1] - b[1]) for a in points for b in points if a != b] + rays
    for dx, dy in edges or [(1, 0), (0, 1)]:
        size = math.hypot(dx, dy)
        for nx, ny in ((-dy / size, dx / size), (dy / size, -dx / size)):
            if any(nx * rx + ny * ry > 1e-9 for rx, ry in rays):
                continue
            if nx * x + ny * y > max(nx * px + ny * py for px, py in points) + slack:
                return False
    return True


class HoldDiagram(KusabiCase):
    def diagram(self, text, mu, *words):
        result = self.solve("hold", self.problem(text), "--diagram", "--mu", mu, *words)
        self.assertEqual(result["verdict"]["exit_code"], 0, result["verdict"])
        return result["result"]

    def test_a_peg_jams_by_whitneys_diagram(self):
        for mu in (0.3, 0.5):
            diagram = self.diagram(BOTH, mu)
            self.assertEqual(diagram["cases"], ["moment", "side"])
            checked = {True: 0, False: 0}
            for i in range(-20, 21):
                for k in range(-20, 21):
                    moment, side = 0.41 * i + 0.01, 0.23 * k + 0.003
                    inside = any(contains(piece, moment, side, 1e-7) for piece in diagram["pieces"])
                    jammed = jams(mu, moment, side)
                    near = any(jams(mu, moment + a, side + b) != jammed for a in (-1e-3, 1e-3) for b in (-1e-3, 1e-3))
                    if not near:
                        self.assertEqual(inside, jammed, (mu, moment, side))
                        checked[jammed] += 1
            self.assertGreater(min(checked.values()), 20)

    def test_above_the_critical_coefficient_all_loads_are_held(self):
        self.assertTrue(any(piece["everything"] for piece in self.diagram(BOTH, 0.76)["pieces"]))

    def test_pieces_have_no_redundant_vertices(self):
        # A piece of two candidates begins where the gap opens and ends where loads close it at a third one.
        for piece in self.diagram(BOTH, 0.5)["pieces"]:
            self.assertEqual(len(piece["vertices"]), 4 if len(piece["pattern"]["contact"]) == 2 else 1)
            self.assertEqual(len(piece["rays"]), 2)

    def test_decoupled_parts_hold_loads_that_each_part_holds(self):
        # Two pegs; the second one has other shares of both loads.
        mu, share, other_share = 0.5, -0.4, 0.7
        second = moved(BOTH[BOTH.index("[[mesh]]"):], 10).replace("peg", "second")
        second = second.replace("[0, 0.5]", f"[0, {0.5 * share}]").replace("[0, -0.5]", f"[0, {-0.5 * share}]")
        second = second.replace("force = [1, 0]", f"force = [{other_share}, 0]")
        diagram = self.diagram(BOTH + second, mu)
        self.assertIn(4, {len(each["pattern"]["contact"]) for each in diagram["pieces"]})
        checked = {True: 0, False: 0}
        for i in range(-20, 21):
            for k in range(-20, 21):
                moment, side = 0.41 * i + 0.01, 0.23 * k + 0.003
                both = [jams(mu, moment + a, side + b) and jams(mu, share * (moment + a), other_share * (side + b))
                        for a in (-1e-3, 0, 1e-3) for b in (-1e-3, 0, 1e-3)]
                if any(both) == all(both):
                    inside = any(contains(piece, moment, side, 1e-7) for piece in diagram["pieces"])
                    self.assertEqual(inside, both[0], (moment, side))
                    checked[inside] += 1
        self.assertGreater(min(checked.values()), 20)

    def test_parts_with_one_load_each_hold_both_loads(self):
        # A moment on one peg, a side force on another, and a ladder with its weight only, which stands from 1/3 on.
        parts = BOTH.split("\n[[loads]]")
        body, dead, moments, side = parts[0], parts[1], parts[2:4], parts[4]
        rest = body[body.index("[[mesh]]"):]
        text = "\n[[loads]]".join([body, dead, *moments]) + "\n"
        text += moved("\n[[loads]]".join([rest, dead, side]), 10).replace("peg", "second") + "\n"
        ladder = (EXAMPLES / "ladder.toml").read_text()
        ladder = moved(ladder[ladder.index("[[mesh]]"):ladder.index("[[loads]]\nkind = \"reference\"")], 20)
        for mu, also, held in ((0.5, "", True), (0.5, ladder, True), (0.3, ladder, False)):
            diagram = self.solve("hold", self.problem(text + also), "--diagram", "--mu", mu)["result"]
            self.assertEqual((diagram["open"], bool(diagram["pieces"])), (False, held))
            checked = {True: 0, False: 0}
            for i in range(-20, 21):
                for k in range(-20, 21):
                    moment, side_force = 0.41 * i + 0.01, 0.23 * k + 0.003
                    both = [jams(mu, moment + a, 0) and jams(mu, 0, side_force + b) and held
                            for a in (-1e-3, 0, 1e-3) for b in (-1e-3, 0, 1e-3)]
                    if any(both) == all(both):
                        inside = any(contains(piece, moment, side_force, 1e-7) for piece in diagram["pieces"])
                        self.assertEqual(inside, both[0], (mu, moment, side_force))
                        checked[inside] += 1
            self.assertGreater(min(checked[False], checked[True] if held else 21), 20)

    def test_parts_without_a_dead_load(self):
        # Each block is held if it is pressed into its groove, and not if it is lifted.
        groove = (EXAMPLES / "wedge-in-groove.toml").read_text().replace("divisions = [4, 4]", "divisions = [1, 1]")
        load = '\n[[loads]]\nkind = "reference"\ncase = "{}"\nnodes = ["block.0,1", "block.1,1"]\nforce = [0, {}]\n'
        second = moved(groove[groove.index("[[mesh]]"):] + load.format("lifts", 2), 10).replace("block", "second")
        diagram = self.diagram(groove + load.format("presses", -1) + second, 0.2)
        self.assertEqual(diagram["outside"], "proved")
        for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1), (1e-3, -1e3)):
            held = diagram["cases"] == ["presses", "lifts"] and x > 0 and y < 0
            self.assertEqual(any(contains(piece, x, y, 1e-9) for piece in diagram["pieces"]), held, (x, y))

    def test_without_a_dead_load_pieces_are_cones(self):
        # At a candidate, which alone carries loads within its friction cone, and beside the candidates.
        for node, divisions in (("block.0,1", "[1, 1]"), ("block.1,1", "[2, 1]")):
            groove = (EXAMPLES / "wedge-in-groove.toml").read_text().replace("divisions = [4, 4]", f"divisions = {divisions}")
            load = f'\n[[loads]]\nkind = "reference"\n{{}}nodes = ["{node}"]\nforce = {{}}\n'
            text = groove + load.format('case = "down"\n', [0.1, -1]) + load.format('case = "along"\n', [1, 0.3])
            diagram = self.solve("hold", self.problem(text), "--diagram", "--mu", 0.2)["result"]
            at_candidate = node == "block.0,1"
            self.assertEqual((diagram["open"], diagram["outside"]), (False, "computed" if at_candidate else "proved"))
            alone = any(piece["pattern"]["contact"] == ["block.0,1"] for piece in diagram["pieces"])
            self.assertEqual(alone, at_candidate)
            counted = {True: 0, False: 0}
            for k in range(24):
                x, y = math.cos(0.2 + math.pi * k / 12), math.sin(0.2 + math.pi * k / 12)
                both = groove + load.format("", [0.1 * x + y, 0.3 * y - x])
                interval = with_ends(*self.solve("hold", self.problem(both), "--mu", 0.2)["result"]["intervals"])
                held = interval["high"] is None
                counted[held] += 1
                self.assertEqual(any(contains(piece, x, y, 1e-6) for piece in diagram["pieces"]), held, (x, y))
            self.assertGreater(min(counted.values()), 2)

    def test_lines_are_intervals_of_one_load(self):
        text = (EXAMPLES / "ladder.toml").read_text()
        first, second = text.replace('kind = "reference"', 'kind = "reference"\ncase = "climber"'), """
[[loads]]
kind = "reference"
case = "pull"
nodes = ["ladder.5,1"]
force = [1, 0.5]
"""
        mu, slant = 0.4, 0.3
        pieces = self.diagram(first + second, mu)["pieces"]
        # The pull is slant times the climber's factor.
        both = text + second.replace('case = "pull"\n', "").replace("[1, 0.5]", f"[{slant}, {0.5 * slant}]")
        held = self.solve("hold", self.problem(both), "--mu", mu)["result"]["intervals"]
        ends = [(each["low"], each["high"]) for each in map(with_ends, held)]
        for i in range(-400, 401):
            factor = 0.013 * i + 0.001
            inside = any(contains(piece, factor, slant * factor, 1e-9) for piece in pieces)
            wanted = any((low is None or low <= factor) and (high is None or factor <= high) for low, high in ends)
            if all(end is None or abs(end - factor) > 1e-5 for pair in ends for end in pair):
                self.assertEqual(inside, wanted, factor)
        self.assertTrue(any(end is not None for pair in ends for end in pair))

    def test_pieces_at_a_limit_are_not_known(self):
        # Each load of the diagram holds a range of the other.
        text = BELOW_CEILING
        for kind, force in (('"dead"', [0.3, -1]), ('"reference"\ncase = "h"', [0.1, 0]), ('"reference"\ncase = "v"', [0, -1])):
            text += f'[[loads]]\nkind = {kind}\nnodes = ["a", "b"]\nforce = {force}\n'
        held = with_ends(*self.solve("hold", self.problem(text), "--mu", 0.5, "--case", "h")["result"]["intervals"])
        self.assertAlmostEqual(held["low"], -8, delta=1e-6)
        result = self.solve("hold", self.problem(text), "--mu", 0.5, "--diagram")
        self.assertEqual((result["result"]["pieces"], result["result"]["open"]), ([], True))
        self.assertIn("not known", result["verdict"]["sentence"])
        self.assertEqual(result["verdict"]["exit_code"], 3)

    def test_csv_and_svg_have_the_pieces(self):
        self.diagram(BOTH, 0.5, "--csv", self.folder / "a.csv", "--svg", self.folder / "a.svg")
        rows = list(csv.DictReader((self.folder / "a.csv").read_text().splitlines()))
        self.assertEqual(set(rows[0]), {"piece", "what", "first", "second", "contact"})
        self.assertEqual({row["what"] for row in rows}, {"vertex", "direction"})
        picture = xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()
        areas = [each for each in picture.iter() if each.tag.endswith("polygon") and each.get("class", "").startswith("area")]
        # Pieces with three candidates in contact begin where loads close the gap, far from the others.
        two = {row["piece"] for row in rows if len(row["contact"].split()) == 2}
        self.assertEqual((len(areas), len(two)), (4, 4))
        self.solve("hold", "peg-under-load.toml", "--mu", 0.5, "--csv", self.folder / "b.csv", "--svg", self.folder / "b.svg")
        rows = list(csv.DictReader((self.folder / "b.csv").read_text().splitlines()))
        self.assertEqual([(row["low"] == "", row["high"] == "") for row in rows], [(True, False), (False, True)])
        xml.etree.ElementTree.parse(self.folder / "b.svg")

    def test_invalid_calls_are_refused(self):
        self.assertIn("expected two, each with a reference load", self.refused("hold", EXAMPLES / "ladder.toml", "--mu", 0.4, "--diagram"))
        dead = BOTH.replace('kind = "dead"', 'kind = "dead"\ncase = "side"')
        self.assertIn("a dead load belongs to one load case", self.refused("hold", self.problem(dead), "--mu", 0.4, "--diagram"))
        self.assertIn("cannot be combined with", self.refused("hold", self.problem(BOTH), "--mu", 0.4, "--diagram", "--grip"))
        self.assertIn("--mu", self.refused("hold", EXAMPLES / "ladder.toml", "--csv", self.folder / "a.csv"))


class Firmness(KusabiCase):
    def test_two_bars_have_their_closed_form(self):
        text = (EXAMPLES / "two-bars.toml").read_text()
        place = self.folder / "bars.toml"
        place.write_text(text + f'\n[[loads]]\nkind = "reference"\nnodes = ["tip"]\nforce = [{-math.sqrt(0.5)}, {math.sqrt(0.5)}]\n')
        for mu in (2.5, 3):
            result = self.solve("patterns", place, "--mu", mu)
            (pattern,) = result["result"]["patterns"]
            found = pattern["firmness"]
            for end, wanted in (("low", -(mu + 2) / 2), ("high", (mu - 2) / 2)):
                self.assertAlmostEqual(found[end], wanted, delta=2e-6)
                self.assertTrue(min(found[end], found[end + "_out"]) <= wanted <= max(found[end], found[end + "_out"]))
            self.solve("patterns", place, "--mu", mu, "--csv", self.folder / "a.csv")
            (row,) = csv.DictReader((self.folder / "a.csv").read_text().splitlines())
            self.assertEqual({key: float(row[f"firmness_{key}"]) for key in found}, found)
            lines = self.folder / "a.jsonl"
            self.assertEqual(self.kusabi("patterns", place, "--mu", mu, "--format", "jsonl", "--output", lines).returncode, 0)
            self.assertEqual(json.loads(lines.read_text().splitlines()[1])["firmness"], found)
            self.assertIn("load held from", self.kusabi("patterns", place, "--mu", mu).stdout)
            self.assertTrue(any("holds the reference load up to" in each for each in result["verdict"]["details"]))

    def test_a_groove_has_its_closed_form(self):
        # Of the pattern with all candidates in contact; the others hold no more: theory/loads.md.
        angle, mu = math.radians(15), 0.4
        text = (EXAMPLES / "wedge-in-groove.toml").read_text().replace("divisions = [4, 4]", "divisions = [1, 1]")
        place = self.folder / "groove.toml"
        place.write_text(text + '\n[[loads]]\nkind = "dead"\nnodes = ["block.0,1"]\nforce = [3, 7]\n'
                                '\n[[loads]]\nkind = "reference"\nnodes = ["block.0,1", "block.1,1"]\nforce = [0, 0.5]\n')
        patterns = self.solve("patterns", place, "--mu", mu)["result"]["patterns"]
        low = min(each["firmness"]["low"] for each in patterns)
        high = max(each["firmness"]["high"] for each in patterns)
        self.assertAlmostEqual(low, -(mu * math.cos(angle) + math.sin(angle)), delta=2e-6)
        self.assertAlmostEqual(high, mu * math.cos(angle) - math.sin(angle), delta=2e-6)

    def test_files_without_a_reference_load_have_no_firmness(self):
        for pattern in self.solve("patterns", "wedge-in-groove.toml", "--mu", 0.4, "--pattern-limit", 2)["result"]["patterns"]:
            self.assertNotIn("firmness", pattern)


if __name__ == "__main__":
    main()
