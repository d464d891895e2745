#!/usr/bin/python3
"""Recomputes the numbers of limit.json and compares them: prints differences, exit code 1 if there are any.

    python3 limit.py [LARGEST]      the family up to LARGEST x LARGEST bays, 7 by default; 10 takes some minutes

Independent of the project: numpy, and HiGHS of scipy. The trusses are built from their definition. The nominal
factor is the optimum of (5) of METR 2006-39. The worst case is between two bounds that must meet:

  upper bound: (5) for the load at a vertex zeta, by the iteration zeta = alpha sign(T'u), u the collapse mode;
  lower bound: the relaxation of (36) in which gamma_j stands for w_j |u_e(j)|, with cuts
               gamma_j <= w_j (|y|'z + |k|), B y - k f_R = e_e(j), added until its optimum violates none.
"""
import json
import pathlib
import sys

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import csr_matrix, eye, hstack, lil_matrix, vstack

HERE = pathlib.Path(__file__).parent
NEAR = 2e-8  # relative to the nominal factor: what two linear programs leave


class Truss:
    """B, yield forces, loads and the uncertain displacements, all in kN and m."""

    def __init__(self, nodes, members, supported, reference, dead, strength):
        free = {}
        for node in range(len(nodes)):
            if node not in supported:
                free[node, "x"], free[node, "y"] = len(free), len(free) + 1
        b = lil_matrix((len(free), len(members)))
        for i, (p, q) in enumerate(members):
            way = np.subtract(nodes[q], nodes[p])
            way = way / np.linalg.norm(way)
            for node, sign in ((p, -1), (q, 1)):
                for axis, cosine in zip("xy", way):
                    if (node, axis) in free and cosine != 0:
                        b[free[node, axis], i] = sign * cosine
        self.b = csr_matrix(b)
        self.reference, self.dead = np.zeros(len(free)), np.zeros(len(free))
        for load, target in ((reference, self.reference), (dead, self.dead)):
            for node, axis, value in load:
                target[free[node, axis]] += value
        self.strength = strength
        self.uncertain = [e for e in range(len(free)) if self.reference[e] == 0 and self.dead[e] == 0]

    def factor(self, dead):
        """(5): the factor and the collapse mode, f_R'u = 1."""
        n, m = self.b.shape
        found = linprog(np.r_[np.zeros(m), -1], A_eq=hstack([self.b, -csr_matrix(self.reference).T]), b_eq=dead,
                        bounds=[(-self.strength, self.strength)] * m + [(None, None)], method="highs")
        if found.status != 0:
            raise ArithmeticError(found.message)
        mode = np.array(found.eqlin.marginals)
        return -found.fun, mode / (self.reference @ mode)

    def load(self, alpha, signs):
        dead = self.dead.copy()
        dead[self.uncertain] += alpha * signs
        return dead

    def worst_signs(self, mode):
        """Of each uncertain displacement of a mode; zero where it rests, as any sign does there."""
        u = mode[self.uncertain]
        return np.where(np.abs(u) > 1e-9 * np.abs(u).max(), np.sign(u), 0.0)

    def descend(self, alpha, mode):
        """By turns the worst load of a mode and the mode of a load."""
        best = np.inf
        while True:
            signs = self.worst_signs(mode)
            factor, mode = self.factor(self.load(alpha, signs))
            if factor >= best - 1e-10:
                return best, best_signs
            best, best_signs = factor, signs

    def cut(self, e, z):
        """min z'|y| + |k| with B y - k f_R = e_e."""
        m = self.b.shape[1]
        r = csr_matrix(self.reference).T
        right = np.zeros(self.b.shape[0])
        right[e] = 1
        found = linprog(np.r_[z, z, 1, 1], A_eq=hstack([self.b, -self.b, -r, r]), b_eq=right, method="highs")
        return np.abs(found.x[:m] - found.x[m:2 * m]), abs(found.x[2 * m] - found.x[2 * m + 1])

    def worst(self, alpha):
        """Lower and upper end of the least factor, and the signs of the worst load that was found."""
        n, m = self.b.shape
        k = len(self.uncertain)
        nominal, mode = self.factor(self.dead)
        upper, signs = self.descend(alpha, mode)
        scale = np.abs(mode).max() * 1e3
        rows = vstack([hstack([self.b.T, -eye(m), csr_matrix((m, k))]), hstack([-self.b.T, -eye(m), csr_matrix((m, k))])])
        cuts, right = [], []
        for _ in range(60):
            # u, z, gamma; z >= |B'u|, z and gamma in a box far off.
            matrix = vstack([rows] + cuts) if cuts else rows
            found = linprog(np.r_[-self.dead, np.full(m, self.strength), np.full(k, -alpha)],
                            A_ub=matrix, b_ub=np.r_[np.zeros(2 * m), right],
                            A_eq=csr_matrix(np.r_[self.reference, np.zeros(m + k)]), b_eq=[1.0],
                            bounds=[(None, None)] * n + [(0, scale)] * m + [(0, scale)] * k, method="highs")
            lower = found.fun
            u, z, gamma = np.split(found.x, [n, n + m])
            factor, corner = self.descend(alpha, u)
            if factor < upper:
                upper, signs = factor, corner
            if upper - lower <= 0.2 * NEAR * nominal:
                break
            resting = z + 1e-3 * z.mean()
            for j, e in enumerate(self.uncertain):
                y, factor = self.cut(e, resting)
                if gamma[j] > y @ z + factor + 1e-12:
                    row = lil_matrix((1, n + m + k))
                    row[0, n:n + m], row[0, n + m + j] = -y, 1
                    cuts.append(csr_matrix(row))
                    right.append(factor)
        return lower, upper, signs


