"""Kusabi's certificates of trusses: the part of second_checker.py for limit loads and losses of members.

Forces q are force densities, multiplied by the lengths of members, so that B is rational: it has a column for each
member, a dictionary of differences of coordinates by displacement. B q is in equilibrium with the dead load + a factor
times the reference load. u are motions; B'u are elongations times lengths.
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
    """A load case: the dead and the reference load, and uncertain columns t_j = w_j d_j, densely, with half-widths and
    w_j: the size of a single component in direction d_j = +-e, otherwise 1."""
    name: str
    dead: list
    reference: list
    columns: list
    widths: list
    sizes: list


class Theorem(NamedTuple):
    """The fields of a theorem, and what is proved: bounds of the factor, or None. `least`: of the opposite factor."""
    case: int
    claim: str
    at: str
    lost: list
    lower: Fraction | None
    upper: Fraction | None


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
    """`kusabi certificate 5 truss`."""

    def __init__(self, reader):
        super().__init__()
        self.read_truss(reader)
        self.cases, self.theorems, self.losses = [], [], None
        count = reader.one("cases", 1)
        for _ in range(count):
            self.cases.append(self.read_case(reader))
            name = self.cases[-1].name
            reader.check(name not in [case.name for case in self.cases[:-1]] and (name or count == 1), "another name")
        for _ in range(reader.one("theorems", 1)):
            self.theorems.append(self.read_theorem(reader))
        reader.check(self.theorems[-1].case == len(self.cases), "theorems on all load cases")
        reader.take("end", count=0)
        reader.end()

    def conclusion(self):
        """The sentence and the exit code."""
        return ("NOT PROVED", 1) if self.refusals else ((self.of_losses if self.losses[0] else self.of_loads)(), 0)

    def read_truss(self, reader):
        self.d, place, self.free, self.names = reader.one("dimension", 2, 4), [], {}, []
        self.squares, self.yields, self.B = [], {"strength": [], "residual": []}, []
        for n in range(reader.one("nodes", 1)):
            words = reader.take("node", count=2 * self.d)
            place.append(reader.reals(words[::2]))
            for axis, word in enumerate(words[1::2]):
                if reader.choice(word, "fixed", "free") == "free":
                    self.free[n, axis] = len(self.free)
        self.nodes = len(place)
        for _ in range(reader.one("members", 1)):
            words = reader.take("member", count=5)
            a, b = (reader.whole(word, 0, len(place)) for word in words[:2])
            along, (t, c, r) = [y - x for x, y in zip(place[a], place[b])], reader.reals(words[2:])
            reader.check(any(along) and min(t, r) >= 0 and r <= c, "a length, and yield forces, none above the others")
            self.names.append(f"{a}-{b}")
            self.yields["strength"].append((t, c))
            self.yields["residual"].append((t, r))
            self.squares.append(dot(along, along))
            self.B.append({self.free[n, axis]: sign * x for n, sign in ((a, -1), (b, 1)) for axis, x in enumerate(along)
                           if x and (n, axis) in self.free})
        # For elongations a bound below the length, for forces one above it; both are exact if the length is a fraction.
        roots = [Fraction(math.isqrt(x.numerator), math.isqrt(x.denominator)) for x in self.squares]
        self.above = [r if r * r == x else root_above(x) for r, x in zip(roots, self.squares)]
        self.below = [r if r * r == x else 1 / root_above(1 / x) for r, x in zip(roots, self.squares)]

    def density(self, i, q):
        """A force density near that of a force, not larger, with few digits."""
        x = q / self.above[i]
        if not x or self.above[i] ** 2 == self.squares[i]:
            return x
        grain = power_near(abs(x)) / 2 ** 64
        return int(x / grain) * grain

    def densities(self, reader, words):
        """Force densities by member: a count, members and their forces."""
        forces, rest = reader.groups([*words, ""], 2)
        reader.check(rest == [""], "the end of the line")
        return {i: self.density(i, x) for i, x in self.pairs(reader, forces, len(self.B)).items()}

    @staticmethod
    def pairs(reader, words, below):
        """Numbers and their values."""
        found = {reader.whole(at, 0, below): reader.real(x) for at, x in zip(words[::2], words[1::2])}
        reader.check(2 * len(found) == len(words), "pairs of different numbers and their values")
        return found

    def members(self, reader, words):
        found = [reader.whole(word, 0, len(self.B)) for word in words[1:]]
        good = words and reader.whole(words[0]) == len(found) and found == sorted(set(found))
        reader.check(good, "ascending members")
        return found

    def read_case(self, reader):
        name, loads = " ".join(reader.take("case")), []
        for key in ("dead", "reference"):
            loads.append([Fraction(0)] * len(self.free))
            for _ in range(reader.one(key)):
                node, *words = reader.take("force", count=1 + self.d)
                for axis, x in enumerate(reader.reals(words)):
                    at = reader.whole(node, 0, self.nodes), axis
                    if at in self.free:  # what acts on supports is theirs
                        loads[-1][self.free[at]] += x
        case = Loads(name, *loads, [], [], [])
        for _ in range(reader.one("uncertain")):
            width, *words = reader.take("column", least=2)
            parts, _ = reader.groups([*words, ""], 3)
            case.widths.append(reader.real(width))
            case.sizes.append(abs(reader.real(parts[2])) if len(parts) == 3 else Fraction(1))
            case.columns.append([Fraction(0)] * len(self.free))
            for node, axis, word in zip(parts[::3], parts[1::3], parts[2::3]):
                at, x = (reader.whole(node, 0, self.nodes), reader.whole(axis, 0, self.d)), reader.real(word)
                reader.check(x and at in self.free, "a component, not zero, on a free displacement")
                case.columns[-1][self.free[at]] += x
            reader.check(parts and case.widths[-1] >= 0, "components, and a half-width >= 0")
        reader.check(any(case.reference), "a reference load")
        return case

    def read_theorem(self, reader):
        """The fields of a theorem, which is proved as it is read."""
        number, claim, at, most, sudden, *kept = reader.take("theorem", least=6)
        number, before = reader.whole(number, 1, len(self.cases) + 1), [(0, "", ""), *self.theorems][-1]
        reader.choice(claim, "largest", "least", "none"), reader.choice(at, "strength", "residual")
        most, sudden, kept = reader.whole(most, 0, len(self.B) + 1), reader.real(sudden), self.members(reader, kept)
        reader.check(sudden >= 1 and (most or (sudden, kept) == (1, [])), "a dynamic factor, of losses")
        last, its_claim, its_strength, *_ = before
        good = not most and (number, "largest", at) == (last, its_claim, its_strength) if claim == "least" else (
            (number, at) == (last + 1, "strength") or (number, at, its_strength) == (last, "residual", "strength"))
        reader.check(good, "the theorems of each load case: largest and least, or none; then at residual strength")
        # One sentence has the theorems on all load cases.
        self.losses = self.losses or (most, sudden, kept)
        reader.check((most, sudden, kept) == self.losses, "the losses of the other theorems")
        loads, strengths = self.cases[number - 1], [(t / sudden, c / sudden) for t, c in self.yields[at]]
        if claim == "least":
            loads = loads._replace(reference=[-x for x in loads.reference])
        lost = self.members(reader, reader.take("lost"))
        reader.check(len(lost) <= most and not set(lost) & set(kept), "a loss of so many members that are not kept")
        left, lower = [i for i in range(len(self.B)) if i not in lost], None
        upper = self.upper(reader, left, strengths, loads, claim)
        if claim != "none":
            lower = self.of_states(reader, strengths, loads) if most else self.of_nodes(reader, strengths, loads, claim)
        return Theorem(number, claim, at, lost, lower, upper)

    def upper(self, reader, members, strengths, loads, claim):
        """Reads a load and a motion. Its factor is an upper bound: proofs.md, "The upper bound". `none`: the motion
        shows that the load is carried at no factor."""
        load, none = reader.reals(reader.take("load"), len(loads.columns)), claim == "none"
        motion, B = reader.reals(reader.take("motion"), len(self.free)), [self.B[i] for i in members]

        def prove():
            if any(abs(x) > width for x, width in zip(load, loads.widths)):
                raise Refused("a load outside of its half-width")
            total, reference, best = loads.dead, loads.reference, []
            for x, t in zip(load, loads.columns):
                total = plus(total, x, t)
            opposite = [[-x for x in motion]] * none
            for u in (each for start in (motion, *opposite) for each in (start, without_small_strains(B, start))):
                if none:
                    at = max(range(len(u)), key=lambda e: abs(reference[e]))
                    u[at] -= dot(reference, u) / reference[at]
                spent = sum(abs(x) * strengths[i][0 if x > 0 else 1] / self.below[i]
                            for i, x in zip(members, elongations(B, u)))
                work, excess = dot(reference, u), spent - dot(total, u)
                if none and excess < 0 and work == 0:
                    best.append(-INFINITE)
                elif not none and work > 0:
                    best.append(excess / work)
            if not best or (not none and min(best) > sys.float_info.max):
                raise Refused("the motion proves no upper bound in the range of doubles")
            return min(best)
        return self.attempt(reader.at, prove)

    def carried(self, strengths, reference, support, states, least):
        """The factor at which members of the support alone carry the first load with any share from -1 to 1 of each of
        the others: proofs.md, "The lower bound" and "States after a loss". States are a load, a factor and densities;
        densities near them are in exact equilibrium within the yield forces."""
        forces = [[densities.get(i, Fraction(0)) for i in support] + [factor] for _, factor, densities in states]
        defects = [less_forces(self.B, densities, plus(load, factor, reference)) for load, factor, densities in states]
        slack = [max(0, min(strengths[i][0] / self.above[i] - x, strengths[i][1] / self.above[i] + x) - spread(rest))
                 for i, (x, *rest) in zip(support, zip(*forces))]
        B, load = [self.B[i] for i in support], {e: -x for e, x in enumerate(reference) if x}
        # At last the factors change as well: on a mechanism the loads may balance at one factor only.
        for members, weights in ((B, slack), (B, [1] * len(B)), ([*B, load], [*slack, Fraction(1, NOISE)])):
            found = exact_forces(members, forces, defects, weights) or []
            factors = [[*q, factor][len(B)] for q, (_, factor, _) in zip(found, states)]
            bound = factors[0] - spread(factors[1:]) if found else -INFINITE
            if found and bound >= least and all(
                    x <= 0 or x * x * self.squares[i] <= strength ** 2
                    for i, (first, *others) in zip(support, zip(*found))
                    for x, strength in zip((spread(others) + first, spread(others) - first), strengths[i])):
                return bound
        raise Refused("in exact equilibrium the state has a lower factor, or forces beyond the yield forces")

    def of_states(self, reader, strengths, loads):
        """Reads states, which together are left after all losses. Their lower bound; None: there is none."""
        (most, _, kept), (count, *lower), supports, start = self.losses, reader.take("states", least=1), [], reader.at
        count, lower = reader.whole(count), reader.reals(lower)
        reader.check(len(lower) == (count > 0), "a lower bound of states")
        for _ in range(count):
            support, line, states = self.members(reader, reader.take("state")), reader.at, []
            for load in [loads.dead] + [[width * x for x in t] for width, t in zip(loads.widths, loads.columns)]:
                factor, *words = reader.take("forces", least=2)
                states.append((load, reader.real(factor), self.densities(reader, words)))
                reader.check(set(states[-1][2]) <= set(support), "forces of the support")
            if self.attempt(line, self.carried, strengths, loads.reference, support, states, *lower) is not None:
                supports.append(set(support))
        flaw = uncovered_loss(supports, set(kept), most) if count else None
        if flaw is not None:
            self.refusals.append((start, "no state remains after the loss of " + " ".join(self.names[i] for i in flaw)))
        return lower[0] if lower else None

    def of_nodes(self, reader, strengths, loads, claim):
        """Reads cuts and nodes. The least of the nodes' bounds; None: there are no nodes, which may be, or they prove
        none. The letters are those of proofs.md, "The lower bound"; needed are the alpha_j w_j, less shares of cuts."""
        directions = [[x / w for x in t] for t, w in zip(loads.columns, loads.sizes)]
        half = [a * w for a, w in zip(loads.widths, loads.sizes)]
        cuts, nodes, bounds, M = [], [], [], len(self.B)
        for _ in range(reader.one("cuts")):
            j, k, *words = reader.take("cut", least=3)
            cuts.append((reader.whole(j, 0, len(half)), reader.real(k), self.densities(reader, words)))
        for _ in range(reader.one("nodes")):
            signs, words = reader.groups(reader.take("node"), 3)
            parts, words = reader.groups(words, 2)
            shares, (factor, *q) = self.pairs(reader, parts, len(cuts)), reader.reals(words, 1 + M)
            decided = {reader.whole(j, 0, len(half)): (1 if reader.choice(s, "+", "-") == "+" else -1, reader.real(nu))
                       for j, s, nu in zip(signs[::3], signs[1::3], signs[2::3])}
            reader.check(len(decided) * 3 == len(signs), "each sign once")
            nodes.append(tuple(sum(1 << j for j, (s, _) in decided.items() if s == sign) for sign in (1, -1)))
            load, needed = loads.dead, [0 if j in decided else each for j, each in enumerate(half)]
            for j, (sign, nu) in decided.items():
                load = plus(load, sign * (half[j] + nu), directions[j])
            states = [(load, factor, {i: self.density(i, x) for i, x in enumerate(q)})]
            for c, share in shares.items():
                j, k, y = cuts[c]
                needed[j] -= share
                states.append(([share * x for x in directions[j]], share * k, {i: share * x for i, x in y.items()}))
            reader.check(min([0, *(nu for _, nu in decided.values()), *shares.values()]) >= 0, "multipliers >= 0")
            # Shares of cuts below the half-width prove nothing.
            least = INFINITE if max([0, *needed]) > 0 else -INFINITE
            bounds.append(self.attempt(reader.at, self.carried, strengths, loads.reference, range(M), states, least))
        flaw = cover_flaw(nodes) if nodes or claim == "largest" else None
        if flaw:
            self.refusals.append((reader.at, re.sub("sign pattern(s?)", r"combination\1 of signs", flaw)))
        return min(bounds) if bounds and not flaw and None not in bounds else None

    def found(self, claim, at, end):
        """The bounds of the load cases; None: there is no such theorem, or it has no such bound."""
        bounds = {each.case: each[4 + end] for each in self.theorems if (each.claim, each.at) == (claim, at)}
        return [bounds.get(case) for case in range(1, len(self.cases) + 1)]

    def of_loads(self):
        widths, struts = set().union(*(case.widths or [0] for case in self.cases)), self.struts()
        loads = f"alpha = {shortest(*widths)}" if len(widths) == 1 else "uncertain loads within these half-widths"
        loads += f" in these {len(self.cases)} load cases" if len(self.cases) > 1 else ""
        if any((theorem.claim, theorem.at) == ("none", "strength") for theorem in self.theorems):
            return f"PROVED: for {loads} some admissible load is carried at no load factor"

        def least_of(claim, at, end):
            bounds = self.found(claim, at, end)
            return None if None in bounds else min(bounds)
        carried, upper = "residual" if struts else "strength", least_of("largest", "strength", 1)
        lower, least = least_of("largest", carried, 0), least_of("least", carried, 0)
        below = max((-x for x in self.found("least", "strength", 1) if x is not None), default=None)
        text = f"PROVED: the worst-case load factor for {loads} is "
        text += f"at most {rounded(upper, 1)}" if lower is None else "between {} and {}".format(*bracket(lower, upper))
        if struts:
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

    def struts(self):
        return self.yields["strength"] != self.yields["residual"] or "residual" in [each.at for each in self.theorems]

    def of_losses(self):
        (most, sudden, kept), one, name = self.losses, len(self.cases) == 1, self.cases[0].name
        worst = min((each for each in self.theorems if each.at == "strength"), key=lambda each: each.upper)
        uncertain = any(case.columns for case in self.cases)
        widths = set().union(*(case.widths or [Fraction(0)] for case in self.cases))
        alpha = f"(alpha = {shortest(*widths)})" if len(widths) == 1 else "(uncertain loads within these half-widths)"
        proved = f"PROVED: in load case {in_quotes(name)}, " if one and name else "PROVED: "

        def after(members):
            return (f"after the loss of {members}" if sudden == 1 else
                    f"after the sudden loss of {members} with dynamic factor {shortest(sudden)}")
        lost = [self.names[i] for i in worst.lost]
        lost = after(" and ".join(lost)) if lost else "without any loss" if sudden == 1 else after("any member")
        if worst.claim == "none":
            load = f"some admissible dead load {alpha}" if uncertain else "the dead load"
            return f"{proved}{lost} {load} is carried at no load factor"
        lowers = self.found("largest", "residual" if self.struts() else "strength", 0)
        if None in lowers:
            some = f" and under some admissible load {alpha}" if uncertain else ""
            return f"{proved}{lost}{some} the load factor is at most {rounded(worst.upper, 1)}"
        kept, (low, high) = [self.names[i] for i in kept], bracket(min(lowers), worst.upper)
        members = "any member" if most == 1 else f"any {most} members"
        more = f" and {len(kept) - 8} more" if len(kept) > 8 else ""
        members += f" except {' '.join(kept[:8])}{more} (kept)" if kept else ""
        text = proved + after(members) + (f" and under every admissible load {alpha}" if uncertain else "")
        text += "" if one else f" in each of {len(self.cases)} load cases"
        text += ", while no strut falls below its residual strength," if self.struts() else ""
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
