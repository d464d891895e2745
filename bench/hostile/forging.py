"""What all forgers share: their command line, the changes of one forgery, and what a run says at its end."""
import argparse
import pathlib
import sys


def command_line(about, count):
    """The arguments of a script. @param about its docstring @param count default number of forgeries"""
    parser = argparse.ArgumentParser(description=about.splitlines()[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--count", type=int, default=count, help="number of forgeries")
    parser.add_argument("--found", type=pathlib.Path, default=pathlib.Path("wrong"), help="folder for the files of failures")
    return parser.parse_args()


def changed(rng, ways):
    """Makes one to three changes, drawn from functions that return False if they change nothing, and otherwise what they
    change. The names of the changes."""
    names = []
    while len(names) < rng.choice((1, 1, 1, 2, 2, 3)):
        way = rng.choice(ways)
        found = way()
        names += [] if found is False else [way.__name__ + (f" ({found})" if found else "")]
    return names


def conclude(count, compared, wrong, outcomes, changes, proved):
    """Prints how often each outcome and each change occurred, and ends with exit code 1 if a statement is wrong."""
    print(f"{count} forgeries, {compared} statements compared, {wrong} wrong: " + ", ".join(f"{n} {key}" for key, n in sorted(outcomes.items())))
    print(", ".join(f"{key} {n} ({proved[key]} proved)" for key, n in sorted(changes.items())))
    sys.exit(1 if wrong else 0)
