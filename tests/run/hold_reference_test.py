"""`kusabi hold` against reference numbers of states under load: closed forms, and enumerations of all sign patterns
(tests/reference/loads.json). Certificates of the answers are verified.

    python3 hold_reference_test.py KUSABI SOURCES
"""
import json
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

CASES = json.loads((SOURCES / "tests" / "reference" / "loads.json").read_text())["cases"]
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
            self.near(found["upper"], case["answer"], name)
            self.check_certificate(place, "cert.lower")
            self.check_certificate(place, "cert.upper")
            return
        words += ["--mu", mu]
        if case["question"].startswith("least and largest"):
            grip = self.solve("hold", place, *words, "--grip")["result"]["grip"]
            self.near(grip["least"]["held"], case["answer"][0], name)
            self.near(grip["most"] and grip["most"]["held"], number(case["answer"][1]), name)
        else:
            words += ["--total", case["input"]["total"]] if "total" in case["input"] else []
            result = self.solve("hold", place, *words)["result"]
            held = [(each["low"], each["high"]) for each in result["intervals"]]
            wanted = [(number(low), number(high)) for low, high in case["answer"]]
            self.assertEqual(len(held), len(wanted), f"{name}: {held}")
            for got, true in zip(held, wanted):
                for one, other in zip(got, true):
                    self.near(one, other, f"{name}: {held}")
        self.check_certificate(place, "cert")

    def test_reference(self):
        before, count = None, 0
        for case in CASES:
            if case.get("input") == "as before":
                case["input"] = before
            given = before = case.get("input")
            unknown = "null" in json.dumps(case["answer"])
            if not isinstance(given, dict) or case["question"] == "set of lambda by pattern" or unknown:
                continue
            if "file" in given:
                text = (SOURCES / given["file"]).read_text()
                for load in given["live"]:
                    text += f'[[loads]]\nkind = "reference"\nnodes = ["{load["node"]}"]\nforce = {load["force"]}\n'
            elif "contact" in given and isinstance(given["contact"], list):
                text = text_of(given)
            else:
                continue
            place = self.folder / "case.toml"
            place.write_text(text)
            with self.subTest(case["name"]):
                self.check(case, place)
            count += 1
        self.assertGreater(count, 55)


if __name__ == "__main__":
    main()
