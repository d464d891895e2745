"""Relations of words: the same entries in another order, under other names, in other groups."""

import copy
import math

import table as tables
from relation import ALL, Changed, Relation, every_component
from table import Unfit, scaled

STYLES = {
    "numbers": lambda k: str(17 * k + 3),
    "blanks": lambda k: f"north  pier {k} ",
    "unicode": lambda k: f"Füße–柱{k}é",
    "quotes": lambda k: f'"{k}"\\\'{k}\'',
    "commas": lambda k: f"a,{k},b",
    "hyphens": lambda k: f"-{k}-",
    "equals": lambda k: f"a={k}",
    "other signs": lambda k: f"<{k}>&#@:{k}%s{{}}$(x)",
}
#: Names of candidates contain these signs themselves (pairs, corners).
BARS = {"bars": lambda k: f"n|{k}"}


def _reordered(rng, table, question):
    """Nodes, members, elements, supports, candidates and loads in another order; members and elements
    reversed."""
    shuffled = lambda items: rng.sample(list(items), len(items))
    before = tables.candidates(table)
    table["nodes"] = dict(shuffled(table["nodes"].items()))
    for entry in tables.entries(table, "members"):
        entry["between"] = [each[::-1] if rng.random() < 0.5 else each for each in shuffled(entry["between"])]
    for entry in tables.entries(table, "elements"):
        entry["between"] = [
            _turned_element(rng, table["dimension"], each) for each in shuffled(entry["between"])
        ]
    for entry in tables.entries(table, "supports", "springs", "loads", "uncertainty"):
        if "nodes" in entry:
            entry["nodes"] = shuffled(entry["nodes"])
    numbered = []
    for number, entry in enumerate(tables.entries(table, "contact")):
        order = shuffled(range(len(entry["nodes"])))
        for key in ("nodes", "against"):
            if isinstance(entry.get(key), list) and len(entry[key]) == len(order):
                entry[key] = [entry[key][k] for k in order]
        numbered.append((number, entry))
    for section in ("members", "elements", "supports", "springs", "loads", "uncertainty"):
        if section in table:
            table[section] = shuffled(table[section])
    if "contact" in table:
        numbered = shuffled(numbered)
        table["contact"] = [entry for _, entry in numbered]
    group = [number for number, _ in numbered]
    original = [before.index((group[number], node)) for number, node in tables.candidates(table)]
    if len(set(original)) < len(original):
        raise Unfit("a node twice in a group")
    rest = [name for name in table if name not in ("name", "dimension", "units")]
    table = {
        **{name: table[name]
           for name in ("name", "dimension", "units") if name in table},
        **{name: table[name]
           for name in shuffled(rest)}
    }
    return Changed(table, original=original)


def _turned_element(rng, dimension, nodes):
    """A plane element of corners from another corner, and perhaps in the other sense."""
    if dimension == 3 or len(nodes) > 4:
        return nodes
    first = rng.randrange(len(nodes))
    nodes = nodes[first:] + nodes[:first]
    return nodes[::-1] if rng.random() < 0.5 else nodes


def _renamed(style, loads_only=False):
    """All nodes, or all uncertain loads, groups, obstacles and load cases under names of one style."""

    def change(rng, table, question):
        new = {old: style(k) for k, old in enumerate(table["nodes"])}
        changed = Changed(table)
        if not loads_only:
            tables.rename(table, new)
            changed.node = new
            return changed
        kinds = {"group": ("name", "group"), "case": ("case", )}
        for kind, keys in kinds.items():
            known = getattr(changed, kind)
            for entry in tables.entries(table, "uncertainty", "loads"):
                for key in keys:
                    if key in entry:
                        entry[key] = known.setdefault(entry[key], style(len(known)))
        for k, entry in enumerate(tables.entries(table, "contact")):
            if "name" in entry:
                entry["name"] = style(k)
        if not changed.group and not changed.case:
            raise Unfit("no names")
        return changed

    return change


def _regrouped(rng, table, question):
    """One group for each member, element, support, candidate and load."""
    for section, key in (("members", "between"), ("elements", "between"), ("supports", "nodes"),
                         ("springs", "nodes"), ("loads", "nodes")):
        if section in table:
            table[section] = [{**copy.deepcopy(entry), key: [each]} for entry in table[section]
                              for each in entry[key]]
    if "contact" in table:
        alone = []
        for entry in table["contact"]:
            # Faces of a surface are those of the group; against a list, each node has its place.
            if isinstance(entry["normal"], str) or not isinstance(entry.get("against", [{}])[0], dict):
                alone.append(entry)
                continue
            for k, node in enumerate(entry["nodes"]):
                own = {**copy.deepcopy(entry), "nodes": [node]}
                if "against" in entry:
                    own["against"] = [entry["against"][k]]
                alone.append(own)
        table["contact"] = alone
    return Changed(table)


