"""Structure in 80 digits, as a reference whose rounding errors are independent of `kusabi`.

Reads a problem file with the TOML reader of the standard library and assembles stiffness and
compliance in decimal arithmetic. The doubles of the file are taken as exact. Only the meaning of
problem files (docs/problem-files.md) is shared with the program.
"""

import tomllib
from decimal import Decimal, getcontext

DIGITS = 80
getcontext().prec = DIGITS

#: Relative size below which an entry of the compliance is an exact zero: far above 10^-80 times
#: the condition numbers here, far below the rounding errors of sums in doubles.
ZERO = Decimal("1e-45")


class Structure:
    """The plain content of a problem file.

    nodes: {name: [float]}; bars: [(EA, a, b)]; quads: [(E, nu, thickness, plane, [4 names])];
    fixed: {name: set of axes}; candidates: [(name, normal, tangent or None, friction)].
    """

    def __init__(self, dimension):
        self.dimension = dimension
        self.nodes = {}
        self.bars = []
        self.quads = []
        self.fixed = {}
        self.candidates = []


def _place_mesh(structure, mesh, alias, edges):
    """Nodes and elements of a [[mesh]], by the bilinear map of its corners in doubles."""
    columns, rows = mesh["divisions"]
    corners = [[float(x) for x in corner] for corner in mesh["corners"]]
    size = max(max(c[k] for c in corners) - min(c[k] for c in corners) for k in (0, 1))
    numbers = {}
    for j in range(rows + 1):
        for i in range(columns + 1):
            x, y = i / columns, j / rows
            weights = ((1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y)
            place = [sum(w * c[k] for w, c in zip(weights, corners)) for k in (0, 1)]
            name = f"{mesh['name']}.{i},{j}"
            at = next((other for other, where in structure.nodes.items()
                       if max(abs(where[k] - place[k]) for k in (0, 1)) <= 1e-9 * size), None)
            if at is None:
                structure.nodes[name] = place
                at = name
            alias[name] = at
            numbers[i, j] = at
    head = mesh["name"]
    edges[head + ".left"] = [numbers[0, j] for j in range(rows + 1)]
    edges[head + ".right"] = [numbers[columns, j] for j in range(rows + 1)]
    edges[head + ".bottom"] = [numbers[i, 0] for i in range(columns + 1)]
    edges[head + ".top"] = [numbers[i, rows] for i in range(columns + 1)]
    for j in range(rows):
        for i in range(columns):
            between = [numbers[i, j], numbers[i + 1, j], numbers[i + 1, j + 1], numbers[i, j + 1]]
            structure.quads.append((float(mesh["E"]), float(mesh["nu"]), float(mesh["thickness"]), mesh["plane"], between))


def from_toml(text):
    """The structure of a problem file's text."""
    table = tomllib.loads(text)
    structure = Structure(table["dimension"])
    structure.nodes = {name: [float(x) for x in place] for name, place in table.get("nodes", {}).items()}
    alias = {name: name for name in structure.nodes}
    edges = {}
    for mesh in table.get("mesh", []):
        _place_mesh(structure, mesh, alias, edges)
    for group in table.get("members", []):
        structure.bars += [(float(group["EA"]), alias[a], alias[b]) for a, b in group["between"]]
    for group in table.get("elements", []):
        for between in group["between"]:
            structure.quads.append((float(group["E"]), float(group["nu"]), float(group["thickness"]), group["plane"],
                                    [alias[name] for name in between]))

    def expand(names):
        return [node for name in names for node in (edges[name] if name in edges else [alias[name]])]

    for group in table.get("supports", []):
        axes = {"xyz".index(axis) for axis in group.get("fixed", "xyz"[: structure.dimension])}
        for node in expand(group["nodes"]):
            structure.fixed.setdefault(node, set()).update(axes)
    for group in table.get("contact", []):
        for node in expand(group["nodes"]):
            structure.candidates.append((node, [float(x) for x in group["normal"]], group.get("tangent"),
                                         float(group.get("friction_factor", group.get("friction", 1.0)))))
    return structure


def to_toml(structure, name="hostile"):
    """Problem file of a structure with one group per element, support and candidate. Numbers keep
    all bits."""
    lines = [f'name = "{name}"', f"dimension = {structure.dimension}", 'units = { length = "m", force = "kN" }', "", "[nodes]"]
    lines += [f'"{node}" = {[float(x) for x in place]}' for node, place in structure.nodes.items()]
    for stiffness, a, b in structure.bars:
        lines += ["", "[[members]]", f"EA = {stiffness!r}", f'between = [["{a}", "{b}"]]']
    for modulus, ratio, thickness, plane, between in structure.quads:
        quoted = ", ".join(f'"{node}"' for node in between)
        lines += ["", "[[elements]]", f"E = {modulus!r}", f"nu = {ratio!r}", f"thickness = {thickness!r}",
                  f'plane = "{plane}"', f"between = [[{quoted}]]"]
    for node, axes in structure.fixed.items():
        lines += ["", "[[supports]]", f'nodes = ["{node}"]']
        if len(axes) < structure.dimension:
            lines += ["fixed = [" + ", ".join(f'"{"xyz"[axis]}"' for axis in sorted(axes)) + "]"]
    for node, normal, tangent, friction in structure.candidates:
        lines += ["", "[[contact]]", f'nodes = ["{node}"]', f"normal = {[float(x) for x in normal]}"]
        if tangent is not None:
            lines += [f"tangent = {[float(x) for x in tangent]}"]
        if friction != 1.0:
            lines += [f"friction_factor = {friction!r}"]
    return "\n".join(lines) + "\n"


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Decimal(0))


