"""Random structures of all kinds that are numerically difficult: degenerate ones, several parts,
contrasts, several obstacles."""

import math
import random

from structure import Mechanism, Structure, compliance, from_toml, to_toml

#: `decimal-grid`, a grid of 0.7 by 0.5 with degenerate nodes perturbed by rounding, is not
#: included: it has no reference.
KINDS = ("bars", "space-bars", "post", "space-post", "pieces", "space-pieces", "grid", "space-grid", "rods", "space-rods",
         "quads", "mesh", "mixed")


def _direction(rng, d):
    while True:
        vector = [rng.gauss(0, 1) for _ in range(d)]
        if math.hypot(*vector) > 0.3:
            return vector


def _stiffness(rng, contrast):
    if contrast <= 1:
        return rng.uniform(0.5, 2)
    return 10 ** rng.uniform(-math.log10(contrast) / 2, math.log10(contrast) / 2)


def _obstacles(rng, d, count):
    """Normals of `count` candidates: of one obstacle, of two, or scattered about one direction."""
    main = _direction(rng, d)
    kind = rng.random()
    if kind < 0.4:
        return [main] * count
    if kind < 0.7:
        other = [x + 0.5 * y for x, y in zip(main, _direction(rng, d))]
        return [rng.choice((main, other)) for _ in range(count)]
    return [[x + 0.4 * y for x, y in zip(main, _direction(rng, d))] for _ in range(count)]


def _outward(a, b):
    """Outward normal of an edge from a to b of a body that is to the left of it."""
    return [b[1] - a[1], a[0] - b[0]]


def _into(normals, faces):
    """Normals of obstacles into the body: turned round together, and then each that still faces away from all faces at its node."""
    inwards = lambda normal, outward: any(sum(x * y for x, y in zip(normal, n)) < 0 for n in outward)
    if 2 * sum(inwards(normal, outward) for normal, outward in zip(normals, faces)) < len(normals):
        normals = [[-x for x in normal] for normal in normals]
    return [normal if inwards(normal, outward) else [-x for x in normal] for normal, outward in zip(normals, faces)]


def _touch(rng, structure, names, normals):
    for name, normal in zip(names, normals):
        tangent = None
        if rng.random() < 0.15:
            tangent = _direction(rng, structure.dimension)
        structure.candidates.append((name, normal, tangent, 1.0))


def _bars(rng, structure, head, m, contrast, shift=0.0):
    d = structure.dimension
    held, free = rng.randint(d, d + 2), m + rng.randint(0, 2)
    place = lambda: [rng.uniform(-1.5, 1.5) + (shift if a == 0 else 0) for a in range(d)]
    supports = [f"{head}s{i}" for i in range(held)]
    nodes = [f"{head}n{i}" for i in range(free)]
    for name in supports:
        structure.nodes[name] = place()
        structure.fixed[name] = set(range(d))
    before = list(supports)
    joined = set()
    for name in nodes:
        structure.nodes[name] = place()
        for other in rng.sample(before, d):
            joined.add((other, name))
        before.append(name)
    everything = supports + nodes
    for _ in range(rng.randint(0, 2 * free)):
        a, b = rng.choice(everything), rng.choice(nodes)
        if a != b and (b, a) not in joined and (a, b) not in joined:
            joined.add((a, b))
    for a, b in sorted(joined):
        structure.bars.append((_stiffness(rng, contrast), a, b))
    _touch(rng, structure, rng.sample(nodes, m), _obstacles(rng, d, m))


def _post(rng, structure, head, contrast, shift):
    """A candidate on d bars; half of them have a bar along the normal, at integer coordinates."""
    d = structure.dimension
    tip = f"{head}tip"
    structure.nodes[tip] = [shift] + [0.0] * (d - 1)
    square = rng.random() < 0.5
    for i in range(d):
        foot = f"{head}foot{i}"
        arm = [float(i == a) for a in range(d)] if square else _direction(rng, d)
        structure.nodes[foot] = [x - y for x, y in zip(structure.nodes[tip], arm)]
        structure.fixed[foot] = set(range(d))
        structure.bars.append((_stiffness(rng, contrast) if not square else float(rng.randint(1, 4)), foot, tip))
    normal = [float(a == 0) for a in range(d)] if square and rng.random() < 0.5 else _direction(rng, d)
    if square and rng.random() < 0.3:
        normal = [1.0] * d
    _touch(rng, structure, [tip], [normal])


