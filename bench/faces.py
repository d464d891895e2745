#!/usr/bin/env python3
"""Faces of meshes with many candidates: both ends of the critical coefficient, and trees.

    bench/faces.py [--kusabi build/kusabi] [--all] [--keep FOLDER] [NAME...]

Meshes are made here, without a mesher: plugs and wedges that can lift off, cubes clamped at the top,
slabs between parallel walls, and cantilever blocks of plane elements whose lower side is in contact.
One row for each call of `kusabi critical --node-limit 1`, which ends before any tree: candidates,
CPU seconds, both ends of the bracket, and whether the goal in the last column is met. A call with a
limit of CPU seconds measures what is known then. Rows that take longer than a minute run with
--all or by their name only. `trees` compares the branching rules of `kusabi patterns` on the
cantilevers, on two ranks with one, and `kusabi verify`; --keep keeps the files.
"""

import argparse
import contextlib
import itertools
import json
import math
import os
import resource
import signal
import subprocess
import tempfile
import time

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe", "PRTE_MCA_hwloc_default_binding_policy": "none"}

SPACE = """name = "{name}"
dimension = 3
units = {{ length = "m", force = "kN" }}
[[mesh]]
name = "b"
file = "{name}.msh"
[[material]]
groups = ["b.body"]
E = 1000.0
nu = 0.3
"""
PLANE = """name = "{name}"
dimension = 2
units = {{ length = "m", force = "kN" }}
[[mesh]]
name = "b"
corners = [[0, 0], [{length}, 0], [{length}, 1], [0, 1]]
divisions = [{along}, {across}]
E = 1000
nu = 0.3
thickness = 1
plane = "stress"
"""
CONTACT = '[[contact]]\nnodes = ["b.{}"]\nnormal = {}\n'


def write_hexahedra(path, divisions, place, sides, ring=False):
    """A Gmsh file of a grid of hexahedra. `place` maps (i, j, k) to coordinates; `sides` maps the name of
    a group to (axis, end), a side of the grid; on a ring the second index is periodic."""
    nodes = [count + 1 for count in divisions]
    if ring:
        nodes[1] -= 1

    def number(i, j, k):
        return 1 + i + nodes[0] * (j % nodes[1] + nodes[1] * k)

    cells = []
    for cell in itertools.product(*map(range, divisions)):
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        cells.append((5, 1, [number(cell[0] + a, cell[1] + b, cell[2] + c) for c in (0, 1) for a, b in corners]))
    for group, (axis, end) in enumerate(sides.values()):
        others = [other for other in range(3) if other != axis]
        for first, second in itertools.product(*(range(divisions[other]) for other in others)):
            face = []
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = [divisions[axis] if end else 0] * 3
                corner[others[0]], corner[others[1]] = first + a, second + b
                face.append(number(*corner))
            cells.append((3, group + 2, face))
    with open(path, "w") as file:
        names = ['3 1 "body"'] + [f'2 {group + 2} "{name}"' for group, name in enumerate(sides)]
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", len(names), *names, "$EndPhysicalNames", "$Nodes",
              math.prod(nodes), sep="\n", file=file)
        for k, j, i in itertools.product(*map(range, reversed(nodes))):
            print(number(i, j, k), *(repr(float(x)) for x in place(i, j, k)), file=file)
        print("$EndNodes", "$Elements", len(cells), sep="\n", file=file)
        for count, (kind, group, corners) in enumerate(cells):
            print(count + 1, kind, 2, group, group, *corners, file=file)
        print("$EndElements", file=file)


def space(folder, name, divisions, place, sides, sections, ring=False):
    write_hexahedra(os.path.join(folder, name + ".msh"), divisions, place, sides, ring)
    return write(folder, name, SPACE.format(name=name) + sections)


def write(folder, name, text):
    path = os.path.join(folder, name + ".toml")
    with open(path, "w") as file:
        file.write(text)
    return path


def box(size, divisions):
    return lambda *index: [length * i / n for length, i, n in zip(size, index, divisions)]


def cube(name, along, layers):
    """Clamped at the top, (along + 1)^2 candidates at the bottom."""
    divisions = (along, along, layers)
    return lambda folder: space(folder, name, divisions, box((1, 1, 1), divisions), {"bottom": (2, 0), "top": (2, 1)},
                                '[[supports]]\nnodes = ["b.top"]\n' + CONTACT.format("bottom", "[0, 0, 1]"))


def slab(name, along, layers):
    """A square of four thicknesses between two walls."""
    divisions = (along, along, layers)
    return lambda folder: space(folder, name, divisions, box((4, 4, 1), divisions), {"bottom": (2, 0), "top": (2, 1)},
                                CONTACT.format("bottom", "[0, 0, 1]") + CONTACT.format("top", "[0, 0, -1]"))


