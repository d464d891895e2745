"""bench/hostile: random difficult structures, compared with an oracle that shares no code with the
program.

    python3 bench/hostile --kusabi build/kusabi --count 1000 --seed 1

Requires Python 3.11 only. Prints each case that differs from the oracle, writes it to --found, and
counts. Exit code 0: no disagreement, nothing open; 1: some.
"""

import argparse
import os
import random
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor

import compare
import generate
import generate_bodies
import outputs
import transform
from oracle import BodiesOracle, Oracle
from structure import Mechanism, from_toml, to_toml

#: Kinds with scales so far apart that an answer may be open; an answer that is given must be
#: correct.
FAR = ("lever", "coupling")
#: A node with several contact normals that is wedged by itself leaves the critical coefficient
#: open (docs/theory/wedged.md).
MAY_BE_OPEN = (*FAR, "corner", "loose-corner")


class Settings:
    """Arguments of the questions about each case."""

    def __init__(self, arguments):
        self.kusabi, self.seed = arguments.kusabi, arguments.seed
        self.kinds = arguments.kinds.split(",") if arguments.kinds else [*generate.KINDS, *generate_bodies.KINDS]
        self.contrasts = [float(x) for x in arguments.contrasts.split(",")]
        self.frictionless = not arguments.no_frictionless
        self.of_structure = arguments.of_structure
        self.certificates, self.outputs = arguments.certificates, arguments.outputs
        self.skip = arguments.skip.split(",") if arguments.skip else []


def _outputs(settings, judge, case, rng):
    """Findings on the consistency of all outputs of some commands."""
    mus = sorted({case.mu, float(f"{case.mu * rng.uniform(0.3, 0.9):.6g}")})
    for words in (["patterns", judge.file, "--mu", repr(case.mu)], ["critical", judge.file],
                  ["sweep", judge.file, "--mu", ",".join(map(repr, mus))],
                  *([] if case.kind.startswith("space") else [["rays", judge.file, "--mu", repr(case.mu)]])):
        for line in outputs.contradictions(judge.kusabi, words, judge.tally):
            judge.findings.append(compare.Finding(compare.DISAGREE, "outputs of " + words[0], line))


def _sweep(judge, case):
    """Findings on the counts of a sweep."""
    asked = sorted({case.mu, float(f"{0.7 * case.mu:.6g}"), float(f"{1.5 * case.mu:.6g}")})
    code, result, _, said = judge._ask("sweep", judge.file, "--mu", ",".join(map(repr, asked)))
    if result is None:
        return
    for point in result["points"]:
        truth = judge.oracle.cones(point["mu"])
        if point["count"] is None or code == 3:
            judge.left_open(said, f"count at {point['mu']} open")
        elif point["count"] != len(truth.cones):
            judge._find(compare.UNDECIDED if judge.excuse(truth) else compare.DISAGREE, said,
                        f"{point['count']} at {point['mu']}, but {len(truth.cones)}")


def _truths(settings, judge, case, rng):
    judge.patterns(case.mu, 0)
    if "rays" not in settings.skip:
        judge.rays(case.mu)
    if "critical" not in settings.skip:
        judge.ends()
    if "sweep" not in settings.skip and rng.random() < 0.3:
        _sweep(judge, case)


def _examine_bodies(settings, index, kind):
    """The same for a case of generate_bodies."""
    case = generate_bodies.make(settings.seed, index, [kind], settings.contrasts)
    rng = random.Random(f"ask/{settings.seed}/{index}")
    tally = {}
    in_space = kind.startswith("space")
    try:
        oracle = None if in_space else BodiesOracle(case.text)
    except Mechanism:
        return case, [], {"mechanisms": 1}
    with tempfile.TemporaryDirectory() as folder:
        judge = compare.Judge(compare.Kusabi(settings.kusabi, folder), oracle, case, tally, kind in FAR, kind in MAY_BE_OPEN)
        if not in_space:
            _truths(settings, judge, case, rng)
        if rng.random() < settings.certificates:
            judge.certificates(case.mu, True, ("--cuts", "always") if rng.random() < 0.3 else ())
        if rng.random() < settings.outputs:
            _outputs(settings, judge, case, rng)
    return case, judge.findings, tally


def examine(settings, index):
    """(case, findings, tally) of case number `index`."""
    kind = settings.kinds[index % len(settings.kinds)]
    if kind in generate_bodies.KINDS:
        return _examine_bodies(settings, index, kind)
    case = generate.make(settings.seed, index, settings.kinds, settings.contrasts, settings.frictionless)
    rng = random.Random(f"ask/{settings.seed}/{index}")
    tally = {}
    with tempfile.TemporaryDirectory() as folder:
        kusabi = compare.Kusabi(settings.kusabi, folder)
        judge = compare.Judge(kusabi, Oracle(case.text), case, tally)
        got = judge.patterns(case.mu)
        if "rays" not in settings.skip:
            judge.rays(case.mu)
            if rng.random() < 0.2:
                judge.rays(case.mu, ("--method", "tree"))
        if judge.oracle.d == 3 and rng.random() < 0.2:
            judge.patterns(case.mu, 0, ("--method", "polyhedral"))
        bracket = None
        if "critical" not in settings.skip:
            bracket = judge.critical()
        if bracket and bracket[1] is not None and bracket[1] < 900 and "near" not in settings.skip:
            judge.patterns(bracket[1] * (1 + 10 ** -rng.uniform(1, 6)), margins=1)
        if rng.random() < settings.certificates:
            judge.certificates(case.mu, settings.of_structure)
        if rng.random() < settings.outputs:
            _outputs(settings, judge, case, rng)
        if got is not None and case.kind != "mesh" and "transform" not in settings.skip:
            name = rng.choice(list(transform.ALL))
            other = transform.ALL[name](rng, from_toml(case.text))
            if other is not None:
                _same(judge, kusabi, case, name, to_toml(other), got)
    return case, judge.findings, tally


