"""Consistency of the outputs of one call with its JSON: text, report, CSV, Python object and exit
code.

Correctness is checked in compare.py.
"""

import csv
import html
import importlib.util
import json
import os
import re
import subprocess

_HERE = os.path.dirname(os.path.abspath(__file__))


def _python():
    spec = importlib.util.spec_from_file_location("kusabi_of_python", os.path.join(_HERE, "..", "..", "run", "python", "kusabi.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


_MODULE = _python()


def _plain(text):
    """One line, without markup."""
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", "", text))).strip()


def _open(command, answer):
    """Parts of the JSON that are open, in words; empty if none."""
    left = []
    for key in ("marginal", "undecided"):
        if answer.get(key):
            left.append(f"{answer[key]} {key}")
    if answer.get("exact_remainder"):
        left.append(answer["exact_remainder"]["why"])
    if answer.get("health", {}).get("undecided"):
        left.append("undecided numbers")
    if command == "critical":
        bracket = answer["critical_friction"]
        left += ["bracket is wide"] if answer["wide"] else []
        left += ["lower not proved"] if (bracket["lower"] or {}).get("standing") == "computed" else []
    if command == "sweep":
        left += ["open leaves"] if answer["open"] else []
        left += [f"no count at {p['mu']}" for p in answer["points"] if p["count"] is None]
    return left


def _rows(command, answer):
    """Number of rows of the CSV without its header; None: not known here."""
    return {"patterns": lambda: len(answer["patterns"]), "rays": lambda: len(answer["rays"]),
            "sweep": lambda: len(answer["points"]) + 2 * len(answer["staircase"])}.get(command, lambda: None)()


def contradictions(kusabi, words, tally):
    """Lines about outputs of `kusabi WORDS` that differ from its JSON. `kusabi` is a compare.Kusabi."""
    folder, command = kusabi.folder, words[0]
    place = lambda name: os.path.join(folder, name)
    names = {"json": place("one.json"), "csv": place("one.csv"), "html": place("one.html")}
    for name in names.values():
        if os.path.exists(name):
            os.remove(name)
    more = ["--output", names["json"]] + (["--csv", names["csv"]] if command in ("patterns", "rays", "sweep") else [])
    call = lambda arguments: subprocess.run([kusabi.path, *map(str, arguments)], capture_output=True, text=True,
                                            timeout=kusabi.seconds, cwd=folder)
    try:
        done = call([*words, *more])
        if not os.path.exists(names["json"]):
            return [] if done.returncode in (1, 2) else [f"exit code {done.returncode} without a result"]
        with open(names["json"]) as file:
            result = json.load(file)
        reported = call(["report", names["json"], "--output", names["html"]])
    except subprocess.TimeoutExpired:
        return []
    tally["outputs"] = tally.get("outputs", 0) + 1
    answer, found = result["result"], []
    status, left = result["status"], _open(command, answer)
    if done.returncode == 0 and (left or status != "solved"):
        found.append(f"exit code 0, but {', '.join(left) or status} in JSON")
    if done.returncode == 3 and status == "solved" and not left and "verdict" not in result:
        found.append("exit code 3, but nothing open in JSON")
    printed = _plain(done.stdout)
    if reported.returncode != 0:
        found.append(f"report: exit code {reported.returncode}: {reported.stderr.strip()}")
    else:
        with open(names["html"]) as file:
            page = file.read()
        text = _plain(page)
        sentence = result.get("verdict", {}).get("sentence")
        if sentence is None:  # headline of the report
            head = re.search(r'<p id="verdict">(.*?)</p>', page, re.S)
            sentence = _plain(head.group(1)) if head else None
        if sentence is None:
            found.append("report without a verdict")
        for where, said in (("terminal", printed), ("report", text)):
            if sentence is not None and _plain(sentence) not in said:
                found.append(f"{where} does not say: {sentence}")
        if done.returncode == 3 and re.search(r"It cannot stick at", printed):
            found.append("It cannot stick, with exit code 3")
    if os.path.exists(names["csv"]):
        with open(names["csv"], newline="") as file:
            rows = len(list(csv.reader(line for line in file if not line.startswith("#")))) - 1
        if _rows(command, answer) is not None and rows != _rows(command, answer):
            found.append(f"csv has {rows} rows, JSON {_rows(command, answer)}")
    own = _MODULE.load(names["json"])
    if own.answer != answer:
        found.append("Python reads another answer")
    if done.returncode in (0, 3) and own.partial != (done.returncode == 3):
        found.append(f"Python calls it {'partial' if own.partial else 'whole'}, the exit code is {done.returncode}")
    return [f"{' '.join(map(str, words))}: {line}".replace(folder + "/", "") for line in found]
