"""Differences between two readings of an output, sorted into structure, words and numbers."""

import dataclasses
import hashlib
import math

STRUCTURE, WORDS, NUMBERS = KINDS = "structure", "words", "numbers"

#: Part of the largest number of a group below which a number may consist of rounding errors.
SMALL = 1e-6
#: Least scale of a group, all of whose numbers may be rounding errors.
LEAST = 1e-3
#: Difference of two checksums that rounding errors may cause.
TOLERANCE = 1e-7


@dataclasses.dataclass(frozen=True)
class Difference:
    """A difference of one kind, described in one line."""

    kind: str
    line: str


@dataclasses.dataclass(frozen=True)
class Summary:
    """What a table stores of a reading."""

    structure: str
    words: str
    count: int
    checksum: float


def _shown(text, length=70):
    return text if len(text) <= length else text[:length - 1] + "…"


def _more(places):
    return f" and {len(places) - 1} more" if len(places) > 1 else ""


def compare(old, new):
    """Differences of two readings, at most one of each kind."""
    before, after = {item.place: item for item in old}, {item.place: item for item in new}
    differences = []
    for kind, structural in ((STRUCTURE, True), (WORDS, False)):
        lost = [i.place for i in old if i.structural == structural and i.place not in after]
        added = [i.place for i in new if i.structural == structural and i.place not in before]
        parts = ([f"no longer {_shown(lost[0])}{_more(lost)}"] if lost else []) + (
            [f"new {_shown(added[0])}{_more(added)}"] if added else [])
        order = [[i.place for i in items if i.structural == structural] for items in (old, new)]
        if not parts and order[0] != order[1]:
            parts = [f"another order, from {_shown(next(b for a, b in zip(*order) if a != b))} on"]
        if parts:
            differences.append(Difference(kind, ", ".join(parts)))
    both = [(item, after[item.place]) for item in old if item.place in after]
    reworded = [(a, b) for a, b in both if a.text != b.text]
    if reworded:
        a, b = reworded[0]
        line = f"{_shown(a.place)} “{_shown(a.text)}” → “{_shown(b.text)}”{_more(reworded)}"
        differences.append(Difference(WORDS, line))
    changed = [(abs(x - y) / max(abs(x), abs(y)), a.place, x, y) for a, b in both if a.text == b.text
               for x, y in zip(a.numbers, b.numbers) if x != y]
    if changed:
        part, place, x, y = max(changed)
        line = f"{len(changed)}, by up to {part:.1e}: {_shown(place)} {x!r} → {y!r}"
        differences.append(Difference(NUMBERS, line))
    return differences


def _hash(texts):
    """Digest of a sequence of texts."""
    digest = hashlib.sha256()
    for text in texts:
        digest.update(text.encode() + b"\n")
    return digest.hexdigest()[:8]


def _checksum(reading):
    """(number of numbers, checksum). The checksum changes by about the relative change of any number,
    whatever its order of magnitude, and not by rounding errors of zeros. A hash of rounded numbers would
    change wherever a number is halfway between two roundings. Weights from 0.5 to 1.5 show numbers that
    change places."""
    scales = {}
    for item in reading:
        for number in item.numbers:
            scales[item.group] = max(scales.get(item.group, LEAST), abs(number))
    terms, row = [], 0
    for item in reading:
        small = SMALL * scales.get(item.group, LEAST)
        for number in item.numbers:
            row += 1
            size = abs(number) + small
            terms.append((0.5 + row * 0.6180339887498949 % 1) * (math.log(size) + 4 * number / size))
    return row, math.fsum(terms)


def summary(reading):
    """The row of a table."""
    structure = _hash(item.place for item in reading if item.structural)
    return Summary(structure, _hash(item.text for item in reading), *_checksum(reading))


def compare_summaries(old, new):
    """Differences of two rows. With another structure the rest is not comparable; with another number of
    numbers in other words, the numbers are not."""
    if old.structure != new.structure:
        return [Difference(STRUCTURE, "another structure, and perhaps other words and numbers")]
    differences = []
    if old.words != new.words:
        differences.append(Difference(WORDS, "other words"))
    apart = abs(old.checksum - new.checksum)
    if old.count == new.count and not apart <= TOLERANCE:
        differences.append(Difference(NUMBERS, f"other numbers (checksums {apart:.1e} apart)"))
    return differences
