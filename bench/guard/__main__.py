"""bench/guard: counts of work, which no load of the machine changes, compared with a committed table.

    python3 bench/guard                                  the rows of every day, in some two minutes
    python3 bench/guard --nightly                        all rows
    python3 bench/guard --row NAME...                    some rows
    python3 bench/guard --against OTHER                  the same calls of another binary, with ratios
    python3 bench/guard --renew ROW... --reason "..."    measures rows, and renews them in the table
    python3 bench/guard --renew all --reason "..."       the whole table

Fails, exit code 1, if the answer of a row is wrong, if a count of nodes, programs, iterations or other work
differs from that of the table, or if instructions, allocated bytes, the peak of the heap or the size of a
file differ from it by more than 5 %, also downwards, or appear or disappear. A commit that means to change a
row, or gains, renews it and says why. CPU seconds are reported and not judged. With another compiler, C
library, valgrind or processor than those of the table, instructions and bytes of the heap are not judged
either. --against fails only if an answer of the first command is wrong.

Requires Python 3.11, valgrind and glibc. Exit code 2: a row could not be measured.
"""

import argparse
import os
import pathlib
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

import measure
import table
from calls import engine_program
from rows import DAILY, ROWS

FAILED, CANNOT = 1, 2
#: Amounts, with the units in which they are printed.
COLUMNS = {"instructions": ("million instr.", 1e6), "allocated": ("allocated MB", 1e6),
           "heap_peak": ("heap peak MB", 1e6), "result": ("result kB", 1e3),
           "certificate": ("certificate kB", 1e3)}
#: Counts that are printed; all are compared.
SHOWN = ("opened", "nodes", "programs", "bound_programs", "tree_programs", "iterations", "pairs")
#: Names of several rows.
GROUPS = {"daily": DAILY, "all": ROWS}