def _grid(rng, structure, head, sizes, full, shift=0.0):
    """A right-angled truss at integer coordinates: rows and columns of rods, some diagonals; the
    first layer is fixed."""
    d = structure.dimension
    cells = [[]]
    for size in sizes:
        cells = [cell + [i] for cell in cells for i in range(size)]
    name = lambda cell: head + "g" + "".join(str(i) for i in cell)
    for cell in cells:
        structure.nodes[name(cell)] = [float(x) + (shift if a == 0 else 0) for a, x in enumerate(cell)]
        if cell[d - 1] == 0:
            structure.fixed[name(cell)] = set(range(d))
    for i, a in enumerate(cells):
        for b in cells[i + 1:]:
            step = [y - x for x, y in zip(a, b)]
            if max(abs(x) for x in step) != 1 or a[d - 1] == b[d - 1] == 0:
                continue
            rods = sum(abs(x) for x in step)
            if rods == 1 or rng.random() < (full if rods == 2 else full / 3):
                structure.bars.append((float(rng.choice((1, 1, 1, 2, 4))), name(a), name(b)))
    return [name(cell) for cell in cells if cell[d - 1] == sizes[d - 1] - 1]


def _whole_normals(rng, d, count):
    axis = [0.0] * d
    axis[d - 1] = rng.choice((1.0, -1.0))
    lean = list(axis)
    lean[0] = rng.choice((1.0, -1.0, 2.0, 0.5))
    kind = rng.random()
    if kind < 0.3:
        return [axis] * count
    if kind < 0.6:
        return [lean] * count
    return [rng.choice((axis, lean)) for _ in range(count)]


def _rods(rng, structure, head, m, shift=0.0):
    """Candidates in a row on upright rods; neighbours are joined along the row only, or not at all;
    few diagonals."""
    d = structure.dimension
    tips = []
    bar = lambda a, b: structure.bars.append((float(rng.choice((1, 1, 2, 3))), a, b))
    for i in range(m):
        tip = f"{head}t{i}"
        tips.append(tip)
        structure.nodes[tip] = [i + shift] + [0.0] * (d - 1)
        for axis in range(1, d):
            foot = f"{head}f{i}{axis}"
            structure.nodes[foot] = [i + shift] + [-float(a == axis) for a in range(1, d)]
            structure.fixed[foot] = set(range(d))
            bar(foot, tip)
        if i and rng.random() < 0.8:
            bar(tips[i - 1], tip)
        else:
            foot = f"{head}f{i}0"
            structure.nodes[foot] = [i + shift - 0.5] + [0.0] * (d - 1)
            structure.fixed[foot] = set(range(d))
            bar(foot, tip)
        if i and rng.random() < 0.5:
            bar(f"{head}f{i - 1}{d - 1}", tip)
    _touch(rng, structure, tips, _whole_normals(rng, d, m))


def _quads(rng, structure, head, columns, rows, contrast, shift=0.0):
    """A strip of four-node elements with perturbed nodes, fixed along its left edge, with random
    materials."""
    name = lambda i, j: f"{head}q{i}{j}"
    for i in range(columns + 1):
        for j in range(rows + 1):
            structure.nodes[name(i, j)] = [i + shift + rng.uniform(-0.2, 0.2), j + rng.uniform(-0.2, 0.2)]
            if i == 0:
                structure.fixed[name(i, j)] = {0, 1}
    for i in range(columns):
        for j in range(rows):
            between = [name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)]
            structure.quads.append((_stiffness(rng, contrast), rng.uniform(0, 0.4), 1.0, rng.choice(("stress", "strain")), between))
    at = lambda i, j: structure.nodes[name(i, j)]
    m = rng.randint(2, min(4, rows + 1))
    chosen = rng.sample(range(rows + 1), m)
    faces = [[_outward(at(columns, k), at(columns, k + 1)) for k in (j - 1, j) if 0 <= k < rows]
             + ([_outward(at(columns - 1, 0), at(columns, 0))] if j == 0 else [])
             + ([_outward(at(columns, rows), at(columns - 1, rows))] if j == rows else []) for j in chosen]
    _touch(rng, structure, [name(columns, j) for j in chosen], _into(_obstacles(rng, 2, m), faces))


