"""Tests of --vtu with VTK or meshio as reader: the numbers match the JSON and statics.

    python3 read_vtu_test.py vtk|meshio KUSABI SOURCES

Exit code 77 (skipped): numpy or the reader is not installed (Debian: python3-vtk9, python3-meshio).
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

SOURCES = pathlib.Path(sys.argv.pop()).resolve()
KUSABI = sys.argv.pop()
READER = sys.argv.pop()
try:
    import numpy as np
    if READER == "vtk":
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkDataArray
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    else:
        import meshio
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


# Quadrilaterals and triangles in turn, and bars of which one has a strength.
MIXED = """
name = "of several shapes"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [1.0, 0.0]
c = [1.0, 1.0]
d = [0.0, 1.0]
e = [2.0, 0.0]
f = [2.0, 1.0]
g = [3.0, 0.0]
h = [3.0, 1.0]
[[elements]]
E = 1.0
nu = 0.25
thickness = 0.5
plane = "strain"
between = [["a", "b", "c", "d"], ["b", "e", "f"], ["e", "g", "h", "f"], ["b", "f", "c"]]
[[members]]
EA = 0.1
yield = { tension = 3, compression = 2 }
between = [["c", "h"]]
[[members]]
EA = 0.1
between = [["b", "g"]]
[[supports]]
nodes = ["a", "d"]
[[contact]]
nodes = ["g", "h"]
normal = [-1.0, 0.2]
"""


class Grid:
    """points, data at points, at cells and of the whole grid, by name; cells as (type of VTK, nodes)."""


def read_by_vtk(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    read, grid = reader.GetOutput(), Grid()
    grid.vtk = read
    grid.points = vtk_to_numpy(read.GetPoints().GetData())
    fields = lambda data: {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    grid.at_points, grid.at_cells = fields(read.GetPointData()), fields(read.GetCellData())
    whole = read.GetFieldData()
    grid.of_whole = {whole.GetArrayName(i): whole.GetArray(i).GetTuple1(0) for i in range(whole.GetNumberOfArrays())}
    nodes_of = lambda cell: [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
    grid.cells = [(read.GetCellType(i), nodes_of(read.GetCell(i))) for i in range(read.GetNumberOfCells())]
    return grid


def read_by_meshio(path):
    read, grid = meshio.read(path), Grid()
    number = lambda block: {"vertex": 1, "line": 3}.get(block.type, 0)
    grid.points = read.points
    grid.cells = [(number(block), list(nodes)) for block in read.cells for nodes in block.data]
    grid.at_points = read.point_data
    grid.of_whole = {name: numbers.item() for name, numbers in read.field_data.items()}
    grid.at_cells = {name: np.concatenate(parts) for name, parts in read.cell_data.items()}
    return grid


read = read_by_vtk if READER == "vtk" else read_by_meshio


def forces_of_bars(grid):
    """Forces of bars on their nodes: nodes x 3."""
    forces = np.zeros_like(grid.points)
    for (kind, nodes), force in zip(grid.cells, grid.at_cells["axial_force"]):
        if kind != 3:
            continue
        along = grid.points[nodes[1]] - grid.points[nodes[0]]
        pull = force * along / np.linalg.norm(along)
        forces[nodes[0]] += pull
        forces[nodes[1]] -= pull
    return forces


def size_of(places):
    """Area or volume of a cell with straight sides, by its nodes, corners first; no simplex: if its sides are parallel."""
    count, d = places.shape
    if count in ((3, 6) if d == 2 else (4, 10)):
        return abs(np.linalg.det(places[1:d + 1] - places[0])) / math.factorial(d)
    return abs(np.linalg.det(places[[1, 3] if d == 2 else [1, 3, 4]] - places[0]))


class ReadVtu(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_kusabi(self, *words):
        words = [KUSABI, *map(str, words), "--serial"]
        run = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)

    def series(self, *words):
        """The JSON of a call and the grids that its .pvd lists, in its order."""
        self.run_kusabi(*words, "--vtu", self.folder / "vtu", "--output", self.folder / "out.json")
        (collection,) = (self.folder / "vtu").glob("*.pvd")
        files = [entry.get("file") for entry in xml.etree.ElementTree.parse(collection).iter("DataSet")]
        return json.loads((self.folder / "out.json").read_text()), [read(collection.parent / name) for name in files]

    @staticmethod
    def close(left, right):
        np.testing.assert_allclose(left, right, rtol=0, atol=1e-9 * np.abs(right).max())

    @staticmethod
    def vanish(forces):
        """In configurations: their normal reactions add up to one unit of force."""
        np.testing.assert_allclose(forces, 0, atol=1e-9)

    def check_configuration(self, problem, pattern, grid):
        """The JSON's numbers at all nodes, and equilibrium of the whole."""
        d = problem["d"]
        names = problem["structure"]["node_names"]
        self.check_structure(problem["structure"], d, grid)
        displacement = np.array(pattern["all_displacements"])
        np.testing.assert_array_equal(grid.at_points["displacement"][:, :d], displacement)
        supports = np.array([pattern["support_reactions"].get(name, [0] * d) for name in names])
        np.testing.assert_array_equal(grid.at_points["support_reaction"][:, :d], supports)
        states = {name: state for name, state in zip(names, grid.at_points["state"].ravel()) if state}
        self.assertEqual({name for name, state in states.items() if state == 1}, set(pattern["contact"]))
        self.assertEqual({name for name, state in states.items() if state == 2}, set(pattern["separated"]))
        self.check_internal_forces(problem["structure"], pattern, grid)
        forces = grid.at_points["contact_reaction"] + grid.at_points["support_reaction"]
        self.vanish(forces.sum(axis=0))
        self.vanish(np.cross(grid.points, forces).sum(axis=0) / np.abs(grid.points).max())

    def check_internal_forces(self, structure, pattern, grid):
        """Axial forces, utilisation and stresses are bit by bit those of the JSON."""
        for name, key in (("axial_force", "axial_forces"), ("utilisation", "utilisation")):
            self.assertEqual(name in grid.at_cells, key in pattern, key)
            if key in pattern:
                of_members = grid.at_cells[name].ravel()[:len(structure["members"])]
                np.testing.assert_array_equal(of_members, np.array(pattern[key], dtype=float))
        elements = [tuple(nodes) for group in structure.get("elements", []) for nodes in group["nodes"]]
        self.assertEqual(bool(elements), "stresses" in pattern)
        cell_of = {tuple(nodes): cell for cell, (_, nodes) in enumerate(grid.cells)}
        for key, field in (("stresses", "stress"), ("von_mises", "von_mises")):
            self.assertEqual(key in pattern, field in grid.at_cells, key)
            if elements:
                drawn = grid.at_cells[field][[cell_of[nodes] for nodes in elements]]
                np.testing.assert_array_equal(drawn.reshape(np.shape(pattern[key])), pattern[key])

    def check_structure(self, structure, d, grid):
        """The structure of the grid is that of the JSON."""
        np.testing.assert_array_equal(grid.points[:, :d], structure["positions"])
        self.assertEqual([list(nodes) for kind, nodes in grid.cells if kind == 3], structure.get("members", []))
        elements = [nodes for group in structure.get("elements", []) for nodes in group["nodes"]]
        self.assertEqual(sorted(list(nodes) for kind, nodes in grid.cells if kind != 3), sorted(elements))
        candidates = np.zeros(len(structure["positions"]))
        candidates[structure["candidates"]] = 1
        np.testing.assert_array_equal(grid.at_points["candidate"].ravel(), candidates)
        for axis, flags in zip("xyz", grid.at_points["fixed"].T):
            self.assertEqual(list(np.flatnonzero(flags)), structure["fixed"].get(axis, []))

    def check_contact(self, problem, pattern, grid):
        """u and r of each candidate in its own frame, against F as kusabi export has it."""
        d = problem["d"]
        names = problem["structure"]["node_names"]
        moved, pressed = [], []
        for frame in problem["contact"]:
            axes = np.array([frame[axis] for axis in ("n", "t1", "t2")[:d]])
            node = names.index(frame["node"])
            moved.append(axes @ grid.at_points["displacement"][node, :d])
            pressed.append(axes @ grid.at_points["contact_reaction"][node, :d])
            np.testing.assert_allclose(grid.at_points["normal"][node, :d], axes[0], atol=1e-15)
        self.close(np.array(moved), np.array(pattern["displacement"]))
        self.close(np.array(pressed), np.array(pattern["reaction"]))
        self.close(self.compliance @ np.concatenate(pressed), np.concatenate(moved))

    def export_compliance(self, file):
        place = self.folder / "f.mtx"
        self.run_kusabi("export", "matrix", file, "--matrix", "compliance", "--output", place)
        lines = [line for line in place.read_text().splitlines() if not line.startswith("%")]
        rows = int(lines[0].split()[0])
        if len(lines[0].split()) == 2:
            lower = iter(map(float, lines[1:]))
            self.compliance = np.zeros((rows, rows))
            for column in range(rows):
                for row in range(column, rows):
                    self.compliance[row, column] = self.compliance[column, row] = next(lower)
            return
        self.compliance = np.zeros((rows, rows))
        for line in lines[1:]:
            row, column, value = line.split()
            self.compliance[int(row) - 1, int(column) - 1] = self.compliance[int(column) - 1, int(row) - 1] = float(value)

    def check_facts(self, result, pattern, grid):
        """Use of friction and gaps by candidate, and the numbers of the whole grid."""
        problem = result["problem"]
        mu, uses, gaps = result["result"]["friction"], np.zeros(len(grid.points)), np.zeros(len(grid.points))
        for node, each, force, motion in zip(problem["structure"]["candidates"], problem["contact"], pattern["reaction"],
                                             pattern["displacement"]):
            if each["node"] in pattern["contact"]:
                uses[node] = np.linalg.norm(force[1:]) / (mu * each["friction"] * force[0])
            else:
                gaps[node] = motion[0]
        np.testing.assert_allclose(grid.at_points["friction_use"].ravel(), uses, rtol=1e-12)
        np.testing.assert_allclose(grid.at_points["gap"].ravel(), gaps, rtol=1e-12)
        self.assertEqual([grid.of_whole[name] for name in ("mu", "margin")], [mu, pattern["margin"]])
        if READER == "vtk":  # meshio has no units
            units = {name: grid.vtk.GetPointData().GetArray(name).GetInformation().Get(vtkDataArray.UNITS_LABEL())
                     for name in ("displacement", "gap", "contact_reaction")}
            length, force = problem["units"]["length"], problem["units"]["force"]
            self.assertEqual(units, {"displacement": length, "gap": length, "contact_reaction": force})

    def test_nodes_have_the_numbers_of_their_mesh(self):
        _, (grid, *_) = self.series("critical", SOURCES / "examples/morse-taper.toml")
        names = json.loads((self.folder / "out.json").read_text())["problem"]["structure"]["node_names"]
        self.assertEqual(list(grid.at_points["node_tag"].ravel()), [int(name.removeprefix("taper.")) for name in names])
        # The script beside the files is Python, and names their data.
        (script,) = (self.folder / "vtu").glob("*.py")
        compile(script.read_text(), str(script), "exec")
        self.assertEqual(script.stem, "critical")
        for name in ("displacement", "contact_reaction", "von_mises"):
            self.assertIn(name, {**grid.at_points, **grid.at_cells})
            self.assertIn(f'"{name}"', script.read_text())

    def test_patterns_of_a_space_truss_match_the_result(self):
        file = SOURCES / "examples/space-truss.toml"
        result, grids = self.series("patterns", file, "--mu", 0.65)
        self.export_compliance(file)
        patterns = result["result"]["patterns"]
        self.assertEqual(len(grids), len(patterns))
        self.assertGreater(len(patterns), 1)
        self.run_kusabi("show", file, "--vtu", self.folder / "shown.vtu")
        stiffness = read(self.folder / "shown.vtu").at_cells["axial_stiffness"].ravel()
        for pattern, grid in zip(patterns, grids):
            self.check_configuration(result["problem"], pattern, grid)
            self.check_contact(result["problem"], pattern, grid)
            self.check_facts(result, pattern, grid)
            forces = grid.at_cells["axial_force"].ravel()
            np.testing.assert_array_equal(forces, pattern["axial_forces"])
            both = grid.at_points["contact_reaction"] + grid.at_points["support_reaction"]
            self.vanish(forces_of_bars(grid) + both)
            for (_, (a, b)), force, each in zip(grid.cells, forces, stiffness):
                along = grid.points[b] - grid.points[a]
                stretch = along @ (grid.at_points["displacement"][b] - grid.at_points["displacement"][a])
                self.assertAlmostEqual(force, each * stretch / (along @ along), delta=1e-8)

    def test_patterns_of_a_mesh_in_the_plane_match_the_result(self):
        file = SOURCES / "examples/snap-hook.toml"
        result, grids = self.series("patterns", file, "--mu", 1.5)
        self.export_compliance(file)
        self.assertTrue(grids)
        for pattern, grid in zip(result["result"]["patterns"], grids):
            self.check_configuration(result["problem"], pattern, grid)
            self.check_contact(result["problem"], pattern, grid)

    def test_the_critical_pattern_of_a_truss_matches_the_result(self):
        self.check_critical(SOURCES / "examples/plane-truss.toml")

    def test_the_critical_pattern_of_a_body_matches_the_result(self):
        self.check_critical(SOURCES / "examples/elastic-body.toml")

    def test_elements_of_several_shapes_match_the_result(self):
        problem = self.folder / "mixed.toml"
        problem.write_text(MIXED)
        result, grids = self.series("patterns", problem, "--mu", 2)
        self.assertTrue(grids)
        self.assertEqual(len(result["problem"]["structure"]["elements"]), 2)
        for pattern, grid in zip(result["result"]["patterns"], grids):
            self.assertIn(None, pattern["utilisation"])
            self.check_configuration(result["problem"], pattern, grid)

    def check_critical(self, file):
        result, grids = self.series("critical", file)
        self.assertEqual(len(grids), len(result["result"]["patterns"]))
        for pattern, grid in zip(result["result"]["patterns"], grids):
            self.check_configuration(result["problem"], pattern, grid)

    def test_rays_match_the_result(self):
        result, grids = self.series("rays", SOURCES / "examples/plane-truss.toml", "--mu", 0.6, "--whole")
        self.assertEqual(len(grids), result["result"]["count"])
        candidates = [frame["node"] for frame in result["problem"]["contact"]]
        for ray, grid in zip(result["result"]["rays"], grids):
            ray["contact"] = [name for name, its in zip(candidates, ray["state"]) if its.startswith("s") and its != "separates"]
            ray["separated"] = [name for name, its in zip(candidates, ray["state"]) if its == "separates"]
            self.check_configuration(result["problem"], ray, grid)

    def test_a_collapse_matches_the_result(self):
        result, grids = self.series("limit", SOURCES / "examples/gust.toml", "--alpha", 0.5)
        answer = result["result"]
        structure = result["problem"]["structure"]
        names = structure["node_names"]
        for grid, mode, forces, load_factor, held in zip(
                grids, (answer["nominal_mode"], answer["collapse_mode"]), (answer["nominal_forces"], answer["forces"]),
                (answer["nominal"], answer["maximum"]["upper"]["value"]),
                (answer["nominal_support_reactions"], answer["support_reactions"])):
            self.assertTrue(held)
            reactions = np.array([held.get(name, [0, 0]) for name in names])
            np.testing.assert_array_equal(grid.at_points["support_reaction"][:, :2], reactions)
            np.testing.assert_array_equal(grid.at_cells["axial_force"].ravel(), forces)
            strength = [row[0] if force > 0 else row[1] for row, force in zip(structure["yield_forces"], forces)]
            velocity = {each["node"]: each["velocity"] for each in mode["moving"]}
            for name, moved in zip(names, grid.at_points["velocity"]):
                np.testing.assert_allclose(moved[:2], velocity.get(name, [0, 0]), atol=1e-7)
            data = grid.at_points
            np.testing.assert_allclose(data["load"], data["dead_load"] + load_factor * data["reference_load"], atol=1e-6)
            rest = forces_of_bars(grid) + data["load"] + data["support_reaction"]
            np.testing.assert_allclose(rest, 0, atol=1e-8)
            used, rate = grid.at_cells["utilisation"].ravel(), grid.at_cells["elongation_rate"].ravel()
            self.assertLessEqual(used.max(), 1 + 1e-9)
            np.testing.assert_allclose(used, np.abs(forces) / strength, atol=1e-12)
            np.testing.assert_array_equal(used, answer["nominal_utilisation" if grid is grids[0] else "utilisation"])
            np.testing.assert_allclose(used[np.abs(rate) > 1e-6], 1, atol=1e-9)
            self.assertTrue((used < 0.999).any())
        self.assertEqual(len(grids), 2)
        worst = {each["node"]: each["force"] for each in answer["critical_load"]}
        for name, load in zip(names, grids[1].at_points["dead_load"]):
            np.testing.assert_allclose(load[:2], worst.get(name, [0, 0]), atol=1e-12)

    def one_body(self, mesh, supports, contact, plane=""):
        problem = self.folder / f"body-{len(list(self.folder.iterdir()))}.toml"
        problem.write_text(f'name = "body"\ndimension = {2 if plane else 3}\nunits = {{ length = "m", force = "kN" }}\n'
                           f'[[mesh]]\nname = "m"\n{mesh}\nE = 3.0\nnu = 0.25\n{plane}\n[[supports]]\nnodes = ["{supports}"]\n'
                           f'[[contact]]\nnodes = ["{contact}"]\nexcept = ["{supports}"]\nnormal = "surface"\n')
        return problem

    # The stress at the centre of each element must be in equilibrium with the forces at its nodes.
    # This is tested where it does not need the shape functions: if the stress varies linearly and
    # the sides are straight, the one at the centre is the mean, and the means times volumes add up
    # to the sum of x f^T over all nodes. If it is constant within simplices, V sigma grad N of all
    # elements are the forces at each node.
    def test_stresses_are_in_equilibrium(self):
        mesh = lambda name: f"file = {json.dumps(str(SOURCES / 'tests/meshes' / name))}"
        leaning = "corners = [[0, 0], [2, 0.2], [2.5, 1.5], [0.5, 1.3]]\ndivisions = [4, 3]"
        thin, thick = ('thickness = 0.5\nplane = "%s"' % state for state in ("stress", "strain"))
        for file, thickness, friction in ((self.one_body(mesh("box-tet4-41.msh"), "m.bottom", "m.right"), 1, 4),
                                          (self.one_body(mesh("box-tet10-41.msh"), "m.bottom", "m.right"), 1, 4),
                                          (self.one_body(mesh("box-hex8-41.msh"), "m.bottom", "m.right"), 1, 4),
                                          (self.one_body(mesh("plate-t3-41.msh"), "m.left", "m.bottom", thin), 0.5, 4),
                                          (self.one_body(mesh("plate-t3-41.msh"), "m.left", "m.bottom", thick), 0.5, 4),
                                          (self.one_body(leaning, "m.left", "m.bottom", thick), 0.5, 4),
                                          (SOURCES / "examples/snap-hook.toml", 5, 1.5)):
            with self.subTest(file=file.read_text()):
                _, grids = self.series("patterns", file, "--mu", friction)
                self.assertTrue(grids)
                for grid in grids[:3]:
                    self.check_stresses(grid, thickness, 'plane = "strain"' in file.read_text())

    def check_stresses(self, grid, thickness, thick):
        stresses = grid.at_cells["stress"]
        d = 3 if grid.points[:, 2].any() else 2
        forces = grid.at_points["contact_reaction"] + grid.at_points["support_reaction"]
        tensors = stresses[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
        sizes = np.array([size_of(grid.points[nodes, :d]) for _, nodes in grid.cells]) * thickness
        mean = np.einsum("e,ekl->kl", sizes, tensors)[:d, :d]
        self.vanish((mean - (grid.points.T @ forces)[:d, :d]) / np.abs(grid.points).max())
        if all(len(nodes) == d + 1 for _, nodes in grid.cells):
            for (_, nodes), size, tensor in zip(grid.cells, sizes, tensors):
                gradients = np.linalg.inv(np.column_stack([np.ones(d + 1), grid.points[nodes, :d]]))[1:]
                forces[nodes, :d] -= (size * tensor[:d, :d] @ gradients).T
            self.vanish(forces)
        if d == 2:
            self.assertFalse(stresses[:, 4:].any())
            across = 0.25 * (stresses[:, 0] + stresses[:, 1]) if thick else np.zeros(len(stresses))
            self.close(stresses[:, 2] + 1, across + 1)
        deviators = tensors - np.trace(tensors, axis1=1, axis2=2)[:, None, None] * np.eye(3) / 3
        self.close(grid.at_cells["von_mises"].ravel(), np.sqrt(1.5 * (deviators ** 2).sum(axis=(1, 2))))

    def test_a_body_without_elements_has_no_stresses(self):
        _, grids = self.series("patterns", SOURCES / "examples/brick-by-calculix.toml", "--mu", 0.9)
        self.assertNotIn("stress", grids[0].at_cells)

    # Each mesh fills a body of known volume (tests/meshes/*.geo), and mid-edge nodes are where VTK
    # expects them.
    def test_nodes_have_the_order_of_vtk(self):
        if READER != "vtk":
            self.skipTest("meshio computes no volumes")
        circle = math.pi / 16
        for name, dimension, size, off in (("plate-t3", 2, 2 - circle, 0.03), ("plate-t6", 2, 2 - circle, 0.03),
                                           ("quads-q4", 2, 3.8, 1e-9), ("quads-q8", 2, 3.8, 1e-9),
                                           ("box-tet4", 3, 2, 1e-9), ("box-tet10", 3, 2, 1e-9),
                                           ("box-hex8", 3, 2, 1e-9), ("box-hex20", 3, 2, 1e-9)):
            with self.subTest(name):
                grid = self.shown_mesh(SOURCES / f"tests/meshes/{name}-41.msh", dimension)
                sizes = vtkCellSizeFilter()
                sizes.SetInputData(grid.vtk)
                sizes.Update()
                data = sizes.GetOutput().GetCellData()
                found = vtk_to_numpy(data.GetArray("Volume" if dimension == 3 else "Area"))
                self.assertGreater(found.min(), 0)
                self.assertAlmostEqual(found.sum(), size, delta=off)
                self.check_edges(grid)

    def shown_mesh(self, mesh, dimension):
        plane = 'thickness = 1.0\nplane = "stress"\n' if dimension == 2 else ""
        problem = self.folder / "mesh.toml"
        problem.write_text(f'name = "mesh"\ndimension = {dimension}\nunits = {{ length = "m", force = "kN" }}\n[[mesh]]\n'
                           f'name = "m"\nfile = {json.dumps(str(mesh))}\nE = 1.0\nnu = 0.25\n{plane}')
        self.run_kusabi("show", problem, "--vtu", self.folder / "mesh.vtu")
        return read(self.folder / "mesh.vtu")

    def check_edges(self, grid):
        for number in range(grid.vtk.GetNumberOfCells()):
            cell = grid.vtk.GetCell(number)
            edges = cell.GetNumberOfEdges()
            for edge in map(cell.GetEdge, range(edges)):
                ends = [grid.points[edge.GetPointId(i)] for i in range(edge.GetNumberOfPoints())]
                if len(ends) == 3:
                    length = np.linalg.norm(ends[1] - ends[0])
                    self.assertLess(np.linalg.norm(ends[2] - (ends[0] + ends[1]) / 2), 0.1 * length)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
