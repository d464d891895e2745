#!/usr/bin/python3
"""Recomputes the numbers of space-truss.json and compares them: prints differences, exit code 1 if there are any.

    python3 space-truss.py      half a minute

Independent of the project: numpy for F of the nodes and members in the file, and for each of the 1023 leaves the
margin t* by linear programs (HiGHS of scipy). Half-spaces replace the friction cones; one is added where the
optimum violates a cone. The sign is decided by the optimum, an upper bound, or by its margin with the true cones,
a lower bound.
"""
import itertools
import json
import math
import pathlib
import sys

import numpy as np
from scipy.optimize import linprog

HERE = pathlib.Path(__file__).parent
ZERO = 1e-9  # a margin nearer to zero is reported
DIGITS = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
BESIDE = 1e-5
FIRST = [(math.cos(a), math.sin(a)) for a in 2 * math.pi * np.arange(16) / 16]


def compliance(data):
    nodes = np.array(data["nodes"])
    free = {node: 3 * place for place, node in enumerate(n for n in range(len(nodes)) if n not in data["supported"])}
    stiffness = np.zeros((3 * len(free), 3 * len(free)))
    for p, q in data["members"]:
        way = nodes[q] - nodes[p]
        length = np.linalg.norm(way)
        vector = np.zeros(3 * len(free))
        for node, sign in ((p, -1), (q, 1)):
            if node in free:
                vector[free[node]:free[node] + 3] = sign * way / length
        stiffness += np.outer(vector, vector) / length
    frame = np.array([data["frame"][axis] for axis in ("n", "t1", "t2")])
    loads = np.zeros((3 * len(free), 3 * len(data["contact"])))
    for i, node in enumerate(data["contact"]):
        loads[free[node]:free[node] + 3, 3 * i:3 * i + 3] = frame.T
    f = loads.T @ np.linalg.solve(stiffness, loads)
    return f / np.mean(np.diag(f)[::3])


class Leaf:
    """t* of a leaf, from above and from below, for any friction; half-spaces are kept from one to the next."""

    def __init__(self, f, contact):
        self.contact = list(contact)
        self.held = [3 * i + a for i in self.contact for a in range(3)]
        self.normal = f[::3, self.held]
        self.others = [j for j in range(len(f) // 3) if j not in self.contact]
        self.sides = [list(FIRST) for _ in self.contact]

    def bracket(self, mu, enough):
        """(below, above) with below <= t* <= above, up to the tolerance of HiGHS, when enough(below, above)."""
        size = len(self.held)
        sums = np.zeros(size + 1)
        sums[:-1:3] = 1
        equal = np.vstack([np.c_[self.normal[self.contact], np.zeros(len(self.contact))], sums])
        gaps = np.c_[-self.normal[self.others], np.ones(len(self.others))]
        best = -math.inf
        for _ in range(60):
            rows = [gaps]
            for c, sides in enumerate(self.sides):
                block = np.zeros((len(sides), size + 1))
                block[:, 3 * c], block[:, 3 * c + 1:3 * c + 3], block[:, -1] = -mu, sides, 1
                rows.append(block)
            rows = np.vstack(rows)
            found = linprog(np.r_[np.zeros(size), -1], A_ub=rows, b_ub=np.zeros(len(rows)), A_eq=equal,
                            b_eq=np.r_[np.zeros(len(self.contact)), 1], bounds=[(None, None)] * (size + 1),
                            method="highs", options=DIGITS)
            if found.status == 2:
                return -math.inf, -math.inf
            r, above = found.x[:-1], -found.fun
            slides = np.hypot(r[1::3], r[2::3])
            best = max(best, min([*(mu * r[::3] - slides), *(self.normal[self.others] @ r)]))
            if enough(best, above):
                break
            for c, sides in enumerate(self.sides):
                if slides[c] + above > mu * r[3 * c] + 1e-11 and slides[c] > 0:
                    sides.append((r[3 * c + 1] / slides[c], r[3 * c + 2] / slides[c]))
        return best, above

    def sign(self, mu):
        """1: feasible, -1: infeasible, 0: undecided."""
        below, above = self.bracket(mu, lambda below, above: below > ZERO or above < -ZERO)
        return 1 if below > ZERO else -1 if above < -ZERO else 0

    def margin(self, mu):
        return sum(self.bracket(mu, lambda below, above: above - below < 1e-10)) / 2


def critical(leaf, near):
    """Zero of t* within BESIDE of `near`, alternately by secants and bisection, since t* may have a kink."""
    dead, alive = near - BESIDE, near + BESIDE
    low, high = leaf.margin(dead), leaf.margin(alive)
    if not low < 0 < high:
        return math.nan
    for turn in range(10):
        middle = (dead + alive) / 2 if turn % 2 else dead + (alive - dead) * -low / (high - low)
        level = leaf.margin(middle)
        if level > 0:
            alive, high = middle, level
        else:
            dead, low = middle, level
    return dead + (alive - dead) * -low / (high - low)


def main():
    known_file = json.loads((HERE / "space-truss.json").read_text())
    f = compliance(known_file)
    m = len(known_file["contact"])
    count = faults = 0

    def compare(what, right):
        nonlocal count, faults
        count += 1
        if not right:
            faults += 1
            print(f"{what}: differs from the file")

    leaves = [Leaf(f, contact) for size in range(1, m + 1) for contact in itertools.combinations(range(m), size)]
    # The largest coefficient first: a leaf that is infeasible there is infeasible at smaller ones.
    for mu, number in sorted(known_file["counts"].items(), key=lambda each: -float(each[0])):
        signs = [leaf.sign(float(mu)) for leaf in leaves]
        compare(f"mu = {mu}: leaves within the tolerance", 0 not in signs)
        leaves = [leaf for leaf, sign in zip(leaves, signs) if sign > 0]
        alive = sorted(leaf.contact for leaf in leaves)
        compare(f"mu = {mu}: {len(alive)} patterns", len(alive) == number)
        if mu in known_file["patterns"]:
            compare(f"mu = {mu}: the patterns", alive == sorted(known_file["patterns"][mu]))
    largest = max(known_file["counts"], key=float)
    known = sorted(contact for _, contact in known_file["critical"])
    compare(f"the patterns at {largest} have a critical friction", known == sorted(known_file["patterns"][largest]))
    for value, contact in known_file["critical"]:
        leaf = Leaf(f, contact)
        compare(f"critical friction of {contact}", abs(critical(leaf, value) - value) < 2e-6)
    print(f"{count} comparisons with space-truss.json, {faults} differ")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
