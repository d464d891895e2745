"""Kusabi's certificates of limit loads and of losses: the part of second_checker.py for trusses.

Letters: B has a column for each member, a dictionary of its values by displacement; q forces of members, with B q in
equilibrium with the dead load + a factor times the reference load; u motions, x = B'u elongations. For a loss, q are
force densities and x is multiplied by the lengths, so that B is rational.
"""
import math
import re
import sys
from fractions import Fraction
from typing import NamedTuple

from second_checker import (ALL_DIGITS, INFINITE, LEAST_SHOWN, NOISE, TABLE_DIGITS, Certificate, Refused, Symmetric,
                            cover_flaw, dot, double, in_quotes, inside, integer_matrix, places_of, power_near,
                            root_above, rounded, shortest, to_integers)


def bracket(lower, upper):
    """Both bounds with so many digits that the bracket shown is at most twice as wide."""
    lower, upper = double(lower, -1), double(upper, 1)
    for digits in range(TABLE_DIGITS, ALL_DIGITS):
        places = max(places_of(lower, digits), places_of(upper, digits))
        shown = rounded(lower, -1, digits, places), rounded(upper, 1, digits, places)
        if float(shown[1]) - float(shown[0]) <= 2 * max(upper - lower, LEAST_SHOWN):
            return shown
    return shortest(lower), shortest(upper)


class Loads(NamedTuple):
    """A load case: the dead and the reference load, and uncertain columns with their half-widths, densely."""
    dead: list
    reference: list
    columns: list
    widths: list


def weighted(B, count, weights):
    """B W B' with the diagonal matrix W of weights."""
    A = [[Fraction(0)] * count for _ in range(count)]
    for b, w in zip(B, weights):
        for e, x in b.items():
            for f, y in b.items():
                A[e][f] += w * x * y
    return A


def exact_forces(B, forces, defects, weights):
    """Forces of several loads, changed such that B times the changes are the defects; the changes are least in the
    sense of the weights. None: there are none."""
    weights, found = [power_near(w) if w > 0 else Fraction(0) for w in weights], []
    A, scale = integer_matrix(weighted(B, len(defects[0]), weights))
    factor = Symmetric(A)
    for q, defect in zip(forces, defects):
        right, unit = to_integers(defect)
        x = factor.solve(right)
        if x is None:
            return None
        unit = Fraction(scale, factor.det * unit)
        found.append([each + y * unit * w for each, y, w in zip(q, elongations(B, x), weights)])
    return found


def spread(forces):
    """|q| of one member, summed over loads, rounded up where the fractions have many digits."""
    return sum(abs(x) if x.denominator.bit_length() < 2000 else Fraction(math.ceil(abs(x) * 2 ** 400), 2 ** 400)
               for x in forces)


def slacks(forces, strengths):
    """What forces of the first load, and of the others times any factors from -1 to 1, leave of the yield forces."""
    return [min(t - x, c + x) - spread(rest) for (t, c), (x, *rest) in zip(strengths, zip(*forces))]


def pairs(reader, words, below):
    """Numbers and their values."""
    found = {reader.whole(at, 0, below): reader.real(x) for at, x in zip(words[::2], words[1::2])}
    reader.check(2 * len(found) == len(words), "pairs of different numbers and their values")
    return found


def elongations(B, u):
    return [sum(x * u[e] for e, x in b.items()) for b in B]


def less_forces(B, q, f):
    """f - B q, for forces q by member."""
    f = list(f)
    for i, x in q.items():
        for e, y in B[i].items():
            f[e] -= y * x
    return f


def plus(f, factor, t):
    return [x + factor * y for x, y in zip(f, t)]


