#!/usr/bin/env python3
"""Writes cvxopt_bounds.json: bounds of single candidates, infeasible nodes with cuts, exact values.

Input of the tests of verify/wedged/infeasibility_proof.cpp. Multipliers are those of the least bound that
cvxopt's conelp finds. The exact value is the maximum over all patterns of contact and separation of

    max r_ni  or  max u_ni,   s = sum r_n = 1,   u = F r,
    u_n = 0 in contact, >= 0 separated,   r = 0 separated,   ||r_t|| <= mu r_n in contact.

K has entries with six binary places, which the file represents exactly.
Usage: cvxopt_bounds.py > cvxopt_bounds.json
"""

import itertools
import json
import random

import numpy
from cvxopt import matrix, solvers

SEED = 17
ROUNDS = 2
MARGIN = 1e-3  # left for the proof: delta
DEAD = 1e-3  # the least delta, multipliers being at most LARGEST, that a node is called dead with
LARGEST = 100.0
OPTIONS = {"show_progress": False, "abstol": 1e-9, "reltol": 1e-9, "feastol": 1e-9}


def solved(objective, rows, values, cones, equations=(), right=()):
    """min objective'x, values - rows x in orthant and cones, equations x = right; x and status."""
    columns = len(objective)
    dims = {"l": len(rows) - sum(cones), "q": list(cones), "s": []}
    extra = ()
    if len(equations):
        extra = (matrix(numpy.array(equations, dtype=float).reshape(-1, columns)),
                 matrix(numpy.array(right, dtype=float)))
    try:
        found = solvers.conelp(matrix(numpy.array(objective, dtype=float)),
                               matrix(numpy.array(rows, dtype=float)),
                               matrix(numpy.array(values, dtype=float)), dims, *extra,
                               options=OPTIONS)
    except (ValueError, ArithmeticError):
        return None, "failed"
    x = None if found["x"] is None else numpy.array(found["x"]).ravel()
    return x, found["status"]


