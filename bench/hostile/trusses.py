"""Random trusses under uncertain loads: guaranteed interval of load factors, compared with all
vertices of the load box.

    python3 bench/hostile/trusses.py --kusabi build/kusabi --count 300 --seed 1

Half of the trusses have nodes on a square grid, so that cosines are zero. Each truss is asked about as it is,
turned by a right angle and by any angle with sines and cosines in doubles, or with noise of 1e-16 in its
coordinates and forces; the simplex method has the same numbers. Each vertex is a known load, for which a simplex method finds the least and largest factor: in
doubles, and in rational numbers where the two programs disagree. Cables without compression, struts
without tension, uplift, several load cases, groups with different half-widths. Results without a
proof are counted, as "just carried" if a vertex is carried at one factor only, otherwise as "open".
Exit code 0: no disagreement.
"""

import argparse
import itertools
import json
import math
import operator
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

NEAR = 1e-6


class Failed(Exception):
    """The simplex method did not terminate."""


def _pivot(rows, basis, row, column):
    pivot = rows[row][column]
    rows[row] = [value / pivot for value in rows[row]]
    for other, values in enumerate(rows):
        factor = values[column]
        if other == row or factor == 0:
            continue
        rows[other] = [value - factor * at for value, at in zip(values, rows[row])]
    basis[row] = column


def _minimise(rows, basis, columns, eps):
    """Pivots by Bland's rule until the last row, the costs, is not negative. False: unbounded."""
    for _ in range(5000):
        costs = rows[-1]
        entering = next((j for j in columns if costs[j] < -eps), None)
        if entering is None:
            return True
        best = None
        for i, values in enumerate(rows[:-1]):
            if values[entering] > eps:
                key = (values[-1] / values[entering], basis[i])
                if best is None or key < best[0]:
                    best = (key, i)
        if best is None:
            return False
        _pivot(rows, basis, best[1], entering)
    raise Failed


def factors(truss, load, number=float):
    """(least, largest) factor at which the load is carried; None: it is not carried."""
    eps = 0 if number is Fraction else 1e-9
    n, members = len(load), len(truss["columns"])
    # x_i = q_i + c_i >= 0, its slack to c_i + t_i, and the factor as a difference.
    width = 2 * members + 2
    rows, wholes = [], []
    for e in range(n):
        right = number(load[e])
        values = [number(0)] * width
        for i, column in enumerate(truss["columns"]):
            values[i] = number(column[e])
            right += number(column[e]) * number(truss["compression"][i])
        values[-2], values[-1] = -number(truss["reference"][e]), number(truss["reference"][e])
        if right < 0:
            values, right = [-value for value in values], -right
        rows.append(values)
        wholes.append(right)
    for i in range(members):
        values = [number(0)] * width
        values[i] = values[members + i] = number(1)
        rows.append(values)
        wholes.append(number(truss["compression"][i]) + number(truss["tension"][i]))
    height = len(rows)
    basis = [width + i for i in range(height)]
    for i, values in enumerate(rows):
        values.extend(number(1) if j == i else number(0) for j in range(height))
        values.append(wholes[i])
    rows.append([-sum(values[j] for values in rows) for j in range(width)] + [number(0)] * height + [-sum(wholes)])
    _minimise(rows, basis, range(width), eps)
    if -rows[-1][-1] > (0 if number is Fraction else 1e-7 * (1 + sum(wholes))):
        return None
    for i in range(height):
        if basis[i] >= width:
            column = max(range(width), key=lambda j, i=i: abs(rows[i][j]))
            if abs(rows[i][column]) > eps:
                _pivot(rows, basis, i, column)
    ends = []
    for sign in (1, -1):
        costs = [number(0)] * len(rows[0])
        costs[width - 2], costs[width - 1] = number(sign), number(-sign)
        rows[-1] = costs
        for i, column in enumerate(basis):
            if rows[-1][column] != 0:
                factor = rows[-1][column]
                rows[-1] = [value - factor * at for value, at in zip(rows[-1], rows[i])]
        if not _minimise(rows, basis, range(width), eps):
            raise Failed
        ends.append(float(-rows[-1][-1] * sign))
    return tuple(ends)


