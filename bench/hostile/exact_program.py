"""Mixed zero-one programs as plain data, their files, and their exact optimum: linear programs in
rational numbers (simplex method with Bland's rule) at the nodes of a tree over the binaries. For a
few columns and rows only."""

import math
from dataclasses import dataclass, field
from fractions import Fraction

OPTIMAL, INFEASIBLE, UNBOUNDED = "optimal", "infeasible", "unbounded"


@dataclass
class Column:
    name: str
    cost: float
    lower: float | None
    upper: float | None
    binary: bool


@dataclass
class Row:
    name: str
    sense: str  # L, G or E
    right: float
    terms: dict
    range: float | None = None

    def ends(self):
        """(lower, upper); None where there is none"""
        width = None if self.range is None else Fraction(self.range)
        right = Fraction(self.right)
        if self.sense == "E":
            return right, right
        if self.sense == "L":
            return (None if width is None else right - width), right
        return right, (None if width is None else right + width)


@dataclass
class Program:
    columns: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    maximise: bool = False

    def column(self, lower=0, upper=None, cost=0.0, binary=False):
        self.columns.append(Column(f"x{len(self.columns)}", cost, 0 if binary else lower, 1 if binary else upper, binary))
        return len(self.columns) - 1

    def row(self, sense, right, terms):
        terms = {j: value for j, value in terms.items() if value}
        if terms:
            self.rows.append(Row(f"r{len(self.rows)}", sense, right, terms))

    def missed(self, values):
        """A row or bound that a point of the result file violates by more than rounding of its terms."""
        at = [Fraction(values.get(column.name, 0.0)) for column in self.columns]
        for row in self.rows:
            terms = [Fraction(value) * at[j] for j, value in row.terms.items()]
            lower, upper = row.ends()
            room = Fraction(1, 10**14) * sum(map(abs, terms))
            if (upper is not None and sum(terms) > upper + room) or (lower is not None and sum(terms) < lower - room):
                return f"the point misses row {row.name} by more than {float(room)!r}: {float(sum(terms))!r}"
        for column, x in zip(self.columns, at):
            if column.binary and x not in (0, 1):
                return f"binary {column.name} is {float(x)!r}"
            if (column.lower is not None and x < column.lower) or (column.upper is not None and x > column.upper):
                return f"column {column.name} is {float(x)!r}"
        return None

    def mps(self):
        lines = ["NAME r", *(["OBJSENSE MAX"] if self.maximise else []), "ROWS", " N cost"]
        lines += [f" {row.sense} {row.name}" for row in self.rows]
        lines.append("COLUMNS")
        inside = False
        for j, column in enumerate(self.columns):
            if column.binary != inside:
                inside = column.binary
                lines.append(f" M{j} 'MARKER' '{'INTORG' if inside else 'INTEND'}'")
            lines.append(f" {column.name} cost {column.cost!r}")
            lines += [f" {column.name} {row.name} {row.terms[j]!r}" for row in self.rows if j in row.terms]
        if inside:
            lines.append(" M 'MARKER' 'INTEND'")
        lines.append("RHS")
        lines += [f" RHS {row.name} {row.right!r}" for row in self.rows]
        lines.append("RANGES")
        lines += [f" RNG {row.name} {row.range!r}" for row in self.rows if row.range is not None]
        lines.append("BOUNDS")
        for column in self.columns:
            if column.lower is None:
                lines.append(f" MI BND {column.name}")
            elif column.lower != 0:
                lines.append(f" LO BND {column.name} {float(column.lower)!r}")
            if column.upper is not None:
                lines.append(f" UP BND {column.name} {float(column.upper)!r}")
        return "\n".join(lines) + "\nENDATA\n"

    def lp(self):
        def form(terms):
            return " ".join(f"{'-' if value < 0 else '+'} {abs(value)!r} {self.columns[j].name}" for j, value in terms.items())

        costs = {j: column.cost for j, column in enumerate(self.columns)}
        lines = ["Maximize" if self.maximise else "Minimize", f" cost: {form(costs)}", "Subject To"]
        for row in self.rows:
            sense = {"L": "<=", "G": ">=", "E": "="}[row.sense]
            lines.append(f" {row.name}: {form(row.terms)} {sense} {row.right!r}")
            if row.range is not None:
                lower, upper = row.ends()
                other = f">= {float(lower)!r}" if row.sense == "L" else f"<= {float(upper)!r}"
                lines.append(f" {row.name}b: {form(row.terms)} {other}")
        lines.append("Bounds")
        for column in self.columns:
            lower = "-inf" if column.lower is None else repr(float(column.lower))
            upper = "+inf" if column.upper is None else repr(float(column.upper))
            if not column.binary:
                lines.append(f" {lower} <= {column.name} <= {upper}")
        lines.append("Binary")
        lines += [f" {column.name}" for column in self.columns if column.binary]
        return "\n".join(lines) + "\nEnd\n"


