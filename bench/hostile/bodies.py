"""Structures of bodies, constrained or not, in 80 digits: pairs, nodes with several normals, triangles, tetrahedra.

Reads problem files by itself (nodes, members, in the plane elements of three or four nodes, in space of four, supports along
the axes, candidates with weights; no springs). The compliance of an unconstrained body requires grounding springs; reactions in equilibrium cause
no force in these, so u = F r + G a with any a, and G'r = 0. Nodes of a pair that differ by the rounding of their
coordinates are moved together exactly.
"""

import tomllib
from decimal import Decimal, localcontext
from fractions import Fraction

import structure
from structure import ZERO, dot, frame


class Candidate:
    """node, outward normal, friction, and [(node, weight)] of the place that it is against."""

    def __init__(self, node, normal, friction, against):
        self.node, self.normal, self.friction, self.against = node, normal, friction, against


class Bodies:
    """Contents of a problem file: as structure.Structure, with candidates as above; names of the
    candidates."""

    def __init__(self, text):
        table = tomllib.loads(text)
        self.dimension = table["dimension"]
        self.nodes = {name: [float(x) for x in place] for name, place in table["nodes"].items()}
        self.bars = [(float(g["EA"]), a, b) for g in table.get("members", []) for a, b in g["between"]]
        self.elements = [(float(g["E"]), float(g["nu"]), float(g.get("thickness", 1)), g.get("plane"), list(between))
                         for g in table.get("elements", []) for between in g["between"]]
        self.fixed = {}
        for group in table.get("supports", []):
            for node in group["nodes"]:
                self.fixed.setdefault(node, set()).update("xyz".index(axis) for axis in group.get("fixed", "xyz"[:self.dimension]))
        self.candidates = []
        for group in table["contact"]:
            for i, node in enumerate(group["nodes"]):
                place = group["against"][i] if "against" in group else {"nodes": [], "weights": []}
                self.candidates.append(Candidate(node, [float(x) for x in group["normal"]], float(group.get("friction_factor", group.get("friction", 1))),
                                                 list(zip(place["nodes"], map(float, place["weights"])))))
        self._place()
        self.names = [self._name(i) for i in range(len(self.candidates))]

    def _place(self):
        """Exact positions of all nodes, converted to decimals for nodes that were moved."""
        self.places = {name: [Fraction(x) for x in place] for name, place in self.nodes.items()}
        for own in self.candidates:
            if not own.against:
                continue
            place = [sum(Fraction(weight) * self.places[node][axis] for node, weight in own.against) for axis in range(self.dimension)]
            largest = max(abs(x) for node in [own.node, *(n for n, _ in own.against)] for x in self.places[node])
            off = max(abs(x - y) for x, y in zip(place, self.places[own.node]))
            if 0 < off <= largest * Fraction(1, 2 ** 48):
                self.places[own.node] = place
                with localcontext() as context:
                    context.prec = 140
                    self.nodes[own.node] = [Decimal(x.numerator) / Decimal(x.denominator) for x in place]

    def _name(self, index):
        own = self.candidates[index]
        same = [i for i, other in enumerate(self.candidates) if other.node == own.node]
        name = own.node + (f"@{same.index(index) + 1}" if len(same) > 1 else "")
        if own.against:
            name += "|" + max(own.against, key=lambda part: part[1])[0] + ("+" if len(own.against) > 1 else "")
        return name

    def is_ground(self, node):
        return self.fixed.get(node, set()) == set(range(self.dimension))


def _bodies(bodies):
    """Connected parts: [(own nodes, fixed nodes connected to them)]."""
    parent = {node: node for node in bodies.nodes if not bodies.is_ground(node)}

    def root(node):
        while parent[node] != node:
            node = parent[node]
        return node

    links = [[a, b] for _, a, b in bodies.bars] + [between for *_, between in bodies.elements]
    for nodes in links:
        own = [node for node in nodes if node in parent]
        for node in own[1:]:
            parent[root(node)] = root(own[0])
    result = {}
    for node in parent:
        result.setdefault(root(node), ([], []))[0].append(node)
    for nodes in links:
        own = [node for node in nodes if node in parent]
        if own:
            result[root(own[0])][1].extend(node for node in nodes if node not in parent)
    return list(result.values())


