"""`kusabi hold` against reference numbers of states under load: closed forms, and enumerations of all sign patterns
(tests/reference/loads.json). Certificates of the answers are verified.

    python3 hold_reference_test.py KUSABI SOURCES
"""
import json
import math
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import SOURCES, KusabiCase, main, with_ends  # noqa: E402: beside the folder of this file

CASES = json.loads((SOURCES / "tests" / "reference" / "loads.json").read_text())["cases"]
BY_PATTERN = "set of lambda by pattern"
#: Relative; the reference has ten digits.
NEAR = 2e-8


def mesh_text(mesh):
    lines = ["[[mesh]]", f'name = "{mesh["mesh"]}"', *(f"{key} = {mesh[key]}" for key in ("corners", "divisions", "E", "nu"))]
    lines += [f"thickness = {mesh['thickness']}", f'plane = "{mesh["plane"]}"']
    return lines + (["join = false"] if mesh.get("join") is False else [])


def list_of(names):
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def text_of(given):
    lines = ['name = "case"', "dimension = 2", 'units = { length = "m", force = "N" }']
    for mesh in given.get("meshes", [given]):
        lines += mesh_text(mesh)
    for support in given.get("supports", []):
        lines += ["[[supports]]", f"nodes = {list_of(support['nodes'])}", f"fixed = {json.dumps(support['fixed'])}"]
    for contact in given["contact"]:
        lines += ["[[contact]]", f"nodes = {list_of(contact['nodes'])}", f"normal = {contact['normal']}"]
        if "against" in contact:
            lines.append(f"against = {list_of(contact['against'])}")
        if given.get("gap"):
            lines.append(f"clearance = {given['gap']}")
    for kind, key in (("dead", "dead"), ("reference", "live")):
        for load in given.get(key, []):
            nodes = load.get("nodes", [load.get("node")])
            lines += ["[[loads]]", f'kind = "{kind}"', f"nodes = {list_of(nodes)}", f"force = {load['force']}"]
    return "\n".join(lines) + "\n"


def listed(places, elements):
    """A file whose nodes and elements are listed, with their material."""
    dimension = len(next(iter(places.values())))
    lines = ['name = "case"', f"dimension = {dimension}", 'units = { length = "m", force = "N" }', "[nodes]"]
    lines += [f'"{name}" = {place}' for name, place in places.items()]
    lines += ["[[elements]]", "E = 1000.0", "nu = 0.3", f"between = [{', '.join(map(list_of, elements))}]"]
    return lines + (["thickness = 1", 'plane = "strain"'] if dimension == 2 else [])


def contacts(normals, clearance):
    lines = []
    for name, normal in normals.items():
        lines += ["[[contact]]", f'nodes = ["{name}"]', f"normal = {normal}", f"clearance = {clearance}"]
    return lines


def loads(forces):
    lines = []
    for name, force in forces.items():
        lines += ["[[loads]]", 'kind = "reference"', f'nodes = ["{name}"]', f"force = {force}"]
    return lines


def ring_text(sectors, layers, torque):
    """A ring on a rigid shaft, radii 1 to 2, with an interference, and a torque at the outside."""
    def turned(k, radius=1.0):
        angle = 2 * math.pi * k / sectors
        return [radius * math.cos(angle), radius * math.sin(angle)]
    places = {f"{i},{k}": turned(k, 2 ** (i / layers)) for i in range(layers + 1) for k in range(sectors)}
    elements = [[f"{i},{k}", f"{i + 1},{k}", f"{i + 1},{(k + 1) % sectors}", f"{i},{(k + 1) % sectors}"]
                for i in range(layers) for k in range(sectors)]
    lines = listed(places, elements) + contacts({f"0,{k}": turned(k) for k in range(sectors)}, -0.001)
    if torque:
        lines += loads({f"{layers},{k}": [-turned(k)[1] / (2 * sectors), turned(k)[0] / (2 * sectors)] for k in range(sectors)})
    return "\n".join(lines) + "\n"


def cube_text(force):
    """A cube between two walls that press it, with a force divided among its nodes."""
    corners = [(x, y, z) for z in (0.0, 1.0) for x, y in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))]
    names = [f"c{i}" for i in range(8)]
    places = dict(zip(names, map(list, corners)))
    lines = listed(places, [names])
    lines += contacts({name: [1 - 2 * x, 0, 0] for name, (x, _, _) in zip(names, corners)}, -0.001)
    return "\n".join(lines + loads({name: [each / 8 for each in force] for name in names})) + "\n"


