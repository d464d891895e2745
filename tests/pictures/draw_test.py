"""Tests of kusabi draw: the output is XML, and drawn positions match the result file.

    python3 draw_test.py KUSABI SOURCES
"""
import json
import pathlib
import re
import sys
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KusabiCase, main, nested, with_ends, without  # noqa: E402: beside the folder of this file

SVG = "{http://www.w3.org/2000/svg}"


# A triangle on a hinge, a roller and a spring, and a bar whose far end is tied to the roller.
HELD = """
name = "held in many ways"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0, 0]
top = [1, 1]
tip = [1.2, 0]
far = [0.4, 1.5]
[[members]]
EA = 1
between = [["left", "tip"], ["top", "tip"], ["left", "top"], ["far", "left"]]
[[supports]]
nodes = ["left"]
[[supports]]
nodes = ["top"]
direction = [1, 3]
[[springs]]
nodes = ["tip"]
axes = ["x"]
stiffness = 0.5
[[ties]]
nodes = ["far"]
to = ["top"]
gap = 1
[[contact]]
nodes = ["tip"]
normal = [-1, 1]
"""


def point(element, x, y):
    return complex(float(element.get(x)), -float(element.get(y)))


def with_class(root, tag, kind):
    return [element for element in root.iter(SVG + tag) if kind in element.get("class", "").split()]


def group(root, kind):
    return next(iter(with_class(root, "g", kind)))


