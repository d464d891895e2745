"""Forged certificates of losses of members: honest ones of small trusses in the plane with other states, losses, kept
members, factors, loads and yield forces, always well-formed, with correct counts and digest.

    python3 bench/hostile/forge_losses.py --kusabi build/kusabi --count 1000 --seed 1 --found wrong/

The sentences of `kusabi verify`, with and without the problem file, and of verify/second_checker.py are compared with
the factors that a simplex method finds for each loss and each corner of the load box alone, in rational numbers where
doubles disagree. Prints each false sentence, each honest certificate that is refused, and each failure; sentences of
both that differ are counted. Exit code 0: none.
"""
import copy
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import tempfile
from collections import Counter
from fractions import Fraction
from functools import lru_cache

import forging
import trusses
import verdicts
from truss_certificates import Certificate

#: Forgeries of each problem, most members, and most corners of the load boxes of a problem.
EACH, MOST, CORNERS = 40, 9, 16
#: Relative room of factors, whose decimals are rounded.
NEAR = 1e-9
FILE_ONLY = "with --problem"


# Correct answers ------------------------------------------------------------------------------------------------------

@lru_cache(100000)
def ends_of(columns, tension, compression, reference, load, number):
    """Least and largest factor at which a load is carried; inf, -inf: at none; not numbers: not solved."""
    truss = {"columns": columns, "tension": tension, "compression": compression, "reference": reference}
    try:
        found = trusses.factors(truss, load, number)
    except trusses.Failed:
        return math.nan, math.nan
    return (math.inf, -math.inf) if found is None else found


class Truth:
    """Factors of the truss and the loads of a certificate, with the yield forces recorded there, divided by the dynamic
    factor."""

    def __init__(self, own):
        self.own, self.free = own, own.free
        place = [[Fraction(x) for x, _ in node] for node in own.nodes]
        self.columns, self.lengths = [], []
        for a, b, *_ in own.members:
            along = [y - x for x, y in zip(place[a], place[b])]
            column = [Fraction(0)] * len(self.free)
            for node, sign in ((a, -1), (b, 1)):
                for axis, x in enumerate(along):
                    if (node, axis) in self.free:
                        column[self.free[node, axis]] += sign * x
            self.columns.append(tuple(column))
            self.lengths.append(math.sqrt(sum(x * x for x in along)))

    def load(self, forces):
        total = [Fraction(0)] * len(self.free)
        for node, force in forces:
            for axis, x in enumerate(force):
                if (node, axis) in self.free:
                    total[self.free[node, axis]] += Fraction(x)
        return total

    def corners(self, case):
        """Dead loads at the corners of the load box; 0: of no width."""
        dead = self.load(case.dead)
        columns = [[Fraction(width) * x for x in self.load([[node, [size if k == axis else 0.0 for k in range(self.own.dimension)]] for node, axis, size in parts])]
                   for width, parts, _ in case.columns]
        columns = [column for column in columns if any(column)]
        for signs in itertools.product((-1, 1), repeat=len(columns)):
            yield tuple(x + sum(sign * column[e] for sign, column in zip(signs, columns)) for e, x in enumerate(dead))

    def ends(self, case, lost, residual, number=float):
        """Least and largest factor after a loss, under each corner. @param residual at residual strength"""
        tension, compression = (tuple(0.0 if i in lost else (t, c, r)[k] / self.own.claims[0].sudden / self.lengths[i]
                                      for i, (_, _, t, c, r) in enumerate(self.own.members)) for k in (0, 1 + residual))
        for corner in self.corners(case):
            yield ends_of(tuple(self.columns), tension, compression, tuple(self.load(case.reference)), corner, number)

    def after(self, case, lost, residual, number=float):
        """The largest ones alone."""
        return (most for _, most in self.ends(case, lost, residual, number))

    def least(self, case, losses, residual=False, below=None):
        """Least factor over all losses and loads, or, sooner, one below a number."""
        least = math.inf
        for lost in losses:
            for exact, factor in enumerate(self.after(case, lost, residual)):
                if below is not None and not factor >= below:  # in doubles
                    factor = next(itertools.islice(self.after(case, lost, residual, Fraction), exact, None))
                least = factor if math.isnan(factor) else min(least, factor)
                if not least >= (below or -math.inf):
                    return least
        return least


def _losses(members, most, kept):
    left = [i for i in range(members) if i not in kept]
    return itertools.combinations(left, min(most, len(left)))