def built(case):
    """The file of a case."""
    given, name = case.get("input"), case["name"]
    if given is None:
        sectors, layers = map(int, re.match(r"ring (\d+) sectors x (\d+) layers", name).groups())
        return ring_text(sectors, layers, False)
    if "cube" in given:
        return cube_text([float(each) for each in re.search(r"load (\S+)", name)[1].split(",")])
    if "N" in given:
        return ring_text(given["N"], 1, True)
    if "file" not in given:
        return text_of(given)
    text = (SOURCES / given["file"]).read_text()
    for kind, key in (("dead", "dead"), ("reference", "live")):
        for load in given.get(key, []):
            text += f'[[loads]]\nkind = "{kind}"\nnodes = ["{load["node"]}"]\nforce = {load["force"]}\n'
            text += 'case = "lift"\n' if kind == "reference" and case["question"] == BY_PATTERN else ""
    if case["question"] == BY_PATTERN:  # a diagram, of which the reference load is one axis
        text += '[[loads]]\nkind = "reference"\nnodes = ["tip"]\nforce = [1, 1]\ncase = "along"\n'
    return text


def number(value):
    return {"inf": math.inf, "-inf": -math.inf}.get(value, value)


class HoldReference(KusabiCase):
    def near(self, got, wanted, name):
        got = {None: math.inf if wanted > 0 else -math.inf}.get(got, got)
        if math.isinf(wanted):
            self.assertEqual(got, wanted, name)
        else:
            self.assertAlmostEqual(got, wanted, delta=NEAR * max(1, abs(wanted)), msg=name)

    def check_certificate(self, place, name):
        run = self.kusabi("verify", self.folder / name, "--problem", place)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def check(self, case, place):
        name, mu = f"{case['name']}, {case['question']}", case.get("mu")
        words = ["--certificate", self.folder / "cert"]
        if case["question"].startswith("critical"):
            found = self.solve("hold", place, *words)["result"]["holding_friction"]
            self.near(found["upper"]["value"], case["answer"], name)
            self.check_certificate(place, "cert.lower")
            self.check_certificate(place, "cert.upper")
            return
        if case["question"] == BY_PATTERN:
            self.check_pieces(case, place, name)
            return
        if case["question"].startswith("sum of r_n"):  # the state without friction is the only one
            (held,) = self.solve("hold", place, "--mu", 0)["result"]["intervals"]
            self.near(sum(force[0] for force in held["state"]["reactions"].values()), case["answer"], name)
            return
        words += ["--mu", mu]
        if case["question"].startswith("least and largest"):
            grip = with_ends(self.solve("hold", place, *words, "--grip")["result"]["grip"])
            self.near(grip["low"], case["answer"][0], name)
            self.near(grip["high"], number(case["answer"][1]), name)
        else:
            words += ["--total", case["input"]["total"]] if "total" in case["input"] else []
            result = self.solve("hold", place, *words)["result"]
            held = [(each["low"], each["high"]) for each in map(with_ends, result["intervals"])]
            answer = [[None, case["answer"]]] if case["question"] == "largest lambda" else case["answer"]
            self.assertEqual(len(held), len(answer), f"{name}: {held}")
            for got, true in zip(held, answer):
                for one, other in zip(got, true):
                    if other is not None:  # not computed
                        self.near(one, number(other), f"{name}: {held}")
        self.check_certificate(place, "cert")

    def check_pieces(self, case, place, name):
        """Each pattern's interval on the axis of the first load."""
        pieces = self.solve("hold", place, "--diagram", "--mu", case["mu"])["result"]["pieces"]
        wanted = {len(each["contact"]): tuple(map(number, each["interval"])) for each in case["answer"]}
        self.assertEqual({len(each["pattern"]["contact"]) for each in pieces}, set(wanted), name)
        for piece in pieces:
            least, most = wanted[len(piece["pattern"]["contact"])]
            if piece["everything"]:
                self.assertEqual((least, most), (-math.inf, math.inf), name)
                continue
            # Loads along the bars' symmetry do not lift the tip: the pieces are half-planes or strips.
            ends = [-math.inf if any(x < -1e-9 for x, _ in piece["rays"]) else min(x for x, _ in piece["vertices"]),
                    math.inf if any(x > 1e-9 for x, _ in piece["rays"]) else max(x for x, _ in piece["vertices"])]
            self.assertTrue(ends[0] <= least + 1e-6 and most - 1e-6 <= ends[1], f"{name}: {ends}")

    def test_answers_agree_with_the_reference(self):
        before, count = None, 0
        for case in CASES:
            if case.get("input") == "as before":
                case["input"] = before
            before = case.get("input")
            place = self.folder / "case.toml"
            place.write_text(built(case))
            with self.subTest(case["name"]):
                self.check(case, place)
            count += 1
        self.assertEqual(count, 86)


if __name__ == "__main__":
    main()
