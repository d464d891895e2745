"""Questions to the command, and answers in a form that relations can compare: candidates by their number
instead of their names, intervals as pairs of numbers, bounds with their standing.

`ask` calls the command once. An answer whose exit code is 3 is open; its proved parts are kept.
"""

import dataclasses
import json
import math
import os
import pathlib
import subprocess

import table as tables

#: Variables of the calls beside the caller's: no file of default options.
ENVIRONMENT = {"KUSABI_CONFIG": ""}
#: Longest time of one call in seconds; a call that takes longer is counted as open.
SECONDS = 60


@dataclasses.dataclass(frozen=True)
class Question:
    """A call without its file. Numbers are None if the option is not given."""

    command: str
    mu: float | None = None
    alpha: float | None = None
    group_alpha: tuple = ()  # pairs of a name and a number
    total: float | None = None
    lose: int | None = None
    keep: tuple = ()
    case: str | None = None
    more: tuple = ()  # further words

    def words(self):
        own = [*self.more]
        for option, value in (("--mu", self.mu), ("--alpha", self.alpha), ("--total", self.total),
                              ("--lose", self.lose)):
            if value is not None:
                own += [option, repr(value)]
        if self.group_alpha:
            own += ["--group-alpha", ",".join(f"{name}={value!r}" for name, value in self.group_alpha)]
        if self.keep:
            own += ["--keep", " ".join(self.keep)]
        if self.case is not None:
            own += ["--case", self.case]
        return own

    @property
    def name(self):
        """The command and the options that determine the kind of its answer, without numbers."""
        words = [self.command, *(word for word in self.more if word.startswith("--"))]
        words += [
            f"--{option}" for option in ("mu", "total", "lose", "keep")
            if getattr(self, option) not in (None, ())
        ]
        return " ".join(words + (["--alpha"] if self.alpha is not None or self.group_alpha else []))


@dataclasses.dataclass
class Answer:
    """code: exit code, None after SECONDS; said: last line of the output; result: `result` of the JSON, or
    None; names: candidates in the order of the file; text: all that was printed."""

    code: int | None
    said: str
    result: dict | None = None
    names: list = dataclasses.field(default_factory=list)
    text: str = ""

    @property
    def is_open(self):
        return self.code in (None, 3)


class Asker:
    """The command, in a folder of its own."""

    def __init__(self, kusabi, folder):
        self.kusabi, self.folder = str(pathlib.Path(kusabi).resolve()), pathlib.Path(folder)
        self.calls = 0

    def run(self, *words, seconds=SECONDS):
        """(exit code, output); None: no answer in time"""
        self.calls += 1
        try:
            done = subprocess.run([self.kusabi, *map(str, words)], capture_output=True, encoding="utf-8",
                                  errors="replace", timeout=seconds, cwd=self.folder,
                                  env={**os.environ, **ENVIRONMENT})
        except subprocess.TimeoutExpired:
            return None, "no answer in time"
        return done.returncode, done.stdout + done.stderr

    def write(self, table, name, files=None):
        """Writes a problem file, or a program in its own format, and further files beside it."""
        is_table = isinstance(table, dict)
        path = self.folder / (name + (".toml" if is_table else table.suffix))
        path.write_text(tables.write(table) if is_table else table.text(), encoding="utf-8")
        for other, text in (files or {}).items():
            (self.folder / other).write_text(text, encoding="utf-8")
        return path

    def ask(self, path, question, *more):
        output = self.folder / "result.json"
        output.unlink(missing_ok=True)
        code, text = self.run(question.command, path, *question.words(), "--serial", "--output", output,
                              *more)
        lines = [line for line in text.strip().splitlines() if not line.startswith("wrote ")]
        answer = Answer(code, lines[-1] if lines else "", text=text)
        if output.exists():
            whole = json.loads(output.read_text(encoding="utf-8"))
            answer.result = whole["result"]
            answer.names = [each["node"] for each in whole.get("problem", {}).get("contact", ())]
        return answer


# Contents of answers
# -------------------------------------------------------------------------------------------


def cones(answer, original):
    """{(numbers in contact, numbers separated): (state, margin)} of `patterns`, by the candidate of the
    original structure that each candidate stands for; parts of added candidates are left out."""
    at = {name: original[number] for number, name in enumerate(answer.names)}
    found = {}
    for pattern in answer.result["patterns"]:
        sets = [frozenset(at[name] for name in pattern[key]) for key in ("contact", "separated")]
        if None not in sets[0] | sets[1]:
            found[tuple(sets)] = pattern["state"], pattern.get("margin")
    return found


def ray_cones(answer, original):
    """The same of `rays`, as a set."""
    at = {name: original[number] for number, name in enumerate(answer.names)}
    known = lambda names: frozenset(at[name] for name in names if at[name] is not None)
    return {(known(set(cone["contact"]) - set(cone.get("idle", ()))), known(cone["separated"]))
            for cone in answer.result["cones"]}


@dataclasses.dataclass(frozen=True)
class Bracket:
    """A number between two bounds with their standing; None: unbounded, or not known."""

    low: float | None
    high: float | None
    low_proved: bool = True
    high_proved: bool = True

    def changed(self, factor, shift=0.0):
        """The bracket of factor * number + shift."""
        ends = [None if end is None else factor * end + shift for end in (self.low, self.high)]
        if factor >= 0:
            return Bracket(*ends, self.low_proved, self.high_proved)
        return Bracket(ends[1], ends[0], self.high_proved, self.low_proved)


def bound(entry, end, otherwise=None):
    """The value of an end of a bracket."""
    return entry[end]["value"] if entry[end] else otherwise


def bracket(entry):
    low, high = entry["lower"], entry["upper"]
    return Bracket(low and low["value"], high and high["value"],
                   bool(low) and low["standing"] == "proved", bool(high) and high["standing"] == "proved")


def coefficient(result):
    """Bracket of the critical coefficient: nothing sticks without friction."""
    found = bracket(result["critical_friction"])
    return found if found.low is not None else dataclasses.replace(found, low=0.0, low_proved=True)


def held(answer):
    """Intervals (low, high) of `hold --mu`, infinite without an end."""
    if answer.result["reason"] in ("supports", "wedging"):
        return [(-math.inf, math.inf)]
    return [(bound(each["below"], "upper", -math.inf), bound(each["above"], "lower", math.inf))
            for each in answer.result["intervals"]]


def sums(grip):
    """The least and the largest sum of normal reactions of a known state; None: not known, or there is none."""
    return bound(grip["minimum"], "upper"), bound(grip["maximum"], "lower")


def guaranteed(result):
    """The factors that `limit` finds carried under every admissible load, in all load cases: brackets of both ends, and
    whether there are none, None: undecided; None without half-widths."""
    if not isinstance(result.get("uncertain"), dict):
        return None
    lower, upper = result["minimum"], result["maximum"]
    above, below, low, high = (bound(*each) for each in ((lower, "lower", -math.inf), (upper, "upper", math.inf),
                                                         (lower, "upper", math.inf), (upper, "lower", -math.inf)))
    empty = True if result["carried_at_none"] or above > below else False if low <= high else None
    return {"lower": lower, "upper": upper, "empty": empty}


def is_proved(answer):
    """True if no number of the answer is merely computed."""
    return '"computed"' not in json.dumps(answer.result)
