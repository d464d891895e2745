"""Oracle for a problem file: its maximal cones at a friction coefficient, and the existence of
wedged configurations."""

from decimal import Decimal, localcontext
from itertools import product

import bodies
import cone_program
import plane
import space
import structure


class Answer:
    """cones: {(S, G): solid} over names; rays: their number, or None; undecided: reason why the
    answer is unreliable."""

    def __init__(self, cones, rays, undecided):
        self.cones, self.rays, self.undecided = cones, rays, undecided


class Oracle:
    """Compliance and blocks of one structure, computed once, and analyses of it."""

    def __init__(self, text):
        self.structure = structure.from_toml(text)
        self.d = self.structure.dimension
        self.names = [candidate[0] for candidate in self.structure.candidates]
        self.relative = [Decimal(candidate[3]) for candidate in self.structure.candidates]
        self.flexibility = structure.compliance(self.structure)
        self.blocks = structure.blocks(self.flexibility, self.d)

    def friction(self, mu):
        return [Decimal(mu) * factor for factor in self.relative]

    def block(self, numbers):
        """Compliance of the candidates `numbers` alone."""
        at = [i * self.d + a for i in numbers for a in range(self.d)]
        return [[self.flexibility[i][j] for j in at] for i in at]

    def _named(self, numbers):
        return frozenset(self.names[i] for i in numbers)

    def _of_block(self, block, mu):
        friction = self.friction(mu)
        leaves, unsure = space.enumerate_cones(self.block(block), self.d, [friction[i] for i in block])
        renamed = [tuple(frozenset(block[i] for i in part) for part in leaf[:3]) + leaf[3:] for leaf in leaves]
        return plane.maximal(renamed), unsure

    def by_programs(self, mu):
        """Block by block, by the cone program of each leaf."""
        undecided = None
        parts = []
        for block in self.blocks:
            found, unsure = self._of_block(block, mu)
            if unsure:
                undecided = f"{unsure} leaves unsure"
            if found:
                parts.append(list(found.items()))
        cones = {}
        for choice in product(*parts) if parts else ():
            pressing = frozenset().union(*(key[0] for key, _ in choice))
            parted = frozenset().union(*(key[1] for key, _ in choice))
            whole = len(pressing) + len(parted) == len(self.names)
            cones[self._named(pressing), self._named(parted)] = whole and all(solid for _, solid in choice)
        return Answer(cones, None, undecided)

    def by_rays(self, mu):
        """All blocks at once, by extremal rays; plane only."""
        found = plane.enumerate_plane(self.flexibility, self.friction(mu))
        cones = {(self._named(s), self._named(g)): solid for (s, g), solid in plane.maximal(found.leaves).items()}
        undecided = f"a displacement is {float(found.least):.1e} of its parts" if found.least < Decimal("1e-11") else None
        return Answer(cones, len(found.rays), undecided)

    def cones(self, mu):
        return self.by_rays(mu) if self.d == 2 else self.by_programs(mu)

    def wedges(self, mu):
        """True if there is a nonzero solution at mu, False if not, None if undecided."""
        if self.d == 2:
            return bool(plane.enumerate_plane(self.flexibility, self.friction(mu)).leaves)
        unsure = 0
        for block in self.blocks:
            found, undecided = self._of_block(block, mu)
            if found:
                return True
            unsure += undecided
        return None if unsure else False

    def margin(self, mu, contact):
        """t* of the leaf with `contact` (names) in the unit of its block, as (low, high); needs a single block."""
        friction = self.friction(mu)
        numbers = [self.names.index(name) for name in contact]
        apart = [i for i in range(len(self.names)) if i not in numbers]
        return cone_program.margin(self.flexibility, self.d, friction, numbers, apart)

    def block_margin(self, mu, contact, separated):
        """t* of a leaf of the block that holds `contact` and `separated`, in the unit of that block."""
        members = sorted(self.names.index(name) for name in list(contact) + list(separated))
        friction = self.friction(mu)
        local = {self.names[i]: k for k, i in enumerate(members)}
        return cone_program.margin(self.block(members), self.d, [friction[i] for i in members],
                                   sorted(local[name] for name in contact), sorted(local[name] for name in separated))


class BodiesOracle:
    """The same analyses for plane bodies of any kind, constrained or not (bodies.py)."""

    d = 2
    DIGITS = 140  # long levers and weak couplings need forty of them

    def __init__(self, text):
        self.structure = bodies.Bodies(text)
        self.names = self.structure.names
        with localcontext() as context:
            context.prec = self.DIGITS
            self.flexibility, self.motions = bodies.compliance(self.structure)
            for l in range(len(self.motions[0])):  # of the order of one
                top = max(abs(row[l]) for row in self.motions)
                for row in self.motions:
                    row[l] = row[l] / top if top else row[l]

    def _blocks(self):
        """Candidates coupled by the compliance or by an unconstrained body."""
        m = len(self.names)
        linked = lambda i, j: any(self.flexibility[2 * i + a][2 * j + b] for a in (0, 1) for b in (0, 1)) or any(
            any(self.motions[2 * i + a][l] for a in (0, 1)) and any(self.motions[2 * j + a][l] for a in (0, 1))
            for l in range(len(self.motions[0])))
        left, result = list(range(m)), []
        while left:
            block, front = [], [left.pop(0)]
            while front:
                i = front.pop()
                block.append(i)
                near = [j for j in left if linked(i, j)]
                front += near
                left = [j for j in left if j not in near]
            result.append(sorted(block))
        return result

    def _enumerate(self, mu, block):
        # The command computes the product as a double.
        friction = [Decimal(float(mu) * self.structure.candidates[i].friction) for i in block]
        at = [2 * i + a for i in block for a in (0, 1)]
        columns = [l for l in range(len(self.motions[0])) if any(self.motions[row][l] for row in at)]
        with localcontext() as context:
            context.prec = self.DIGITS
            return plane.enumerate_plane([[self.flexibility[i][j] for j in at] for i in at], friction,
                                         [[self.motions[row][l] for l in columns] for row in at] if columns else ())

    def _named(self, block, numbers):
        return frozenset(self.names[block[k]] for k in numbers)

    def cones(self, mu):
        """For `patterns`: candidates of a block that cannot wedge are inactive, even if its body
        could move away."""
        least, parts = Decimal(1), []
        for block in self._blocks():
            found = self._enumerate(mu, block)
            least = min(least, found.least)
            if found.leaves:
                parts.append([(block, key, solid) for key, solid in plane.maximal(found.leaves).items()])
        cones = {}
        for choice in product(*parts) if parts else ():
            pressing = frozenset().union(*(self._named(block, s) for block, (s, _), _ in choice))
            parted = frozenset().union(*(self._named(block, g) for block, (_, g), _ in choice))
            whole = len(pressing) + len(parted) == len(self.names)
            cones[pressing, parted] = whole and all(solid for _, _, solid in choice)
        return self._answer(cones, least)

    def by_rays(self, mu):
        """For `rays`: all blocks at once, with bodies that move away without a reaction."""
        everything = range(len(self.names))
        found = self._enumerate(mu, everything)
        return self._answer({(self._named(everything, s), self._named(everything, g)): solid
                             for (s, g), solid in plane.maximal(found.leaves).items()}, found.least)

    def _answer(self, cones, least):
        return Answer(cones, None, f"a displacement is {float(least):.1e} of its parts" if least < Decimal("1e-11") else None)

    def wedges(self, mu):
        return any(self._enumerate(mu, block).leaves for block in self._blocks())
