"""One call of the command, in a folder of its own: its steps, and the outputs of all of them as text."""

import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCES = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(SOURCES / "bench"))
import openblas  # noqa: E402

#: Settings without which outputs may differ: no defaults from files of the user, one thread, no terminal.
ENVIRONMENT = {"KUSABI_CONFIG": "", "NO_COLOR": "1", "TERM": "dumb", "LC_ALL": "C.UTF-8", **openblas.SETTINGS}
#: Folders of the sources with the problem files of the calls.
INPUTS = ("examples", "tests/cases", "tests/meshes", "tests/programs")

#: Left out of the outputs, each for a reason: keys of result files at the top.
LEFT_OUT_KEYS = {
    "statistics": "times, and the share of each rank",
    "version": "of the program; outputs do not depend on it",
}
#: Likewise parts of texts: end of the name of the output, pattern, and what stands in its place.
LEFT_OUT_TEXTS = (
    # Version and date of the program.
    ("", r"\bkusabi \d+\.\d+\.\d+", "kusabi -"),
    (".html", r'(<th scope="row">version</th>\s*<td>)[^<]*', r"\1-"),
    (".printed", r"(?m)^(\.TH .* 1) [-0-9]+ ", r"\1 - "),
    # Tables of ranks: share of the time without work, and seconds.
    (".printed", r"(?m)^(0 .*?) +[\d.]+ % +\d+\.\d{3}$", r"\1 - -"),
    # Progress, shown by the clock: lines of a search, and of the steps between searches.
    (".messages", r"(?m)^ +time +nodes +per s .*\n", ""),
    (".messages", r"(?m)^ +\d+:\d\d .*\n", ""),
    (".messages", r"(?m)^(bracket so far|at the root|bounds|the least factors): .*\n", ""),
    (".messages", r"(?m)^(looking for|sampling the tree|losses of up to \d+ members:) .*\n", ""),
    (".messages", r"(?m)^.*: \d+ %\n", ""),
    # Digest of a certificate: it changes with every last digit of its numbers.
    ("", r"(?m)^digest [0-9a-f]{40}$", "digest -"),
)


@dataclasses.dataclass(frozen=True)
class Step:
    """One start of the command.
    @param needs a file without which the step is skipped, such as the certificate of an open bound"""

    label: str
    words: tuple
    needs: str = ""


@dataclasses.dataclass(frozen=True)
class Call:
    """Steps that follow each other, in a folder with copies of INPUTS.
    @param files pairs of a name and the text of a file that exists before
    @param stopped the search ends early, at a node that depends on the speed of the machine
    @param sensitive numbers depend on rounding errors by more than a table tolerates"""

    name: str
    steps: tuple
    quick: bool = False
    files: tuple = ()
    stopped: bool = False
    sensitive: bool = False


def _without_left_out(name, text):
    for end, pattern, instead in LEFT_OUT_TEXTS:
        if name.endswith(end):
            text = re.sub(pattern, instead, text)
    return text


def _result(text):
    """A result file without the keys that are left out, one value a line."""
    result = json.loads(text)
    if isinstance(result, dict):
        for key in LEFT_OUT_KEYS:
            result.pop(key, None)
    return json.dumps(result, indent=1, ensure_ascii=False) + "\n"


def _normalised(name, text):
    try:
        if name.endswith(".jsonl"):
            first, *rest = text.splitlines()
            return "\n".join([json.dumps(json.loads(_result(first))), *rest]) + "\n"
        if name.endswith(".json") or text.startswith("{"):
            return _result(text)
    except ValueError:
        pass  # what is no JSON is compared as it is
    return _without_left_out(name, text)


def _start(binary, words, folder, seconds):
    """(exit, standard output, standard error)"""
    try:
        done = subprocess.run([binary, *words], cwd=folder, capture_output=True, timeout=seconds, check=False,
                              stdin=subprocess.DEVNULL, env={**os.environ, **ENVIRONMENT})
    except subprocess.TimeoutExpired:
        return f"no answer in {seconds} s", b"", b""
    code = done.returncode
    return code if code >= 0 else f"signal {-code}", done.stdout, done.stderr


def outputs(binary, call, seconds):
    """{name: text} of all that the call writes, among them inputs that it overwrites. `all.exits` has the
    exit code of each step, or its signal."""
    found, exits = {}, {}
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for name in INPUTS:
            shutil.copytree(SOURCES / name, folder / name)
        for name, text in call.files:
            (folder / name).write_text(text)
        before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        for step in call.steps:
            if step.needs and not (folder / step.needs).exists():
                continue
            exits[step.label], printed, messages = _start(binary, step.words, folder, seconds)
            for kind, content in (("printed", printed), ("messages", messages)):
                if content:
                    key = f"{step.label}.{kind}"
                    found[key] = content.decode(errors="replace").replace(place, "FOLDER")
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            content = path.read_bytes()
            if before.get(path) != content:
                name = str(path.relative_to(folder))
                found[name] = content.decode(errors="backslashreplace").replace(place, "FOLDER")
    found["all.exits"] = json.dumps(exits, indent=1)
    normalised = {name: _normalised(name, text) for name, text in found.items()}
    return {name: text for name, text in normalised.items() if text}


def failures(found):
    """Lines about steps that crashed or did not end."""
    exits = json.loads(found["all.exits"])
    return [f"{label}: {end}" for label, end in exits.items() if isinstance(end, str)]
