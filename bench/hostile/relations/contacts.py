"""Relations of contact candidates: the same obstacle in other words."""

import copy
import math

import table as tables
from relation import FRICTION, Changed, Relation
from table import Unfit, scaled


def _normals(rng, table, question):
    """Normals of another length; powers of two, so that directions keep their bits."""
    if not any(isinstance(entry["normal"], list) for entry in tables.entries(table, "contact")):
        raise Unfit("no normal is a direction")
    for entry in tables.entries(table, "contact"):
        if isinstance(entry["normal"], list):
            entry["normal"] = scaled(entry["normal"], 2.0**rng.randint(-30, 30))
    return Changed(table)


def _unit_normals(rng, table, question):
    """Normals of length 1, as a program writes them."""
    for entry in tables.entries(table, "contact"):
        if isinstance(entry["normal"], list):
            entry["normal"] = scaled(entry["normal"], 1.0 / math.hypot(*entry["normal"]))
    return Changed(table, exact=False, error=2.0**-52)


def _tangents(rng, table, question):
    """Tangents of the file, in any direction: only the length of the tangential reaction counts."""
    for entry in tables.entries(table, "contact"):
        if not isinstance(entry["normal"], list):
            raise Unfit("a normal of a surface")
        normal = scaled(entry["normal"], 1.0 / math.hypot(*entry["normal"]))
        while True:
            tangent = [rng.uniform(-1, 1) for _ in normal]
            along = sum(x * y for x, y in zip(normal, tangent))
            if math.hypot(*(x - along * y for x, y in zip(tangent, normal))) > 0.3:
                break
        entry["tangent"] = tangent
    return Changed(table)


def _swapped(rng, table, question):
    """Each pair of two nodes from the side of the other one."""
    supported = tables.supported_axes(table)
    dependent = [
        node for entry in tables.entries(table, "contact") if "against" in entry for node in entry["nodes"]
    ]
    swapped = 0
    result, original, number = [], [], 0
    for entry in tables.entries(table, "contact"):
        own = [{**copy.deepcopy(entry), "nodes": [node]} for node in entry["nodes"]]
        for k, each in enumerate(own):
            original.append(number)
            number += 1
            if "against" not in entry:
                continue
            place = entry["against"][k] if isinstance(entry["against"][0], dict) else _coincident(
                table, entry, each["nodes"][0])
            each["against"] = [place]
            node, master = each["nodes"][0], place["nodes"][0]
            if len(place["nodes"]) > 1 or place.get("weights", [1.0]) != [1.0]:
                continue
            if master in supported or master in dependent or dependent.count(node) > 1:
                continue
            if table["nodes"][master] != table["nodes"][node] or any(node in other["nodes"]
                                                                     for other in _masters(table)):
                continue
            each["against"] = [{"nodes": [node], "weights": [1.0]}]
            each["nodes"], each["normal"] = [master], scaled(entry["normal"], -1.0)
            each.pop("tangent", None)
            swapped += 1
        result += own
    if not swapped:
        raise Unfit("no pair of two nodes")
    table["contact"] = result
    masters = {node for place in _masters(table) for node in place["nodes"]}
    if masters & {node for entry in result if "against" in entry for node in entry["nodes"]}:
        raise Unfit("a dependent node as a master")
    return Changed(table, original=original)


def _masters(table):
    for entry in tables.entries(table, "contact", "ties"):
        for place in entry.get("against", entry.get("to", ())):
            yield place if isinstance(place, dict) else {"nodes": [place]}


def _coincident(table, entry, node):
    name = next((other for other in entry["against"] if table["nodes"][other] == table["nodes"][node]), None)
    if name is None:
        raise Unfit("places that do not coincide")
    return {"nodes": [name], "weights": [1.0]}


def _fixed_body(rng, table, question):
    """The obstacle as a body that cannot move: each candidate is against a supported node at its place."""
    supported = tables.supported_axes(table)
    masters = {node for place in _masters(table) for node in place["nodes"]}
    count = 0
    for number, entry in enumerate(tables.entries(table, "contact")):
        if "against" in entry or not isinstance(entry["normal"], list) or \
                any(node in supported or node in masters for node in entry["nodes"]):
            continue
        places = []
        for k, node in enumerate(entry["nodes"]):
            name = f"obstacle {number} {k}"
            table["nodes"][name] = list(table["nodes"][node])
            table.setdefault("supports", []).append({"nodes": [name]})
            places.append({"nodes": [name], "weights": [1.0]})
            count += 1
        entry["against"] = places
    if not count:
        raise Unfit("no candidate without support")
    return Changed(table)


RELATIONS = [
    Relation("scaled normals", FRICTION, _normals),
    Relation("unit normals", FRICTION, _unit_normals),
    Relation("tangents", FRICTION, _tangents),
    Relation("pairs swapped", FRICTION, _swapped),
    Relation("obstacle as a fixed body", FRICTION, _fixed_body),
]
