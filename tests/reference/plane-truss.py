#!/usr/bin/python3
"""Recomputes the numbers of plane-truss.json and compares them: prints differences, exit code 1 if there are any.

    python3 plane-truss.py [LARGEST]      trusses of 5 to LARGEST rows, 7 by default; 9 takes some minutes

Independent of the project: mpmath for F, HiGHS of scipy for the margin t* of each of the 2^m - 1 leaves, and
brute force for the rays. A complementary ray with reactions at exactly the candidates U is extremal in
{x >= 0 on U, u_n = 0 on U, u_n >= 0 elsewhere}, x = (mu r_n - r_t, mu r_n + r_t): |U| - 1 of the inequalities
are equalities there, and all such choices are enumerated. A maximal cone is the set of all rays of a leaf, if
no other leaf has a larger one.
"""
import itertools
import json
import math
import pathlib
import sys

import mpmath
import numpy as np
from scipy.optimize import linprog

HERE = pathlib.Path(__file__).parent
ZERO = 1e-9  # relative to what cancels: rounding is below 1e-12, what is not zero above 1e-7 up to nine rows


def truss(rows):
    nodes = [[(5 + y * math.tan(math.pi / 6)) * j / 2, float(y)] for y in range(rows) for j in range(3)]
    members = [(3 * i + j, 3 * i + j + 1) for i in range(rows) for j in range(2)]
    members += [(3 * i + 1, 3 * i + 4) for i in range(rows - 1)]
    members += [pair for i in range(rows - 1) for j in range(2)
                for pair in ((3 * i + j, 3 * i + j + 4), (3 * i + j + 1, 3 * i + j + 3))]
    return nodes, members


def compliance(rows):
    """F of the candidates (the right column), n and t of each, as doubles of 40 digits."""
    mpmath.mp.dps = 40
    half, root = mpmath.mpf(1) / 2, mpmath.sqrt(3) / 2
    lean = 1 / mpmath.sqrt(3)  # tan 30 degrees
    nodes = [((5 + y * lean) * j / 2, mpmath.mpf(y)) for y in range(rows) for j in range(3)]
    free = {}
    for node in range(3 * rows):
        if node % 3 != 0:
            free[node] = 2 * len(free)
    stiffness = mpmath.zeros(2 * len(free))
    for p, q in truss(rows)[1]:
        way = [b - a for a, b in zip(nodes[p], nodes[q])]
        length = mpmath.sqrt(sum(x * x for x in way))
        entries = [(free[node] + axis, sign * way[axis] / length)
                   for node, sign in ((p, -1), (q, 1)) if node in free for axis in range(2)]
        for a, x in entries:
            for b, y in entries:
                stiffness[a, b] += x * y / length
    whole = mpmath.inverse(stiffness)
    frame = [(-root, half), (half, root)]
    places = [free[3 * i + 2] for i in range(rows)]
    result = np.zeros((2 * rows, 2 * rows))
    for (i, p), (k, q) in itertools.product(enumerate(places), repeat=2):
        for a, b in itertools.product(range(2), repeat=2):
            result[2 * i + a, 2 * k + b] = float(sum(frame[a][x] * whole[p + x, q + y] * frame[b][y]
                                                     for x in range(2) for y in range(2)))
    return result / np.mean(np.diag(result)[::2])


def margin(f, mu, contact):
    """t* of the leaf with these candidates in contact."""
    m = len(f) // 2
    held = [2 * i + a for i in contact for a in range(2)]
    normal = f[::2, held]
    others = [j for j in range(m) if j not in contact]
    rows = [np.r_[-normal[j], 1] for j in others]
    for c in range(len(contact)):
        for sign in (-1, 1):
            row = np.zeros(len(held) + 1)
            row[2 * c], row[2 * c + 1], row[-1] = -mu, sign, 1
            rows.append(row)
    sums = np.zeros(len(held) + 1)
    sums[:-1:2] = 1
    equal = np.vstack([np.c_[normal[contact], np.zeros(len(contact))], sums])
    found = linprog(np.r_[np.zeros(len(held)), -1], A_ub=np.array(rows), b_ub=np.zeros(len(rows)), A_eq=equal,
                    b_eq=np.r_[np.zeros(len(contact)), 1], bounds=[(None, None)] * (len(held) + 1), method="highs")
    return -found.fun if found.status == 0 else -math.inf


