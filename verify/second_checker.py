#!/usr/bin/env python3
"""A second checker of Kusabi's certificates, which shares nothing with `kusabi verify`.

    python3 second_checker.py CERT

It was written from docs/certificates.md and docs/theory/proofs.md, with the standard library only. All numbers are
exact fractions, so there are no error bounds: what is checked is an identity or an inequality of fractions. Roots are
compared by their squares, or enclosed where a sum contains them. The claim is about the numbers in the certificate.
That these are the stiffness and the loads of a structure is what `kusabi verify --problem FILE` adds. Certificates of
trusses are in second_checker_loads.py.

Letters: u displacements, r reactions of the candidates, each with a normal and d - 1 tangential components, u_n and
u_t; K the stiffness; G the rigid-body modes; U the candidates in contact and R the separated ones of a node.

Exit codes: 0 proved, 1 not proved, 2 not a certificate or malformed, 3 nothing or not all proved.
"""
import functools
import hashlib
import math
import re
import sys
from fractions import Fraction

#: Displacements above this number of times the strains are large (proofs.md, "except for large displacements").
LARGE = 2 ** 20
FAR = " for displacements up to 1e+06 times the strains"
#: An entry of a load below the largest one divided by this is a rounding error of zero.
NOISE = 2 ** 60
INFINITE = math.inf


# Exact linear algebra -------------------------------------------------------------------------------------------------

