"""Relations of pieces: idle ones, copies, and heavily loaded neighbours in the same file."""

import copy

import table as tables
from positions import ROUNDING
from relation import ALL, FRICTION, Changed, Relation, every_component
from table import Unfit


def _beyond(table):
    """A coordinate beyond the structure, a power of two, so that moved coordinates are rounded little."""
    size = max(abs(x) for place in table["nodes"].values() for x in place) + 1.0
    far = 1.0
    while far < 4 * size:
        far *= 2
    if min(1.0, tables.shortest(table)) < far * ROUNDING * 1e6:
        raise Unfit("so long that lengths beyond it are rounded")
    return far


def _post(rng, table, question, stiffness=1.0, load=0.0, candidate=True):
    """A node far away on bars along the axes, perhaps with a candidate and a dead load towards it."""
    far, dimension = _beyond(table), table["dimension"]
    tip = [far] + [0.0] * (dimension - 1)
    table["nodes"]["far"] = tip
    feet = []
    for axis in range(dimension):
        foot = list(tip)
        foot[axis] -= 1.0
        table["nodes"][f"far foot {axis}"] = foot
        feet.append(f"far foot {axis}")
    bars = {"EA": stiffness, "between": [[foot, "far"] for foot in feet]}
    if question.command == "limit":
        bars["yield"] = 8.0 * max(abs(load), 1.0)
    table.setdefault("members", []).append(bars)
    table.setdefault("supports", []).append({"nodes": feet})
    normal = [0.0] * dimension
    normal[rng.randrange(dimension)] = rng.choice((1.0, -1.0))
    changed = Changed(table)
    if load:
        table.setdefault("loads",
                         []).append({"kind": "dead", "nodes": ["far"], "force": [-load * n for n in normal]})
    if candidate and question.command != "limit":
        at = rng.randint(0, len(table.get("contact", ())))
        before = sum(len(entry["nodes"]) for entry in table["contact"][:at])
        table["contact"].insert(at, {"nodes": ["far"], "normal": normal})
        changed.original.insert(before, None)
    return changed


def _components(table, question):
    """@raises Unfit if further nodes would be uncertain, or could be lost"""
    if every_component(table, question):
        raise Unfit("all components are uncertain")


def _idle(rng, table, question):
    _components(table, question)
    if question.lose is not None:
        raise Unfit("further members to lose")
    return _post(rng, table, question)


def _heavy(rng, table, question):
    """A decoupled truss under 1e12. Tolerances that are relative to the largest force of the file would hide
    others."""
    _components(table, question)
    of_all_reactions = "--grip" in question.more or question.total is not None
    if of_all_reactions or question.lose is not None or "actions" in table:
        raise Unfit("its reactions count")
    if question.command == "hold" and not any(entry["kind"] == "dead"
                                              for entry in tables.entries(table, "loads")):
        raise Unfit("no dead load")
    return _post(rng, table, question, stiffness=1e9, load=1e12)


def _stiff(rng, table, question):
    """A decoupled post whose stiffness is 1e12 times larger."""
    _components(table, question)
    if question.lose is not None:
        raise Unfit("further members to lose")
    return _post(rng, table, question, stiffness=1e12)


def _doubled(rng, table, question):
    """A copy of the whole structure beside it. Both carry the same factors; configurations multiply."""
    if question.lose is not None or question.total is not None or question.group_alpha or "actions" in table:
        raise Unfit("counted twice")
    if question.command == "rays" or any("density" in entry
                                         for entry in tables.entries(table, "members", "elements")):
        raise Unfit("rays of a product")
    far = _beyond(table)
    moved = {name: [place[0] + far, *place[1:]] for name, place in table["nodes"].items()}
    exact = all(place[0] - far == table["nodes"][name][0] for name, place in moved.items())
    if not exact and far > 1e4:
        raise Unfit("so long that the copy is another structure")
    other = copy.deepcopy(table)
    if any(isinstance(entry["normal"], dict) for entry in tables.entries(other, "contact")):
        raise Unfit("an obstacle at a place")
    other["nodes"] = moved
    tables.rename(other, lambda name: f"{name}'")
    first = tables.candidates(table)
    for entry in tables.entries(other, "uncertainty", "contact"):
        if "name" in entry:
            entry["name"] += "'"
    table["nodes"] |= other["nodes"]
    for section, values in other.items():
        if isinstance(values, list) and section not in ("gravity", ):
            table[section] = table[section] + values
    return Changed(table, exact=exact, error=0.0 if exact else 2.0**-50,
                   original=[*range(len(first)), *range(len(first))], copies=2)


RELATIONS = [
    Relation("idle piece", ALL, _idle),
    Relation("neighbour under 1e12", ("hold", "limit"), _heavy),
    Relation("stiff neighbour", FRICTION, _stiff),
    Relation("doubled", ALL, _doubled),
]
