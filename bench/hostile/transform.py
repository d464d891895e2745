"""Transformations of structures that do not change the answer.

Each is exact in binary arithmetic, so that degenerate patterns stay degenerate; None if it cannot
be exact.
"""

import copy



def _all(structure):
    return copy.deepcopy(structure)


def scale(rng, structure):
    """Lengths and forces multiplied by powers of two; moduli change accordingly, thicknesses stay."""
    result = _all(structure)
    length, force = 2.0 ** rng.randint(-16, 16), 2.0 ** rng.randint(-30, 30)
    result.nodes = {name: [length * x for x in place] for name, place in result.nodes.items()}
    result.bars = [(force * stiffness, a, b) for stiffness, a, b in result.bars]
    result.quads = [(force / length * modulus, *rest) for modulus, *rest in result.quads]
    result.candidates = [(node, [2.0 * x for x in normal],
                          tangent, friction) for node, normal, tangent, friction in result.candidates]
    return result


def turn(rng, structure):
    """Quarter turns and a reflection: the axes in another order, some with the other sign."""
    d = structure.dimension
    order = list(range(d))
    rng.shuffle(order)
    signs = [rng.choice((1.0, -1.0)) for _ in range(d)]
    place = lambda vector: [signs[k] * float(vector[order[k]]) for k in range(d)]
    result = _all(structure)
    result.nodes = {name: place(x) for name, x in result.nodes.items()}
    result.fixed = {name: {order.index(axis) for axis in axes} for name, axes in result.fixed.items()}
    result.candidates = [(node, place(normal), None if tangent is None else place(tangent), friction)
                         for node, normal, tangent, friction in result.candidates]
    return result


def renumber(rng, structure):
    """Nodes, bars, elements, supports and candidates in another order; bars and elements reversed."""
    result = _all(structure)
    shuffled = lambda items: rng.sample(items, len(items))
    result.nodes = dict(shuffled(list(result.nodes.items())))
    result.fixed = dict(shuffled(list(result.fixed.items())))
    result.bars = [(stiffness, b, a) if rng.random() < 0.5 else (stiffness, a, b) for stiffness, a, b in shuffled(result.bars)]
    result.quads = [(*rest, between[::-1] if rng.random() < 0.5 else between) for *rest, between in shuffled(result.quads)]
    result.candidates = shuffled(result.candidates)
    return result


def split(rng, structure):
    """A bar along an axis divided in two at a node with rollers across it: the same stiffness."""
    d = structure.dimension
    choices = []
    for i, (_, a, b) in enumerate(structure.bars):
        along = [axis for axis in range(d) if structure.nodes[a][axis] != structure.nodes[b][axis]]
        if len(along) == 1:
            axis = along[0]
            low, high = structure.nodes[a][axis], structure.nodes[b][axis]
            middle = (low + high) / 2
            if middle * 2 == low + high and (high - middle) * 2 == high - low and middle == int(middle * 8) / 8:
                choices.append((i, axis, middle))
    if not choices:
        return None
    result = _all(structure)
    i, axis, middle = rng.choice(choices)
    stiffness, a, b = result.bars[i]
    place = list(result.nodes[a])
    place[axis] = middle
    if any(place == other for other in result.nodes.values()):
        return None
    result.nodes["between"] = place
    result.fixed["between"] = set(range(d)) - {axis}
    result.bars[i:i + 1] = [(stiffness, a, "between"), (stiffness, "between", b)]
    return result


def post(rng, structure):
    """A distant candidate on bars along the axes with the normal along one: it never wedges and is
    inactive."""
    result = _all(structure)
    d = structure.dimension
    far = [4096.0] + [0.0] * (d - 1)
    result.nodes["far"] = far
    for axis in range(d):
        foot = list(far)
        foot[axis] -= 1.0
        result.nodes[f"far{axis}"] = foot
        result.fixed[f"far{axis}"] = set(range(d))
        result.bars.append((float(rng.randint(1, 3)), f"far{axis}", "far"))
    normal = [0.0] * d
    normal[rng.randrange(d)] = rng.choice((1.0, -1.0))
    result.candidates.insert(rng.randint(0, len(result.candidates)), ("far", normal, None, 1.0))
    return result


ALL = {"scale": scale, "turn": turn, "renumber": renumber, "split": split, "post": post}
