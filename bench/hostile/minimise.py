"""Reduction of a problem file while the same command still disagrees with the oracle.

    python3 bench/hostile/minimise.py FILE --kusabi build/kusabi --ask patterns --mu 1.5 > SMALLER.toml
"""

import argparse
import copy
import sys
import tempfile

import compare
from oracle import Oracle
from structure import Mechanism, from_toml, to_toml


class _Case:
    def __init__(self, text, mu):
        self.name, self.text, self.mu, self.contrast = "case", text, mu, 1


def _wrong(path, ask, mu, kinds, text):
    """Findings of one command on one file, as lines."""
    try:
        oracle = Oracle(text)
    except (Mechanism, ZeroDivisionError, KeyError, ArithmeticError):
        return []
    if not oracle.names:
        return []
    with tempfile.TemporaryDirectory() as folder:
        judge = compare.Judge(compare.Kusabi(path, folder, 60), oracle, _Case(text, mu), {})
        if ask == "critical":
            judge.critical()
        elif ask == "certificates":
            judge.certificates(mu, True)
        else:
            getattr(judge, ask)(mu)
        return [f"{f.kind}: {f.asked}: {f.line}" for f in judge.findings if f.kind in kinds]


def _smaller(structure):
    """Structures with one part removed."""
    for field in ("candidates", "bars", "quads"):
        for i in range(len(getattr(structure, field))):
            other = copy.deepcopy(structure)
            del getattr(other, field)[i]
            used = {n for _, a, b in other.bars for n in (a, b)} | {n for q in other.quads for n in q[4]}
            if any(name not in used for name, *_ in other.candidates):
                continue
            other.nodes = {name: place for name, place in other.nodes.items() if name in used}
            other.fixed = {name: axes for name, axes in other.fixed.items() if name in used}
            yield other
    for i, (node, normal, tangent, friction) in enumerate(structure.candidates):
        if tangent is not None or friction not in (0.0, 1.0):
            other = copy.deepcopy(structure)
            other.candidates[i] = (node, normal, None, 1.0)
            yield other
    for digits in (1, 2, 3):
        near = lambda x: float(f"{x:.{digits}g}")
        other = copy.deepcopy(structure)
        other.nodes = {name: [near(x) for x in place] for name, place in other.nodes.items()}
        other.bars = [(near(stiffness), a, b) for stiffness, a, b in other.bars]
        other.candidates = [(node, [near(x) for x in normal], tangent, near(friction))
                            for node, normal, tangent, friction in other.candidates]
        if to_toml(other) != to_toml(structure):
            yield other


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("--kusabi", default="build/kusabi")
    parser.add_argument("--ask", choices=("patterns", "rays", "critical", "certificates"), default="patterns")
    parser.add_argument("--mu", type=float, default=1.0)
    parser.add_argument("--kinds", default="disagreement,open")
    arguments = parser.parse_args()
    with open(arguments.file) as file:
        structure = from_toml(file.read())
    test = lambda other: _wrong(arguments.kusabi, arguments.ask, arguments.mu, arguments.kinds.split(","), to_toml(other))
    lines = test(structure)
    if not lines:
        sys.exit("it does not disagree")
    progress = True
    while progress:
        progress = False
        for other in _smaller(structure):
            found = test(other)
            if found:
                structure, lines, progress = other, found, True
                break
    print("# " + lines[0].replace("\n", " "))
    print(to_toml(structure), end="")


if __name__ == "__main__":
    main()
