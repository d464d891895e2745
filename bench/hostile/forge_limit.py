"""Forged certificates of limit loads: honest ones of small trusses in the plane with other cuts, nodes, collapses, claims,
half-widths and yield forces, always well-formed, with correct counts and digest.

    python3 bench/hostile/forge_limit.py --kusabi build/kusabi --count 1000 --seed 1 --found wrong/

As forge_losses.py, with the factors that a simplex method finds at each corner of the load boxes.
"""
import copy
import hashlib
import itertools
import math
import pathlib
import re
import subprocess
from dataclasses import dataclass
from fractions import Fraction

import forge_losses
import forging
from forge_losses import NEAR, ends_of, number_of, words_of


@dataclass
class Claim:
    word: str  # largest, least or none
    residual: list | None  # compression strengths of all members after buckling
    load: list
    motion: list
    cuts: list  # [column, factor, {member: force}]
    nodes: list  # [[[column, sign, multiplier]], {cut: share}, factor, forces]


@dataclass
class Case:
    name: str
    dead: list
    reference: list
    columns: list  # {displacement: size}
    names: list  # lines
    alpha: list
    claims: list


def _pairs(words):
    return dict(zip(words[::2], words[1::2]))


def _flat(pairs):
    return itertools.chain(*pairs.items())


class Certificate:
    def __init__(self, text):
        self.lines = [line.split(" ") for line in text.splitlines()[1:]]
        self.size = self.take()[0]
        self.members = [(lambda t, c, _, *words: [t, c, _pairs(words)])(*self.take()) for _ in range(self.take()[0])]
        self.cases = []
        while self.lines[0][0] == "case":
            name = " ".join(self.lines.pop(0)[1:])
            case = Case(name, self.take(), self.take(), [_pairs(self.take()) for _ in range(self.take()[0])],
                        [" ".join(self.lines.pop(0)) for _ in range(self.take()[0])], self.take(), [])
            residual = None
            while self.lines[0][0] in ("claim", "residual"):
                if self.lines[0][0] == "residual":
                    residual = self.take()
                case.claims.append(Claim(self.lines.pop(0)[1], residual, self.take(), self.take(),
                                         [(lambda j, k, _, *words: [j, k, _pairs(words)])(*self.take()) for _ in range(self.take()[0])],
                                         [self.node(self.take()) for _ in range(self.take()[0])]))
            self.cases.append(case)
        del self.lines

    def take(self):
        return [number_of(word) if word[:1] in "-0123456789" and word != "-" else word for word in self.lines.pop(0)[1:] if word]

    @staticmethod
    def node(words):
        count = words.pop(0)
        signs, words = [list(part) for part in zip(*[iter(words[:3 * count])] * 3)], words[3 * count:]
        count = words.pop(0)
        return [signs, _pairs(words[:2 * count]), words[2 * count], words[2 * count + 1:]]

    claims = property(lambda self: [claim for case in self.cases for claim in case.claims])

    def fit(self):
        """Makes the file well-formed: claims in their order, and as many numbers as each line needs."""
        members = range(len(self.members))
        size = lambda numbers, count: ([float(x) for x in numbers] + count * [0.0])[:count]
        for case in self.cases:
            columns, claims = range(len(case.columns)), []
            case.alpha = case.alpha[:1] if len(case.alpha) == 1 else [abs(x) for x in size(case.alpha, max(len(columns), 1))]
            case.alpha = [abs(x) for x in case.alpha]
            for residual in (False, True):
                own = [claim for claim in case.claims if (claim.residual is not None) == residual]
                first = next((claim for claim in own if claim.word != "least"), None)
                if first is None:
                    if not residual:
                        own[0:0] = [copy.deepcopy(case.claims[0])]
                        first = own[0]
                        first.word, first.residual = "largest", None
                    else:
                        continue
                claims += [first] + [claim for claim in own if claim.word == "least"][:first.word == "largest"]
            case.claims = claims
            strengths = next((claim.residual for claim in claims if claim.residual is not None), None)
            for claim in claims:
                if claim.residual is not None:
                    claim.residual = [min(max(x, 0.0), member[1]) for x, member in zip(size(strengths, len(members)), self.members)]
                claim.load, claim.motion = size(claim.load, len(columns)), size(claim.motion, self.size)
                kept = [c for c, cut in enumerate(claim.cuts) if cut[0] in columns]
                claim.cuts = [[j, k, {i: y for i, y in sorted(forces.items()) if i in members}] for j, k, forces in (claim.cuts[c] for c in kept)]
                for node in claim.nodes:
                    signs = {j: (j, sign, abs(nu)) for j, sign, nu in node[0] if j in columns}
                    node[0] = [list(signs[j]) for j in sorted(signs)]
                    node[1] = {kept.index(c): abs(share) for c, share in sorted(node[1].items()) if c in kept}
                    node[3] = size(node[3], len(members))

    def text(self):
        lines = ["kusabi certificate 5 limit", f"displacements {self.size}", f"members {len(self.members)}"]
        lines += [words_of("member", t, c, len(column), *_flat(column)) for t, c, column in self.members]
        for case in self.cases:
            lines += [f"case {case.name}".rstrip(), words_of("dead", *case.dead), words_of("reference", *case.reference), f"uncertain {len(case.columns)}",
                      *(words_of("column", *_flat(column)) for column in case.columns), f"names {len(case.names)}", *case.names, words_of("alpha", *case.alpha)]
            residual = None
            for claim in case.claims:
                lines += [words_of("residual", *claim.residual)] if residual is None and claim.residual is not None else []
                residual = claim.residual
                lines += [f"claim {claim.word}", words_of("load", *claim.load), words_of("motion", *claim.motion), f"cuts {len(claim.cuts)}"]
                lines += [words_of("cut", j, k, len(forces), *_flat(forces)) for j, k, forces in claim.cuts]
                lines += [f"nodes {len(claim.nodes)}"]
                lines += [words_of("node", len(signs), *itertools.chain(*signs), len(shares), *_flat(shares), factor, *forces) for signs, shares, factor, forces in claim.nodes]
        content = "\n".join([*lines, "end"]) + "\n"
        return content + f"digest {hashlib.sha1(content.encode()).hexdigest()}\n"


