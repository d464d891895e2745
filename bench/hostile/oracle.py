"""The truth about a problem file: its maximal cones at a friction coefficient, and whether anything can wedge."""

from decimal import Decimal
from itertools import product

import cone_program
import plane
import space
import structure


class Answer:
    """cones: {(S, G): solid} over names; rays: their number, or None; doubtful: why the truth is not to be judged by."""

    def __init__(self, cones, rays, doubtful):
        self.cones, self.rays, self.doubtful = cones, rays, doubtful


class Oracle:
    """Compliance and blocks of one structure, computed once, and questions about it."""

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
        """The compliance of the candidates `numbers` alone."""
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
        doubtful = None
        parts = []
        for block in self.blocks:
            found, unsure = self._of_block(block, mu)
            if unsure:
                doubtful = f"{unsure} leaves unsure"
            if found:
                parts.append(list(found.items()))
        cones = {}
        for choice in product(*parts) if parts else ():
            pressing = frozenset().union(*(key[0] for key, _ in choice))
            parted = frozenset().union(*(key[1] for key, _ in choice))
            whole = len(pressing) + len(parted) == len(self.names)
            cones[self._named(pressing), self._named(parted)] = whole and all(solid for _, solid in choice)
        return Answer(cones, None, doubtful)

    def by_rays(self, mu):
        """The whole at once, by extremal rays; plane only."""
        found = plane.enumerate_plane(self.flexibility, self.friction(mu))
        cones = {(self._named(s), self._named(g)): solid for (s, g), solid in plane.maximal(found.leaves).items()}
        doubtful = f"a displacement is {float(found.least):.1e} of its parts" if found.least < Decimal("1e-11") else None
        return Answer(cones, len(found.rays), doubtful)

    def cones(self, mu):
        return self.by_rays(mu) if self.d == 2 else self.by_programs(mu)

    def wedges(self, mu):
        """True if there is a nonzero solution at mu, False if not, None if that is too close to tell."""
        if self.d == 2:
            return bool(plane.enumerate_plane(self.flexibility, self.friction(mu)).leaves)
        unsure = 0
        for block in self.blocks:
            found, doubts = self._of_block(block, mu)
            if found:
                return True
            unsure += doubts
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
