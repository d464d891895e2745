#!/usr/bin/env python3
"""Critical friction coefficient by each method, among which `kusabi critical --method auto`
chooses.

    bench/critical_methods.py [build/kusabi [NAME...]]

For examples, trusses of the families and faces of blocks of plane quadrilaterals (all, or those
named): cone programs of the search for the bracket and of the proofs of both bounds, and CPU
seconds of the whole call; without --mu-max, and with 0.9, 1.1 and 2 times the answer, at which
`newton` begins with the patterns that are feasible there. A call ends after 60 s of CPU time.
Programs are the same on any machine.
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

from faces import FACE

SOURCES = pathlib.Path(__file__).resolve().parent.parent
SECONDS = 60
EXAMPLES = ("two-bars", "plane-truss", "space-truss", "wedge-in-groove", "snap-hook", "brick-by-calculix", "elastic-body",
            "peg-in-hole", "morse-taper")
PLANE = (8, 16, 24, 32, 40)
SPACE = ((4, 2), (8, 2), (10, 2), (5, 4), (10, 3), (6, 5), (15, 2), (10, 4), (8, 5))
FACES = (8, 16, 32, 40, 60)


def main():
    kusabi = sys.argv[1] if len(sys.argv) > 1 else SOURCES / "build" / "kusabi"
    names = sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        for name, file in problems(kusabi, pathlib.Path(folder)):
            if names and name not in names:
                continue
            methods = ("auto", "descent", "global")
            ends = [show(name, kusabi, file, folder, method)[1] for method in methods]
            upper = next(filter(None, ends), None)
            for share in (0.9, 1.1, 2):
                for method in (*methods, "newton"):
                    if upper is not None:
                        show(name, kusabi, file, folder, method, round(share * upper, 6))


def problems(kusabi, folder):
    """Names and files."""
    for name in EXAMPLES:
        yield name, SOURCES / "examples" / f"{name}.toml"
    for rows in PLANE:
        file = folder / f"plane-{rows}.toml"
        subprocess.run([kusabi, "example", "plane-truss", "--rows", str(rows), "--output", file], check=True,
                       stderr=subprocess.DEVNULL)
        yield file.stem, file
    for rows, depth in SPACE:
        file = folder / f"space-{rows}x{depth}.toml"
        subprocess.run([kusabi, "example", "space-truss", "--rows", str(rows), "--depth", str(depth), "--output", file], check=True,
                       stderr=subprocess.DEVNULL)
        yield file.stem, file
    for across in FACES:
        file = folder / f"face-{across}.toml"
        file.write_text(FACE.format(across, across // 4))
        yield file.stem, file


def show(name, kusabi, file, folder, method, most=None):
    """Prints a line. @return lower and upper bound"""
    output = pathlib.Path(folder, "out.json")
    output.unlink(missing_ok=True)
    words = [kusabi, "critical", file, "--method", method, "--quiet", "--serial", "--output", output]
    if most is not None:
        words += ["--mu-max", str(most)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    label = f"{name:18} {'' if most is None else f'up to {most:g}':14} {method:8} {seconds:7.2f} s"
    if not output.exists():
        print(f"{label}  cut off", flush=True)
        return None, None
    result = json.loads(output.read_text())
    searches = result["statistics"]["searches"]
    proofs = sum(each["programs"] for each in searches if each["phase"].endswith("end"))
    low, high = (bound and bound["value"] for bound in result["result"]["critical_friction"].values())
    print(f"{label} {sum(each['programs'] for each in searches) - proofs:8} + {proofs:<6} {low or 0:.10g} … {high}",
          flush=True)
    return low or 0, high


if __name__ == "__main__":
    os.environ.setdefault("OMPI_ALLOW_RUN_AS_ROOT", "1")
    os.environ.setdefault("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
    main()