class Draw(KusabiCase):
    def draw(self, *words):
        place = self.folder / "out.svg"
        run = self.kusabi("draw", self.result, "--output", place, *words)
        self.assertEqual(run.returncode, 0, run.stderr)
        return xml.etree.ElementTree.parse(place).getroot()

    def marks(self, root):
        """Class and position of each candidate's mark, by name."""
        found = {}
        for each in with_class(root, "g", "candidate"):
            circle = each.find(SVG + "circle")
            found[each.find(SVG + "title").text] = (circle.get("class"), point(circle, "cx", "cy"))
        return found

    def text(self, root):
        return "\n".join(element.text or "" for element in root.iter(SVG + "text")).replace("\u00a0", " ")

    def test_draws_a_pattern_of_a_plane_truss(self):
        result = self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        problem, patterns = result["problem"], result["result"]["patterns"]
        structure = problem["structure"]
        number = next(i for i, each in enumerate(patterns) if each["separated"])
        pattern, root = patterns[number], self.draw("--pattern", number + 1)
        marks = self.marks(root)
        self.assertEqual({name for name, (kind, _) in marks.items() if kind == "contact"}, set(pattern["contact"]))
        self.assertEqual({name for name, (kind, _) in marks.items() if kind == "separated"}, set(pattern["separated"]))

        # Plane structures are drawn with one factor and one shift.
        places = [complex(*place) for place in structure["positions"]]
        bars = [(point(line, "x1", "y1"), point(line, "x2", "y2")) for line in group(root, "rest").iter(SVG + "line")]
        self.assertEqual(len(bars), len(structure["members"]))
        (a, b), ends = structure["members"][0], bars[0]
        scale = (ends[1] - ends[0]) / (places[b] - places[a])
        self.assertAlmostEqual(scale.imag, 0, delta=0.01)
        self.assertGreater(scale.real, 10)
        shift = ends[0] - scale * places[a]
        for (a, b), ends in zip(structure["members"], bars):
            self.assertLess(abs(scale * places[a] + shift - ends[0]), 0.5)
            self.assertLess(abs(scale * places[b] + shift - ends[1]), 0.5)

        # Displacements are multiplied by the factor in the legend.
        factor = float(re.search(r"displacements × (\S+),", self.text(root))[1])
        moved = [complex(*each) for each in pattern["all_displacements"]]
        lines = list(group(root, "moved").iter(SVG + "line"))
        for (a, _), line in zip(structure["members"], lines):
            self.assertLess(abs(scale * (places[a] + factor * moved[a]) + shift - point(line, "x1", "y1")), 0.5)
        largest = max(map(abs, moved))
        self.assertIn(f"largest {largest:.4g} {problem['units']['length']}", self.text(root))

        # Files before 1.0 have displacements by the names of nodes.
        pattern["all_displacements"] = dict(zip(structure["node_names"], pattern["all_displacements"], strict=True))
        self.result.write_text(json.dumps(result))
        old = self.draw("--pattern", number + 1)
        self.assertEqual(xml.etree.ElementTree.tostring(old), xml.etree.ElementTree.tostring(root))

        # Reactions have one scale, and each lies within its friction cone.
        frames = {each["node"]: (complex(*each["n"]), complex(*each["t1"])) for each in problem["contact"]}
        tips = [polygon.get("points").split()[0].split(",") for polygon in with_class(root, "polygon", "reaction")]
        tips = [complex(float(x), -float(y)) for x, y in tips]
        forces = [(each["node"], r[0] * frames[each["node"]][0] + r[1] * frames[each["node"]][1])
                  for each, r in zip(problem["contact"], pattern["reaction"]) if r[0] != 0]
        arrows = tips[:len(forces)]  # the legend has one more
        self.assertEqual(len(tips), len(forces) + 1)
        biggest = max(forces, key=lambda each: abs(each[1]))
        unit = (arrows[forces.index(biggest)] - marks[biggest[0]][1]) / biggest[1]
        for (name, force), tip in zip(forces, arrows):
            self.assertLess(abs(unit * force - (tip - marks[name][1])), 0.1)
        self.assertIn(f"reaction, largest {abs(biggest[1]):.4g} {problem['units']['force']}", self.text(root))
        self.assertIn("μ = 0.8", self.text(root))

    def test_draws_springs_constraints_and_inclined_supports(self):
        problem = self.folder / "held.toml"
        problem.write_text(HELD)
        result = self.solve("patterns", problem, "--mu", 5)
        names = result["problem"]["structure"]["node_names"]
        root = self.draw("--pattern", 1)
        drawn = [point(line, "x1", "y1") for line in group(root, "rest").iter(SVG + "line")]
        ends = [point(line, "x2", "y2") for line in group(root, "rest").iter(SVG + "line")]
        members = result["problem"]["structure"]["members"]
        place = {names[member[i]]: points[k] for k, member in enumerate(members) for i, points in enumerate((drawn, ends))}
        corners = lambda each: [complex(float(x), -float(y)) for x, y in
                                (corner.split(",") for corner in each.get("points").split())]
        # A roller behind the node, along (1, 3), and its ground perpendicular to it; the legend has
        # one more.
        tip, one, other = corners(with_class(root, "polygon", "rolling")[0])
        way = (1 + 3j) / abs(1 + 3j)
        self.assertLess(abs(tip - place["top"]), 0.1)
        self.assertLess(abs(((one + other) / 2 - tip) / abs((one + other) / 2 - tip) - way), 0.01)
        ground = with_class(root, "line", "ground")[0]
        self.assertAlmostEqual(((point(ground, "x1", "y1") - point(ground, "x2", "y2")) / way).real, 0, delta=0.1)
        # A zigzag from the node along x, away from the rest.
        zigzag = corners(with_class(root, "polyline", "spring")[0])
        self.assertLess(abs(zigzag[0] - place["tip"]), 0.1)
        self.assertGreater((zigzag[-1] - zigzag[0]).real, 10)
        self.assertAlmostEqual((zigzag[-1] - zigzag[0]).imag, 0, delta=0.1)
        # A line between the displaced positions of two nodes, hence with the original length and
        # direction.
        tie = with_class(root, "line", "tie")[0]
        self.assertLess(abs(point(tie, "x2", "y2") - point(tie, "x1", "y1") - (place["top"] - place["far"])), 0.5)
        for words in ("inclined support", "spring", "tie"):
            self.assertIn(words, self.text(root))

    def test_draws_all_patterns_on_a_sheet(self):
        result = self.solve("patterns", "space-truss.toml", "--mu", 0.65)
        root = self.draw()
        count = result["result"]["count"]
        self.assertEqual(len(with_class(root, "g", "small")), count)
        self.assertNotIn("the first", self.text(root))
        for number in range(1, count + 1):
            self.assertIn(f"pattern {number}\n", self.text(root) + "\n")

    def test_a_sheet_has_at_most_sixty_patterns_and_says_so(self):
        result = self.solve("patterns", "space-truss.toml", "--mu", 2)
        self.assertGreater(result["result"]["count"], 60)
        root = self.draw()
        self.assertEqual(len(with_class(root, "g", "small")), 60)
        self.assertIn("the first 60 of them", self.text(root))
        self.assertIn(" · pattern 61", self.text(self.draw("--pattern", 61)))

    def test_draws_patterns_of_other_structures_and_subcommands(self):
        for command, name, *words in (("patterns", "morse-taper.toml", "--mu", 0.3, "--pattern-limit", 1),
                                      ("patterns", "brick-by-calculix.toml", "--mu", 0.9),
                                      ("patterns", "peg-in-hole.toml", "--mu", 0.9, "--pattern-limit", 2),
                                      ("critical", "plane-truss.toml"), ("rays", "two-bars.toml", "--mu", 2),
                                      ("rays", "plane-truss.toml", "--mu", 0.6, "--whole")):
            with self.subTest(name=name, command=command):
                result = self.solve(command, name, *words)
                root = self.draw("--pattern", 1)
                self.assertEqual(set(self.marks(root)), {each["node"] for each in result["problem"]["contact"]})
                self.assertIn("μ", self.text(root))

    def test_draws_a_collapse(self):
        answer = self.solve("limit", "gust.toml", "--alpha", 0.5)["result"]
        self.assertEqual(len(with_class(self.draw(), "g", "small")), 2)
        root = self.draw("--pattern", 2)
        yielding = [each["in"] for each in answer["collapse_mode"]["yielding"]]
        for kind in ("tension", "compression"):
            drawn = [line for line in with_class(group(root, "moved"), "line", kind)]
            self.assertEqual(len(drawn), yielding.count(kind))
        self.assertEqual(len(with_class(root, "line", "dead")), len(answer["critical_load"]) + 1)
        self.assertIn(f"λ = {answer['maximum']['upper']['value']:.10g}", self.text(root))

    def check_sweep(self, name, *words):
        """The chart equals the one drawn by the sweep, and its curve matches the result. @return the result"""
        result = self.solve("sweep", name, *words, "--svg", self.folder / "own.svg")["result"]
        root = self.draw()
        self.assertEqual((self.folder / "out.svg").read_text(), (self.folder / "own.svg").read_text())
        curve = with_class(root, "polyline", "curve")[0]
        return result, [tuple(map(float, each.split(","))) for each in curve.get("points").split()]

    def check_scale(self, drawn, expected):
        """Drawn positions are numbers with one scale and one shift."""
        (a, x), (b, y) = max(zip(drawn, expected), key=lambda pair: pair[1]), min(zip(drawn, expected), key=lambda pair: pair[1])
        for place, number in zip(drawn, expected):
            self.assertAlmostEqual(place, b + (a - b) * (number - y) / (x - y), delta=0.1)

    def test_draws_a_sweep_of_friction_as_a_staircase(self):
        result, drawn = self.check_sweep("plane-truss.toml", "--mu", "0.5:0.8:0.1")
        steps = [(step[end], step["count"]) for step in result["staircase"] for end in ("from", "to")]
        self.assertEqual(len(drawn), len(steps))
        self.assertEqual([step["from"] for step in result["staircase"][1:]], [each["upper"] for each in result["patterns"]])
        for axis in (0, 1):
            self.check_scale([place[axis] for place in drawn], [step[axis] for step in steps])
        self.assertIn("expected no --pattern", self.refused("draw", self.result, "--pattern", 1))

    def test_draws_a_sweep_of_loads_as_a_curve(self):
        result, drawn = self.check_sweep("gust.toml", "--alpha", "0:0.6:0.2")
        pieces = result["curve"]
        corners = [(each["from"], each["factor_from"]) for each in pieces] + [(pieces[-1]["to"], pieces[-1]["factor_to"])]
        self.assertEqual(len(drawn), len(corners))
        for axis in (0, 1):
            self.check_scale([place[axis] for place in drawn], [corner[axis] for corner in corners])

    def corners(self, element):
        return [tuple(map(float, corner.split(","))) for corner in element.get("points").split()]

    def test_an_open_point_of_a_sweep_is_drawn_from_its_lower_to_its_upper_bound(self):
        result = self.solve("sweep", "gust.toml", "--alpha", "0:0.6:0.2")
        point = result["result"]["points"][1]
        point["maximum"]["lower"]["value"] -= 1
        self.result.write_text(json.dumps(result))
        lines = [self.corners(each) for each in with_class(self.draw(), "polyline", "s1")[:-1]]
        heights = [abs(a[1] - b[1]) for a, b in lines]
        self.assertGreater(heights.pop(1), 20)
        self.assertLess(max(heights), 0.1)

    def test_paints_nothing_between_two_coefficients(self):
        mus = [0.4, 0.45, 0.55]
        points = self.solve("hold", "ladder.toml", "--mu", ",".join(map(str, mus)))["result"]["points"]
        root = self.draw()
        bars = [self.corners(each) for each in with_class(root, "polyline", "thick")[:-1]]  # the legend has one more
        ends = [(each["friction"], with_ends(each["intervals"][0])[end]) for each in points for end in ("low", "high")]
        drawn = [place for bar in bars for place in bar]
        for axis in (0, 1):
            self.check_scale([place[axis] for place in drawn], [end[axis] for end in ends])
        self.assertEqual(with_class(root, "polygon", "area"), [])
        self.assertIn("between them nothing is computed", self.text(root))

    def test_loads_without_an_end_run_to_the_frame(self):
        points = self.solve("hold", "peg-under-load.toml", "--mu", "0.3,0.4,1.4")["result"]["points"]
        root = self.draw()
        heights = [float(line.get("y1")) for line in with_class(root, "line", "grid")]
        tips = [self.corners(each)[0][1] for each in with_class(root, "polygon", "arrow")]
        unbounded = [[with_ends(each)[end] for point in points for each in point["intervals"]].count(None) for end in ("low", "high")]
        self.assertEqual([tips.count(max(heights)), tips.count(min(heights))], unbounded)
        self.assertEqual(len(tips), sum(unbounded))
        self.assertIn("arrow: no end", self.text(root))
        # The rays of a piece lead to the frame, where it has no edge.
        pieces = self.solve("hold", "peg-under-two-loads.toml", "--mu", 0.5, "--diagram")["result"]["pieces"]
        self.assertTrue(all(each["rays"] for each in pieces))
        root = self.draw()
        grid = with_class(root, "line", "grid")
        sides = [(max if i % 2 else min)(float(line.get(end)) for line in grid for end in (f"{axis}1", f"{axis}2"))
                 for i, axis in enumerate("xxyy")]
        on_frame = lambda a, b: any(abs(a[i // 2] - side) + abs(b[i // 2] - side) < 0.1 for i, side in enumerate(sides))
        areas = [self.corners(each) for each in with_class(root, "polygon", "area")]
        self.assertGreater(len(areas), 2)
        for area in areas:
            self.assertTrue(any(on_frame(a, b) for a, b in zip(area, area[1:] + area[:1])))
        for edge in with_class(root, "line", "edge"):
            ends = [tuple(float(edge.get(axis + end)) for axis in "xy") for end in "12"]
            self.assertFalse(on_frame(*ends), ends)
        self.assertEqual(self.text(root).count("; no end"), len(areas))

    def test_long_sentences_are_broken_at_blanks(self):
        result = self.solve("hold", "peg-under-load.toml", "--mu", ",".join(f"0.{i}" for i in range(30, 60, 3)))
        lines = [each.text for each in with_class(self.draw(), "text", "line")]
        lines = lines[:next(i for i, line in enumerate(lines) if line.replace(".", "").isdigit())]  # ticks
        self.assertEqual(" ".join(lines), result["verdict"]["sentence"])
        self.assertGreater(len(lines), 1)
        self.assertLessEqual(max(map(len, lines)), 122)

    def test_refuses_a_sweep_without_results(self):
        self.solve("sweep", "space-truss.toml", "--mu", 0.8, "--node-limit", 3)
        self.assertEqual(self.refused("draw", self.result), f"{self.result}: has no results that could be drawn; expected a result with at least one\n")

    def test_escapes_names(self):
        self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        self.result.write_text(self.result.read_text().replace('"r1"', json.dumps('<a> & "b" ]]>')))
        self.assertIn('<a> & "b" ]]>', self.marks(self.draw("--pattern", 1)))

    def test_refuses_an_empty_answer(self):
        self.assertEqual(self.solve("rays", "two-bars.toml", "--mu", 1.5)["result"]["count"], 0)
        run = self.kusabi("draw", self.result)
        self.assertEqual((run.returncode, run.stderr), (2, f"{self.result}: has no rays; expected at least one\n"))

    def test_refuses_a_file_that_is_no_result_in_one_line(self):
        whole = self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        text = json.dumps(whole)
        self.result.write_text(text)
        self.check_refusals("draw", (
            ("{", "is not a JSON object"), ("[1]", "is not a JSON object"), ("", "is not a JSON object"),
            (nested(32), "'problem' is missing"), (nested(33), "is nested deeper than 32;"),
            ("[" * 1000000, "is nested deeper than 32;"),
            (without(whole, "problem", "structure"), "'structure' is missing"),
            (without(whole, "result", "patterns", 0, "reaction"), "'reaction' is missing"),
            (text.replace('"members": [[0', '"members": [[99'), "99 is not one of 15 nodes"),
            (text.replace('"command": "patterns"', '"command": "mip"'), "is a result of kusabi mip"),
            (text.replace('"contact": ["', '"contact": ["z'), "there is no candidate 'z"),
            (text.replace('"d": 2', '"d": 3'), "is not a list of 3 numbers")))
        self.assertIn("expected 1 to ", self.refused("draw", self.result, "--pattern", 99))

    def test_refuses_a_friction_coefficient_that_is_no_number(self):
        held = self.solve("hold", "peg-under-load.toml", "--mu", 0.4)
        held["options"]["mu"] = ["x"]
        self.check_refusals("draw", ((json.dumps(held), "'mu' is not a number"),))


if __name__ == "__main__":
    main()
