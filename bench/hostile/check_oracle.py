"""Checks of the oracle: rays against programs in 80 digits, and both against cvxopt and HiGHS in
doubles.

    /usr/bin/python3 bench/hostile/check_oracle.py --count 300

Debian: python3-cvxopt, python3-scipy. Leaves with |t*| < 1e-7 are skipped, since doubles cannot
determine their sign.
"""

import argparse
from itertools import combinations

import cvxopt
import numpy
import scipy.optimize
from cvxopt import solvers

import cone_program
import generate
from oracle import Oracle

UNSURE = 1e-7


def program(flexibility, d, friction, contact):
    """t* of a leaf by cvxopt; None if it fails. All candidates have friction."""
    m = len(friction)
    columns = [(i, a) for i in contact for a in range(d)]
    n = len(columns) + 1
    matrix = numpy.array([[float(x) for x in row] for row in flexibility])
    row_of = lambda j: [matrix[j * d, i * d + a] for i, a in columns]
    equations = [row_of(i) + [0.0] for i in contact]
    equations.append([1.0 if a == 0 else 0.0 for _, a in columns] + [0.0])
    right = [0.0] * len(contact) + [1.0]
    linear = [[-x for x in row_of(j)] + [1.0] for j in range(m) if j not in contact]
    g, h = list(linear), [0.0] * len(linear)
    for k, i in enumerate(contact):
        top = [0.0] * n
        top[k * d] = -float(friction[i])
        top[n - 1] = 1.0
        g.append(top)
        for a in range(1, d):
            row = [0.0] * n
            row[k * d + a] = -1.0
            g.append(row)
        h += [0.0] * d
    goal = [0.0] * (n - 1) + [-1.0]
    dims = {"l": len(linear), "q": [d] * len(contact), "s": []}
    try:
        answer = solvers.conelp(cvxopt.matrix(goal), cvxopt.matrix(numpy.array(g)), cvxopt.matrix(h), dims,
                                cvxopt.matrix(numpy.array(equations)), cvxopt.matrix(right))
    except (ValueError, ArithmeticError, ZeroDivisionError):
        return None
    if answer["status"] == "optimal":
        return -answer["primal objective"]
    return float("-inf") if answer["status"] == "primal infeasible" else None


def linear_program(flexibility, friction, contact):
    """The same in the plane by HiGHS."""
    m = len(friction)
    columns = [(i, a) for i in contact for a in range(2)]
    matrix = numpy.array([[float(x) for x in row] for row in flexibility])
    row_of = lambda j: [matrix[j * 2, i * 2 + a] for i, a in columns]
    equations = [row_of(i) + [0.0] for i in contact] + [[1.0 - a for _, a in columns] + [0.0]]
    above = [[-x for x in row_of(j)] + [1.0] for j in range(m) if j not in contact]
    for k, i in enumerate(contact):
        for side in (1.0, -1.0):
            row = [0.0] * (len(columns) + 1)
            row[2 * k], row[2 * k + 1], row[-1] = -float(friction[i]), side, 1.0
            above.append(row)
    answer = scipy.optimize.linprog([0.0] * len(columns) + [-1.0], A_ub=above, b_ub=[0.0] * len(above), A_eq=equations,
                                    b_eq=[0.0] * len(contact) + [1.0], bounds=(None, None), method="highs",
                                    options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    if answer.status == 0:
        return -answer.fun
    return float("-inf") if answer.status == 2 else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=130)
    arguments = parser.parse_args()
    solvers.options.update(show_progress=False, abstol=1e-10, reltol=1e-9, feastol=1e-10)
    judged = unsure = gave_up = wrong = 0
    for index in range(arguments.count):
        case = generate.make(arguments.seed, index, generate.KINDS, (1.0, 1e2, 1e4))
        oracle = Oracle(case.text)
        if oracle.d == 2:
            rays, programs = oracle.by_rays(case.mu), oracle.by_programs(case.mu)
            if rays.cones != programs.cones and not rays.undecided and not programs.undecided:
                wrong += 1
                print(f"{case.name}: rays {rays.cones}, programs {programs.cones}")
        friction = oracle.friction(case.mu)
        if any(value == 0 for value in friction):
            continue
        scaled = cone_program.equilibrated(oracle.flexibility, oracle.d)
        m = len(friction)
        for size in range(1, m + 1):
            for contact in combinations(range(m), size):
                apart = [i for i in range(m) if i not in contact]
                truth = cone_program.sign(cone_program.Leaf(scaled, oracle.d, friction, contact, apart))
                values = [program(scaled, oracle.d, friction, contact)]
                if oracle.d == 2:
                    values.append(linear_program(scaled, friction, contact))
                for value in values:
                    if value is None:
                        gave_up += 1
                    elif abs(value) < UNSURE:
                        unsure += 1
                    else:
                        judged += 1
                        if truth != (cone_program.ALIVE if value > 0 else cone_program.DEAD):
                            wrong += 1
                            print(f"{case.name} {contact}: {truth}, but t* = {value} in doubles")
    print(f"{arguments.count} structures: {judged} leaves compared, {wrong} differ; "
          f"{unsure} too close to zero, {gave_up} not solved")
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
