"""All wedged configurations in space (or in the plane), by the cone program of each leaf in 80
digits.

For a leaf with t* = 0 the barrier method ends in the relative interior of its cone D(Y). Candidates
that are inactive there are inactive throughout, which is checked by solving again with these
candidates inactive.
"""

from decimal import Decimal
from itertools import combinations

from cone_program import ALIVE, DEAD, TIED, UNSURE, Leaf, equilibrated, sign
from structure import dot

#: In the equilibrated problem: smaller values are zero, since t* = 0 is reached to 10^-24 and
#: vanishing components to about its square root.
REST = Decimal("1e-9")


def _flat(leaf, flexibility, d, friction, contact, apart):
    """(S, G, sure) of a leaf with t* = 0, from its point."""
    reactions = leaf.reaction()
    pressing = frozenset(i for i in contact if reactions[i][0] > REST)
    parted = set()
    for j in apart:
        gap = sum(dot(flexibility[j * d][i * d:i * d + len(r)], r) for i, r in reactions.items())
        if gap > REST:
            parted.add(j)
    rest = [i for i in list(contact) + list(apart) if i not in pressing and i not in parted]
    again = sign(Leaf(flexibility, d, friction, sorted(pressing), sorted(parted), rest)) if pressing else DEAD
    return pressing, frozenset(parted), again in (ALIVE, TIED)


def enumerate_cones(flexibility, d, friction):
    """All leaves of one block with a nonzero solution: [(U, S, G, solid)], and the number of
    undecided leaves."""
    m = len(friction)
    scaled = equilibrated(flexibility, d)
    leaves, unsure = [], 0
    for size in range(1, m + 1):
        for contact in combinations(range(m), size):
            apart = [i for i in range(m) if i not in contact]
            leaf = Leaf(scaled, d, friction, contact, apart)
            answer = sign(leaf)
            if answer == ALIVE:
                leaves.append((frozenset(contact), frozenset(contact), frozenset(apart), True))
            elif answer == TIED:
                pressing, parted, sure = _flat(leaf, scaled, d, friction, contact, apart)
                unsure += not sure
                leaves.append((frozenset(contact), pressing, parted, False))
            elif answer == UNSURE:
                unsure += 1
    return leaves, unsure
