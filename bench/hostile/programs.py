"""Random mixed zero-one programs that are numerically difficult for `kusabi mip`, with their exact
optimum.

    python3 bench/hostile/programs.py --kusabi build/kusabi --count 900 --seed 1 --found wrong/

Each program is solved in rational arithmetic by an independent tree search (exact_program.py).
Prints each case that differs or stays open, writes its file to --found, and counts. Exit code 0: no
disagreement, nothing open; 1: some.
"""

import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

from exact_program import INFEASIBLE, OPTIMAL, UNBOUNDED, Program, exact_optimum

TOLERANCE = Fraction(1, 10**8)  # relative tolerance of an optimum (docs/result-files.md)


def _rows(rng, program, columns, count, low, high, senses, per_row):
    for _ in range(count):
        chosen = rng.sample(columns, min(len(columns), rng.randint(*per_row)))
        terms = {j: float(rng.choice([-1, 1]) * rng.randint(low, high)) for j in chosen}
        program.row(rng.choice(senses), float(rng.randint(-high, 4 * high)), terms)


def _costs(rng, program, share=0.7):
    for column in program.columns:
        if rng.random() < share:
            column.cost = float(rng.randint(-9, 9))


def _plant(rng, program):
    """Right-hand sides chosen such that a random point near the bounds of its columns satisfies all rows."""
    at = []
    for column in program.columns:
        lower, upper = column.lower, column.upper
        ends = [end for end in (lower, upper) if end is not None] or [rng.randint(-4, 4)]
        inward = rng.choice([0, 0, 1, 2, 0.5]) if not column.binary and lower != upper else 0
        x = rng.choice(ends)
        at.append(Fraction(x) + Fraction(inward) * (-1 if x == upper else 1))
        if lower is not None and upper is not None:
            at[-1] = min(max(at[-1], Fraction(lower)), Fraction(upper))
    for row in program.rows:
        activity = sum(Fraction(value) * at[j] for j, value in row.terms.items())
        lower, upper = row.ends()
        if (lower is None or lower <= activity) and (upper is None or activity <= upper):
            continue
        if row.sense == "E" and Fraction(float(activity)) != activity:
            row.sense = rng.choice("LG")  # equal to no double
        toward = math.inf if row.sense == "L" else -math.inf
        right = activity + {"E": 0, "L": 1, "G": -1}[row.sense] * rng.choice([0, 0, 0, 1, 3])
        row.right = float(right)
        if row.sense != "E" and Fraction(row.right) != right:
            row.right = math.nextafter(row.right, toward)


def big_m(rng):
    """Rows switched off by a binary, M between 1e2 and 1e9; columns with unusual bounds."""
    program = Program()
    m = 10.0 ** rng.randint(2, 9)
    binaries = [program.column(binary=True) for _ in range(rng.randint(2, 7))]
    others = [program.column(*rng.choice([(0, None), (0, 8), (None, 0), (0, 0), (None, -5), (-3, 9), (None, None)]))
              for _ in range(rng.randint(2, 6))]
    for _ in range(rng.randint(1, 5)):
        terms = {j: float(rng.randint(-9, 9) or 1) for j in rng.sample(others, rng.randint(1, min(3, len(others))))}
        terms[rng.choice(binaries)] = rng.choice([-1, 1, -1]) * m
        program.row(rng.choice("LLG"), float(rng.choice([0, 0, rng.randint(-20, 40), m, -m])), terms)
    _rows(rng, program, binaries + others, rng.randint(1, 4), 1, 9, "LLGE", (1, 4))
    _costs(rng, program)
    return program


def fixed_charge(rng):
    """Flows with fixed costs of arcs; one M for all, far too large."""
    program = Program()
    nodes = rng.randint(3, 5)
    m = 10.0 ** rng.randint(2, 9)
    balance = [{} for _ in range(nodes)]
    for _ in range(rng.randint(nodes, 2 * nodes)):
        a, b = rng.sample(range(nodes), 2)
        flow = program.column(0, rng.choice([None, None, 6.0]), cost=float(rng.randint(0, 5)))
        used = program.column(binary=True, cost=float(rng.choice([4, 4, rng.randint(1, 20)])))
        balance[a][flow] = balance[a].get(flow, 0.0) + 1.0
        balance[b][flow] = balance[b].get(flow, 0.0) - 1.0
        program.row("L", 0.0, {flow: 1.0, used: -m})
    amount = float(rng.randint(1, 9))
    for node, terms in enumerate(balance):
        program.row("E", amount if node == 0 else -amount if node == nodes - 1 else 0.0, terms)
    return program


