#!/usr/bin/env python3
"""Faces of meshes with many candidates: branching rules, two ranks compared with one, and the
proof.

    bench/faces.py [build/kusabi [CANDIDATES...]]

Blocks of 4 x 1 of plane quadrilaterals, fixed at one end, with all nodes of the lower side in
contact (critical coefficient near 5.3). For each number of candidates: nodes, iterations and
seconds of `patterns` at 5.2, where it cannot stick, by the relative rule up to a hundred
candidates, by the deepest candidate, and by the automatic choice (including its sampling); wall
seconds of the latter on two ranks, and seconds of `verify`. Nodes and iterations are the same on
any machine; seconds are CPU seconds except on two ranks.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import time

FRICTION = "5.2"
MOST_RELATIVE = 100  # beyond this size, the relative rule takes hours
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe", "PRTE_MCA_hwloc_default_binding_policy": "none"}
FACE = """
name = "face"
dimension = 2
units = {{ length = "m", force = "kN" }}
[[mesh]]
name = "b"
corners = [[0, 0], [4, 0], [4, 1], [0, 1]]
divisions = [{}, {}]
E = 1000
nu = 0.3
thickness = 1
plane = "stress"
[[supports]]
nodes = ["b.left"]
[[contact]]
nodes = ["b.bottom"]
except = ["b.left"]
normal = [0, 1]
"""


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    kusabi = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "../build/kusabi")
    sizes = [int(size) for size in sys.argv[2:]] or [32, 60, 100, 200]
    with tempfile.TemporaryDirectory() as folder:
        output, proof = os.path.join(folder, "out.json"), os.path.join(folder, "proof")

        def timed(*command):
            """CPU seconds, wall seconds."""
            cpu, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env={**os.environ, **ENVIRONMENT})
            spent = resource.getrusage(resource.RUSAGE_CHILDREN)
            return spent.ru_utime + spent.ru_stime - cpu.ru_utime - cpu.ru_stime, time.monotonic() - wall

        def patterns(file, *more, launch=()):
            cpu, wall = timed(*launch, kusabi, "patterns", file, "--mu", FRICTION, "--quiet", "--output", output, *more)
            with open(output) as answer:
                tree = json.load(answer)["result"]["tree"]
            return f"{tree['opened']:>7} {tree['iterations']:>8} {wall if launch else cpu:>8.2f}"

        print("candidates | relative: nodes iterations seconds | deepest: nodes iterations seconds | auto: nodes iterations "
              "seconds | two ranks: seconds | verify: seconds")
        for size in sizes:
            file = os.path.join(folder, f"face-{size}.toml")
            with open(file, "w") as text:
                text.write(FACE.format(size, max(2, size // 4) if size <= MOST_RELATIVE else 20))
            relative = patterns(file, "--branching", "relative") if size <= MOST_RELATIVE else " " * 25
            deepest = patterns(file, "--branching", "deepest")
            auto = patterns(file)
            two = patterns(file, "--certificate", proof, launch=("mpirun", "-np", "2")).split()[-1]
            verified, _ = timed(kusabi, "verify", proof, "--problem", file)
            print(f"{size:>10} | {relative} | {deepest} | {auto} | {two:>8} | {verified:>8.2f}", flush=True)


if __name__ == "__main__":
    main()