class Problem:
    def __init__(self, rng, d, m, mu):
        self.d, self.m, self.mu = d, m, mu
        n = d * m
        half = numpy.array([[rng.uniform(-1, 1) for _ in range(n)] for _ in range(n)])
        self.stiffness = numpy.round(64 * (half @ half.T + 0.3 * numpy.eye(n))) / 64
        self.compliance = numpy.linalg.inv(self.stiffness)
        self.gap = [None] * m
        self.reaction = [1.0] * m
        self.fixed = {"contact": set(), "separated": set()}  # never on the other side

    def multipliers(self, contact, separated, hypothesis=None, cuts=True):
        """y, eta and what they prove: the least bound, or the largest margin delta.

        Columns: y (m), eta (m), beta or delta. w = F_n (y - eta A + theta e_i).
        """
        d, m = self.d, self.m
        normals = self.compliance[:, ::d]
        columns = 2 * m + 1
        side, i = hypothesis if hypothesis else (None, None)
        w = numpy.zeros((d * m, columns))
        w[:, :m] = normals
        for k in range(m):
            if self.gap[k] is not None:
                w[:, m + k] = -normals[:, k] / self.gap[k]
        constant = normals[:, i] if side == "separated" else numpy.zeros(d * m)
        rows, values, cones = [], [], []

        def at_least(coefficients, constant_part):  # coefficients x + constant >= 0
            rows.append(-coefficients)
            values.append(constant_part)

        for j in range(m):
            unit = numpy.eye(columns)
            if j not in contact:
                at_least(unit[j], 0.0)
            at_least(-unit[j], LARGEST)
            at_least(unit[j], LARGEST)
            at_least(unit[m + j], 0.0)
            has = cuts and self.gap[j] is not None
            at_least(-unit[m + j], LARGEST if has else 0.0)
        if not hypothesis:
            at_least(-numpy.eye(columns)[2 * m], 1.0)
        for k in range(m):
            if k in separated:
                continue
            tilde, own = w[d * k].copy(), constant[d * k]
            tilde[m:2 * m] += 1.0
            tilde[m + k] -= 1.0 / self.reaction[k]
            if side == "contact" and k == i:
                own += 1.0
            if hypothesis:
                tilde[2 * m] -= 1.0  # - theta beta
                own += MARGIN
            else:
                tilde[2 * m] += 1.0  # - w~ - mu |w_t| >= delta
            rows_of_cone = [-tilde] + [self.mu * w[d * k + c] for c in range(1, d)]
            cone_values = [-own] + [self.mu * constant[d * k + c] for c in range(1, d)]
            cones.append((rows_of_cone, cone_values))
        for cone_rows, cone_values in cones:
            rows.extend(-numpy.array(row) for row in cone_rows)
            values.extend(cone_values)
        objective = numpy.zeros(columns)
        objective[2 * m] = 1.0 if hypothesis else -1.0
        # At most so much of everything: the simplest multipliers.
        objective[m:2 * m] += 1e-7
        x, status = solved(objective, rows, values, [d] * len(cones))
        if status != "optimal":
            return None
        eta = numpy.maximum(x[m:2 * m], 0.0)
        eta[eta < 1e-8] = 0.0
        y = x[:m].copy()
        for k in range(m):
            if k not in contact:
                y[k] = max(y[k], 0.0)
            if self.gap[k] is not None:
                y[k] -= eta[k] / self.gap[k]
        if side == "separated":
            y[i] += 1.0
        return list(y), list(eta), x[2 * m]

    def sides(self, i, side):
        contact, separated = set(self.fixed["contact"]), set(self.fixed["separated"])
        (contact if side == "contact" else separated).add(i)
        return contact, separated

    def bounds(self):
        """The lines, in the order in which they are proved."""
        lines = []
        for _, i, side in itertools.product(range(ROUNDS), range(self.m), ("contact", "separated")):
            if i in self.fixed["contact"] | self.fixed["separated"]:
                continue
            contact, separated = self.sides(i, side)
            if len(separated) == self.m:
                continue
            dead = self.multipliers(contact, separated)
            if dead and dead[2] > DEAD:
                plain = self.multipliers(contact, separated, cuts=False)
                lines.append({"candidate": i, "side": side, "most": None,
                              "numbers": dead[0] + dead[1],
                              "alone": bool(plain and plain[2] > 0)})
                self.fixed["separated" if side == "contact" else "contact"].add(i)
                continue
            found = self.multipliers(contact, separated, (side, i))
            if not found:
                continue
            y, eta, most = found
            known = self.reaction if side == "contact" else self.gap
            if most <= 0 or (known[i] is not None and most > 0.99 * known[i]):
                continue
            plain = self.multipliers(contact, separated, (side, i), cuts=False)
            # Far enough above for cvxopt to be believed.
            alone = plain is not None and plain[2] - 2 * MARGIN <= most
            lines.append({"candidate": i, "side": side, "most": most, "numbers": y + eta + [1.0],
                          "alone": bool(alone)})
            known[i] = most
        return lines

    def dead_nodes(self):
        """Those that cuts close and nothing else, on the way from the root."""
        found, open_nodes = [], [(set(), set())]
        while open_nodes:
            contact, separated = open_nodes.pop()
            free = [i for i in range(self.m) if i not in contact | separated]
            if len(separated) == self.m:
                continue
            plain = self.multipliers(contact, separated, cuts=False)
            if plain and plain[2] > 0:
                continue
            with_cuts = self.multipliers(contact, separated)
            if with_cuts and with_cuts[2] > DEAD and plain and plain[2] < 1e-6:
                found.append({"contact": sorted(contact), "separated": sorted(separated),
                              "numbers": with_cuts[0] + with_cuts[1]})
            elif free:
                open_nodes += [(contact | {free[0]}, separated), (contact, separated | {free[0]})]
        return found

    def greatest(self):
        """By side and candidate the largest reaction or gap of all patterns; None: there is none."""
        d, m, n = self.d, self.m, self.d * self.m
        most = {"contact": [None] * m, "separated": [None] * m}
        for size in range(1, m + 1):
            for contact in itertools.combinations(range(m), size):
                equations, right = [], []
                unit = numpy.eye(n)
                rows, values = [], []
                for i in range(m):
                    if i in contact:
                        equations.append(self.compliance[d * i])
                        right.append(0.0)
                    else:
                        rows.append(-self.compliance[d * i])
                        values.append(0.0)
                        for c in range(d):
                            equations.append(unit[d * i + c])
                            right.append(0.0)
                equations.append(sum(unit[d * i] for i in range(m)))
                right.append(1.0)
                for i in contact:
                    rows.append(-self.mu * unit[d * i])
                    rows.extend(-unit[d * i + c] for c in range(1, d))
                    values.extend([0.0] * d)
                for i in range(m):
                    side = "contact" if i in contact else "separated"
                    value = unit[d * i] if i in contact else self.compliance[d * i]
                    x, status = solved(-value, rows, values, [d] * size, equations, right)
                    if status != "optimal":
                        break  # no configuration has this pattern
                    known = most[side][i]
                    most[side][i] = max(value @ x, known if known is not None else value @ x)
        return most


def main():
    rng = random.Random(SEED)
    cases = []
    for d, m, mu in [(2, 3, 1.0), (2, 4, 0.75), (2, 5, 1.0), (3, 3, 1.0), (3, 4, 0.75), (3, 5, 0.75)]:
        while True:
            problem = Problem(rng, d, m, mu)
            if numpy.linalg.eigvalsh(problem.stiffness)[0] < 0.1:
                continue
            greatest = problem.greatest()
            if sum(value is not None for side in greatest.values() for value in side) < m:
                continue
            lines = problem.bounds()
            nodes = problem.dead_nodes()
            if nodes and any(not line["alone"] for line in lines):
                break
        cases.append({"dimension": d, "friction": mu, "stiffness": problem.stiffness.tolist(),
                      "bounds": lines, "cuts": nodes, "greatest": greatest})
    print(json.dumps(cases, indent=1))


main()