class Dictionary:
    """Minimise c'x with Ax <= b, x >= 0: each basic variable is a constant plus a combination of
    the others. Numbers are integers over one denominator: a row of A is multiplied by its own, which
    scales the slack variable, and all divisions of a pivot are exact, without common factors to be
    found (Edmonds 1967)."""

    def __init__(self, a, b, c):
        self.rows, self.constants = [], []
        for row, constant in zip(a, b):
            *own, constant = self._integers([*row, constant])[0]
            self.rows.append([-value for value in own])
            self.constants.append(constant)
        self.costs, self.unit = self._integers(c)
        self.minimum, self.denominator = 0, 1
        self.free = list(range(len(c)))
        self.basic = list(range(len(c), len(c) + len(b)))

    @staticmethod
    def _integers(numbers):
        """Multiples of the numbers, and the factor"""
        unit = math.lcm(*(number.denominator for number in numbers))
        return [number.numerator * (unit // number.denominator) for number in numbers], unit

    @property
    def value(self):
        return Fraction(self.minimum, self.denominator * self.unit)

    def constant(self, i):
        """Value of the basic variable of a row, which is no slack variable"""
        return Fraction(self.constants[i], self.denominator)

    def pivot(self, i, j):
        pivot, last = self.rows[i][j], self.denominator
        sign = 1 if pivot > 0 else -1
        size = abs(pivot)
        row = [-sign * entry for entry in self.rows[i]]
        row[j] = sign * last
        constant = -sign * self.constants[i]

        def replaced(entries, own):
            factor = entries[j]
            if not factor:
                return [entry * size // last if entry else 0 for entry in entries], own * size // last
            new = [(entry * size + factor * other) // last if other else entry * size // last if entry else 0
                   for entry, other in zip(entries, row)]
            new[j] = sign * factor
            return new, (own * size + factor * constant) // last

        for k in range(len(self.rows)):
            if k != i:
                self.rows[k], self.constants[k] = replaced(self.rows[k], self.constants[k])
        self.costs, self.minimum = replaced(self.costs, self.minimum)
        self.rows[i], self.constants[i], self.denominator = row, constant, size
        self.basic[i], self.free[j] = self.free[j], self.basic[i]

    def feasible(self):
        """Bland's rule for a feasible point: the first negative basic variable, the first column
        that increases it."""
        while True:
            low = [i for i, constant in enumerate(self.constants) if constant < 0]
            if not low:
                return True
            i = min(low, key=lambda k: self.basic[k])
            raises = [j for j, entry in enumerate(self.rows[i]) if entry > 0]
            if not raises:
                return False
            self.pivot(i, min(raises, key=lambda k: self.free[k]))

    def solve(self):
        if not self.feasible():
            return INFEASIBLE
        while True:
            falls = [j for j, cost in enumerate(self.costs) if cost < 0]
            if not falls:
                return OPTIMAL
            j = min(falls, key=lambda k: self.free[k])
            steps = [(Fraction(self.constants[i], -row[j]), self.basic[i], i) for i, row in enumerate(self.rows) if row[j] < 0]
            if not steps:
                return UNBOUNDED
            self.pivot(min(steps)[2], j)


def _relaxed(program, held):
    """(status, value, values of the binaries) of the relaxation, minimised, with binaries fixed by `held`."""
    parts, start, a, b, c = [], [], [], [], []
    widths = []
    for j, column in enumerate(program.columns):
        lower = held.get(j, column.lower)
        upper = held.get(j, column.upper)
        if lower is not None and upper is not None and lower > upper:
            return INFEASIBLE, None, None
        if lower is not None:
            start.append(Fraction(lower))
            if lower != upper:
                parts.append((j, 1))
                widths.append(None if upper is None else Fraction(upper) - Fraction(lower))
        elif upper is not None:
            start.append(Fraction(upper))
            parts.append((j, -1))
            widths.append(None)
        else:
            start.append(Fraction(0))
            parts += [(j, 1), (j, -1)]
            widths += [None, None]
    for row in program.rows:
        at = sum(Fraction(value) * start[j] for j, value in row.terms.items())
        line = [sign * Fraction(row.terms.get(j, 0)) for j, sign in parts]
        lower, upper = row.ends()
        if upper is not None:
            a.append(line)
            b.append(upper - at)
        if lower is not None:
            a.append([-value for value in line])
            b.append(at - lower)
    for k, width in enumerate(widths):
        if width is not None:
            a.append([Fraction(int(t == k)) for t in range(len(parts))])
            b.append(width)
    sense = -1 if program.maximise else 1
    costs = [sense * Fraction(column.cost) for column in program.columns]
    dictionary = Dictionary(a, b, [sign * costs[j] for j, sign in parts])
    status = dictionary.solve()
    if status != OPTIMAL:
        return status, None, None
    values = list(start)
    for i, k in enumerate(dictionary.basic):
        if k < len(parts):
            j, sign = parts[k]
            values[j] += sign * dictionary.constant(i)
    return status, dictionary.value + sum(cost * x for cost, x in zip(costs, start)), values


def exact_optimum(program):
    """(status, optimum in the sense of the file or None)"""
    binaries = [j for j, column in enumerate(program.columns) if column.binary]
    best = None
    nodes = [{}]
    while nodes:
        held = nodes.pop()
        status, value, values = _relaxed(program, held)
        if status == INFEASIBLE or (status == OPTIMAL and best is not None and value >= best):
            continue
        rest = [j for j in binaries if j not in held]
        if status == OPTIMAL:
            rest = [j for j in rest if values[j] not in (0, 1)]
            if not rest:
                best = value
                continue
        elif not rest:
            return UNBOUNDED, None
        nodes += [{**held, rest[0]: 1}, {**held, rest[0]: 0}]
    if best is None:
        return INFEASIBLE, None
    return OPTIMAL, -best if program.maximise else best