def arguments():
    parser = argparse.ArgumentParser(prog="bench/guard", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--kusabi", type=pathlib.Path, default=pathlib.Path("build/kusabi"), help="default: build/kusabi")
    add("--nightly", action="store_true", help="all rows")
    add("--row", nargs="+", metavar="NAME", default=[], help="only these rows")
    add("--list", action="store_true", help="print the rows, with the reasons of their last renewal")
    add("--against", type=pathlib.Path, metavar="OTHER", help="compare with this binary instead of the table")
    add("--renew", nargs="+", metavar="ROW", default=[], help="renew these rows, or daily, or all")
    add("--reason", help="for --renew: the change that the rows show")
    add("--jobs", type=int, default=os.cpu_count(), help="rows measured at a time; default: as many as cores")
    asked = parser.parse_args()
    known = {row.name for row in ROWS} | GROUPS.keys()
    unknown = [name for name in [*asked.row, *asked.renew] if name not in known]
    if unknown:
        parser.error(f"no row is named {', '.join(unknown)}; --list prints them")
    if bool(asked.renew) != bool(asked.reason):
        parser.error("--renew and --reason require each other")
    return asked


def chosen(asked):
    names = asked.renew or asked.row or (["all"] if asked.nightly else ["daily"])
    groups = [row for name in names for row in GROUPS.get(name, [])]
    return [row for row in ROWS if row.name in names or row in groups]


def measured(rows, kusabi, jobs, known):
    """Measurements by the names of their rows; the longest begin first."""
    found = {}
    with ThreadPoolExecutor(jobs) as pool:
        order = sorted(rows, key=lambda row: known.amount(row.name, "instructions"), reverse=True)
        begun = {pool.submit(measure.measure, row, kusabi): row for row in order}
        for future in as_completed(begun):
            row = begun[future]
            found[row.name] = future.result()
            print(f"[{len(found):>2}/{len(rows)}] {row.name}: {found[row.name].answer}; "
                  f"{found[row.name].amounts['instructions'] / 1e6:,.0f} million instructions", flush=True)
    return found


def print_cells(name, cells, end):
    print(f"{name:<18}" + "".join(f"{cell:>15}" for cell in cells) + "   " + end)


def print_table(rows, found, before):
    """@param before instructions by the names of rows"""
    heads = [head for head, _ in COLUMNS.values()]
    print()
    print_cells("", [heads[0], "change", *heads[1:], "CPU s"], "counts")
    for row in rows:
        figures = found[row.name]
        cells = [f"{figures.amounts[key] / unit:,.1f}" if key in figures.amounts else ""
                 for key, (_, unit) in COLUMNS.items()]
        changed = table.change(before[row.name], figures.amounts["instructions"])
        counts = [f"{name} {count:,}" for name, count in figures.counts.items()
                  if name.split(".")[-1] in SHOWN]
        print_cells(row.name, [cells[0], changed, *cells[1:], f"{figures.seconds:.2f}"], ", ".join(counts))


def print_ratios(rows, found, other):
    """Each amount divided by that of the other binary, and the counts that differ."""
    print()
    print_cells("ratio to the other", COLUMNS, "counts that differ: here, other")
    for row in rows:
        here, there = found[row.name], other[row.name]
        both = here.amounts.keys() & there.amounts.keys()
        cells = [f"{here.amounts[key] / there.amounts[key]:.3f}" if key in both else "" for key in COLUMNS]
        names = here.counts | there.counts
        counts = [(name, here.counts.get(name, 0), there.counts.get(name, 0)) for name in names]
        differing = [f"{name} {one:,}, {two:,}" for name, one, two in counts if one != two]
        print_cells(row.name, cells, "; ".join(differing))


def print_list(known):
    for row in ROWS:
        when = "daily" if row in DAILY else "nightly"
        reason = known.rows[row.name]["reason"] if row.name in known.rows else "not in the table"
        print(f"{row.name:<18} {when:<8} {row.right_answer:<60} {reason}")


def renew(rows, found, known, facts, reason):
    wrong = [row for row in rows if found[row.name].answer != row.right_answer]
    for row in wrong:
        print(f"not renewed: {table.wrong_answer(row, found[row.name])}")
    for row in rows:
        if row not in wrong:
            known.renew(row.name, found[row.name], reason)
    known.facts = facts
    for name in known.rows.keys() - {row.name for row in ROWS}:
        del known.rows[name]
    known.write()
    return FAILED if wrong else 0


def judge(rows, found, known, facts):
    """Prints all failures. @return the exit code"""
    other = known.other_facts(facts)
    failures = [line for row in rows for line in table.failures(row, known, found[row.name], not other)]
    unjudged = f" Instructions and bytes of the heap were not judged: {other}." if other else ""
    if not failures:
        what = "Answers, counts and files of all" if other else "All"
        print(f"\n{what} {len(rows)} rows are as in the table.{unjudged}")
        return 0
    names = " ".join(dict.fromkeys(line.split(":", 1)[0] for line in failures))
    print(f"\nFAILED:{unjudged}", *failures, sep="\n  ")
    print("If the change is meant, renew the rows in the commit that makes it:\n"
          f"  python3 bench/guard --renew {names} --reason \"...\"")
    return FAILED


def compare(asked, kusabi, against, jobs, known):
    """Prints the ratios of two commands in the rows that both can run. @return the exit code"""
    rows = [row for row in asked if row.available(kusabi) and row.available(against)]
    if len(rows) < len(asked):
        print("The row of the engine's example is left out, since it is not built beside both commands.")
    found, other = (measured(rows, command, jobs, known) for command in (kusabi, against))
    print_table(rows, found, {name: figures.amounts["instructions"] for name, figures in other.items()})
    print_ratios(rows, found, other)
    wrong = [row for row in rows if found[row.name].answer != row.right_answer]
    if wrong:
        print("\nFAILED:", *(table.wrong_answer(row, found[row.name]) for row in wrong), sep="\n  ")
    return FAILED if wrong else 0


def main():
    asked, begin, known = arguments(), time.monotonic(), table.Table.read()
    if asked.list:
        print_list(known)
        return 0
    measure.require_valgrind()
    kusabi = str(asked.kusabi.resolve())
    if asked.against:
        return compare(chosen(asked), kusabi, str(asked.against.resolve()), asked.jobs, known)
    rows, facts = chosen(asked), measure.facts(kusabi)
    if not all(row.available(kusabi) for row in rows):
        raise measure.GuardError(f"{engine_program(kusabi)} is not built; configure with KUSABI_TESTS=ON, or "
                                 "name other rows with --row")
    if asked.renew and known.other_facts(facts) and known.rows.keys() - {row.name for row in rows}:
        raise measure.GuardError(f"{known.other_facts(facts)}: renew all")
    found = measured(rows, kusabi, asked.jobs, known)
    print_table(rows, found, {row.name: known.amount(row.name, "instructions") for row in rows})
    code = renew(rows, found, known, facts, asked.reason) if asked.renew else judge(rows, found, known, facts)
    print(f"{time.monotonic() - begin:.0f} s")
    return code


if __name__ == "__main__":
    try:
        sys.exit(main())
    except measure.GuardError as error:
        print(f"bench/guard: {error}", file=sys.stderr)
        sys.exit(CANNOT)