def _split_loads(rng, table, question):
    """Each load in two parts, one of them perhaps opposite."""
    parts = []
    for entry in tables.entries(table, "loads"):
        if any(isinstance(part, list) for part in entry["force"]):
            raise Unfit("a load with intervals")
        share = rng.choice((0.25, 0.5, 3.0, -1.0))
        parts += [{**entry, "force": scaled(entry["force"], share)},
                  {**entry, "force": scaled(entry["force"], 1.0 - share)}]
    if not parts:
        raise Unfit("no loads")
    table["loads"] = rng.sample(parts, len(parts))
    exact = all(scaled(a, 1.0) == a for entry in parts
                for a in (entry["force"], )) and all(x * 4.0 == int(x * 4.0) for entry in parts
                                                     for x in entry["force"])
    return Changed(table, exact=exact, error=0.0 if exact else 2.0**-52)


def _split_cases(rng, table, question):
    """Two load cases, each with all loads."""
    if any("case" in entry for entry in tables.entries(table, "loads", "uncertainty")) or "actions" in table:
        raise Unfit("load cases")
    if question.lose is not None:
        raise Unfit("losses of cases")
    names = ("first case", "second, the same")
    if question.command == "hold":
        table["loads"] = [{**copy.deepcopy(entry), "case": name} for name in names
                          for entry in table["loads"]]
        changed = Changed(table)
        changed.case = {None: rng.choice(names)}
        return changed
    if question.group_alpha:
        raise Unfit("names of uncertain loads would be double")
    dead = [entry for entry in table["loads"] if entry["kind"] == "dead"]
    if not dead or any("name" in entry for entry in tables.entries(table, "uncertainty")):
        raise Unfit("no dead load, or names of uncertain loads would be double")
    others = [entry for entry in table["loads"] if entry["kind"] != "dead"]
    table["loads"] = others + [{**copy.deepcopy(entry), "case": name} for name in names for entry in dead]
    return Changed(table)


def _split_members(rng, table, question):
    """A bar in two halves, whose middle is guided along it."""
    if question.lose is not None or every_component(table, question):
        raise Unfit("one member more")
    supports = tables.supported_axes(table)
    if sum(map(len, supports.values())) < math.comb(table["dimension"] + 1, 2):
        raise Unfit("an unconstrained body, of which the guided middle is no part")
    choices = []
    for entry in tables.entries(table, "members"):
        if "buckling" in entry:
            continue
        for k, (a, b) in enumerate(entry["between"]):
            start, end = table["nodes"][a], table["nodes"][b]
            along = [axis for axis in range(table["dimension"]) if start[axis] != end[axis]]
            middle = [(x + y) / 2 for x, y in zip(start, end)]
            exact = len(along) == 1 and all(2 * m == x + y and 2 * (m - x) == y - x
                                            for m, x, y in zip(middle, start, end))
            if exact and not {a, b} <= supports.keys() and middle not in table["nodes"].values():
                choices.append((entry, k, along[0], middle))
    if not choices:
        raise Unfit("no bar along an axis")
    entry, k, axis, middle = rng.choice(choices)
    a, b = entry["between"].pop(k)
    table["nodes"]["the middle"] = middle
    # Halves have the density and the expansion of the bar, and the axial stiffness of its group.
    table["members"].append({**copy.deepcopy(entry), "between": [[a, "the middle"], ["the middle", b]]})
    table["members"] = [each for each in table["members"] if each["between"]]
    table.setdefault("supports", []).append({
        "nodes": ["the middle"],
        "fixed": ["xyz"[other] for other in range(table["dimension"]) if other != axis]
    })
    if "gravity" in table or "temperature" in table:
        raise Unfit("the weight of the middle goes to the ground")
    return Changed(table)


RELATIONS = [
    Relation("reordered", ALL, _reordered),
    *(Relation(f"nodes renamed, {name}", ALL, _renamed(style)) for name, style in {**STYLES, **BARS}.items()),
    *(Relation(f"loads renamed, {name}", ("hold", "limit"), _renamed(style, True))
      for name, style in {**STYLES, **BARS}.items()),
    Relation("regrouped", ALL, _regrouped),
    Relation("loads split", ("hold", "limit"), _split_loads),
    Relation("cases split", ("hold", "limit"), _split_cases),
    Relation("members split", ALL, _split_members),
]
