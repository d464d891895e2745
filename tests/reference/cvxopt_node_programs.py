#!/usr/bin/env python3
"""Writes cvxopt_node_programs.json: node programs of the wedged problem with their optimal values.

Reference values for the cone solver in solvers/conic, by another program (cvxopt's conelp) and in
another formulation, in the original variables r and t:

    max t   (F r)_{n,i} = 0 (i in U),   (F r)_{n,j} >= t (j not in U),
            ||r_{t,i}|| + t <= mu_i r_{n,i} (i not in R),   r_i = 0 (i in R),   sum r_{n,i} = 1,

the form of the wedged paper's (23) at a node (U, R). Data are decimals of three places, which the
file represents exactly. Usage: cvxopt_node_programs.py > cvxopt_node_programs.json
"""

import json
import random

from cvxopt import lapack, matrix, solvers, spmatrix

SEED = 28
CASES = 40
# Far below what the test compares to (1e-6); conelp reaches it on these well-scaled data.
TOLERANCE = 1e-9


def compliance(rng, d, m):
    """A sparse symmetric positive definite dm x dm matrix with about unit normal diagonal."""
    size = d * m
    factor = [[rng.uniform(-1, 1) if rng.random() < 0.5 else 0.0 for _ in range(size)]
              for _ in range(size)]
    product = [[sum(a * b for a, b in zip(p, q)) for q in factor] for p in factor]
    mean = sum(product[d * i][d * i] for i in range(m)) / m
    return [[round(product[i][j] / mean + (0.2 if i == j else 0.0), 3) for j in range(size)]
            for i in range(size)]


def positive_definite(rows):
    try:
        lapack.potrf(matrix([row[:] for row in rows]))
    except ArithmeticError:
        return False
    return True


def optimum(d, friction, rows, contact, separated):
    """t*, or None when conelp does not reach the tolerance (or there is no feasible point)."""
    m, size = len(friction), d * len(friction)
    t = size  # the column of t, after those of r
    equations, values = [], []
    for i in sorted(contact):
        equations.append({c: rows[d * i][c] for c in range(size)})
        values.append(0.0)
    for i in sorted(separated):
        for c in range(d * i, d * i + d):
            equations.append({c: 1.0})
            values.append(0.0)
    equations.append({d * i: 1.0 for i in range(m)})
    values.append(1.0)

    # conelp: G x + s = h with s in the nonnegative orthant, then in the second-order cones.
    cone_rows, dims = [], {"l": m - len(contact), "q": [], "s": []}
    for j in range(m):
        if j not in contact:
            cone_rows.append({**{c: -rows[d * j][c] for c in range(size)}, t: 1.0})
    for i in range(m):
        if i not in separated:
            cone_rows.append({d * i: -friction[i], t: 1.0})
            cone_rows.extend({d * i + c: -1.0} for c in range(1, d))
            dims["q"].append(d)

    def sparse(table):
        entries = [(v, i, j) for i, row in enumerate(table) for j, v in row.items() if v != 0]
        return spmatrix(*map(list, zip(*entries)), size=(len(table), size + 1))

    objective = matrix(0.0, (size + 1, 1))
    objective[t] = -1.0
    options = {"show_progress": False, "abstol": TOLERANCE, "reltol": TOLERANCE,
               "feastol": TOLERANCE, "maxiters": 100}
    try:
        solution = solvers.conelp(objective, sparse(cone_rows), matrix(0.0, (len(cone_rows), 1)),
                                  dims, sparse(equations), matrix(values), options=options)
    except (ArithmeticError, ValueError):
        return None
    if solution["status"] != "optimal":
        return None
    return -solution["primal objective"]


def main():
    rng = random.Random(SEED)
    cases = []
    while len(cases) < CASES:
        d, m = rng.choice([2, 3]), rng.randint(2, 8)
        rows = compliance(rng, d, m)
        if not positive_definite(rows):
            continue
        friction = [round(rng.uniform(0.1, 1.0), 2) for _ in range(m)]
        kinds = [rng.choice("UURRF") for _ in range(m)]
        contact = [i for i in range(m) if kinds[i] == "U"]
        separated = [i for i in range(m) if kinds[i] == "R"]
        if len(separated) == m:
            continue
        value = optimum(d, friction, rows, set(contact), set(separated))
        if value is None:
            continue
        cases.append({"dimension": d, "friction": friction, "contact": contact,
                      "separated": separated, "optimum": value, "compliance": rows})
    print("[")
    print(",\n".join(json.dumps(case) for case in cases))
    print("]")


if __name__ == "__main__":
    main()
