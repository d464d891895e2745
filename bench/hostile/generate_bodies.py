"""Random bodies of kinds that generate.py lacks: unconstrained bodies, pairs, nodes with several
normals, long levers, weak couplings.

Plane ones are read by bodies.py; for those in space certificates and outputs are checked. Levers
and couplings reach the limits of floating point: the answer must be correct, or open in a sentence
and by the exit code.
"""

import math
import random

from generate import Case, _direction, _stiffness

KINDS = ("loose-truss", "loose-mesh", "wedge", "pair", "loose-pair", "corner", "loose-corner", "mixture", "lever", "coupling",
         "space-loose")


class _Draft:
    """Lines of a problem file; positions of nodes."""

    def __init__(self, rng, contrast, dimension=2):
        self.rng, self.contrast, self.dimension = rng, contrast, dimension
        self.nodes, self.sections, self.contacts = {}, [], []

    def node(self, name, place):
        self.nodes[name] = [float(x) for x in place]
        return name

    def bar(self, a, b, stiffness=None):
        value = _stiffness(self.rng, self.contrast) if stiffness is None else stiffness
        self.sections += ["", "[[members]]", f"EA = {value!r}", f'between = [["{a}", "{b}"]]']

    def element(self, between):
        quoted = ", ".join(f'"{node}"' for node in between)
        self.sections += ["", "[[elements]]", f"E = {_stiffness(self.rng, self.contrast)!r}", f"nu = {self.rng.uniform(0, 0.4)!r}",
                          "thickness = 1.0", f'plane = "{self.rng.choice(("stress", "strain"))}"', f"between = [[{quoted}]]"]

    def support(self, node, axes=None):
        axes = axes or "xyz"[:self.dimension]
        self.sections += ["", "[[supports]]", f'nodes = ["{node}"]']
        if axes != "xyz"[:self.dimension]:
            self.sections += [f"fixed = {list(axes)}".replace("'", '"')]

    def contact(self, node, normal, against=None):
        lines = ["", "[[contact]]", f'nodes = ["{node}"]', f"normal = {[float(x) for x in normal]}"]
        if against:
            lines += [f"against = [{{ nodes = {[n for n, _ in against]}, weights = {[w for _, w in against]} }}]".replace("'", '"')]
        if self.rng.random() < 0.3:
            lines += [f"friction_factor = {math.exp(self.rng.uniform(-1.2, 1.2))!r}"]
        self.contacts.append(lines)

    def text(self):
        self.rng.shuffle(self.contacts)
        lines = ['name = "hostile"', f"dimension = {self.dimension}", 'units = { length = "m", force = "kN" }', "", "[nodes]"]
        lines += [f'"{name}" = {place}' for name, place in self.nodes.items()]
        return "\n".join(lines + self.sections + [line for each in self.contacts for line in each]) + "\n"


def _round_places(rng, count, radius=1.0, centre=(0.0, 0.0)):
    """Positions around a centre, in order."""
    angles = sorted((k + rng.uniform(-0.3, 0.3)) * 2 * math.pi / count for k in range(count))
    return [[centre[0] + radius * rng.uniform(0.7, 1.1) * math.cos(a), centre[1] + radius * rng.uniform(0.7, 1.1) * math.sin(a)]
            for a in angles]


def _inwards(rng, place, spread=0.5):
    """Normal of an obstacle that faces a body about the origin."""
    angle = math.atan2(-place[1], -place[0]) + rng.uniform(-spread, spread)
    return [math.cos(angle), math.sin(angle)]


def _truss(draft, head, places):
    """Bars between all nodes, or nearly all."""
    names = [draft.node(f"{head}{i}", place) for i, place in enumerate(places)]
    count = len(names)
    for i in range(count):
        for j in range(i):
            if count < 5 or draft.rng.random() < 0.85 or abs(i - j) in (1, 2, count - 1, count - 2):
                draft.bar(names[j], names[i])
    return names


def _fan(draft, head, places):
    """Triangles around the middle."""
    middle = draft.node(f"{head}m", [sum(p[k] for p in places) / len(places) for k in (0, 1)])
    names = [draft.node(f"{head}{i}", place) for i, place in enumerate(places)]
    for i, name in enumerate(names):
        draft.element([middle, name, names[(i + 1) % len(names)]])
    return names


def _touch(draft, names, count):
    for name in draft.rng.sample(names, min(count, len(names))):
        draft.contact(name, _inwards(draft.rng, draft.nodes[name]))


def _loose(draft, mesh):
    rng = draft.rng
    make = _fan if mesh else _truss
    names = make(draft, "n", _round_places(rng, rng.randint(3, 6)))
    _touch(draft, names, rng.randint(2, 5))


