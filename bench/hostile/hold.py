"""Random bodies under load: load factors that can be held, also with a given sum of the normal
reactions, the range of that sum, and the smallest friction coefficient for the dead load, by a program
for every sign pattern: in the plane linear ones in rational numbers, in space cone programs in 80
digits. Certificates of all answers are verified.

    python3 bench/hostile/hold.py --kusabi build/kusabi --count 300 --seed 1 --found wrong/
    python3 bench/hostile/hold.py --kusabi build/kusabi --count 40 --space

With --cuts always the trees, which are small, have bounds of their candidates. Prints each case in which `kusabi hold` differs. Exit code 0: none.
"""
import argparse
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import textwrap
from decimal import Decimal, localcontext
from fractions import Fraction

import bodies
import generate_bodies
import hold_space
from compare import Kusabi
from exact_program import INFEASIBLE, Program, exact_optimum
from structure import Mechanism, blocks

KINDS = ["loose-truss", "loose-mesh", "wedge", "pair", "loose-pair", "corner", "loose-corner"]
SPACE_KINDS = ["space-loose", "space-partly", "space-held", "space-pair", "space-loose-pair", "space-corner"]
#: Error of rows relative to their largest term: dependent equations of 80 digits remain consistent.
ROOM = Fraction(1, 10**24)
#: Coefficients of rows, whose largest is 1, are multiples of its inverse: times the largest force far less than the room.
GRID = 2**133
#: Largest load factor of the programs, and largest force and rigid-body displacement: with the room above, larger ones
#: could be in any state, and displacements of the inverse of the grid cancel its rounding. Forces may be ten thousand
#: times the factor, so that the limit of the factor is reached first. Ends near that limit are unbounded.
LARGE = 10**9
LARGE_FORCE = 10**13
UNBOUNDED = 10**10 / 11
#: Relative difference of ends of intervals; of those that are computed, not proved; and largest end of the latter.
NEAR = 1e-7
NEAR_COMPUTED = 1e-6
LARGE_COMPUTED = 1e8


def with_loads(case, rng):
    """The file with random loads and clearances, and the same as data: dead force, reference force, clearances."""
    text, clearances = [], []
    for line in case.text.splitlines():
        text.append(line)
        if line == "[[contact]]":
            clearance = rng.choice((0.0, 0.0, rng.uniform(-0.02, 0.05)))
            clearances.append(clearance)
            if clearance:
                text.append(f"clearance = {clearance!r}")
    contents = bodies.Bodies(case.text)
    nodes = list(contents.nodes)
    forces = []
    for kind in ("dead", "reference"):
        force = {}
        for node in rng.sample(nodes, rng.randint(1, 2)):
            value = [rng.choice((0.0, -1.0, rng.uniform(-2, 2))) for _ in range(contents.dimension - 1)]
            value.append(rng.choice((-1.0, rng.uniform(-2, 2))))
            text += ["", "[[loads]]", f'kind = "{kind}"', f'nodes = ["{node}"]', f"force = {value}"]
            for axis, part in enumerate(value):
                force[node, axis] = part
        forces.append(force)
    return "\n".join(text) + "\n", forces, clearances


