"""mesh_file.py: meshes that meshio reads become mesh files with groups, which kusabi reads. The
library is replaced by a module with its interface, so it need not be installed.

    python3 mesh_file_test.py KUSABI SOURCES
"""
import os
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

CONVERTER = SOURCES / "run" / "python" / "mesh_file.py"

MESHIO = """
class ReadError(Exception):
    pass

class Block:
    def __init__(self, kind, data):
        self.type, self.data = kind, data

class Mesh:
    pass

def read(name):
    data = eval(open(name).read(), {"nan": float("nan"), "inf": float("inf")})
    mesh = Mesh()
    mesh.points = data["points"]
    mesh.cells = [Block(*cell) for cell in data["cells"]]
    mesh.cell_data, mesh.point_data = data.get("cell_data", {}), data.get("point_data", {})
    mesh.cell_sets, mesh.point_sets = data.get("cell_sets", {}), data.get("point_sets", {})
    return mesh
"""

PROBLEM = """
name = "converted"
dimension = 3
units = { length = "mm", force = "N" }
[[mesh]]
name = "m"
file = "a.msh"
E = 1.0
nu = 0.25
[[supports]]
nodes = [SUPPORT]
[[contact]]
nodes = [CONTACT]
normal = "surface"
"""

# Vertices and edges in the order of VTK's file formats.
SHAPES = {
    "tetra10": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]),
    "hexahedron20": ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
                     [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]),
    "wedge15": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)],
                [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)]),
    "pyramid": ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)], []),
}


class MeshFile(KusabiCase):
    def convert(self, content, meshio=MESHIO):
        (self.folder / "meshio.py").write_text(meshio)
        (self.folder / "a.vtu").write_text(repr(content))
        return subprocess.run([sys.executable, CONVERTER, "a.vtu", "a.msh"], cwd=self.folder, capture_output=True,
                              text=True, check=False, env={**os.environ, "PYTHONPATH": str(self.folder)})

    def show(self, support, contact):
        (self.folder / "p.toml").write_text(PROBLEM.replace("SUPPORT", support).replace("CONTACT", contact))
        return subprocess.run([KUSABI, "show", self.folder / "p.toml"], capture_output=True, text=True, check=False)

    # With a node out of order the Jacobian determinant changes its sign, which kusabi refuses.
    def test_nodes_of_each_shape_are_in_order(self):
        for shape, (corners, edges) in SHAPES.items():
            with self.subTest(shape):
                middles = [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j])) for i, j in edges]
                points = corners + middles
                run = self.convert({"points": points, "cells": [(shape, [list(range(len(points)))])]})
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                shown = self.show('"m.1"', '"m.2"')
                self.assertEqual(shown.returncode, 0, shown.stderr)
                self.assertIn(f"{len(points)} nodes, 1 ", shown.stdout)

    def test_arrays_and_sets_are_groups(self):
        corners = SHAPES["hexahedron20"][0]
        points = [*corners, *((x, y, 2) for x, y, z in corners[4:])]
        run = self.convert({
            "points": points,
            "cells": [("hexahedron", [[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]]), ("quad", [[0, 1, 2, 3]])],
            "cell_data": {"part": [[1, 2], [0]], "stress": [[0.5, 1.5], [0.5]],
                          "gap": [[float("nan"), float("inf")], [2]]},
            "cell_sets": {"bottom": [None, [0]]}, "point_data": {"held": [0] * 8 + [2] * 4},
            "point_sets": {"corner": [0]}})
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        for group, count in (("bottom", 4), ("corner", 1), ("part.1", 8)):
            with self.subTest(group):
                shown = self.show('"m.held.2"', f'"m.{group}"')
                self.assertEqual(shown.returncode, 0, shown.stderr)
                self.assertRegex(shown.stdout, rf"candidates +{count}\n")

    def test_faults_are_one_line(self):
        for content, meshio, message in (
                ({"points": [], "cells": [("VTK_LAGRANGE", [])]}, MESHIO, "cells of the kind VTK_LAGRANGE"),
                ({}, "raise ImportError", "meshio is not installed"),
                ({}, MESHIO + "\ndef read(name): raise ReadError('no mesh')", "a.vtu: no mesh")):
            run = self.convert(content, meshio)
            self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1), run.stderr)
            self.assertIn(message, run.stderr)


if __name__ == "__main__":
    main()
