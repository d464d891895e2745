"""Certificates of random structures of every kind, by both checkers.

    python3 bench/hostile/certificates.py --kusabi build/kusabi --count 300 --seed 1 --found refused/

Structures are those of relations/: bodies with and without supports, pairs, nodes with several normals, meshes and
elements, in the plane and in space, with loads and clearances, and trusses; here also with a temperature, a second body
beside them, two load cases, struts, losses. `kusabi verify --problem` must prove all that a command says is proved, and
refuse no line of the rest. Without the problem file, `kusabi verify` and verify/second_checker.py must have the same
exit code and the same sentence, as in verdicts.py. K, the loads and the rigid-body modes are recorded as doubles, so
that statements close to their limits, or with exact zeros, may be refused then; these are counted. Prints each
certificate for which one of these fails, and keeps its files. Exit code 0: none.
"""
import argparse
import copy
import dataclasses
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(FOLDER / "relations"))
import questions  # noqa: E402
import sources  # noqa: E402
import table as tables  # noqa: E402
import verdicts  # noqa: E402
from questions import Question  # noqa: E402

#: Kinds of structures: wedged, loaded and limit ones in turn.
FAMILIES = [family for turn in zip(sources.WEDGED, 2 * sources.LOADED, sources.LIMIT * len(sources.WEDGED)) for family in turn]
#: Longest times in seconds, and most candidates for the second checker.
SECONDS, MOST = 120, 12


def _expanding(rng, table):
    """A rise of the temperature; gravity on some."""
    table["temperature"] = rng.choice((1.0, -1.0, 0.25))
    for entry in tables.entries(table, "members", "elements"):
        if rng.random() < 0.7:
            entry["expansion"] = rng.choice((0.01, 0.002))


def _beside(rng, table, family, seed, index):
    """A second structure of the family beside the first one: further blocks."""
    other = copy.deepcopy(sources.generated(family, f"{seed}/beside", index).table)
    if len(tables.candidates(table)) + len(tables.candidates(other)) > MOST:
        return
    tables.rename(other, lambda name: f"{name}'")
    table["nodes"] |= {name: [place[0] + 64.0, *place[1:]] for name, place in other["nodes"].items()}
    for section, values in other.items():
        if isinstance(values, list) and section in (*tables.WITH_NODES, "members", "elements"):
            table[section] = table.get(section, []) + values


def _in_cases(rng, table):
    """Each dead load in one of two load cases, or in both."""
    for entry in tables.entries(table, "loads"):
        if entry["kind"] == "dead" and (case := rng.choice((None, "one", "two"))):
            entry["case"] = case
    return sorted({entry["case"] for entry in table["loads"] if "case" in entry})


def _struts(rng, table):
    for entry in table["members"]:
        strength = entry.get("yield")
        if isinstance(strength, (int, float)):
            strength = entry["yield"] = {"tension": strength, "compression": strength}
        if strength and rng.random() < 0.5:
            strength["residual"] = rng.choice((0.3, 0.5, 1.0))


def _certain_case(table, asked):
    """One load case without uncertain loads; the questions that remain."""
    entries = [entry for entry in table["uncertainty"] if entry.get("case") != "two"]
    names = [entry["name"] for entry in entries]
    if len(entries) < len(table["uncertainty"]) and entries:
        table["uncertainty"] = entries
        return [dataclasses.replace(question, group_alpha=tuple(pair for pair in question.group_alpha if pair[0] in names)) for question in asked]
    return asked


def case_of(seed, index):
    """(family, table, questions)"""
    family = FAMILIES[index % len(FAMILIES)]
    rng = random.Random(f"certificates/{seed}/{index}")
    case = sources.generated(family, f"certificates/{seed}", index)
    table, asked = case.table, [question for question in case.questions if question.command not in ("sweep", "rays")]
    if "contact" in table:
        if rng.random() < 0.3:
            _beside(rng, table, family, seed, index)
        mu = next(question.mu for question in asked if question.mu is not None) if any(question.mu for question in asked) else 0.5
        if family.startswith(("loaded", "pressed")):
            if rng.random() < 0.3:
                _expanding(rng, table)
            cases = _in_cases(rng, table) if rng.random() < 0.2 else []
            asked = [Question(question.command, question.mu, case=cases[0] if cases else None, more=question.more) for question in asked]
        else:
            asked += [Question("critical", more=("--cuts", "always"))] * (rng.random() < 0.3)
            asked += [Question("patterns", mu=float(f"{mu * rng.uniform(0.5, 2):.3g}"))] * (rng.random() < 0.3)
    else:
        if rng.random() < 0.3:
            _struts(rng, table)
        if rng.random() < 0.3:
            asked = _certain_case(table, asked)
        least = next((question for question in asked if question.lose), None)
        if least:
            asked += [Question("limit", lose=1, alpha=asked[0].alpha, group_alpha=asked[0].group_alpha)] * (asked[0].alpha is not None or asked[0].group_alpha != ())
            asked += [Question("limit", lose=1, more=("--sudden", rng.choice(("2", "1.3"))))]
            asked += [Question("limit", lose=2)] * (sum(len(entry["between"]) for entry in table["members"]) < 20)
    return family, table, asked


