"""Runs every subcommand and compares all outputs with those of another build, or with the committed table.

    python3 bench/frozen                                    # with the table
    python3 bench/frozen --against ../before/build/kusabi   # with another build, number by number
    python3 bench/frozen --expect numbers                   # a change that means to change numbers only

Exit code 0: every call ends by itself, and no difference but of the expected kinds. 1: otherwise, or if the
table has a row without a call. 2: wrong options.
"""

import argparse
import collections
import dataclasses
import pathlib
import shutil
import sys
import time
from concurrent.futures import ProcessPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import table  # noqa: E402: beside this file
from calls import all_calls  # noqa: E402
from comparing import KINDS, STRUCTURE, Difference, compare, compare_summaries, summary  # noqa: E402
from reading import Item, coarse, read  # noqa: E402
from running import SOURCES, failures, outputs  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parent / "table.tsv"


def _folder_of(kept, call):
    return kept / call.name.replace("/", "_")


def _keep(kept, call, found):
    """Writes the outputs of the call in place of those of an earlier run."""
    folder = _folder_of(kept, call)
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in found.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())


def _kept(kept, call):
    folder = _folder_of(kept, call)
    return {str(path.relative_to(folder)): path.read_bytes().decode()
            for path in folder.rglob("*") if path.is_file()}


def compare_outputs(old, new, one_by_one):
    """[(output, difference)] of two calls.
    @param one_by_one comparison of the contents of an output in both"""
    if not old:
        return [("all outputs", Difference(STRUCTURE, "are new"))]
    found = []
    for name in sorted({*old, *new}):
        if name not in new:
            found.append((name, Difference(STRUCTURE, "is missing")))
        elif name not in old:
            found.append((name, Difference(STRUCTURE, "is new")))
        elif old[name] != new[name]:
            found += [(name, difference) for difference in one_by_one(name, old[name], new[name])]
    return found


def _reading(call, name, text):
    items = read(name, text)
    return list(coarse(items)) if call.stopped else items


#: Kinds of outputs that have one row in a table, by the ends of their names.
_ROWS = {".exits": "messages", ".messages": "messages", ".printed": "printed", ".svg": "pictures",
         ".vtu": "vtu", ".pvd": "vtu", ".py": "vtu",
         "": "certificate", ".lower": "certificate", ".upper": "certificate"}


def _summaries(call, found):
    """{kind of output: summary} of all outputs."""
    readings = {}
    for name, text in sorted(found.items()):
        items = readings.setdefault(_ROWS.get(pathlib.PurePath(name).suffix, name), [])
        items.append(Item(name))
        items += _reading(call, name, text)
    rows = {kind: summary(items) for kind, items in readings.items()}
    if call.sensitive:
        rows = {kind: dataclasses.replace(row, checksum=0) for kind, row in rows.items()}
    return rows


def examine(call, arguments, rows):
    """(call, seconds, differences, steps that crashed or did not end, summaries).
    @param rows those of the table, if it is compared with one"""
    begin = time.time()
    found = outputs(arguments.kusabi, call, arguments.seconds)
    if arguments.keep:
        _keep(arguments.keep, call, found)
    if rows is not None:
        summaries = _summaries(call, found)
        differences = compare_outputs(rows, summaries, lambda _, old, new: compare_summaries(old, new))
    else:
        summaries = {}
        if arguments.against.is_dir():
            before = _kept(arguments.against, call)
        else:
            before = outputs(arguments.against, call, arguments.seconds)
        differences = compare_outputs(before, found, lambda name, old, new: compare(
            _reading(call, name, old), _reading(call, name, new)))
    return call, time.time() - begin, differences, failures(found), summaries


def _is_table(path):
    """True if the file is a table, not a program or a folder."""
    return path.is_file() and path.suffix == ".tsv"


def _kinds(text):
    kinds = set(text.split(",")) if text else set()
    if not kinds <= set(KINDS):
        raise argparse.ArgumentTypeError(f"some of {','.join(KINDS)}, separated by commas")
    return kinds


