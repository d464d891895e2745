"""Verdicts of `kusabi verify` and of verify/second_checker.py, and their comparison.

Both say the same, word for word, but for the last digit of numbers, since one has enclosures where the other has
fractions, and the sums of normal reactions of some states, which may be others.
"""
import math
import pathlib
import re
import subprocess
import sys

SECOND_CHECKER = pathlib.Path(__file__).resolve().parents[2] / "verify" / "second_checker.py"
NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
#: Relative difference of numbers that differ in their last digit, and of those that cancel.
SAME_NUMBERS = 2e-11


def conclusion(output):
    """The sentence of a verdict, on one line, without what `kusabi verify` adds about claims that are not made."""
    last = re.split(r"\n[ \t]*\n", output.strip())[-1]
    found = re.search(r"(NOT |NOTHING )?PROVED.*", " ".join(last.split()))
    return re.sub(r"\.? *The certificate claims nothing.*", "", found[0]) if found else ""


def differ(one, other):
    """True if two sentences say different things."""
    one, other = (re.sub(r", those of some states to \S+ and [^ ;,]+", ", some", text) for text in (one, other))
    return re.sub(NUMBER, "#", one) != re.sub(NUMBER, "#", other) or any(
        not math.isclose(float(a), float(b), rel_tol=SAME_NUMBERS, abs_tol=SAME_NUMBERS)
        for a, b in zip(re.findall(NUMBER, one), re.findall(NUMBER, other)))


def of_second_checker(path, seconds=600):
    """(exit code, output); exit code None: no answer in time"""
    try:
        run = subprocess.run([sys.executable, "-B", SECOND_CHECKER, path], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, ""
    return run.returncode, run.stdout + run.stderr
