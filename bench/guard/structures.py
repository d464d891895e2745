"""Problem files that no `kusabi example` makes: an arch of voussoirs and a dome with a lantern."""

import math

from faces import write

ARCH = """name = "arch of voussoirs"
dimension = 2
units = {{ length = "m", force = "kN" }}
gravity = [0, -1]

[nodes]
{nodes}
[[elements]]
E = 1e6
nu = 0.3
thickness = 1
plane = "strain"
density = 1
between = [{quads}]
"""
DOME = """name = "dome with a lantern"
dimension = 3
units = {{ length = "m", force = "kN" }}

[nodes]
{nodes}
[[members]]
yield = {{ tension = 240.0, compression = 120.0 }}
between = [{members}]

[[supports]]
nodes = [{supported}]

[[loads]]
kind = "reference"
nodes = [{loaded}]
force = [0.0, 0.0, -10.0]
"""


def arch(voussoirs):
    """A semicircular arch of equal voussoirs on two springings under its own weight, 0.15 of its radius
    thick: two candidates at each joint."""
    def point(radius, joint):
        angle = math.pi * joint / voussoirs
        return f"[{radius * math.cos(angle)!r}, {radius * math.sin(angle)!r}]"

    nodes = "".join(f"{side}{k}_{end} = {point(radius, k + end)}\n" for k in range(voussoirs)
                    for side, radius in (("i", 0.925), ("o", 1.075)) for end in (0, 1))
    quads = ", ".join(f'["i{k}_0", "o{k}_0", "o{k}_1", "i{k}_1"]' for k in range(voussoirs))
    text = ARCH.format(nodes=nodes, quads=quads)
    last = voussoirs - 1
    for springing in ('"i0_0", "o0_0"', f'"i{last}_1", "o{last}_1"'):
        text += f"\n[[contact]]\nnodes = [{springing}]\nnormal = [0, 1]\n"
    for k in range(1, voussoirs):
        angle = math.pi * k / voussoirs
        text += f'\n[[contact]]\nnodes = ["i{k}_0", "o{k}_0"]\n'
        text += f"normal = [{-math.sin(angle)!r}, {math.cos(angle)!r}]\n"
        text += f'against = ["i{k - 1}_1", "o{k - 1}_1"]\n'
    return lambda folder: write(folder, "arch", text)


def dome_places(segments, rings):
    """Nodes on a paraboloid: (k, j) on ring k from the opening; ("h", j) on the lower ring of the lantern."""
    places = {}
    for j in range(segments):
        angle = 2 * math.pi * j / segments
        for node, radius in [(("h", j), 1.2), *(((k, j), 1.2 + 2.1 * k) for k in range(rings + 1))]:
            height = 5.4 if node[0] == "h" else 6 - 0.054 * radius**2
            place = radius * math.cos(angle), radius * math.sin(angle), height
            places[node] = [round(x, 3) + 0.0 for x in place]
    return places


def dome_members(segments, rings):
    """Meridians, rings and one diagonal of each field; the lantern below the opening."""
    for j in range(segments):
        after = (j + 1) % segments
        yield from ((("h", j), other) for other in ((0, j), (1, j), ("h", after), (0, after)))
        for k in range(rings):
            yield from (((k, j), (k + 1, j)), ((k, j), (k, after)), ((k + 1, j), (k, after)))


def dome(segments, rings):
    """A dome of bars, pinned at its lowest ring, under a vertical reference load and four uncertain loads
    that act on many nodes each: wind along two axes, drifted and even snow."""
    def name(node):
        return f'"{node[0]}.{node[1]}"'

    def names(nodes):
        return ", ".join(map(name, nodes))

    places = dome_places(segments, rings)
    loaded = [node for node in places if node[0] != rings]
    text = DOME.format(
        nodes="".join(f"{name(node)} = {place}\n" for node, place in places.items()),
        members=", ".join(f"[{names(pair)}]" for pair in dome_members(segments, rings)),
        supported=names((rings, j) for j in range(segments)), loaded=names(loaded))
    for title, force_at in (("wind x", lambda x: [0.3, 0.0, 0.0]), ("wind y", lambda x: [0.0, 0.3, 0.0]),
                            ("drifted snow", lambda x: [0.0, 0.0, math.copysign(0.3, x) if x else 0.0]),
                            ("snow", lambda x: [0.0, 0.0, -0.3])):
        forces = [(node, force_at(places[node][0])) for node in loaded]
        listed = [f"{{ nodes = [{name(node)}], force = {force} }}" for node, force in forces if any(force)]
        text += f'\n[[uncertainty]]\nname = "{title}"\nforces = [{", ".join(listed)}]\n'
    return lambda folder: write(folder, "dome", text)
