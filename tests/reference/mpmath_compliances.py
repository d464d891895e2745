#!/usr/bin/env python3
"""F of random structures with 60 digits: mpmath_compliances.json beside this file.

Written from the definitions alone: bars by their elongations, quadrilaterals by 2 x 2 Gauss points,
the whole stiffness inverted by LU. All doubles are taken as exact.
"""
import json
import pathlib
import random

from mpmath import inverse, matrix, mp, mpf, sqrt

mp.dps = 60


def unit(vector):
    size = sqrt(sum(x * x for x in vector))
    return [x / size for x in vector]


def frame(normal, tangent):
    n = unit([mpf(x) for x in normal])
    if len(n) == 2 and tangent is None:
        return [n, [n[1], -n[0]]]
    wish = [mpf(x) for x in tangent] if tangent else None
    if wish is None:
        axis = min(range(3), key=lambda a: abs(normal[a]))
        wish = [mpf(a == axis) for a in range(3)]
    along = sum(a * b for a, b in zip(n, wish))
    t = unit([b - along * a for a, b in zip(n, wish)])
    if len(n) == 2:
        return [n, t]
    cross = [n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]]
    return [n, t, cross]


def stiffness_of_quadrilateral(corners, e, nu, thickness):
    e, nu, thickness = mpf(e), mpf(nu), mpf(thickness)
    elastic = e / (1 - nu * nu) * matrix([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    total = matrix(8, 8)
    for a, b in signs:
        xi, eta = a / sqrt(mpf(3)), b / sqrt(mpf(3))
        slopes = matrix([[s * (1 + t * eta) / 4 for s, t in signs],
                         [t * (1 + s * xi) / 4 for s, t in signs]])
        jacobian = slopes * matrix(corners)
        gradients = inverse(jacobian) * slopes
        strain = matrix(3, 8)
        for corner in range(4):
            strain[0, 2 * corner] = strain[2, 2 * corner + 1] = gradients[0, corner]
            strain[1, 2 * corner + 1] = strain[2, 2 * corner] = gradients[1, corner]
        area = abs(jacobian[0, 0] * jacobian[1, 1] - jacobian[0, 1] * jacobian[1, 0])
        total += thickness * area * strain.T * elastic * strain
    return total


def compliance(case):
    d, places = case["dimension"], case["coordinates"]
    number = {}
    for node in range(case["free"]):
        for axis in range(d):
            number[node, axis] = len(number)
    whole = matrix(len(number), len(number))
    for a, b, ea in case["members"]:
        along = [mpf(y) - mpf(x) for x, y in zip(places[a], places[b])]
        length = sqrt(sum(x * x for x in along))
        strain = matrix(len(number), 1)
        for axis in range(d):
            for node, sign in ((a, -1), (b, 1)):
                if (node, axis) in number:
                    strain[number[node, axis]] = sign * along[axis] / length
        whole += mpf(ea) / length * strain * strain.T
    for element in case["elements"]:
        nodes = element["nodes"]
        part = stiffness_of_quadrilateral([[mpf(x) for x in places[n]] for n in nodes],
                                          element["E"], element["nu"], element["thickness"])
        keys = [(n, axis) for n in nodes for axis in range(2)]
        for i, row in enumerate(keys):
            for j, column in enumerate(keys):
                if row in number and column in number:
                    whole[number[row], number[column]] += part[i, j]
    loads = matrix(len(number), d * len(case["contact"]))
    for i, (node, normal, tangent) in enumerate(case["contact"]):
        for j, direction in enumerate(frame(normal, tangent)):
            for axis in range(d):
                loads[number[node, axis], d * i + j] = direction[axis]
    return loads.T * inverse(whole) * loads


def truss(d, contrast, candidates, free, rng):
    nodes = free + d + 1
    place = lambda: [rng.uniform(-2, 2) for _ in range(d)]

    def direction():
        v = [rng.uniform(-1, 1) for _ in range(d)]
        size = sum(x * x for x in v) ** 0.5
        return [x / size for x in v]

    return {
        "dimension": d, "free": free, "coordinates": [place() for _ in range(nodes)],
        "members": [[a, b, contrast ** rng.random()] for a in range(free)
                    for b in range(a + 1, nodes)],
        "elements": [],
        "contact": [[i, direction(), direction() if d == 3 and i == 0 else None]
                    for i in range(candidates)]}


def body(rng):
    """Three elements in a row, the last two corners held, and a bar."""
    places = [[x + rng.uniform(-0.2, 0.2), y + rng.uniform(-0.2, 0.2)]
              for x in range(4) for y in range(2)]
    elements = [{"nodes": [2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1], "E": 10.0 ** rng.uniform(-3, 3),
                 "nu": rng.uniform(-0.5, 0.49), "thickness": rng.uniform(0.1, 1)} for c in range(3)]
    return {"dimension": 2, "free": 6, "coordinates": places, "members": [[0, 5, 7.0]],
            "elements": elements, "contact": [[0, [0.6, 0.8], None], [1, [-0.28, 0.96], None]]}


def main():
    rng = random.Random(1)
    cases = [truss(d, contrast, candidates, free, rng)
             for d, candidates, free in ((2, 1, 2), (2, 3, 5), (3, 2, 4))
             for contrast in (1.0, 1e6, 1e9)]
    cases += [body(rng) for _ in range(3)]
    for case in cases:
        f = compliance(case)
        case["compliance"] = [[mp.nstr(f[i, j], 45) for j in range(f.cols)] for i in range(f.rows)]
    path = pathlib.Path(__file__).with_suffix(".json")
    path.write_text(json.dumps(cases, indent=0) + "\n")


if __name__ == "__main__":
    main()