def _mesh(rng):
    """[[mesh]] at coordinates that are exact in binary, so that all readers compute the same inner nodes."""
    eighth = lambda: rng.randint(-2, 2) / 8
    corners = [[x + eighth(), y + eighth()] for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    columns, rows = rng.choice((1, 2)), rng.choice((1, 2))
    text = ['name = "hostile"', "dimension = 2", 'units = { length = "m", force = "kN" }', "", "[[mesh]]", 'name = "a"',
            f"corners = {corners}", f"divisions = [{columns}, {rows}]", f"E = {rng.uniform(0.5, 2)!r}",
            f"nu = {rng.choice((0.0, 0.25, 0.3))!r}", "thickness = 1.0", f'plane = "{rng.choice(("stress", "strain"))}"',
            "", "[[supports]]", f'nodes = ["a.{rng.choice(("left", "bottom"))}"]']
    right, top = _outward(corners[1], corners[2]), _outward(corners[2], corners[3])
    places = [((columns, j), [right, top] if j == rows else [right]) for j in range(1, rows + 1)]
    places += [((i, rows), [top]) for i in range(1, columns)]
    chosen = rng.sample(places, min(rng.randint(1, rows + 1), len(places)))
    normals = _into(_obstacles(rng, 2, len(chosen)), [faces for _, faces in chosen])
    for ((i, j), _), normal in zip(chosen, normals):
        text += ["", "[[contact]]", f'nodes = ["a.{i},{j}"]', f"normal = {normal}", f"friction_factor = {rng.choice((1.0, 1.0, 0.7))!r}"]
    return "\n".join(text) + "\n"


def _piece(rng, structure, head, m, contrast, shift):
    d = structure.dimension
    kind = rng.random()
    if kind < 0.5:
        _bars(rng, structure, head, m, contrast, shift)
    elif kind < 0.7:
        _rods(rng, structure, head, m, shift)
    elif kind < 0.8 and d == 2:
        _quads(rng, structure, head, 1, 1, contrast, shift)
    else:
        _post(rng, structure, head, contrast, shift)


def _build(rng, kind, contrast):
    structure = Structure(3 if kind.startswith("space") else 2)
    d = structure.dimension
    kind = kind.removeprefix("space-")
    decimal = kind == "decimal-grid"
    kind = kind.removeprefix("decimal-")
    if kind == "mesh":
        return _mesh(rng)
    if kind == "bars":
        _bars(rng, structure, "", rng.randint(1, 5 if d == 2 else 4), contrast)
    elif kind == "post":
        _bars(rng, structure, "a", rng.randint(1, 4 if d == 2 else 3), contrast)
        for i in range(rng.randint(1, 2)):
            _post(rng, structure, f"p{i}", contrast, 20.0 * (i + 1))
    elif kind == "pieces":
        for i in range(rng.randint(2, 3)):
            _piece(rng, structure, "abc"[i], rng.randint(1, 2), contrast, 100.0 * i)
    elif kind == "grid":
        if d == 2:
            columns = rng.randint(2, 5)
            top = _grid(rng, structure, "", (columns, rng.randint(2, 3)), rng.choice((0.4, 0.7, 1.0)))
        else:
            top = _grid(rng, structure, "", (2, 2, 2), rng.choice((0.4, 0.7)))
        m = rng.randint(2, len(top))
        _touch(rng, structure, rng.sample(top, m), _whole_normals(rng, d, m))
        if decimal:
            structure.nodes = {name: [0.7 * x for x in place[:-1]] + [0.5 * place[-1] + 0.1] for name, place in structure.nodes.items()}
    elif kind == "rods":
        _rods(rng, structure, "", rng.randint(2, 5 if d == 2 else 4))
    elif kind == "quads":
        _quads(rng, structure, "", rng.randint(1, 2), rng.randint(1, 3), contrast)
    elif kind == "mixed":
        _quads(rng, structure, "a", 1, 2, contrast)
        _bars(rng, structure, "b", rng.randint(1, 2), contrast, 30.0)
        if rng.random() < 0.5:  # joined by a bar
            structure.bars.append((_stiffness(rng, contrast), "aq11", "bn0"))
    if rng.random() < 0.5:
        frictionless = rng.random() < 0.25
        structure.candidates = [(node, normal, tangent, 0.0 if frictionless and rng.random() < 0.5
                                 else math.exp(rng.uniform(-1.2, 1.2))) for node, normal, tangent, _ in structure.candidates]
        if all(candidate[3] == 0 for candidate in structure.candidates):
            node, normal, tangent, _ = structure.candidates[0]
            structure.candidates[0] = (node, normal, tangent, 1.0)
    rng.shuffle(structure.candidates)
    return to_toml(structure)


class Case:
    """text of a problem file, its kind, contrast, and a friction coefficient"""

    def __init__(self, name, kind, contrast, text, mu):
        self.name, self.kind, self.contrast, self.text, self.mu = name, kind, contrast, text, mu


def make(seed, index, kinds, contrasts, frictionless=True):
    """Case number `index`, the same for the same arguments on any machine."""
    rng = random.Random(f"{seed}/{index}")
    kind = kinds[index % len(kinds)]
    contrast = rng.choice(contrasts)
    while True:
        text = _build(rng, kind, contrast)
        mu = float(f"{math.exp(rng.uniform(-1.4, 1.6)):.6g}")
        if rng.random() < 0.1:
            mu = float(rng.choice((1, 2, 0.5, 3)))
        if rng.random() < 0.04:
            mu = float(f"{10 ** rng.uniform(-5.4, 5.4):.6g}")  # times a factor of up to e^1.2, within 1e-6 to 1e6
        structure = from_toml(text)
        if not frictionless and any(candidate[3] == 0 for candidate in structure.candidates):
            continue
        try:
            compliance(structure)
        except Mechanism:
            continue
        return Case(f"{seed}-{index:05d}-{kind}", kind, contrast, text, mu)