def grid(bays, width, braced_base, supported):
    """Nodes and members of a grid of bays x bays, crosswise braced, row by row from below."""
    side = bays + 1
    nodes = [(width * i, 0.5 * j) for j in range(side) for i in range(side)]
    beams = [(side * j + i, side * j + i + 1) for j in range(0 if braced_base else 1, side) for i in range(bays)]
    columns = [(side * j + i, side * (j + 1) + i) for j in range(bays) for i in range(side)]
    braces = [pair for j in range(bays) for i in range(bays)
              for pair in ((side * j + i, side * (j + 1) + i + 1), (side * j + i + 1, side * (j + 1) + i))]
    return nodes, beams + columns + braces, supported


def family(bays):
    nodes, members, supported = grid(bays, 0.35, False, set(range(bays + 1)))
    side = bays + 1
    reference = [(side * r, "x", 52 - 24 * (r - 2) / (bays - 2)) for r in range(2, bays + 1)]
    dead = [(side * bays + i, "y", -800) for i in range(2, bays + 1)]
    return Truss(nodes, members, supported, reference, dead, 800)


class Comparison:
    def __init__(self):
        self.faults = self.count = 0

    def near(self, what, found, expected, scale):
        self.count += 1
        if not abs(found - expected) <= NEAR * scale:
            self.faults += 1
            print(f"{what}: {found:.12g}, in the file {expected:.12g}")

    def same(self, what, found, expected):
        self.count += 1
        if found != expected:
            self.faults += 1
            print(f"{what}: differs from the file")

    def worst(self, what, truss, alpha, expected, nominal):
        lower, upper, signs = truss.worst(alpha)
        self.near(what + ", from below", lower, expected, nominal)
        self.near(what + ", from above", upper, expected, nominal)
        return signs


def value_on(points, at):
    return np.interp(at, [x for x, _ in points], [y for _, y in points])


def main():
    largest = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    expected_file = json.loads((HERE / "limit.json").read_text())
    compare = Comparison()
    trusses, corners = {}, {}
    shapes = {"3x3": grid(3, 0.7, True, {0, 3}), "4x4": grid(4, 0.35, False, set(range(5)))}
    for name, (nodes, members, supported) in shapes.items():
        data = expected_file["trusses"][name]
        compare.same(f"{name}: nodes", np.round(nodes, 9).tolist(), data["nodes_m"])
        compare.same(f"{name}: members", sorted(map(list, members)), sorted(map(sorted, data["members"])))
        compare.same(f"{name}: supports", sorted(supported), data["supported"])
        loads = [[(load["node"], load["component"], load["value"]) for load in data[kind]]
                 for kind in ("reference_load_kN", "dead_load_kN")]
        truss = trusses[name] = Truss(nodes, members, supported, *loads, data["yield_force_kN"])
        values = data["values"]
        compare.same(f"{name}: uncertain components", len(truss.uncertain), values["uncertain_components"])
        nominal = values["nominal"]
        compare.near(f"{name}: nominal", truss.factor(truss.dead)[0], nominal, nominal)
        for alpha, expected in values["worst_case"].items():
            corners[name, alpha] = compare.worst(f"{name}, alpha = {alpha}", truss, float(alpha), expected, nominal)
        # At the breakpoints and half-way between, which a concave function that agrees there pins down.
        points = expected_file["worst_case_of_alpha"][name]
        for (left, _), (right, _) in zip(points, points[1:]):
            for alpha in ((left + right) / 2, right):
                compare.worst(f"{name}, alpha = {alpha:.6g}", truss, alpha, value_on(points, alpha), nominal)

    figure, truss = expected_file["figure_5"], trusses["3x3"]
    nominal = expected_file["trusses"]["3x3"]["values"]["nominal"]
    for line, corner, alpha in (("solid", "40", 40), ("dashed", "20", 40)):
        points = figure[line]
        at = sorted({x for x, _ in points} | {(a + b) / 2 for (a, _), (b, _) in zip(points, points[1:])})
        for beta in at:
            found, _ = truss.factor(truss.load(alpha * beta, corners["3x3", corner]))
            compare.near(f"figure 5, {line}, beta = {beta:.6g}", found, value_on(points, beta), nominal)
    for beta, expected in figure["worst"]:
        compare.worst(f"figure 5, worst, beta = {beta:.6g}", truss, 40 * beta, expected, nominal)

    for bays in range(5, largest + 1):
        truss = family(bays)
        nominal = expected_file["family"]["nominal"][str(bays)]
        compare.near(f"{bays} x {bays}: nominal", truss.factor(truss.dead)[0], nominal, nominal)
        for alpha in (20, 40):
            expected = expected_file["family"][f"worst_case_alpha_{alpha}"][str(bays)]
            compare.worst(f"{bays} x {bays}, alpha = {alpha}", truss, alpha, expected, nominal)
    print(f"{compare.count} comparisons with limit.json, {compare.faults} differ")
    return 1 if compare.faults else 0


if __name__ == "__main__":
    sys.exit(main())
