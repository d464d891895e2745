"""Comparison of `kusabi` with the oracle on one case."""

import json
import os
import subprocess
from decimal import Decimal
from itertools import product

DISAGREE, OPEN, UNDECIDED, REFUSED = "disagreement", "open", "undecided", "refused"
#: Default width of the brackets of `critical`.
WIDTH = 1e-8


#: Without a bound: nothing sticks without friction.
OPEN_BELOW = {"value": 0.0, "standing": "proved"}


class Finding:
    """A finding: kind (above), question, and one line with the answer and the correct one."""

    def __init__(self, kind, asked, line):
        self.kind, self.asked, self.line = kind, asked, line


class Kusabi:
    """The command, run in a folder of its own."""

    def __init__(self, path, folder, seconds=120):
        self.path, self.folder, self.seconds = os.path.abspath(path), folder, seconds
        self.calls = 0

    def run(self, *arguments):
        """(exit code, JSON or None, output). Exit code None: time limit."""
        output = os.path.join(self.folder, "result.json")
        if os.path.exists(output):
            os.remove(output)
        words = [self.path, *map(str, arguments)]
        if arguments[0] != "verify":
            words += ["--output", output]
        self.calls += 1
        try:
            done = subprocess.run(words, capture_output=True, text=True, timeout=self.seconds, cwd=self.folder)
        except subprocess.TimeoutExpired:
            return None, None, "no answer in time"
        result = None
        if os.path.exists(output):
            with open(output) as file:
                result = json.load(file)
        lines = (done.stdout + done.stderr).strip().splitlines()
        return done.returncode, result, lines[-1] if lines else ""


def whole_cones(result):
    """{(S, G): solid} of the whole structure from the patterns of its blocks."""
    everything = [name for block in result["blocks"] for name in block["candidates"]] if "blocks" in result else None
    parts = {}
    for pattern in result["patterns"]:
        if pattern["state"] not in ("feasible", "flat"):
            continue
        key = frozenset(pattern["contact"]), frozenset(pattern["separated"])
        parts.setdefault(pattern.get("block", 1), []).append((key, pattern))
    cones = {}
    for choice in product(*parts.values()) if parts else ():
        pressing = frozenset().union(*(key[0] for key, _ in choice))
        parted = frozenset().union(*(key[1] for key, _ in choice))
        rest = [set(pattern.get("inactive", ())) for _, pattern in choice]
        candidates = set(everything) if everything else set(pressing | parted).union(*rest)
        whole = len(pressing) + len(parted) == len(candidates)
        cones[pressing, parted] = whole and all(pattern["state"] == "feasible" for _, pattern in choice)
    return cones


def describe(cones):
    """A line for a set of cones."""
    words = sorted(f"{' '.join(sorted(s)) or '-'} | {' '.join(sorted(g)) or '-'}" for s, g in cones)
    return "{" + "; ".join(words[:6]) + (f"; ... {len(words)} in all" if len(words) > 6 else "") + "}"


def _same_cell(one, other):
    """True if two brackets share a coefficient and their bounds differ by at most one cell: a critical coefficient that
    is a multiple of the width may be in either cell beside it."""
    if one == other or None in one or None in other:
        return one == other
    near = all(abs(a - b) <= 1.5 * WIDTH for a, b in zip(one, other))
    return near and max(one[0], other[0]) <= min(one[1], other[1])