class Judge:
    """False statements of the sentence about one certificate.

    @param names of the nodes, as in members of the sentence"""

    def __init__(self, own, names):
        self.own, self.truth, self.checked = own, Truth(own), 0
        self.members = {f"{names[a]}-{names[b]}": i for i, (a, b, *_) in enumerate(own.members)}

    def lost(self, text):
        """Members of "after the loss of a-b and c-d"."""
        found = re.search(r"loss of (.*?)(?: with dynamic factor \S+)?$", text)
        return [] if not found or found[1] == "any member" else [self.members[name] for name in found[1].split(" and ")]

    def is_at_most(self, lost, factor):
        """After this loss the factor is at most this in some case, or minus infinity: there is none."""
        self.checked += 1
        room = NEAR * (1 + abs(factor)) if math.isfinite(factor) else 0
        for number in (float, Fraction):
            found = [x for case in self.own.cases for x in self.truth.after(case, lost, False, number)]
            if any(math.isnan(x) or x <= factor + room for x in found):
                return True
        return False

    def false_parts(self, sentence):
        text = re.sub(r"^PROVED: (in load case \".*?\", )?", "", sentence)
        if re.match(r"for .* some admissible load is carried at no load factor$", text):  # no member is lost
            yield from () if self.is_at_most([], -math.inf) else ["every load is carried at some factor"]
            return
        none = re.match(r"(.*?) (some admissible dead load|the dead load) .*is carried at no load factor|(.*?) the dead load is carried at no load factor", text)
        if none:
            lost = self.lost(none[1] or none[3])
            yield from () if self.is_at_most(lost, -math.inf) else [f"it is carried after the loss of {lost}"]
            return
        both = re.match(r"after the (?:sudden )?loss of any (?:member|(\d+) members)(?: except (.*?) \(kept\))?(?: with dynamic factor \S+)?"
                        r"(?: and under .*?)?(?: in each of (\d+) load cases)?(, while no strut [^,]*,)? the load factor is at least (\S+); (.*) it is at most (\S+)$", text)
        if not both:
            lost, upper = re.match(r"(.*?)(?: and under some .*| and under the dead load as given)? the load factor is at most (\S+)$", text).groups()
            lost = self.lost(lost)
            yield from () if self.is_at_most(lost, float(upper)) else [f"it is more than {upper} after the loss of {lost}"]
            return
        most, kept, cases, struts, lower, lost, upper = both.groups()
        if int(cases or 1) != len(self.own.cases):
            yield f"it has {len(self.own.cases)} load cases"
        claim, kept = self.own.claims[0], [self.members[name] for name in (kept or "").split(" and ")[0].split()]
        if not set(kept) <= set(claim.kept) or (set(kept) != set(claim.kept) and len(kept) < 8):
            yield f"the kept members are {claim.kept}"
        room = NEAR * (1 + abs(float(lower)))
        for case in self.own.cases:
            self.checked += 1
            least = self.truth.least(case, _losses(len(self.own.members), int(most or 1), claim.kept), bool(struts), float(lower) - room)
            if least < float(lower) - room:
                yield f"a factor is {float(least)}"
        if not self.is_at_most(self.lost(lost), float(upper)):
            yield f"it is more than {upper} after the loss of {self.lost(lost)}"


# Forgeries ------------------------------------------------------------------------------------------------------------

