"""Mesh file for Kusabi of a mesh in another format: VTU, VTK, XDMF, MED and all that meshio reads.

    python3 mesh_file.py MESH.vtu MESH.msh

Writes MSH 2.2. Groups, with numbers n from 1 on: "A.n" are the cells, or the points, where an array A
of whole numbers is n; a cell set or a point set keeps its name. Requires meshio (Debian:
python3-meshio).
"""
import pathlib
import sys

# Type of Gmsh, dimension, and for each node in Gmsh's order its place in the order of VTK.
SHAPES = {
    "vertex": (15, 0, None), "line": (1, 1, None), "line3": (8, 1, None),
    "triangle": (2, 2, None), "triangle6": (9, 2, None), "quad": (3, 2, None), "quad8": (16, 2, None),
    "tetra": (4, 3, None), "tetra10": (11, 3, (0, 1, 2, 3, 4, 5, 6, 7, 9, 8)),
    "hexahedron": (5, 3, None),
    "hexahedron20": (17, 3, (0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14)),
    "wedge": (6, 3, None), "wedge15": (18, 3, (0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10)),
    "pyramid": (7, 3, None),
}


def groups_of_arrays(arrays, number):
    """Names "A.n" and their members, of arrays of whole numbers."""
    groups = {}
    for name, values in arrays.items():
        values = values[number] if number is not None else values
        if getattr(values, "ndim", 1) != 1 or not all(float(value).is_integer() for value in values):
            continue
        for index, value in enumerate(values):
            if value >= 1:
                groups.setdefault(f"{name}.{int(value)}", []).append(index)
    return groups


def elements(mesh):
    """(shape, nodes from 0 on, names of its groups) for each cell, and for each point in a group."""
    for number, block in enumerate(mesh.cells):
        if block.type not in SHAPES:
            raise ValueError(f"cells of the kind {block.type}; expected {', '.join(SHAPES)}")
        groups = groups_of_arrays(mesh.cell_data, number)
        for name, blocks in mesh.cell_sets.items():
            if blocks[number] is not None:
                groups.setdefault(name, []).extend(blocks[number])
        names = [[] for _ in block.data]
        for name, members in groups.items():
            for index in members:
                names[index].append(name)
        yield from zip([block.type] * len(names), block.data, names)
    points = groups_of_arrays(mesh.point_data, None)
    for name, members in [*points.items(), *mesh.point_sets.items()]:
        yield from (("vertex", [index], [name]) for index in members)


def text_of(mesh):
    """The mesh as MSH 2.2; an element of several groups has a line for each."""
    tags, lines, last = {}, [], 0
    for last, (shape, nodes, names) in enumerate(elements(mesh), 1):
        kind, dimension, order = SHAPES[shape]
        nodes = " ".join(str(int(node) + 1) for node in (nodes[place] for place in order or range(len(nodes))))
        for name in names or [None]:
            tag = 0 if name is None else tags.setdefault((dimension, name), len(tags) + 1)
            lines.append(f"{last} {kind} 2 {tag} {tag} {nodes}")
    places = [[*map(float, place), 0.0][:3] for place in mesh.points]
    named = [f'{dimension} {tag} "{name}"' for (dimension, name), tag in tags.items()]
    return "\n".join([
        "$MeshFormat", "2.2 0 8", "$EndMeshFormat",
        "$PhysicalNames", str(len(named)), *named, "$EndPhysicalNames",
        "$Nodes", str(len(places)), *(f"{tag} {x!r} {y!r} {z!r}" for tag, (x, y, z) in enumerate(places, 1)),
        "$EndNodes", "$Elements", str(len(lines)), *lines, "$EndElements", ""])


def main():
    if len(sys.argv) != 3 or not sys.argv[2].endswith(".msh"):
        sys.exit("mesh_file.py: expected two files: python3 mesh_file.py MESH.vtu MESH.msh")
    try:
        import meshio
    except ImportError:
        sys.exit("mesh_file.py: meshio is not installed; expected the package python3-meshio, or pip install meshio")
    try:
        pathlib.Path(sys.argv[2]).write_text(text_of(meshio.read(sys.argv[1])))
    except (meshio.ReadError, ValueError, OSError) as error:
        sys.exit(f"mesh_file.py: {sys.argv[1]}: {error}")


if __name__ == "__main__":
    main()
