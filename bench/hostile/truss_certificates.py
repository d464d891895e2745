"""Certificates of trusses, which forgers read, change and write, always well-formed, with correct counts and digest."""
import hashlib
import itertools
import re
from dataclasses import dataclass, field


@dataclass
class Claim:
    """A theorem on one load case at one strength, and its evidence."""
    word: str  # largest, least or none
    residual: bool  # at residual strength
    most: int
    sudden: float
    kept: list
    lost: list
    load: list
    motion: list
    cuts: list = field(default_factory=list)  # [column, factor, {member: force}]
    nodes: list = field(default_factory=list)  # [[[column, sign, multiplier]], {cut: share}, factor, forces]
    lower: float | None = None  # with states
    states: list = field(default_factory=list)  # [support, [[factor, {member: force}] of each load]]


@dataclass
class Case:
    name: str
    dead: list  # [node, force]
    reference: list
    columns: list  # [half-width, [[node, axis, size]], name]
    claims: list


def number_of(word):
    return int(word) if word.isdigit() else float.fromhex(word) if re.fullmatch(r"-?0x[0-9a-f.]+p[-+]?\d+", word) else word


def words_of(*parts):
    return " ".join(part.hex() if isinstance(part, float) else str(part) for part in parts)


def _pairs(words):
    return dict(zip(words[::2], words[1::2]))


def _flat(pairs):
    return itertools.chain(*pairs.items())


