"""bench/hostile/relations: the same question in other words, and one command against another.

    python3 bench/hostile/relations --kusabi build/kusabi --count 400 --found different/

Each check asks one question about a structure and about the same structure in other words (turned, renamed,
in other units, in other files), or two questions whose answers depend on each other. Requires Python 3.11
only. The same --seed gives the same checks on any machine. Prints a line for each disagreement, and counts.
Disagreements listed in known-failures.toml are expected; one that no longer occurs is an error as well, so
that its line is removed. Exit code 0: no other disagreement; 1: some, or most checks are open. """

import argparse
import collections
import pathlib
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import checks  # noqa: E402 (below the path of the folder around)
from known import Known  # noqa: E402
import sources  # noqa: E402


def _named(arguments):
    """Names of the cases: files of the project and generated structures in turn."""
    families = arguments.families.split(",") if arguments.families else sources.FAMILIES
    files = [] if arguments.families else checks.files_of_the_project()
    number = arguments.first
    while True:
        if files and number % 4 == 3 and number // 4 < len(files):
            yield files[number // 4]
        else:
            yield f"{families[number % len(families)]} {arguments.seed}/{number}"
        number += 1


def main():
    parser = argparse.ArgumentParser(prog="bench/hostile/relations", description=__doc__.split("\n")[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--count", type=int, default=400, help=f"number of checks, {checks.CHECKS} of a case")
    parser.add_argument("--families", help="generated structures of these families only, separated by commas")
    parser.add_argument("--case", help="all checks of one case, such as 'girder 1/5' or examples/gust.toml")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--known", type=pathlib.Path, default=HERE.parent / "known-failures.toml",
                        help="expected disagreements")
    parser.add_argument("--found", type=pathlib.Path, help="folder for the files of both questions")
    arguments = parser.parse_args()
    known = Known(None if arguments.case else arguments.known)
    counts, outcomes, failed = collections.Counter(), {}, 0

    def receive(future):
        nonlocal failed
        own, findings = future.result()
        outcomes.update(own)
        counts.update(own.values())
        for finding in findings:
            expected = known.expects(finding)
            counts["known"] += expected
            failed += not expected
            if not expected:
                print(f"different: {' | '.join(finding.key)}: {finding.line}", flush=True)
            if arguments.found and not expected:
                finding.write(arguments.found)

    with ProcessPoolExecutor(arguments.jobs) as pool:
        if arguments.case:
            jobs = [pool.submit(checks.examine, arguments.kusabi, arguments.case, None, 10**6)]
        else:
            jobs = [
                pool.submit(checks.examine, arguments.kusabi, name, wanted)
                for name, wanted in known.cases().items()
            ]
            names = _named(arguments)
            jobs += [
                pool.submit(checks.examine, arguments.kusabi, next(names))
                for _ in range(-(-arguments.count // checks.CHECKS))
            ]
        for job in as_completed(jobs):
            receive(job)
    if not arguments.case:
        for line in known.obsolete(outcomes):
            failed += 1
            print(f"no longer different: {' | '.join(line)}: remove this line of {arguments.known.name}")
    reasons = {key.removeprefix("open: "): count for key, count in counts.items() if key.startswith("open: ")}
    is_open, different = sum(reasons.values()), counts["different"] - counts["known"]
    print(f"{counts['agree']} agree, {is_open} open, {counts['known']} known, {different} different")
    print("".join(f"  {count} open: {reason}\n" for reason, count in sorted(reasons.items())), end="")
    if not arguments.case and counts["agree"] < is_open + different:
        failed += 1
        print("fewer than half of the checks agree, known failures apart")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