class Judge:
    """All checks of one case. `findings` collects errors, `tally` counts."""

    def __init__(self, kusabi, oracle, case, tally, far=False, may_be_open=False):
        """far: scales are far apart; may_be_open: answers may be open."""
        self.kusabi, self.oracle, self.case, self.tally = kusabi, oracle, case, tally
        self.far, self.may_be_open = far, may_be_open
        self.findings = []
        self.file = os.path.join(kusabi.folder, case.name + ".toml")
        with open(self.file, "w") as file:
            file.write(case.text)

    def _count(self, key, by=1):
        self.tally[key] = self.tally.get(key, 0) + by

    def _find(self, kind, asked, line):
        self.findings.append(Finding(kind, asked, line))

    def left_open(self, asked, line):
        if self.may_be_open:
            self._count("left open")
        else:
            self._find(OPEN, asked, line)

    def excuse(self, truth):
        """Reason why the oracle has no reliable answer, or None."""
        return None if self.far else truth.undecided

    def _ask(self, *arguments):
        """The JSON if the exit code is 0 or 3; otherwise None, and a finding."""
        asked = " ".join(str(a) for a in arguments if a != self.file)
        code, result, line = self.kusabi.run(*arguments)
        self._count(f"exit {code}")
        if code in (0, 3) and result is not None:
            return code, result["result"], result.get("statistics", {}), asked
        kind = REFUSED if code in (1, 2) else DISAGREE
        self._find(kind, asked, f"exit code {code}: {line}")
        return code, None, None, asked

    def _differs(self, asked, got, truth, undecided):
        """A finding if the sets differ, with the missing and the superfluous ones."""
        if set(got) == set(truth):
            return False
        missing, spare = set(truth) - set(got), set(got) - set(truth)
        self._find(UNDECIDED if undecided else DISAGREE, asked,
                   f"{len(got)} cones for {len(truth)}; missing {describe(missing)}, not true {describe(spare)}"
                   + (f" ({undecided})" if undecided else ""))
        return True

    def patterns(self, mu, margins=2, more=()):
        truth = self.oracle.cones(mu)
        code, result, _, asked = self._ask("patterns", self.file, "--mu", repr(mu), *more)
        self._count("ties", any(not solid for solid in truth.cones.values()))
        self._count("cones", len(truth.cones))
        if result is None:
            return None
        tree = result.get("tree", {})
        self._count("nodes", tree.get("opened", 0))
        self._count("escalated", tree.get("escalated", 0) or 0)
        left = result["marginal"] + result["undecided"] + bool(result["exact_remainder"])
        if (code == 3) != (left > 0):
            self._find(DISAGREE, asked, f"exit code {code} with {result['marginal']} marginal, {result['undecided']} undecided")
        if left:
            self.left_open(asked, f"{result['marginal']} marginal, {result['undecided']} undecided; truth: {len(truth.cones)} cones")
            return None
        got = whole_cones(result)
        if not self._differs(asked, got, truth.cones, self.excuse(truth)):
            if result["count"] != len(truth.cones):
                self._find(DISAGREE, asked, f"count {result['count']}, but {len(truth.cones)} cones")
            wrong = [key for key in got if got[key] != truth.cones[key]]
            if wrong and not self.excuse(truth):
                self._find(DISAGREE, asked, f"solid or flat: {describe(wrong)} is {'solid' if truth.cones[wrong[0]] else 'flat'}")
            for pattern in [p for p in result["patterns"] if p["state"] == "feasible"][:margins]:
                self._margin(asked, mu, pattern)
        return got

    def _margin(self, asked, mu, pattern):
        low, high = self.oracle.block_margin(mu, pattern["contact"], pattern["separated"])
        lower, upper = Decimal(pattern["margin"]), Decimal(pattern.get("margin_upper") or pattern["margin"])
        self._count("margins")
        slack = abs(high) * Decimal("2e-5")
        if lower > high + slack or upper < low - slack:
            self._find(DISAGREE, asked, f"margin {lower:.6e} .. {upper:.6e} of {pattern['contact']}, t* = {low:.6e}")
        elif abs(lower - low) > abs(low) * Decimal("1e-3") + Decimal("1e-12"):
            self._find(DISAGREE, asked, f"margin {lower:.6e} of {pattern['contact']} is not right to three digits, t* = {low:.6e}")

    def rays(self, mu, more=()):
        if self.oracle.d != 2:
            return
        truth = self.oracle.by_rays(mu)
        code, result, _, asked = self._ask("rays", self.file, "--mu", repr(mu), *more)
        if result is None:
            return
        if code == 3 or result["health"]["undecided"]:
            self.left_open(asked, f"{result['health']['undecided']} undecided zeros")
            return
        got = {(frozenset(c["contact"]) - frozenset(c.get("idle", ())), frozenset(c["separated"])) for c in result["cones"]}
        if not self._differs(asked, got, truth.cones, self.excuse(truth)) and truth.rays not in (None, result["count"]):
            self._find(UNDECIDED if truth.undecided else DISAGREE, asked, f"{result['count']} rays, but {truth.rays}")

    def _bracket(self, *more):
        """(lower, upper) if the call was answered; an open answer is checked and listed, and None
        is returned."""
        code, result, _, asked = self._ask("critical", self.file, *more)
        if result is None:
            return None
        bounds = result["critical_friction"]["lower"] or OPEN_BELOW, result["critical_friction"]["upper"]
        ends = bounds[0]["value"], bounds[1] and bounds[1]["value"]
        if code == 3:
            self.left_open(asked, f"bracket {ends[0]!r} .. {ends[1]!r}")
            low, high = (bound["value"] if bound and bound["standing"] == "proved" else None for bound in bounds)
            self._true_bracket(asked, low or 0.0, high)
            return None
        return ends

    def ends(self):
        """Consistency of the bracket, and its bounds by the oracle."""
        bracket = self._bracket()
        if bracket is not None:
            self._true_bracket("critical", *bracket)

    def _true_bracket(self, asked, lower, upper):
        below = lower > 0 and self.oracle.wedges(lower)
        if below:
            self._find(DISAGREE, asked, f"something wedges at the lower end {lower!r}")
        if upper is not None and self.oracle.wedges(upper) is False:
            self._find(DISAGREE, asked, f"nothing wedges at the upper end {upper!r}")

    def critical(self):
        """All methods, and the bounds by the oracle. Returns the bracket of the default."""
        bracket = self._bracket()
        if bracket is None:
            return None
        self._true_bracket("critical", *bracket)
        lower, upper = bracket
        for method in ("descent", "global"):
            other = self._bracket("--method", method)
            if other is not None and not _same_cell(other, bracket):
                self._find(DISAGREE, f"critical --method {method}", f"{other}, but by itself {bracket}")
        most = 2 * upper if upper is not None else min(lower, 10 * self.case.mu)
        for method in ("newton", "bisection"):
            other = self._bracket("--method", method, "--mu-max", repr(most))
            if other is None:
                continue
            if upper is None:
                if other != (most, None):
                    self._find(DISAGREE, f"critical --method {method}", f"{other}, but nothing wedges up to {lower!r}")
            elif not _same_cell(other, bracket):
                self._find(DISAGREE, f"critical --method {method} --mu-max {most!r}", f"{other}, but globally {bracket}")
        if upper is not None and lower > 0:
            most = 0.9 * lower
            other = self._bracket("--mu-max", repr(most))
            if other is not None and other != (most, None):
                self._find(DISAGREE, f"critical --mu-max {most!r}", f"{other}, but nothing wedges up to {lower!r}")
        return bracket

    def certificates(self, mu, of_structure, words=()):
        """Certificates of the patterns and of both bounds, accepted by `kusabi verify`."""
        path = os.path.join(self.kusabi.folder, "evidence")
        more = ["--problem", self.file] if of_structure else []
        for asked, files in ((("patterns", self.file, "--mu", repr(mu), *words), [path]),
                             (("critical", self.file), [path + ".lower", path + ".upper"])):
            for file in files:
                if os.path.exists(file):
                    os.remove(file)
            code, result, line = self.kusabi.run(*asked, "--certificate", path)
            if code != 0:
                continue
            for file in files:
                if file.endswith(".upper"):
                    upper = result["result"]["critical_friction"]["upper"]
                    if upper is None or upper["standing"] != "proved":
                        continue  # it is said that there is no certificate
                proved, _, line = self.kusabi.run("verify", file, *more)
                self._count("certificates")
                # Degenerate patterns cannot be proved: `patterns` counts them.
                answer = result["result"]
                ties = answer["exact"]["unproved"] if "exact" in answer else asked[0] == "critical" and file.endswith(".upper")
                if proved != 0 and not (proved == 3 and ties):
                    self._find(OPEN if proved == 3 else DISAGREE, f"{asked[0]} --certificate, verify {os.path.basename(file)} {' '.join(more[:1])}",
                               f"exit code {proved}: {line}")
