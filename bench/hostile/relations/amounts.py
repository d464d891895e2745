"""Relations of amounts: units, stiffnesses, areas, loads, friction factors, load factors."""

import table as tables
from positions import ROUNDING
from relation import ALL, FRICTION, Changed, Relation, every_component
from table import Unfit, scaled


def _moduli(table, force, length):
    """All stiffnesses and strengths in other units. Thicknesses are lengths."""
    for entry in tables.entries(table, "members"):
        for key in ("EA", "yield"):
            if key in entry:
                entry[key] = scaled(entry[key], force)
        if "A" in entry:
            entry["A"] *= length**2
    for entry in tables.entries(table, "members", "elements"):
        for key in ("E", "fy"):
            if key in entry:
                entry[key] = scaled(entry[key], force / length**2)
        if "buckling" in entry:
            entry["buckling"] = {
                key: value * length if key == "i" else value
                for key, value in entry["buckling"].items()
            }
        if "thickness" in entry:
            entry["thickness"] *= length
        if "density" in entry:
            entry["density"] *= force / length**3
    for entry in tables.entries(table, "springs"):
        entry["stiffness"] *= force / length


def _units(force, length, exact):
    """Another unit of force, and of length. A density is a weight per volume, since gravity keeps its
    number."""

    def change(rng, table, question):
        _moduli(table, force, length)
        tables.change_places(table, lambda place: scaled(place, length))
        for entry in tables.entries(table, "contact", "ties", "supports"):
            for key in ("clearance", "interference", "gap", "displacement"):
                if key in entry:
                    entry[key] = scaled(entry[key], length)
        tables.scale_forces(table, force)
        if any(not 1e-6 <= abs(size) <= 1e6 for size in tables.uncertain_sizes(table)):
            raise Unfit("an uncertain load out of range")
        own = "uncertainty" in table or question.command != "limit"
        return Changed(table, exact=exact, error=0.0 if exact else ROUNDING, force=force,
                       alpha=1.0 if own else force)

    return change


def _no_displacements(table):
    """@raises Unfit if the load contains displacements, to which forces are not proportional"""
    if "temperature" in table or any(
            entry.get(key) for entry in tables.entries(table, "contact", "supports")
            for key in ("clearance", "interference", "displacement")):
        raise Unfit("displacements are given")


def _stiffer(rng, table, question):
    """All stiffnesses times one number. Limit loads do not depend on them at all."""
    if question.command == "hold":
        _no_displacements(table)
    by = 2.0**rng.randint(-20, 20)
    for entry in tables.entries(table, "members", "elements"):
        for key in ("EA", "E"):
            if key in entry and not ("buckling" in entry):
                entry[key] *= rng.choice((0.25, 1.0, 8.0)) if question.command == "limit" else by
    for entry in tables.entries(table, "springs"):
        entry["stiffness"] *= by
    return Changed(table)


def _areas(rng, table, question):
    """All areas, thicknesses, axial stiffnesses and yield forces times one number, and all loads as well: a
    weight is proportional to the areas."""
    by = 2.0**rng.randint(-6, 6)
    for entry in tables.entries(table, "members"):
        if "buckling" in entry:
            raise Unfit("buckling depends on the radius of gyration")
        for key in ("EA", "yield", "A"):
            if key in entry:
                entry[key] = scaled(entry[key], by)
    for entry in tables.entries(table, "elements"):
        if "thickness" not in entry:
            raise Unfit("elements in space")
        entry["thickness"] *= by
    for entry in tables.entries(table, "springs"):
        entry["stiffness"] *= by
    tables.scale_forces(table, by)
    own = "uncertainty" in table or question.command != "limit"
    return Changed(table, force=by, alpha=1.0 if own else by)


def _loads(rng, table, question):
    """All loads times one number: without given displacements factors are the same."""
    _no_displacements(table)
    if "gravity" in table:
        raise Unfit("a weight")
    by = 2.0**rng.randint(-20, 20)
    tables.scale_forces(table, by)
    return Changed(table, force=by)


def _reference(table):
    entries = [entry for entry in tables.entries(table, "loads") if entry["kind"] == "reference"]
    if not entries:
        raise Unfit("no reference load")
    return entries


def _reference_times(by):
    """The reference load times a number: factors are divided by it."""

    def change(rng, table, question):
        for entry in _reference(table):
            entry["force"] = scaled(entry["force"], by)
        if question.lose is not None and by < 0:
            raise Unfit("one end only")
        return Changed(table, slope=1.0 / by)

    return change


def _shifted(rng, table, question):
    """A multiple of the reference load becomes a part of the dead load."""
    of_dead_load = question.command == "hold" and question.mu is None or "--grip" in question.more
    if of_dead_load or question.lose is not None:
        raise Unfit("the dead load alone")
    by = rng.choice((-2.0, -0.5, 0.25, 1.0, 2.0))
    added = [{**entry, "kind": "dead", "force": scaled(entry["force"], by)} for entry in _reference(table)]
    if every_component(table, question):
        raise Unfit("uncertain where no load is")
    table["loads"] += added
    # Sums of loads at a node are rounded, and a state at an end may hold for the exact sum only.
    return Changed(table, exact=False, error=ROUNDING, shift=-by)


def _friction(by):
    """All friction factors times a number, and the coefficient divided by it."""

    def change(rng, table, question):
        for entry in tables.entries(table, "contact"):
            entry["friction_factor"] = entry.get("friction_factor", 1.0) * by
            if not (entry["friction_factor"] == 0 or 1e-6 <= entry["friction_factor"] <= 1e6):
                raise Unfit("a friction factor out of range")
        return Changed(table, mu=1.0 / by)

    return change


def _coefficient(rng, table, question):
    """The coefficient of the call as friction factors of the file, and 1 in the call."""
    if question.mu is None:
        raise Unfit("no coefficient")
    changed = _friction(question.mu)(rng, table, question)
    changed.exact = False
    changed.error = ROUNDING
    return changed


LOADED = ("hold", "limit")
RELATIONS = [
    Relation("units by powers of two", ALL, _units(2.0**10, 2.0**-7, True)),
    Relation("units", ALL, _units(1e3, 1e3, False)),
    Relation("small units", ALL, _units(1e-6, 1e-3, False)),
    Relation("other stiffness", ALL, _stiffer),
    Relation("areas", ALL, _areas),
    Relation("all loads", ("hold", ), _loads),
    Relation("reference reversed", LOADED, _reference_times(-1.0)),
    Relation("reference times 8", LOADED, _reference_times(8.0)),
    Relation("reference shifted", LOADED, _shifted),
    Relation("friction factors", FRICTION, _friction(0.25)),
    Relation("coefficient in the file", ("patterns", "rays", "hold"), _coefficient),
]