def wedge(name, along, layers):
    """Two walls that enclose 20 degrees: it sticks from tan 10 degrees on."""
    divisions = (layers, along, along)

    def place(i, j, k):
        z = 4 * k / along
        return (2 * i / layers - 1) * (1 + z * math.tan(math.radians(10))), 4 * j / along, z

    return lambda folder: space(folder, name, divisions, place, {"left": (0, 0), "right": (0, 1)},
                                CONTACT.format("left", '"surface"') + CONTACT.format("right", '"surface"'))


def plug(name, around, along, layers):
    """A hollow plug in a conical hole, 3 degrees: it sticks from tan 3 degrees on."""
    divisions = (layers, around, along)

    def place(i, j, k):
        z = 2 * k / along
        radius = (0.4 + 0.6 * i / layers) * (1 + z * math.tan(math.radians(3)))
        angle = 2 * math.pi * j / around
        return radius * math.cos(angle), radius * math.sin(angle), z

    apex = -1 / math.tan(math.radians(3))
    normal = f'{{ point = [0, 0, {apex!r}], axis = [0, 0, 1], half_angle = 3, body = "inside" }}'
    return lambda folder: space(folder, name, divisions, place, {"seat": (0, 1)}, CONTACT.format("seat", normal), ring=True)


def plane_slab(name, along, across, length):
    return lambda folder: write(folder, name, PLANE.format(name=name, along=along, across=across, length=length)
                                + CONTACT.format("bottom", "[0, 1]") + CONTACT.format("top", "[0, -1]"))


def face(candidates):
    """A cantilever of 4 x 1, fixed at one end."""
    across = max(2, candidates // 4) if candidates <= 100 else 20
    name = f"face-{candidates}"
    return lambda folder: write(folder, name, PLANE.format(name=name, along=candidates, across=across, length=4)
                                + '[[supports]]\nnodes = ["b.left"]\n' + CONTACT.format("bottom", "[0, 1]").rstrip()
                                + '\nexcept = ["b.left"]\n')


# Name, function that writes the file, limit of CPU seconds or None, goal: most seconds, largest upper bound, smallest
# lower bound, largest relative width (None: none); True: a row of --all.
ROWS = [
    ("plug-120", plug("plug-120", 20, 5, 2), None, (60, None, None, 1e-4), False),
    ("plug-240", plug("plug-240", 24, 9, 2), None, (60, None, None, 1e-4), False),
    ("plug-450", plug("plug-450", 30, 14, 2), None, (60, None, None, 1e-4), False),
    ("wedge-200", wedge("wedge-200", 9, 4), None, (60, None, None, 1e-4), False),
    ("wedge-450", wedge("wedge-450", 14, 4), None, (60, None, None, 1e-4), False),
    ("cube-49", cube("cube-49", 6, 6), None, (None, 1.3061, 0.95, None), False),
    ("cube-100", cube("cube-100", 9, 9), None, (None, 1.2945, 0.95, None), False),
    ("cube-225", cube("cube-225", 14, 7), 15, (15, 1.3005, None, None), False),
    ("cube-225", cube("cube-225", 14, 7), None, (None, 1.3005, 0.95, None), False),
    ("cube-400", cube("cube-400", 19, 9), 180, (180, 1.302, 0.85, None), True),
    ("cube-1024", cube("cube-1024", 31, 10), 120, (120, 1.42, 0.1, None), True),
    ("slab-50", slab("slab-50", 4, 2), None, (60, None, 0.3, None), False),
    ("slab-200", slab("slab-200", 9, 2), None, (None, None, 0.3, None), True),
    ("plane-slab-50", plane_slab("plane-slab-50", 24, 6, 4), None, (60, None, 0.3, None), False),
    ("plane-slab-200", plane_slab("plane-slab-200", 99, 10, 8), None, (None, None, 0.3, None), True),
    ("face-100", face(100), None, (10, 5.295, 1, None), False),
    ("face-200", face(200), None, (10, 5.295, 1, None), False),
    ("face-400", face(400), None, (10, 5.295, 1, None), True),
]


def cpu_seconds(process):
    """CPU seconds of a running process; 0 if they cannot be read."""
    try:
        with open(f"/proc/{process.pid}/stat") as file:
            ticks = file.read().rsplit(")", 1)[1].split()[11:13]
    except OSError:
        return 0
    return sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK")


def run(command, limit=None):
    """CPU seconds and wall seconds. A process is interrupted after `limit` CPU seconds."""
    cpu, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
    while limit is not None:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=0.2)
            break
        if cpu_seconds(process) >= limit:
            process.send_signal(signal.SIGINT)
            break
    process.wait()
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime - cpu.ru_utime - cpu.ru_stime, time.monotonic() - wall


