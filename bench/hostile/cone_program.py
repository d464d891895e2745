"""Cone programs in 80 digits, and that of a leaf: its sign, its value, and its inactive candidates.

The program is (P) of docs/theory/wedged.md. Its equations are eliminated exactly (up to 80 digits);
the rest has an interior, so that a logarithmic barrier with Newton's method applies, in the plane
and in space. The method is slow and simple, as suits a reference.
"""

import math
from decimal import Decimal

from structure import dot

#: Relative size below which a pivot of the equations is zero.
RANK = Decimal("1e-40")
#: Values of t* below this, with a gap below this, are zero.
TIE = Decimal("1e-24")

ALIVE, DEAD, TIED, UNSURE = "alive", "dead", "tied", "unsure"


def mean_scaled(flexibility, d):
    """F in the unit of the program's margins: divided by the mean diagonal of its normal block."""
    m = len(flexibility) // d
    mean = sum(flexibility[i * d][i * d] for i in range(m)) / m
    return [[value / mean for value in row] for row in flexibility]


def equilibrated(flexibility, d):
    """F with a unit diagonal of its normal block: other margins, the same signs, far better conditions."""
    roots = [flexibility[i // d * d][i // d * d].sqrt() for i in range(len(flexibility))]
    return [[value / (roots[i] * roots[j]) for j, value in enumerate(row)] for i, row in enumerate(flexibility)]


def affine(rows, right):
    """x0 and a basis (list of vectors) of all x with rows x = right; None if there are none."""
    n = len(rows[0])
    table = []
    for row, value in zip(rows, right):
        top = max(abs(x) for x in row)
        if top == 0:
            if value != 0:
                return None
            continue
        table.append([x / top for x in row] + [value / top])
    pivots = []
    for step in range(len(table)):
        best, at, column = RANK, None, None
        for i in range(step, len(table)):
            for j in range(n):
                if abs(table[i][j]) > best:
                    best, at, column = abs(table[i][j]), i, j
        if at is None:
            if any(abs(row[n]) > RANK for row in table[step:]):
                return None
            break
        table[step], table[at] = table[at], table[step]
        pivot = table[step][column]
        table[step] = [x / pivot for x in table[step]]
        for i, row in enumerate(table):
            if i != step and row[column]:
                factor = row[column]
                table[i] = [x - factor * y for x, y in zip(row, table[step])]
        pivots.append(column)
    free = [j for j in range(n) if j not in pivots]
    start = [Decimal(0)] * n
    for step, column in enumerate(pivots):
        start[column] = table[step][n]
    basis = []
    for j in free:
        vector = [Decimal(0)] * n
        vector[j] = Decimal(1)
        for step, column in enumerate(pivots):
            vector[column] = -table[step][j]
        basis.append(vector)
    for i, vector in enumerate(basis):  # orthonormal, only as a starting point
        for other in basis[:i]:
            along = dot(vector, other)
            vector = [x - along * y for x, y in zip(vector, other)]
        size = dot(vector, vector).sqrt()
        basis[i] = [x / size for x in vector]
    return start, basis


def _solve(matrix, right):
    """Cholesky; None if the matrix is not definite in 80 digits."""
    n = len(right)
    low = []
    y = []
    for i in range(n):
        row = []
        for j in range(i):
            row.append((matrix[i][j] - sum(a * b for a, b in zip(row, low[j]))) / low[j][j])
        pivot = matrix[i][i] - sum(a * a for a in row)
        if pivot <= 0:
            return None
        row.append(pivot.sqrt())
        low.append(row)
        y.append((right[i] - sum(a * b for a, b in zip(row, y))) / row[i])
    for i in reversed(range(n)):
        y[i] = (y[i] - sum(low[k][i] * y[k] for k in range(i + 1, n))) / low[i][i]
    return y


class Barrier:
    """Maximum of t subject to linear rows >= 0 and cones, each (first row, others): rows are (coefficients of the
    unknowns, of which t is the last; constant)."""

    empty = False

    def _values(self, point):
        at = lambda row: row[1] + dot(row[0], point)
        return [at(row) for row in self.linear], [(at(first), [at(o) for o in others]) for first, others in self.cones]

    def begin(self, point):
        """From a point at which all rows with t can be positive: t is below them."""
        linear, cones = self._values([*point, Decimal(0)])
        falling = [value for (row, _), value in zip(self.linear, linear) if row[-1]]
        falling += [f - dot(o, o).sqrt() for (first, _), (f, o) in zip(self.cones, cones) if first[0][-1]]
        self.first = [*point, min(falling) - 1]

    def escalate(self, gap, above=None, below=None):
        """Increases t until its bracket [low, high] is narrower than `gap`, or it is known to be larger or smaller than
        the given numbers. Both are stored in self."""
        self.low, self.high = Decimal("-Infinity"), Decimal("Infinity")
        if self.empty:
            self.high = self.low
            return
        self.point = self.first
        k = len(self.point) - 1
        order = Decimal(len(self.linear) + 2 * len(self.cones))
        slack = order + 2 * order.sqrt()
        weight = Decimal(1)
        for _ in range(2000):
            decrement = self._newton(weight)
            if decrement is None:
                return
            self.low = self.point[k]
            if decrement < Decimal("0.05"):
                self.high = min(self.high, self.low + slack / weight)
                if self.high - self.low < gap or (below is not None and self.high < below):
                    return
                weight *= 20
            if above is not None and self.low > above:
                return

    def _newton(self, weight):
        k = len(self.point)
        linear, cones = self._values(self.point)
        gradient = [Decimal(0)] * k
        gradient[k - 1] = -weight
        hessian = [[Decimal(0)] * k for _ in range(k)]

        def add(vector, factor):
            for i in range(k):
                if vector[i]:
                    scaled = factor * vector[i]
                    row = hessian[i]
                    for j in range(i + 1):
                        row[j] += scaled * vector[j]

        for (row, _), value in zip(self.linear, linear):
            add(row, 1 / (value * value))
            for i in range(k):
                gradient[i] -= row[i] / value
        for (first, others), (top, rest) in zip(self.cones, cones):
            square = top * top - dot(rest, rest)
            slope = [2 * (top * a - sum(v * o[0][i] for v, o in zip(rest, others))) for i, a in enumerate(first[0])]
            add(slope, 1 / (square * square))
            add(first[0], -2 / square)
            for other in others:
                add(other[0], 2 / square)
            for i in range(k):
                gradient[i] -= slope[i] / square
        step = _solve(hessian, [-g for g in gradient])
        if step is None:
            return None
        decrement = (-dot(gradient, step))
        if decrement < 0:
            return None
        decrement = decrement.sqrt()
        length = Decimal(1)
        if decrement > Decimal("0.5"):
            length = Decimal(self._length(step, linear, cones, float(weight * step[k - 1])))
        self.point = [a + length * b for a, b in zip(self.point, step)]
        return decrement if length == 1 else Decimal(1)

    def _length(self, step, linear, cones, gain):
        """Step length: the minimum of the barrier function along the step, to a few digits, in doubles."""
        slopes = [float(dot(row, step) / value) for (row, _), value in zip(self.linear, linear)]
        curves = []
        for (first, others), (top, rest) in zip(self.cones, cones):
            square = top * top - dot(rest, rest)
            dtop = dot(first[0], step)
            drest = [dot(o[0], step) for o in others]
            curves.append((float(2 * (top * dtop - dot(rest, drest)) / square),
                           float((dtop * dtop - dot(drest, drest)) / square), float(dtop / top)))
        end = 1e6
        for s in slopes:
            if s < 0:
                end = min(end, -1 / s)
        for c1, c2, s in curves:
            if s < 0:  # through the apex the square vanishes twice, which the root below may miss
                end = min(end, -1 / s)
            root = c1 * c1 - 4 * c2
            if root < 0:
                continue
            q = -0.5 * (c1 + math.copysign(math.sqrt(root), c1))
            for x in ((q / c2 if c2 else math.inf), (1 / q if q else math.inf)):
                if x > 0:
                    end = min(end, x)
        low, high = 0.0, end
        for _ in range(40):
            middle = (low + high) / 2
            lines = [(s, 1 + s * middle) for s in slopes]
            lines += [(c1 + 2 * c2 * middle, 1 + c1 * middle + c2 * middle * middle) for c1, c2, _ in curves]
            outside = any(value <= 0 for _, value in lines)  # by rounding
            if outside or -gain - sum(change / value for change, value in lines) > 0:
                high = middle
            else:
                low = middle
        return min(low, 0.999 * end)


class Leaf(Barrier):
    """The program of one leaf, in the unit of the given compliance.

    @param contact, apart, rest  candidates with u_n = 0; with r = 0; with both
    """

    def __init__(self, flexibility, d, friction, contact, apart, rest=()):
        self.columns = [(i, a) for i in contact for a in range(d if friction[i] else 1)]
        self.contact, self.apart, self.d = list(contact), list(apart), d
        n = len(self.columns)
        self.empty = n == 0
        if self.empty:
            return
        normal = {j: [flexibility[j * d][i * d + a] for i, a in self.columns]
                  for j in list(contact) + list(apart) + list(rest)}
        rows = [normal[j] for j in list(contact) + list(rest)]
        total = [Decimal(1) if a == 0 else Decimal(0) for _, a in self.columns]
        solutions = affine(rows + [total], [Decimal(0)] * len(rows) + [Decimal(1)])
        if solutions is None:
            self.empty = True
            return
        start, self.basis = solutions
        aim = [x / len(self.contact) - y for x, y in zip(total, start)]
        for vector in self.basis:
            along = dot(vector, aim)
            start = [x + along * y for x, y in zip(start, vector)]
        self.start = start
        # Rows of the unknowns (z, t): linear ones, and cones (first row, others).
        self.linear = [self._row(normal[j], Decimal(-1)) for j in apart]
        self.cones = []
        for i in contact:
            at = self.columns.index((i, 0))
            pick = [Decimal(0)] * n
            pick[at] = friction[i] or Decimal(1)
            first = self._row(pick, Decimal(-1))
            if not friction[i]:
                self.linear.append(first)
                continue
            others = []
            for a in range(1, d):
                pick = [Decimal(0)] * n
                pick[at + a] = Decimal(1)
                others.append(self._row(pick, Decimal(0)))
            self.cones.append((first, others))
        self.begin([Decimal(0)] * len(self.basis))

    def _row(self, coefficients, of_t):
        return [dot(coefficients, vector) for vector in self.basis] + [of_t], dot(coefficients, self.start)

    def reaction(self):
        """{candidate: reaction} at the current point."""
        x = list(self.start)
        for value, vector in zip(self.point, self.basis):
            x = [a + value * b for a, b in zip(x, vector)]
        result = {}
        for (i, _), value in zip(self.columns, x):
            result.setdefault(i, []).append(value)
        return result


def sign(leaf):
    """alive, dead, tied or unsure, with the point of the leaf."""
    leaf.escalate(TIE, above=0, below=0)
    if leaf.low > 0 and leaf.low > TIE:
        return ALIVE
    if leaf.high < 0 and (leaf.high < -TIE or leaf.empty):
        return DEAD
    return TIED if max(abs(leaf.low), abs(leaf.high)) < 4 * TIE else UNSURE


def margin(flexibility, d, friction, contact, apart):
    """t* in the unit of the program to more than four digits: (low, high)."""
    leaf = Leaf(mean_scaled(flexibility, d), d, friction, contact, apart)
    leaf.escalate(Decimal("1e-3"))
    while not leaf.empty and leaf.high - leaf.low > abs(leaf.low) * Decimal("1e-5") and leaf.high - leaf.low > TIE:
        goal = max(min(leaf.high - leaf.low, abs(leaf.low)) * Decimal("1e-3"), TIE / 2)
        before = leaf.high - leaf.low
        leaf.escalate(goal)
        if leaf.high - leaf.low >= before:
            break
    return leaf.low, leaf.high
