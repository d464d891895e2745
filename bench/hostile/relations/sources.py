"""Structures of which questions are asked in other words, with their questions.

Random ones of the generators in this folder and the folder around it; the examples; structures of
tests/cases. A case is named by its family and number, `wedge 1/12` for seed 1, or by its file. """

import dataclasses
import itertools
import pathlib
import random

import bodies
import generate
import generate_bodies
import girders
import hold
import mixed
import programs
import table as tables
import trusses
from questions import Question
from structure import Mechanism

ROOT = pathlib.Path(__file__).resolve().parents[3]
#: Ratios of stiffness: larger ones are for the oracle, where an answer may be open.
CONTRASTS = [1.0, 1e2]
#: Families of the wedged problem, without those that may be open.
WEDGED = [*generate.KINDS, *(kind for kind in generate_bodies.KINDS if kind not in ("lever", "coupling"))]
#: Families with random directions only.
SPECIAL = ("post", "pieces", "grid", "rods", "wedge")
GENERIC = [kind for kind in {*WEDGED, *hold.SPACE_KINDS} if kind.removeprefix("space-") not in SPECIAL]
#: Families of bodies with loads at any nodes, and at candidates.
LOADED = [f"loaded {kind}" for kind in (*hold.KINDS, *hold.SPACE_KINDS)]
LOADED += [f"pressed {kind}" for kind in hold.KINDS]
LIMIT = ["truss", *girders.KINDS]
MIXED = list(programs.KINDS)
#: Families in turn, as many of each command.
FAMILIES = [
    family for turn in zip(WEDGED, LOADED + LOADED, LIMIT * len(WEDGED), MIXED * len(WEDGED))
    for family in turn
]

#: Friction coefficients for files, where 1 is not interesting.
COEFFICIENTS = {
    "block_below_ceiling": 0.4,
    "computed_equilibrium": 0.5,
    "end_at_zero": 0.3,
    "grip_of_a_pair": 0.7,
    "guided_block": 0.4,
    "held_at_one_factor": 0.5,
    "ladder": 0.3,
    "light_beside_heavy_load": 0.5,
    "pattern_below_its_corner": 1.7,
    "peg-under-load": 0.3,
    "post_on_floor": 0.5,
    "wedge_margins": 2.12536,
    "wedge-in-groove": 0.5,
    "false_lower_101": 1.13815,
    "undecided_contrast6_493": 0.7261972342575947,
}
#: Files whose stiffnesses differ by so much that only bars along the axes can be computed with.
LEFT_OUT = ("big_int", )


@dataclasses.dataclass
class Case:
    """table: a flat table, or a mixed.File; questions: what is asked of it"""

    name: str
    family: str
    table: object
    questions: list

    @property
    def is_generated(self):
        return self.family != self.name

    @property
    def generic(self):
        """False if coordinates may be chosen such that forces are on one line, or patterns at a limit."""
        return self.family.removeprefix("loaded ") in GENERIC


def _wedged_questions(table, mu):
    asked = [
        Question("patterns", mu=mu),
        Question("critical"),
        Question("sweep", more=("--mu", ",".join(map(repr, sorted({0.5 * mu, mu, 1.5 * mu})))))
    ]
    return asked + ([Question("rays", mu=mu)] if tables.is_plane(table) else [])


def _loaded_questions(table, mu):
    kinds = {entry["kind"] for entry in tables.entries(table, "loads")}
    cases = [entry["case"] for entry in tables.entries(table, "loads") if "case" in entry]
    of_case = (
        lambda question: dataclasses.replace(question, case=cases[0])) if cases else lambda question: question
    asked = []
    if "dead" in kinds or "gravity" in table or "temperature" in table:
        asked.append(Question("hold"))
    if "reference" in kinds:
        asked += [Question("hold", mu=mu), Question("hold", mu=mu, more=("--grip", ))]
    return [of_case(question) for question in asked]


