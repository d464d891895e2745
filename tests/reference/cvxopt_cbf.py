#!/usr/bin/env python3
"""Solves a file in the Conic Benchmark Format with cvxopt, and prints the optimal objective.

For the cones that `kusabi export cbf` writes: F, L=, L+ and Q. Usage: cvxopt_cbf.py FILE
"""

import sys

from cvxopt import matrix, solvers, spmatrix


def read(name):
    """Keyword -> the lines of numbers and words below it."""
    with open(name, encoding="utf-8") as file:
        lines = [line.split() for line in file if not line.startswith("#")]
    sections, inside = {}, None
    for words in lines:
        if not words:
            inside = None
        elif inside is None:
            inside = sections.setdefault(words[0], [])
        else:
            inside.append(words)
    assert int(sections["VER"][0][0]) >= 1
    return sections


def parts(section):
    """The size in all, and (cone, first, size) of each part."""
    (total, count), *cones = section
    assert len(cones) == int(count)
    first, result = 0, []
    for cone, size in cones:
        result.append((cone, first, int(size)))
        first += int(size)
    assert first == int(total)
    return first, result


def entries(section):
    (count,), *rest = section
    assert len(rest) == int(count)
    return [(*map(int, words[:-1]), float(words[-1])) for words in rest]


def main():
    sections = read(sys.argv[1])
    columns, column_parts = parts(sections["VAR"])
    rows, row_parts = parts(sections["CON"])
    sign = {"MIN": 1.0, "MAX": -1.0}[sections["OBJSENSE"][0][0]]
    cost = matrix(0.0, (columns, 1))
    for j, value in entries(sections["OBJACOORD"]):
        cost[j] = sign * value
    constant = [0.0] * rows
    for i, value in entries(sections["BCOORD"]):
        constant[i] = value
    terms = [{} for _ in range(rows)]
    for i, j, value in entries(sections["ACOORD"]):
        assert j not in terms[i]
        terms[i][j] = value

    # Each column is in its cone, too: rows of the identity.
    every = [(cone, [(terms[i], constant[i]) for i in range(first, first + size)])
             for cone, first, size in row_parts]
    every += [(cone, [({j: 1.0}, 0.0) for j in range(first, first + size)])
              for cone, first, size in column_parts if cone != "F"]

    def of(kind):
        return [row for cone, part in every if cone == kind for row in part]

    def system(chosen, factor):
        triples = [(factor * v, i, j) for i, (row, _) in enumerate(chosen) for j, v in row.items()]
        return (spmatrix(*map(list, zip(*triples)), size=(len(chosen), columns)),
                matrix([b for _, b in chosen]))

    # conelp: G x + s = h and s in the cones; here s = matrix x + constant.
    g, h = system(of("L+") + of("Q"), -1.0)
    a, b = system(of("L="), -1.0)
    sizes = {"l": len(of("L+")), "q": [len(part) for cone, part in every if cone == "Q"], "s": []}
    options = {"show_progress": False, "abstol": 1e-10, "reltol": 1e-10, "feastol": 1e-10}
    solution = solvers.conelp(cost, g, h, sizes, a, b, options=options)
    if solution["status"] != "optimal":
        sys.exit("not solved: " + solution["status"])
    print(repr(sign * solution["primal objective"]))


if __name__ == "__main__":
    main()