def unit(vector):
    vector = [Decimal(x) for x in vector]
    length = dot(vector, vector).sqrt()
    return [x / length for x in vector]


def frame(normal):
    """Exact unit normal, and unit tangents. The choice of tangents does not matter, since only
    |r_t| is used."""
    n = unit(normal)
    if len(n) == 2:
        return [n, [n[1], -n[0]]]
    axis = min(range(3), key=lambda k: abs(n[k]))
    across = [(Decimal(1) if k == axis else Decimal(0)) - n[axis] * n[k] for k in range(3)]
    t1 = unit(across)
    t2 = [n[1] * t1[2] - n[2] * t1[1], n[2] * t1[0] - n[0] * t1[2], n[0] * t1[1] - n[1] * t1[0]]
    return [n, t1, t2]


def _bar_strain(structure, bar):
    """Weighted strain vector {(node, axis): value} whose square is the bar's stiffness."""
    stiffness, a, b = bar
    along = [Decimal(y) - Decimal(x) for x, y in zip(structure.nodes[a], structure.nodes[b])]
    square = dot(along, along)
    weight = (Decimal(stiffness) / (square * square.sqrt())).sqrt()
    strain = {}
    for axis, extent in enumerate(along):
        if extent != 0:
            strain[a, axis] = -weight * extent
            strain[b, axis] = weight * extent
    return [strain]