def judged(goal, seconds, upper, lower, proved):
    """The goal in words, and whether it is met."""
    most, largest, smallest, width = goal
    parts = []
    if largest is not None:
        parts.append((f"upper <= {largest}", upper is not None and upper <= largest))
    if smallest is not None:
        parts.append((f"lower >= {smallest}", lower >= smallest))
    if width is not None:
        parts.append((f"proved to {width:g}", proved and upper - lower <= width * lower))
    if most is not None:
        parts.append((f"{most} s", seconds <= 1.1 * most))
    return ", ".join(text for text, _ in parts) + (": met" if all(met for _, met in parts) else ": not met")


def brackets(kusabi, folder, rows):
    output = os.path.join(folder, "out.json")
    print(f"{'mesh':<16} {'candidates':>10} {'CPU s':>7} {'lower':>12} {'upper':>12} {'proved':>12}  goal")
    for name, make, limit, goal, _ in rows:
        with contextlib.suppress(FileNotFoundError):
            os.remove(output)
        seconds, _ = run([kusabi, "critical", make(folder), "--node-limit", "1", "--quiet", "--output", output], limit)
        if not os.path.exists(output):
            print(f"{name:<16} no answer after {seconds:.0f} s", flush=True)
            continue
        with open(output) as file:
            answer = json.load(file)
        ends = answer["result"]["critical_friction"]
        proved = [end for end, bound in ends.items() if bound and bound["standing"] == "proved"]
        low, high = (bound and bound["value"] for bound in (ends["lower"], ends["upper"]))
        print(f"{name:<16} {answer['problem']['m']:>10} {seconds:>7.1f} {low or 0:>12.8f} "
              f"{'-' if high is None else f'{high:.8f}':>12} "
              f"{', '.join(proved):>12}  {judged(goal, seconds, high, low or 0, len(proved) == 2)}", flush=True)


FRICTION = "5.2"
MOST_RELATIVE = 100  # beyond this size, the relative rule takes hours


def trees(kusabi, folder):
    """Nodes, iterations and seconds of `patterns` at 5.2, 3 % below the critical coefficient of a cantilever."""
    output, proof = os.path.join(folder, "out.json"), os.path.join(folder, "proof")

    def patterns(file, *more, launch=()):
        cpu, wall = run([*launch, kusabi, "patterns", file, "--mu", FRICTION, "--quiet", "--output", output, *more])
        with open(output) as answer:
            tree = json.load(answer)["result"]["tree"]
        return f"{tree['opened']:>7} {tree['iterations']:>8} {wall if launch else cpu:>8.2f}"

    print("candidates | relative: nodes iterations seconds | deepest: nodes iterations seconds | auto: nodes iterations "
          "seconds | two ranks: seconds | verify: seconds")
    for size in (32, 60, 100, 200):
        file = face(size)(folder)
        relative = patterns(file, "--branching", "relative") if size <= MOST_RELATIVE else " " * 25
        deepest = patterns(file, "--branching", "deepest")
        auto = patterns(file)
        two = patterns(file, "--certificate", proof, launch=("mpirun", "-np", "2")).split()[-1]
        verified, _ = run([kusabi, "verify", proof, "--problem", file])
        print(f"{size:>10} | {relative} | {deepest} | {auto} | {two:>8} | {verified:>8.2f}", flush=True)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kusabi", default=os.path.join(here, "../build/kusabi"))
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--keep", metavar="FOLDER")
    parser.add_argument("names", nargs="*", metavar="NAME", help="names of rows, or trees")
    chosen = parser.parse_args()
    unknown = set(chosen.names) - {row[0] for row in ROWS} - {"trees"}
    if unknown:
        parser.error(f"no row is named {', '.join(sorted(unknown))}; expected trees or "
                     f"{', '.join(dict.fromkeys(row[0] for row in ROWS))}")
    with contextlib.ExitStack() as stack:
        folder = chosen.keep or stack.enter_context(tempfile.TemporaryDirectory())
        os.makedirs(folder, exist_ok=True)
        if chosen.names != ["trees"]:
            rows = [row for row in ROWS if (row[0] in chosen.names if chosen.names else chosen.all or not row[4])]
            brackets(chosen.kusabi, folder, rows)
        if "trees" in chosen.names:
            trees(chosen.kusabi, folder)


if __name__ == "__main__":
    main()