def knapsack(rng):
    """Equality knapsacks, and pairs of them, with a continuous column for small corrections."""
    program = Program()
    binaries = [program.column(binary=True, cost=float(rng.randint(-30, 30))) for _ in range(rng.randint(4, 10))]
    rest = program.column(0, rng.choice([0.5, 2, None]), cost=float(rng.randint(1, 9)))
    for _ in range(rng.randint(1, 2)):
        weights = {j: float(rng.randint(3, 40)) for j in binaries}
        target = sum(weights[j] for j in binaries if rng.random() < 0.5)
        if rng.random() < 0.7:
            weights[rest] = rng.choice([-1.0, 1.0])
        program.row("E", target + rng.choice([0, 0, 1, 0.5]), weights)
    return program


def ties(rng):
    """Coefficients of 0 and 1, equal costs: many optima, degenerate bases."""
    program = Program()
    binaries = [program.column(binary=True, cost=float(rng.choice([-1, 1, 1]))) for _ in range(rng.randint(3, 8))]
    others = [program.column(0, rng.choice([None, 1, 2]), cost=float(rng.choice([-1, 0, 1]))) for _ in range(rng.randint(1, 5))]
    columns = binaries + others
    for _ in range(rng.randint(3, 8)):
        terms = {j: float(rng.choice([-1, 1])) for j in rng.sample(columns, rng.randint(2, min(5, len(columns))))}
        program.row(rng.choice("LLGE"), float(rng.choice([0, 0, 1, 1, 2])), terms)
    return program


def free(rng):
    """Columns without bounds, ranges, rows of all kinds."""
    program = Program()
    binaries = [program.column(binary=True) for _ in range(rng.randint(2, 6))]
    others = [program.column(*rng.choice([(None, None), (None, None), (0, None), (None, 4)])) for _ in range(rng.randint(2, 6))]
    _rows(rng, program, binaries + others, rng.randint(2, 7), 1, 9, "LGE", (2, 5))
    for row in program.rows:
        if row.sense in "LG" and rng.random() < 0.2:
            row.range = float(rng.randint(0, 30))
    _costs(rng, program)
    return program


def decades(rng):
    """Coefficients over twelve decades, and decimals without an equal double."""
    program = Program()
    binaries = [program.column(binary=True) for _ in range(rng.randint(2, 6))]
    others = [program.column(0, rng.choice([None, 10.0 ** rng.randint(-3, 6)])) for _ in range(rng.randint(1, 5))]
    columns = binaries + others
    for _ in range(rng.randint(2, 6)):
        terms = {j: float(f"{rng.choice([-1, 1]) * rng.randint(1, 99)}e{rng.randint(-6, 6)}")
                 for j in rng.sample(columns, rng.randint(1, min(4, len(columns))))}
        program.row(rng.choice("LLGE"), float(f"{rng.randint(-9, 99)}e{rng.randint(-3, 6)}"), terms)
    for column in program.columns:
        column.cost = float(f"{rng.randint(-9, 9)}e{rng.randint(-3, 3)}")
    return program


def penalties(rng):
    """Rows that may be violated at a cost of 1e4 to 1e12 per unit."""
    program = Program()
    binaries = [program.column(binary=True) for _ in range(rng.randint(3, 7))]
    penalty = 10.0 ** rng.randint(4, 12)
    _rows(rng, program, binaries, rng.randint(2, 5), 1, 9, "LGE", (2, 5))
    _costs(rng, program, 1)
    for row in program.rows:
        for sign in (1.0, -1.0):
            row.terms[program.column(0, None, cost=penalty)] = sign
    return program


def _mixed_columns(rng, program, binaries, others):
    """Binaries, and columns that are free, bounded on one side, or on both."""
    return ([program.column(binary=True) for _ in range(rng.randint(*binaries))] +
            [program.column(*rng.choice([(None, None), (None, None), (0, None), (None, 0), (0, 4), (-1, 1)]))
             for _ in range(rng.randint(*others))])