def without_small_strains(B, u):
    """u changed such that members of small elongation keep their length, by the iteration of proofs.md, "The upper
    bound". Its numbers are rounded to fractions of few digits, since the bound holds for any u."""
    x, n = elongations(B, u), len(u)
    still = [b for b, each in zip(B, x) if abs(each) * 10 ** 9 < max(map(abs, x))]
    A = weighted(still, n, [1] * len(still))
    unit = power_near(max(A[i][i] for i in range(n)) or 1) / 2 ** 60
    factor = Symmetric([[round(x / unit) + (i == j) * 2 ** 27 for j, x in enumerate(row)] for i, row in enumerate(A)])
    for _ in range(12 if min(factor.minors) > 0 else 0):
        grain = max(map(abs, u)) / 2 ** 120 or 1
        f = [round(x / unit / grain) for x in less_forces(still, dict(enumerate(elongations(still, u))), [0] * n)]
        u = [a + round(Fraction(b, factor.det)) * grain for a, b in zip(u, factor.solve(f))]
    return u


class Truss(Certificate):
    """What certificates of limit loads and of losses have in common."""

    def __init__(self, reader):
        super().__init__()
        self.cases, self.struts, self.strengths, self.B = [], False, [], []
        self.read_truss(reader)
        while reader.peek() == "case":
            name = " ".join(reader.take("case"))
            reader.check(name not in [case["name"] for case in self.cases], "another name")
            self.cases.append({"name": name, "widths": set()})
            self.read_case(reader, self.cases[-1])
        reader.take("end", count=0)
        reader.check(self.cases, "a load case")
        reader.end()

    def conclusion(self):
        """The sentence and the exit code."""
        return ("NOT PROVED", 1) if self.refusals else (self.sentence(), 0)

    def residual(self, reader, words):
        """The yield forces with the strengths of struts after buckling."""
        self.struts, after = True, reader.reals(words, len(self.B))
        reader.check(all(0 <= x <= c for x, (_, c) in zip(after, self.strengths)), "no more than the strengths")
        return [(t, x) for (t, _), x in zip(self.strengths, after)]

    def upper(self, reader, members, strengths, loads, fatal, lengths=None):
        """Reads a load and a motion. Its factor is an upper bound: proofs.md, "The upper bound". Fatal: the motion
        shows that the load is carried at no factor. Elongations are divided by the lengths."""
        load = reader.reals(reader.take("load"), len(loads.columns))
        motion, B = reader.reals(reader.take("motion"), len(loads.dead)), [self.B[i] for i in members]

        def prove():
            if any(abs(x) > width for x, width in zip(load, loads.widths)):
                raise Refused("a load outside of its half-width")
            total, reference, best = loads.dead, loads.reference, []
            for x, t in zip(load, loads.columns):
                total = plus(total, x, t)
            opposite = [[-x for x in motion]] * fatal
            for u in (each for start in (motion, *opposite) for each in (start, without_small_strains(B, start))):
                if fatal:
                    at = max(range(len(u)), key=lambda e: abs(reference[e]))
                    u[at] -= dot(reference, u) / reference[at]
                spent = sum(abs(x) * strengths[i][0 if x > 0 else 1] / (lengths[i] if lengths else 1)
                            for i, x in zip(members, elongations(B, u)))
                work, excess = dot(reference, u), spent - dot(total, u)
                if fatal and excess < 0 and work == 0:
                    best.append(-INFINITE)
                elif not fatal and work > 0:
                    best.append(excess / work)
            if not best or (not fatal and min(best) > sys.float_info.max):
                raise Refused("the motion proves no upper bound in the range of doubles")
            return min(best)
        return self.attempt(reader.at, prove)


