"""Trusses as people draw them: nodes on a grid or on a circle, bars along the axes, equal sections, a few
loads with names. Coordinates have zeros, optima are degenerate, and many bars are loaded alike."""


def _members(rng, groups):
    """Groups of bars with yield forces, some of them cables or slender."""
    members = []
    for between in groups:
        if not between:
            continue
        strong = float(rng.choice((50, 100, 200)))
        kind = rng.random()
        share = 1.0 if kind < 0.6 else 0.4 if kind < 0.9 else 0.0
        strength = {"tension": strong, "compression": share * strong}
        members.append({"EA": 100.0 * strong, "yield": strength, "between": between})
    return members


def _loads(rng, nodes, dimension):
    """Dead and reference loads downwards, and named loads that vary."""
    down = [0.0] * (dimension - 1) + [-1.0]
    loads = []
    if rng.random() < 0.8:
        loads.append({"kind": "dead", "nodes": nodes, "force": [2.0 * x for x in down]})
    loads.append({
        "kind": "reference", "nodes": rng.sample(nodes, rng.randint(1, len(nodes))),
        "force": [10.0 * x for x in down]
    })
    uncertain = []
    for name, nodes_of_it in (("gust", rng.sample(nodes, max(1,
                                                             len(nodes) // 2))),
                              ("half", nodes[:max(1,
                                                  len(nodes) // 2)])):
        force = [0.0] * dimension
        force[rng.randrange(dimension)] = float(rng.choice((-3, 2, 5)))
        uncertain.append({"name": name, "forces": [{"nodes": nodes_of_it, "force": force}]})
    return {"loads": loads, "uncertainty": uncertain[:rng.randint(1, 2)]}


def _table(dimension, nodes, members, supports, loads):
    return {
        "name": "girder", "dimension": dimension, "units": {"length": "m", "force": "kN"}, "nodes": nodes,
        "members": members, "supports": supports, **loads
    }


def girder(rng):
    """A plane girder with crossed diagonals, hinged at one end and on a roller at the other."""
    bays, height, width = rng.randint(2, 4), float(rng.choice((1, 2, 3))), float(rng.choice((1, 2, 4)))
    nodes = {f"{row}{k}": [k * width, height * (row == "t")] for row in "bt" for k in range(bays + 1)}
    chords = [[[f"{row}{k}", f"{row}{k + 1}"] for k in range(bays)] for row in "bt"]
    posts = [[f"b{k}", f"t{k}"] for k in range(bays + 1)]
    diagonals = [[f"b{k}", f"t{k + 1}"] for k in range(bays)], [[f"t{k}", f"b{k + 1}"] for k in range(bays)
                                                                if rng.random() < 0.7]
    supports = [{"nodes": ["b0"]}, {"nodes": [f"b{bays}"], "fixed": ["y"]}]
    return _table(2, nodes, _members(rng, [*chords, posts, *diagonals]), supports,
                  _loads(rng, [f"t{k}" for k in range(bays + 1)], 2))


def tower(rng):
    """A square tower in space, with crossed diagonals on its sides and at its levels."""
    levels = rng.randint(1, 2)
    corners = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    nodes = {
        f"{level}.{k}": [x, y, 3.0 * level]
        for level in range(levels + 1) for k, (x, y) in enumerate(corners)
    }
    legs, rings, crosses = [], [], []
    for level in range(1, levels + 1):
        for k in range(4):
            other = (k + 1) % 4
            legs.append([f"{level - 1}.{k}", f"{level}.{k}"])
            rings.append([f"{level}.{k}", f"{level}.{other}"])
            crosses.append([f"{level - 1}.{k}", f"{level}.{other}"])
            if rng.random() < 0.7:
                crosses.append([f"{level - 1}.{other}", f"{level}.{k}"])
        rings.append([f"{level}.0", f"{level}.2"])
    return _table(3, nodes, _members(rng, [legs, rings, crosses]), [{"nodes": [f"0.{k}" for k in range(4)]}],
                  _loads(rng, [f"{levels}.{k}" for k in range(4)], 3))


#: Points of a circle with whole coordinates, in order around it.
CIRCLE = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3)]
CIRCLE += [(-x, -y) for x, y in CIRCLE]


def dome(rng):
    """A ring dome of one or two rings, at whole coordinates: the noise of sines and cosines is a relation."""
    every, rings = rng.choice(((3, 1), (3, 2), (1, 1)))
    points = CIRCLE[::every]
    sides = len(points)
    nodes = {"top": [0.0, 0.0, 2.0 * rings + 1.0]}
    for ring in range(rings + 1):
        for k, (x, y) in enumerate(points):
            nodes[f"r{ring}.{k}"] = [x * (ring + 1.0), y * (ring + 1.0), 2.0 * (rings - ring)]
    ribs = [["top", f"r0.{k}"] for k in range(sides)]
    ribs += [[f"r{ring}.{k}", f"r{ring + 1}.{k}"] for ring in range(rings) for k in range(sides)]
    hoops = [[f"r{ring}.{k}", f"r{ring}.{(k + 1) % sides}"] for ring in range(rings) for k in range(sides)]
    diagonals = [[f"r{ring}.{k}", f"r{ring + 1}.{(k + 1) % sides}"] for ring in range(rings)
                 for k in range(sides)]
    return _table(3, nodes, _members(rng, [ribs, hoops, diagonals]),
                  [{"nodes": [f"r{rings}.{k}" for k in range(sides)]}],
                  _loads(rng, ["top", *(f"r0.{k}" for k in range(sides))], 3))


KINDS = {"girder": girder, "tower": tower, "dome": dome}
