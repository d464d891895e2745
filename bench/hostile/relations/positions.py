"""Relations of positions: turned, reflected, moved, rounded, in space instead of the plane."""

import math

import table as tables
from relation import ALL, Changed, Relation, every_component
from table import Unfit

#: Rounding of a coordinate relative to the size of the structure.
ROUNDING = 2.0**-52


def _rotation(rng, dimension, cosine, sine):
    """Rows of a rotation, in space about a random axis of coordinates."""
    a, b = (0, 1) if dimension == 2 else rng.choice(((0, 1), (1, 2), (2, 0)))
    rows = [[float(i == j) for j in range(dimension)] for i in range(dimension)]
    rows[a][a], rows[a][b], rows[b][a], rows[b][b] = cosine, -sine, sine, cosine
    return rows


def _times(rows, vector):
    return [math.fsum(x * y for x, y in zip(row, vector)) for row in rows]


def _incline_supports(table, rows):
    """Supports along axes as inclined ones, along the turned axes."""
    dimension, result = table["dimension"], []
    for entry in tables.entries(table, "supports"):
        fixed = entry.get("fixed", "xyz"[:dimension])
        if "direction" in entry or len(fixed) == dimension:
            result.append(entry)
            continue
        if len(fixed) != 1 or "displacement" in entry:
            raise Unfit("a support along two of three axes")
        entry["direction"] = [row["xyz".index(fixed[0])] for row in rows]
        del entry["fixed"]
        result.append(entry)
    if "supports" in table:
        table["supports"] = result


def _name_components(table):
    """Uncertain components as uncertain loads with names."""
    result, dimension = [], table["dimension"]
    for entry in tables.entries(table, "uncertainty"):
        if "forces" in entry:
            result.append(entry)
            continue
        kept = {key: entry[key] for key in ("alpha", "group", "case") if key in entry}
        for node in entry["nodes"]:
            for axis in entry["axes"]:
                force = [entry.get("weight", 1.0) * (axis == each) for each in "xyz"[:dimension]]
                result.append({
                    "name": f"{axis} at {node} {len(result)}", "forces": [{"nodes": [node], "force": force}],
                    **kept
                })
    if result:
        table["uncertainty"] = result


def _admissible(table):
    """@raises Unfit if an uncertain load has a component below the smallest that is read; noise has a
    relation of its own"""
    if any(not 1e-6 <= abs(size) <= 1e6 for size in tables.uncertain_sizes(table)):
        raise Unfit("an uncertain load out of range")


def _turned(angle, round_off):
    """Rotation by an angle; round_off: relative error of the coordinates that it causes."""

    def change(rng, table, question):
        by = angle if angle is not None else rng.uniform(0.2, 1.4)
        rows = _rotation(rng, table["dimension"], math.cos(by), math.sin(by))
        axes = tables.supported_axes(table)
        if any(0 < len(fixed) < table["dimension"] for fixed in axes.values()):
            if question.command == "limit" or any(node in axes for _, node in tables.candidates(table)):
                raise Unfit("supports along axes")
        if table.get("springs") or every_component(table, question):
            raise Unfit("components along axes")
        _incline_supports(table, rows)
        _name_components(table)
        turn = lambda vector: _times(rows, vector)
        tables.change_places(table, turn)
        tables.change_vectors(table, turn)
        _admissible(table)
        return Changed(table, exact=False, error=round_off)

    return change


def _axes(table, order, signs):
    """Axes in another order, some with the other sign, without rounding."""
    place = lambda vector: [sign * vector[axis] + 0.0 for sign, axis in zip(signs, order)]
    if any(isinstance(part, list) for entry in tables.force_lists(table) for part in entry["force"]):
        raise Unfit("a load with intervals")
    tables.change_places(table, place)
    tables.change_vectors(table, place)
    new = {"xyz"[old]: "xyz"[k] for k, old in enumerate(order)}
    for entry in tables.entries(table, "supports", "springs", "uncertainty"):
        for key in ("fixed", "axes"):
            if key in entry:
                entry[key] = [new[axis] for axis in entry[key]]
    return Changed(table)


def _quarter_turn(rng, table, question):
    a, b = (0, 1) if table["dimension"] == 2 else rng.choice(((0, 1), (1, 2), (2, 0)))
    order, signs = list(range(table["dimension"])), [1.0] * table["dimension"]
    order[a], order[b], signs[a] = b, a, -1.0
    return _axes(table, order, signs)


def _half_turn(rng, table, question):
    a, b = (0, 1) if table["dimension"] == 2 else rng.choice(((0, 1), (1, 2), (2, 0)))
    return _axes(table, list(range(table["dimension"])),
                 [-1.0 if k in (a, b) else 1.0 for k in range(table["dimension"])])


def _reflected(rng, table, question):
    axis = rng.randrange(table["dimension"])
    return _axes(table, list(range(table["dimension"])),
                 [-1.0 if k == axis else 1.0 for k in range(table["dimension"])])