def _in_all(intervals):
    """Intersection of all intervals, perhaps with least > largest; None: one of them is None."""
    least, largest = -math.inf, math.inf
    for ends in intervals:
        if ends is None:
            return None
        least, largest = max(least, ends[0]), min(largest, ends[1])
    return least, largest


def _corners(case):
    """The dead load at every vertex of one load case."""
    for signs in itertools.product((-1, 1), repeat=len(case["uncertain"])):
        load = list(case["dead"])
        for sign, (column, half_width) in zip(signs, case["uncertain"]):
            load = [value + sign * half_width * part for value, part in zip(load, column)]
        yield load


def _turned(angle):
    cosine, sine = math.cos(angle), math.sin(angle)
    return lambda vector: [cosine * vector[0] - sine * vector[1], sine * vector[0] + cosine * vector[1]]


def _wording(rng):
    """The vectors of a truss in other words: places and forces."""
    kind = rng.randrange(4)
    if kind == 0:
        return list
    if kind == 3:
        return lambda vector: [value + rng.choice((-1e-16, 0, 1e-16)) for value in vector]
    return _turned(math.pi / 2 if kind == 1 else rng.uniform(0, 2 * math.pi))


def make(seed, index):
    """(text of a problem file, truss, load cases, arguments)."""
    rng = random.Random(f"truss/{seed}/{index}")
    worded = _wording(random.Random(f"wording/{seed}/{index}"))
    count = rng.choice((3, 4, 5, 5))
    if index % 2 == 0:
        places = [(round(rng.uniform(0, 4), 2), round(rng.uniform(0, 4), 2)) for _ in range(count)]
    else:
        places = [(float(place // 3), float(place % 3)) for place in rng.sample(range(9), count)]
    places = [worded(place) for place in places]
    held = rng.sample(range(count), 2)
    free = [(node, axis) for node in range(count) if node not in held for axis in (0, 1)]
    pairs = [pair for pair in itertools.combinations(range(count), 2) if not set(pair) <= set(held)]
    pairs = [pair for pair in pairs if math.dist(places[pair[0]], places[pair[1]]) > 0.3]
    rng.shuffle(pairs)
    pairs = pairs[:max(len(free) + 1, rng.randint(min(len(free), len(pairs)), len(pairs)))]
    lines = ['name = "random"', "dimension = 2", 'units = { length = "m", force = "kN" }', "[nodes]"]
    lines += [f"n{k} = [{x}, {y}]" for k, (x, y) in enumerate(places)]
    truss = {"columns": [], "tension": [], "compression": []}
    for first, second in pairs:
        kind = rng.random()
        strong = round(10 ** rng.uniform(-0.3, 0.5), 2)
        tension = 0.0 if kind < 0.1 else strong
        compression = 0.0 if 0.1 <= kind < 0.35 else round(strong * rng.choice((1, 1, 0.4)), 2)
        length = math.dist(places[first], places[second])
        # Forces divided by lengths, whose coefficients are exact differences of coordinates.
        column = []
        for node, axis in free:
            along = Fraction(places[second][axis]) - Fraction(places[first][axis])
            column.append(along if node == second else -along if node == first else Fraction(0))
        truss["columns"].append(column)
        truss["tension"].append(tension / length)
        truss["compression"].append(compression / length)
        lines += ["[[members]]", f"yield = {{ tension = {tension}, compression = {compression} }}",
                  f'between = [["n{first}", "n{second}"]]']
    lines += ["[[supports]]", f"nodes = {json.dumps([f'n{k}' for k in held])}"]

    def load(kind, size, case=None):
        node = rng.choice([k for k in range(count) if k not in held])
        force = worded([round(rng.uniform(-size, size), 2) or 0.1, round(rng.uniform(-size, size), 2) or 0.1])
        lines.extend(["[[loads]]", f'kind = "{kind}"', f'nodes = ["n{node}"]', f"force = {force}"])
        if case:
            lines.append(f'case = "{case}"')
        return [force[axis] if at == node else 0.0 for at, axis in free]

    truss["reference"] = load("reference", 1)
    names = [None] if rng.random() < 0.7 else ["one", "two"]
    cases, groups = [], {}
    alpha = round(10 ** rng.uniform(-2, 0), 3)
    for name in names:
        case = {"name": name, "dead": [0.0] * len(free), "uncertain": []}
        if rng.random() < 0.7:
            case["dead"] = load("dead", 1.0, name)
        for k in range(rng.randint(1, 4)):
            node = rng.choice([k for k in range(count) if k not in held])
            force = worded([round(rng.uniform(-1, 1), 2) or 0.1, round(rng.uniform(-1, 1), 2) or 0.1])
            own = f"{name or 'load'} {k}"
            half_width = alpha
            if rng.random() < 0.3:
                half_width = groups[own] = round(10 ** rng.uniform(-2, 0), 3)
            lines += ["[[uncertainty]]", f'name = "{own}"', f'forces = [{{ nodes = ["n{node}"], force = {force} }}]']
            if name:
                lines.append(f'case = "{name}"')
            case["uncertain"].append(([force[axis] if at == node else 0.0 for at, axis in free], half_width))
        cases.append(case)
    total = sum(len(case["uncertain"]) for case in cases)
    arguments = ["--alpha", repr(alpha)] if len(groups) < total else []
    if groups:
        arguments += ["--group-alpha", ",".join(f"{name}={half_width}" for name, half_width in groups.items())]
    return "\n".join(lines) + "\n", truss, cases, arguments


def truth(truss, cases, number=float):
    """(least, largest) over all vertices of all cases; None: some load is not carried at any factor."""
    return _in_all(factors(truss, load, number) for case in cases for load in _corners(case))


def just_carried(truss, cases):
    """True if some vertex is carried at one factor only."""
    every = [factors(truss, load, Fraction) for case in cases for load in _corners(case)]
    return any(ends is not None and ends[1] - ends[0] <= NEAR for ends in every)


def carried(result):
    """Brackets of the ends of the interval of a result, and whether it is empty; None: undecided."""
    lower, upper = result["minimum"], result["maximum"]

    def holds(one, other, relation):
        return one is not None and other is not None and relation(one["value"], other["value"])
    empty = result["carried_at_none"] or holds(lower["lower"], upper["upper"], operator.gt)
    some = holds(lower["upper"], upper["lower"], operator.le)
    return {"lower": lower, "upper": upper, "empty": True if empty else False if some else None}


def contradicts(said, true):
    """True if a bound of a result excludes an end of the interval of the vertices."""
    if true is None:
        return said["empty"] is False
    size = NEAR * (1 + max(map(abs, true)))
    if said["empty"] is (true[0] <= true[1] - size):
        return True
    return any(bound is not None and sign * (bound["value"] - value) > size
               for end, value in (("lower", true[0]), ("upper", true[1]))
               for bound, sign in ((said[end]["lower"], 1), (said[end]["upper"], -1)))


def is_tie(truss, cases):
    """True if a small change of all yield forces decides whether every vertex of a load case is carried: members have
    a limit as their only force, such as zero in a cable, and rounding of the coordinates moves it."""
    def carried(case, by):
        other = {**truss, "tension": [value + by for value in truss["tension"]],
                 "compression": [value + by for value in truss["compression"]]}
        return (all(t + c >= 0 for t, c in zip(other["tension"], other["compression"])) and
                truth(other, [case], Fraction) is not None)
    return any(carried(case, NEAR) and not carried(case, -NEAR) for case in cases)


def same(said, true):
    """True if the interval of a result is that of the vertices; None: too close to empty."""
    size = 1 + (0 if true is None else max(map(abs, true)))
    if true is None:
        return said["empty"] is True
    least, largest = true
    if abs(least - largest) <= NEAR * size:
        return None
    if said["empty"] is not (least > largest):
        return False
    if any(said[end][bound] is None for end in ("lower", "upper") for bound in ("lower", "upper")):
        return False  # not carried at any factor, or open
    return all(said[end]["lower"]["value"] - NEAR * size <= value <= said[end]["upper"]["value"] + NEAR * size and
               said[end]["upper"]["value"] - said[end]["lower"]["value"] <= NEAR * size
               for end, value in (("lower", least), ("upper", largest)))


class Kusabi:
    """Comparison for one truss."""

    def __init__(self, program, folder, text):
        self.program, self.folder = program, folder
        self.file = os.path.join(folder, "truss.toml")
        with open(self.file, "w") as file:
            file.write(text)

    def run(self, *words):
        done = subprocess.run([self.program, *words], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def limit(self, arguments):
        output = os.path.join(self.folder, "out.json")
        code, said = self.run("limit", self.file, *arguments, "--output", output,
                              "--certificate", os.path.join(self.folder, "cert"))
        if not os.path.exists(output):
            return code, None, said
        with open(output) as file:
            return code, json.load(file)["result"], said

    def verify(self):
        return self.run("verify", os.path.join(self.folder, "cert"), "--problem", self.file)


def examine(program, seed, index, counts):
    """Findings on one truss; empty: none."""
    text, truss, cases, arguments = make(seed, index)
    with tempfile.TemporaryDirectory() as folder:
        kusabi = Kusabi(program, folder, text)
        code, result, said = kusabi.limit(arguments)
        if code == 2 and "mechanism" in said:
            return count_as("mechanism", counts)
        if result is None:
            return f"exit code {code}: {said}"
        interval = carried(result)
        try:
            true = truth(truss, cases)
            agrees = same(interval, true)
            if agrees is False:
                true = truth(truss, cases, Fraction)
                agrees = same(interval, true)
        except Failed:
            return count_as("not solved here", counts)
        if agrees is None:
            return count_as("just carried", counts)
        if code == 3 and not contradicts(interval, true):
            if just_carried(truss, cases):
                return count_as("just carried", counts)
            if is_tie(truss, cases):
                return count_as("decided by rounding", counts)
            print(f"truss {index}: open, corners say {true}", flush=True)
            return count_as("open", counts)
        if not agrees or code != 0:
            return f"exit code {code}, {json.dumps(interval)}, corners say {true}"
        code, said = kusabi.verify()
        if code != 0:
            return f"its certificate is refused: {said}"
        empty = true is None or true[0] > true[1]
        wanted = "carried at no load factor" if true is None else "no load factor is carried" if empty else "every load factor from"
        if wanted not in said and not (empty and "PROVED" in said):
            return f"the certificate says something else: {said}"
        return count_as("carried at none" if true is None else "empty" if empty else
                        "with zero" if true[0] <= 0 <= true[1] else "without zero", counts)


def count_as(what, counts):
    counts[what] = counts.get(what, 0) + 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--found", help="folder for the trusses that come out wrong")
    arguments = parser.parse_args()
    wrong, counts = 0, {}
    for index in range(arguments.first, arguments.first + arguments.count):
        finding = examine(arguments.kusabi, arguments.seed, index, counts)
        if finding is None:
            continue
        wrong += 1
        print(f"truss {index}: {finding}", flush=True)
        if arguments.found:
            os.makedirs(arguments.found, exist_ok=True)
            text, _, _, words = make(arguments.seed, index)
            with open(os.path.join(arguments.found, f"truss-{index}.toml"), "w") as file:
                file.write(f"# {' '.join(words)}\n{text}")
    print(f"{arguments.count} trusses, {wrong} wrong; " + ", ".join(f"{n} {what}" for what, n in sorted(counts.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
