"""Comparison of two SVG files: they are the same if only numbers differ, by no more than rounding
of compilers."""
import re

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def difference(old, new):
    """The difference of two texts in a sentence; nothing if they are the same."""
    lines, others = old.splitlines(), new.splitlines()
    if len(lines) != len(others):
        return f"{len(lines)} lines; expected {len(others)}"
    for number, (line, other) in enumerate(zip(lines, others), 1):
        if NUMBER.sub("#", line) != NUMBER.sub("#", other):
            return f"line {number}: '{line}'; expected '{other}'"
        for one, two in zip(map(float, NUMBER.findall(line)), map(float, NUMBER.findall(other))):
            if abs(one - two) > 0.05 + 1e-3 * abs(two):
                return f"line {number}: {one}; expected {two}"
    return None