def _quarter_turn_by_cosine(rng, table, question):
    """The rotation as a program computes it: cos 90 degrees is 6.1e-17, and so are the zeros of the file."""
    exact = _quarter_turn(rng, table, question).table
    return _noisy(rng, exact, 6.123233995736766e-17)


def _noisy(rng, table, size, of_loads=False):
    """Zeros of coordinates and normals, or of forces, as sines and cosines leave them: up to size times the
    largest number."""
    extent = tables.extent(table)
    at_zero = lambda value, scale: rng.uniform(-1, 1) * size * scale if value == 0 else value
    # Nodes at one place stay there, and mirrored directions are mirrored.
    known = {}

    def place(vector):
        return known.setdefault(("place", *vector), [at_zero(x, extent) for x in vector])

    def vector(components):
        scale = max(map(abs, components), default=0.0)
        if scale == 0:
            return components
        sign = next(-1.0 if x < 0 else 1.0 for x in components if x)
        noise = known.setdefault(("vector", *(sign * x for x in components)),
                                 [at_zero(0.0, 1.0) for _ in components])
        return [sign * noise[k] * scale if x == 0 else x for k, x in enumerate(components)]

    if of_loads:
        tables.change_vectors(table, lambda components: components, vector)
    else:
        tables.change_places(table, place)
        tables.change_vectors(table, vector, lambda force: force)
    return Changed(table, exact=False, error=size)


def _noise(of_loads):

    def change(rng, table, question):
        if of_loads and question.command not in ("hold", "limit"):
            raise Unfit("no loads")
        return _noisy(rng, table, 1e-16, of_loads)

    return change


def _noise_removed(rng, table, question):
    """Coordinates, normals and forces below 1e-14 of the largest ones as the zeros that they stand for."""
    size, found = tables.extent(table), 0

    def clean(vector, scale):
        nonlocal found
        found += any(0 < abs(x) < 1e-14 * scale for x in vector)
        return [0.0 if abs(x) < 1e-14 * scale else x for x in vector]

    tables.change_places(table, lambda place: clean(place, size))
    tables.change_vectors(table, lambda vector: clean(vector, max(map(abs, vector), default=0.0)))
    if not found:
        raise Unfit("no noise")
    return Changed(table, exact=False, error=1e-15)


def _moved(distance):
    """distance: relative to the size of the structure, with which the rounding that it causes grows"""

    def change(rng, table, question):
        # A power of two, so that coordinates of few digits keep their bits.
        size = 2.0**math.frexp(tables.extent(table))[1]
        if tables.shortest(table) < distance * size * ROUNDING * 1e6:
            raise Unfit("nodes as close to each other as the rounding")
        by = [rng.choice((-1.0, 1.0)) * distance * size for _ in range(table["dimension"])]
        exact = all(
            (x + offset) - offset == x for place in table["nodes"].values() for x, offset in zip(place, by))
        tables.change_places(table, lambda place: [x + offset for x, offset in zip(place, by)])
        return Changed(table, exact=exact, error=0.0 if exact else distance * ROUNDING)

    return change


def _in_space(rng, table, question):
    """A plane truss in space, with all nodes supported along z."""
    if not tables.is_plane(table) or table.get("elements") or table.get(
            "springs") or question.command == "rays":
        raise Unfit("no plane truss")
    if tables.has_pairs(table) and question.command != "limit":
        raise Unfit("pairs in a guide need supported masters")
    supports = tables.supported_axes(table)
    if any("direction" in entry or "displacement" in entry for entry in tables.entries(table, "supports")):
        raise Unfit("inclined or displaced supports")
    table["dimension"] = 3
    tables.change_places(table, lambda place: [*place, 0.0])
    tables.change_vectors(table, lambda vector: [*vector, 0.0])
    for entry in tables.entries(table, "uncertainty"):
        if "forces" not in entry and "axes" not in entry:
            raise Unfit("components along axes")
    table["supports"] = [{
        "nodes": [node], "fixed": ["xyz"[axis] for axis in sorted({*supports.get(node, ()), 2})]
    } for node in table["nodes"]]
    return Changed(table)


RELATIONS = [
    Relation("turned by 0.1", ALL, _turned(0.1, 2 * ROUNDING)),
    Relation("turned", ALL, _turned(None, 2 * ROUNDING)),
    Relation("turned by 1e-9", ALL, _turned(1e-9, 2 * ROUNDING)),
    Relation("quarter turn", ALL, _quarter_turn),
    Relation("quarter turn by cosine", ALL, _quarter_turn_by_cosine),
    Relation("half turn", ALL, _half_turn),
    Relation("reflected", ALL, _reflected),
    Relation("noise of cosines", ALL, _noise(False)),
    Relation("noise of cosines in loads", ("hold", "limit"), _noise(True)),
    Relation("noise removed", ALL, _noise_removed),
    Relation("moved by 1e6", ALL, _moved(1e6)),
    Relation("moved by 1024", ALL, _moved(1024.0)),
    Relation("plane in space", ALL, _in_space),
]