def wide(rng):
    """Coefficients from 1e-24 to 1e12 beside ones, free columns, few bounds."""
    program = Program()
    columns = _mixed_columns(rng, program, (0, 3), (2, 6))

    def number(ones=0.6):
        size = 1.0 if rng.random() < ones else float(f"{rng.randint(1, 9)}e{rng.randint(-24, 12)}")
        return rng.choice([-1, 1]) * size

    for _ in range(rng.randint(2, 7)):
        terms = {j: number() for j in rng.sample(columns, rng.randint(1, min(4, len(columns))))}
        program.row(rng.choice("LGGE"), rng.choice([0.0, 0.0, 1.0, number()]), terms)
    for column in program.columns:
        if rng.random() < 0.5:
            column.cost = number(0.8)
    return program


def nearly(rng):
    """Right-hand sides that miss a vertex by 1e-8 to 1e-15 of a row's terms, beside an unrelated column of up
    to 1e12."""
    program = Program()
    columns = _mixed_columns(rng, program, (1, 4), (1, 4))
    _rows(rng, program, columns, rng.randint(2, 5), 1, 5, "LG", (1, 4))
    _costs(rng, program)
    _plant(rng, program)
    for row in rng.sample(program.rows, min(len(program.rows), 2)):
        row.right += rng.choice([-1, 1]) * max(1.0, abs(row.right)) * 10.0**-rng.randint(8, 15)
        opposite = program.rows[-1] if rng.random() < 0.5 else row
        program.row("L" if opposite.sense == "G" else "G", opposite.right, dict(opposite.terms))
    size = 10.0**rng.randint(0, 12)
    program.column(size, size, cost=rng.choice([0.0, 0.0, 1.0 / size]))
    return program


def chains(rng):
    """Columns that are each up to 1e7 times the next: the optimum is far from all coefficients, or there is
    none."""
    program = Program()
    lower = rng.choice([None, 0])
    steps = [10.0**rng.randint(0, 7) for _ in range(rng.randint(2, 5))]
    columns = [program.column(lower) for _ in range(len(steps) + 1)]
    columns[-1:] = [program.column(binary=True)] if rng.random() < 0.4 else columns[-1:]
    program.columns[columns[0]].cost = -1.0
    for k, step in enumerate(steps):
        program.row("L", 0.0, {columns[k]: 1.0, columns[k + 1]: -step})
    if rng.random() < 0.7:
        program.row("L", rng.choice([1.0, 0.5, -1.0, 1e-9]), {columns[-1]: 1.0})
    if rng.random() < 0.3:
        program.row("G", 10.0**rng.randint(-9, 15), {columns[0]: 1.0})
    return program


def tiny(rng):
    """An objective far below its cost: a column defined by binaries with coefficients of 1e-6 to 1e-18."""
    program = Program()
    binaries = [program.column(binary=True) for _ in range(rng.randint(2, 6))]
    value = program.column(rng.choice([None, 0]), None, cost=10.0**rng.randint(-3, 3))
    unit = 10.0**-rng.randint(6, 18)
    program.row(rng.choice("EG"), 0.0, {value: 1.0, **{j: -rng.randint(-1, 9) * unit for j in binaries}})
    _rows(rng, program, binaries, rng.randint(1, 3), 1, 7, "G", (2, 4))
    return program


KINDS = {f.__name__: f for f in (big_m, fixed_charge, knapsack, ties, free, decades, penalties, wide, nearly, chains, tiny)}


def make(seed, index, kinds):
    """(name, program): the same on any machine."""
    kind = kinds[index % len(kinds)]
    rng = random.Random(f"programs/{seed}/{index}/{kind}")
    program = KINDS[kind](rng)
    if rng.random() < 0.8 and kind not in ("nearly", "chains"):
        _plant(rng, program)
    if rng.random() < 0.3:
        program.maximise = True
        for column in program.columns:
            column.cost = -column.cost
    return f"{kind}-{seed}-{index}", program