def to_integers(numbers):
    """The numbers times their common denominator, and this denominator."""
    scale = math.lcm(*(x.denominator for x in numbers)) if numbers else 1
    return [x.numerator * (scale // x.denominator) for x in numbers], scale


def dot(a, b):
    return sum(x * y for x, y in zip(a, b) if x and y)


def integer_matrix(rows):
    """A matrix times the common denominator of its entries, and this denominator."""
    scale = math.lcm(*(x.denominator for row in rows for x in row))
    return [[x.numerator * (scale // x.denominator) for x in row] for row in rows], scale


def root_above(x):
    """A fraction not below the root of x >= 0, and close to it."""
    x = Fraction(x)
    shift = max(0, 160 - x.numerator.bit_length() + x.denominator.bit_length()) // 2 * 2
    return Fraction(math.isqrt((x.numerator << shift) // x.denominator) + 1, 1 << shift // 2) if x else x


def power_near(x):
    """The power of two near x > 0: a weight with few digits."""
    return Fraction(2) ** (Fraction(x).numerator.bit_length() - Fraction(x).denominator.bit_length())


class Symmetric:
    """Elimination of a symmetric matrix of integers without fractions or a choice of pivots (Bareiss): pivot k is the
    leading minor of k + 1 rows. A row whose pivot is zero is left out; the matrix must then be semidefinite."""

    def __init__(self, matrix):
        rows = [row[i:] for i, row in enumerate(matrix)]
        self.rows, self.minors, self.det = rows, [0] * len(rows), 1
        for k, row in enumerate(rows):
            pivot = self.minors[k] = row[0]
            for i in range(k + 1, len(rows)) if pivot else ():
                factor = row[i - k]
                rows[i] = [(pivot * a - factor * b) // self.det for a, b in zip(rows[i], row[i - k:])] if factor else \
                    [pivot * a // self.det for a in rows[i]]
            self.det = pivot or self.det

    def solve(self, right):
        """det times the solution, in integers; None: there is none."""
        right, before, n = list(right), 1, len(self.rows)
        for k, (row, pivot) in enumerate(zip(self.rows, self.minors)):
            if pivot:
                for i in range(k + 1, n):
                    right[i] = (pivot * right[i] - row[i - k] * right[k]) // before
                before = pivot
            elif right[k]:
                return None
        found = [0] * n
        for k in range(n - 1, -1, -1):
            if self.minors[k]:
                found[k] = (self.det * right[k] - dot(self.rows[k][1:], found[k + 1:])) // self.minors[k]
        return found


def solve(rows, right):
    """A solution of linear equations, free unknowns being zero; None: there is none."""
    count, done, before = len(rows[0]) if rows else 0, [], 1
    left = [to_integers([*map(Fraction, row), Fraction(b)])[0] for row, b in zip(rows, right)]
    for column in range(count):
        at = min((i for i, row in enumerate(left) if row[column]), key=lambda i: left[i][column].bit_length(),
                 default=None)
        if at is not None:
            row = left.pop(at)
            left = [[(row[column] * a - other[column] * b) // before for a, b in zip(other, row)] for other in left]
            done.append((column, row))
            before = row[column]
    if any(row[count] for row in left):
        return None
    found = [Fraction(0)] * count
    for column, row in reversed(done):
        found[column] = Fraction(row[count] - dot(row[column + 1:count], found[column + 1:])) / row[column]
    return found


def null_space(rows, count, relative=0):
    """A basis of the vectors with rows x = 0; pivots below `relative` times the first are taken as zero."""
    rows, pivots, least = [list(map(Fraction, row)) for row in rows], [], 0
    while True:
        k = len(pivots)
        size, i, j = max(((abs(rows[i][j]), i, j) for i in range(k, len(rows)) for j in range(count)),
                         default=(0, 0, 0))
        if size == 0 or size < least:
            break
        least = least or size * relative
        rows[k], rows[i] = rows[i], rows[k]
        rows[k] = [x / rows[k][j] for x in rows[k]]
        rows = [[x - row[j] * y for x, y in zip(row, rows[k])] if n != k and row[j] else row
                for n, row in enumerate(rows)]
        pivots.append(j)
    return [[-rows[pivots.index(j)][free] if j in pivots else Fraction(int(j == free)) for j in range(count)]
            for free in range(count) if free not in pivots]


# Bounds as decimal numbers that remain bounds, with the digits of Kusabi's sentences ----------------------------------

TABLE_DIGITS, ALL_DIGITS, MAX_PLACES, LEAST_SHOWN = 12, 17, 15, 1e-300


def double(x, way):
    """The nearest double not above x (way = -1) or not below it (1)."""
    near = float(x)
    return near if not math.isfinite(near) or way * (Fraction(near) - x) >= 0 else math.nextafter(near, way * math.inf)


def shortest(x):
    return repr(float(x) + 0.0).removesuffix(".0")


def places_of(number, digits):
    return 0 if number == 0 else digits - 1 - math.floor(math.log10(abs(number)))


def rounded(x, way, digits=TABLE_DIGITS, places=None):
    """x rounded down (way = -1) or up (1) to so many digits or decimal places; if it is tiny, with a power of ten."""
    number = double(x, way)
    places = places_of(number, digits) if places is None else places
    if 0 < abs(number) < LEAST_SHOWN:
        return "0" if way * number < 0 else shortest(way * LEAST_SHOWN)
    if number == 0 or places < 0:
        return shortest(number)
    if places > MAX_PLACES:
        places = places_of(number, digits)
    form, step = f".{places}f", -places
    if places > MAX_PLACES:
        digits = min(digits, ALL_DIGITS)
        form, step = f".{digits - 1}e", math.floor(math.log10(abs(number))) - digits + 1
    text = format(number, form)
    if way * (number - float(text)) > 0:
        text = format(float(text) + way * 10.0 ** step, form)
    mantissa, e, power = text.partition("e")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return "0" if mantissa == "-0" else mantissa + e + power


def inside(low, high):
    """Both ends of a range, rounded inwards."""
    for digits in range(TABLE_DIGITS, ALL_DIGITS):
        shown = rounded(low, 1, digits), rounded(high, -1, digits)
        if float(shown[0]) <= float(shown[1]):
            return shown
    return shortest(double(low, 1)), shortest(double(high, -1))


def counted(count, thing):
    return f"{count} {thing}{'' if count == 1 else 's'}"


def in_quotes(text):
    data = text.encode(errors="surrogateescape")
    shown = text if len(data) <= 40 else data[:40].decode(errors="ignore")
    return '"' + re.sub(r'(["\\])', r"\\\1", shown) + ("..." if shown != text else "") + '"'


# Reading --------------------------------------------------------------------------------------------------------------

class Malformed(Exception):
    """Not a certificate; the message begins with its line."""


class Refused(Exception):
    """A statement that is not proved."""


class Reader:
    """The records of a certificate, whose digest is checked first."""

    def __init__(self, path):
        try:
            with open(path, "rb") as file:
                data = file.read()
        except OSError as error:
            raise Malformed(f"{path}: {error.strerror}") from None
        self.path, self.at, self.lines = path, 1, data.decode(errors="surrogateescape").split("\n")
        body, _, digest = data.rpartition(b"\ndigest ")
        if digest != hashlib.sha1(body + b"\n").hexdigest().encode() + b"\n":
            raise Malformed(f"{path}: was altered: its last line is not the digest of its text")

    def check(self, good, expected):
        if not good:
            raise Malformed(f"{self.path}:{self.at}: {self.lines[self.at - 1][:60]!r}, expected {expected}")

    def take(self, *keys, count=None, least=0):
        """The words of the next line after its keyword; with several keywords, the keyword as well."""
        words = self.lines[min(self.at, len(self.lines) - 1)].split(" ")
        self.at = min(self.at + 1, len(self.lines))
        self.check(not keys or words[0] in keys, " or ".join(keys))
        rest = words[1:] if keys else words
        self.check(count in (None, len(rest)) and len(rest) >= least, f"{count or least} words")
        return rest if len(keys) <= 1 else (words[0], rest)

    def peek(self):
        return self.lines[self.at].split(" ")[0] if self.at < len(self.lines) else ""

    def real(self, word):
        """A double, exactly: digits or exponents beyond it would be rounded, and are refused."""
        parts = re.fullmatch(r"(-?)0x([0-9a-f]{1,20})(?:\.([0-9a-f]{1,20}))?p([+-][0-9]{1,4})", word)
        self.check(parts, "a number")
        sign, whole, after = parts[1], parts[2], parts[3] or ""
        value = int(sign + whole + after, 16) * Fraction(2) ** (int(parts[4]) - 4 * len(after))
        try:
            self.check(Fraction(float(value)) == value, "a double")
        except OverflowError:
            self.check(False, "a finite number")
        return value

    def reals(self, words, count=None):
        self.check(count in (None, len(words)), f"{count} numbers")
        return [self.real(word) for word in words]

    def whole(self, word, least=0, below=10 ** 9):
        good = re.fullmatch("[0-9]{1,9}", word) and least <= int(word) < below
        self.check(good, f"a whole number from {least} to {below - 1}")
        return int(word)

    def one(self, key, least=0, below=10 ** 9):
        return self.whole(self.take(key, count=1)[0], least, below)

    def set(self, word, within):
        self.check(re.fullmatch("[0-9a-f]+", word) and not int(word, 16) & ~within, "a set of candidates of the block")
        return int(word, 16)

    def choice(self, word, *words):
        self.check(word in words, " or ".join(words))
        return word

    def groups(self, words, each):
        """Splits off a count and so many groups of `each` words; the rest of the words."""
        count = self.whole(words[0] if words else "")
        self.check(len(words) > count * each, f"{count} groups of {each} words")
        return words[1:1 + count * each], words[1 + count * each:]

    def end(self):
        self.take("digest", count=1)
        self.check(self.lines[self.at:] == [""], "the end")


class Certificate:
    """What has been refused, its lines and reasons, and what its conclusion says about its numbers."""

    def __init__(self):
        self.refusals, self.noise = [], False

    def attempt(self, line, prove, *what):
        """The result of a proof; None: it was refused."""
        try:
            return prove(*what)
        except Refused as why:
            self.refusals.append((line, str(why)))
            return None


def cover_flaw(nodes):
    """Why the nodes (U, R), sets as numbers, do not cover each sign pattern once, or None: proofs.md, "The cover"."""
    todo = [(nodes, 0)]
    while todo:
        nodes, decided = todo.pop()
        if not nodes:
            return "no node covers some sign patterns"
        undecided = [(u | r) & ~decided for u, r in nodes]
        common = functools.reduce(int.__and__, undecided)
        if 0 in undecided:
            if len(nodes) > 1:
                return "two nodes cover the same sign pattern"
        elif not common:
            return "the nodes do not form a tree"
        else:
            bit = common & -common
            todo += [([node for node in nodes if node[side] & bit], decided | bit) for side in (0, 1)]
    return None


# Wedged configurations and states under load: one decoupled block -----------------------------------------------------

class Block:
    """A decoupled block with modes G: K is replaced by P K P, P the projection onto the complement of the modes. F,
    with u = F f for forces f in equilibrium and G'u = 0, is the upper left part of the inverse of [K G; G' 0], and any
    multiple of G G' may be added to K. Candidates are counted within the block, but for `candidates`. Loads of a
    theorem are tuples: share of the dead load, forces on the candidates, clearances, and what cuts and a restriction of
    the sum of the normal reactions add to L."""

    def __init__(self, dimension, candidates, stiffness, motions, friction):
        self.d, self.candidates, self.K, self.G, self.mu = dimension, candidates, stiffness, motions, friction
        self.m, self.n, self.q = len(candidates), dimension * len(candidates), len(motions[0]) if motions else 0
        self.columns, self.trace = {}, None
        self.held, self.wedged, self.solid = [], set(), False
        self.GG = [[sum(g[i] * g[j] for g in self.G) for j in range(self.q)] for i in range(self.q)]
        for g in zip(*self.G):
            sizes = [sum(abs(x * y) for x, y in zip(row, g)) for row in self.K]
            if any(abs(dot(row, g)) * LARGE > max(sizes) for row in self.K):
                raise Refused("the motions are not rigid-body modes of K")
        self.eliminate()

    def eliminate(self):
        """Raises Refused unless K is positive definite, but on the modes, which are linearly independent."""
        (K, scale), columns = integer_matrix(self.K), [to_integers(g)[0] for g in zip(*self.G)]
        # Columns of nearly equal size, so that one multiple of G G' suits all of them.
        sizes = [max(map(abs, c)).bit_length() for c in columns]
        columns = [[x << max(sizes) - size for x in c] for c, size in zip(columns, sizes)]
        start = max(abs(x) for row in K for x in row).bit_length() - 2 * max(sizes, default=0)
        for change in (0, 8, -8, 16, 24, 32, 48, 64) if self.q else (-start,):
            power = start + change
            self.factor = Symmetric([[(x << max(0, -power)) + (sum(c[i] * c[j] for c in columns) << max(0, power))
                                      for j, x in enumerate(K[i])] + [c[i] for c in columns] for i in range(self.n)]
                                    + [c + [0] * self.q for c in columns])
            if min(self.factor.minors[:self.n]) > 0 and all(self.factor.minors):
                break
        else:
            raise Refused("K is not positive definite" + (", except on independent rigid-body modes" if self.q else ""))
        self.scale, self.unit = abs(self.factor.det), (scale << max(0, -power)) * (1 if self.factor.det > 0 else -1)

    def load(self, D, factor):
        """Forces on the candidates, and clearances, of a load: the dead load D times, and a factor of the other one."""
        return [D * x + factor * y for x, y in zip(self.dead, self.reference)], [D * g for g in self.gaps]

    def column(self, at):
        """`scale` times a column of F, in integers."""
        if at not in self.columns:
            unit = [int(i == at) for i in range(self.n + self.q)]
            self.columns[at] = [x * self.unit for x in self.factor.solve(unit)[:self.n]]
        return self.columns[at]

    def moved(self, a):
        """The displacements G a."""
        return [dot(row, a) for row in self.G] if self.q else [Fraction(0)] * self.n

    def on_modes(self, f, step=1):
        """The work of forces on the modes, G'f; step d: forces along the normals."""
        return [sum(row[j] * x for row, x in zip(self.G[::step], f) if x) for j in range(self.q)]

    def displaced(self, y, a):
        """w = F y + G a of forces y along the normals, in integers and their positive factor."""
        ys, scale = to_integers(y)
        moved, unit = to_integers(self.moved(a))
        w, scale = [g * scale * self.scale for g in moved], scale * self.scale * unit
        for k, yk in enumerate(ys):
            if yk:
                w = [x + yk * unit * c for x, c in zip(w, self.column(k * self.d))]
        return w, scale

    def negative(self, w, k, add):
        """Whether w_n + add + mu |w_t| < 0 at candidate k."""
        n, *t = w[k * self.d:(k + 1) * self.d]
        n += add
        return n < 0 and (self.mu[k] == 0 or n * n > self.mu[k] ** 2 * dot(t, t))

    @staticmethod
    def works(w, scale, y, loads):
        """L = w'p + y'g + what is added, of each load."""
        return [Fraction(dot(w, p)) / scale + dot(y, g) + extra for _, p, g, extra in loads]

    def excludes(self, separated, y, a, add, loads):
        """Whether these multipliers, in equilibrium, leave neither a reaction nor a load."""
        w, scale = self.displaced(y, a)
        return (all(self.negative(w, k, add[k] * scale) for k in range(self.m) if k not in separated)
                and all(L < 0 for L in self.works(w, scale, y, loads)))

    def balanced(self, contact, y, low, regular=0):
        """y changed by the least change, relative to what it may change, such that G_n'y = 0 and y >= low outside of
        the contact set. None: there is none."""
        most, G = max(map(abs, y), default=0) / 2 ** 20, self.G[::self.d]
        while True:
            room = [max(abs(x), most) if k in contact else x - low[k] for k, x in enumerate(y)]
            weights = [power_near(x) ** 2 if x > 0 else 0 for x in room]
            normal = [[sum(w * row[i] * row[j] for w, row in zip(weights, G)) for j in range(self.q)]
                      for i in range(self.q)]
            shift = max(normal[j][j] for j in range(self.q)) * regular
            x = solve([[z + shift * (i == j) for j, z in enumerate(row)] for i, row in enumerate(normal)],
                      self.on_modes(y, self.d))
            if x is None:
                return None
            y = [value - w * dot(row, x) for value, w, row in zip(y, weights, G)]
            below = [k for k in range(self.m) if k not in contact and y[k] < low[k]]
            if not below:
                return y
            # These stay at their least values, and the others are changed instead.
            y = [low[k] if k in below else x for k, x in enumerate(y)]

    def no_state(self, contact, separated, y, a, low, add, loads, with_wedged):
        """Raises Refused unless neither a state nor a wedged configuration is below a node: proofs.md, "Infeasible
        node". True if large displacements are left out. low: the least values of y outside of the contact set; add:
        what is added to w_n of each candidate; with_wedged: the argument "with wedged configurations" may be used."""
        y = [x if k in contact else max(x, low[k]) for k, x in enumerate(y)]
        starts = [y]
        if self.q:
            tiny, zero = max(map(abs, y)) / 10 ** 6, [Fraction(0)] * self.m
            without = [x if k in contact or x - low[k] >= tiny else low[k] for k, x in enumerate(y)]
            starts = [self.balanced(contact, each, low) for each in (y, without)] + [zero] * (max(low) <= 0)
        if any(start is not None and self.excludes(separated, start, a, add, loads) for start in starts):
            return False
        if self.q and with_wedged and any(self.excludes_by_motion(separated, a, loads, 10 ** i) for i in (9, 12, 14)):
            return False
        near = self.balanced(contact, y, low, Fraction(1, 2 ** 64)) if self.q else None
        if near is not None and self.excludes_near(separated, near, a, add, loads):
            return True
        raise Refused("its multipliers, in equilibrium, do not rule out every reaction and load")

    def excludes_by_motion(self, separated, a, loads, small):
        """Infeasible node with wedged configurations: a motion that leaves the candidates W at rest, and on which the
        loads J, without dead load, do no work, exactly, where the recorded one has less than 1 / small of its largest
        displacement. (A load with the dead load must be excluded itself, unless states under it alone are excepted.)"""
        w, d = self.moved(a), self.d
        most, may = max(map(abs, w)), [k for k in range(self.m) if k not in separated]
        rest = [k * d + j for k in may if all(abs(x) * small < most for x in w[k * d:(k + 1) * d]) for j in range(d)]
        idle = [load for load in loads
                if not load[0] and abs(dot(w, load[1])) * small <= most * sum(map(abs, load[1]))]
        free = null_space([self.G[i] for i in rest] + [self.on_modes(load[1]) for load in idle], self.q)
        motions = [self.moved(x) for x in free]
        amounts = solve([[dot(x, y) for y in motions] for x in motions], [dot(x, w) for x in motions])
        w = [sum(c * x[i] for c, x in zip(amounts, motions)) for i in range(self.n)]
        others = self.works(w, 1, [], [load for load in loads if load not in idle])
        return bool(others) and all(L < 0 for L in others) and all(
            self.negative(w, k, 0) or not any(w[k * d:(k + 1) * d]) for k in may)

    def closes_gaps(self, contact):
        """Whether motions that leave the normal displacements of a contact set zero close the gaps of all others."""
        normals = self.G[::self.d]
        fixed = [row for row, i in zip(normals, self.candidates) if contact >> i & 1]
        free, left = (len(null_space(rows, self.q)) for rows in (fixed, normals))
        return bool(self.q) and free - left == self.m - len(fixed)

    def excludes_near(self, separated, y, a, add, loads):
        """Infeasible node, except for large displacements: y is in equilibrium up to h = G (G'G)^-1 G'y, whose work is
        at most |h| LARGE |r| / s, where s = 1 / trace F is a lower bound of the other eigenvalues of P K P."""
        if self.trace is None:
            self.trace = sum(Fraction(self.column(i)[i], self.scale) for i in range(self.n))
        defect = self.on_modes(y, self.d)
        h = root_above(dot(defect, solve(self.GG, defect))) * LARGE * self.trace
        bound = h * root_above(1 + max(self.mu) ** 2)
        return self.excludes(separated, y, a, [x + bound for x in add],
                             [(D, p, g, extra + h * root_above(dot(p, p))) for D, p, g, extra in loads])

    def state(self, contact, separated, numbers, loaded, p, gaps):
        """The sum of the normal reactions of a state in the interior of its cone: proofs.md, "Feasible leaves" and
        "State". The unknowns are v and x, u = v + G x with G'v = 0, the multipliers of G'v = 0, the normal reactions,
        and the amounts of changes of the tangential ones along the modes that slide on U (these are free, and follow
        the recorded mean motion).

        @param numbers recorded tangential reactions of the candidates in contact, and mean motion
        @param loaded whether the state is under a load, and not a wedged configuration
        @param p forces on the candidates @param gaps u_n + gap = 0 on U, > 0 on R
        """
        if len(contact) + len(separated) != self.m or not (contact or loaded):
            raise Refused("not a pattern of all candidates of the block, with contact")
        d, n, q, K, G, f = self.d, self.n, self.q, self.K, self.G or [[]] * self.n, list(p)
        for i, k in enumerate(contact):
            for j in range(d - 1):
                f[k * d + 1 + j] += numbers[i * (d - 1) + j]
        fixed, a = [k * d for k in contact], numbers[len(contact) * (d - 1):]
        slides = null_space([G[i] for i in fixed], q, Fraction(1, 2 ** 40)) if q else []
        rough = {k * d + j for k in contact if self.mu[k] for j in range(1, d)}
        ways = [[x if i in rough else 0 for i, x in enumerate(self.moved(v))] for v in slides]
        KG, none = [[dot(row, g) for g in zip(*G)] for row in K], [0] * (len(fixed) + len(ways))
        rows = [K[i] + [0] * q + G[i] + [-int(i == j) for j in fixed] + [-way[i] for way in ways] for i in range(n)]
        rows += [[g[j] for g in G] + [0] * 2 * q + none for j in range(q)]
        rows += [[g[j] for g in KG] + [0] * q + self.GG[j] + none for j in range(q)]  # K v + G multipliers balance
        rows += [[int(i == j) for i in range(n)] + G[j] + [0] * q + none for j in fixed]
        rows += [[0] * n + [dot(row, v) for row in self.GG] + [0] * q + none for v in slides]
        f += [0] * 2 * q + [-gaps[k] for k in contact] + [dot(a, [dot(row, v) for row in self.GG]) for v in slides]
        found = solve(rows, f)
        if found is None:
            raise Refused("the reactions and loads are not in equilibrium")
        v, u = found[:n], [x + y for x, y in zip(found, self.moved(found[n:n + q]))]
        forces = [dot(row, v) + dot(g, found[n + q:]) - load for row, g, load in zip(K, G, p)]
        if any(self.on_modes([x + y for x, y in zip(forces, p)])) or any(self.on_modes(v)):
            raise Refused("the reactions and loads are not in equilibrium")
        for k in contact:
            rn, *rt = forces[k * d:(k + 1) * d]
            inside_cone = self.mu[k] ** 2 * rn * rn > dot(rt, rt) if self.mu[k] else not any(rt)
            if not (rn > 0 and inside_cone and u[k * d] + gaps[k] == 0):
                raise Refused(f"the reaction at candidate {self.candidates[k]} is not inside its friction cone")
        for k in separated:
            if not u[k * d] + gaps[k] > 0 or any(forces[k * d:(k + 1) * d]):
                raise Refused(f"candidate {self.candidates[k]} is not separated")
        return sum(forces[i] for i in fixed)

    def unloaded(self, contact, separated):
        """Whether equilibrium excludes a reaction of the contact set: proofs.md, "Contact without a reaction"."""
        may, d = [k for k in range(self.m) if k not in separated], self.d
        for a, b in ((a, b) for a in may for b in may if a < b):
            free = null_space(self.G[a * d:(a + 1) * d] + self.G[b * d:(b + 1) * d], self.q)
            for sign in (1, -1) if len(free) == 1 else ():
                w = [sign * x for x in self.moved(free[0])]
                moved = [k for k in may if any(w[k * d:(k + 1) * d])]
                if contact & set(moved) and all(self.negative(w, k, 0) for k in moved):
                    return True
        return False

    def prove_form(self, numbers):
        """No wedged configuration of the block, by a quadratic form of x = (r, a): proofs.md, "A quadratic form"."""
        d, m, n, take = self.d, self.m, self.n, iter(numbers)
        P = [[next(take) for _ in range(m)] for _ in range(m)]
        S = [[[next(take) for _ in range(d - 1)] for _ in range(m)] for _ in range(m)]
        sigma, N = [next(take) for _ in range(m)], [[next(take) if self.q else 0 for _ in range(m)] for _ in range(m)]
        if any(P[i][j] < 0 for i in range(m) for j in range(m) if i != j) or min(sigma) <= 0 or min(map(min, N)) < 0:
            raise Refused("a multiplier of the form is negative")
        modes, normals = [], self.G[::d]  # without those that slide on all candidates
        for j in range(self.q):
            if solve([[g[i] for i in modes] for g in normals], [g[j] for g in normals]) is None:
                modes.append(j)
        size = n + len(modes)
        U = [[Fraction(x, self.scale) for x in self.column(k * d)] + [self.G[k * d][j] for j in modes]
             for k in range(m)]
        NU = [[sum(N[i][j] * U[j][c] for j in range(m)) for c in range(size)] for i in range(m)]
        T = [[sum(U[i][r] * NU[i][c] for i in range(m)) for c in range(size)] for r in range(size)]
        for j in range(m):
            for c in range(size):
                T[c][j * d] += sum(P[i][j] * U[i][c] for i in range(m))
            for k in range(m):
                T[j * d][k * d] += self.mu[k] * root_above(dot(S[j][k], S[j][k]))
                for t in range(d - 1):
                    T[j * d][k * d + 1 + t] += S[j][k][t]
            for t in range(d):
                T[j * d + t][j * d + t] += sigma[j] * (-1 if t else self.mu[j] ** 2)
        kept = [i for i in range(size) if i >= n or i % d == 0 or self.mu[i // d]]
        most = max(abs(T[i][j] + T[j][i]) for i in kept for j in kept)
        for t in (Fraction(2) ** power * most for power in (range(-40, 41, 8) if self.q else (0,))):
            form = [[Fraction((t * dot(self.G[i], self.G[j]) if self.q and max(i, j) < n else 0) - T[i][j] - T[j][i])
                     for j in kept] for i in kept]
            if min(Symmetric(integer_matrix(form)[0]).minors) > 0:
                return
        raise Refused("the form is not negative definite")


# Certificates of wedged configurations and of states under load -------------------------------------------------------

class Theorem:
    """`none`: no state of a block is under a load of a cone; without loads, it has no other wedged pattern."""

    def __init__(self, line, block, loads, weights, bound, total, excepted):
        self.line, self.block, self.loads = line, block, loads
        self.excepted = excepted  # states under the dead load alone
        self.weights, self.bound = weights, bound  # of the loads in s, or none; of the normal reactions
        self.side, self.sum = bound or ("", total if loads else None)  # of a restriction of the sum
        self.nodes, self.far, self.complete = {}, False, False
        self.cuts = {"contact": {}, "separated": {}}  # B and A of the cuts, where they are not 1 and 0
        self.never, self.near_only = {"contact": set(), "separated": set()}, False  # a bound leaves far states out

    def count(self, cuts):
        """How many numbers the proof of a node has."""
        return self.block.m * (2 if cuts else 1) + self.block.q + (self.sum is not None)

    def no_state(self, contact, separated, numbers, cuts, opposite=None):
        """Raises Refused unless no state is below a node. True if large displacements are left out. With cuts, A_k v_nk
        + B_k r_nk <= s, all that earlier lines prove of the states of this theorem is used, and the opposite of a bound
        (candidate, side, beta, multiplier) may be assumed: proofs.md, "Bounds of candidates, and cuts"."""
        block, m, q = self.block, self.block.m, self.block.q
        y, a, rest = numbers[:m], numbers[m:m + q], numbers[m + q:]
        theta = rest.pop(0) if self.sum is not None else Fraction(0)
        if (self.side == "above" and theta < 0) or (self.side == "below" and theta > 0):
            raise Refused("the multiplier of the sum has the wrong sign")
        low, add, of_sum, eta = [Fraction(0)] * m, [theta] * m, Fraction(0), rest if cuts else []
        if any(x < 0 for x in eta):
            raise Refused("a multiplier of a cut is negative")
        if cuts:
            contact, separated = contact | self.never["separated"], separated | self.never["contact"]
            if contact & separated:
                return self.near_only
            low, of_sum = [-e * self.cuts["separated"].get(k, 0) for k, e in enumerate(eta)], sum(eta)
            add = [x - e * self.cuts["contact"].get(k, 1) for k, (x, e) in enumerate(zip(add, eta))]
            if opposite:
                k, side, beta, own = opposite
                of_sum -= own * beta
                (add if side == "contact" else low)[k] += own
        if not self.loads and len(separated) == m:
            return cuts and self.near_only
        of_grip = -theta * (self.sum or 0)
        loads = [(D and not (self.excepted and factor == 0), *block.load(D, factor), of_sum * c + of_grip * D)
                 for (D, factor), c in zip(self.loads, self.weights or [0] * len(self.loads))]
        far = block.no_state(contact, separated, y, a, low, [x + of_sum for x in add], loads,
                             loads and not cuts and theta == 0)
        return far or (cuts and self.near_only)

    def prove_bound(self, k, side, beta, numbers):
        """A bound of candidate k, or with beta None that it is never on this side; later statements use it."""
        own = numbers.pop() if beta is not None else None
        if beta is not None and (beta <= 0 or own <= 0):
            raise Refused("the bound or the multiplier of its negation is not positive")
        node = ({k}, set()) if side == "contact" else (set(), {k})
        self.near_only = self.no_state(*node, numbers, True, None if beta is None else (k, side, beta, own))
        if beta is None:
            self.never[side].add(k)
        else:
            self.cuts[side][k] = max(self.cuts[side].get(k, Fraction(side == "contact")), 1 / beta)


class Contact(Certificate):
    """`kusabi certificate 5 contact`: proves each statement as it is read."""

    def __init__(self, reader):
        super().__init__()
        self.read_problem(reader)
        self.read_theorems(reader)
        for _ in range(reader.one("bounds")):
            self.read_bound(reader)
        reader.take("evidence", count=0)
        start = reader.at
        while reader.peek() != "end":
            self.read_evidence(reader, *reader.take("infeasible", "cut", "form", "marginal", "wedged", "held", least=3))
        reader.check(reader.one("end") == reader.at - 1 - start, "the number of lines of evidence")
        reader.end()

    def read_problem(self, reader):
        d, m = reader.one("dimension", 2, 4), reader.one("candidates", 1, 4097)
        reader.check(len({" ".join(reader.take("name")) for _ in range(m)}) == m, "different names")
        self.d, self.mu, sets, seen = d, reader.reals(reader.take("friction"), m), [], 0
        reader.check(min(self.mu) >= 0, "friction coefficients >= 0")
        for _ in range(reader.one("blocks", 1, m + 1)):
            sets.append(reader.set(reader.take("block", count=1)[0], (1 << m) - 1 & ~seen))
            seen |= sets[-1]
        reader.check(seen == (1 << m) - 1 and all(sets) and sets == sorted(sets, key=lambda s: s & -s),
                     "blocks of all candidates, in the order of their first candidates")
        reader.take("stiffness", count=0)
        block_of = [next(b for b, s in enumerate(sets) if s >> i // d & 1) for i in range(d * m)]
        K = [reader.reals(reader.take(), i + 1) for i in range(d * m)]
        reader.check(all(block_of[i] == block_of[j] for i, row in enumerate(K) for j, x in enumerate(row) if x),
                     "zeros between blocks")
        modes = reader.one("motions")
        G = [reader.reals(reader.take(), modes) for _ in range(d * m)] if modes else []
        homes = [{block_of[i] for i in range(d * m) if G[i][j]} for j in range(modes)]
        reader.check(all(len(home) == 1 for home in homes), "modes that each move one block")
        self.loaded = reader.choice(reader.take("loads", count=1)[0], "0", "2") == "2"
        self.case, self.total, gaps, (dead, reference) = "", None, [Fraction(0)] * m, [[Fraction(0)] * d * m] * 2
        if self.loaded:
            self.case, gaps = " ".join(reader.take("case")), reader.reals(reader.take("clearance"), m)
            dead, reference = (self.without_noise(reader.reals(reader.take(key), d * m))
                               for key in ("dead", "reference"))
            total = reader.reals(reader.take("total"))
            reader.check(not total or (len(total) == len(sets) == 1 and total[0] > 0),
                         "no total, or one above 0, since it is that of the only block")
            self.total = total[0] if total else None
        self.blocks = []
        for b, each in enumerate(sets):
            candidates, mine = [k for k in range(m) if each >> k & 1], [j for j in range(modes) if homes[j] == {b}]
            rows = [k * d + j for k in candidates for j in range(d)]
            block = Block(d, candidates, [[K[max(i, j)][min(i, j)] for j in rows] for i in rows],
                          [[G[i][j] for j in mine] for i in rows] if mine else [], [self.mu[k] for k in candidates])
            block.set, block.gaps = each, [gaps[k] for k in candidates]
            block.dead, block.reference = [dead[i] for i in rows], [reference[i] for i in rows]
            # The dead load acts, and the reference load. A total makes the share of the dead load count.
            block.acts = any(block.dead) or any(block.gaps) or bool(self.total), any(block.reference)
            self.blocks.append(block)

    def without_noise(self, load):
        """The load with zeros in place of the rounding errors that its condensation leaves in their place."""
        small = [0 < abs(x) * NOISE <= max(map(abs, load)) for x in load]
        self.noise = self.noise or any(small)
        return [Fraction(0) if noise else x for x, noise in zip(load, small)]

    def read_theorems(self, reader):
        self.theorems, self.of_wedged = [], {}  # of_wedged: the one with N = 0, of each block
        for _ in range(reader.one("theorems")):
            words = reader.take("none", least=2)
            block = self.blocks[reader.whole(words[0], 1, len(self.blocks) + 1) - 1]
            numbers, rest = reader.groups([*words[1:], ""], 2)
            numbers, rest, bound, weights = reader.reals(numbers), rest[:-1], None, []
            loads = list(zip(numbers[::2], numbers[1::2]))
            if loads and rest[:1] == ["weights"]:
                weights, rest = reader.reals(rest[1:1 + len(loads)], len(loads)), rest[1 + len(loads):]
                reader.check(min(weights) > 0, "weights above 0")
            reader.check(all(D in (0, 1) and (D or R) for D, R in loads) and (self.loaded or not loads),
                         "loads, not zero")
            excepted = rest == ["except", "dead"]
            if excepted:
                reader.check(len(loads) == 2 and loads.count((1, 0)) == 1, "the dead load and another load")
            elif rest:
                reader.check(len(rest) == 2 and loads and not self.total, "a bound of the sum, without a total")
                bound = reader.choice(rest[0], "above", "below"), reader.real(rest[1])
                reader.check(bound[1] >= 0, "a sum that is not negative")
            self.theorems.append(Theorem(reader.at, block, loads, weights, bound, self.total, excepted))
            if not loads:
                reader.check(block not in self.of_wedged, "one such theorem of a block")
                self.of_wedged[block] = self.theorems[-1]
        reader.check(self.loaded or len(self.of_wedged) in (0, len(self.blocks)), "one theorem for each block")

    def read_bound(self, reader):
        key, words = reader.take("bound", "never", least=3)
        theorem = self.theorems[reader.whole(words[0], 1, len(self.theorems) + 1) - 1]
        at, side = reader.whole(words[1]), reader.choice(words[2], "contact", "separated")
        reader.check(at in theorem.block.candidates, "a candidate of the block")
        reader.check(theorem.weights or not theorem.loads, "a theorem with weights of its loads")
        numbers = reader.reals(words[3:], theorem.count(True) + 2 * (key == "bound"))
        beta = numbers.pop(0) if key == "bound" else None
        self.attempt(reader.at, theorem.prove_bound, theorem.block.candidates.index(at), side, beta, numbers)

    def read_evidence(self, reader, key, words):
        line, first, of_state = reader.at, 3 if key == "held" else 1, key in ("wedged", "held")
        reader.check(len(words) >= first + 2, "more words")
        number = reader.whole(words[0], 1, len(self.blocks if of_state else self.theorems) + 1) - 1
        theorem = None if of_state else self.theorems[number]
        block = theorem.block if theorem else self.blocks[number]
        node = U, R = tuple(reader.set(word, block.set) for word in words[first:first + 2])
        reader.check(not U & R, "no candidate both in contact and separated")
        contact, separated = ({i for i, k in enumerate(block.candidates) if each >> k & 1} for each in node)
        numbers, m, q = reader.reals(words[first + 2:]), block.m, block.q
        if of_state:
            load = reader.reals(words[1:3]) if key == "held" else [Fraction(0)] * 2
            reader.check(load[0] in (0, 1) and (key == "wedged" or self.loaded and any(load)), "a load, not zero")
            reader.check(len(numbers) == len(contact) * (self.d - 1) + q, "tangential reactions and a motion")
            total = self.attempt(line, block.state, sorted(contact), separated, numbers, any(load), *block.load(*load))
            if key == "held":
                if total is not None and (not self.total or abs(total - self.total) * 10 ** 6 <= self.total):
                    block.held.append((U, *load, total))  # with a total, other states are of no use
                return
            if total is not None:
                block.wedged.add(node)
                # Solid: some of these have contacts whose reactions can balance every load.
                free = [k * self.d + j for k in contact for j in range(self.d if block.mu[k] else 1)]
                block.solid = block.solid or not null_space([block.G[i] for i in free] if q else [], q)
        else:
            reader.check(key in ("infeasible", "marginal") or not theorem.loads or (key == "cut" and theorem.weights),
                         "a theorem without loads, or with their weights")
            reader.check(key != "form" or not U | R, "two empty sets")
            expected = {"infeasible": theorem.count(False), "cut": theorem.count(True),
                        "form": m * m * (self.d + bool(q)) + m}
            reader.check(len(numbers) == expected.get(key, 0), f"{expected.get(key, 0)} numbers")
        # Of the statements about a node the first is used, and the others must agree with it.
        claim = key if key in ("wedged", "marginal") else "infeasible"
        theorem = theorem or self.of_wedged.setdefault(block, Theorem(line, block, [], [], None, None, False))
        known = theorem.nodes.get(node)
        theorem.nodes.setdefault(node, claim)
        if known:
            if known not in (claim, "refused") and (known, claim) != ("unloaded", "marginal"):
                self.refusals.append((line, f"the node is {known} in a line before"))
        elif key == "marginal":
            if not theorem.loads and q and block.unloaded(contact, separated):
                theorem.nodes[node] = "unloaded"
        elif key != "wedged":
            far = (self.attempt(line, lambda: bool(block.prove_form(numbers))) if key == "form" else
                   self.attempt(line, theorem.no_state, contact, separated, numbers, key == "cut"))
            theorem.nodes[node] = "refused" if far is None else claim
            theorem.far = theorem.far or bool(far)

    def conclusion(self):
        """The sentence and the exit code."""
        for theorem in self.theorems:
            flaw = cover_flaw(list(theorem.nodes))
            if flaw:
                self.refusals.append((theorem.line, flaw))
            theorem.complete = not flaw and not {"refused", "marginal"} & set(theorem.nodes.values())
        sentence, code = self.of_loads() if self.loaded else self.of_list()
        return ("NOT PROVED", 1) if self.refusals else (sentence, code)

    def of_list(self):
        patterns = counted(sum(len(block.wedged) for block in self.blocks), "pattern")
        if not self.theorems:
            if patterns[0] == "0":
                self.refusals.append((0, "neither theorems nor a wedged configuration that is proved"))
            return f"PROVED: it can stick, by {patterns}; other patterns are not decided", 0
        claims = [claim for theorem in self.theorems for claim in theorem.nodes.values()]
        far = FAR if any(t.far for t in self.theorems) else ""
        marginal = claims.count("marginal")
        if marginal == len(claims):
            return "NOTHING PROVED: all nodes are marginal, and the certificate claims nothing about them", 3
        if marginal:
            return (f"PROVED except for {counted(marginal, 'marginal node')}: the list of {patterns} is complete"
                    f"{far and far + ','} except for these"), 3
        return f"PROVED: the list of {patterns} is complete{': it cannot stick' * (patterns[0] == '0')}{far}", 0

    def of_loads(self):
        """proofs.md, "Conclusions". A structure holds the factors that all of its blocks hold."""
        held, none, far = [(-INFINITE, INFINITE)], [], False
        for block in self.blocks:
            mine, ways = [t for t in self.theorems if t.block is block and t.loads and t.complete], {}
            far = far or any(t.far for t in mine)
            for pattern, D, factor, _ in block.held:
                if D or not self.total:
                    ways.setdefault(pattern, []).append((D, factor))
            if block.set in ways:  # the states whose gaps a motion closes are also those of all contacts
                ways[block.set] += [load for pattern in ways if pattern != block.set and block.closes_gaps(pattern)
                                    for load in ways[pattern] if load[0]]
            own = [factors(loads, *block.acts) for loads in ways.values()]
            out = [ends for t in mine if not t.bound for ends in excluded(t.loads, t.excepted, *block.acts)]
            if not self.total and (block.solid or not block.q or not any(block.acts)):
                own = [(-INFINITE, INFINITE)]
            elif block.acts == (False, True) and not self.total:
                own.append((Fraction(0), Fraction(0)))
            common = [(max(a[0], b[0]), min(a[1], b[1])) for a in own for b in out]
            if any(low <= high for low, high in common):
                self.refusals.append((0, "THIS CHECKER IS WRONG: a load factor is both held and excluded"))
            held = [(max(a[0], b[0]), min(a[1], b[1])) for a in held for b in united(own)]
            held, none = united(held), united(none + out)
        grip, parts = self.grip_text(), []
        if not held and not none and not grip:
            return "NOTHING PROVED: the certificate has neither a state nor a complete tree", 3
        if not any(block.acts[1] for block in self.blocks) or held + none == [(0, 0)]:
            parts += ["it can hold the dead load"] * bool(held) + ["it cannot hold the dead load"] * bool(none)
        else:
            can, cannot = (", ".join(map(range_text, each)) for each in (held, none))
            parts += [f"it can hold these factors of the reference load: {can}"] * bool(held)
            parts += [f"it cannot hold: {cannot}"] * bool(none)
        text = (f"PROVED: at friction coefficient {shortest(max(self.mu))}" if min(self.mu) == max(self.mu) else
                "PROVED: at the friction coefficients of the certificate")
        text += f" in load case {in_quotes(self.case)}" if self.case else ""
        text += f" and with normal reactions that add up to {shortest(self.total)}" if self.total else ""
        return f"{text}, {'; '.join(parts + [grip] * bool(grip))}{'; all' + FAR if far else ''}", 0

    def grip_text(self):
        """What is proved of the sum of the normal reactions of all states under the dead load."""
        if not any(theorem.bound for theorem in self.theorems):
            return ""
        below, above, low, high = [], [], [], []  # of each block
        for block in self.blocks:
            bounds = {"below": [Fraction(0)], "above": []}
            for t in self.theorems:
                least, most = factors(t.loads, True, True)
                if t.block is block and t.bound and t.complete and least <= 0 <= most:
                    bounds[t.bound[0]].append(t.bound[1])
            sums = [total for _, D, factor, total in block.held if D and factor == 0]
            if not block.acts[0]:
                sums, wedged = [Fraction(0)], self.of_wedged.get(block)
                if wedged and wedged.complete and not block.wedged and not wedged.far:
                    bounds["above"].append(Fraction(0))
            below.append(max(bounds["below"]))
            above.append(min(bounds["above"], default=None))
            low.append(min(sums, default=None))
            high.append(max(sums, default=None))
        text = f"the normal reactions of every state under the dead load add up to {rounded(sum(below), -1)} or more"
        text += "" if None in above else f" and {rounded(sum(above), 1)} or less"
        text += "" if None in low else ", those of some states to {} and {}".format(*inside(sum(low), sum(high)))
        return text if any(below) or None not in above or None not in low else ""


def factors(loads, dead, reference):
    """The least and the largest factor of the reference load, beside the dead load once, in a convex cone of loads
    (D, R). dead, reference: whether these loads act."""
    points = [R for D, R in loads if D] if dead else [Fraction(0)] * any(R for _, R in loads)
    if not points or not reference:
        return (-INFINITE, INFINITE) if points else (INFINITE, -INFINITE)
    rays = [R for D, R in loads if not (D and dead)]
    return -INFINITE if any(R < 0 for R in rays) else min(points), INFINITE if any(R > 0 for R in rays) else max(points)


def excluded(loads, excepted, dead, reference):
    """Ranges of factors that a cone without states excludes. Without dead load these are all of a sign, but not 0, and
    likewise if states under the dead load alone are excepted; the ends are then the doubles beside it."""
    least = Fraction(1, 2 ** 1074)
    if dead and excepted:
        low, high = factors(loads, dead, reference)
        return [(low or least, high or -least)] * reference
    if dead or not reference:
        return [factors(loads, dead, reference)] * dead
    return [(least, INFINITE)] * any(R > 0 for _, R in loads) + [(-INFINITE, -least)] * any(R < 0 for _, R in loads)


def united(ranges):
    """Disjoint ranges in ascending order."""
    found = []
    for low, high in sorted(each for each in ranges if each[0] <= each[1]):
        if found and low <= found[-1][1]:
            found[-1] = found[-1][0], max(high, found[-1][1])
        else:
            found.append((low, high))
    return found


def range_text(ends):
    low, high = ends
    if -low == high == INFINITE:
        return "all factors"
    if -low == INFINITE:
        return "below 0" if double(high, -1) == -math.ulp(0) else f"up to {rounded(high, -1)}"
    if high == INFINITE:
        return "above 0" if double(low, 1) == math.ulp(0) else f"from {rounded(low, 1)} on"
    return shortest(low) if low == high else "from {} to {}".format(*inside(low, high))


def main(path):
    try:
        reader = Reader(path)
        version, _, kind = reader.lines[0].rpartition(" ")
        reader.check(version == "kusabi certificate 5", "'kusabi certificate 5'")
        if reader.choice(kind, "contact", "truss") == "contact":
            checked = Contact(reader)
        else:
            import second_checker_loads  # only for these certificates; it imports from this module
            checked = second_checker_loads.Truss(reader)
        sentence, code = checked.conclusion()
        for line, why in sorted(checked.refusals):
            print(f"{path}:{line}: refused: {why}")
        noise = ", entries of a load below 2^-60 of its largest taken as zero" if checked.noise else ""
    except (Refused, OverflowError, RecursionError) as why:
        print(f"{path}:{reader.at}: refused: {why}")
        sentence, code, noise = "NOT PROVED", 1, ""
    except Malformed as error:
        print(error, file=sys.stderr)
        return 2
    print(f"the claim is about the numbers in this certificate{noise}; that they are those of a structure is what "
          "kusabi verify --problem adds")
    print(sentence)
    return code


if __name__ == "__main__":
    sys.modules["second_checker"], sys.dont_write_bytecode = sys.modules["__main__"], True
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else print(__doc__) or 2)