def _quad_strain(structure, quad):
    """Strain vectors of a four-node element at 2 x 2 points: eigen-strains of the isotropic law, so no root of a matrix
    is needed: (xx + yy), (xx - yy) and the shear are independent of one another."""
    modulus, ratio, thickness, plane, between = quad
    modulus, ratio, thickness = Decimal(modulus), Decimal(ratio), Decimal(thickness)
    shear = modulus / (2 * (1 + ratio))
    if plane == "stress":
        bulk = modulus / (2 * (1 - ratio))
    else:
        bulk = modulus / (2 * (1 + ratio) * (1 - 2 * ratio))
    places = [[Decimal(x) for x in structure.nodes[node]] for node in between]
    signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    gauss = 1 / Decimal(3).sqrt()
    vectors = []
    for px, py in signs:
        xi, eta = gauss * px, gauss * py
        slope = [(sx * (1 + sy * eta) / 4, sy * (1 + sx * xi) / 4) for sx, sy in signs]
        jac = [[sum(slope[c][k] * places[c][axis] for c in range(4)) for axis in (0, 1)] for k in (0, 1)]
        det = jac[0][0] * jac[1][1] - jac[0][1] * jac[1][0]
        inverse = [[jac[1][1] / det, -jac[0][1] / det], [-jac[1][0] / det, jac[0][0] / det]]
        grad = [[inverse[axis][0] * slope[c][0] + inverse[axis][1] * slope[c][1] for axis in (0, 1)] for c in range(4)]
        area = thickness * abs(det)
        for factor, parts in (((area * bulk).sqrt(), ((0, 0, 1), (1, 1, 1))),
                              ((area * shear).sqrt(), ((0, 0, 1), (1, 1, -1))),
                              ((area * shear).sqrt(), ((0, 1, 1), (1, 0, 1)))):
            strain = {}
            for c, node in enumerate(between):
                for axis, slope_axis, sign in parts:
                    value = sign * factor * grad[c][slope_axis]
                    strain[node, axis] = strain.get((node, axis), Decimal(0)) + value
            vectors.append(strain)
    return vectors


class Mechanism(Exception):
    """The stiffness is singular, or nearly so that sixteen digits have no meaning."""


def compliance(structure):
    """F of the candidates in (n, t1[, t2]) each: list of rows, dm x dm, in 80 digits.

    @raises Mechanism if a pivot vanishes
    """
    d = structure.dimension
    number = {}
    for node in structure.nodes:
        for axis in range(d):
            if axis not in structure.fixed.get(node, ()):
                number[node, axis] = len(number)
    size = len(number)
    matrix = [[Decimal(0)] * size for _ in range(size)]
    for vector in [s for bar in structure.bars for s in _bar_strain(structure, bar)] + \
                  [s for quad in structure.quads for s in _quad_strain(structure, quad)]:
        entries = [(number[key], value) for key, value in vector.items() if key in number]
        for i, x in entries:
            for j, y in entries:
                if j <= i:
                    matrix[i][j] += x * y
    start = [matrix[i][i] for i in range(size)]
    for i in range(size):  # Cholesky factorisation in place, lower triangle
        row = matrix[i]
        for j in range(i):
            other = matrix[j]
            value = row[j]
            for k in range(j):
                if row[k] and other[k]:
                    value -= row[k] * other[k]
            row[j] = value / other[j] if value else value
        pivot = row[i] - sum(x * x for x in row[:i] if x)
        if start[i] <= 0 or pivot <= start[i] * Decimal("1e-22"):
            raise Mechanism(i)
        row[i] = pivot.sqrt()
    loads = []
    for node, normal, _, _ in structure.candidates:
        for direction in frame(normal):
            load = [Decimal(0)] * size
            for axis in range(d):
                load[number[node, axis]] = direction[axis]
            for i in range(size):
                value = load[i]
                row = matrix[i]
                for k in range(i):
                    if row[k] and load[k]:
                        value -= row[k] * load[k]
                load[i] = value / row[i] if value else value
            loads.append(load)
    flexibility = [[dot(a, b) for b in loads] for a in loads]
    for i, row in enumerate(flexibility):  # entries that cancel to the last digits are zero
        for j in range(len(row)):
            if abs(row[j]) < ZERO * (flexibility[i][i] * flexibility[j][j]).sqrt():
                row[j] = Decimal(0)
    return flexibility


def blocks(flexibility, d):
    """Candidates coupled by the compliance: lists of indices, in order of the first."""
    m = len(flexibility) // d
    left = list(range(m))
    result = []
    while left:
        block, front = [], [left.pop(0)]
        while front:
            i = front.pop()
            block.append(i)
            near = [j for j in left if any(flexibility[i * d + a][j * d + b] for a in range(d) for b in range(d))]
            front += near
            left = [j for j in left if j not in near]
        result.append(sorted(block))
    return result
