"""Relations of mixed zero-one programs, for `kusabi mip`: the programs of programs.py in other words."""

import copy
import dataclasses
import random

import exact_program
import programs
from questions import Question
from relation import Changed, Relation
from table import Unfit


@dataclasses.dataclass
class File:
    """A program and the format of its file, .mps or .lp. The interface of a table in problem files."""

    program: exact_program.Program
    suffix: str

    def text(self):
        return self.program.mps() if self.suffix == ".mps" else self.program.lp()


def generated(kind, seed, index):
    """(File, questions) of program number `index` of a kind."""
    program = programs.make(f"relations/{seed}", index, [kind])[1]
    form = random.Random(f"{kind}/{seed}/{index}").choice((".mps", ".lp"))
    return File(program, form), [Question("mip")]


def _changed(file, slope=1.0, shift=0.0):
    return Changed(file, original=[], slope=slope, shift=shift, sense=-1 if file.program.maximise else 1)


def _other_format(rng, file, question):
    file.suffix = ".lp" if file.suffix == ".mps" else ".mps"
    return _changed(file)


def _reordered(rng, file, question):
    """Rows and columns in another order."""
    program = file.program
    order = rng.sample(range(len(program.columns)), len(program.columns))
    at = {old: new for new, old in enumerate(order)}
    program.columns = [program.columns[old] for old in order]
    for row in program.rows:
        row.terms = dict(sorted((at[j], value) for j, value in row.terms.items()))
    program.rows = rng.sample(program.rows, len(program.rows))
    return _changed(file)


def _renamed(rng, file, question):
    for k, each in enumerate(rng.sample(file.program.columns, len(file.program.columns))):
        each.name = f"y_{k}#a"
    for k, each in enumerate(file.program.rows):
        each.name = f"ROW.{k}"
    return _changed(file)


def _rows_scaled(rng, file, question):
    for row in file.program.rows:
        by = 2.0**rng.randint(-8, 8)
        row.right *= by
        row.terms = {j: value * by for j, value in row.terms.items()}
        if row.range is not None:
            row.range *= by
    return _changed(file)


def _costs_scaled(rng, file, question):
    by = 2.0**rng.randint(-10, 10)
    for column in file.program.columns:
        column.cost *= by
    return _changed(file, slope=by)


def _opposite(rng, file, question):
    """The largest instead of the smallest value of the negative costs."""
    file.program.maximise = not file.program.maximise
    for column in file.program.columns:
        column.cost = -column.cost
    return _changed(file, slope=-1.0)


def _columns_scaled(rng, file, question):
    """Continuous columns in other units."""
    program = file.program
    for j, column in enumerate(program.columns):
        if column.binary:
            continue
        by = 2.0**rng.randint(-8, 8)
        column.cost *= by
        column.lower = None if column.lower is None else column.lower / by
        column.upper = None if column.upper is None else column.upper / by
        for row in program.rows:
            if j in row.terms:
                row.terms[j] *= by
    return _changed(file)


def _rows_repeated(rng, file, question):
    program = file.program
    for row in rng.sample(program.rows, min(2, len(program.rows))):
        again = copy.deepcopy(row)
        again.name = f"{row.name}again"
        program.rows.append(again)
    return _changed(file)


def _far_column(rng, file, question):
    """A further column of up to 1e12, without cost, in a row of its own."""
    far = file.program.column(0, 1e12)
    file.program.row("G", 1e12, {far: 1.0})
    return _changed(file)


def _rows_as_pairs(rng, file, question):
    """Each equation as two inequalities."""
    rows = []
    for row in file.program.rows:
        if row.sense != "E":
            rows.append(row)
            continue
        rows += [
            dataclasses.replace(row, name=row.name + sense, sense=sense, terms=dict(row.terms))
            for sense in "LG"
        ]
    if len(rows) == len(file.program.rows):
        raise Unfit("no equations")
    file.program.rows = rows
    return _changed(file)


def _shifted(rng, file, question):
    """A constant in the objective, as the cost of a column that is 1."""
    shift = float(rng.randint(-8, 8) or 1)
    file.program.column(1, 1, cost=shift)
    return _changed(file, shift=shift)


def _slacks(rng, file, question):
    """Each inequality as an equation with a column of its own."""
    rows = [row for row in file.program.rows if row.sense != "E" and row.range is None]
    if not rows:
        raise Unfit("no inequalities")
    for row in rows:
        row.terms[file.program.column()] = 1.0 if row.sense == "L" else -1.0
        row.sense = "E"
    return _changed(file)


RELATIONS = [
    Relation(name, ("mip", ), change)
    for name, change in (("other format", _other_format), ("rows and columns reordered", _reordered),
                         ("columns renamed", _renamed), ("rows scaled", _rows_scaled),
                         ("costs scaled", _costs_scaled), ("costs negated", _opposite),
                         ("columns scaled", _columns_scaled), ("rows repeated", _rows_repeated),
                         ("column at 1e12", _far_column), ("equations as pairs", _rows_as_pairs),
                         ("objective shifted", _shifted), ("inequalities with slacks", _slacks))
]
