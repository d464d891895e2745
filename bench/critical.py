#!/usr/bin/env python3
"""Critical friction coefficient: global search compared with enumeration first, and two ranks with
one.

    bench/critical.py [build/kusabi]

For each truss: nodes opened, cone programs solved and seconds of the global search; of the
enumeration at mu^0 that Algorithm 6.1 begins with, and of its second step by Newton's method and by
bisection. For the largest truss, nodes opened per second and rank, on two ranks and on one. Nodes
and programs are the same on any machine.
"""

import json
import os
import subprocess
import sys
import tempfile

from faces import ENVIRONMENT

TRUSSES = [((5, 2, 3), 1.0), ((10, 2, 3), 0.7), ((5, 4, 3), 0.6), ((15, 2, 3), 0.55)]
SCALED = ((5, 4, 3), 0.6)  # 408 patterns


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    kusabi = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "../build/kusabi")
    with tempfile.TemporaryDirectory() as folder:
        def run(arguments, ranks=None):
            output = os.path.join(folder, "out.json")
            launch = ["mpirun", "-np", str(ranks)] if ranks else []
            subprocess.run(launch + [kusabi, *arguments, "--quiet", "--output", output], check=True,
                           env={**os.environ, **ENVIRONMENT})
            with open(output) as file:
                return json.load(file)

        def truss(size):
            file = os.path.join(folder, "-".join(map(str, size)) + ".toml")
            rows, depth, bays = map(str, size)
            subprocess.run([kusabi, "example", "space-truss", "--rows", rows, "--depth", depth, "--bays", bays,
                            "--output", file], check=True)
            return file

        def figures(answer):
            ranks = answer["statistics"]["ranks"]
            return (sum(r["opened"] for r in ranks), sum(r.get("programs", r["opened"]) for r in ranks),
                    max(r["seconds"] for r in ranks))

        print("m   mu^0  patterns | global: nodes programs seconds | enumeration: nodes seconds | "
              "newton: programs seconds | bisection: programs seconds | critical")
        for size, most in TRUSSES:
            file = truss(size)
            found = run(["critical", file, "--method", "global"])
            listed = run(["patterns", file, "--mu", str(most)])
            newton = run(["critical", file, "--method", "newton", "--mu-max", str(most)])
            bisection = run(["critical", file, "--method", "bisection", "--mu-max", str(most)])
            bracket = found["result"]["critical_friction"]
            for other in (newton, bisection):
                if listed["result"]["count"] and other["result"]["critical_friction"] != bracket:
                    print(f"    DISAGREE: {bracket} {other['result']['critical_friction']}")
            g, e, n, b = map(figures, (found, listed, newton, bisection))
            print(f"{size[0] * size[1]:<3} {most:<5} {listed['result']['count']:>8} | {g[0]:>13} {g[1]:>8} {g[2]:>7.3f} | "
                  f"{e[0]:>18} {e[2]:>7.3f} | {n[1]:>16} {n[2]:>7.3f} | {b[1]:>19} {b[2]:>7.3f} | "
                  f"{bracket['lower']['value']:.8f}", flush=True)

        size, most = SCALED
        file = truss(size)
        print("\nbisection, nodes opened per second and rank (best of three)")
        rates = {}
        for ranks in (1, 2):
            best = 0
            for _ in range(3):
                answer = run(["critical", file, "--method", "bisection", "--mu-max", str(most)], ranks)
                opened, _, seconds = figures(answer)
                best = max(best, opened / (ranks * seconds))
            rates[ranks] = best
            print(f"{ranks} rank{'s' if ranks > 1 else ' '}: {best:.0f}")
        print(f"two ranks do {2 * rates[2] / rates[1]:.2f} times the work of one in the same time")


if __name__ == "__main__":
    main()