class Loaded:
    """States of one structure under load."""

    #: Largest load factor with an end.
    unbounded = UNBOUNDED

    def __init__(self, text, forces, clearances):
        self.bodies = bodies.Bodies(text)
        self.candidates, self.dimension = len(self.bodies.candidates), self.bodies.dimension
        with localcontext() as context:
            context.prec = 140
            flexibility, rows = bodies.compliance(self.bodies, forces)
        size = self.dimension * self.candidates + 2
        self.flexibility = [[self.number(flexibility[i][j]) for j in range(size)] for i in range(size)]
        self.motions = [[self.number(x) for x in row] for row in rows]
        self.clearances = [self.number(x) for x in clearances]
        self.relative = [self.number(own.friction) for own in self.bodies.candidates]

    @staticmethod
    def number(value):
        """Forty digits of a decimal are enough, and shorter numbers are faster."""
        with localcontext() as context:
            context.prec = 40
            return Fraction(+value if isinstance(value, Decimal) else value)

    def program(self, mu, contacts, dead_only, total=None, undecided=()):
        """The states of one pattern, the column of the load factor, and those of the normal reactions; without the
        condition that an undecided candidate is in contact or has no reaction."""
        program = Program()
        last = 2 * self.candidates
        edges = [(program.column(upper=LARGE_FORCE), 2 * i, 2 * i + 1, sign * mu * self.relative[i]) for i in [*contacts, *undecided]
                 for sign in (1, -1)]
        modes = [program.column(lower=-LARGE_FORCE, upper=LARGE_FORCE) for _ in self.motions[0]]
        most = 0 if dead_only else LARGE
        factor = program.column(lower=-most, upper=most)
        one = program.column(lower=1, upper=1)  # of the constants: rows of nothing else are kept

        def row(sense, constant, terms):
            scale = max([abs(constant), *map(abs, terms.values())], default=0)
            if scale == 0:
                return
            terms = {j: Fraction(round(value / scale * GRID), GRID) for j, value in [*terms.items(), (one, constant)]}
            for sign in ("L", "G") if sense == "E" else (sense,):
                program.row(sign, ROOM if sign == "L" else -ROOM, terms)

        for i in range(self.candidates):
            line = self.flexibility[2 * i]
            terms = {j: line[n] + slope * line[t] for j, n, t, slope in edges}
            terms |= {j: self.motions[2 * i][k] for k, j in enumerate(modes)}
            terms[factor] = line[last + 1]
            row("E" if i in contacts else "G", line[last] + self.clearances[i], terms)
        for k in range(len(modes)):
            terms = {j: self.motions[n][k] + slope * self.motions[t][k] for j, n, t, slope in edges}
            terms[factor] = self.motions[last + 1][k]
            row("E", self.motions[last][k], terms)
        if total is not None:
            row("E", -Fraction(total), {j: Fraction(1) for j, *_ in edges})
        return program, factor, [j for j, *_ in edges]

    def has_states(self, mu, contacts, dead_only, total, undecided):
        return exact_optimum(self.program(mu, contacts, dead_only, total, undecided)[0])[0] != INFEASIBLE

    def minimum(self, of_sum, sense, mu, contacts, dead_only, total=None, undecided=()):
        """Minimum of sense times the sum of the normal reactions or the load factor; nothing without a state."""
        program, factor, normals = self.program(mu, contacts, dead_only, total, undecided)
        for column in normals if of_sum else [factor]:
            program.columns[column].cost = float(sense)
        status, value = exact_optimum(program)
        return None if status == INFEASIBLE else float(value)

    def patterns(self, mu, dead_only, total=None, contacts=(), first=0):
        """Candidates in contact of each pattern with states. All patterns of a program without states are left out."""
        undecided = range(first, self.candidates)
        if not self.has_states(mu, contacts, dead_only, total, undecided):
            return
        if not undecided:
            yield contacts
            return
        yield from self.patterns(mu, dead_only, total, (*contacts, first), first + 1)
        yield from self.patterns(mu, dead_only, total, contacts, first + 1)

    def least_sum(self, mu, sense, best=math.inf, contacts=(), first=0):
        """Least of sense times the sum of the normal reactions under the dead load, or best; by branch and bound."""
        if best < -self.unbounded:  # without end
            return best
        undecided = range(first, self.candidates)
        value = self.minimum(True, sense, mu, contacts, True, undecided=undecided)
        if value is None or value >= best:
            return best
        if not undecided:
            return value
        for touching in ((*contacts, first), contacts):
            best = self.least_sum(mu, sense, best, touching, first + 1)
        return best

    def sums(self, mu):
        """The least and the largest sum of the normal reactions under the dead load; nothing without a state."""
        least, most = float(self.least_sum(self.number(mu), 1)), -float(self.least_sum(self.number(mu), -1))
        if math.isinf(least):
            return None
        return least, math.inf if most > self.unbounded else most

    def intervals(self, mu, total=None):
        """Load factors that can be held, as a union of intervals."""
        found = []
        for contacts in self.patterns(self.number(mu), False, total):
            ends = []
            for sense in (1, -1):
                end = sense * self.minimum(False, sense, self.number(mu), contacts, False, total)
                ends.append(math.copysign(math.inf, end) if abs(end) > self.unbounded else end)
            if all(map(math.isinf, ends)):
                return [(-math.inf, math.inf)]
            found.append(tuple(ends))
        joined = []
        for low, high in sorted(found):
            if joined and low <= joined[-1][1] + NEAR * max(1, abs(low)):
                joined[-1] = (joined[-1][0], max(joined[-1][1], high))
            else:
                joined.append((low, high))
        return joined

    def is_one_part(self):
        """True if all candidates are coupled, by the compliance or by rigid-body modes."""
        size = self.dimension * self.candidates
        coupled = [[self.flexibility[i][j] or any(x and y for x, y in zip(self.motions[i], self.motions[j])) for j in range(size)]
                   for i in range(size)]
        return len(blocks(coupled, self.dimension)) == 1

    def holds(self, mu):
        """True if the dead load can be held."""
        return any(True for _ in self.patterns(self.number(mu), True))


