#!/usr/bin/env python3
"""Loads that friction holds with many candidates: rings pressed on a rigid shaft, and slabs pressed between two walls.

    bench/hold.py [--kusabi build/kusabi] [--limit SECONDS] [--cuts WORD] [NAME...]

Rings as in examples/press-fit.toml with a torque, in space with a force along the axis; slabs of
four thicknesses with an interference at both walls and a force along them. One row for each call of
`kusabi hold --mu 0.2` on one and on two ranks: candidates, trees, nodes, user CPU seconds, and the
load factors.
"""

import argparse
import json
import math
import os
import resource
import subprocess
import tempfile

from faces import ENVIRONMENT, PLANE, SPACE, box, write, write_hexahedra

PRESSED = '[[contact]]\nnodes = ["b.{}"]\nnormal = {}\ninterference = 0.001\n'
PUSH = '[[loads]]\nkind = "reference"\nnodes = ["b.{}"]\nforce = {}\n'


def ring(name, sectors):
    """Candidates: sectors."""
    def made(folder):
        text = f'name = "{name}"\ndimension = 2\nunits = {{ length = "mm", force = "N" }}\n[nodes]\n'
        elements, loads = [], []
        for k in range(sectors):
            c, s = math.cos(2 * math.pi * k / sectors), math.sin(2 * math.pi * k / sectors)
            text += f"in{k} = [{c!r}, {s!r}]\nout{k} = [{2 * c!r}, {2 * s!r}]\n"
            after = (k + 1) % sectors
            elements.append(f'["in{k}", "out{k}", "out{after}", "in{after}"]')
            loads.append(f'[[loads]]\nkind = "reference"\nnodes = ["out{k}"]\nforce = [{-s / 2 / sectors!r}, {c / 2 / sectors!r}]\n')
        text += f'[[elements]]\nE = 1000\nnu = 0.3\nthickness = 1\nplane = "strain"\nbetween = [{", ".join(elements)}]\n'
        names = ", ".join(f'"in{k}"' for k in range(sectors))
        text += f'[[contact]]\nnodes = [{names}]\nnormal = {{ point = [0, 0], body = "outside" }}\ninterference = 0.001\n'
        return write(folder, name, text + "".join(loads))
    return made


def sleeve(name, around, along):
    """Candidates: around (along + 1)."""
    def made(folder):
        divisions = (1, around, along)

        def place(i, j, k):
            angle = 2 * math.pi * j / around
            return (1 + i) * math.cos(angle), (1 + i) * math.sin(angle), 2 * k / along

        write_hexahedra(os.path.join(folder, name + ".msh"), divisions, place, {"inner": (0, 0), "outer": (0, 1)}, ring=True)
        return write(folder, name, SPACE.format(name=name) + PRESSED.format("inner", '"surface"') + PUSH.format("outer", "[0, 0, 0.01]"))
    return made


def plane(name, along, across):
    """Candidates: 2 (along + 1)."""
    def made(folder):
        text = PLANE.format(name=name, length=4, along=along, across=across)
        text += PRESSED.format("bottom", "[0, 1]") + PRESSED.format("top", "[0, -1]")
        return write(folder, name, text + PUSH.format("left", "[0.1, 0]"))
    return made


def space(name, along, layers):
    """Candidates: 2 (along + 1)^2."""
    def made(folder):
        divisions = (along, along, layers)
        sides = {"bottom": (2, 0), "top": (2, 1), "left": (0, 0)}
        write_hexahedra(os.path.join(folder, name + ".msh"), divisions, box((4, 4, 1), divisions), sides)
        text = SPACE.format(name=name) + PRESSED.format("bottom", "[0, 0, 1]") + PRESSED.format("top", "[0, 0, -1]")
        return write(folder, name, text + PUSH.format("left", "[0.1, 0, 0]"))
    return made


ROWS = {"ring-50": ring("ring-50", 50), "ring-100": ring("ring-100", 100), "sleeve-24": sleeve("sleeve-24", 8, 2),
        "sleeve-50": sleeve("sleeve-50", 10, 4), "plane-20": plane("plane-20", 9, 2), "plane-40": plane("plane-40", 19, 5),
        "plane-60": plane("plane-60", 29, 7), "plane-100": plane("plane-100", 49, 12), "space-18": space("space-18", 2, 1), "space-50": space("space-50", 4, 2)}


def measured(kusabi, file, ranks, limit, cuts):
    """(user CPU seconds of all ranks, result) of a call."""
    output = file + ".json"
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    launch = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    done = subprocess.run([*launch, kusabi, "hold", file, "--mu", "0.2", "--quiet", "--time-limit", str(limit), "--cuts", cuts,
                           "--output", output],
                          env=ENVIRONMENT, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(done.stderr)
    with open(output) as result:
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, json.load(result)


def answer(result):
    ended = "" if result["status"] == "solved" else f" ({result['status']})"
    ends = [[bound and bound["value"] for bound in (each["below"]["upper"], each["above"]["lower"])]
            for each in result["result"]["intervals"]]
    return "; ".join(f"{low} to {high}" for low, high in ends) + ended


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kusabi", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "../build/kusabi"))
    parser.add_argument("--limit", type=float, default=300, help="seconds of a call")
    parser.add_argument("--cuts", default="auto", choices=["auto", "none", "always"], help="as of `kusabi hold`")
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(ROWS))
    asked = parser.parse_args()
    print("structure   candidates  ranks  trees    nodes   CPU s  load factors")
    with tempfile.TemporaryDirectory() as folder:
        for name in asked.names or ROWS:
            file = ROWS[name](folder)
            for ranks in (1, 2):
                seconds, result = measured(asked.kusabi, file, ranks, asked.limit, asked.cuts)
                searches = result["statistics"]["searches"]
                print(f"{name:<11} {result['problem']['m']:>10}  {ranks:>5} {len(searches):>6} "
                      f"{sum(each['opened'] for each in searches):>8} {seconds:>7.1f}  {answer(result)}", flush=True)


if __name__ == "__main__":
    main()
