"""Forged certificates of limit loads: honest ones of small trusses in the plane with other cuts, nodes, collapses, claims,
half-widths and yield forces, always well-formed, with correct counts and digest.

    python3 bench/hostile/forge_limit.py --kusabi build/kusabi --count 1000 --seed 1 --found wrong/

As forge_losses.py, with the factors that a simplex method finds at each corner of the load boxes.
"""
import copy
import math
import re
import subprocess
from fractions import Fraction

import forge_losses
import forging
from forge_losses import NEAR, Truth, origin_of
from truss_certificates import Certificate


class Judge:
    """False statements of the sentence about one certificate."""

    def __init__(self, own):
        self.own, self.truth, self.checked = own, Truth(own), 0

    def interval(self, struts, number):
        """The largest of the least factors and the least of the largest ones, over all cases and loads."""
        least, most = -math.inf, math.inf
        for case in self.own.cases:
            for low, high in self.truth.ends(case, (), struts, number):
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
            widths = {column[0] for case in self.own.cases for column in case.columns} or {0.0}
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
        node, other = claim.nodes[at], self.pick(node for claim in (*self.foreign, claim) for node in claim.nodes)
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
            claim.cuts[at] = copy.deepcopy(self.pick(cut for claim in (*self.foreign, claim) for cut in claim.cuts))
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
            other.residual = True
            case.claims.append(other)
        elif what == 4:
            share = self.rng.choice((0.5, 0.9, 1.1, 2.0, 0.0))
            for member in self.own.members:
                member[4] *= share
        elif what == 5 and len(self.own.cases) > 1:
            self.own.cases.remove(case)
        else:
            return False
        return ("word", "of another", "left out", "residual added", "residual strengths", "case left out")[what]

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


def judge_of(own, origin, of_file, names):
    judged = origin_of(own, origin) if of_file else own
    return judged and Judge(judged)


if __name__ == "__main__":
    forge_losses.campaign(__doc__, honest, has_nodes, Forger, judge_of)
