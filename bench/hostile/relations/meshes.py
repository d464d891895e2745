"""Relations of meshes and matrices: the same elements from a file of Gmsh (MSH 2.2, MSH 4.1) or of Abaqus,
the same stiffness as a matrix, the same nodes under second names."""

import structure
import table as tables
from relation import FRICTION, Changed, Relation
from table import Unfit

#: Number of nodes and dimension: (type of Gmsh, type of Abaqus in plane stress or in space, in plane strain).
SHAPES = {(3, 2): (2, "CPS3", "CPE3"), (4, 2): (3, "CPS4", "CPE4"), (4, 3): (4, "C3D4", "C3D4"),
          (8, 3): (5, "C3D8", "C3D8"), (2, 2): (1, "T2D2", "T2D2"), (2, 3): (1, "T3D2", "T3D2")}


class Mesh:
    """Members and elements of a table, numbered from 1: nodes {name: tag}, parts [(group, its entry, shape,
    tags)]."""

    def __init__(self, table):
        self.dimension = table["dimension"]
        used = {
            node
            for entry in tables.entries(table, "elements", "members") for each in entry["between"]
            for node in each
        }
        self.tags = {
            name: tag
            for tag, name in enumerate((name for name in table["nodes"] if name in used), 1)
        }
        self.places = {tag: table["nodes"][name] for name, tag in self.tags.items()}
        self.parts = []
        for number, entry in enumerate(tables.entries(table, "elements", "members")):
            for each in entry["between"]:
                if (len(each), self.dimension) not in SHAPES:
                    raise Unfit("elements of the second order")
                self.parts.append((number, entry, SHAPES[len(each),
                                                         self.dimension], [self.tags[node] for node in each]))
        if not any("E" in entry and "EA" not in entry for _, entry, _, _ in self.parts):
            raise Unfit("no elements")

    def place(self, tag):
        return " ".join(map(repr, (*self.places[tag], 0.0)[:3]))

    def materials(self):
        result = {}
        for number, entry, _, _ in self.parts:
            result[number] = {
                "groups": [f"m.part{number}"],
                **{key: value
                   for key, value in entry.items() if key != "between"}
            }
        return list(result.values())

    def rank(self, entry):
        return 1 if "EA" in entry else self.dimension

    def msh2(self):
        groups = {number: self.rank(entry) for number, entry, _, _ in self.parts}
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(groups))]
        lines += [f'{rank} {number + 1} "part{number}"' for number, rank in groups.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.places))]
        lines += [f"{tag} {self.place(tag)}" for tag in self.places]
        lines += ["$EndNodes", "$Elements", str(len(self.parts))]
        lines += [
            f"{k} {shape[0]} 2 {number + 1} {number + 1} {' '.join(map(str, tags))}"
            for k, (number, _, shape, tags) in enumerate(self.parts, 1)
        ]
        return "\n".join([*lines, "$EndElements"]) + "\n"

    def msh4(self):
        groups = {number: self.rank(entry) for number, entry, _, _ in self.parts}
        lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(groups))]
        lines += [f'{rank} {number + 1} "part{number}"' for number, rank in groups.items()]
        ranked = [[number for number, rank in groups.items() if rank == r] for r in range(4)]
        low = " ".join(repr(min(([*place, 0.0])[k] for place in self.places.values())) for k in range(3))
        high = " ".join(repr(max(([*place, 0.0])[k] for place in self.places.values())) for k in range(3))
        lines += ["$EndPhysicalNames", "$Entities", " ".join(str(len(each)) for each in ranked)]
        lines += [f"{number + 1} {low} {high} 1 {number + 1} 0" for each in ranked for number in each]
        first = self.parts[0][0]
        lines += [
            "$EndEntities", "$Nodes", f"1 {len(self.places)} 1 {len(self.places)}",
            f"{groups[first]} {first + 1} 0 {len(self.places)}"
        ]
        lines += [str(tag) for tag in self.places] + [self.place(tag) for tag in self.places]
        blocks = {}
        for number, _, shape, tags in self.parts:
            blocks.setdefault((number, shape[0]), []).append(tags)
        lines += ["$EndNodes", "$Elements", f"{len(blocks)} {len(self.parts)} 1 {len(self.parts)}"]
        count = 0
        for (number, shape), each in blocks.items():
            lines.append(f"{groups[number]} {number + 1} {shape} {len(each)}")
            for tags in each:
                count += 1
                lines.append(f"{count} {' '.join(map(str, tags))}")
        return "\n".join([*lines, "$EndElements"]) + "\n"

    def inp(self):
        lines = ["*NODE"] + [f"{tag}, {', '.join(map(repr, self.places[tag]))}" for tag in self.places]
        for k, (number, entry, shape, tags) in enumerate(self.parts, 1):
            kind = shape[2] if entry.get("plane") == "strain" else shape[1]
            lines += [f"*ELEMENT, TYPE={kind}, ELSET=part{number}", f"{k}, {', '.join(map(str, tags))}"]
        return "\n".join(lines) + "\n"


