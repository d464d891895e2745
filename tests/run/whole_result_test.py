"""Result files without their problem files: all names are in the file, and its numbers follow from
its structure.

    python3 whole_result_test.py KUSABI SOURCES

With jsonschema (Debian: python3-jsonschema) the results are validated as well.
"""
import json
import math
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    Draft202012Validator = None

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

# Two parts that wedge independently; a node of the first is constrained to the tip and held by a
# spring and a slope.
PROBLEM = """
name = "of everything a little"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0.0, 0.0]
top = [1.0, 1.0]
tip = [1.0, 0.0]
beside = [1.0, 0.0]
far = [2.0, 0.0]
left2 = [10.0, 0.0]
top2 = [11.0, 1.0]
tip2 = [11.0, 0.0]
[[members]]
EA = 1.0
between = [["left", "tip"], ["left2", "tip2"]]
[[members]]
EA = 3.0
between = [["top", "tip"], ["top2", "tip2"], ["beside", "far"]]
[[supports]]
nodes = ["left", "top", "left2", "top2"]
[[supports]]
nodes = ["far"]
direction = [3, 4]
[[springs]]
nodes = ["far"]
axes = ["x"]
stiffness = 0.25
[[ties]]
nodes = ["beside"]
to = ["tip"]
[[contact]]
nodes = ["tip", "tip2"]
normal = [-1.0, 1.0]
friction_factor = 2
"""


class WholeResult(KusabiCase):
    def check_schema(self, result):
        if Draft202012Validator is not None:
            schema = json.loads((SOURCES / "docs" / "result.schema.json").read_text())
            self.assertEqual([error.message for error in Draft202012Validator(schema).iter_errors(result)], [])

    def check_members(self, structure):
        self.assertEqual(len(structure["member_names"]), len(structure["members"]))
        for name, ends in zip(structure["member_names"], structure["members"]):
            self.assertEqual(name, "-".join(structure["node_names"][node] for node in ends))

    def elongations(self, structure, displacements):
        """For each member: (u_2 - u_1) . e, and its length."""
        for first, second in structure["members"]:
            edge = [b - a for a, b in zip(structure["positions"][first], structure["positions"][second])]
            names = structure["node_names"]
            moved = [b - a for a, b in zip(displacements[names[first]], displacements[names[second]])]
            length = math.hypot(*edge)
            yield sum(a * b for a, b in zip(edge, moved)) / length, length

    def test_a_structure_of_all_parts_is_in_the_file(self):
        problem = self.folder / "all.toml"
        problem.write_text(PROBLEM)
        result = self.solve("patterns", problem, "--mu", 3)
        self.check_schema(result)
        structure = result["problem"]["structure"]
        self.check_members(structure)
        number = {name: i for i, name in enumerate(structure["node_names"])}
        self.assertEqual(structure["axial_stiffnesses"], [1, 1, 3, 3, 3])
        self.assertEqual(structure["springs"], [{"node": number["far"], "axis": "x", "stiffness": 0.25}])
        (inclined,) = structure["inclined_supports"]
        self.assertEqual(inclined["node"], number["far"])
        x, y = inclined["direction"]
        self.assertAlmostEqual(4 * x, 3 * y, delta=1e-14 * abs(y))
        self.assertEqual(structure["ties"], [{"node": number["beside"], "to": [{"node": number["tip"], "weight": 1}]}])
        self.assertEqual(structure["fixed"], {axis: [number[name] for name in ("left", "top", "left2", "top2")]
                                              for axis in "xy"})
        self.assertEqual([each["friction"] for each in result["problem"]["contact"]], [2, 2])

        patterns = result["result"]["patterns"]
        self.assertEqual({pattern["block"] for pattern in patterns}, {1, 2})
        for pattern in patterns:
            moved = dict(zip(structure["node_names"], pattern["all_displacements"], strict=True))
            self.assertEqual(moved["beside"], moved["tip"])
            self.assertAlmostEqual(3 * moved["far"][0] + 4 * moved["far"][1], 0, delta=1e-12)
            for (elongation, length), stiffness, force in zip(self.elongations(structure, moved),
                                                              structure["axial_stiffnesses"], pattern["axial_forces"]):
                self.assertAlmostEqual(stiffness * elongation / length, force, delta=1e-12)

    def test_uncertain_loads_add_up_to_the_critical_load(self):
        result = self.solve("limit", "gust.toml", "--alpha", 0.5, "--curve")
        self.check_schema(result)
        answer, problem = result["result"], result["problem"]
        loads, parameters = problem["uncertain_loads"], answer["critical_parameters"]
        self.assertEqual(len(loads), problem["m"])
        self.assertEqual([load["name"] for load in loads], [each["name"] for each in parameters])
        self.assertLessEqual({"gust", "where the load stands", "x at b1", "x at b2"}, {load["name"] for load in loads})
        made = {}
        for load, parameter in zip(loads, parameters):
            for each in load["components"]:
                place = (each["node"], "xyz".index(each["axis"]))
                made[place] = made.get(place, 0) + parameter["value"] * each["weight"]
        stated = {(each["node"], axis): force for each in answer["critical_part"] for axis, force in enumerate(each["force"])}
        for place in made.keys() | stated.keys():
            self.assertAlmostEqual(made.get(place, 0), stated.get(place, 0), delta=1e-12)

        structure = problem["structure"]
        self.check_members(structure)
        for piece in answer["curve"] + answer["worst_curve"]:
            self.assertLessEqual(set(piece["yielding"]), set(structure["member_names"]))
        for force, (tension, compression), used in zip(answer["forces"], structure["yield_forces"], answer["utilisation"]):
            self.assertAlmostEqual(used, force / tension if force > 0 else -force / compression, delta=1e-12)


if __name__ == "__main__":
    main()
