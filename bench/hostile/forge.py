"""Forged certificates about contact: honest ones of small problems in the plane with other lines, theorems, totals,
loads and numbers, always well-formed, with correct counts and digest.

    python3 bench/hostile/forge.py --kusabi build/kusabi --count 2000 --seed 1 --found wrong/

The sentences of `kusabi verify` and of verify/second_checker.py, and every line that the former does not refuse, are
compared with the states of all sign patterns, by linear programs in rational numbers. Prints each false statement that is accepted, each honest certificate
that is refused, and each failure. Exit code 0: none.
"""
import copy
import hashlib
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache

import bodies
import forging
import generate_bodies
import hold
import verdicts
from compare import Kusabi
from exact_program import INFEASIBLE, Program, exact_optimum
from generate import Case
from structure import Mechanism

#: Most candidates of a problem, and forgeries of each.
MOST, EACH = 4, 50
#: Relative room of ends of ranges, whose decimals are rounded; with a total, which states have up to a tolerance.
NEAR, NEAR_TOTAL = 1e-9, 3e-5
CALLS = ("patterns --mu {mu}", "critical", "critical --cuts always", "hold --mu {mu} --grip", "hold --mu {less}", "hold --mu {mu} --total {total}", "hold", "hold --mu {mu} --cuts always", "hold --mu {mu} --total {total} --cuts always")


def _plain(rng):
    """A file of decoupled parts at integer positions: rectangles of bars, loose or on feet, and posts."""
    nodes, sections, contacts = [], [], []
    for part in range(rng.choice((1, 1, 2, 2, 3))):
        width, height, kind = rng.randint(1, 3), rng.randint(1, 2), rng.choice(("loose", "loose", "feet", "post"))
        names = [f"p{part}{i}" for i in range(4 - (kind == "post"))]
        nodes += [f"{name} = [{10 * part + x}.0, {y}.0]" for name, x, y in zip(names, (0, width, width, 0), (0, 0, height, height))]
        pairs = [[names[i], names[j]] for i in range(len(names)) for j in range(i) if kind != "post" or i == 2]
        sections += ["", "[[members]]", f"EA = {rng.choice((1.0, 2.0, 0.75))}", f"between = {pairs}".replace("'", '"')]
        if kind != "loose":
            sections += ["", "[[supports]]", f'nodes = ["{names[0]}", "{names[1]}"]']
        free = names if kind == "loose" else names[2:]
        for name in rng.sample(free, min(MOST - len(contacts) - (part == 0), len(free), rng.randint(1, 4))):
            inward, upward = (1.0 if name[-1] in ends else -1.0 for ends in ("03", "01"))
            normal = rng.choice(([0.0, upward], [inward, 0.0], [4 * inward, rng.choice((-1.0, 1.0, 2.0))]))
            contacts.append(["", "[[contact]]", f'nodes = ["{name}"]', f"normal = {normal}", f"friction_factor = {rng.choice((1.0, 1.0, 1.0, 0.0, 0.5))}"])
    head = ['name = "forged"', "dimension = 2", 'units = { length = "m", force = "kN" }', "", "[nodes]"]
    return "\n".join([*head, *nodes, *sections, *(line for each in contacts for line in each)]) + "\n"