class Forger:
    """Changes of a certificate, which return False if there is nothing to change. @param donors honest certificates"""

    def __init__(self, rng, own, donors):
        self.rng, self.own, self.donors = rng, own, donors
        self.foreign = [claim for each in donors for claim in each.claims]
        self.stressed = [state for claim in self.foreign for state in claim.states]

    def pick(self, items):
        items = list(items)
        return self.rng.choice(items) if items else None

    def member(self):
        return self.rng.randrange(len(self.own.members))

    def number(self, x):
        """A number near this one, or another one."""
        return x * self.rng.choice((1 + 1e-8, 1 + 1e-6, 1.01, 1.1, 2.0, 0.5, -1.0, 0.0)) + self.rng.choice((0.0, 0.0, 0.0, 1e-7, 0.1, -1.0))

    def claim(self):
        return self.pick(self.own.claims)

    def raise_lower(self):
        """A larger factor, perhaps with states that say the same."""
        claim = self.pick(claim for claim in self.own.claims if claim.lower is not None)
        if not claim:
            return False
        before, claim.lower = claim.lower, self.rng.choice((self.number(claim.lower), *(each.lower for each in self.foreign if each.lower is not None)))
        if self.rng.random() < 0.5:
            for _, columns in claim.states:
                columns[0][0] += max(0.0, claim.lower - before)
        return None

    def other_loss(self):
        """Other members as the worst loss, and perhaps a fatal one that is not, or the other way round."""
        claim, other, what = self.claim(), self.pick(self.foreign), self.rng.randrange(5)
        if what == 0:
            claim.lost = self.rng.sample(range(len(self.own.members)), min(len(self.own.members), self.rng.randint(0, claim.most)))
        elif what == 1:
            claim.lost, claim.word = other.lost, other.word
        elif what == 2:
            claim.word = "largest" if claim.word == "none" else "none"
        elif what == 3:
            claim.lost = claim.lost[1:]
        else:
            claim.lost, claim.word, claim.load, claim.motion = other.lost, other.word, list(other.load), list(other.motion)
        return ("members", "of another", "fatal", "fewer", "collapse of another")[what]

    def collapse(self):
        """Another motion or load of the collapse."""
        claim, other, what = self.claim(), self.pick(self.foreign), self.rng.randrange(5)
        at = self.rng.randrange(len(claim.motion) or 1)
        if what == 0:
            claim.motion = list(other.motion)
        elif what == 1:
            claim.motion = [self.number(x) if i == at else x for i, x in enumerate(claim.motion)]
        elif what == 2:
            claim.motion = [float(f"{x:.3g}") * self.rng.choice((1, -1)) for x in claim.motion]
        elif claim.load:
            claim.load = [self.rng.choice((-x, 2 * x, 0.0, x * (1 + 1e-9), x)) for x in claim.load] if what == 3 else list(other.load)
        else:
            return False
        return ("motion", "motion", "motion", "load", "load")[what]

    def state(self):
        """A state of another loss, case or truss, or with another support or other forces."""
        claim, what = self.pick(claim for claim in self.own.claims if claim.states), self.rng.randrange(9)
        if not claim:
            return False
        at = self.rng.randrange(len(claim.states))
        support, columns = claim.states[at]
        column = self.rng.choice(columns)
        if what == 0:
            del claim.states[at]
        elif what == 1:
            claim.states[at:at + self.rng.randint(0, 1)] = [copy.deepcopy(self.pick(self.stressed))]
        elif what == 2:
            support.remove(self.pick(support)) if support else support.append(self.member())
        elif what == 3:  # the force of a member is not mentioned any more, or that of all
            gone = {self.member()} if self.rng.random() < 0.6 else set(support)
            claim.states[at][0] = [i for i in support if i not in gone]
        elif what == 4:
            claim.states[at][0] = [*support, self.member()]
        elif what == 5:
            i = self.pick(column[1]) if column[1] else self.member()
            column[1][i] = self.number(column[1].get(i, 0.0))
        elif what == 6:
            column[0] = self.number(column[0])
        elif what == 7:  # the mean of two
            other = copy.deepcopy(self.rng.choice([*self.stressed, *claim.states]))
            for (_, mine), (_, theirs) in zip(columns, other[1]):
                mine.update({i: (mine.get(i, 0.0) + theirs.get(i, 0.0)) / 2 for i in [*mine, *theirs]})
            claim.states[at][0] = [*support, *other[0]]
        else:
            for each in columns:
                each[1] = {i: q * 0.5 for i, q in each[1].items()}
        return ("deleted", "of another", "smaller support", "without members", "larger support", "force", "factor", "mean", "half")[what]

    def losses(self):
        """Another number of lost members, another dynamic factor, or other kept members, of one claim or of all."""
        what, claims = self.rng.randrange(3), self.own.claims if self.rng.random() < 0.7 else [self.claim()]
        change, factor, kept = self.rng.choice((1, 1, -1, 5)), self.rng.choice((1.0, 2.0, 0.5, 1 + 2**-52, 1.5)), [self.member() for _ in range(self.rng.randint(0, 3))]
        for claim in claims:
            if what == 0:
                claim.most += change
            elif what == 1:
                claim.sudden = max(1.0, claim.sudden * factor)
            else:
                claim.kept = kept if change == 1 else [*claim.kept, *kept]
        return ("number", "dynamic factor", "kept")[what]

    def of_case(self):
        """A case or claim left out, copied, or with the claim of another; strengths after buckling."""
        case, what, other = self.pick(self.own.cases), self.rng.randrange(6), copy.deepcopy(self.pick(self.foreign))
        if what == 0 and len(self.own.cases) > 1:
            self.own.cases.remove(case)
        elif what == 1:
            donor = copy.deepcopy(self.pick(each for donor in self.donors for each in donor.cases))
            donor.name = self.rng.choice((donor.name, case.name)) if donor.name not in [each.name for each in self.own.cases] else donor.name + "x"
            self.own.cases.append(donor)
        elif what == 2:
            case.claims[self.rng.randrange(len(case.claims))] = other
        elif what == 3 and len(case.claims) > 1:
            case.claims.pop(self.rng.randint(0, 1))
        elif what == 4:
            other = copy.deepcopy(self.rng.choice([other, case.claims[0]]))
            other.residual = True
            case.claims.append(other)
        elif what == 5:
            share = self.rng.choice((0.5, 0.9, 1.1, 2.0))
            for member in self.own.members:
                member[4] *= share
        else:
            return False
        names = set()
        self.own.cases = [case for case in self.own.cases if case.name not in names and not names.add(case.name)]
        return ("left out", "added", "claim of another", "claim left out", "residual claim added", "residual strengths")[what]

    def problem(self):
        """Another truss or other loads than those of the file."""
        case, what, factor = self.pick(self.own.cases), self.rng.randrange(7), self.rng.choice((1 + 2**-52, 1 + 1e-12, 1.001, 2.0, 0.5, 0.0))
        member, node = self.pick(self.own.members), self.pick(self.own.nodes)
        if what == 0:
            member[self.rng.choice((2, 3, 4))] *= factor
        elif what == 1:
            at = self.rng.randrange(len(node))
            node[at] = (node[at][0] * factor, node[at][1])
        elif what == 2:
            at = self.rng.randrange(len(node))
            node[at] = (node[at][0], "free" if node[at][1] == "fixed" else "fixed")
        elif what == 3:
            for _, force in self.rng.choice((case.dead, case.reference)):
                force[:] = [factor * x for x in force]
        elif what == 4 and case.columns:
            self.pick(case.columns)[0] *= factor
        elif what == 5 and case.columns:
            self.own.leave_out(case, self.rng.choice(([self.rng.randrange(len(case.columns))], range(len(case.columns)))))
        elif what == 6 and case.columns:
            column = self.pick(case.columns)
            column[1] = [[node, axis, factor * x] for node, axis, x in column[1]]
        else:
            return False
        return ("yield force", "place", "support", "loads", "half-width", "column left out", "column")[what]

    def changes(self):
        """Names of one to three changes."""
        names = forging.changed(self.rng, 3 * (self.raise_lower, self.state, self.state, self.other_loss) + 2 * (self.losses, self.collapse) + (self.of_case, self.problem))
        self.own.fit()
        return names


