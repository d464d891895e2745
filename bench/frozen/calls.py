"""Calls of all subcommands whose outputs are frozen, and those left out with their reasons.

calls.txt lists most of them, wrong-calls.txt those that are refused. No search ends by its time.
"""

import json

from running import SOURCES, Call, Step

#: Subcommands and options that have no call, and why.
LEFT_OUT = {
    "--version": "names the compiler, the libraries and the commit",
    "bench uts": "prints a speed; its numbers of nodes are compared with the published ones by tests/engine",
    "--time-limit, --pattern-limit": "the node at which a search ends depends on the speed of the machine",
    "numbers and sizes of runs with --node-limit": "likewise, since a search may open one node more",
    "--trace, --record": "files of times",
    "--resume": "state files are binary and of one version; tests/run/resume_test.py compares the results",
    "several ranks": "other `statistics`, lines about ranks, and order of the nodes in certificates",
    "tests/bad-input, bad-meshes, bad-matrices, bad-programs": "their whole messages are tests already",
}
#: Problem files of tests/cases that no call reads, and why.
LEFT_OUT_CASES = {"c_lc6_o2.toml": "233 candidates: minutes", "w3_14.toml": "450 candidates: minutes"}

GROUPS = ("example", "export", "bench")
SUBCOMMANDS = ("patterns", "rays", "critical", "sweep", "hold", "limit", "mip", "verify", "show", "draw",
               "report", "example space-truss", "example plane-truss", "example grid", "import", "export mps",
               "export cbf", "export matrix", "bench scaling", "bench schedules", "bench uts")


def _lines(name):
    """Lines of a list of calls."""
    text = (SOURCES / "bench/frozen" / name).read_text(encoding="utf-8")
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def _of_steps(name, steps, quick=True, files=()):
    """@param steps pairs of a label and a call in one line"""
    return Call(name, tuple(Step(label, tuple(text.split())) for label, text in steps), quick, files)


def _analysis(letters, text):
    """An analysis with its outputs, and what reads these. @param letters see calls.txt"""
    words = text.split()
    command, problem = words[:2]
    bounds = {"p": ("",), "P": (".lower", ".upper")}
    first = [*words, "--output", "result.json"]
    for letter, more in (("c", "--csv table.csv"), ("v", "--vtu vtu"), ("p", "--certificate certificate"),
                         ("P", "--certificate certificate")):
        first += more.split() if letter in letters else []
    steps = [Step("run", tuple(first))]
    for letter, label, reading in (("r", "report", "report result.json --output report.html"),
                                   ("a", "draw", "draw result.json --output picture-all.svg"),
                                   ("1", "draw 1", "draw result.json --pattern 1 --output picture-1.svg"),
                                   ("2", "draw 2", "draw result.json --pattern 2 --output picture-2.svg")):
        if letter in letters:
            steps.append(Step(label, tuple(reading.split()), "result.json"))
    for bound in (bound for letter in letters for bound in bounds.get(letter, ())):
        certificate = f"certificate{bound}"
        steps.append(Step(f"verify{bound}", ("verify", certificate, "--problem", problem), certificate))
    name = " ".join([command, problem.split("/", 1)[1].rsplit(".", 1)[0], *words[2:]])
    return Call(name, tuple(steps), "q" in letters, stopped="s" in letters, sensitive="d" in letters)


def _listed():
    """Calls of calls.txt."""
    for line in _lines("calls.txt"):
        letters, text = line.split(maxsplit=1)
        yield _of_steps(text, [("run", text)], "q" in letters) if "o" in letters else _analysis(letters, text)


def _other_outputs():
    """Lists in lines, results on standard output, defaults from a file."""
    yield _of_steps("rays plane-truss, list in lines", [
        ("run", "rays examples/plane-truss.toml --mu 0.65 --format jsonl --output result.jsonl"),
        ("report", "report result.jsonl --output report.html"),
        ("draw", "draw result.jsonl --output picture.svg")])
    yield _of_steps("patterns space-truss, list in lines", [
        ("run", "patterns examples/space-truss.toml --mu 0.65 --format jsonl --output result.jsonl"),
        ("report", "report result.jsonl --output report.html"),
        ("draw", "draw result.jsonl --output picture.svg")], quick=False)
    yield _of_steps("patterns two-bars, printed outputs", [
        ("run", "patterns examples/two-bars.toml --mu 2 --output -"),
        ("csv", "patterns examples/two-bars.toml --mu 2 --csv - --quiet"),
        ("defaults", "patterns examples/two-bars.toml --config defaults.toml --output result.json"),
    ], files=(("defaults.toml", '[patterns]\nmu = 2\nsort = "margin"\n'),))


def _cases():
    """Cases with known answers (tests/cases/truth.json), as asked there."""
    truth = json.loads((SOURCES / "tests/cases/truth.json").read_text())["cases"]
    for entry in truth:
        command, *more = entry["command"]
        file = f"tests/cases/{entry['file']}"
        if command == "verify":
            options = " ".join(more).replace("../../", "")
            yield _of_steps(f"verify {entry['file']}", [("run", f"verify {file} {options}")])
        else:
            yield _analysis("cr", " ".join([command, file, *more]))
    bodies = json.loads((SOURCES / "tests/cases/bodies.json").read_text())["cases"]
    for entry in bodies:
        yield _analysis("cpr", f"patterns tests/cases/{entry['file']} --mu {entry['mu']}")


def _pages():
    """Summaries of problem files; help, manual pages and completion; messages about wrong calls."""
    examples = SOURCES / "examples"
    for path in sorted([*examples.glob("*.toml"), *examples.glob("paper/*.toml"), *examples.glob("statics/*.toml")]):
        name = str(path.relative_to(SOURCES))
        words = ("show", name, "--html", "page.html", "--vtu", "picture.vtu")
        yield Call(f"show {path.relative_to(examples).with_suffix('')}", (Step("run", words),), quick=True)
    helped = [("all", "help"), ("none", "")] + [(name, f"help {name}") for name in (*SUBCOMMANDS, *GROUPS)]
    yield _of_steps("help", helped)
    yield _of_steps("manual", [("all", "--manual")] + [(name, f"--manual {name}") for name in SUBCOMMANDS])
    shells = ("bash", "zsh", "fish", "tcsh")
    yield _of_steps("completion", [(shell, f"--completion {shell}") for shell in shells])
    yield _of_steps("wrong calls", [(line, line) for line in _lines("wrong-calls.txt")])


def cases_without_call(calls):
    """Problem files of tests/cases that no call reads, without LEFT_OUT_CASES."""
    words = {word for call in calls for step in call.steps for word in step.words}
    files = [path for path in (SOURCES / "tests/cases").iterdir()
             if path.suffix in (".toml", ".mps", ".lp", ".inp", ".cert")]
    return sorted(path.name for path in files
                  if f"tests/cases/{path.name}" not in words and path.name not in LEFT_OUT_CASES)


def all_calls():
    """Every call, in the order of the table."""
    calls = [call for group in (_listed, _other_outputs, _cases, _pages) for call in group()]
    names = [call.name for call in calls]
    twice = sorted({name for name in names if names.count(name) > 1})
    assert not twice, f"two calls have one name: {twice}"
    return calls
