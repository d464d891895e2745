#!/usr/bin/env python3
"""Worst-case limit loads of grids, beside programs that solve the 0-1 program (L 29).

    bench/limit.py [--kusabi build/kusabi] [--seconds S] [BAYS:ALPHA...]

One row for each grid: members, uncertain loads, user CPU seconds of `kusabi limit --certificate` on
one rank and of `kusabi verify --problem`, relative width of the proved bracket, size of the
certificate; then user CPU seconds of cbc and glpsol, if they are installed, on the exported program
with the derived M, up to S seconds each (default 60): "-" if not solved, and no further grids are
tried by that one. An optimum outside of the bracket is printed. The last line is the exponent of the
seconds in the number of members, between the first and the last grid with the same alpha.
"""

import argparse
import json
import math
import os
import re
import resource
import shutil
import subprocess
import tempfile

USUAL = ["4:40", "5:40", "6:40", "8:40", "10:40", "12:40", "14:40", "16:40", "20:40", "30:20"]
PEERS = {
    "cbc": (["cbc", "{file}", "seconds", "{seconds}", "solve"], r"Result - Optimal[\s\S]*Objective value: +(\S+)"),
    "glpsol": (["glpsol", "--freemps", "{file}", "--tmlim", "{seconds}", "--pcost", "--mir", "-o", "{file}.out"],
               r"(?:obj|cost) = +(\S+) +\(MINimum\)"),
}


def call(words):
    """User CPU seconds, and the text of standard output; errors end the script, except those of exit code 3."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(f"{' '.join(words)}: exit code {done.returncode}\n{done.stderr}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, done.stdout


def peer(name, file, seconds):
    """User CPU seconds and optimum; None: it is not installed or does not end in time."""
    words, optimum = PEERS[name]
    if shutil.which(name) is None:
        return None
    spent, said = call([word.format(file=file, seconds=seconds) for word in words])
    if os.path.exists(f"{file}.out"):
        with open(f"{file}.out") as text:
            said += text.read() if "INTEGER OPTIMAL SOLUTION FOUND" in said else ""
    found = re.search(optimum, said)
    return (spent, float(found[1])) if found else None


def measure(kusabi, folder, bays, alpha):
    """A row without peers, as a dictionary."""
    file, cert, out = (os.path.join(folder, name) for name in ("grid.toml", "cert", "out.json"))
    call([kusabi, "example", "grid", "--bays", str(bays), "-o", file])
    seconds, _ = call([kusabi, "limit", file, "--alpha", str(alpha), "--serial", "--certificate", cert, "-o", out])
    checked, _ = call([kusabi, "verify", cert, "--problem", file, "--serial"])
    with open(out) as text:
        answer = json.load(text)
    worst = answer["result"]["maximum"]
    return {"file": file, "members": len(answer["result"]["nominal_forces"]), "seconds": seconds, "verify": checked,
            "uncertain": answer["result"]["uncertain_components"], "lower": worst["lower"]["value"],
            "upper": worst["upper"]["value"],
            "megabytes": os.path.getsize(cert) / 1e6}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi")
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("grids", nargs="*", default=USUAL, metavar="BAYS:ALPHA")
    arguments = parser.parse_args()
    print("bays  alpha  members  uncertain        s  verify, s    width      MB" + "".join(f"  {name + ', s':>9}" for name in PEERS))
    sizes, ended = {}, set()
    for grid in arguments.grids:
        bays, alpha = grid.split(":")
        with tempfile.TemporaryDirectory() as folder:
            row = measure(arguments.kusabi, folder, bays, alpha)
            width = (row["upper"] - row["lower"]) / abs(row["upper"])
            print(f"{bays:>4}  {alpha:>5}  {row['members']:>7}  {row['uncertain']:>9}  {row['seconds']:7.2f}  "
                  f"{row['verify']:9.2f}  {width:.1e}  {row['megabytes']:6.1f}", end="", flush=True)
            program = os.path.join(folder, "grid.mps")
            if ended != set(PEERS):
                call([arguments.kusabi, "export", "mps", row["file"], "--alpha", alpha, "-o", program])
            for name in PEERS:
                found = None if name in ended else peer(name, program, arguments.seconds)
                if found is None:
                    ended.add(name)
                    print(f"  {'-':>9}", end="", flush=True)
                    continue
                print(f"  {found[0]:9.2f}", end="", flush=True)
                size = 1e-6 * (1 + abs(row["upper"]))
                if not row["lower"] - size <= found[1] <= row["upper"] + size:
                    print(f" ({found[1]}, not in {row['lower']} ... {row['upper']})", end="")
            print()
            sizes.setdefault(alpha, []).append((row["members"], row["seconds"]))
    for alpha, rows in sizes.items():
        if len(rows) > 1:
            (small, first), (large, last) = rows[0], rows[-1]
            print(f"alpha = {alpha}: seconds grow as the power {math.log(last / first) / math.log(large / small):.2f} of the members")


if __name__ == "__main__":
    main()