# Problems and calls ---------------------------------------------------------------------------------------------------

def problem(seed, index):
    """(text of a file, arguments with half-widths), some with struts; nothing for many members or loads."""
    rng = random.Random(f"losses/{seed}/{index}")
    text, truss, cases, arguments = trusses.make(f"losses/{seed}", index)
    if len(truss["columns"]) > MOST or sum(2 ** len(case["uncertain"]) for case in cases) > CORNERS:
        return None
    if rng.random() < 0.25:
        text = re.sub(r"compression = (\S+) }", lambda m: f"compression = {m[1]}, residual = {round(float(m[1]) * rng.choice((0.3, 0.6, 1.0)), 2)} }}"
                      if rng.random() < 0.6 else m[0], text)
    return text, arguments


def honest(kusabi, folder, text, arguments, rng):
    """Certificates of one problem, by call; the first is that of its yield forces and half-widths."""
    found, names = {}, re.findall(r"(?m)^(n\d+) = ", text)
    calls = [["--lose", "1", *arguments], ["--lose", "2", *arguments], ["--lose", "1", "--sudden", rng.choice(("2", "1.5")), *arguments],
             ["--lose", "1", "--keep", rng.choice(names), *arguments]] + [["--lose", "1"]] * (arguments != [] and "alpha =" not in text)
    calls += [["--lose", "1", "--case", "one", *arguments]] * ('case = "one"' in text)
    for words in calls:
        subprocess.run([kusabi, "limit", folder / "problem.toml", *words, "--serial", "--certificate", folder / "cert"], capture_output=True, text=True, timeout=600)
        if not (folder / "cert").exists():
            if not found:
                break
            continue
        own = Certificate((folder / "cert").read_text())
        (folder / "cert").unlink()
        if own.claims[0].most:  # not: the nominal load is carried at no factor
            found[" ".join(words)] = own
        elif not found:
            break
    is_fatal = not any(claim.states for each in found.values() for claim in each.claims)
    return {} if is_fatal and rng.random() < 0.8 else found


def has_states(own):
    return any(claim.states for claim in own.claims)