def _wedge(draft):
    """A block at integer coordinates between planes with integer slopes: degenerate patterns, and
    parallel walls."""
    rng = draft.rng
    width, height = rng.randint(1, 3), rng.randint(1, 2)
    places = [[0, 0], [width, 0], [width, height], [0, height]]
    names = [draft.node(f"q{i}", place) for i, place in enumerate(places)]
    draft.element(names)
    slope = float(rng.choice((0, 1, 2, 4)))
    normals = [[4, slope], [-4, slope], [-4, slope], [4, slope]]
    for i in sorted(rng.sample(range(4), rng.randint(2, 4))):
        draft.contact(names[i], normals[i])


def _held(draft, names):
    """Two supported nodes beside a body, on two bars each."""
    rng = draft.rng
    for k in range(2):
        foot = draft.node(f"foot{k}", [rng.uniform(3, 4), rng.uniform(-2, 2)])
        draft.support(foot)
        for name in rng.sample(names, 2):
            draft.bar(foot, name)


def _pair(draft, held):
    """A body inside another one in contact with its edges; the outer one is fixed, or rests on obstacles."""
    rng = draft.rng
    outer = (_fan if rng.random() < 0.5 else _truss)(draft, "b", _round_places(rng, rng.randint(3, 5), 2.0))
    if held:
        _held(draft, outer)
    else:
        _touch(draft, outer, rng.randint(1, 2))
    places, against = [], []
    for k in range(rng.randint(2, 4)):
        i = rng.randrange(len(outer))
        a, b = outer[i], outer[(i + 1) % len(outer)]
        share = rng.choice((0.0, 0.25, 0.5, 0.75, rng.randint(1, 7) / 8))
        place = [share * x + (1 - share) * y for x, y in zip(draft.nodes[a], draft.nodes[b])]
        if place in places:
            continue
        places.append(place)
        against.append([(a, share), (b, 1 - share)] if share else [(b, 1.0)])
    extra = [[rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)] for _ in range(3 - len(places))] if len(places) < 3 else \
        [[rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)]] if rng.random() < 0.5 else []
    inner = _truss(draft, "a", places + extra)
    for name, place in zip(inner, against):
        draft.contact(name, _inwards(rng, draft.nodes[name]), place)
    if rng.random() < 0.3:
        draft.contact(inner[-1], _direction(rng, 2)) if extra else None
    if rng.random() < 0.3:
        foot = draft.node("stay", [rng.uniform(-0.2, 0.2), rng.uniform(2.5, 3)])
        draft.support(foot)
        draft.bar(foot, inner[0])


def _corner(draft, held):
    rng = draft.rng
    names = _truss(draft, "n", _round_places(rng, rng.randint(3, 5)))
    if held:
        _held(draft, names)
    chosen = rng.sample(names, rng.randint(2, min(3, len(names))))
    for name in chosen[1:]:
        draft.contact(name, _inwards(rng, draft.nodes[name]))
    inward = math.atan2(-draft.nodes[chosen[0]][1], -draft.nodes[chosen[0]][0])
    for side in (-1, 1):
        angle = inward + side * rng.uniform(0.3, 1.2)
        draft.contact(chosen[0], [math.cos(angle), math.sin(angle)])


def _mixture(draft):
    """A constrained truss, an unconstrained mesh and another constrained part, each with candidates."""
    rng = draft.rng
    names = _truss(draft, "n", _round_places(rng, 3))
    _held(draft, names)
    _touch(draft, names, 1)
    _touch(draft, _fan(draft, "m", _round_places(rng, rng.randint(3, 4))), rng.randint(2, 3))
    if rng.random() < 0.5:
        _touch(draft, _truss(draft, "k", _round_places(rng, 3)), 2)


def _lever(draft):
    """An unconstrained truss with a node 10^6 to 10^13 away, on bars of the same stiffness as the others."""
    rng = draft.rng
    names = _truss(draft, "n", _round_places(rng, rng.randint(3, 4)))
    length, angle = 10 ** rng.uniform(6, 13), rng.uniform(0, 2 * math.pi)
    far = draft.node("far", [length * math.cos(angle), length * math.sin(angle)])
    for name in rng.sample(names, 2):
        draft.bar(far, name, length * rng.uniform(0.5, 2))
    _touch(draft, names, rng.randint(2, 3))
    draft.contact(far, _direction(rng, 2))


def _coupling(draft):
    """Two constrained trusses, joined by a very weak bar."""
    rng = draft.rng
    pieces = []
    for head, shift in (("a", 0.0), ("b", 6.0)):
        names = _truss(draft, head, _round_places(rng, 3, centre=(shift, 0.0)))
        for k in range(2):
            foot = draft.node(f"{head}foot{k}", [shift + rng.uniform(-1, 1), -2.0 + rng.uniform(-0.5, 0.5)])
            draft.support(foot)
            for name in rng.sample(names, 2):
                draft.bar(foot, name)
        pieces.append(names)
    draft.bar(rng.choice(pieces[0]), rng.choice(pieces[1]), 10 ** -rng.uniform(6, 13))
    for names in pieces:
        for name in rng.sample(names, rng.randint(1, 2)):
            draft.contact(name, _direction(rng, 2))


