"""A relation: a change of the problem file of which the change of every answer is known."""

import copy
import dataclasses
from collections.abc import Callable

import table as tables
from questions import Question

WEDGED = ("patterns", "critical", "rays", "sweep")
FRICTION = (*WEDGED, "hold")
ALL = (*FRICTION, "limit")


@dataclasses.dataclass
class Changed:
    """The changed structure, and the answer that is expected of it.

    original: for each candidate the number of that of the original structure, None for an added one; missing:
    the same candidates in the same order. exact: the structure is the same but for rounding in the command;
    otherwise error is the relative rounding of the coordinates. Friction coefficients are multiplied by mu,
    forces of the call and of the answer by force, half-widths of the call by alpha; a load factor f becomes
    slope f + shift. copies: number of copies of the structure in the file. group, node, case: new names by
    old ones, for the options of the call. files: further files by name. sense: of a mixed program, 1 if the
    changed one is minimised, -1 if it is maximised. """

    table: dict
    exact: bool = True
    error: float = 0.0
    original: list | None = None
    mu: float = 1.0
    force: float = 1.0
    alpha: float = 1.0
    slope: float = 1.0
    shift: float = 0.0
    copies: int = 1
    group: dict = dataclasses.field(default_factory=dict)
    node: dict = dataclasses.field(default_factory=dict)
    case: dict = dataclasses.field(default_factory=dict)
    files: dict = dataclasses.field(default_factory=dict)
    sense: int = 1

    def __post_init__(self):
        if self.original is None:
            self.original = list(range(len(tables.candidates(self.table))))

    def factor(self, value):
        return self.slope * value + self.shift

    def question(self, asked):
        """The question in the words of the changed file."""
        times = lambda value, by: None if value is None else value * by
        mu = times(asked.mu, self.mu)
        more = tuple(",".join(repr(float(each) * self.mu)
                              for each in word.split(",")) if before == "--mu" else word
                     for before, word in zip(("", *asked.more), asked.more))
        return dataclasses.replace(
            asked, mu=mu, more=more, alpha=times(asked.alpha, self.alpha),
            total=times(asked.total, self.force), group_alpha=tuple(
                (self.group.get(name, name), value) for name, value in asked.group_alpha),
            keep=tuple(self.node.get(name, name)
                       for name in asked.keep), case=self.case.get(asked.case, asked.case))


def every_component(table, question):
    """True if all free components without a load are uncertain: further nodes and loads then change the
    question."""
    return question.command == "limit" and question.alpha is not None and "uncertainty" not in table


@dataclasses.dataclass(frozen=True)
class Relation:
    """name; commands to which it applies; change(rng, table, question) of a copy of the table, which returns
    a Changed and raises tables.Unfit if the relation does not apply."""

    name: str
    commands: tuple
    change: Callable

    def apply(self, rng, table, question: Question):
        if question.command not in self.commands:
            raise tables.Unfit("another command")
        return self.change(rng, copy.deepcopy(table), question)