def _without_faces(table):
    """@raises Unfit if the faces of elements determine normals: bars have none"""
    if any(not isinstance(entry["normal"], list) for entry in tables.entries(table, "contact")):
        raise Unfit("a normal of a surface")
    if any("gravity" in table or "density" in entry
           for entry in tables.entries(table, "elements", "members")):
        raise Unfit("weights")


def _from_file(form, suffix, keep_names=False):
    """Elements and their nodes from a mesh file; the other nodes, and with keep_names all, stay in
    [nodes]."""

    def change(rng, table, question):
        _without_faces(table)
        mesh = Mesh(table)
        new = {name: f"m.{tag}" for name, tag in mesh.tags.items()}
        files = {f"mesh{suffix}": getattr(mesh, form)()}
        materials = mesh.materials()
        before = dict(table["nodes"])
        tables.rename(table, new)
        table["nodes"] = {name: place for name, place in before.items() if keep_names or name not in new}
        if not table["nodes"]:
            del table["nodes"]
        table.pop("elements", None)
        table.pop("members", None)
        if len(set(map(tuple, before.values()))) < len(before) and keep_names:
            raise Unfit("nodes at one place")
        table["mesh"] = [{"name": "m", "file": f"mesh{suffix}"}]
        table["material"] = materials
        return Changed(table, files=files, node=new)

    return change


def _constrained(own):
    """@raises Unfit if a body may be unconstrained: rounded numbers of a matrix do not show its rigid-body
    modes"""
    ground = {node for node, axes in own.fixed.items() if len(axes) == own.dimension}
    body = {node: node for node in own.nodes}

    def root(node):
        while body[node] != node:
            node = body[node]
        return node

    elements = [[a, b] for _, a, b in own.bars] + [quad[-1] for quad in own.quads]
    for element in elements:
        free = [node for node in element if node not in ground]
        for node in free[1:]:
            body[root(node)] = root(free[0])
    fixed = {root(node): set() for node in own.nodes if node not in ground}
    for element in elements:
        for free in element:
            if free not in ground:
                fixed[root(free)] |= {(node, axis) for node in element for axis in own.fixed.get(node, ())}
    if any(len(axes) < (3 if own.dimension == 2 else 6) for axes in fixed.values()):
        raise Unfit("an unconstrained body")


def _as_matrix(rng, table, question):
    """All members and elements as one Matrix Market file, computed in 80 digits and rounded to doubles."""
    _without_faces(table)
    if question.command == "rays" or "temperature" in table:
        raise Unfit("the rounding of the matrix, or a temperature")
    if table["dimension"] == 3 and table.get("elements"):
        raise Unfit("solids")
    own = structure.from_toml(
        tables.write({
            **table, "supports": [
                entry for entry in tables.entries(table, "supports") if "direction" not in entry
            ]
        }))
    if any(len(quad[-1]) != 4 for quad in own.quads):
        raise Unfit("triangles")
    _constrained(own)
    axes = [(node, axis) for node in own.nodes for axis in range(own.dimension)]
    number = {each: k for k, each in enumerate(axes)}
    strains = [strain for bar in own.bars for strain in structure._bar_strain(own, bar)]
    strains += [strain for quad in own.quads for strain in structure._quad_strain(own, quad)]
    entries = {}
    for strain in strains:
        for one, x in strain.items():
            for other, y in strain.items():
                if number[one] >= number[other]:
                    key = number[one] + 1, number[other] + 1
                    entries[key] = entries.get(key, 0) + x * y
    used = {node for strain in strains for node, _ in strain}
    if used != set(own.nodes) or not all(entries.get((row, row)) for row in range(1, len(axes) + 1)):
        raise Unfit("a node without stiffness")
    lines = ["%%MatrixMarket matrix coordinate real symmetric", f"{len(axes)} {len(axes)} {len(entries)}"]
    lines += [
        f"{row} {column} {float(value)!r}" for (row, column), value in sorted(entries.items())
        if value or row == column
    ]
    lines[1] = f"{len(axes)} {len(axes)} {len(lines) - 2}"
    table.pop("elements", None)
    table.pop("members", None)
    table["stiffness"] = [{"file": "stiffness.mtx", "nodes": list(own.nodes)}]
    return Changed(table, exact=False, error=2.0**-52, files={"stiffness.mtx": "\n".join(lines) + "\n"})


RELATIONS = [
    Relation("mesh by MSH 2.2", FRICTION, _from_file("msh2", ".msh")),
    Relation("mesh by MSH 4.1", FRICTION, _from_file("msh4", ".msh")),
    Relation("mesh by Abaqus", FRICTION, _from_file("inp", ".inp")),
    Relation("second names", FRICTION, _from_file("msh2", ".msh", True)),
    Relation("stiffness as a matrix", FRICTION, _as_matrix),
]
