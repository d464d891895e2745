"""Comparison of output shown on a page with the actual output, and its update.

Lines may be wrapped. A lone … stands for any number of words. Numbers may differ by two in their
last digit, those of more digits by 1e-12 of their size, as compilers round differently; integers
must agree. Rows of a table of ranks, and the version, are not compared, since they change from run
to run.
"""
import re
import textwrap

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
GAP = "…"
WIDTH = 120


def words(text):
    """The words that are compared."""
    text = re.sub(r"(?m)^kusabi \d+\.\d+\.\d+\S* · .*\n?", "", text)
    kept, in_ranks = [], False
    for line in text.splitlines():
        if in_ranks and re.match(r"\s*(\d+|all)\s", line):
            continue
        in_ranks = line.startswith("rank ")
        kept.extend(line.split())
    return kept


def last_digit(number):
    """Unit of the last digit."""
    mantissa, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def alike(one, two):
    """True if two words agree except for rounding."""
    if one == two:
        return True
    if NUMBER.sub("#", one) != NUMBER.sub("#", two):
        return False
    for old, new in zip(NUMBER.findall(one), NUMBER.findall(two)):
        whole = "." not in old + new and "e" not in old + new
        rounding = max(2.01 * last_digit(old), 2.01 * last_digit(new), 1e-12 * abs(float(old)))
        if abs(float(old) - float(new)) > (0 if whole else rounding):
            return False
    return True


def difference(shown, came):
    """The first difference between page and output, in a sentence; nothing if they agree."""
    old, new = words(shown), words(came)
    at, to, gap, after_gap, farthest = 0, 0, None, 0, (0, 0)
    while to < len(new):
        if at < len(old) and old[at] == GAP:
            gap, after_gap, at = at, to, at + 1
        elif at < len(old) and alike(old[at], new[to]):
            at, to = at + 1, to + 1
            farthest = max(farthest, (at, to))
        elif gap is not None:
            after_gap += 1
            at, to = gap + 1, after_gap
        else:
            break
    while at < len(old) and old[at] == GAP:
        at += 1
    if at == len(old) and to == len(new):
        return None
    at, to = max(farthest, (at, to)) if to < len(new) else farthest
    return f"'{' '.join(old[at:at + 6]) or 'nothing'}'; expected '{' '.join(new[to:to + 6]) or 'nothing'}'"


def likeness(line):
    """Key by which a line with other numbers is found again."""
    return NUMBER.sub("#", " ".join(line.split()[:2]))


def wrapped(lines):
    """Wrapped to the width of a page."""
    for line in lines:
        yield from [line] if len(line) <= WIDTH else textwrap.wrap(line, WIDTH, break_long_words=False, break_on_hyphens=False)


def renewed(shown, came):
    """The output, abridged like the page, as lines. Lines between two gaps are found by their first words."""
    if difference("\n".join(shown), came) is None:
        return shown
    new = list(wrapped(came.rstrip("\n").splitlines()))
    parts = [[]]
    for line in shown:
        if line.strip() == GAP:
            parts.append([])
        else:
            parts[-1].append(line)
    if len(parts) == 1:
        return shortened(new, shown)
    at = len(parts[0])
    lines = shortened(new[:at], parts[0])
    for part in parts[1:]:
        lines.append(GAP)
        here = (k for k in range(at, len(new)) if part and likeness(new[k]) == likeness(part[0]))
        begin = next(here, None)
        if begin is None:
            continue
        at = begin + len(part)
        lines += shortened(new[begin:at], part)
    return lines


def shortened(new, old):
    """Lines that end in a gap on the page end there again."""
    out = []
    for k, line in enumerate(new):
        was = old[k].split() if k < len(old) else []
        if len(was) > 1 and was[-1] == GAP:
            cut = re.match(r"\s*(?:\S+\s+){%d}" % (len(was) - 1), line)
            line = cut[0].rstrip() + " " + GAP if cut else line
        out.append(line)
    return out
