#!/usr/bin/env python3
"""Stiffness of single distorted elements in the plane with 40 digits: mpmath_elements.json beside this file.

K = sum w |det J| t B'DB with the usual shape functions; their gradients are central differences, which are exact
for functions that are quadratic along each axis. All doubles are taken as exact.
"""
import json
import pathlib
import random

from mpmath import inverse, matrix, mp, mpf, sqrt

mp.dps = 40

TRIANGLE = [lambda x, y: 1 - x - y, lambda x, y: x, lambda x, y: y]
SQUARE = [lambda x, y, s=s, t=t: (1 + s * x) * (1 + t * y) / 4
          for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def six_nodes():
    corners = [lambda x, y, l=l: l(x, y) * (2 * l(x, y) - 1) for l in TRIANGLE]
    return corners + [lambda x, y, a=TRIANGLE[i], b=TRIANGLE[(i + 1) % 3]: 4 * a(x, y) * b(x, y)
                      for i in range(3)]


def eight_nodes():
    """The corners' functions less half of those of the two middles beside them."""
    middles = [lambda x, y: (1 - x * x) * (1 - y) / 2, lambda x, y: (1 + x) * (1 - y * y) / 2,
               lambda x, y: (1 - x * x) * (1 + y) / 2, lambda x, y: (1 - x) * (1 - y * y) / 2]
    return [lambda x, y, n=SQUARE[i], a=middles[i], b=middles[i - 1]:
            n(x, y) - (a(x, y) + b(x, y)) / 2 for i in range(4)] + middles


def grid(places, weights):
    return [(x, y, a * b) for x, a in zip(places, weights) for y, b in zip(places, weights)]


THIRD, SIXTH = mpf(1) / 3, mpf(1) / 6
TWO = grid([-1 / sqrt(mpf(3)), 1 / sqrt(mpf(3))], [1, 1])
THREE = grid([-sqrt(mpf(3) / 5), 0, sqrt(mpf(3) / 5)], [mpf(5) / 9, mpf(8) / 9, mpf(5) / 9])
SHAPES = {3: (TRIANGLE, [(THIRD, THIRD, mpf(1) / 2)]),
          6: (six_nodes(), [(SIXTH, SIXTH, SIXTH), (4 * SIXTH, SIXTH, SIXTH),
                            (SIXTH, 4 * SIXTH, SIXTH)]),
          4: (SQUARE, TWO), 8: (eight_nodes(), THREE)}
CORNERS = {3: [(0, 0), (1, 0), (0, 1)], 4: [(0, 0), (1, 0), (1, 1), (0, 1)]}


def elastic(modulus, ratio, strain):
    e, nu = mpf(modulus), mpf(ratio)
    if strain:
        return e / ((1 + nu) * (1 - 2 * nu)) * matrix(
            [[1 - nu, nu, 0], [nu, 1 - nu, 0], [0, 0, (1 - 2 * nu) / 2]])
    return e / (1 - nu * nu) * matrix([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])


def stiffness(case):
    places = matrix(case["nodes"])
    functions, rule = SHAPES[places.rows]
    law = elastic(case["modulus"], case["ratio"], case["strain"])
    total = matrix(2 * places.rows, 2 * places.rows)
    h = mpf(1) / 2
    for x, y, weight in rule:
        slopes = matrix([[(f(x + h, y) - f(x - h, y)) / (2 * h) for f in functions],
                         [(f(x, y + h) - f(x, y - h)) / (2 * h) for f in functions]])
        jacobian = slopes * places
        gradients = inverse(jacobian) * slopes
        strain = matrix(3, 2 * places.rows)
        for node in range(places.rows):
            strain[0, 2 * node] = strain[2, 2 * node + 1] = gradients[0, node]
            strain[1, 2 * node + 1] = strain[2, 2 * node] = gradients[1, node]
        area = abs(jacobian[0, 0] * jacobian[1, 1] - jacobian[0, 1] * jacobian[1, 0])
        total += weight * area * mpf(case["thickness"]) * strain.T * law * strain
    return total


def places(count, rng):
    corners = CORNERS[3 if count in (3, 6) else 4]
    moved = [[x + rng.uniform(-0.15, 0.15) for x in corner] for corner in corners]
    if count == len(corners):
        return moved
    return moved + [[(x + y) / 2 + rng.uniform(-0.05, 0.05) for x, y in zip(a, b)]
                    for a, b in zip(moved, moved[1:] + moved[:1])]


def main():
    rng = random.Random(1)
    cases = []
    for count in SHAPES:
        for strain in (False, True):
            case = {"nodes": places(count, rng), "modulus": 200.0, "ratio": 0.3, "thickness": 0.5,
                    "strain": strain}
            k = stiffness(case)
            case["stiffness"] = [[mp.nstr(k[i, j], 32) for j in range(k.cols)] for i in range(k.rows)]
            cases.append(case)
    path = pathlib.Path(__file__).with_suffix(".json")
    path.write_text(json.dumps(cases, indent=0).replace(",\n", ", ") + "\n")


if __name__ == "__main__":
    main()