def _arguments():
    parser = argparse.ArgumentParser(prog="bench/frozen", description=__doc__.split("\n", maxsplit=1)[0])
    path = lambda text: pathlib.Path(text).absolute()
    parser.add_argument("--kusabi", type=path, default=SOURCES / "build/kusabi",
                        help="the command under test")
    parser.add_argument("--against", type=path, default=TABLE, metavar="BINARY|TABLE|DIR",
                        help="another build of the command, a table (.tsv), or a folder of --keep. "
                        "Default: the table of the sources")
    parser.add_argument("--expect", type=_kinds, default=set(), metavar="KINDS",
                        help=f"kinds of differences that are no failure: some of {','.join(KINDS)}")
    parser.add_argument("--renew", action="store_true", help="write the new rows into the table")
    parser.add_argument("--keep", type=path, metavar="DIR", help="write all outputs to this folder")
    parser.add_argument("--quick", action="store_true", help="only the calls that take no time")
    parser.add_argument("--only", default="", metavar="WORDS",
                        help="only the calls whose names contain these words")
    parser.add_argument("--jobs", type=int, default=2, help="calls at a time")
    parser.add_argument("--seconds", type=float, default=300,
                        help="a step that takes longer is stopped, which is another structure")
    arguments = parser.parse_args()
    for place in (arguments.kusabi, arguments.against):
        if not place.exists() and not (arguments.renew and place == arguments.against):
            parser.error(f"{place} does not exist")
    if arguments.renew and arguments.against.exists() and not _is_table(arguments.against):
        parser.error("--renew writes a table, which --against does not name")
    return arguments


def main():
    arguments = _arguments()
    every = all_calls()
    calls = [call for call in every if arguments.only in call.name and (call.quick or not arguments.quick)]
    if not calls:
        print(f"no call has \"{arguments.only}\" in its name", file=sys.stderr)
        return 2
    of_table = arguments.renew or _is_table(arguments.against)
    rows = table.load(arguments.against) if of_table and arguments.against.exists() else {}
    without_call = [] if arguments.renew else sorted(rows.keys() - {call.name for call in every})
    counts, unexpected, unended, begin = collections.Counter(), 0, 0, time.time()
    with ProcessPoolExecutor(arguments.jobs) as pool:
        running = [pool.submit(examine, call, arguments,
                               rows.get(call.name, {}) if of_table else None) for call in calls]
        for number, task in enumerate(running, 1):
            call, seconds, differences, failed, summaries = task.result()
            kinds = [kind for kind in KINDS if any(difference.kind == kind for _, difference in differences)]
            print(f"{number:4}/{len(calls)} {seconds:6.1f} s  {call.name}: {', '.join(kinds) or 'the same'}",
                  flush=True)
            for line in failed:
                print(f"       did not end by itself: {line}", flush=True)
            for output, difference in differences:
                print(f"       {difference.kind}: {output}: {difference.line}", flush=True)
            counts.update(kinds)
            unexpected += any(kind not in arguments.expect for kind in kinds)
            unended += bool(failed)
            if arguments.renew and not failed:
                rows[call.name] = summaries
    print(f"{len(calls)} calls in {time.time() - begin:.0f} s; with differences in "
          + ", ".join(f"{kind}: {counts[kind]}" for kind in KINDS))
    for name in without_call:
        print(f"a row of the table has no call: {name}")
    if unended:
        print(f"{unended} calls did not end by themselves" + ("; not renewed" if arguments.renew else ""))
    if arguments.renew:
        table.save(arguments.against, rows, [call.name for call in every])
        print(f"wrote {arguments.against}")
        return 1 if unended else 0
    if unexpected:
        print(f"{unexpected} calls have differences that are not expected"
              + (f" (only {', '.join(sorted(arguments.expect))})" if arguments.expect else ""))
    return 1 if unexpected or unended or without_call else 0


if __name__ == "__main__":
    sys.exit(main())
