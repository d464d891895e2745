"""Problem files as tables of Python: reader, writer, and functions that change every place, direction,
length, force or name of a table at once.

A relation changes a table, never a text, so the sections of a changed file have the order of the table.
Tables here are flat: the nodes of a `[[mesh]]` are in `[nodes]`, and groups are lists of nodes.
"""

import copy
import itertools
import json
import math
import re
import tomllib

BARE = re.compile(r"[A-Za-z0-9_-]+")
#: Sections whose entries have `nodes`.
WITH_NODES = ("supports", "springs", "contact", "loads", "uncertainty", "ties")


class Unfit(Exception):
    """A relation does not apply to this table, for the given reason."""


def read(text):
    return tomllib.loads(text)


def _key(name):
    return name if BARE.fullmatch(name) else json.dumps(name, ensure_ascii=False)


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(name)} = {_value(each)}" for name, each in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value)


def write(table):
    """Text of the problem file. Numbers keep all bits."""
    lines, sections = [], []
    for name, value in table.items():
        if name in ("nodes", "combinations"):
            sections += ["", f"[{name}]"] + [f"{_key(key)} = {_value(each)}" for key, each in value.items()]
        elif isinstance(value, list):
            for entry in value:
                sections += ["", f"[[{name}]]"
                             ] + [f"{_key(key)} = {_value(each)}" for key, each in entry.items()]
        else:
            lines.append(f"{_key(name)} = {_value(value)}")
    return "\n".join(lines + sections) + "\n"


def entries(table, *sections):
    for section in sections:
        yield from table.get(section, ())


def force_lists(table):
    """Every entry { nodes, force } of loads, uncertain loads and actions."""
    yield from entries(table, "loads")
    for entry in entries(table, "uncertainty", "actions"):
        yield from entry.get("forces", ())


def candidates(table):
    """(number of its group, node) of each contact candidate, in the order of every answer."""
    return [(number, node) for number, entry in enumerate(table.get("contact", ()))
            for node in entry["nodes"]]


def is_plane(table):
    return table["dimension"] == 2


def supported_axes(table):
    """{node: its fixed axes as numbers}, without inclined supports."""
    fixed = {}
    for entry in entries(table, "supports"):
        if "direction" not in entry:
            axes = {"xyz".index(axis) for axis in entry.get("fixed", "xyz"[:table["dimension"]])}
            for node in entry["nodes"]:
                fixed[node] = axes
    return fixed


def has_pairs(table):
    return any("against" in entry for entry in entries(table, "contact")) or bool(table.get("ties"))


# Flat tables
# ---------------------------------------------------------------------------------------------------


