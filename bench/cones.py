#!/usr/bin/env python3
"""Comparison of the cone solver with cvxopt on the same node programs, in one run.

    bench/cones.py [build/bench/bench_cones]

For each instance of bench/instances/cones-*.json: microseconds and iterations per solve of both,
and their ratio. cvxopt (Debian: python3-cvxopt) solves the same program to the same accuracy in the
original variables r (of candidates that are not separated) and t, with its Cholesky KKT solver; the
assembly of its matrices is not counted. A value outside the bracket of Kusabi is reported.
"""

import glob
import json
import os
import subprocess
import sys
import time

from cvxopt import matrix, solvers

ACCURACY = 1e-8  # of both
DIMENSION = 3


def program(compliance, friction, contact, separated):
    """conelp's data of one node; the last variable is t."""
    m = len(compliance) // DIMENSION
    open_ = [i for i in range(m) if not separated >> i & 1]
    touching = [i for i in range(m) if contact >> i & 1]
    apart = [i for i in range(m) if not contact >> i & 1]
    columns = [DIMENSION * i + c for i in open_ for c in range(DIMENSION)]
    n = len(columns) + 1
    equations = [[compliance[DIMENSION * i][c] for c in columns] + [0.0] for i in touching]
    equations.append([float(c % DIMENSION == 0) for c in columns] + [0.0])
    rows = [[-compliance[DIMENSION * j][c] for c in columns] + [1.0] for j in apart]
    for place in range(len(open_)):
        for component in range(DIMENSION):
            row = [0.0] * n
            row[DIMENSION * place + component] = -friction if component == 0 else -1.0
            row[-1] = 1.0 if component == 0 else 0.0
            rows.append(row)
    objective = matrix(0.0, (n, 1))
    objective[n - 1] = -1.0
    right = matrix([0.0] * len(touching) + [1.0])
    dims = {"l": len(apart), "q": [DIMENSION] * len(open_), "s": []}
    return (objective, matrix(rows).T, matrix(0.0, (len(rows), 1)), dims, matrix(equations).T, right)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    program_file = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "../build/bench/bench_cones")
    instances = sorted(glob.glob(os.path.join(here, "instances/cones-*.json")))
    solvers.options.update(show_progress=False, abstol=ACCURACY, reltol=ACCURACY, feastol=ACCURACY)
    print("  m | ours: us   iterations | cvxopt: us  iterations |  ratio | certified sign: us  share of full")
    for instance in instances:
        answer = subprocess.run([program_file, "--json", instance], check=True, capture_output=True, text=True)
        data = json.loads(answer.stdout)
        seconds = iterations = solved = failed = wrong = 0
        for sets, (lower, upper) in zip(data["nodes"], data["brackets"]):
            contact, separated = (int(word, 16) if isinstance(word, str) else word for word in sets)
            if separated == (1 << len(data["compliance"]) // DIMENSION) - 1:
                continue
            given = program(data["compliance"], data["friction"], contact, separated)
            start = time.process_time()
            try:
                solution = solvers.conelp(*given, kktsolver="chol")
            except (ArithmeticError, ValueError):
                failed += 1
                continue
            finally:
                seconds += time.process_time() - start
                solved += 1
            iterations += solution["iterations"]
            if solution["status"] != "optimal":
                failed += 1
                continue
            value = -solution["primal objective"]
            slack = 1e-6 * max(1.0, abs(value))
            wrong += not lower - slack <= value <= upper + slack
        theirs = 1e6 * seconds / solved
        ours, our_iterations = data["full"]
        sign, _ = data["sign"]
        print(f"{len(data['compliance']) // DIMENSION:3} | {ours:8.1f} {our_iterations:12.1f} | "
              f"{theirs:10.0f} {iterations / solved:11.1f} | {theirs / ours:6.0f} | "
              f"{sign:18.1f} {sign / ours:14.2f}")
        if failed:
            print(f"      cvxopt did not solve {failed} of {solved}")
        if wrong:
            print(f"      {wrong} values DISAGREE")


if __name__ == "__main__":
    main()
