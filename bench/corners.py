#!/usr/bin/env python3
"""Worst-case limit loads of domes and towers under a few uncertain loads, beside a linear program for each corner.

    bench/corners.py [--kusabi build/kusabi] [--mpirun "mpirun -np 2"] [--no-peer] [ROW...]

One row for each truss: members, uncertain loads, seconds of `kusabi limit --alpha 1` in one process and on the ranks
of --mpirun, with both ends of the guaranteed interval proved; the proved bounds of the least of the largest factors;
and the seconds of glpsol, if it is installed, on program (5) of every corner, unproved, with their least factor. A
factor of glpsol outside of the bracket ends the script.
"""

import argparse
import itertools
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import time
import tomllib

ROWS = {
    "ring": ["dome", "--rings", "4", "--sectors", "16"],
    "lantern": ["dome", "--kind", "lantern", "--rings", "7", "--sectors", "24"],
    "tower": ["tower", "--storeys", "55"],
    "double-layer": ["dome", "--kind", "double-layer", "--rings", "7", "--sectors", "30"],
}


def timed(words):
    """Seconds of a call, and its standard output; errors end the script, except those of exit code 3."""
    before = time.monotonic()
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(f"{shlex.join(words)}: exit code {done.returncode}\n{done.stderr}")
    return time.monotonic() - before, done.stdout


def corners(file):
    """The text of the problem file with the load of each corner as dead load, for alpha = 1."""
    text = file.read_text()
    loads = tomllib.loads(text)["uncertainty"]
    head = text[:text.index("[[uncertainty]]")]
    for signs in itertools.product((1, -1), repeat=len(loads)):
        groups = [(each["nodes"], [sign * part for part in each["force"]])
                  for sign, load in zip(signs, loads) for each in load["forces"]]
        yield head + "".join(f'[[loads]]\nkind = "dead"\nnodes = {json.dumps(nodes)}\nforce = {force}\n'
                             for nodes, force in groups)


def peer(kusabi, file, folder):
    """Seconds of glpsol for all corners, and the least factor."""
    seconds, least = 0, float("inf")
    corner, program = folder / "corner.toml", folder / "corner.mps"
    for text in corners(file):
        corner.write_text(text)
        timed([kusabi, "export", "mps", str(corner), "--program", "static", "--output", str(program)])
        spent, said = timed(["glpsol", "--freemps", str(program), "--write", str(folder / "solution"), "--steep"])
        seconds += spent
        found = re.search(r"obj = +(\S+)[^\n]*\n(?:[^\n]*\n)*?OPTIMAL LP SOLUTION FOUND", said)
        if not found:
            return seconds, None
        values = re.findall(r"obj = +(\S+)", said)
        least = min(least, -float(values[-1]))
    return seconds, least


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi")
    parser.add_argument("--mpirun", default="", help="call of two ranks; empty: one process only")
    parser.add_argument("--no-peer", action="store_true")
    parser.add_argument("rows", nargs="*", default=list(ROWS), metavar="ROW")
    arguments = parser.parse_args()
    print(f"{'truss':<14} members loads {'one rank':>9} {'ranks':>9}  {'worst case':<32} {'glpsol':>8}  least factor")
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        file, output = folder / "truss.toml", folder / "out.json"
        for row in arguments.rows:
            timed([arguments.kusabi, "example", *ROWS[row], "--output", str(file)])
            call = [arguments.kusabi, "limit", str(file), "--alpha", "1", "--output", str(output)]
            alone, _ = timed([*call, "--serial"])
            shared = timed([*shlex.split(arguments.mpirun), *call])[0] if arguments.mpirun else float("nan")
            found = json.loads(output.read_text())
            worst = found["result"]["maximum"]
            low, high = worst["lower"]["value"], worst["upper"]["value"]
            bracket = f"{low} ... {high}"
            state = "" if found["verdict"]["answered"] else " (open)"
            line = (f"{row:<14} {found['problem']['members']:>7} {found['problem']['m']:>5} {alone:>8.2f}s {shared:>8.2f}s"
                    f"  {bracket}{state}")
            if not arguments.no_peer and shutil.which("glpsol"):
                seconds, least = peer(arguments.kusabi, file, folder)
                line += f" {seconds:>8.2f}s  {least}"
                if least is not None and not low - 1e-5 <= least <= high + 1e-5:
                    raise SystemExit(f"{line}\n{row}: the corners differ")
            print(line, flush=True)


if __name__ == "__main__":
    main()