class Certificate:
    def __init__(self, text):
        self.lines = iter(text.splitlines()[1:])
        self.dimension = self.take()[0]
        self.nodes = [list(zip(words[::2], words[1::2])) for words in self.records()]
        self.members = self.records()  # two nodes, strengths in tension, in compression, and after buckling
        self.cases = [Case(" ".join(map(str, self.take())), self.forces(), self.forces(), [self.column(words) for words in self.records()], [])
                      for _ in range(self.take()[0])]
        for _ in range(self.take()[0]):
            number, *words = self.take()
            self.cases[number - 1].claims.append(self.claim(self.cases[number - 1], *words))
        del self.lines

    def take(self):
        return [number_of(word) for word in next(self.lines).split(" ")[1:] if word]

    def records(self):
        return [self.take() for _ in range(self.take()[0])]

    def forces(self):
        return [[node, force] for node, *force in self.records()]

    @staticmethod
    def column(words):
        width, count, *words = words
        parts, name = words[:3 * count], " ".join(map(str, words[3 * count:]))
        return [width, [list(part) for part in zip(parts[::3], parts[1::3], parts[2::3])], name]

    def claim(self, case, word, at, most, sudden, _, *kept):
        claim = Claim(word, at == "residual", most, sudden, kept, self.take()[1:], self.take(), self.take())
        if word != "none" and not most:
            claim.cuts = [[j, k, _pairs(words)] for j, k, _, *words in self.records()]
            claim.nodes = [self.node(words) for words in self.records()]
        elif word != "none":
            count, *lower = self.take()
            claim.lower = (lower or [None])[0]
            for _ in range(count):
                support = self.take()[1:]
                claim.states.append([support, [[factor, _pairs(words)] for factor, _, *words in (self.take() for _ in range(1 + len(case.columns)))]])
        return claim

    @staticmethod
    def node(words):
        count = words.pop(0)
        signs, words = [list(part) for part in zip(*[iter(words[:3 * count])] * 3)], words[3 * count:]
        count = words.pop(0)
        return [signs, _pairs(words[:2 * count]), words[2 * count], words[2 * count + 1:]]

    claims = property(lambda self: [claim for case in self.cases for claim in case.claims])
    #: Number of each free displacement.
    free = property(lambda self: {place: i for i, place in enumerate(
        (n, axis) for n, node in enumerate(self.nodes) for axis, (_, word) in enumerate(node) if word == "free")})

    def fit(self):
        """Makes the file well-formed: theorems in their order and of the same losses, members in order, forces of them, and
        as many numbers as each line needs."""
        members, free, losses = range(len(self.members)), self.free, self.claims[0]
        size = lambda numbers, count: ([float(x) for x in numbers] + count * [0.0])[:count]
        most, sudden = min(max(losses.most, 1), len(members)) if losses.most else 0, losses.sudden if losses.most else 1.0
        kept = sorted(set(losses.kept) & set(members)) if losses.most else []
        for member in self.members:
            member[4] = min(max(member[4], 0.0), member[3])
        for case in self.cases:
            case.columns = [[abs(width), parts, name] for width, parts, name in
                            ([width, [part for part in parts if part[2] and (part[0], part[1]) in free], name] for width, parts, name in case.columns)]
            if not all(parts for _, parts, _ in case.columns):
                self.leave_out(case, [j for j, (_, parts, _) in enumerate(case.columns) if not parts])
            columns, claims = range(len(case.columns)), []
            for residual in (False, True):
                own = [claim for claim in case.claims if claim.residual == residual]
                first = next((claim for claim in own if claim.word != "least"), None)
                if first is None and not residual:
                    first = case.claims[0]
                    first.word, first.residual = "largest", False
                    own = [claim for claim in own if claim is not first]
                if first is not None:
                    claims += [first] + [claim for claim in own if claim.word == "least"][:first.word == "largest" and not most]
            case.claims = claims
            for claim in claims:
                claim.most, claim.sudden, claim.kept = most, sudden, kept
                claim.lost = sorted(set(claim.lost) & set(members) - set(claim.kept))[:most]
                claim.load, claim.motion = size(claim.load, len(columns)), size(claim.motion, len(free))
                chosen = [c for c, cut in enumerate(claim.cuts) if cut[0] in columns]
                claim.cuts = [[j, k, {i: y for i, y in sorted(forces.items()) if i in members}] for j, k, forces in (claim.cuts[c] for c in chosen)]
                for node in claim.nodes:
                    signs = {j: (j, sign, abs(nu)) for j, sign, nu in node[0] if j in columns}
                    node[0] = [list(signs[j]) for j in sorted(signs)]
                    node[1] = {chosen.index(c): abs(share) for c, share in sorted(node[1].items()) if c in chosen}
                    node[3] = size(node[3], len(members))
                claim.lower = claim.lower if claim.states and claim.word != "none" else None
                claim.states = [] if claim.lower is None else claim.states
                for state in claim.states:
                    support = state[0] = sorted(set(state[0]) & set(members))
                    state[1] = [[factor, {i: q for i, q in sorted(forces.items()) if i in support}]
                                for factor, forces in (state[1] + (1 + len(columns)) * [[0.0, {}]])[:1 + len(columns)]]

    @staticmethod
    def leave_out(case, gone):
        """Leaves out columns with their part of the evidence."""
        case.columns = [column for j, column in enumerate(case.columns) if j not in gone]
        for claim in case.claims:
            claim.load = [x for j, x in enumerate(claim.load) if j not in gone]
            for state in claim.states:
                state[1] = [column for j, column in enumerate(state[1], -1) if j not in gone]

    def text(self):
        lines = ["kusabi certificate 5 truss", f"dimension {self.dimension}", f"nodes {len(self.nodes)}"]
        lines += [words_of("node", *itertools.chain(*node)) for node in self.nodes]
        lines += [f"members {len(self.members)}", *(words_of("member", *member) for member in self.members), f"cases {len(self.cases)}"]
        for case in self.cases:
            lines += [f"case {case.name}".rstrip()]
            for key in ("dead", "reference"):
                lines += [f"{key} {len(getattr(case, key))}", *(words_of("force", node, *force) for node, force in getattr(case, key))]
            lines += [f"uncertain {len(case.columns)}"]
            lines += [words_of("column", width, len(parts), *itertools.chain(*parts), *name.split(" ") * bool(name)) for width, parts, name in case.columns]
        lines += [f"theorems {len(self.claims)}"]
        for number, case in enumerate(self.cases, 1):
            for claim in case.claims:
                lines += self.lines_of(number, claim)
        content = "\n".join([*lines, "end"]) + "\n"
        return content + f"digest {hashlib.sha1(content.encode()).hexdigest()}\n"

    @staticmethod
    def lines_of(number, claim):
        lines = [words_of("theorem", number, claim.word, "residual" if claim.residual else "strength", claim.most, claim.sudden, len(claim.kept), *claim.kept),
                 words_of("lost", len(claim.lost), *claim.lost), words_of("load", *claim.load), words_of("motion", *claim.motion)]
        if claim.word == "none":
            return lines
        if claim.most:
            lines += [words_of("states", len(claim.states), *[claim.lower] * bool(claim.states))]
            for support, columns in claim.states:
                lines += [words_of("state", len(support), *support)]
                lines += [words_of("forces", factor, len(forces), *_flat(forces)) for factor, forces in columns]
            return lines
        lines += [f"cuts {len(claim.cuts)}", *(words_of("cut", j, k, len(forces), *_flat(forces)) for j, k, forces in claim.cuts)]
        return [*lines, f"nodes {len(claim.nodes)}", *(words_of("node", len(signs), *itertools.chain(*signs), len(shares), *_flat(shares), factor, *forces)
                                                       for signs, shares, factor, forces in claim.nodes)]
