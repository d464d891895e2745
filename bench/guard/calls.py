"""Calls of the rows, and their answers as text.

A call is a function of the command and the folder of a run: it makes the files that it needs there, and
returns its words. An answer is a function of the result, None without one, and of standard output.
"""

import dataclasses
import os
import re
from collections.abc import Callable

from measure import BENCH, made

EXAMPLES = BENCH.parent / "examples"


@dataclasses.dataclass
class Row:
    name: str
    call: Callable
    answer: Callable
    expected: str
    exit_code: int = 0
    opened: str = ""  # of a call without a result file: pattern of its number of nodes in the output

    @property
    def right_answer(self):
        return f"exit code {self.exit_code}, {self.expected}"

    def printed_counts(self, printed):
        found = re.search(self.opened, printed) if self.opened else None
        return {"nodes": int(found[1])} if found else {}

    def available(self, kusabi):
        """Whether the program exists; only the example of the engine may be missing beside a command."""
        return not self.name.startswith("engine") or os.path.exists(engine_program(kusabi))


def in_folder(folder, name):
    return os.path.join(folder, name)


def example(*words):
    """A problem that `kusabi example` makes."""
    def problem(kusabi, folder):
        path = in_folder(folder, "problem.toml")
        made([kusabi, "example", *map(str, words), "--output", path])
        return path
    return problem


def shipped(name):
    """A problem of examples/."""
    return lambda kusabi, folder: str(EXAMPLES / name)


def written(make):
    """A problem of faces.py, hold.py or structures.py."""
    return lambda kusabi, folder: make(folder)


def solve(subcommand, problem, *words, certificate=False):
    def call(kusabi, folder):
        more = ["--certificate", in_folder(folder, "certificate")] if certificate else []
        return [kusabi, subcommand, problem(kusabi, folder), *map(str, words), *more, "--serial", "--quiet",
                "--output", in_folder(folder, "result")]
    return call


def verify(solving, part=""):
    """The proof of the certificate of a call of `solve`.
    @param part the end of its name, if the call writes several"""
    def call(kusabi, folder):
        solved = solving(kusabi, folder)
        made(solved)
        os.remove(in_folder(folder, "result"))  # of the other call
        return [kusabi, "verify", in_folder(folder, "certificate" + part), "--problem", solved[2], "--serial"]
    return call


def bench(*words):
    return lambda kusabi, folder: [kusabi, "bench", *map(str, words), "--serial"]


def engine_program(kusabi):
    """The knapsack of examples/engine, which bench/guard/CMakeLists.txt builds beside the command."""
    return os.path.join(os.path.dirname(kusabi), "bench", "guard", "guard_knapsack")


def knapsack(*words):
    return lambda kusabi, folder: [engine_program(kusabi), *map(str, words)]


def count(result, printed):
    return f"{result['status']}, {result['result']['count']:,} found"


def proved(ends):
    return all(bound and bound["standing"] == "proved" for bound in (ends["lower"], ends["upper"]))


def bracket(key, truth, relative=1e-6):
    """A proved bracket that is at most `relative` of its upper end wide.
    @param truth a number in it, which is part of the answer"""
    def answer(result, printed):
        ends = result["result"][key]
        low, high = (bound["value"] if bound else float("nan") for bound in (ends["lower"], ends["upper"]))
        if not proved(ends) or high - low > relative * abs(high):
            return f"{result['status']}, from {low} to {high}, {'' if proved(ends) else 'not '}proved"
        contains = low - relative * abs(truth) <= truth <= high + relative * abs(truth)
        return f"{result['status']}, proved to {relative}, {truth if contains else high}"
    return answer


def within(least, most):
    """A proved bracket of the critical coefficient that lies between these coefficients."""
    def answer(result, printed):
        ends = result["result"]["critical_friction"]
        inside = proved(ends) and least <= ends["lower"]["value"] and ends["upper"]["value"] <= most
        return f"{result['status']}, " + (f"proved within {least} and {most}" if inside else str(ends))
    return answer


def interval(result, printed):
    """The only interval of load factors."""
    (only,) = result["result"]["intervals"]
    return f"{result['status']}, {only['below']['upper']['value']:.2f} to {only['above']['lower']['value']:.2f}"


def verified(result, printed):
    return "proved" if re.search("^PROVED", printed, re.MULTILINE) else "not proved"


def as_published(result, printed):
    """Of `bench uts`: three counts."""
    return f"{printed.count('as published')} counts as published"


def printed_line(word):
    """Of other programs: the first line that contains a word."""
    def answer(result, printed):
        found = re.search(f"^.*{word}.*$", printed, re.MULTILINE)
        return found[0].strip() if found else f"no line with {word}"
    return answer
