"""All wedged configurations in the plane, by extremal rays in 80 digits.

Friction is linear in the plane: a reaction is a nonnegative sum of the two edges of its friction
cone. For each choice "contact or separated" a cone is cut out of the nonnegative sums, one
candidate after another (double description). The sum of the rays of a leaf is a point of the
relative interior of its cone D(Y), so components that vanish on all rays vanish on D(Y).
"""

from decimal import Decimal

from structure import ZERO


class Ray:
    """Coefficients of the friction edges and of motions, normal displacements and equilibrium
    residuals, and a bit set of zeros."""

    __slots__ = ("x", "u", "zeros", "support", "gaps")


class PlaneAnswer:
    """cones: set of (frozenset S, frozenset G, solid) before taking maxima; rays: their (support,
    gaps);
    least: the smallest relative displacement that was regarded as nonzero.
    """

    def __init__(self):
        self.leaves = []
        self.rays = set()
        self.least = Decimal(1)


def _edges(flexibility, friction, motions):
    """Columns for the edges of all friction cones: [(candidate, u_n of every candidate and then
    G'r, sums of sizes)]; and for each motion one in each direction, without a candidate."""
    m = len(friction)
    count = len(motions[0]) if motions else 0
    of_equations = lambda row, k: [motions[2 * k + row][l] for l in range(count)]
    columns = []
    for k in range(m):
        mu = friction[k]
        for sign in ((1, -1) if mu else (0,)):
            scale = 1 + abs(mu)
            normal = [x / scale for x in [flexibility[2 * i][2 * k] for i in range(m)] + of_equations(0, k)]
            shear = [sign * mu * x / scale for x in [flexibility[2 * i][2 * k + 1] for i in range(m)] + of_equations(1, k)]
            columns.append((k, [a + b for a, b in zip(normal, shear)], [abs(a) + abs(b) for a, b in zip(normal, shear)]))
    for l in range(count):
        lift = [motions[2 * i][l] for i in range(m)] + [Decimal(0)] * count
        for sign in (1, -1):
            columns.append((None, [sign * x for x in lift], [abs(x) for x in lift]))
    return columns


def enumerate_plane(flexibility, friction, motions=()):
    """All leaves with a nonzero reaction.

    flexibility: 2m x 2m in (n, t); friction: m Decimals, 0 allowed; motions: G of unconstrained
    bodies, 2m rows: then G'r = 0, and any combination of them is added to u_n = F r. Returns a
    PlaneAnswer whose `leaves` are (U, S, G, solid): candidates in contact, with reaction, with gap,
    and True if D(Y) has an interior.
    """
    m = len(friction)
    columns = _edges(flexibility, friction, motions)
    equations = len(columns[0][1]) - m
    of_candidate = [sum(1 << c for c, (k, _, _) in enumerate(columns) if k == i) for i in range(m)]
    width = len(columns)
    answer = PlaneAnswer()

    def make(x):
        ray = Ray()
        top = max(x)
        ray.x = [value / top if value else value for value in x]
        ray.u = []
        ray.support = sum(1 << c for c, value in enumerate(ray.x) if value)
        ray.gaps = 0
        for i in range(m + equations):
            total = sum(columns[c][1][i] * value for c, value in enumerate(ray.x) if value)
            size = sum(columns[c][2][i] * value for c, value in enumerate(ray.x) if value)
            if not size or abs(total) < ZERO * size:
                total = Decimal(0)
            else:
                answer.least = min(answer.least, abs(total) / size)
            ray.u.append(total)
            if total > 0 and i < m:
                ray.gaps |= 1 << i
        return ray

    def cut(rays, i, done, equality):
        """Rays of the cone after u_ni = 0, or u_ni >= 0; `done` are the candidates whose u_n was cut before."""
        zero = [ray for ray in rays if ray.u[i] == 0]
        above = [ray for ray in rays if ray.u[i] > 0]
        below = [ray for ray in rays if ray.u[i] < 0]
        kept = zero if equality else zero + above
        marks = {id(ray): ray.support | sum(1 << (width + j) for j in done if ray.u[j] != 0) for ray in rays}
        between = []
        for a in above:
            for b in below:
                both = marks[id(a)] | marks[id(b)]
                if any(c is not a and c is not b and marks[id(c)] | both == both for c in rays):
                    continue
                x = [a.x[c] * -b.u[i] + b.x[c] * a.u[i] for c in range(width)]
                ray = make(x)
                ray.u[i] = Decimal(0)
                ray.gaps &= ~(1 << i)
                for j in done:  # zero at its parents
                    if a.u[j] == 0 and b.u[j] == 0:
                        ray.u[j] = Decimal(0)
                        ray.gaps &= ~(1 << j)
                between.append(ray)
        return kept + between

    def walk(i, rays, contact):
        if not rays:
            return
        if i == m:
            support = gaps = 0
            for ray in rays:
                support |= ray.support
                gaps |= ray.gaps
                answer.rays.add((ray.support, ray.gaps))
            if not any(support & bits for bits in of_candidate):
                return
            reacting = frozenset(k for k in range(m) if support & of_candidate[k])
            parted = frozenset(k for k in range(m) if gaps >> k & 1)
            full = all(support & of_candidate[k] == of_candidate[k] for k in contact)
            solid = full and reacting == frozenset(contact) and len(parted) == m - len(contact)
            answer.leaves.append((frozenset(contact), reacting, parted, solid))
            return
        done = [*range(m, m + equations), *range(i)]
        walk(i + 1, cut(rays, i, done, True), contact + [i])
        apart = [ray for ray in rays if not ray.support & of_candidate[i]]
        walk(i + 1, cut(apart, i, done, False), contact)

    start = []
    for c in range(width):
        start.append(make([Decimal(1) if k == c else Decimal(0) for k in range(width)]))
    for l in range(equations):
        start = cut(start, m + l, range(m, m + l), True)
    walk(0, start, [])
    return answer


def maximal(leaves):
    """Maximal (S, G) of leaves (U, S, G, solid) under inclusion of both: {(S, G): solid}."""
    found = {}
    for _, reacting, parted, solid in leaves:
        found[reacting, parted] = found.get((reacting, parted), False) or solid
    return {key: solid for key, solid in found.items()
            if not any(other != key and key[0] <= other[0] and key[1] <= other[1] for other in found)}