def _tetrahedron(draft, head, size=1.0, further=()):
    """Four corners as bars or solid, with further nodes as bars."""
    rng = draft.rng
    corners = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1], *further]
    names = [draft.node(f"{head}{i}", [size * x + rng.uniform(-0.3, 0.3) for x in corner]) for i, corner in enumerate(corners)]
    if len(names) == 4 and rng.random() < 0.5:
        draft.sections += ["", "[[elements]]", f"E = {_stiffness(rng, draft.contrast)!r}", "nu = 0.3",
                           "between = [[" + ", ".join(f'"{name}"' for name in names) + "]]"]
    else:
        _all_bars(draft, names)
    return names


def _all_bars(draft, names):
    for i, b in enumerate(names):
        for a in names[:i]:
            draft.bar(a, b)


def _inwards_in_space(draft, name):
    return [-x + draft.rng.uniform(-0.7, 0.7) for x in draft.nodes[name]]


def _space(draft):
    """An unconstrained tetrahedron of bars or solid, or a truss of five nodes, with obstacles around it."""
    rng = draft.rng
    names = _tetrahedron(draft, "n", further=[[0.1, 0.2, 1.8]] if rng.random() < 0.5 else [])
    for name in rng.sample(names, rng.randint(2, len(names))):
        draft.contact(name, _inwards_in_space(draft, name))


def _space_supported(draft, kind):
    """A tetrahedron with feet, or with a support that leaves some of its motions, or with two obstacles at a node."""
    rng = draft.rng
    names = _tetrahedron(draft, "n")
    if kind == "held":
        _feet(draft, names)
    if kind == "partly":
        draft.support(names[3], rng.choice(("xyz", "xy", "z")))
    for name in rng.sample(names[:3], rng.randint(2, 3)):
        draft.contact(name, _inwards_in_space(draft, name))
    if kind == "corner":
        for _ in range(2):
            draft.contact(names[3], _inwards_in_space(draft, names[3]))


def _feet(draft, names):
    for k in range(3):
        foot = draft.node(f"foot{k}", [4 + draft.rng.uniform(-1, 1), *(draft.rng.uniform(-2, 2) for _ in range(2))])
        draft.support(foot)
        for name in names:
            draft.bar(foot, name)


def _space_pair(draft, held):
    """A truss inside a tetrahedron, in contact with its faces; the outer one is fixed, or rests on obstacles."""
    rng = draft.rng
    outer = _tetrahedron(draft, "b", 2.0)
    if held:
        _feet(draft, outer)
    else:
        for name in rng.sample(outer, rng.randint(1, 2)):
            draft.contact(name, _inwards_in_space(draft, name))
    inner = []
    for k in range(rng.randint(2, 3)):
        face = [name for i, name in enumerate(outer) if i != k]
        weights = rng.choice(([0.25, 0.25, 0.5], [0.5, 0.375, 0.125], [0.5, 0.5, 0.0], [0.125, 0.125, 0.75]))
        place = [sum(w * draft.nodes[name][axis] for w, name in zip(weights, face)) for axis in range(3)]
        against = [(name, w) for name, w in zip(face, weights) if w]
        inner.append(draft.node(f"a{k}", place))
        draft.contact(inner[-1], _inwards_in_space(draft, inner[-1]), against)
    inner += [draft.node(f"a{k}", [rng.uniform(-0.5, 0.5) for _ in range(3)]) for k in range(len(inner), 4)]
    _all_bars(draft, inner)


def _build(rng, kind, contrast):
    draft = _Draft(rng, contrast, 3 if kind.startswith("space") else 2)
    if kind in ("loose-truss", "loose-mesh"):
        _loose(draft, kind == "loose-mesh")
    elif kind == "wedge":
        _wedge(draft)
    elif kind in ("pair", "loose-pair"):
        _pair(draft, kind == "pair")
    elif kind in ("corner", "loose-corner"):
        _corner(draft, kind == "corner")
    elif kind == "mixture":
        _mixture(draft)
    elif kind == "lever":
        _lever(draft)
    elif kind == "coupling":
        _coupling(draft)
    elif kind in ("space-pair", "space-loose-pair"):
        _space_pair(draft, kind == "space-pair")
    elif kind in ("space-held", "space-partly", "space-corner"):
        _space_supported(draft, kind.removeprefix("space-"))
    else:
        _space(draft)
    return draft.text()


def make(seed, index, kinds, contrasts):
    """Case number `index`, the same for the same arguments on any machine. It may be a mechanism."""
    rng = random.Random(f"bodies/{seed}/{index}")
    kind = kinds[index % len(kinds)]
    far = kind in ("lever", "coupling")
    contrast = 1.0 if far else rng.choice(contrasts)
    mu = float(f"{math.exp(rng.uniform(-1.4, 1.6)):.6g}")
    return Case(f"{seed}-{index:05d}-{kind}", kind, contrast, _build(rng, kind, contrast), mu)
