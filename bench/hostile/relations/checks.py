"""Checks of one case: its questions in other words, and its commands against each other."""

import pathlib
import random
import tempfile

import agreement
import amounts
import commands
import contacts
import meshes
import mixed
import pieces
import positions
import sources
import table as tables
import wording
from questions import Asker

RELATIONS = [
    relation for module in (positions, amounts, wording, pieces, contacts, meshes, mixed)
    for relation in module.RELATIONS
]
#: Checks of one case: each further one saves the answer to the question in its own words.
CHECKS = 8


class Finding:
    """A disagreement, with the files of both questions."""

    def __init__(self, check, part, line, files):
        self.case, self.family, self.relation, self.command = check
        self.part, self.line, self.files = part, line, files

    @property
    def key(self):
        return self.relation, self.command, self.part, self.case

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        stem = "-".join((self.relation, self.command, self.case)).replace("/", "-").replace(" ", "_")
        for number, (suffix, text) in enumerate(self.files, 1):
            (folder / f"{stem}-{number}{suffix}").write_text(text, encoding="utf-8")


class Examined:
    """Checks of one case, with the answers that several of them need."""

    def __init__(self, kusabi, folder, case):
        self.asker, self.case = Asker(kusabi, folder), case
        self.asked = commands.Asked(self.asker, case)
        self.base, self.findings = {}, []
        #: By relation, command and case: "agree", "open: " with the reason, "different" or "unfit".
        self.outcomes = {}

    def _text(self, question, table, suffix=".toml", about=""):
        comment = "\\" if suffix == ".lp" else "*" if suffix == ".mps" else "#"
        words = " ".join([question.command, *question.words()]) if question else ""
        head = f"{comment} kusabi {words}\n" + (f"{comment} {about}\n" if about else "")
        return suffix, head + (tables.write(table) if isinstance(table, dict) else table.text())

    def _judge(self, check, compare, files):
        """Records the outcome of compare()."""
        case, _, relation, command = check
        try:
            compare()
            outcome = "agree"
        except agreement.Undecided as why:
            outcome = f"open: {str(why).split(':')[0]}"
        except agreement.Disagreement as found:
            outcome = "different"
            self.findings.append(Finding(check, found.part, found.line, files(found.line)))
        self.outcomes[relation, command, case] = outcome

    def in_other_words(self, relation, question):
        """False: the relation does not apply."""
        rng = random.Random(f"{self.case.name}/{question.name}/{relation.name}")
        try:
            changed = relation.apply(rng, self.case.table, question)
        except tables.Unfit:
            return False
        other = changed.question(question)
        suffix = getattr(self.case.table, "suffix", ".toml"), getattr(changed.table, "suffix", ".toml")

        def compare():
            if question not in self.base:
                self.base[question] = self.asker.ask(self.asker.write(self.case.table, "original"), question)
            if self.case.is_generated and self.base[question].code in agreement.REFUSED:
                raise agreement.Disagreement("refused", self.base[question].said)
            answer = self.asker.ask(self.asker.write(changed.table, "changed", changed.files), other)
            agreement.compare(question, self.base[question], answer, changed)

        def judged():
            try:
                compare()
            except agreement.RoundedAnew:
                if self.case.generic:
                    raise
                raise agreement.Undecided("special position, coordinates rounded anew") from None

        self._judge((self.case.name, self.case.family, relation.name, question.name), judged, lambda line: [
            self._text(question, self.case.table, suffix[0]),
            self._text(other, changed.table, suffix[1], line), *(
                (pathlib.Path(name).suffix, text) for name, text in changed.files.items())
        ])
        return True

    def between_commands(self, relation):
        if relation.command not in {question.command for question in self.case.questions}:
            return False
        rng = random.Random(f"{self.case.name}/{relation.name}")
        mu = next((question.mu for question in self.case.questions if question.mu), None)
        try:
            self._judge(
                (self.case.name, self.case.family, relation.name, relation.command),
                lambda: relation.check(self.asked, rng, self.case, mu),
                lambda line: [self._text(self.asked.last_question, self.asked.last_table, about=line)])
        except tables.Unfit:
            return False
        return True

    def pairs(self):
        """Every relation with every question of the case, as functions by their names."""
        for relation in RELATIONS:
            for question in self.case.questions:
                if question.command in relation.commands:
                    yield (relation.name,
                           question.name), lambda r=relation, q=question: self.in_other_words(r, q)
        if isinstance(self.case.table, dict):
            for relation in commands.RELATIONS:
                yield (relation.name, relation.command), lambda r=relation: self.between_commands(r)


def family_of(name):
    """The family of the case of this name; of a file the file itself."""
    return name if (sources.ROOT / name).is_file() else name.rsplit(" ", 1)[0]


def case_of(name):
    """The case of a name: a file of the project, or FAMILY SEED/NUMBER."""
    if (sources.ROOT / name).is_file():
        return sources.of_file(sources.ROOT / name)
    family, number = name.rsplit(" ", 1)
    seed, index = number.split("/")
    return sources.generated(family, int(seed), int(index))


def examine(kusabi, name, wanted=None, count=CHECKS):
    """(outcomes, findings) of some checks of a case; wanted: pairs of a relation and a command, otherwise at
    random."""
    with tempfile.TemporaryDirectory() as folder:
        case = case_of(name)
        examined = Examined(kusabi, folder, case)
        pairs = dict(examined.pairs())
        if wanted is not None:
            for pair in wanted:
                if pair not in pairs or not pairs[pair]():
                    examined.outcomes[(*pair, name)] = "unfit"
            return examined.outcomes, examined.findings
        order = random.Random(f"checks/{name}").sample(sorted(pairs), len(pairs))
        # One question of each relation comes first: relations of a single command are as frequent as others.
        first = list({pair[0]: pair for pair in order}.values())
        done = 0
        for pair in [*first, *(pair for pair in order if pair not in first)]:
            if done == count:
                break
            done += pairs[pair]()
        return examined.outcomes, examined.findings


def files_of_the_project():
    """Names of the problem files that relations change."""
    paths = sorted(
        [*(sources.ROOT / "examples").glob("*.toml"), *(sources.ROOT / "tests" / "cases").glob("*.toml")])
    return [path.relative_to(sources.ROOT).as_posix() for path in paths if sources.of_file(path) is not None]