def problem(seed, index):
    """(text of a file with loads, its states), or nothing for mechanisms and too many candidates."""
    rng = random.Random(f"forge/{seed}/{index}")
    text = _plain(rng) if index % 2 else generate_bodies.make(seed, index // 2, [*hold.KINDS, "mixture"], [1.0, 1e2]).text
    text, forces, clearances = hold.with_loads(Case("", "", 1.0, text, 1.0), rng)
    if rng.random() < 0.5:  # it presses a candidate on its obstacle: often held by itself
        own = rng.choice(bodies.Bodies(text).candidates)
        forces[1] = {(own.node, axis): -x for axis, x in enumerate(own.normal)}
        loads = '[[loads]]\nkind = "reference"\n'
        text = text[:text.index(loads)] + loads + f'nodes = ["{own.node}"]\nforce = {[-x for x in own.normal]}\n'
    try:
        return (text, Truth(text, forces, clearances)) if len(clearances) <= MOST else None
    except Mechanism:
        return None


class Truth(hold.Loaded):
    """States of blocks, by one program for each pattern. Answers are kept."""

    @lru_cache(10000)
    def of_structure(self, what, friction, total=None):
        """Load factors or sums at the friction coefficients of a certificate."""
        self.relative = [Fraction(mu) for mu in friction]
        return self.intervals(1, total) if what == "factors" else self.sums(1)

    @lru_cache(10000)
    def below(self, friction, block, shares, limit, contact, separated, solid, opposite):
        """True if the states below a node satisfy what its patterns have in common: wedged configurations without shares. A
        theorem with a share of the dead load says nothing of states without it.
        @param limit ("above", "below" or "equal", sum) @param solid in the interior
        @param opposite ("contact" or "separated", candidate, bound, weights of the loads): the bound is exceeded"""
        program, last = Program(), 2 * self.candidates
        numbers = [i for i in range(self.candidates) if block >> i & 1]
        margin = program.column(upper=1, cost=-float(solid))
        edges = [(program.column(upper=hold.LARGE_FORCE), i, sign * Fraction(friction[i]))
                 for i in numbers if not separated >> i & 1 for sign in ((1, -1) if friction[i] else (0,))]
        modes = [(program.column(lower=-hold.LARGE_FORCE, upper=hold.LARGE_FORCE), k) for k in range(len(self.motions[0]))
                 if any(self.motions[row][k] for i in numbers for row in (2 * i, 2 * i + 1))]
        loads = [(program.column(upper=1), Fraction(dead), Fraction(reference)) for dead, reference in shares]
        some = [load for load in loads if load[1]] or [load for load in loads if load[2]] or loads or edges
        sums = {j: 1 for j, *_ in edges}
        if not some:
            return False

        def row(senses, terms, room=hold.ROOM, right=0):
            scale = max(map(abs, terms.values()), default=0) or 1
            terms = {j: Fraction(round(x / scale * hold.GRID), hold.GRID) for j, x in terms.items()}
            for sense in senses:
                program.row(sense, Fraction(right) / scale + (room if sense == "L" else -room), terms)

        def displacement(i):
            line = self.flexibility[2 * i]
            return ({j: line[2 * k] + slope * line[2 * k + 1] for j, k, slope in edges} | {j: self.motions[2 * i][k] for j, k in modes}
                    | {j: dead * (line[last] + self.clearances[i]) + reference * line[last + 1] for j, dead, reference in loads})

        for i in numbers:
            touching = contact >> i & 1
            row("LG" if touching else "G", displacement(i) | ({} if touching else {margin: -int(solid)}))
        for _, k in modes:
            row("LG", {j: self.motions[2 * i][k] + slope * self.motions[2 * i + 1][k] for j, i, slope in edges}
                | {j: dead * self.motions[last][k] + reference * self.motions[last + 1][k] for j, dead, reference in loads})
        for j in sums if solid else ():
            row("G", {j: 1, margin: -1}, 0)
        if limit and limit[0] == "except":  # a part of the dead load, and of another one
            row("G", {j: 1 for j, dead, _ in loads if dead}, 0, Fraction(1, 10 ** 6))
            some = [load for load in loads if load[2]]
        row("LG", {j: 1 for j, *_ in some}, 0, 1)
        if limit and limit[0] in ("above", "below", "equal"):
            row({"above": "G", "below": "L", "equal": "LG"}[limit[0]], sums | {j: -Fraction(limit[1]) * dead for j, dead, _ in loads}, 0)
        if opposite:
            side, candidate, bound, weights = opposite
            terms = {j: 1 for j, k, _ in edges if k == candidate} if side == "contact" else displacement(candidate)
            whole = sums | {j: Fraction(weight) for (j, *_), weight in zip(loads, weights)}
            row("G", {j: terms.get(j, 0) - Fraction(bound) * whole.get(j, 0) for j in terms | whole}, 0)
        status, value = exact_optimum(program)
        return status != INFEASIBLE and (not solid or value < -1e-18)

    def has(self, friction, block, shares=(), limit=None, contact=0, separated=0, solid=False, opposite=None):
        """True if some pattern below a node has such a state."""
        left = block & ~(contact | separated)
        one = left & -left
        return self.below(friction, block, shares, limit, contact, separated, solid, opposite) and (
            not left or self.has(friction, block, shares, limit, contact | one, separated, solid, opposite)
            or self.has(friction, block, shares, limit, contact, separated | one, solid, opposite))


def _floats(words):
    return [float.fromhex(word) for word in words]


def _words(*parts):
    return " ".join(part.hex() if isinstance(part, float) else str(part) for part in parts)


@dataclass
class Item:
    """A line: `none`, `bound` or `never`, or one of the evidence, owned by the theorem, a theorem and a state by the block, of this number."""
    kind: str
    owner: int
    shares: tuple = ()
    grip: tuple = ()
    weights: tuple = ()
    contact: int = 0
    separated: int = 0
    candidate: int = 0
    side: str = ""
    maximum: float = 1.0
    numbers: list = field(default_factory=list)

    is_state = property(lambda self: self.kind in ("wedged", "held"))
    #: Of lines of evidence with the same one the first is used.
    key = property(lambda self: (self.is_state, self.owner, self.shares, self.contact, self.separated, self.kind == "marginal"))

    @staticmethod
    def read(line):
        kind, owner, *rest = line.split()
        own = Item(kind, int(owner))
        count = {"none": int(rest.pop(0)) if kind == "none" else 0, "held": 1}.get(kind, 0)
        own.shares, rest = tuple(zip(_floats(rest[:2 * count:2]), _floats(rest[1:2 * count:2]))), rest[2 * count:]
        if kind == "none":
            if rest[:1] == ["weights"]:
                own.weights, rest = tuple(_floats(rest[1:1 + count])), rest[1 + count:]
            own.grip = tuple(float.fromhex(word) if word.startswith("0x") else word for word in rest)
        elif kind in ("bound", "never"):
            own.candidate, own.side, own.numbers = int(rest[0]), rest[1], _floats(rest[2:])
            own.maximum = own.numbers.pop(0) if kind == "bound" else 1.0
        else:
            own.contact, own.separated, own.numbers = int(rest[0], 16), int(rest[1], 16), _floats(rest[2:])
        return own

    def text(self):
        loads = [x for share in self.shares for x in share]
        words = {"none": (len(self.shares), *loads, *(("weights", *self.weights) if self.weights else ()), *self.grip), "bound": (self.candidate, self.side, self.maximum), "never": (self.candidate, self.side)}
        return _words(self.kind, self.owner, *words.get(self.kind, (*loads, f"{self.contact:x}", f"{self.separated:x}")), *self.numbers)


class Certificate:
    def __init__(self, text):
        lines = iter(text.splitlines()[2:])
        count = lambda: int(next(lines).split()[1])
        numbers = lambda: _floats(word for word in next(lines).split() if word[0] in "-0")
        self.names = [next(lines)[5:] for _ in range(count())]
        self.friction, self.blocks, rows = numbers(), [int(next(lines)[6:], 16) for _ in range(count())], range(2 * len(self.names))
        next(lines)
        self.stiffness = [numbers() for _ in rows]
        self.motions = [numbers() for _ in rows] if count() else [[] for _ in rows]
        self.loads, self.total = {}, None
        if count():
            next(lines)
            self.loads = {key: numbers() for key in ("clearance", "dead", "reference")}
            self.total = (numbers() or [None])[0]
        self.theorems, self.bounds = ([Item.read(next(lines)) for _ in range(count())] for _ in range(2))
        self.evidence = [Item.read(line) for line in list(lines)[1:-2]]

    def fit(self):
        """Makes the file well-formed: sets within blocks, and as many numbers as each line needs."""
        rows = range(len(self.motions))
        modes_of = [sum(map(any, zip(*(self.motions[row] for row in rows if block >> row // 2 & 1)))) for block in self.blocks]
        self.total = self.total if self.loads and len(self.blocks) == 1 else None
        for theorem in self.theorems:
            theorem.owner, theorem.shares = min(theorem.owner, len(self.blocks)), theorem.shares[:2] if self.loads else ()
            theorem.grip = theorem.grip if theorem.shares and self.total is None else ()
            theorem.weights = (theorem.weights + (1.0,))[:len(theorem.shares)] if theorem.weights else ()
        cuts = [None, *(len(theorem.weights) == len(theorem.shares) for theorem in self.theorems)]  # allowed
        for bound in self.bounds if self.theorems else ():
            bound.owner = min(bound.owner, len(self.theorems))
            block = self.blocks[self.theorems[bound.owner - 1].owner - 1]
            bound.candidate = bound.candidate if block >> bound.candidate & 1 else (block & -block).bit_length() - 1
        self.bounds = [bound for bound in self.bounds if self.theorems and cuts[bound.owner]]
        self.evidence = [line for line in self.evidence if line.is_state or self.theorems]
        for line in self.bounds + self.evidence:
            line.kind = "wedged" if line.kind == "held" and not self.loads else line.kind
            line.shares = (line.shares or ((1.0, 0.0),))[:1] if line.kind == "held" else ()
            line.owner = min(line.owner, len(self.blocks if line.is_state else self.theorems))
            theorem = Item("none", line.owner) if line.is_state else self.theorems[line.owner - 1]
            line.kind = "infeasible" if line.kind == "form" and theorem.shares or line.kind == "cut" and not cuts[line.owner] else line.kind
            block, modes = self.blocks[theorem.owner - 1], modes_of[theorem.owner - 1]
            m = block.bit_count()
            line.contact &= block if line.kind != "form" else 0
            line.separated = block & ~line.contact & (-1 if line.is_state else 0 if line.kind == "form" else line.separated)
            limited = theorem.grip[:1] in (("above",), ("below",)) or (self.total is not None and theorem.shares != ())
            plain = m + modes + limited
            size = {"infeasible": plain, "cut": plain + m, "never": plain + m, "bound": plain + m + 1, "marginal": 0,
                    "form": (2 + (modes > 0)) * m * m + m}.get(line.kind, line.contact.bit_count() + modes)
            line.numbers = (line.numbers + [0.0] * size)[:size]
            if line.side or line.kind == "cut":
                line.numbers[plain:] = map(abs, line.numbers[plain:])
            if line.kind == "bound":
                line.numbers[-1] = line.numbers[-1] or 1.0

    def text(self):
        """(content, {number of a line: its item})"""
        lines = ["kusabi certificate 5 contact", "dimension 2", f"candidates {len(self.names)}", *("name " + name for name in self.names),
                 _words("friction", *self.friction), f"blocks {len(self.blocks)}", *(f"block {block:x}" for block in self.blocks),
                 "stiffness", *(_words(*each) for each in self.stiffness), f"motions {len(self.motions[0])}",
                 *(_words(*each) for each in self.motions if each), "loads 2" if self.loads else "loads 0"]
        if self.loads:
            lines += ["case", *(_words(key, *each) for key, each in self.loads.items()), _words("total", *([] if self.total is None else [self.total]))]
        places = {}
        for head, items in ((f"theorems {len(self.theorems)}", self.theorems), (f"bounds {len(self.bounds)}", self.bounds), ("evidence", self.evidence)):
            places |= {len(lines) + 2 + k: item for k, item in enumerate(items)}
            lines += [head, *(item.text() for item in items)]
        content = "\n".join([*lines, f"end {len(self.evidence)}"]) + "\n"
        return content + f"digest {hashlib.sha1(content.encode()).hexdigest()}\n", places


class Forger:
    """Changes of a certificate, which return False if there is nothing to change. @param donors honest certificates"""

    def __init__(self, rng, own, donors):
        self.rng, self.own, self.donors = rng, own, donors
        self.lines = [line for each in donors for line in each.evidence]

    def pick(self, items):
        items = list(items)
        return self.rng.choice(items) if items else None

    def candidate(self):
        return 1 << self.rng.randrange(len(self.own.names))

    def number(self):
        """A load factor or sum of some certificate, or near it."""
        found = [x for item in [*self.lines, *(each for donor in self.donors for each in donor.theorems)] for x in [*(r for _, r in item.shares), *item.grip[1:]] if x != "dead"]
        return self.rng.choice([*found, 0.0, 1.0, self.rng.uniform(-3, 3)]) * self.rng.choice((1.0, 1.0, 1.0, -1.0, 1 + 1e-9, 1 - 1e-9, 1.1, 0.9, 2.0))

    def share(self):
        return self.rng.choice((0.0, 1.0)), self.rng.choice((0.0, 1.0, -1.0, self.number(), self.number()))

    def grip(self):
        return self.rng.choice(((), ("above", abs(self.number())), ("below", abs(self.number()))))

    def other(self, item, name):
        """Another value of a part of a line."""
        old, number = getattr(item, name), self.rng.choice((2.0, -1.0, 1e-3, 0.0, 1e6))
        at = self.rng.randrange(len(item.numbers) or 1)
        return {"kind": lambda: self.rng.choice(("bound", "never") if item.side else ("wedged", "held", "infeasible", "cut", "form", "marginal")),
                "owner": lambda: self.rng.randint(1, 1 + len(self.own.theorems)), "contact": lambda: old ^ self.candidate(),
                "separated": lambda: self.rng.choice((old, item.contact)) ^ self.candidate(), "candidate": lambda: self.rng.randrange(len(self.own.names)),
                "shares": lambda: self.rng.choice((old[:1], old[1:], (*old[:1], self.share()), (self.share(),), (self.share(), self.share()))),
                "grip": lambda: self.rng.choice((self.grip(), ({"above": "below", "below": "above"}[old[0]], old[1]) if old[:1] in (("above",), ("below",)) else ())),
                "weights": lambda: self.rng.choice(((), (1.0,) * len(item.shares), tuple(self.rng.choice((1.0, 1e-3, 1e3, 0.5)) * x for x in old))),
                "side": lambda: self.rng.choice(("contact", "separated")), "maximum": lambda: old * self.rng.choice((0.5, 0.99, 1 - 1e-9, 1e-3)),
                "numbers": lambda: self.rng.choice(([number * x for x in old], [float(f"{x:.4g}") for x in old], list(self.pick(self.lines).numbers),
                                                    [number * x if i == at else x for i, x in enumerate(old)]))}[name]()

    def changed(self, item):
        """(name of a part, copy with another value of it)"""
        item, parts = copy.deepcopy(item), ("kind", "owner", "shares", "contact", "separated", "numbers", "numbers")
        name = self.rng.choice({"none": ("owner", "shares", "shares", "grip", "weights")}.get(item.kind, ("kind", "candidate", "side", "maximum", "numbers") if item.side else parts))
        setattr(item, name, self.other(item, name))
        return name, item

    def change(self):
        """In place, or a copy before or after it."""
        items = self.rng.choice((self.own.evidence, self.own.evidence, self.own.theorems, self.own.bounds))
        if not items:
            return False
        at, to = self.rng.randrange(len(items)), self.rng.randint(0, len(items))
        name, item = self.changed(items[at])
        items[at:at + 1], items[to:to] = ([item], []) if item.kind == "none" or self.rng.random() < 0.7 else ([items[at]], [item])
        return f"{name} of {item.kind if item.side or item.kind == 'none' else 'evidence'}"

    def delete(self):
        """A line; a theorem with its nodes, or these remain for the next one."""
        items = self.rng.choice((self.own.evidence, self.own.theorems, self.own.bounds))
        if not items:
            return False
        at, kept = self.rng.randrange(len(items)), self.rng.random() < 0.3
        items.pop(at)
        if items is self.own.theorems:
            self.own.evidence = [line for line in self.own.evidence if line.is_state or kept or line.owner != at + 1]
            self.own.bounds = [line for line in self.own.bounds if kept or line.owner != at + 1]
            for line in self.own.bounds + self.own.evidence:
                line.owner -= not line.is_state and line.owner > at + 1

    def transplant(self):
        """A line beside another one or in its place, often a wedged state or one of the reference load alone; or a whole part; or another order."""
        part, at = self.rng.choice(("evidence", "theorems", "bounds")), self.rng.randint(0, len(self.own.evidence))
        if self.rng.random() < 0.3:
            setattr(self.own, part, copy.deepcopy(getattr(self.pick(self.donors), part)))
            return part
        if part == "bounds":
            return self.rng.shuffle(self.own.bounds) or "order of bounds" if self.own.bounds else False
        alone, held = [line for line in self.lines if line.kind == "wedged" or line.shares and not line.shares[0][0]], {line.contact for line in self.own.evidence if line.shares}
        directions = [line for line in alone if line.shares and line.contact in held] or alone
        line = copy.deepcopy(self.pick(directions if directions and part == "theorems" else self.lines))
        if line.is_state and line.shares and self.rng.random() < 0.2:
            line.shares = ((0.0, self.rng.choice((1.0, -1.0, line.shares[0][1]))),)
        self.own.evidence[at:at + self.rng.randint(0, 1)] = [line]
        return f"line {line.kind}"

    def move_node(self):
        """A node in place of all those below it, or both of its halves by the same numbers, one perhaps without a claim."""
        line, one = self.pick(line for line in self.own.evidence if not line.is_state), self.candidate()
        if not line:
            return False
        if not (line.contact | line.separated) & one:
            self.own.evidence.append(copy.deepcopy(line))
            self.own.evidence[-1].separated, line.contact = line.separated | one, line.contact | one
            line.kind = self.rng.choice((line.kind, line.kind, "marginal"))
            return "halves"
        line.contact, line.separated = line.contact & ~one, line.separated & ~one
        self.own.evidence = [each for each in self.own.evidence if each is line or each.is_state or each.owner != line.owner
                             or line.contact & ~each.contact or line.separated & ~each.separated]

    def add_theorem(self):
        """One that the nodes of another may prove, or one of them alone; or one whose nodes have no reaction, no load or no claim."""
        donor, number = self.rng.choice([self.own, *self.donors]), len(self.own.theorems) + 1
        at = self.rng.randint(1, max(1, len(donor.theorems)))
        nodes = [copy.deepcopy(line) for line in donor.evidence if not line.is_state and line.owner == at]
        is_trivial = not donor.theorems or not nodes or self.rng.random() < 0.4
        if is_trivial:
            shares = self.rng.choice(((), ((0.0, 0.0),), ((1.0, 0.0),), ((0.0, 1.0),), ((1.0, 0.0), (0.0, 0.0)), (self.share(),)))
            theorem = Item("none", self.rng.randint(1, len(self.own.blocks)), shares, self.grip())
            whole = self.own.blocks[theorem.owner - 1]
            leaves = [(0, whole), *((1 << i, whole & ((1 << i) - 1)) for i in range(len(self.own.names)) if whole >> i & 1)]
            nodes = [Item(self.rng.choice(("infeasible", "marginal", "form")), 0, contact=u, separated=r) for u, r in self.rng.choice(([(0, 0)], leaves))]
        else:
            _, theorem = self.changed(donor.theorems[at - 1])
            if self.rng.random() < 0.3:
                nodes = [nodes[0]]
                nodes[0].contact = nodes[0].separated = 0
            self.own.bounds += [copy.deepcopy(line) for line in donor.bounds if line.owner == at]
            for line in self.own.bounds[-sum(line.owner == at for line in donor.bounds) or len(self.own.bounds):]:
                line.owner = number
        self.own.theorems.append(theorem)
        for node in nodes:
            node.owner = number
        self.own.evidence += nodes
        return "trivial" if is_trivial else "by nodes of another"

    def change_problem(self):
        """The total, the friction, K, modes, blocks, loads and clearances as recorded."""
        own, what, at, loads = self.own, self.rng.randrange(10), self.rng.randrange(8), self.own.loads
        factor = self.rng.choice((1 + 2**-52, 1 + 2**-51, 1 - 1e-12, 1 + 1e-9, 1 - 1e-6, 1.001, 0.0) if what < 5 else (1 + 1e-8, 1.001, -1.0))
        part, same = self.rng.choice(("clearance", "dead", "reference")), self.pick(each for each in self.donors if each.names == own.names)
        if what < 3:
            own.total = self.rng.choice([None, *(each.total for each in self.donors), abs(self.number()) or 1.0, (own.total or 1.0) * (1 + self.rng.choice((1e-7, 1e-5)))])
        elif what < 5:
            own.friction = list(same.friction) if same and at < 3 else [factor * mu if at > 4 or at == i else mu for i, mu in enumerate(own.friction)]
        elif what == 5:
            own.stiffness = [[x * factor for x in row] for row in own.stiffness]
        elif what == 6:
            own.motions = [[factor * x if k == at else x for k, x in enumerate(row)] for row in own.motions]
        elif what == 7 and len(own.blocks) > 1:
            own.blocks[0] |= own.blocks.pop(1)
        elif loads and what > 7:
            loads |= {part: [factor * x for x in loads[part]]} if what == 8 else {"dead": loads["reference"], "reference": loads["dead"]}
        else:
            return False
        return ("total", "total", "total", "friction", "friction", "K", "modes", "blocks", "loads", "loads")[what]

    def changes(self):
        """Names of one to three changes."""
        names = forging.changed(self.rng, 3 * (self.change, self.transplant, self.add_theorem, self.change_problem) + 2 * (self.delete, self.move_node))
        self.own.fit()
        return names


def _ranges(verb, sentence):
    """Load factors that it can or cannot hold."""
    found = re.search(rf"it {verb} hold(?: these factors of the reference load)?: ([^;]+)", sentence)
    for part in found.group(1).split(", ") if found else ["0"] if f"it {verb} hold the dead load" in sentence else ():
        ends = [float(end) for end in re.findall(r"-?\d\S*", part)] or [math.inf]
        yield (-math.inf if part.startswith(("up to", "below", "all")) else ends[0]), (math.inf if part.endswith(" on") or part.startswith("above") else ends[-1])


class Judge:
    """False statements of one certificate among those that `kusabi verify` accepts."""

    def __init__(self, truth, own, output):
        self.truth, self.own, self.output, self.friction, self.checked = truth, own, output, tuple(own.friction), 0
        self.far = "displacements up to" in output  # true only for smaller ones

    def has(self, number, *words, **further):
        self.checked += 1
        return self.truth.has(self.friction, self.own.blocks[number - 1], *words, **further)

    def is_true(self, item):
        node, theorem = {"contact": item.contact, "separated": item.separated}, item
        if item.is_state:
            return self.has(item.owner, item.shares, solid=not item.shares, **node)
        theorem = self.own.theorems[item.owner - 1]
        limit = theorem.grip or (("equal", self.own.total) if self.own.total is not None and theorem.shares else None)
        if self.far or item.kind == "marginal":
            return True
        if not item.side:
            return not self.has(theorem.owner, theorem.shares, limit, **node)
        # Of all states, those without a share of the dead load and wedged configurations as well.
        limit, node = None if limit == ("except", "dead") else limit, {item.side: 1 << item.candidate}
        cones = {part: [k for k, (dead, _) in enumerate(theorem.shares) if part == "all" or part == "rays" and not dead] for part in ("all", "rays", "none")}
        return not any(self.has(theorem.owner, tuple(theorem.shares[k] for k in part), limit, **node, opposite=None if item.kind == "never" else (
            item.side, item.candidate, item.maximum * (1 + 1e-12), tuple(theorem.weights[k] for k in part))) for part in cones.values())

    def false_lines(self, places):
        refused = {int(number) for number in re.findall(r":(\d+): refused", self.output)}
        first = {item.key: number for number, item in reversed(places.items()) if item.kind != "none" and not item.side}
        yield from (f"line {number} is false: {item.text()[:60]}" for number, item in places.items() if number not in refused
                    and item.kind != "none" and (item.side or first[item.key] == number) and not self.is_true(item))

    def false_parts(self, sentence):
        """Of the conclusion."""
        said = float(re.search(r"friction (?:coefficient|given in the file):? ([^\s,;]+)", self.output).group(1))
        if any(abs(said * own.friction - mu) > 2**-50 * mu for own, mu in zip(self.truth.bodies.candidates, self.friction)):
            yield f"the friction coefficient is not {said}"
        if self.own.loads:
            yield from () if self.far else self.false_loads(sentence)
            return
        states, is_list = {line.key for line in self.own.evidence if line.is_state}, "is complete" in sentence
        if int(re.search(r"(\d+) pattern", sentence).group(1)) != len(states) or not (states or is_list):
            yield f"it has {len(states)} patterns"
        for number, block in enumerate(self.own.blocks, 1) if is_list and not self.far else ():
            lines = [line for line in self.own.evidence if line.kind == "wedged" and line.owner == number
                     or line.kind == "marginal" and self.own.theorems[line.owner - 1].owner == number]
            yield from (f"block {number} has wedged configurations with contact at {contact:x}" for contact in {part & block for part in range(block + 1)}
                        if all(line.contact & ~contact or line.separated & contact for line in lines)
                        and self.has(number, contact=contact, separated=block & ~contact))

    def false_loads(self, sentence):
        total = re.search(r"with normal reactions that add up to ([^\s,;]+)", sentence)
        if (total and float(total.group(1))) != self.own.total:
            yield f"the total is {self.own.total}"
        held, none = list(_ranges("can", sentence)), list(_ranges("cannot", sentence))
        truth = self.truth.of_structure("factors", self.friction, self.own.total) if held or none else []
        room = lambda x: 0 if math.isinf(x) else (NEAR_TOTAL if total else NEAR) * max(1, abs(x))
        yield from (f"{low} to {high} is not held: {truth}" for low, high in held if not any(a - room(a) <= low and high <= b + room(b) for a, b in truth))
        inside = ((low, high, min(room(low), (high - low) / 2), min(room(high), (high - low) / 2)) for low, high in none)
        yield from (f"{low} to {high} is held in part: {truth}" for low, high, left, right in inside
                    if any(max(a, low + left) <= min(b, high - right) for a, b in truth))
        found = re.search(r"dead load add up to (\S+) or more(?: and (\S+) or less)?(?:, those of some states to (\S+) and ([^\s;]+))?", sentence)
        if found:
            least, most, *ends = (None if x is None else float(x.strip(",;")) for x in found.groups())
            sums = self.truth.of_structure("sums", self.friction) or (math.inf, -math.inf)
            if least > sums[0] + room(sums[0]) or (most is not None and most < sums[1] - room(sums[1])) \
                    or any(x is not None and not sums[0] - room(sums[0]) <= x <= sums[1] + room(sums[1]) for x in ends):
                yield f"the sums are {sums}"


def judged(kusabi, truth, own, path, toml):
    """(outcome, false statements, number of statements compared) of a certificate."""
    content, places = own.text()
    pathlib.Path(path).write_text(content)
    done = subprocess.run([kusabi, "verify", path, "--problem", toml, "--serial"], capture_output=True, text=True, timeout=600)
    output, (second_code, second) = done.stdout + done.stderr, verdicts.of_second_checker(path)
    sentence = re.search(r"^(NOT PROVED|NOTHING PROVED|PROVED( except)?).*", output, re.M)
    if second_code not in (0, 1, 2, 3) or "Traceback" in second or "CHECKER IS WRONG" in second:
        return "failed", [f"second checker: exit code {second_code}: {second[-300:]}"], 0
    if done.returncode == 2:
        return "malformed", [] if second_code == 2 or "K is not positive definite" in second else [f"malformed, but the second checker says: {second[-300:]}"], 0
    if done.returncode not in (0, 1, 3) or not sentence or "the verification itself is wrong" in output:
        return "failed", [f"exit code {done.returncode}: {output[-300:]}"], 0
    if "K is positive definite" not in output:
        return "of another problem", [], 0
    judge = Judge(truth, own, output)
    wrong = [*judge.false_lines(places), *(judge.false_parts(sentence.group()) if sentence.group().startswith("PROVED") else ())]
    if (says := verdicts.conclusion(second)).startswith("PROVED"):  # of the numbers of the certificate, which are those of the file
        wrong += [f"second checker: {part}" for part in Judge(truth, own, output + says).false_parts(says)]
    return sentence.group(1), wrong, judge.checked


def honest(kusabi, toml, rng):
    """Certificates of one problem, by call."""
    mu, total, found = rng.choice((0.2, 0.5, 1.0, round(math.exp(rng.uniform(-1.4, 1.6)), 4))), rng.choice((1.0, rng.uniform(0.2, 3))), {}
    for call in CALLS:
        words = call.format(mu=mu, less=0.6 * mu, total=total).split()
        code, _, line = kusabi.run(words[0], toml, *words[1:], "--serial", "--certificate", os.path.join(kusabi.folder, "cert"))
        if code not in (0, 3) and toml not in line and "load" not in line and "parts" not in line:
            raise RuntimeError(f"{' '.join(words)}: exit code {code}: {line}")
        for place in sorted(pathlib.Path(kusabi.folder).glob("cert*")):
            own = Certificate(place.read_text())
            # The programs of the truth bound all reactions.
            if all(abs(x) < hold.LARGE_FORCE / 100 for line in own.evidence if line.is_state for x in line.numbers):
                found[" ".join(words) + place.suffix] = own
            place.unlink()
    return found


def main():
    asked = forging.command_line(__doc__, 2000)
    outcomes, changes, proved, foreign = Counter(), Counter(), Counter(), []
    index, left, checked, differences = -1, asked.count, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        kusabi, path, toml = Kusabi(asked.kusabi, folder), os.path.join(folder, "forged"), os.path.join(folder, "problem.toml")
        while left > 0:
            index += 1
            if (made := problem(asked.seed, index)) is None:
                continue
            pathlib.Path(toml).write_text(made[0])
            rng = random.Random(f"forged/{asked.seed}/{index}")
            originals = honest(kusabi, toml, rng)
            donors, calls = list(originals.values()), list(originals)
            for number in range(len(donors) + min(EACH, left) * bool(donors)):
                is_honest, names = number < len(donors), []
                own = copy.deepcopy(donors[number] if is_honest else rng.choice(donors + 3 * [each for each in donors if each.total]))
                if not is_honest:
                    names, left = Forger(rng, own, foreign if foreign and rng.random() < 0.15 else donors).changes(), left - 1
                outcome, wrong, lines = judged(kusabi.path, made[1], own, path, toml)
                wrong += [outcome] if is_honest and outcome not in ("PROVED", "PROVED except", "NOTHING PROVED", "failed") else []
                checked, differences = checked + lines, differences + len(wrong)
                outcomes["honest: " * is_honest + outcome] += 1
                changes.update(names)
                proved.update(names if outcome.startswith("PROVED") else [])
                if wrong:
                    asked.found.mkdir(parents=True, exist_ok=True)
                    name = f"{asked.found}/{asked.seed}-{index:05d}-{number:02d}"
                    shutil.copy(path, name + ".cert")
                    shutil.copy(toml, name + ".toml")
                    print(*(f"{name} ({', '.join(names) or calls[number]}): {line}" for line in wrong), sep="\n", flush=True)
            foreign = [*foreign, *donors][-30:]
    forging.conclude(asked.count, checked, differences, outcomes, changes, proved)


if __name__ == "__main__":
    main()