def rays_of(f, mu, contact):
    """Extremal rays with a reaction at each of these candidates and nowhere else: (r, candidates with a gap)."""
    m, k = len(f) // 2, len(contact)
    by_p_q = np.zeros((m, 2 * k))
    for c, i in enumerate(contact):
        by_p_q[:, 2 * c] = f[::2, 2 * i] / (2 * mu) - f[::2, 2 * i + 1] / 2
        by_p_q[:, 2 * c + 1] = f[::2, 2 * i] / (2 * mu) + f[::2, 2 * i + 1] / 2
    others = [j for j in range(m) if j not in contact]
    held = by_p_q[contact]
    rows = np.vstack([np.eye(2 * k), by_p_q[others]])
    size = np.abs(by_p_q)
    found = {}
    # p and q of a candidate do not both vanish: it has a reaction.
    for slides in itertools.product((None, 0, 1), repeat=k):
        zeros = [2 * c + which for c, which in enumerate(slides) if which is not None]
        if len(zeros) > k - 1 or k - 1 - len(zeros) > len(others):
            continue
        kept = [x for x in range(2 * k) if x not in zeros]
        for more in itertools.combinations(range(len(others)), k - 1 - len(zeros)):
            equal = np.vstack([held, by_p_q[[others[j] for j in more]]])[:, kept]
            scale = np.linalg.norm(equal, axis=1, keepdims=True)
            values, turned = np.linalg.svd(equal / scale)[1:]
            if len(values) >= len(kept) and values[len(kept) - 1] > 1e-11:
                continue
            if len(kept) > 1 and values[len(kept) - 2] < 1e-11:
                continue
            x = np.zeros(2 * k)
            x[kept] = turned[-1] * np.sign(turned[-1].sum())
            if (x[kept] <= ZERO * np.abs(x).max()).any():
                continue
            gaps = (by_p_q @ x) / (size @ np.abs(x))
            if (gaps[others] < -ZERO).any():
                continue
            r = np.zeros(2 * m)
            for c, i in enumerate(contact):
                r[2 * i] = (x[2 * c] + x[2 * c + 1]) / (2 * mu)
                r[2 * i + 1] = (x[2 * c + 1] - x[2 * c]) / 2
            gap = frozenset(j for j in others if gaps[j] > ZERO)
            found[frozenset(zeros), gap] = (r / r[::2].sum(), gap)
    return list(found.values())


def table_entry(f, mu):
    m = len(f) // 2
    leaves = [list(contact) for size in range(1, m + 1) for contact in itertools.combinations(range(m), size)]
    margins = [margin(f, mu, leaf) for leaf in leaves]
    rays = []
    for leaf, t in zip(leaves, margins):
        if t > -ZERO:
            rays += [(r, set(leaf), gap) for r, gap in rays_of(f, mu, leaf)]
    fitting = {frozenset(number for number, (_, reaction, gap) in enumerate(rays)
                         if reaction <= set(leaf) and not gap & set(leaf)) for leaf in leaves}
    cones = [one for one in fitting if one and not any(one < other for other in fitting)]
    alive = [leaf for leaf, t in zip(leaves, margins) if t > ZERO]
    return rays, cones, alive


def critical(f, contact, dead, alive):
    while alive - dead > 2e-11:
        middle = (dead + alive) / 2
        if margin(f, middle, contact) > 0:
            alive = middle
        else:
            dead = middle
    return alive


def main():
    largest = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    known_file = json.loads((HERE / "plane-truss.json").read_text())
    count = faults = 0

    def compare(what, found, expected):
        nonlocal count, faults
        count += 1
        if found != expected:
            faults += 1
            print(f"{what}: {found}, in the file {expected}")

    for rows in range(5, largest + 1):
        f = compliance(rows)
        for mu, expected in known_file["table"][str(rows)].items():
            rays, cones, alive = table_entry(f, float(mu))
            found = {"rays": len(rays), "cones": len(cones), "patterns": len(alive)}
            compare(f"{rows} rows, mu = {mu}", {key: found[key] for key in expected if expected[key] is not None},
                    {key: value for key, value in expected.items() if value is not None})

    five, f = known_file["five"], compliance(5)
    nodes, members = truss(5)
    compare("nodes", np.round(nodes, 9).tolist(), np.round(five["nodes"], 9).tolist())
    compare("members", sorted(map(sorted, members)), sorted(map(sorted, five["members"])))
    found = sorted(np.round(ray, 8).tolist() for ray, *_ in table_entry(f, 0.65)[0])
    given = sorted(np.round(five["rays_at_0_65"], 8).tolist())
    compare("rays at 0.65", len(found), len(given))
    compare("numbers of the rays at 0.65", all(np.allclose(a, b, atol=2e-9) for a, b in zip(found, given)), True)
    alive = table_entry(f, 1.0)[2]
    compare("patterns at 1", sorted(alive), sorted(contact for _, contact in five["critical_at_1"]))
    for value, contact in five["critical_at_1"]:
        compare(f"critical friction of {contact}", abs(critical(f, contact, 0.1, 1.0) - value) < 1e-8, True)
    print(f"{count} comparisons with plane-truss.json, {faults} differ")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