def _lever(bodies, centre, node, axis):
    """Row of a motion (vx, vy, w), in space (vx, vy, vz, wx, wy, wz), about a centre, at a node along an axis, exactly."""
    arm = [x - c for x, c in zip(bodies.places[node], bodies.places[centre])]
    if bodies.dimension == 2:
        return [Fraction(axis == 0), Fraction(axis == 1), -arm[1] if axis == 0 else arm[0]]
    turns = [Fraction(0)] * 3
    turns[(axis + 1) % 3], turns[(axis + 2) % 3] = arm[(axis + 2) % 3], -arm[(axis + 1) % 3]
    return [Fraction(axis == k) for k in range(3)] + turns


def _left(columns, row):
    """The subspace of the columns (vectors) with row'x = 0, and the column removed, or None."""
    products = [sum(a * b for a, b in zip(row, column)) for column in columns]
    pivot = next((k for k, value in enumerate(products) if value), None)
    if pivot is None:
        return columns, None
    taken = columns[pivot]
    rest = [[a - products[k] / products[pivot] * b for a, b in zip(column, taken)]
            for k, column in enumerate(columns) if k != pivot]
    return rest, taken


def _motions(bodies):
    """[(centre, nodes of the body, a motion)] of all bodies, and as many grounding springs (node,
    axis) as they need."""
    result, springs = [], []
    for nodes, ground in _bodies(bodies):
        centre = nodes[0]
        count = 3 if bodies.dimension == 2 else 6
        left = [[Fraction(i == k) for i in range(count)] for k in range(count)]
        for node in nodes + ground:
            for axis in bodies.fixed.get(node, ()):
                left, _ = _left(left, _lever(bodies, centre, node, axis))
        result += [(centre, set(nodes), motion) for motion in left]
        while left:
            best = max(((abs(sum(a * b for a, b in zip(_lever(bodies, centre, node, axis), left[0]))), node, axis)
                        for node in nodes for axis in range(bodies.dimension) if axis not in bodies.fixed.get(node, ())))
            springs.append(best[1:])
            left, _ = _left(left, _lever(bodies, centre, *best[1:]))
    return result, springs


def _strain_vector(factor, parts, between, grad):
    """A share of the strains of an element, by node and axis. @param parts axis, slope and sign of each term"""
    strain = {}
    for corner, node in enumerate(between):
        for axis, slope, share in parts:
            strain[node, axis] = strain.get((node, axis), Decimal(0)) + share * factor * grad[corner][slope]
    return strain


def _triangle_strain(bodies, element):
    """Strain vectors of a triangle, in the format of structure._quad_strain."""
    modulus, ratio, thickness, plane, between = element
    modulus, ratio, thickness = Decimal(modulus), Decimal(ratio), Decimal(thickness)
    shear = modulus / (2 * (1 + ratio))
    bulk = modulus / (2 * (1 - ratio)) if plane == "stress" else modulus / (2 * (1 + ratio) * (1 - 2 * ratio))
    places = [[Decimal(x) for x in bodies.nodes[node]] for node in between]
    double = sum(places[i][0] * (places[(i + 1) % 3][1] - places[(i + 2) % 3][1]) for i in range(3))
    grad = [[(places[(i + 1) % 3][1] - places[(i + 2) % 3][1]) / double,
             (places[(i + 2) % 3][0] - places[(i + 1) % 3][0]) / double] for i in range(3)]
    area = thickness * abs(double) / 2
    vectors = []
    for factor, parts in (((area * bulk).sqrt(), ((0, 0, 1), (1, 1, 1))), ((area * shear).sqrt(), ((0, 0, 1), (1, 1, -1))),
                          ((area * shear).sqrt(), ((0, 1, 1), (1, 0, 1)))):
        vectors.append(_strain_vector(factor, parts, between, grad))
    return vectors


def _tetrahedron_strain(bodies, element):
    """Strain vectors of a tetrahedron: the volume, both differences of the normal strains, and the shears."""
    modulus, ratio, *_, between = element
    modulus, ratio = Decimal(modulus), Decimal(ratio)
    shear, bulk = modulus / (2 * (1 + ratio)), modulus / (3 * (1 - 2 * ratio))
    places = [[Decimal(x) for x in bodies.nodes[node]] for node in between]

    def cross(a, b):
        return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]

    def minus(a, b):
        return [x - y for x, y in zip(a, b)]

    edges = [minus(place, places[0]) for place in places[1:]]
    six = dot(cross(edges[0], edges[1]), edges[2])
    grad = [[x / six for x in cross(edges[(k + 1) % 3], edges[(k + 2) % 3])] for k in range(3)]
    grad.insert(0, [-sum(g[axis] for g in grad) for axis in range(3)])
    volume = abs(six) / 6
    vectors = []
    for square, parts in ((bulk, ((0, 0, 1), (1, 1, 1), (2, 2, 1))), (shear, ((0, 0, 1), (1, 1, -1))),
                          (shear / 3, ((0, 0, 1), (1, 1, 1), (2, 2, -2))),
                          *((shear, ((k, (k + 1) % 3, 1), ((k + 1) % 3, k, 1))) for k in range(3))):
        vectors.append(_strain_vector((volume * square).sqrt(), parts, between, grad))
    return vectors