class Judge:
    """False statements of the sentence about one certificate."""

    def __init__(self, own):
        self.own, self.checked = own, 0

    def corners(self, case):
        widths = case.alpha * len(case.columns) if len(case.alpha) == 1 else case.alpha
        for signs in itertools.product((-1, 1), repeat=len(case.columns)):
            load = [Fraction(x) for x in case.dead]
            for sign, width, column in zip(signs, widths, case.columns):
                for e, x in column.items():
                    load[e] += sign * Fraction(width) * Fraction(x)
            yield tuple(load)

    def interval(self, struts, number):
        """The largest of the least factors and the least of the largest ones, over all cases and loads."""
        least, most = -math.inf, math.inf
        columns = tuple(tuple(Fraction(column.get(e, 0.0)) for e in range(self.own.size)) for *_, column in self.own.members)
        for case in self.own.cases:
            residual = next((claim.residual for claim in case.claims if claim.residual is not None), None) if struts else None
            compression = tuple(residual or (c for _, c, _ in self.own.members))
            for load in self.corners(case):
                low, high = ends_of(columns, tuple(t for t, *_ in self.own.members), compression, tuple(Fraction(x) for x in case.reference), load, number)
                if math.isnan(low):
                    return math.nan, math.nan
                least, most = max(least, low), min(most, high)
        return least, most

    def false_parts(self, sentence):
        struts = "while no strut" in sentence
        wrong = []
        for number in (float, Fraction):
            least, most = self.interval(False, number)
            wrong = list(self.parts(sentence, least, most, *self.interval(struts, number)))
            if math.isnan(least) or not wrong:
                return []
        return wrong

    def parts(self, sentence, least, most, least_carried, most_carried):
        self.checked += 1
        room = lambda x: NEAR * (1 + abs(x))
        if alpha := re.search(r"alpha = ([^\s;,]+)", sentence):
            widths = {x for case in self.own.cases for x in case.alpha}
            if widths != {float(alpha[1])}:
                yield f"the half-widths are {widths}"
        if "some admissible load is carried at no load factor" in sentence:
            yield from [] if most == -math.inf else [f"all loads are carried: {least}, {most}"]
            return
        if found := re.search(r" is at most ([^\s;,]+)", sentence):
            yield from [] if most <= float(found[1]) + room(float(found[1])) else [f"the largest factor is {most}"]
        if found := re.search(r" is between (\S+) and ([^\s;,]+)", sentence):
            low, high = map(float, found.groups())
            yield from [] if most <= high + room(high) else [f"the largest factor is {most}"]
            yield from [] if most_carried >= low - room(low) else [f"the largest factor is only {most_carried}"]
        if found := re.search(r"every load factor from (\S+) to (\S+) is carried", sentence):
            low, high = map(float, found.groups())
            yield from [] if least_carried <= low + room(low) and high - room(high) <= most_carried else [f"{least_carried} to {most_carried} is carried"]
        for found in re.findall(r"no factor below (\S+) is carried|the least factor of one is (\S+) or more", sentence):
            low = float(found[0] or found[1])
            yield from [] if low - room(low) <= least else [f"the least factor is {least}"]