class Campaign:
    def __init__(self, asked, folder):
        self.asker, self.found, self.seed, self.calls = questions.Asker(asked.kusabi, folder), asked.found, asked.seed, asked.calls
        self.folder, self.counts, self.failures = pathlib.Path(folder), Counter(), 0

    def fail(self, index, family, question, path, what):
        self.failures += 1
        self.found.mkdir(parents=True, exist_ok=True)
        name = f"{self.found}/{self.seed}-{index:05d}-{self.failures}"
        shutil.copy(self.folder / "problem.toml", name + ".toml")
        if path and path.exists():
            shutil.copy(path, f"{name}{path.suffix}.cert")
        print(f"{name} ({family}: {question.command} {' '.join(question.words())}): {what}", flush=True)

    def examine(self, index):
        family, table, asked = case_of(self.seed, index)
        file, loaded, total = self.asker.write(table, "problem"), family.startswith(("loaded", "pressed")), None
        self.counts["structures"] += 1
        for question in random.Random(f"calls/{self.seed}/{index}").sample(asked, min(self.calls, len(asked))):
            result = self.call(index, family, file, question, len(tables.candidates(table)))
            grip = (result or {}).get("grip")
            total = questions.sums(grip) if grip else total
        if loaded and total:
            rng = random.Random(f"total/{self.seed}/{index}")
            low, high = (1.0 if end is None else end for end in total)
            clamped = float(f"{rng.uniform(low, high + 0.1):.4g}")
            if clamped > 0:
                self.call(index, family, file, Question("hold", asked[-1].mu, total=clamped, case=asked[-1].case), len(tables.candidates(table)))

    def call(self, index, family, file, question, candidates):
        """The result of a call whose certificates are checked."""
        for old in self.folder.glob("cert*"):
            old.unlink()
        answer = self.asker.ask(file, question, "--certificate", "cert")
        self.counts[f"{question.name.removesuffix(' --alpha')}: {'refused by the command' if answer.code == 2 else 'in time' if answer.code is not None else 'too slow'}"] += 1
        if answer.code not in (0, 3):
            if answer.code not in (None, 2):
                self.fail(index, family, question, None, f"exit code {answer.code}: {answer.said}")
            return None
        proved, written = answer.code == 0 and questions.is_proved(answer), sorted(path for path in self.folder.glob("cert*") if path.suffix != ".tmp")
        if not written and proved and "ertificate" not in answer.text:
            self.fail(index, family, question, None, f"no certificate: {answer.said}")
        for path in written:
            self.check(index, family, question, path, proved, candidates)
        return answer.result

    def check(self, index, family, question, path, proved, candidates):
        good = (0,) if proved else (0, 3)
        modes = " with modes" * bool(re.search(r"(?m)^motions [1-9]", path.read_text()))
        self.counts["certificates"] += 1
        of_file, with_file = self.asker.run("verify", path.name, "--serial", "--problem", "problem.toml", seconds=SECONDS)
        if of_file is None:
            self.counts["verify too slow"] += 1
        elif of_file not in good:
            self.counts["refused by verify --problem"] += 1
            self.fail(index, family, question, path, f"verify --problem: exit code {of_file}: {with_file.strip()[-600:]}")
        code, said = self.asker.run("verify", path.name, "--serial", seconds=SECONDS)
        own, says = (None, "too large") if candidates > MOST or family == "dome" else verdicts.of_second_checker(path, SECONDS)
        if code is None or own is None:
            self.counts[f"second checker: {says or 'too slow'}"] += 1
            if code not in (*good, None) and not modes:
                self.fail(index, family, question, path, f"verify: exit code {code}: {said.strip()[-600:]}")
            return
        first, second = (verdicts.conclusion(text) for text in (said, says))
        same = code == own and not verdicts.differ(first, second)
        if same and code in good:
            self.counts["the same by both"] += 1
        elif same:
            self.counts[f"without the problem file refused by both{modes}"] += 1
        elif modes and 0 in (code, own):
            self.counts[f"without the problem file refused by {'verify' if code else 'the second checker'} only{modes}"] += 1
        else:
            self.counts["other words"] += 1
            self.fail(index, family, question, path, f"verify: {code} {first or said[-300:]}\n    second checker: {own} {second or says[-300:]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kusabi", default="build/kusabi", help="the command under test")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0, help="number of the first structure")
    parser.add_argument("--count", type=int, default=300, help="number of structures")
    parser.add_argument("--calls", type=int, default=10, help="most calls of each structure, chosen at random")
    parser.add_argument("--found", type=pathlib.Path, default=pathlib.Path("refused"), help="folder for the files of failures")
    asked = parser.parse_args()
    asked.found = asked.found.resolve()
    with tempfile.TemporaryDirectory() as folder:
        campaign = Campaign(asked, folder)
        try:
            for index in range(asked.first, asked.first + asked.count):
                campaign.examine(index)
        except KeyboardInterrupt:
            print(f"ended at structure {index}")
    print(f"{campaign.failures} failures: " + ", ".join(f"{n} {key}" for key, n in sorted(campaign.counts.items())))
    sys.exit(1 if campaign.failures else 0)


if __name__ == "__main__":
    main()
