#!/usr/bin/env python3
"""All rays and maximal cones of the wedged paper's plane trusses (section 7.2) in exact arithmetic.

    exact_cliques.py ROWS [KUSABI]

Nothing is rounded: coordinates, frames and K = sum e e^T = sum d d^T / |d|^2 (all bars have the same
EA/L) are in Q(sqrt 3), and mu = 0.65 is 13/20. Algorithm 4.2, as corrected in docs/theory/rays.md,
computes with displacements a + b sqrt 3, a and b integers, so the sign of u_n is a comparison of
integers. The maximal cones are the maximal cliques of the graph of cross-complementary rays, by the
Bron-Kerbosch algorithm. Requires Python only.

With the path of the command `kusabi` its answer for the same truss is compared: the states of all
rays, and the cones. Differences are printed, with exit code 1.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

MU = (13, 20)


class Root3:
    """Numbers a + b sqrt 3, as pairs of integers."""

    @staticmethod
    def times(x, y):
        return (x[0] * y[0] + 3 * x[1] * y[1], x[0] * y[1] + x[1] * y[0])

    @staticmethod
    def sign(x):
        a, b = x
        if a >= 0 and b >= 0:
            return int(a > 0 or b > 0)
        if a <= 0 and b <= 0:
            return -1
        return (1 if a > 0 else -1) if a * a > 3 * b * b else (1 if b > 0 else -1)

    @staticmethod
    def inverse(x):
        """1/x times a positive integer."""
        norm = x[0] * x[0] - 3 * x[1] * x[1]
        return (x[0], -x[1]) if norm > 0 else (-x[0], x[1])


def scaled(vector, by):
    """A vector times a number, made primitive: without a common divisor."""
    product = [Root3.times(x, by) for x in vector]
    divisor = math.gcd(*(part for x in product for part in x)) or 1
    return [(a // divisor, b // divisor) for a, b in product]


def normalised(vector):
    """The positive multiple whose first nonzero number is a rational integer, in lowest terms."""
    first = next(x for x in vector if x != (0, 0))
    by = Root3.inverse(first)
    if Root3.sign(first) < 0:
        by = (-by[0], -by[1])
    return scaled(vector, by)


def combination(x, first, y, second):
    """x first + y second for numbers x, y and vectors."""
    result = []
    for f, s in zip(first, second):
        a, b = Root3.times(x, f), Root3.times(y, s)
        result.append((a[0] + b[0], a[1] + b[1]))
    return result


def truss_rows(rows):
    """K in frames (n, t) of the candidates, 2N rows, each times an integer of its own."""
    # Lengths times 6 and frames times 2, so that all are integers: x = 5 + i / sqrt 3.
    normal, tangent = ((0, -1), (-1, 0)), ((-1, 0), (0, 1))  # 2 n, 2 t = 2 (n_y, -n_x)
    place = [((30, 2 * i), (6 * i, 0)) for i in range(rows)]
    wall = [((0, 0), (6 * i, 0)) for i in range(rows)]
    bars = [(place[i], wall[j], i, None)
            for i in range(rows) for j in (i - 1, i, i + 1) if 0 <= j < rows]
    bars += [(place[i], place[i + 1], i, i + 1) for i in range(rows - 1)]
    stiffness = {}
    scale = 1
    terms = []
    for one, other, i, j in bars:
        d = [(a[0] - b[0], a[1] - b[1]) for a, b in zip(one, other)]
        inner = [tuple(map(sum, zip(*(Root3.times(x, y) for x, y in zip(axis, d)))))
                 for axis in (normal, tangent)]  # of d, times 2
        square = tuple(map(sum, zip(*(Root3.times(x, x) for x in d))))
        norm = square[0] ** 2 - 3 * square[1] ** 2
        scale = scale * norm // math.gcd(scale, norm)
        terms.append((inner, (square[0], -square[1]), norm, i, j))
    assert all(norm > 0 for _, _, norm, _, _ in terms)
    for inner, conjugate, norm, i, j in terms:
        for a in range(2):
            for b in range(2):
                entry = Root3.times(Root3.times(inner[a], inner[b]), conjugate)
                entry = tuple(part * (scale // norm) for part in entry)
                for row, column, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
                    if row is None or column is None:
                        continue
                    key = (2 * row + a, 2 * column + b)
                    old = stiffness.get(key, (0, 0))
                    stiffness[key] = (old[0] + sign * entry[0], old[1] + sign * entry[1])
    k = [[stiffness.get((i, j), (0, 0)) for j in range(2 * rows)] for i in range(2 * rows)]
    return [scaled([x for row in k for x in row], (1, 0))[2 * rows * i:2 * rows * (i + 1)]
            for i in range(2 * rows)]


def friction_rows(k):
    """p = mu r_n - r_t and q = mu r_n + r_t of all candidates, as rows on u."""
    both = []
    for sign in (-1, 1):
        both.append([combination((MU[0], 0), k[2 * i], (sign * MU[1], 0), k[2 * i + 1])
                     for i in range(len(k) // 2)])
    return both


def null_vector(rows):
    """Null vector of 2N - 1 independent rows of 2N numbers, up to a factor."""
    rows = [list(row) for row in rows]
    unknowns = len(rows[0])
    pivots = []
    for column in range(unknowns):
        free = [row for row in rows if row[column] != (0, 0)]
        if not free:
            last = column
            continue
        pivot = scaled(free[0], Root3.inverse(free[0][column]))
        rows = [row for row in rows if row is not free[0]]
        for row in free[1:]:
            minus = (-row[column][0], -row[column][1])
            row[:] = scaled(combination(pivot[column], row, minus, pivot), (1, 0))
        pivots.append((column, pivot))
    assert len(pivots) == unknowns - 1
    x = [(0, 0)] * unknowns
    x[last] = (1, 0)
    for column, pivot in reversed(pivots):
        rest = (0, 0)
        for other in range(column + 1, unknowns):
            a, b = Root3.times(pivot[other], x[other])
            rest = (rest[0] - a, rest[1] - b)
        factor = pivot[column]  # an integer
        x = [(a * factor[0], b * factor[0]) for a, b in x]
        x[column] = rest
        x = scaled(x, (1, 0))
    return x


def dot(row, u):
    a = b = 0
    for x, y in zip(row, u):
        if x != (0, 0):
            c, d = Root3.times(x, y)
            a += c
            b += d
    return (a, b)


class Enumeration:
    """Zero sets are integers: bits 3 i, 3 i + 1 and 3 i + 2 are p, q and u_n of candidate i."""

    def __init__(self, rows):
        self.rows = rows
        self.p, self.q = friction_rows(truss_rows(rows))
        everything = [row for pair in zip(self.p, self.q) for row in pair]
        all_reactions = sum(3 << (3 * i) for i in range(rows))
        self.rays = []
        for own, row in enumerate(everything):
            u = null_vector(everything[:own] + everything[own + 1:])
            if Root3.sign(dot(row, u)) < 0:
                u = [(-a, -b) for a, b in u]
            bit = 1 << (3 * (own // 2) + own % 2)
            self.rays.append((all_reactions & ~bit, normalised(u)))
        self.processed = []

    def gap(self, ray, i):
        return Root3.sign(ray[1][2 * i])

    def complementary(self, zeros):
        """At each candidate processed no gap, or no reaction."""
        return all(zeros >> (3 * i) & 4 or zeros >> (3 * i) & 3 == 3 for i in self.processed)

    def run(self):
        left = set(range(self.rows))
        while left:
            signs = {i: [self.gap(ray, i) for ray in self.rays] for i in left}
            i = min(left, key=lambda i: (signs[i].count(1) * signs[i].count(-1), i))
            left.remove(i)
            self.step(i, signs[i])
            self.processed.append(i)

    def step(self, i, signs):
        plus = [ray for ray, sign in zip(self.rays, signs) if sign > 0]
        minus = [ray for ray, sign in zip(self.rays, signs) if sign < 0]
        kept = [(z | 4 << (3 * i), u) for (z, u), sign in zip(self.rays, signs) if sign == 0]
        kept += [ray for ray in plus if ray[0] >> (3 * i) & 3 == 3]
        zero_sets = [ray[0] for ray in self.rays]
        larger_sets = []
        enough = 2 * self.rows - 2
        for a, u in plus:
            for b, v in minus:
                common = a & b
                if common.bit_count() < enough or not self.complementary(common):
                    continue
                if self.third(common, a, b, larger_sets, zero_sets):
                    continue
                x, y = v[2 * i], u[2 * i]  # x < 0 < y
                between = combination((-x[0], -x[1]), u, y, v)
                assert between[2 * i] == (0, 0)
                kept.append((common | 4 << (3 * i), normalised(between)))
        self.rays = kept

    @staticmethod
    def third(common, a, b, larger_sets, zero_sets):
        """True if another ray is on the smallest face that contains both."""
        for place, z in enumerate(larger_sets):
            if z & common == common and z not in (a, b):
                larger_sets.insert(0, larger_sets.pop(place))
                return True
        for z in zero_sets:
            if z & common == common and z not in (a, b):
                larger_sets.insert(0, z)
                del larger_sets[16:]
                return True
        return False

    def check(self):
        """Asserts that the numbers match the zero sets: zero where these contain the inequality, otherwise positive."""
        for zeros, u in self.rays:
            for i in range(self.rows):
                for bit, value in enumerate((dot(self.p[i], u), dot(self.q[i], u), u[2 * i])):
                    assert Root3.sign(value) == (0 if zeros >> (3 * i + bit) & 1 else 1)

    def state(self, zeros):
        names = {4: "sticks", 5: "slides +", 6: "slides -", 3: "separates", 7: "idle"}
        return tuple(names[zeros >> (3 * i) & 7] for i in range(self.rows))


def supports(state):
    """Candidates with a reaction and candidates with a gap of a ray."""
    reaction = frozenset(i for i, s in enumerate(state) if s[:2] in ("st", "sl"))
    return reaction, frozenset(i for i, s in enumerate(state) if s == "separates")


def maximal_cliques(vertices):
    """Maximal cliques by Bron and Kerbosch with pivots. Rays with the same supports are one vertex."""
    neighbours = [sum(1 << k for k, (r, g) in enumerate(vertices)
                      if k != j and not r & gap and not g & reaction)
                  for j, (reaction, gap) in enumerate(vertices)]
    found = []

    def members(bits):
        while bits:
            low = bits & -bits
            yield low.bit_length() - 1
            bits ^= low

    def extend(clique, candidates, excluded):
        if not candidates and not excluded:
            found.append(clique)
            return
        pivot = max(members(candidates | excluded),
                    key=lambda v: (neighbours[v] & candidates).bit_count())
        for v in members(candidates & ~neighbours[pivot]):
            extend(clique | 1 << v, candidates & neighbours[v], excluded & neighbours[v])
            candidates &= ~(1 << v)
            excluded |= 1 << v

    sys.setrecursionlimit(100000)
    extend(0, (1 << len(vertices)) - 1, 0)
    return [[vertices[v] for v in members(clique)] for clique in found]


def answer_of(kusabi, rows):
    """The result of `kusabi rays` for the truss with that many rows."""
    with tempfile.TemporaryDirectory() as folder:
        truss, result = (pathlib.Path(folder) / name for name in ("truss.toml", "rays.json"))
        for call in (["example", "plane-truss", "--paper", "--rows", str(rows), "--output", truss],
                     ["rays", truss, "--mu", str(MU[0] / MU[1]), "--quiet", "--output", result]):
            subprocess.run([kusabi, *call], check=True)
        return json.loads(result.read_text(encoding="utf-8"))["result"]


def main():
    rows = int(sys.argv[1])
    exact = Enumeration(rows)
    exact.run()
    exact.check()
    states = {exact.state(zeros) for zeros, _ in exact.rays}
    assert len(states) == len(exact.rays)
    cliques = maximal_cliques(sorted({supports(s) for s in states}, key=repr))
    cones = {(frozenset().union(*(r for r, _ in c)), frozenset().union(*(g for _, g in c)))
             for c in cliques}
    print(f"N = {rows}: {len(states)} rays, {len(cliques)} maximal cones, exactly")
    if len(sys.argv) < 3:
        return 0
    result = answer_of(sys.argv[2], rows)
    theirs = {tuple(ray["state"]) for ray in result["rays"]}
    places = {f"r{i + 1}c1": i for i in range(rows)}
    their_cones = {(frozenset(places[n] for n in c["contact"] if n not in c["idle"]),
                    frozenset(places[n] for n in c["separated"])) for c in result["cones"]}
    same = theirs == states and their_cones == cones and len(cliques) == len(result["cones"])
    print("kusabi has the same rays in the same states, and the same cones" if same else
          f"kusabi has {len(theirs - states)} rays more and {len(states - theirs)} less, "
          f"{len(their_cones - cones)} cones more and {len(cones - their_cones)} less")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