class Limit(Truss):
    """`kusabi certificate 5 limit`."""

    def read_truss(self, reader):
        self.count = reader.one("displacements", 1)
        for _ in range(reader.one("members", 1)):
            words = reader.take("member", least=3)
            self.strengths.append(reader.reals(words[:2], 2))
            reader.check(min(self.strengths[-1]) >= 0, "yield forces >= 0")
            entries, rest = reader.groups([*words[2:], ""], 2)
            reader.check(rest == [""], "the end of the line")
            self.B.append(pairs(reader, entries, self.count))

    def read_case(self, reader, case):
        dead, reference = (reader.reals(reader.take(key), self.count) for key in ("dead", "reference"))
        reader.check(any(reference), "a reference load")
        columns = [pairs(reader, reader.take("column"), self.count) for _ in range(reader.one("uncertain"))]
        reader.check(all(x for t in columns for x in t.values()), "columns without zeros")
        columns = [[t.get(e, Fraction(0)) for e in range(self.count)] for t in columns]
        for _ in range(reader.one("names")):
            reader.take("name")
        alpha = reader.reals(reader.take("alpha", least=1))
        alpha *= len(columns) if len(alpha) == 1 and columns else 1
        reader.check(len(alpha) == max(len(columns), 1) and min(alpha) >= 0, "a half-width, or one for each column")
        case.update(widths=set(alpha), strength={}, residual={})
        strengths, at = self.strengths, "strength"
        while reader.peek() in ("claim", "residual"):
            key, words = reader.take("claim", "residual")
            if key == "residual":
                reader.check(at == "strength", "one line 'residual'")
                strengths, at = self.residual(reader, words), "residual"
                continue
            claim = reader.choice(" ".join(words), "largest", "least", "none")
            reader.check(claim not in case[at], "each claim once")
            loads = Loads(dead, [-x if claim == "least" else x for x in reference], columns, alpha)
            upper, before = self.upper(reader, range(len(self.B)), strengths, loads, claim == "none"), len(self.refusals)
            lower = self.lower(reader, strengths, loads, claim != "largest")
            if claim == "none":  # its cuts and nodes, if it has any, claim nothing
                lower, self.refusals[before:] = None, []
            case[at][claim] = lower, upper

    def lower(self, reader, strengths, loads, may_be_open):
        """Reads cuts and nodes. The least of the nodes' bounds; None: there are no nodes, which may be, or they prove
        none. The letters are those of proofs.md, "The lower bound"; needed are the alpha_j w_j, less shares of cuts."""
        # d_j and w_j: a single component is a size w_j in direction d_j = +-e.
        sizes = [abs(sum(t)) if sum(map(bool, t)) == 1 else Fraction(1) for t in loads.columns]
        directions = [[x / w for x in t] for t, w in zip(loads.columns, sizes)]
        half = [a * w for a, w in zip(loads.widths, sizes)]
        cuts, nodes, bounds, M = [], [], [], len(self.B)
        for _ in range(reader.one("cuts")):
            j, k, count, *words = reader.take("cut", least=3)
            j, k, y = reader.whole(j, 0, len(half)), reader.real(k), pairs(reader, words, M)
            reader.check(reader.whole(count) == len(y), "the number of forces")
            cuts.append((j, k, y, less_forces(self.B, y, plus(directions[j], k, loads.reference))))
        for _ in range(reader.one("nodes")):
            signs, words = reader.groups(reader.take("node"), 3)
            parts, words = reader.groups(words, 2)
            shares, (factor, *q) = pairs(reader, parts, len(cuts)), reader.reals(words, 1 + M)
            decided = {reader.whole(j, 0, len(half)): (1 if reader.choice(s, "+", "-") == "+" else -1, reader.real(nu))
                       for j, s, nu in zip(signs[::3], signs[1::3], signs[2::3])}
            reader.check(len(decided) * 3 == len(signs), "each sign once")
            nodes.append(tuple(sum(1 << j for j, (s, _) in decided.items() if s == sign) for sign in (1, -1)))
            defect = less_forces(self.B, dict(enumerate(q)), plus(loads.dead, factor, loads.reference))
            for j, (sign, nu) in decided.items():
                defect = plus(defect, sign * (half[j] + nu), directions[j])
            needed = [0 if j in decided else each for j, each in enumerate(half)]
            for c, share in shares.items():
                needed[cuts[c][0]] -= share
            good = all(x >= 0 for x in [*(nu for _, nu in decided.values()), *shares.values(), *(-x for x in needed)])
            used = [(share, *cuts[c][1:]) for c, share in shares.items()]
            bounds.append(self.attempt(reader.at, self.node_bound, good, strengths, used, factor, q, defect))
        flaw = cover_flaw(nodes) if nodes or not may_be_open else None
        if flaw:
            self.refusals.append((reader.at, re.sub("sign pattern(s?)", r"combination\1 of signs", flaw)))
        return min(bounds) if bounds and not flaw and None not in bounds else None

    def node_bound(self, good, strengths, cuts, factor, q, defect):
        """A lower bound for all loads with the decided signs: the forces of the node, and those of the cuts times their
        shares, are brought into exact equilibrium, and must then leave slack in all members."""
        if not good:
            raise Refused("a negative multiplier, or shares of cuts below the half-width of their column")
        forces = [q] + [[share * y.get(i, 0) for i in range(len(q))] for share, _, y, _ in cuts]
        defects = [defect] + [[share * x for x in rest] for share, _, _, rest in cuts]
        found = exact_forces(self.B, forces, defects, slacks(forces, strengths))
        if found is None or min(slacks(found, strengths)) < 0:
            raise Refused("in exact equilibrium the forces exceed the yield forces")
        return factor - sum(share * abs(k) for share, k, _, _ in cuts)

    def sentence(self):
        widths = set().union(*(case["widths"] for case in self.cases))
        loads = f"alpha = {shortest(*widths)}" if len(widths) == 1 else "uncertain loads within these half-widths"
        loads += f" in these {len(self.cases)} load cases" if len(self.cases) > 1 else ""
        if any("none" in case["strength"] for case in self.cases):
            return f"PROVED: for {loads} some admissible load is carried at no load factor"

        def least_of(claim, at, end):
            found = [case[at].get(claim, (None, None))[end] for case in self.cases]
            return None if None in found else min(found)
        carried, upper = "residual" if self.struts else "strength", least_of("largest", "strength", 1)
        lower, least = least_of("largest", carried, 0), least_of("least", carried, 0)
        below = max((-case["strength"]["least"][1] for case in self.cases if "least" in case["strength"]), default=None)
        if upper is None:
            return f"PROVED: for {loads} nothing is claimed"
        text = f"PROVED: the worst-case load factor for {loads} is "
        text += f"at most {rounded(upper, 1)}" if lower is None else "between {} and {}".format(*bracket(lower, upper))
        if self.struts:
            text += (", an upper value: no lower bound at residual strength is proved" if lower is None else
                     ", while no strut falls below its residual strength")
        if below is not None and below > upper:
            text += ("; there is no load factor that is carried under every admissible load: the least factor of one "
                     f"is {rounded(below, -1)} or more")
        elif None not in (below, least, lower) and -least <= lower:
            low, high = inside(-least, lower)
            text += f"; every load factor from {low} to {high} is carried under every admissible load"
            text += f", and some admissible load is carried at no factor below {rounded(below, -1)}"
        return text


