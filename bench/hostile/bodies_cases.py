"""Bodies of tests/cases that earlier versions got wrong: correct answers, and the comparison with
them.

    python3 bench/hostile/bodies_cases.py tests/cases --kusabi build/kusabi     # compares every command with bodies.json
    python3 bench/hostile/bodies_cases.py tests/cases --write                   # writes bodies.json, by the oracle alone

An answer must be correct with exit code 0, or open with exit code 3 and a sentence if scales are
far apart (`far`). Certificates must be proved; bounds of `critical` that are called proved must be
correct.
"""

import argparse
import json
import os
import sys
import tempfile
from decimal import Decimal

from compare import Kusabi, whole_cones
from oracle import BodiesOracle

#: (file, friction coefficient, further arguments of `patterns`, whether scales are far apart)
ASKED = (("lever_3e11", 0.5, (), True), ("lever_1e12", 0.5719, (), True), ("lever_2e10", 1.0, (), True), ("lever_2e11", 1.0, (), True),
         ("weak_coupling_1e-11", 1.83834805972901, (), True),
         ("pair_on_edges", 1.2492575712727418, (), False), ("loose_with_cuts", 1.72062024876753, ("--cuts", "always"), False))
#: Upper limit and width of the search for the smallest coefficient by the oracle.
MOST, WIDTH = 8.0, Decimal("1e-10")


def _critical(oracle):
    """[infeasible at, feasible at]; the latter is None if nothing is feasible up to MOST."""
    low, high = Decimal(0), Decimal(MOST)
    if not oracle.wedges(float(high)):
        return [MOST, None]
    while high - low > WIDTH * high:
        middle = (low + high) / 2
        low, high = (low, middle) if oracle.wedges(float(middle)) else (middle, high)
    return [float(low), float(high)]


def write(folder):
    cases = []
    for name, mu, words, far in ASKED:
        with open(os.path.join(folder, name + ".toml")) as file:
            oracle = BodiesOracle(file.read())
        cones = [{"contact": sorted(s), "separated": sorted(g), "solid": solid} for (s, g), solid in oracle.cones(mu).cones.items()]
        cases.append({"file": name + ".toml", "mu": mu, "words": list(words), "far": far,
                      "cones": sorted(cones, key=lambda c: c["contact"]), "critical": _critical(oracle)})
    with open(os.path.join(folder, "bodies.json"), "w") as file:
        file.write('{"about": "by bench/hostile/bodies_cases.py, 140 digits; never copied from an output",\n "cases": [\n')
        file.write(",\n".join(json.dumps(case) for case in cases) + "\n]}\n")


def _list(kusabi, case, path):
    code, result, line = kusabi.run("patterns", path, "--mu", repr(case["mu"]), *case["words"])
    if code == 3 and case["far"]:
        return
    if code != 0:
        yield f"patterns: exit code {code}: {line}"
        return
    truth = {(frozenset(c["contact"]), frozenset(c["separated"])): c["solid"] for c in case["cones"]}
    if whole_cones(result["result"]) != truth or result["result"]["count"] != len(truth):
        yield f"patterns: {result['result']['count']} for {len(truth)}"


def _certificate(kusabi, case, path):
    evidence = os.path.join(kusabi.folder, "evidence")
    code, result, _ = kusabi.run("patterns", path, "--mu", repr(case["mu"]), *case["words"], "--certificate", evidence)
    proved, _, line = kusabi.run("verify", evidence, "--problem", path)
    if code == 3 and case["far"]:
        return
    ties = result["result"]["exact"]["unproved"]  # no claim, as it states
    if proved != code and not (proved == 3 and ties):
        yield f"patterns: exit code {code}, verify: {proved}: {line}"


def _rays_and_counts(kusabi, case, path):
    for words in (("rays", path, "--mu", repr(case["mu"])), ("sweep", path, "--mu", repr(case["mu"]))):
        code, result, line = kusabi.run(*words)
        if code != 0 and case["far"]:
            continue
        answer = result["result"]
        count = len(answer["cones"]) if words[0] == "rays" else answer["points"][0]["count"]
        if code != 0 or count != len(case["cones"]):
            yield f"{words[0]}: exit code {code}, {count} for {len(case['cones'])}"


def _ends(kusabi, case, path):
    code, result, line = kusabi.run("critical", path, "--mu-max", str(MOST))
    if result is None:
        yield f"critical: exit code {code}: {line}"
        return
    low, high = result["result"]["critical_friction"].values()
    dead, feasible = case["critical"]
    if low and low["standing"] == "proved" and feasible is not None and low["value"] > feasible:
        yield f"critical: the proved lower bound is {low['value']}, but a pattern is feasible at {feasible}"
    if high and high["standing"] == "proved" and high["value"] < dead:
        yield f"critical: the proved upper bound is {high['value']}, but no pattern is feasible up to {dead}"
    if code == 0 and low and low["standing"] != "proved":
        yield "critical: exit code 0 with a lower end that is not proved"
    if code != 0 and not case["far"]:
        yield f"critical: exit code {code}: {line}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--kusabi", default="build/kusabi")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    if arguments.write:
        write(arguments.folder)
        return 0
    with open(os.path.join(arguments.folder, "bodies.json")) as file:
        cases = json.load(file)["cases"]
    wrong = 0
    with tempfile.TemporaryDirectory() as work:
        kusabi = Kusabi(arguments.kusabi, work)
        for case in cases:
            path = os.path.abspath(os.path.join(arguments.folder, case["file"]))
            for check in (_list, _certificate, _rays_and_counts, _ends):
                for text in check(kusabi, case, path):
                    wrong += 1
                    print(f"{case['file']}: {text}")
    print(f"{len(cases)} bodies, {wrong} answers come out otherwise than they should")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