class Forger(forge_losses.Forger):
    """Changes of a certificate, which return False if there is nothing to change. @param donors honest certificates"""

    def __init__(self, rng, own, donors):
        self.rng, self.own, self.donors = rng, own, donors
        self.foreign = [claim for each in donors for claim in each.claims]

    def node(self):
        claim, what = self.pick(claim for claim in self.own.claims if claim.nodes), self.rng.randrange(8)
        if not claim:
            return False
        at = self.rng.randrange(len(claim.nodes))
        node, other = claim.nodes[at], self.pick(node for claim in self.foreign for node in claim.nodes)
        if what == 0:
            del claim.nodes[at]
        elif what == 1:
            node[2] = self.number(node[2])
        elif what == 2 and node[0]:
            self.pick(node[0])[1] = self.rng.choice("+-")
        elif what == 3 and node[0]:
            del node[0][self.rng.randrange(len(node[0]))]
        elif what == 4:
            i = self.rng.randrange(len(node[3]))
            node[3] = list(other[3]) if self.rng.random() < 0.4 else [self.number(q) if k == i else q for k, q in enumerate(node[3])]
        elif what == 5 and node[1]:
            node[1] = {c: share * self.rng.choice((1.0, 0.999, 0.5, 2.0, 0.0)) for c, share in node[1].items()}
        elif what == 6:
            claim.nodes[at:at + self.rng.randint(0, 1)] = [copy.deepcopy(other)]
        elif what == 7 and node[0]:
            self.pick(node[0])[2] += self.rng.choice((0.1, 1.0, 1e-6))
        else:
            return False
        return ("deleted", "factor", "sign", "sign left out", "forces", "shares", "of another", "multiplier")[what]

    def cut(self):
        claim, what = self.pick(claim for claim in self.own.claims if claim.cuts), self.rng.randrange(4)
        if not claim:
            return False
        cut = self.pick(claim.cuts)
        if what == 0:
            cut[1] = self.number(cut[1])
        elif what == 1 and cut[2]:
            i = self.pick(cut[2])
            cut[2][i] = self.number(cut[2][i])
        elif what == 2:
            cut[0] = self.rng.randint(0, 4)
        else:
            at = claim.cuts.index(cut)
            claim.cuts[at] = copy.deepcopy(self.pick(cut for claim in self.foreign for cut in claim.cuts))
        return ("factor", "force", "column", "of another")[what]

    def of_claim(self):
        """Evidence of another claim, or another claim for the evidence; strengths after buckling."""
        case, what, other = self.pick(self.own.cases), self.rng.randrange(6), copy.deepcopy(self.pick(self.foreign))
        claim = self.pick(case.claims)
        if what == 0:
            claim.word = self.rng.choice(("largest", "least", "none"))
        elif what == 1:
            case.claims[case.claims.index(claim)] = other
        elif what == 2 and len(case.claims) > 1:
            case.claims.remove(claim)
        elif what == 3:
            other.residual = self.rng.choice(([c for _, c, _ in self.own.members], [0.3 * c for _, c, _ in self.own.members]))
            case.claims.append(other)
        elif what == 4 and claim.residual:
            share = self.rng.choice((0.5, 0.9, 1.1, 2.0, 0.0))
            for each in case.claims:
                each.residual = each.residual and [share * x for x in each.residual]
        elif what == 5 and len(self.own.cases) > 1:
            self.own.cases.remove(case)
        else:
            return False
        return ("word", "of another", "left out", "residual added", "residual strengths", "case left out")[what]

    def problem(self):
        case, what, factor = self.pick(self.own.cases), self.rng.randrange(5), self.rng.choice((1 + 2**-52, 1 + 1e-12, 1.001, 2.0, 0.5, 0.0))
        member = self.pick(self.own.members)
        if what == 0:
            member[self.rng.choice((0, 1))] *= factor
        elif what == 1:
            e = self.pick(member[2])
            if e is None:
                return False
            member[2][e] *= factor
        elif what == 2:
            at = self.rng.randrange(len(case.alpha))
            case.alpha = [factor * x if i == at else x for i, x in enumerate(case.alpha)]
        elif what == 3 and case.columns:
            self.pick(case.columns).update({self.rng.randrange(self.own.size): factor})
        else:
            for load in self.rng.choice(((case.dead,), (case.reference,))):
                load[:] = [factor * x for x in load] if factor or load is case.dead else load
        return ("yield force", "direction", "half-width", "column", "loads")[what]

    def changes(self):
        """Names of one to three changes."""
        names = forging.changed(self.rng, (*3 * (self.node, self.node, self.cut, self.collapse, self.of_claim), self.problem, self.problem))
        self.own.fit()
        return names