def _mesh_nodes(table, mesh, nodes, alias, groups):
    """Nodes and elements of a mesh of corners and divisions, as docs/problem-files.md names them."""
    if "file" in mesh:
        raise Unfit("a mesh from a file")
    columns, rows = mesh["divisions"]
    corners = [[float(x) for x in corner] for corner in mesh["corners"]]
    size = max(max(c[k] for c in corners) - min(c[k] for c in corners) for k in (0, 1))
    head, numbers = mesh["name"], {}
    before = list(nodes.items()) if mesh.get("join", True) else []
    for j in range(rows + 1):
        for i in range(columns + 1):
            x, y = i / columns, j / rows
            weights = ((1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y)
            place = [sum(w * c[k] for w, c in zip(weights, corners)) for k in (0, 1)]
            name = f"{head}.{i},{j}"
            at = next((other for other, where in before if max(abs(where[k] - place[k])
                                                               for k in (0, 1)) <= 1e-9 * size), name)
            if at == name:
                nodes[name] = place
            alias[name] = numbers[i, j] = at
    groups[head + ".left"] = [numbers[0, j] for j in range(rows + 1)]
    groups[head + ".right"] = [numbers[columns, j] for j in range(rows + 1)]
    groups[head + ".bottom"] = [numbers[i, 0] for i in range(columns + 1)]
    groups[head + ".top"] = [numbers[i, rows] for i in range(columns + 1)]
    kept = {
        key: mesh[key]
        for key in ("E", "nu", "thickness", "plane", "density", "expansion") if key in mesh
    }
    between = [[numbers[i, j], numbers[i + 1, j], numbers[i + 1, j + 1], numbers[i, j + 1]]
               for j in range(rows) for i in range(columns)]
    table.setdefault("elements", []).append({**kept, "between": between})


def _explicit(entry, nodes, alias, groups):
    """The entry with its list of nodes written out."""
    listed = lambda names: [alias.get(node, node) for name in names for node in groups.get(name, [name])]
    entry = dict(entry)
    left_out = set(listed(entry.pop("except", ())))
    entry["nodes"] = [node for node in listed(entry["nodes"])
                      if node not in left_out][::entry.pop("every", 1)]
    for key in ("to", "against"):
        if isinstance(entry.get(key), str):
            raise Unfit("a place on an edge")
        if key in entry:
            entry[key] = [({**place, "nodes": listed(place["nodes"])} if isinstance(place, dict) else place)
                          for place in (entry[key] if isinstance(entry[key][0], dict) else listed(entry[key]))
                          ]
    if unknown := [node for node in entry["nodes"] if node not in nodes]:
        raise Unfit(f"unknown nodes {unknown}")
    return entry


def flat(table):
    """The same structure without `[[mesh]]` and groups. @raises Unfit if that needs the contents of a file"""
    if table.get("stiffness"):
        raise Unfit("a stiffness from a file")
    result = copy.deepcopy(table)
    nodes = result["nodes"] = {
        name: [float(x) for x in place]
        for name, place in table.get("nodes", {}).items()
    }
    alias, groups = {}, {}
    for mesh in result.pop("mesh", ()):
        _mesh_nodes(result, mesh, nodes, alias, groups)
    for section in WITH_NODES:
        if section in result:
            result[section] = [
                _explicit(entry, nodes, alias, groups) if "nodes" in entry else entry
                for entry in result[section]
            ]
    for entry in entries(result, "members", "elements"):
        entry["between"] = [[alias.get(node, node) for node in each] for each in entry["between"]]
    for entry in entries(result, "uncertainty", "actions"):
        if "forces" in entry:
            entry["forces"] = [_explicit(each, nodes, alias, groups) for each in entry["forces"]]
    for entry in entries(result, "contact"):
        if "friction" in entry:
            entry["friction_factor"] = entry.pop("friction")
    return result


# Changes of all quantities of one kind
# -------------------------------------------------------------------------


def change_vectors(table, change, of_forces=None):
    """Every direction and force; `of_forces` of forces if it is another function. Intervals are not
    vectors."""
    of_forces = of_forces or change
    if any(isinstance(part, list) for entry in force_lists(table) for part in entry["force"]):
        raise Unfit("a load with intervals")
    for entry in force_lists(table):
        entry["force"] = of_forces(entry["force"])
    for entry in entries(table, "contact"):
        for key in ("normal", "tangent"):
            if isinstance(entry.get(key), list):
                entry[key] = change(entry[key])
        if isinstance(entry["normal"], dict):
            for key in ("plane", "axis"):
                if key in entry["normal"]:
                    entry["normal"][key] = change(entry["normal"][key])
    for entry in entries(table, "supports"):
        for key in ("direction", "displacement"):
            if key in entry:
                entry[key] = change(entry[key])
    if "gravity" in table:
        table["gravity"] = of_forces(table["gravity"])


def change_places(table, change):
    table["nodes"] = {name: change(place) for name, place in table["nodes"].items()}
    for entry in entries(table, "contact"):
        if isinstance(entry["normal"], dict) and "point" in entry["normal"]:
            entry["normal"]["point"] = change(entry["normal"]["point"])


def scaled(value, by):
    """A number, an interval, a list or a table of numbers, each multiplied."""
    if isinstance(value, list):
        return [scaled(each, by) for each in value]
    if isinstance(value, dict):
        return {key: each if key == "residual" else scaled(each, by) for key, each in value.items()}
    return value * by


def scale_forces(table, by, sections=("loads", "uncertainty", "actions")):
    """All loads of the given sections multiplied; half-widths are factors of these loads and stay."""
    chosen = {name: table.get(name, ()) for name in sections}
    for entry in force_lists(chosen):
        entry["force"] = scaled(entry["force"], by)
    for entry in entries(chosen, "uncertainty"):
        if "forces" not in entry:
            entry["weight"] = entry.get("weight", 1.0) * by


def uncertain_sizes(table):
    """Components of uncertain loads that are not zero, and weights."""
    for entry in entries(table, "uncertainty"):
        yield from (part for each in entry.get("forces", ()) for part in each["force"] if part)
        if "forces" not in entry:
            yield entry.get("weight", 1.0)


def rename(table, node_name):
    """Every node by its new name; `node_name` is a table or a function of the old one."""
    name = node_name if callable(node_name) else lambda old: node_name.get(old, old)
    table["nodes"] = {name(old): place for old, place in table["nodes"].items()}
    for entry in entries(table, "members", "elements"):
        entry["between"] = [[name(old) for old in each] for each in entry["between"]]
    for entry in [
            *entries(table, *WITH_NODES),
            *(each for entry in entries(table, "uncertainty", "actions") for each in entry.get("forces", ()))
    ]:
        if "nodes" in entry:
            entry["nodes"] = [name(old) for old in entry["nodes"]]
        for key in ("to", "against"):
            if key in entry:
                entry[key] = [{**place, "nodes": [name(old) for old in place["nodes"]]} if isinstance(
                    place, dict) else name(place) for place in entry[key]]


def shortest(table):
    """Shortest distance of two nodes at different places."""
    places = sorted(set(map(tuple, table["nodes"].values())))
    return min((math.dist(a, b) for a, b in itertools.combinations(places, 2)), default=math.inf)


def extent(table):
    """Length of the box around all nodes."""
    places = list(table["nodes"].values())
    return math.hypot(*(max(p[k] for p in places) - min(p[k] for p in places)
                        for k in range(table["dimension"])))
