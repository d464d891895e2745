"""The committed table of counts, bench/guard/table.json, and its comparison with a new measurement.

Each row of the table is one line: `amounts` (instructions and bytes), `counts` (nodes, programs, iterations
and other work that the result file reports), and the `reason` of its last renewal. `facts` are the
properties of the build and of the machine on which instructions and allocated bytes depend.
"""

import dataclasses
import json
import pathlib

PATH = pathlib.Path(__file__).resolve().parent / "table.json"

#: Largest relative change of an amount that passes. Two runs of one binary differ by less than 1 %, as the
#: engine looks at the clock. Less fails too: a gain that no row keeps could be lost again unseen.
TOLERANCE = 0.05
#: Amounts that depend on compiler, libraries and processor; the sizes of files do not.
OF_MACHINE = ("instructions", "allocated", "heap_peak")


@dataclasses.dataclass
class Measurement:
    """Figures of a run of a row. `amounts` and `counts` map names to integers; `answer` is compared with the
    row's right answer, `seconds` of CPU time are reported only."""

    answer: str
    amounts: dict
    counts: dict
    seconds: float = 0.0


@dataclasses.dataclass
class Table:
    facts: dict
    rows: dict

    @staticmethod
    def read(path=PATH):
        if not path.exists():
            return Table({}, {})
        content = json.loads(path.read_text())
        return Table(content["facts"], content["rows"])

    def write(self, path=PATH):
        """One line for each row, so that a commit shows which rows it renews."""
        lines = [f"    {json.dumps(name)}: {json.dumps(row)}" for name, row in sorted(self.rows.items())]
        rows = ",\n".join(lines)
        facts = json.dumps(self.facts, sort_keys=True)
        path.write_text(f'{{\n  "facts": {facts},\n  "rows": {{\n{rows}\n  }}\n}}\n')

    def renew(self, name, measurement, reason):
        self.rows[name] = {"amounts": measurement.amounts, "counts": measurement.counts, "reason": reason}

    def amount(self, name, key):
        """0 if the table does not have it."""
        return self.rows[name]["amounts"].get(key, 0) if name in self.rows else 0

    def other_facts(self, facts):
        """The first fact that differs from those of the table, in words; empty if none does."""
        for key, value in facts.items():
            if self.facts.get(key) != value:
                return f"{key} is {value}, but {self.facts.get(key, 'unknown')} in the table"
        return ""


def change(before, after):
    """The relative change in words."""
    return f"{100 * (after - before) / before:+.1f} %" if before else "new"


def wrong_answer(row, measurement):
    return f"{row.name}: the answer is \"{measurement.answer}\", expected \"{row.right_answer}\""


def failures(row, table, measurement, same_machine):
    """Sentences about all that fails in a row.
    @param same_machine whether amounts of OF_MACHINE are judged"""
    found = []
    if measurement.answer != row.right_answer:
        found.append(wrong_answer(row, measurement))
    if row.name not in table.rows:
        return [*found, f"{row.name}: not in the table"]
    counts, amounts = table.rows[row.name]["counts"], table.rows[row.name]["amounts"]
    for name in {**counts, **measurement.counts}:
        before, after = counts.get(name, 0), measurement.counts.get(name, 0)
        if before != after:
            found.append(f"{row.name}: {name} {before:,} before, {after:,} now")
    for name in {**amounts, **measurement.amounts}:
        if name not in measurement.amounts:
            found.append(f"{row.name}: {name} {amounts[name]:,} before, none now")
        elif name not in amounts:
            found.append(f"{row.name}: {name} none before, {measurement.amounts[name]:,} now")
        elif same_machine or name not in OF_MACHINE:
            before, after = amounts[name], measurement.amounts[name]
            if abs(after - before) > TOLERANCE * before:
                found.append(f"{row.name}: {name} {before:,} before, {after:,} now "
                             f"({change(before, after)}; at most {100 * TOLERANCE:.0f} % more or less)")
    return found