class Judged:
    """A run of the command compared with the exact optimum: `wrong` and `open` are one line each,
    or empty."""

    def __init__(self, program, truth, code, result, said):
        self.program, self.truth, self.code, self.result = program, truth, code, result
        self.wrong, self.open = self._wrong(said), None
        if not self.wrong and code != 0:
            self.open = f"{result.get('state')}: objective {result.get('objective')}, bound {result.get('bound')}"

    def _wrong(self, said):
        status, value = self.truth
        if self.code not in (0, 3) or not self.result:
            return f"exit code {self.code}: {said.strip().splitlines()[-1] if said.strip() else 'nothing said'}"
        answer = self.result["state"]
        if self.code == 0 and answer != status:
            return f"{answer}, exit code 0"
        if self.code == 3 and answer not in ("feasible", "unknown"):
            return f"{answer}, exit code 3"
        if answer == "feasible" and status != OPTIMAL and status != UNBOUNDED:
            return "a point of a program that has none"
        if status == OPTIMAL:
            return self._wrong_numbers(value)
        return None

    def _wrong_numbers(self, value):
        sign = -1 if self.program.maximise else 1
        size = max(abs(value), min((abs(Fraction(c.cost)) for c in self.program.columns if c.cost), default=Fraction(1)))
        bound = self.result.get("bound")
        if bound is not None:
            room = 0 if bound["standing"] == "proved" else TOLERANCE * size
            if sign * Fraction(bound["value"]) > sign * value + room:
                return f"bound {bound['value']} beyond the optimum {float(value)!r}"
        if self.result["state"] not in ("optimal", "feasible"):
            return None
        objective = Fraction(self.result["objective"])
        if self.result["state"] == "optimal" and abs(objective - value) > TOLERANCE * size:
            return f"optimal {float(objective)!r}, but the optimum is {float(value)!r}"
        if sign * objective < sign * value - TOLERANCE * size:
            return f"a point of {float(objective)!r}, better than the optimum {float(value)!r}"
        return self.program.missed(self.result["columns"])


def run(kusabi, options, path, ranks):
    """(exit code, result, output)"""
    output = path + f".{ranks}.json"
    launcher = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    serial = [] if ranks > 1 else ["--serial"]
    done = subprocess.run([*launcher, kusabi, "mip", path, *serial, *options, "--output", output],
                          capture_output=True, text=True, timeout=600)
    result = None
    if os.path.exists(output):
        with open(output) as file:
            result = json.load(file)["result"]
    return done.returncode, result, done.stdout + done.stderr


def examine(arguments, index):
    """(name, text of the file, [(what, line)])"""
    name, program = make(arguments.seed, index, arguments.kinds)
    as_lp = index % 2 == 1
    text = program.lp() if as_lp else program.mps()
    truth = exact_optimum(program)
    findings = []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name + (".lp" if as_lp else ".mps"))
        with open(path, "w") as file:
            file.write(text)
        first = None
        for ranks in arguments.ranks:
            code, result, said = run(arguments.kusabi, arguments.options, path, ranks)
            judged = Judged(program, truth, code, result or {}, said)
            value = "" if truth[1] is None else f" {float(truth[1])!r}"
            for what, line in (("wrong", judged.wrong), ("open", judged.open)):
                if line:
                    findings.append((what, f"{line}; truth: {truth[0]}{value}; {ranks} rank(s)"))
            answer = (code, *((result or {}).get(key) for key in ("answer", "objective", "bound")))
            if first is None:
                first = answer
            elif answer[:3] != first[:3]:
                findings.append(("differs", f"{first} on {arguments.ranks[0]}, {answer} on {ranks} rank(s)"))
    return os.path.basename(path), text, truth[0], findings


def main():
    parser = argparse.ArgumentParser(prog="bench/hostile/programs.py", description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--count", type=int, default=140)
    parser.add_argument("--kinds", default=",".join(KINDS), help="some of " + ",".join(KINDS))
    parser.add_argument("--options", default="", help="further options of mip, in one word")
    parser.add_argument("--ranks", default="1", help="numbers of ranks whose answers must agree, e.g. 1,2")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--found", help="write cases that are wrong or open to this folder")
    arguments = parser.parse_args()
    arguments.kinds = arguments.kinds.split(",")
    arguments.options = arguments.options.split()
    arguments.ranks = [int(number) for number in arguments.ranks.split(",")]
    counts = {}
    indices = range(arguments.first, arguments.first + arguments.count)
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for name, text, status, findings in pool.map(lambda index: examine(arguments, index), indices):
            counts[status] = counts.get(status, 0) + 1
            for what, line in findings:
                counts[what] = counts.get(what, 0) + 1
                print(f"{what}: {name}: {line}", flush=True)
            if findings and arguments.found:
                os.makedirs(arguments.found, exist_ok=True)
                with open(os.path.join(arguments.found, name), "w") as file:
                    file.write(text)
    failed = [what for what in ("wrong", "open", "differs") if counts.get(what)]
    print(f"{arguments.count} programs: " + ", ".join(f"{counts.get(key, 0)} {key}"
          for key in (OPTIMAL, INFEASIBLE, UNBOUNDED, "wrong", "open", "differs")))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
