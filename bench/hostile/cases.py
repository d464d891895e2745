"""Comparison of `kusabi` on the inputs of tests/cases with truth.json.

    python3 bench/hostile/cases.py tests/cases --kusabi build/kusabi

Prints a line for each entry that differs. Exit code 0: none.
"""

import argparse
import json
import os
import sys
import tempfile

from compare import Kusabi

WIDTH = 2.1e-8  # of a bracket: two cells, if the truth is on the grid


def _set(entries, *keys):
    return {tuple(frozenset(entry.get(key, ())) for key in keys) for entry in entries}


def _patterns(expected, result):
    if result["count"] != expected["count"]:
        yield f"count {result['count']}, not {expected['count']}"
    for truth in expected["blocks"]:
        members = set(truth["candidates"])
        mine = [p for p in result["patterns"] if set(p["contact"]) | set(p["separated"]) <= members]
        mine = [{**p, "inactive": [n for n in p.get("inactive", ()) if n in members]} for p in mine]
        keys = ("contact", "separated", "inactive")
        if _set(mine, *keys) != _set(truth["patterns"], *keys):
            yield f"block {sorted(members)}: {len(mine)} cones, not those {truth['count']}"
            continue
        for entry in truth["patterns"]:
            found = next(p for p in mine if _set([p], *keys) == _set([entry], *keys))
            if found["state"] != entry["state"]:
                yield f"{entry['contact']} is {entry['state']}, not {found['state']}"
            elif "margin" in entry and abs(found["margin"] - entry["margin"]) > 1e-3 * entry["margin"]:
                yield f"{entry['contact']}: margin {found['margin']:.4e}, not {entry['margin']:.4e}"


def _rays(expected, result):
    if result["count"] != expected["count"]:
        yield f"{result['count']} rays, not {expected['count']}"
    mine = [{**c, "contact": [n for n in c["contact"] if n not in c.get("idle", ())]} for c in result["cones"]]
    if _set(mine, "contact", "separated", "idle") != _set(expected["cones"], "contact", "separated", "idle"):
        yield f"{len(mine)} cones, not those {len(expected['cones'])}"


def _critical(expected, result):
    lower, upper = (bound and bound["value"] for bound in result["critical_friction"].values())
    lower = lower or 0.0
    low, high = (float(x) for x in expected["critical_friction"])
    if upper is None:
        yield f"nothing can wedge up to {lower}, but from {low} on"
    elif lower > high or upper < low:
        yield f"{lower!r} .. {upper!r} does not hold {low!r}"
    elif upper - lower > WIDTH:
        yield f"{lower!r} .. {upper!r} is {upper - lower:.1e} wide"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--kusabi", default="build/kusabi")
    arguments = parser.parse_args()
    with open(os.path.join(arguments.folder, "truth.json")) as file:
        cases = json.load(file)["cases"]
    wrong = 0
    with tempfile.TemporaryDirectory() as work:
        for case in cases:
            words, expected = list(case["command"]), case["expected"]
            place = lambda name: os.path.abspath(os.path.join(arguments.folder, name))
            words = [place(w) if w.endswith(".toml") else w for w in words]
            code, result, line = Kusabi(arguments.kusabi, work).run(words[0], place(case["file"]), *words[1:])
            found = []
            if "exit" in expected:
                allowed = expected["exit"] if isinstance(expected["exit"], list) else [expected["exit"]]
                if code not in allowed:
                    found.append(f"exit code {code}, not {expected['exit']}: {line}")
            if result is not None and words[0] in ("patterns", "rays", "critical") and "says" not in expected:
                check = {"patterns": _patterns, "rays": _rays, "critical": _critical}[words[0]]
                found += check(expected, result["result"])
            if "says" in expected and code == 0 and "match" not in line and "warn" not in line:
                found.append(f"does not tell: {expected['says']}")
            wrong += bool(found)
            for text in found:
                print(f"{case['file']} {' '.join(case['command'])}: {text}")
    print(f"{len(cases)} commands, {wrong} come out otherwise than they should")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