def _same(judge, kusabi, case, name, text, got):
    """The transformed structure has the same cones."""
    path = os.path.join(kusabi.folder, "transformed.toml")
    with open(path, "w") as file:
        file.write(text)
    code, result, line = kusabi.run("patterns", path, "--mu", repr(case.mu))
    judge.tally[name] = judge.tally.get(name, 0) + 1
    if code != 0:
        judge.findings.append(compare.Finding(compare.OPEN if code == 3 else compare.DISAGREE, f"patterns after {name}",
                                              f"exit code {code}, but 0 before: {line}\n{text}"))
        return
    other = compare.whole_cones(result["result"])
    if set(other) != set(got):
        judge.findings.append(compare.Finding(compare.DISAGREE, f"patterns --mu {case.mu} after {name}",
                                              f"{compare.describe(other)}, but {compare.describe(got)} before\n{text}"))


def _write(folder, case, finding, number):
    """The case as a problem file whose first lines are its findings."""
    os.makedirs(folder, exist_ok=True)
    first, *rest = finding.line.split("\n", 1)
    path = os.path.join(folder, f"{case.name}-{number}.toml")
    with open(path, "w") as file:
        file.write(f"# {finding.kind}: {finding.asked}\n# {first}\n")
        file.write(rest[0] if rest else case.text)
    return path


def main():
    parser = argparse.ArgumentParser(prog="bench/hostile", description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--count", type=int, default=130, help="number of cases; the kinds take turns")
    parser.add_argument("--kinds", help="some of " + ",".join([*generate.KINDS, *generate_bodies.KINDS]))
    parser.add_argument("--contrasts", default="1,1e2,1e4,1e6", help="ratios of stiffness within a structure")
    parser.add_argument("--no-frictionless", action="store_true", help="no candidates with friction 0")
    parser.add_argument("--certificates", type=float, default=0.2, help="share of cases whose certificates are verified")
    parser.add_argument("--outputs", type=float, default=0.2, help="share of cases of which all outputs are compared")
    parser.add_argument("--of-structure", action="store_true", help="verify with --problem")
    parser.add_argument("--skip", help="some of rays,critical,near,transform,sweep")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=float, help="begin no case after so long")
    parser.add_argument("--found", help="write disagreeing cases to this folder")
    parser.add_argument("--allow-open", action="store_true", help="exit code 0 although answers are open")
    parser.add_argument("--quiet", action="store_true", help="print the counts only")
    arguments = parser.parse_args()
    settings = Settings(arguments)
    begin = time.time()
    indices = range(arguments.first, arguments.first + arguments.count)
    totals, kinds = {}, {}
    cases = 0

    def account(outcome):
        nonlocal cases
        case, findings, tally = outcome
        cases += 1
        for key, value in tally.items():
            totals[key] = totals.get(key, 0) + value
        for number, finding in enumerate(findings):
            kinds[finding.kind] = kinds.get(finding.kind, 0) + 1
            path = _write(arguments.found, case, finding, number) if arguments.found else case.name
            if not arguments.quiet:
                print(f"{path} (contrast {case.contrast:g}): {finding.kind}: {finding.asked}: {finding.line.splitlines()[0]}", flush=True)

    late = lambda: arguments.seconds is not None and time.time() - begin > arguments.seconds
    if arguments.jobs > 1:
        with ProcessPoolExecutor(arguments.jobs) as pool:
            waiting = [pool.submit(examine, settings, i) for i in indices]
            for future in waiting:
                if late():
                    future.cancel()
                if not future.cancelled():
                    account(future.result())
    else:
        for i in indices:
            if late():
                break
            account(examine(settings, i))
    print(f"{cases} cases in {time.time() - begin:.0f} s: "
          + ", ".join(f"{kinds.get(k, 0)} {w}" for k, w in ((compare.DISAGREE, "disagreements"), (compare.OPEN, "open"),
                                                            (compare.UNDECIDED, "too close to judge"), (compare.REFUSED, "refused"))))
    print(", ".join(f"{value} {key}" for key, value in sorted(totals.items())))
    return 1 if kinds.get(compare.DISAGREE) or (kinds.get(compare.OPEN) and not arguments.allow_open) else 0


if __name__ == "__main__":
    sys.exit(main())
