"""Measurement of one call, run twice: as it is for its answer, its counts, its heap and its CPU time, and
under valgrind for its instructions.

libmemusage.so, a part of glibc, adds the sizes of all allocated blocks. Valgrind's cachegrind without its
simulation of caches counts instructions exactly, and is the fastest of valgrind's tools that do. Its long
double has 64 bits only, so everything else is taken from the other run.
"""

import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

from table import Measurement

BENCH = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(BENCH))  # for openblas.py, and for faces.py and hold.py of the rows
import openblas  # noqa: E402

#: Without variables of the caller.
ENVIRONMENT = {"PATH": os.defpath, "LC_ALL": "C.UTF-8", "KUSABI_CONFIG": "", **openblas.SETTINGS}
HEAP = {"LD_PRELOAD": "libmemusage.so"}
#: Valgrind itself chooses most addresses, so that `setarch -R` changes nothing.
COUNTING = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]


class GuardError(Exception):
    """A call that could not be measured, in one sentence."""


def made(words):
    """Standard output of a call that must succeed."""
    done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise GuardError(f"{' '.join(words)}: exit code {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def require_valgrind():
    if shutil.which("valgrind", path=ENVIRONMENT["PATH"]) is None:
        raise GuardError("valgrind is missing: apt-get install valgrind")


def facts(kusabi):
    """Properties of the build and the machine on which instructions and allocated bytes depend."""
    compiler = re.search(r"^compiler +(.*)$", made([kusabi, "--version"]), re.MULTILINE)
    return {"compiler": compiler[1] if compiler else "unknown", "C library": " ".join(platform.libc_ver()),
            "valgrind": made(["valgrind", "--version"]).strip(),
            "processor": platform.machine() + (" with AVX2" if openblas.has_avx2() else "")}


def _run(words, folder, environment):
    """(exit code, standard output, standard error, resource usage)"""
    streams = [open(os.path.join(folder, name), "w+") for name in ("stdout", "stderr")]
    with streams[0] as out, streams[1] as error:
        process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=out, stderr=error)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        for stream in streams:
            stream.seek(0)
        return process.returncode, out.read(), error.read(), usage


def _heap(said):
    """Bytes of all allocated blocks, and the most at one time, from the summary of libmemusage."""
    found = re.search(r"heap total: (\d+), heap peak: (\d+)", re.sub(r"\x1b\[[0-9;]*m", "", said))
    if not found:
        raise GuardError("libmemusage.so of glibc printed no summary; is it installed?")
    return {"allocated": int(found[1]), "heap_peak": int(found[2])}


def _instructions(words, folder, expected):
    """@param expected exit code of the call without valgrind"""
    log = os.path.join(folder, "valgrind.log")
    code, _, said, _ = _run([*COUNTING, f"--log-file={log}", *words], folder, ENVIRONMENT)
    if code != expected:
        raise GuardError(f"{' '.join(words)}: exit code {code} under valgrind, {expected} without it: "
                         f"{said.strip()}")
    with open(log) as file:
        found = re.search(r"I +refs: +([\d,]+)", file.read())
    if not found:
        raise GuardError(f"valgrind counted no instructions of {' '.join(words)}")
    return int(found[1].replace(",", ""))


def _counts(content, path=""):
    """All integers of an object, summed over lists, by their path."""
    if isinstance(content, dict):
        pairs = [(f"{path}.{key}" if path else key, value) for key, value in content.items()]
    else:
        pairs = [(path, value) for value in content]
    sums = {}
    for key, value in pairs:
        if isinstance(value, (dict, list)):
            for inner, count in _counts(value, key).items():
                sums[inner] = sums.get(inner, 0) + count
        elif isinstance(value, int) and not isinstance(value, bool):
            sums[key] = sums.get(key, 0) + value
    return sums


def work(result):
    """Counts of work in a result: all of its statistics, and numbers of programs elsewhere; without zeros."""
    programs = {name: count for name, count in _counts(result["result"]).items() if name.endswith("programs")}
    return {name: count for name, count in (_counts(result["statistics"]) | programs).items() if count}


def _sizes(folder):
    """Bytes of the result file and of all files of the certificate."""
    sizes = {}
    for name in os.listdir(folder):
        kind = name.split(".")[0]
        if kind in ("result", "certificate"):
            sizes[kind] = sizes.get(kind, 0) + os.path.getsize(os.path.join(folder, name))
    return sizes


def measure(row, kusabi):
    """The Measurement of a row with this command. @throws GuardError"""
    with tempfile.TemporaryDirectory(prefix="kusabi-guard-") as folder:
        words = row.call(kusabi, folder)
        code, printed, said, usage = _run(words, folder, ENVIRONMENT | HEAP)
        amounts, counts, result = _heap(said) | _sizes(folder), row.printed_counts(printed + said), None
        if "result" in amounts:
            with open(os.path.join(folder, "result")) as file:
                result = json.load(file)
            counts |= work(result)
        answer = row.answer(result, printed) if code in (0, 3) else said.partition("\n")[0]
        amounts = {"instructions": _instructions(words, folder, code), **amounts}
    return Measurement(f"exit code {code}, {answer}", amounts, counts, usage.ru_utime + usage.ru_stime)