class LoadedInSpace(Loaded):
    """The same in space."""

    unbounded = float(hold_space.UNBOUNDED)

    @staticmethod
    def number(value):
        with localcontext() as context:
            context.prec = 60
            return +value if isinstance(value, Decimal) else Decimal(value)

    def states(self, mu, contacts, dead_only, total, undecided):
        """The states as a cone program, and its rows of the load factor and of the sum of the normal reactions."""
        last = 3 * self.candidates
        touching = [*contacts, *undecided]
        rough = {i: mu * self.relative[i] for i in touching}
        columns = [3 * i + a for i in touching for a in (range(3) if rough[i] else (0,))]
        modes = len(self.motions[0])
        factor = len(columns) + modes
        states = hold_space.States(factor + 1)
        zero = Decimal(0)
        for i in range(self.candidates):
            line = self.flexibility[3 * i]
            row = [line[j] for j in columns] + self.motions[3 * i] + [zero if dead_only else line[last + 1]]
            states.add(row, line[last] + self.clearances[i], i in contacts)
        for k in range(modes):
            row = [self.motions[j][k] for j in columns] + [zero] * modes + [zero if dead_only else self.motions[last + 1][k]]
            states.add(row, self.motions[last][k], True)
        normals = [Decimal(j % 3 == 0) for j in columns] + [zero] * (modes + 1)
        if total is not None:
            states.add(normals, -Decimal(total), True)
        for i in touching:
            at = columns.index(3 * i)
            if rough[i]:
                states.cone(at, (at + 1, at + 2), rough[i])
            states.limit(at, hold_space.LARGE_FORCE, 0)
        for k in range(modes):
            states.limit(len(columns) + k, hold_space.LARGE_FORCE)
        states.limit(factor, hold_space.LARGE)
        return states, [Decimal(j == factor) for j in range(factor + 1)], normals

    def has_states(self, mu, contacts, dead_only, total, undecided):
        return self.states(mu, contacts, dead_only, total, undecided)[0].interior() is not None

    def minimum(self, of_sum, sense, mu, contacts, dead_only, total=None, undecided=()):
        states, factor, normals = self.states(mu, contacts, dead_only, total, undecided)
        value = states.maximum([-sense * x for x in (normals if of_sum else factor)])
        return None if value is None else -float(value)


def near(a, b, room=NEAR):
    return a == b or abs(a - b) <= room * max(1, abs(a), abs(b))


def value(bound, otherwise):
    return otherwise if bound is None else bound["value"]


def without_points(intervals):
    return [(low, high) for low, high in intervals if not near(low, high)]


def compare_intervals(what, result, code, truth):
    """Differences of an answer about load factors."""
    answer = result["result"]
    held = [(value(each["below"]["upper"], -math.inf), value(each["above"]["lower"], math.inf)) for each in answer["intervals"]]
    if answer["reason"] in ("supports", "wedging"):
        held = [(-math.inf, math.inf)]
    proved = all(each["standing"] == "proved" for each in answer["intervals"])
    room = NEAR if proved else NEAR_COMPUTED
    if not proved:  # inequalities hold within the rounding of the numbers, times such factors
        truth = [(-math.inf if low < -LARGE_COMPUTED else low, math.inf if high > LARGE_COMPUTED else high) for low, high in truth]
    if code == 3:
        inside = all(any(low - room * max(1, abs(low)) <= a and b <= high + room * max(1, abs(high)) for low, high in truth)
                     for a, b in held)
        return [] if inside else [f"{what}: {held} is not within {truth}"]
    one, other = without_points(held), without_points(truth)
    if len(one) != len(other) or not all(near(x, y, room) for a, b in zip(one, other) for x, y in zip(a, b)):
        return [f"{what}: {held}, but {truth}"]
    return []


def compare_sums(what, grip, truth):
    """Differences of a range of sums of normal reactions."""
    if not grip["held"]:
        return [] if truth is None else [f"{what}: no state, but {truth}"]
    if truth is None:
        return [] if grip["standing"] == "computed" else [f"{what}: {grip}, but there is no state"]
    wrong = []
    least, most = grip["minimum"], grip["maximum"]
    below, above = (None if end is None or end["standing"] != "proved" else end["value"] for end in (least["lower"], most["upper"]))
    if below is not None and below > truth[0] + NEAR * max(1, truth[0]):
        wrong.append(f"{what}: not below {below}, but {truth}")
    if grip["unbounded"]:
        if not math.isinf(truth[1]):
            wrong.append(f"{what}: no upper bound, but {truth}")
    elif above is not None and above < truth[1] - NEAR * max(1, truth[1]):
        wrong.append(f"{what}: not above {above}, but {truth}")
    elif above is not None:
        sums = value(least["upper"], math.inf), value(most["lower"], -math.inf)
        if not (near(sums[0], truth[0]) and near(sums[1], truth[1])):
            wrong.append(f"{what}: {sums[0]} to {sums[1]}, but {truth}")
    return wrong


