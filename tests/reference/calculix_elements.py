#!/usr/bin/env python3
"""Stiffness of single distorted elements by CalculiX 2.20 (Debian's calculix-ccx): calculix_elements.json.

One element of each shape in space, its nodes moved at random, without supports; *FREQUENCY with
SOLVER=MATRIXSTORAGE writes its stiffness with 14 digits. Plane elements are missing: CalculiX
expands them to elements in space with additional nodes and multi-point constraints.
"""
import json
import pathlib
import random
import subprocess
import tempfile

TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
CUBE_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5),
              (2, 6), (3, 7)]
SHAPES = {"C3D4": (TETRAHEDRON, []), "C3D10": (TETRAHEDRON, TETRAHEDRON_EDGES), "C3D8": (CUBE, []),
          "C3D20": (CUBE, CUBE_EDGES)}


def places(shape, rng):
    corners, edges = SHAPES[shape]
    moved = [[x + rng.uniform(-0.15, 0.15) for x in corner] for corner in corners]
    middles = [[(x + y) / 2 + rng.uniform(-0.05, 0.05) for x, y in zip(moved[a], moved[b])]
               for a, b in edges]
    # As the deck has them: what it rounds is not there to begin with.
    return [[float(f"{x:.10f}") for x in place] for place in moved + middles]


def deck(shape, nodes, modulus, ratio):
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{n}, " + ", ".join(f"{x:.10f}" for x in place) for n, place in enumerate(nodes, 1)]
    lines += [f"*ELEMENT, TYPE={shape}, ELSET=BODY"]
    numbers = [str(n) for n in range(1, len(nodes) + 1)]
    first = ["1"] + numbers[:15]
    lines += [", ".join(first) + ("," if len(numbers) > 15 else "")]
    if len(numbers) > 15:
        lines += [", ".join(numbers[15:])]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{modulus}, {ratio}", "*DENSITY", "1.",
              "*SOLID SECTION, ELSET=BODY, MATERIAL=M", "*STEP",
              "*FREQUENCY, SOLVER=MATRIXSTORAGE", "*END STEP"]
    return "\n".join(lines) + "\n"


def stiffness(shape, nodes, modulus, ratio):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        (path / "job.inp").write_text(deck(shape, nodes, modulus, ratio))
        subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        order = [line.split(".") for line in (path / "job.dof").read_text().split()]
        place = [3 * (int(node) - 1) + int(axis) - 1 for node, axis in order]
        matrix = [[0.0] * len(place) for _ in place]
        for line in (path / "job.sti").read_text().splitlines():
            row, column, value = line.split()
            i, j = place[int(row) - 1], place[int(column) - 1]
            matrix[i][j] = matrix[j][i] = float(value)
        return matrix


def main():
    rng = random.Random(1)
    cases = []
    for shape in SHAPES:
        nodes = places(shape, rng)
        modulus, ratio = 200.0, 0.3
        cases.append({"shape": shape, "modulus": modulus, "ratio": ratio, "nodes": nodes,
                      "stiffness": stiffness(shape, nodes, modulus, ratio)})
    path = pathlib.Path(__file__).with_suffix(".json")
    path.write_text(json.dumps(cases, indent=0).replace(",\n", ", ") + "\n")


if __name__ == "__main__":
    main()
