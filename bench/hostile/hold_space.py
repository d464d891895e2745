"""States of one sign pattern under load in space, by a barrier method in 80 digits: a point of the program, and a bound by
its central path.

Equations are eliminated. Inequalities have a room of their own, so that a pattern with states has an interior; forces and
displacements have limits, so that the path is bounded.
"""

from decimal import Decimal

from cone_program import Barrier, affine

#: Rows, whose largest term is 1, may be missed by this: states of patterns that are degenerate have an interior.
ROOM = Decimal("1e-24")
#: Largest load factor and largest force or displacement. Ends beyond a tenth of the former are unbounded.
LARGE, LARGE_FORCE = Decimal("1e6"), Decimal("1e10")
UNBOUNDED = LARGE / 10
#: Relative width of the bracket of an optimum.
WIDTH = Decimal("1e-10")


class Undecided(Exception):
    """The bracket did not become narrow enough."""


class States:
    """A convex set of unknowns x: equations and inequalities, each (coefficients, constant), and cones |tangential| <= first."""

    def __init__(self, count):
        self.count, self.equations, self.rows, self.cones = count, [], [], []

    @staticmethod
    def _scaled(coefficients, constant):
        scale = max(abs(constant), *map(abs, coefficients))
        return None if scale == 0 else ([x / scale for x in coefficients], constant / scale)

    def add(self, coefficients, constant, is_equation=False):
        row = self._scaled(coefficients, constant)
        if row:
            (self.equations if is_equation else self.rows).append(row)

    def limit(self, unknown, largest, smallest=None):
        """Bounds of an unknown."""
        for sign, end in ((-1, largest), (1, largest if smallest is None else -smallest)):
            row = [Decimal(0)] * self.count
            row[unknown] = Decimal(sign) / largest
            self.rows.append((row, end / largest))

    def cone(self, normal, tangential, friction):
        unit = lambda column: [Decimal(column == k) for k in range(self.count)]
        self.cones.append(([friction * x for x in unit(normal)], [unit(column) for column in tangential]))

    def interior(self):
        """The unknowns without the equations, and a point; nothing if there is no state."""
        solutions = affine([row for row, _ in self.equations], [-value for _, value in self.equations]) if self.equations else \
            ([Decimal(0)] * self.count, [[Decimal(i == k) for k in range(self.count)] for i in range(self.count)])
        if solutions is None:
            return None
        start, basis = solutions

        def reduced(row, constant, of_t):
            return [sum(a * b for a, b in zip(row, vector)) for vector in basis] + [of_t], \
                sum(a * b for a, b in zip(row, start)) + constant

        program = Barrier()
        program.reduced = reduced
        program.linear = [reduced(row, constant + ROOM, Decimal(-1)) for row, constant in self.rows]
        program.linear.append(([Decimal(0)] * len(basis) + [Decimal(-1)], Decimal(1)))
        program.cones = [(reduced(first, ROOM, Decimal(-1)), [reduced(other, Decimal(0), Decimal(0)) for other in others])
                         for first, others in self.cones]
        program.begin([Decimal(0)] * len(basis))
        program.escalate(ROOM / 100, above=0, below=0)
        if program.low > 0:
            return program
        if program.high < 0:
            return None
        raise Undecided

    def maximum(self, objective):
        """The largest value of a row; nothing without states."""
        program = self.interior()
        if program is None:
            return None
        # t no longer reduces the rows, and is bounded by the objective instead.
        without = lambda row: (row[0][:-1] + [Decimal(0)], row[1])
        program.linear = [without(row) for row in program.linear[:-1]] + [program.reduced(objective, Decimal(0), Decimal(-1))]
        program.cones = [(without(first), others) for first, others in program.cones]
        program.begin(program.point[:-1])
        for step in range(4):
            program.escalate(WIDTH / 1000 ** step, above=UNBOUNDED)
            size = max(abs(program.low), Decimal("1e-12"))
            if program.low > UNBOUNDED or program.high - program.low <= 10 * WIDTH * max(size, 1):
                return program.low
        raise Undecided