def origin_of(own, origin):
    """The certificate with the truss and the loads of the problem file; nothing: it has other load cases."""
    named, judged = {case.name: case for case in origin.cases}, copy.deepcopy(own)
    judged.nodes, judged.members = origin.nodes, origin.members
    for case in judged.cases:
        of_file = named.get(case.name)
        if of_file is None:
            return None
        case.dead, case.reference = of_file.dead, of_file.reference
        key = lambda column: (column[2], column[1])
        widths = {repr(key(column)): column[0] for column in case.columns}
        case.columns = [[widths.get(repr(key(column)), column[0]), *column[1:]] for column in of_file.columns] if case.columns else []
    return judged


def checked(kusabi, path, file):
    """{checker: (exit code, sentence, output)}"""
    found = {"second checker": verdicts.of_second_checker(path)}
    for key, more in (("verify", ()), (FILE_ONLY, ("--problem", file))):
        run = subprocess.run([kusabi, "verify", path, "--serial", *more], capture_output=True, text=True, timeout=600)
        found[key] = run.returncode, run.stdout + run.stderr
    return {key: (code, verdicts.conclusion(output), output) for key, (code, output) in found.items()}


def judge_of(own, origin, of_file, names):
    """For the sentences about a certificate, by itself or of the problem file; nothing: not compared."""
    judged = origin_of(own, origin) if of_file else own
    return judged and Judge(judged, names if of_file else range(len(own.nodes)))


def false_statements(own, origin, names, found, judge_of):
    """False parts of the verdicts, and the number of statements compared."""
    wrong, compared = [], 0
    for checker, (code, sentence, output) in found.items():
        if code not in (0, 1, 2, 3) or "Traceback" in output or "WRONG" in output:
            wrong.append(f"{checker}: exit code {code}: {output[-300:]}")
        judge = judge_of(own, origin, checker == FILE_ONLY, names) if sentence.startswith("PROVED") else None
        if judge:
            wrong += [f"{checker}: {sentence}: {part}" for part in judge.false_parts(sentence)]
            compared += judge.checked
    return wrong, compared


def campaign(about, honest, is_preferred, forger, judge_of):
    """Runs the command line of a script.

    @param about its docstring @param honest certificates of a problem by call @param is_preferred those that are forged
           more often @param forger class of the changes @param judge_of of the sentences about a certificate"""
    asked = forging.command_line(about, 1000)
    kusabi = pathlib.Path(asked.kusabi).resolve()
    outcomes, changes, proved, foreign = Counter(), Counter(), Counter(), []
    index, left, compared, differences = -1, asked.count, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        path, file = folder / "forged", folder / "problem.toml"
        while left > 0:
            index += 1
            rng = random.Random(f"forged/{asked.seed}/{index}")
            if (made := problem(asked.seed, index)) is None:
                continue
            file.write_text(made[0])
            originals = honest(kusabi, folder, *made, rng)
            names, donors, calls = re.findall(r"(?m)^(n\d+) = ", made[0]), list(originals.values()), list(originals)
            for number in range(len(donors) + min(EACH, left) * bool(donors)):
                is_honest, what = number < len(donors), []
                own = copy.deepcopy(donors[number] if is_honest else rng.choice(donors + 3 * [*filter(is_preferred, donors)]))
                if not is_honest:
                    what, left = forger(rng, own, foreign if foreign and rng.random() < 0.15 else donors).changes(), left - 1
                path.write_text(own.text())
                found = checked(kusabi, path, file)
                wrong, count = false_statements(own, donors[0], names, found, judge_of)
                compared += count
                first, second = found["verify"], found["second checker"]
                if is_honest and any(code != 0 for code, *_ in found.values()):
                    wrong.append("an honest certificate: " + json.dumps({key: each[2][-300:] for key, each in found.items() if each[0]}))
                elif is_honest and verdicts.differ(first[1], second[1]):
                    wrong.append(f"other words: {first[1]}\n    {second[1]}")
                outcomes["checkers differ"] += first[0] != second[0]
                outcomes["honest" * is_honest or ("proved" if found[FILE_ONLY][0] == 0 else "of another problem" if first[0] == 0 else "refused")] += 1
                changes.update(what)
                proved.update(what if found[FILE_ONLY][0] == 0 else [])
                differences += len(wrong)
                if wrong:
                    asked.found.mkdir(parents=True, exist_ok=True)
                    name = f"{asked.found}/{asked.seed}-{index:05d}-{number:02d}"
                    pathlib.Path(name + ".cert").write_text(own.text())
                    pathlib.Path(name + ".toml").write_text(file.read_text())
                    print(*(f"{name} ({', '.join(what) or calls[number]}): {line}" for line in wrong), sep="\n", flush=True)
            foreign = [*foreign, *donors][-30:]
    forging.conclude(asked.count, compared, differences, outcomes, changes, proved)


if __name__ == "__main__":
    campaign(__doc__, honest, has_states, Forger, judge_of)