def _element_strain(bodies, element):
    if bodies.dimension == 3:
        return _tetrahedron_strain(bodies, element)
    return (_triangle_strain if len(element[4]) == 3 else structure._quad_strain)(bodies, element)


def _stiffness(bodies, number, springs):
    size = len(number)
    matrix = [[Decimal(0)] * size for _ in range(size)]
    vectors = [s for bar in bodies.bars for s in structure._bar_strain(bodies, bar)]
    for element in bodies.elements:
        vectors += _element_strain(bodies, element)
    for vector in vectors:
        entries = [(number[key], value) for key, value in vector.items() if key in number]
        for i, x in entries:
            for j, y in entries:
                matrix[i][j] += x * y
    for key in springs:
        at = number[key]
        matrix[at][at] += max(matrix[at][at], Decimal(1).scaleb(-30))
    return matrix


def _solved(matrix, loads):
    """Columns K^-1 f, by Cholesky factorisation."""
    size = len(matrix)
    start = [matrix[i][i] for i in range(size)]
    for i in range(size):
        row = matrix[i]
        for j in range(i):
            other = matrix[j]
            row[j] = (row[j] - sum(row[k] * other[k] for k in range(j) if row[k] and other[k])) / other[j]
        pivot = row[i] - sum(x * x for x in row[:i] if x)
        if start[i] <= 0 or pivot <= start[i] * Decimal("1e-40"):
            raise structure.Mechanism(i)
        row[i] = pivot.sqrt()
    result = []
    for load in loads:
        x = list(load)
        for i in range(size):
            x[i] = (x[i] - sum(matrix[i][k] * x[k] for k in range(i) if matrix[i][k] and x[k])) / matrix[i][i]
        for i in reversed(range(size)):
            x[i] = (x[i] - sum(matrix[k][i] * x[k] for k in range(i + 1, size) if matrix[k][i] and x[k])) / matrix[i][i]
        result.append(x)
    return result


def compliance(bodies, forces=()):
    """F, dm x dm in (n, t) or (n, t1, t2) of each candidate, and G, rows of the motions. Each of the forces,
    {(node, axis): value}, is one more row and column: displacements of the candidates and work on
    the motions. @raises structure.Mechanism"""
    motions, springs = _motions(bodies)
    number = {}
    axes = range(bodies.dimension)
    for node in bodies.nodes:
        for axis in axes:
            if axis not in bodies.fixed.get(node, ()):
                number[node, axis] = len(number)
    loads, rows = [], []
    decimal = lambda fraction: Decimal(fraction.numerator) / Decimal(fraction.denominator)
    for own in bodies.candidates:
        for direction in frame(own.normal):
            load, row = [Decimal(0)] * len(number), []
            parts = [(own.node, Decimal(1))] + [(node, -Decimal(weight)) for node, weight in own.against]
            for node, weight in parts:
                for axis in axes:
                    if (node, axis) in number:
                        load[number[node, axis]] += weight * direction[axis]
            for centre, nodes, motion in motions:
                row.append(sum((weight * direction[axis] * decimal(sum(a * b for a, b in zip(_lever(bodies, centre, node, axis), motion)))
                                for node, weight in parts if node in nodes for axis in axes), Decimal(0)))
            loads.append(load)
            rows.append(row)
    for force in forces:
        load = [Decimal(0)] * len(number)
        for key, value in force.items():
            if key in number:
                load[number[key]] += Decimal(value)
        loads.append(load)
        rows.append([sum((Decimal(value) * decimal(sum(a * b for a, b in zip(_lever(bodies, centre, node, axis), motion)))
                          for (node, axis), value in force.items() if node in nodes), Decimal(0))
                     for centre, nodes, motion in motions])
    moved = _solved(_stiffness(bodies, number, springs), loads)
    flexibility = [[dot(a, b) for b in moved] for a in loads]
    for i, row in enumerate(flexibility):
        for j in range(len(row)):
            if abs(row[j]) < ZERO * (flexibility[i][i] * flexibility[j][j]).sqrt():
                row[j] = Decimal(0)
    return flexibility, rows
