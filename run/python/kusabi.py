"""Kusabi from Python: runs the command `kusabi` and reads its results.

One file that requires the standard library only (Python 3.9 or later), and uses pandas if
installed. The command is that of the environment variable KUSABI, otherwise `kusabi` in the PATH.

    import kusabi

    result = kusabi.run("patterns", "examples/space-truss.toml", mu=0.65, ranks=2)
    result["result"]["count"]               # the result file, see docs/result-files.md
    result.partial                          # stopped early, or something is open
    result.to_dataframe()                   # one row per pattern; a list of dicts without pandas

    try:
        kusabi.run("patterns", "wrong.toml", mu=0.65)
    except kusabi.WrongInput as error:
        print(error)                        # wrong.toml:16:3: unknown key "menbers" …
"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import tempfile

__all__ = ["Error", "Failed", "NotFound", "Result", "WrongInput", "call", "load", "patterns", "run"]

_SOLVED, _WRONG_INPUT, _STOPPED_EARLY = 0, 2, 3  # exit codes; 1 and all others: the run failed


class Error(Exception):
    """An error, with the message of the command.

    returncode: exit code of the command, None if it was not run; stderr: all of its messages;
    result: the result file if it was written nevertheless (a Result), or None.
    """

    def __init__(self, message, returncode=None, stderr="", result=None):
        super().__init__(message)
        self.returncode = returncode
        self.stderr = stderr
        self.result = result


class WrongInput(Error):
    """The problem file or the call is invalid (exit code 2), or a file is not a result."""


class Failed(Error):
    """The run failed: exit code 1, a signal, or an error of the launcher."""


class NotFound(Error):
    """The command `kusabi`, or the launcher, does not exist."""


class Result(dict):
    """A result file: a dict with its keys, and methods for its parts.

    remarks: further messages of the command, one line each: warnings, open parts, the call that
    resumes.
    sentence, reservations, warnings: the answer, its limitations and the warnings about the input,
    as in the table and the report.
    """

    def __init__(self, content, partial=None, remarks=()):
        super().__init__(content)
        self.partial = _is_partial(content) if partial is None else partial
        self.remarks = list(remarks)

    @property
    def sentence(self):
        return self["verdict"]["sentence"]

    @property
    def reservations(self):
        return self["verdict"]["reservations"]

    @property
    def warnings(self):
        return self.get("warnings", [])

    @property
    def answer(self):
        """The key `result`: the answer."""
        return self["result"]

    @property
    def structure(self):
        """Nodes, members, elements, supports and loads (not for `mip`)."""
        return self["problem"]["structure"]

    @property
    def candidates(self):
        """Names of the contact candidates, in the order of all reactions."""
        return [each["node"] for each in self["problem"]["contact"]]

    def rows(self, of=None):
        """Table of the answer as a list of dicts with the names of the result file: one row per
        pattern (`patterns`, `critical`, `sweep` of friction), interval of load factors (`hold`,
        with `friction` first if there are several coefficients) or piece of its diagram, ray,
        member (`limit`), point (`sweep` of loads), or nonzero column of the program (`mip`).

        of: name of another list of the answer, such as "staircase" of `sweep`, "groups" of
        `patterns`.
        """
        if of is not None:
            return _list(self.answer, of)
        tables = {"patterns": _patterns, "critical": _patterns, "hold": _intervals, "rays": _rays, "sweep": _swept,
                  "limit": _members, "mip": _columns}
        if self["command"] not in tables:
            raise Error(f"results of kusabi {self['command']} have no rows; expected one of {', '.join(tables)}")
        return tables[self["command"]](self)

    def to_dataframe(self, of=None):
        """rows(of) as a pandas.DataFrame; without pandas rows(of) itself."""
        try:
            import pandas
        except ImportError:
            return self.rows(of)
        return pandas.DataFrame(self.rows(of))


def run(command, file, *, ranks=None, input=None, **options):
    """Runs `kusabi COMMAND FILE` and returns its Result.

    command: "patterns", "rays", "critical", "hold", "sweep", "limit", "mip", or any other with --output
    file: the problem file; "-" for the text `input`
    ranks: number of ranks under mpirun (or the launcher of the environment variable KUSABI_MPIRUN);
    None: one process
    options: options of the command, with _ for -: mu=0.65, time_limit=60; True switches one on,
    None and False leave it out. output="FILE" keeps the result file.

    A run that was stopped, or is partly open (exit code 3), is not an error: `partial` of its
    Result is true.
    Raises WrongInput, Failed, NotFound.
    """
    with tempfile.TemporaryDirectory() as folder:
        kept = options.pop("output", None)
        place = pathlib.Path(folder, "result.json") if kept is None else pathlib.Path(kept)
        before = _stamp(place)
        ended = _execute(command, file, ranks, input, {**options, "output": place, "quiet": True})
        written = _stamp(place) != before
        if ended.returncode not in (_SOLVED, _STOPPED_EARLY):
            raise _error(ended, load(place) if written else None)
        if not written:
            raise Failed(f"kusabi {command} has written no result", ended.returncode, ended.stderr)
        return Result(_read(place), ended.returncode == _STOPPED_EARLY, _said(ended.stderr))


def call(command, *files, ranks=None, input=None, **options):
    """Runs any command, such as kusabi.call("verify", "a.cert", problem="a.toml"), and returns its
    output.

    Raises WrongInput, Failed (also if `verify` refuses), NotFound.
    """
    ended = _execute(command, files, ranks, input, options)
    if ended.returncode not in (_SOLVED, _STOPPED_EARLY):
        raise _error(ended)
    return ended.stdout


def load(path):
    """Reads a result file. Raises WrongInput if it is not one, OSError if it cannot be read."""
    return Result(_read(path))


def patterns(path):
    """Iterates over the patterns of a file of --format jsonl, one at a time: memory does not grow.

    Raises WrongInput if it is no such file, OSError if it cannot be read.
    """
    return _in_lines(path, "patterns")


def rays(path):
    """Iterates over the rays of a file of --format jsonl, as patterns()."""
    return _in_lines(path, "rays")


def _in_lines(path, name):
    with open(path, encoding="utf-8") as file:
        try:
            if json.loads(file.readline()).get("lines") != name:
                raise WrongInput(f"{path}: has no lines of {name}; expected what --format jsonl has written")
            for line in file:
                each = json.loads(line)
                if "reaction" not in each:
                    return
                yield each
        except (ValueError, RecursionError, AttributeError) as error:
            raise WrongInput(f"{path}: is no JSON in lines: {error}") from None
        raise WrongInput(f"{path}: has no last line; the file is incomplete")


def _content(path):
    with open(path, encoding="utf-8") as file:
        first = file.readline()
        if not any(f'"lines":"{name}"' in first for name in ("patterns", "rays")):
            return json.loads(first + file.read())
        content = json.loads(first)
        *found, end = (json.loads(line) for line in file)
    if "reaction" in end:
        raise ValueError("its last line is missing")
    content["result"][content.pop("lines")] = found
    return {**content, **end}


def _read(path):
    try:
        content = _content(path)
    except (ValueError, KeyError, RecursionError) as error:
        raise WrongInput(f"{path}: is no JSON: {error}") from None
    missing = [key for key in ("command", "problem", "status", "result")
               if not isinstance(content, dict) or key not in content]
    if missing:
        raise WrongInput(f"{path}: '{missing[0]}' is missing; expected what --output of kusabi has written")
    _make_counts_integers(content["result"])
    return content


def _make_counts_integers(answer):
    """Counts beyond 2^53 are strings in the file."""
    for each in (answer, answer.get("at_mu_max") or {}, *answer.get("points", ()), *answer.get("staircase", ())):
        for name in ("count", "known"):
            if isinstance(each.get(name), str):
                each[name] = _integer(each[name])


def _integer(digits):
    value, at_once = 0, 4000  # int() takes 4300 digits
    for first in range(0, len(digits), at_once):
        part = digits[first:first + at_once]
        value = value * 10 ** len(part) + int(part)
    return value


def _execute(command, files, ranks, input, options):
    words = [_executable(), *command.split()]  # "export mps" is two
    files = files if isinstance(files, tuple) else (files,)
    words += [_file_word(file) for file in files]
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(repr(float(value)) if isinstance(value, float) else str(value))
    if ranks is None:
        words.append("--serial")
    else:
        words = [*_launcher(), "-n", str(ranks), *words]
    return subprocess.run(words, input="" if input is None else input, capture_output=True, encoding="utf-8",
                          errors="replace", check=False)


def _file_word(file):
    word = os.fspath(file)
    return f"./{word}" if word.startswith("-") and word != "-" else word  # not an option


def _executable():
    named = os.environ.get("KUSABI", "kusabi")
    found = shutil.which(named)
    if found is None:
        raise NotFound(f"there is no command {named}; expected it on the PATH, or its place in the environment "
                       "variable KUSABI")
    return found


def _launcher():
    words = shlex.split(os.environ.get("KUSABI_MPIRUN", "mpirun"))
    if not words or shutil.which(words[0]) is None:
        raise NotFound(f"there is no launcher {' '.join(words)}; expected mpirun on the PATH, or another in the "
                       "environment variable KUSABI_MPIRUN")
    return words


def _said(text):
    """Message lines of the command; what mpirun adds about a failed rank begins with a line of dashes."""
    lines = []
    for line in text.splitlines():
        if line.startswith("----------"):
            break
        if line.strip():
            lines.append(line.strip())
    return lines


def _error(ended, result=None):
    # Warnings precede the error. A refused certificate is an answer, which is printed; otherwise
    # the message is the launcher's.
    of_launcher = [line.strip() for line in ended.stderr.splitlines() if line.strip(" -")]
    said = _said(ended.stderr)[-1:] or _said(ended.stdout)[:1] or of_launcher[:1]
    message = said[0] if said else f"kusabi ended with exit code {ended.returncode} and said nothing"
    kind = WrongInput if ended.returncode == _WRONG_INPUT else Failed
    return kind(message, ended.returncode, ended.stderr, result)


def _stamp(path):
    """State of a file, which changes when it is replaced."""
    try:
        status = os.stat(path)
    except OSError:
        return None
    return status.st_ino, status.st_mtime_ns, status.st_size


def _is_partial(content):
    """True for exit code 3, determined from the file alone."""
    return not content["verdict"]["answered"]


def _patterns(result):
    return [{"pattern": number, **each} for number, each in enumerate(result.answer["patterns"], 1)]


def _swept(result):
    return _patterns(result) if "patterns" in result.answer else _list(result.answer, "points")


def _list(answer, name):
    tables = [key for key, value in answer.items() if isinstance(value, list) and all(isinstance(each, dict) for each in value)]
    if name not in tables:
        raise Error(f"the result has no table {name!r}; expected one of {', '.join(tables)}")
    return [dict(each) for each in answer[name]]


def _intervals(result):
    answer = result.answer
    if "points" in answer:
        return [{"friction": point["friction"], **each} for point in answer["points"] for each in point["intervals"]]
    return answer.get("pieces", answer.get("intervals", []))


def _rays(result):
    return [{"ray": each["number"], **each} for each in result.answer["rays"]]


def _columns(result):
    return [{"column": name, "value": value} for name, value in result.answer.get("columns", {}).items()]


def _members(result):
    answer, structure = result.answer, result.structure
    names = structure["node_names"]
    yielding = {mode: {tuple(each["member"]): each["in"] for each in answer.get(mode, {}).get("yielding", [])}
                for mode in ("nominal_mode", "collapse_mode")}
    rows = []
    for i, (first, second) in enumerate(structure["members"]):
        row = {"member": structure["member_names"][i], "first": names[first], "second": names[second]}
        row["yield_tension"], row["yield_compression"] = structure["yield_forces"][i]
        for forces, utilisation, mode in (("nominal_forces", "nominal_utilisation", "nominal_mode"),
                                          ("forces", "utilisation", "collapse_mode")):
            row[forces] = answer[forces][i] if forces in answer else None
            row[utilisation] = answer[utilisation][i] if utilisation in answer else None
            row[mode] = yielding[mode].get((row["first"], row["second"]))
        rows.append(row)
    return rows