class Loss(Truss):
    """`kusabi certificate 5 loss`."""

    def read_truss(self, reader):
        self.d, place, self.free, self.names = reader.one("dimension", 2, 4), [], {}, []
        self.squares, self.losses = [], []
        for n in range(reader.one("nodes", 1)):
            words = reader.take("node", count=2 * self.d)
            place.append(reader.reals(words[::2]))
            for axis, word in enumerate(words[1::2]):
                if reader.choice(word, "fixed", "free") == "free":
                    self.free[n, axis] = len(self.free)
        self.nodes = len(place)
        for _ in range(reader.one("members", 1)):
            words = reader.take("member", count=4)
            a, b = (reader.whole(word, 0, len(place)) for word in words[:2])
            along = [y - x for x, y in zip(place[a], place[b])]
            self.names.append(f"{a}-{b}")
            self.strengths.append(reader.reals(words[2:]))
            self.squares.append(dot(along, along))
            reader.check(any(along) and min(self.strengths[-1]) >= 0, "a length, and yield forces >= 0")
            self.B.append({self.free[n, axis]: sign * x for n, sign in ((a, -1), (b, 1)) for axis, x in enumerate(along)
                           if x and (n, axis) in self.free})
        # For elongations a bound below the length, for forces one above it.
        self.above, self.below = [root_above(x) for x in self.squares], [1 / root_above(1 / x) for x in self.squares]

    def set(self, reader, words):
        found = [reader.whole(word, 0, len(self.B)) for word in words[1:]]
        reader.check(words and reader.whole(words[0]) == len(found) == len(set(found)), "a count and different members")
        return found

    def add(self, reader, load, node, axis, word):
        """Adds a component to a load; what acts on supports is theirs."""
        at, x = (reader.whole(node, 0, self.nodes), axis), reader.real(word)
        if at in self.free:
            load[self.free[at]] += x

    def read_case(self, reader, case):
        loads = Loads(*([Fraction(0)] * len(self.free) for _ in range(2)), [], [])
        for key, load in (("dead", loads.dead), ("reference", loads.reference)):
            for _ in range(reader.one(key)):
                node, *words = reader.take("force", count=1 + self.d)
                for axis, word in enumerate(words):
                    self.add(reader, load, node, axis, word)
        for _ in range(reader.one("uncertain")):
            width, *words = reader.take("column", least=2)
            loads.widths.append(reader.real(width))
            components, _ = reader.groups([*words, ""], 3)
            loads.columns.append([Fraction(0)] * len(self.free))
            for node, axis, word in zip(components[::3], components[1::3], components[2::3]):
                self.add(reader, loads.columns[-1], node, reader.whole(axis, 0, self.d), word)
        reader.check(any(loads.reference) and min(loads.widths, default=0) >= 0, "a reference load, half-widths >= 0")
        case["widths"], case["strength"] = set(loads.widths), self.claim(reader, self.strengths, loads)
        if reader.peek() == "residual":
            case["residual"] = self.claim(reader, self.residual(reader, reader.take("residual")), loads)

    def claim(self, reader, strengths, loads):
        """The numbers of a claim, which are proved as they are read."""
        most, sudden = reader.take("lose", count=2)
        most, sudden = reader.whole(most, 1), reader.real(sudden)
        reader.check(sudden >= 1, "a dynamic factor of 1 or more")
        kept, words = self.set(reader, reader.take("kept")), reader.take("lost")
        fatal = words[-1:] == ["fatal"]
        lost = self.set(reader, words[:len(words) - fatal])
        reader.check(len(lost) <= most and not set(lost) & set(kept), "a loss of so many members that are not kept")
        # One sentence has the claims of all load cases.
        self.losses.append((most, sudden, set(kept)))
        if self.losses[-1] != self.losses[0]:
            self.refusals.append((reader.at, "other losses, dynamic factor or kept members than in the first claim"))
        left = [i for i in range(len(self.B)) if i not in lost]
        upper = self.upper(reader, left, strengths, loads, fatal, self.below)
        lower, supports, start = (reader.reals(reader.take("lower")) or [None])[0], [], reader.at
        for _ in range(reader.one("states", 0, 10 ** 9 if lower is not None else 1)):
            support, line, states = self.set(reader, reader.take("state")), reader.at, []
            for load in [loads.dead] + [[width * x for x in t] for width, t in zip(loads.widths, loads.columns)]:
                factor, count, *words = reader.take("forces", least=2)
                q = pairs(reader, words, len(self.B))
                reader.check(reader.whole(count) == len(q) and set(q) <= set(support), "forces of the support")
                states.append((load, reader.real(factor), {i: x / self.above[i] for i, x in q.items()}))
            if self.attempt(line, self.carries, strengths, loads.reference, support, states, lower):
                supports.append(set(support))
        flaw = uncovered_loss(supports, set(kept), most) if lower is not None else None
        if flaw is not None:
            names = " ".join(self.names[i] for i in flaw)
            self.refusals.append((start, f"no state remains after the loss of {names}"))
        return {"most": most, "sudden": sudden, "kept": kept, "lost": lost, "fatal": fatal, "lower": lower,
                "upper": upper}

    def carries(self, strengths, reference, support, states, lower):
        """Whether members of the support alone can carry all loads at the factor `lower`: proofs.md, "States after a
        loss". States are a load, a factor and densities, for the dead load and for each uncertain one; densities near
        them are in exact equilibrium within the yield forces."""
        forces = [[densities.get(i, Fraction(0)) for i in support] + [factor] for _, factor, densities in states]
        defects = [less_forces(self.B, densities, plus(load, factor, reference)) for load, factor, densities in states]
        slack = [max(0, x) for x in slacks(forces, [[x / self.above[i] for x in strengths[i]] for i in support])]
        B, load = [self.B[i] for i in support], {e: -x for e, x in enumerate(reference) if x}
        # At last the factors change as well: on a mechanism the loads may balance at one factor only.
        for members, weights in ((B, slack), (B, [1] * len(B)), ([*B, load], [*slack, Fraction(1, NOISE)])):
            found = exact_forces(members, forces, defects, weights) or []
            factors = [[*q, factor][len(B)] for q, (_, factor, _) in zip(found, states)]
            if found and factors[0] - spread(factors[1:]) >= lower and all(
                    x <= 0 or x * x * self.squares[i] <= strength ** 2
                    for i, (first, *others) in zip(support, zip(*found))
                    for x, strength in zip((spread(others) + first, spread(others) - first), strengths[i])):
                return True
        raise Refused("in exact equilibrium the state has a lower factor, or forces beyond the yield forces")

    def sentence(self):
        one, name = len(self.cases) == 1, self.cases[0]["name"]
        worst = min((case["strength"] for case in self.cases), key=lambda claim: claim["upper"])
        of_cases = [case["widths"] for case in self.cases]
        widths = set().union(*(each or {Fraction(0)} for each in of_cases)) if any(of_cases) else set()
        alpha = f"(alpha = {shortest(*widths)})" if len(widths) == 1 else "(uncertain loads within these half-widths)"
        proved = f"PROVED: in load case {in_quotes(name)}, " if one and name else "PROVED: "
        sudden, lost = worst["sudden"], [self.names[i] for i in worst["lost"]]

        def after(members):
            return (f"after the loss of {members}" if sudden == 1 else
                    f"after the sudden loss of {members} with dynamic factor {shortest(sudden)}")
        lost = after(" and ".join(lost)) if lost else "without any loss" if sudden == 1 else after("any member")
        if worst["fatal"]:
            load = f"some admissible dead load {alpha}" if widths else "the dead load"
            return f"{proved}{lost} {load} is carried at no load factor"
        lowers = [case.get("residual" if self.struts else "strength", {"lower": None})["lower"] for case in self.cases]
        if None in lowers:
            some = f" and under some admissible load {alpha}" if widths else ""
            return f"{proved}{lost}{some} the load factor is at most {rounded(worst['upper'], 1)}"
        kept, (low, high) = [self.names[i] for i in worst["kept"]], bracket(min(lowers), worst["upper"])
        members = "any member" if worst["most"] == 1 else f"any {worst['most']} members"
        more = f" and {len(kept) - 8} more" if len(kept) > 8 else ""
        members += f" except {' '.join(kept[:8])}{more} (kept)" if kept else ""
        text = proved + after(members) + (f" and under every admissible load {alpha}" if widths else "")
        text += "" if one else f" in each of {len(self.cases)} load cases"
        text += ", while no strut falls below its residual strength," if self.struts else ""
        return f"{text} the load factor is at least {low}; {lost} it is at most {high}"


def uncovered_loss(supports, kept, most):
    """A loss of at most `most` members that meets every support; None: there is none. More supports that are disjoint
    outside of the kept members than losses exclude it."""
    apart, seen, left = 0, set(), sorted((support - kept for support in supports), key=len)
    for support in left:
        if not support & seen:
            seen |= support
            apart += 1
    if apart > most or set() in left:
        return None
    for member in sorted(left[0]) if left else ():
        rest = uncovered_loss([support for support in supports if member not in support], kept, most - 1)
        if rest is not None:
            return [member, *rest]
        kept = kept | {member}
    return None if left else []