def _limit_questions(rng, table, alpha, group_alpha=()):
    asked = [Question("limit", alpha=alpha, group_alpha=group_alpha)
             ] if alpha is not None or group_alpha else []
    given = ["alpha" in entry for entry in tables.entries(table, "uncertainty")]
    given += [
        True for entry in tables.force_lists(table) for part in entry["force"] if isinstance(part, list)
    ]
    if not any(given) or all(given):
        asked += [Question("limit"), Question("limit", lose=1)]
    if question_of_loss := next((each for each in asked if each.lose), None):
        supported = tables.supported_axes(table)
        if free := [node for node in table["nodes"] if node not in supported]:
            asked.append(dataclasses.replace(question_of_loss, keep=(rng.choice(free), ), more=()))
    return asked


def _pressed(rng, table):
    """Loads at candidates, along their normals: the contact takes the dead load by itself, so that ends of
    intervals are exactly zero."""
    entry = rng.choice(table["contact"])
    node = rng.choice(entry["nodes"])
    amount = rng.choice((1.0, 0.5, 2.0))
    table["loads"] = [{"kind": "dead", "nodes": [node], "force": [-amount * x for x in entry["normal"]]}, {
        "kind": "reference", "nodes": [rng.choice(list(table["nodes"]))],
        "force": [rng.choice((0.0, -1.0, 1.0, 0.5)) for _ in range(table["dimension"] - 1)] + [-1.0]
    }]


def _bodies(seed, index, kind):
    """A case of generate_bodies, the first of several that is no mechanism: those are refused."""
    for draw in itertools.count():
        case = generate_bodies.make("/".join(["relations", str(seed), *["again"] * draw]), index, [kind],
                                    CONTRASTS)
        try:
            bodies.compliance(bodies.Bodies(case.text))
            return case
        except Mechanism:
            continue


def generated(family, seed, index):
    """Case number `index` of a family, the same on any machine."""
    name = f"{family} {seed}/{index}"
    rng = random.Random(f"relations/{name}")
    if family == "truss":
        text, _, _, words = trusses.make(f"relations/{seed}", index)
        table = tables.read(text)
        options = dict(zip(words[::2], words[1::2]))
        groups = tuple(
            (name, float(value)) for name, value in (pair.rsplit("=", 1)
                                                     for pair in options.get("--group-alpha", "").split(",")
                                                     if pair))
        alpha = float(options["--alpha"]) if "--alpha" in options else None
        return Case(name, family, tables.flat(table), _limit_questions(rng, table, alpha, groups))
    if family in girders.KINDS:
        table = girders.KINDS[family](rng)
        return Case(name, family, table, _limit_questions(rng, table, rng.choice((0.25, 0.5, 1.0))))
    if family in MIXED:
        return Case(name, family, *mixed.generated(family, seed, index))
    kind = family.removeprefix("loaded ").removeprefix("pressed ")
    if kind in (*generate_bodies.KINDS, *hold.KINDS, *hold.SPACE_KINDS):
        case = _bodies(seed, index, kind)
    else:
        case = generate.make(f"relations/{seed}", index, [kind], CONTRASTS)
    mu = float(f"{case.mu:.3g}")
    if family == kind:
        table = tables.flat(tables.read(case.text))
        return Case(name, family, table, _wedged_questions(table, mu))
    if family.startswith("pressed"):
        table = tables.flat(tables.read(case.text))
        _pressed(rng, table)
    else:
        table = tables.flat(tables.read(hold.with_loads(case, rng)[0]))
    return Case(name, family, table, _loaded_questions(table, mu))


def of_file(path):
    """Case of a problem file with the questions that it has the data for, or None if it refers to other
    files."""
    if path.stem in LEFT_OUT:
        return None
    table = tables.read(path.read_text(encoding="utf-8"))
    name = path.relative_to(ROOT).as_posix()
    try:
        table = tables.flat(table)
    except tables.Unfit:
        return None
    if len(tables.candidates(table)) > 12:
        return None
    mu = COEFFICIENTS.get(path.stem, 1.0)
    alpha = 0.5 if any("alpha" not in entry for entry in tables.entries(table, "uncertainty")) else None
    rng = random.Random(f"relations/{name}")
    asked = []
    if table.get("contact"):
        asked += _wedged_questions(table, mu)
        if "loads" in table or "gravity" in table:
            asked += _loaded_questions(table, mu)
    elif any("yield" in entry or "fy" in entry for entry in tables.entries(table, "members")):
        asked += _limit_questions(rng, table, alpha)
    return Case(name, name, table, asked) if asked else None