def verify(what, kusabi, path, names):
    """Refusals of certificates."""
    wrong = []
    for name in names:
        place = os.path.join(kusabi.folder, name)
        if not os.path.exists(place):
            continue
        done = subprocess.run([kusabi.path, "verify", place, "--problem", path, "--serial"],
                              capture_output=True, text=True, timeout=300)
        if done.returncode not in (0, 3):
            wrong.append(f"{what}: verify {name}: {done.stdout.strip()[-300:]} {done.stderr.strip()[:300]}")
    return wrong


def examine(kusabi, seed, index, cuts, space):
    """(text, differences, whether the answer is open) of one case; nothing for a mechanism."""
    case = generate_bodies.make(seed, index, SPACE_KINDS if space else KINDS, [1.0, 1e2])
    rng = random.Random(f"hold/{seed}/{index}")
    text, forces, clearances = with_loads(case, rng)
    path = os.path.join(kusabi.folder, "loaded.toml")
    pathlib.Path(path).write_text(text)
    for each in pathlib.Path(kusabi.folder).glob("cert*"):
        each.unlink()
    try:
        loaded = (LoadedInSpace if space else Loaded)(text, forces, clearances)
    except Mechanism:
        return None
    wrong, open_answers = [], 0
    further = ["--certificate", os.path.join(kusabi.folder, "cert"), "--cuts", cuts]
    what = f"hold --mu {case.mu} --grip"
    code, result, line = kusabi.run("hold", path, "--mu", repr(case.mu), "--grip", *further)
    if code == 2 and "there is no load" in line:  # they act on supports alone
        return text, [], 0
    if result is None:
        return text, [f"{what}: exit code {code}: {line}"], 0
    open_answers += code == 3
    wrong += compare_intervals(what, result, code, loaded.intervals(case.mu))
    sums = loaded.sums(case.mu)
    if "grip" in result["result"]:
        wrong += compare_sums(what, result["result"]["grip"], sums)
    wrong += verify(what, kusabi, path, ["cert"])
    total = rng.uniform(0.2, 3)
    what = f"hold --mu {case.mu} --total {total!r}"
    if loaded.is_one_part():
        code, result, line = kusabi.run("hold", path, "--mu", repr(case.mu), "--total", repr(total), *further)
        if result is not None:
            open_answers += code == 3
            wrong += compare_intervals(what, result, code, loaded.intervals(case.mu, total))
            wrong += verify(what, kusabi, path, ["cert"])
        elif code != 2:
            wrong.append(f"{what}: exit code {code}: {line}")
    code, result, line = kusabi.run("hold", path, *further)
    if code == 2 and "there is no dead load" in line:  # it acts on supports alone
        return text, wrong, open_answers
    if result is None:
        return text, [*wrong, f"hold: exit code {code}: {line}"], open_answers
    low, high = (result["result"]["holding_friction"][end] for end in ("lower", "upper"))
    open_answers += code == 3
    # Near a critical coefficient the reactions grow beyond those of the programs.
    if low and low["value"] and loaded.holds(low["value"] * (1 - (1e-9 if low["standing"] == "proved" else 1e-3))):
        wrong.append(f"hold: the dead load is held at the {low['standing']} lower bound {low['value']}")
    if high and high["standing"] == "proved" and not loaded.holds(high["value"] * (1 + 1e-3)):
        wrong.append(f"hold: the dead load is not held at the upper bound {high['value']}")
    wrong += verify("hold", kusabi, path, ["cert.lower", "cert.upper"])
    return text, wrong, open_answers


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--count", type=int, default=100, help="number of cases")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--space", action="store_true", help="bodies in space, of 2 to 5 candidates")
    parser.add_argument("--cuts", default="auto", choices=["auto", "none", "always"], help="as of `kusabi hold`")
    parser.add_argument("--found", type=pathlib.Path, help="folder for the cases that differ")
    asked = parser.parse_args()
    differences = open_answers = mechanisms = 0
    with tempfile.TemporaryDirectory() as folder:
        kusabi = Kusabi(asked.kusabi, folder)
        for index in range(asked.first, asked.first + asked.count):
            result = examine(kusabi, asked.seed, index, asked.cuts, asked.space)
            if result is None:
                mechanisms += 1
                continue
            text, wrong, still_open = result
            open_answers += still_open
            differences += len(wrong)
            for line in wrong:
                print(f"{asked.seed}-{index:05d}: {line}", flush=True)
            if wrong and asked.found:
                asked.found.mkdir(parents=True, exist_ok=True)
                (asked.found / f"{asked.seed}-{index:05d}.toml").write_text(textwrap.indent("\n".join(wrong) + "\n", "# ", lambda line: True) + text)
    print(f"{asked.count} cases: {differences} differences, {open_answers} open answers, {mechanisms} mechanisms")
    sys.exit(1 if differences else 0)


if __name__ == "__main__":
    main()