def honest(kusabi, folder, text, arguments, rng):
    """Certificates of one problem, by call; the first is that of its half-widths."""
    found = {}
    for words in (arguments, ["--alpha", "0.5"], ["--alpha", "0"]):
        subprocess.run([kusabi, "limit", folder / "problem.toml", *words, "--serial", "--certificate", folder / "cert"], capture_output=True, timeout=600)
        if (folder / "cert").exists():
            found[" ".join(words)] = Certificate((folder / "cert").read_text())
            (folder / "cert").unlink()
        elif not found:
            break
    return found


def has_nodes(own):
    return any(len(claim.nodes) > 1 or claim.cuts for claim in own.claims)


def origin_of(own, origin):
    """The certificate with the truss and the loads of the problem file; nothing: it has other load cases."""
    named, judged = {case.name: case for case in origin.cases}, copy.deepcopy(own)
    judged.members = origin.members
    for case in judged.cases:
        of_file = named.get(case.name)
        if of_file is None or len(case.columns) != len(of_file.columns):
            return None
        case.dead, case.reference = of_file.dead, of_file.reference
        strengths = next((each.residual for each in of_file.claims if each.residual is not None), None)
        for claim in case.claims:
            claim.residual = claim.residual and strengths
    return judged


def judge_of(own, origin, of_file, names):
    judged = origin_of(own, origin) if of_file else own
    return judged and Judge(judged)


if __name__ == "__main__":
    forge_losses.campaign(__doc__, honest, has_nodes, Forger, judge_of)
