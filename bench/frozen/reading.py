"""Output of a call, taken apart into places, texts and numbers.

A reading is a list of items. An item has a *place* (path of a JSON value, row and column of a table, path of
an XML element), a *text* in which each number is replaced by `#`, and these *numbers*. Two readings with
other places differ in structure, with other texts in words, with other numbers in numbers only.
"""

import base64
import csv
import dataclasses
import io
import json
import math
import os
import re
import struct
import tomllib
import zlib
from html.parser import HTMLParser

#: A number in a text; letters or digits on either side make it part of a name, as in `b13`.
_NUMBER = r"(?:0x[01](?:\.[0-9a-f]+)?p[-+]\d+|\d+(?:\.\d+)?(?:[eE][-+]?\d{1,2})?)"
_IN_TEXT = re.compile(r"(?<![\w.#])(?:(?<![\w.)\]])[-+−])?" + _NUMBER + r"(?!\w)")
#: A number in a list of coordinates, beside a letter as in `M10,4`.
_IN_COORDINATES = re.compile(r"[-+]?" + _NUMBER)
_COORDINATES = {"d", "points", "transform", "viewbox"}


@dataclasses.dataclass(frozen=True)
class Item:
    """@param group items whose numbers are of one kind: a number is small or large by comparison with these
    @param structural whether an item more or less is another structure, or other words only"""

    place: str
    text: str = ""
    numbers: tuple = ()
    group: str = ""
    structural: bool = True


def _value(digits):
    digits = digits.replace("−", "-")
    return float.fromhex(digits) if "0x" in digits else float(digits)


def _split(text, pattern=_IN_TEXT):
    """(text with `#` for each number, numbers). Blanks are single, since columns move with the length of
    their numbers."""
    numbers = tuple(_value(digits) for digits in pattern.findall(text))
    return " ".join(pattern.sub("#", text).split()), numbers


def _texts(place, text, group=None):
    """Item of a text."""
    words, numbers = _split(text)
    return Item(place, words, numbers, words if group is None else group)


def _lines(text):
    """Items of the lines of a printed text. The place of a line is its text and the number of such lines so
    far, so that a line more does not move all others."""
    seen = {}
    for line in text.splitlines():
        words, numbers = _split(line)
        seen[words] = seen.get(words, 0) + 1
        yield Item(f"“{words}” {seen[words]}", words, numbers, words, structural=False)


def _records(text):
    """Items of the lines of a file for programs: places are numbers of lines and of their fields."""
    for row, line in enumerate(text.splitlines(), 1):
        words, numbers = _split(line)
        yield Item(f"line {row} of {len(line.split())} fields", words, numbers, words.split("#")[0])


def _in_json(value, place, group):
    if isinstance(value, dict):
        yield Item(f"{place}: object")
        for key, inner in value.items():
            yield from _in_json(inner, f"{place}.{key}" if place else key, f"{group}.{key}")
    elif isinstance(value, list):
        yield Item(f"{place}: list of {len(value)}")
        for row, inner in enumerate(value):
            yield from _in_json(inner, f"{place}[{row}]", group)
    elif isinstance(value, bool):
        yield Item(f"{place}: truth", str(value).lower())
    elif value is None:
        yield Item(f"{place}: null")
    elif isinstance(value, str):
        yield _texts(f"{place}: text", value, group)
    else:
        text, numbers = ("#", (float(value),)) if abs(value) < 1e300 else (str(value), ())
        yield Item(f"{place}: number", text, numbers, group)


def _json(text):
    yield from _in_json(json.loads(text), "", "")


def _exits(text):
    """Exit codes are structure."""
    yield from (Item(f"exit of {label}: {end}") for label, end in json.loads(text).items())


def _json_lines(text):
    for row, line in enumerate(text.splitlines(), 1):
        yield from _in_json(json.loads(line), f"line {row}", "")


def _csv(text):
    header = None
    for row, cells in enumerate(csv.reader(io.StringIO(text))):
        if header is None:
            header = cells
            yield from (Item(f"column {name}") for name in cells)
            continue
        for column, cell in enumerate(cells):
            name = header[column] if column < len(header) else f"{column + 1}, which has no name"
            yield _texts(f"row {row}, column {name}", cell, name)


def _toml(text):
    """The keys are the structure; the text has the comments, too."""
    yield from (Item(item.place) for item in _in_json(tomllib.loads(text), "", ""))
    yield from _lines(text)


#: Codes of struct for the types of arrays in VTU files.
_CODES = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B", "Int8": "b"}


def _array(text, kind, packed):
    """Numbers of a binary array in a VTU file whose headers are 64-bit numbers."""
    text = text.strip()
    if packed:
        count = struct.unpack("<Q", base64.b64decode(text[:12])[:8])[0]
        length = 4 * math.ceil(8 * (3 + count) / 3)
        sizes = struct.unpack(f"<{count}Q", base64.b64decode(text[:length])[24:])
        blocks, data = base64.b64decode(text[length:]), b""
        for size in sizes:
            data, blocks = data + zlib.decompress(blocks[:size]), blocks[size:]
    else:
        data = base64.b64decode(text)[8:]
    code = _CODES[kind]
    return tuple(map(float, struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)))


class _Markup(HTMLParser):
    """Items of an HTML, SVG or VTK file: a place for each element, its attributes and the text in it."""

    def __init__(self):
        super().__init__()
        self.items, self._open, self._counts, self._packed, self._array = [], [], {}, False, None

    def _place(self, tag):
        path = "/".join([*self._open, tag])
        self._counts[path] = self._counts.get(path, 0) + 1
        return f"<{path}> {self._counts[path]}"

    def handle_starttag(self, tag, attributes):
        place = self._place(tag)
        self.items.append(Item(place))
        for key, value in attributes:
            words, numbers = _split(value or "", _IN_COORDINATES if key in _COORDINATES else _IN_TEXT)
            self.items.append(Item(f"{place} {key}=", words, numbers, f"{tag} {key}"))
        known = dict(attributes)
        if tag == "vtkfile":
            self._packed = "compressor" in known
        self._array = (known["type"], known.get("name", "")) if tag == "dataarray" else None
        if tag not in ("br", "hr", "img", "input", "link", "meta", "path", "line", "circle", "rect"):
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if self._open and self._open[-1] == tag:
            self._open.pop()

    def handle_endtag(self, tag):
        while tag in self._open and self._open.pop() != tag:
            pass

    def handle_comment(self, data):
        self.items.append(_texts(self._place("comment"), data))

    def handle_data(self, data):
        if not data.strip():
            return
        if self._array is None:
            self.items.append(_texts(self._place("text"), data))
            return
        kind, name = self._array
        numbers = _array(data, kind, self._packed)
        missing = " ".join(f"{number} at {row}" for row, number in enumerate(numbers)
                           if not math.isfinite(number))
        self.items.append(Item(f"{self._place(name)}: {len(numbers)} numbers", missing,
                               tuple(filter(math.isfinite, numbers)), name))
        self._array = None


def _markup(text):
    parser = _Markup()
    parser.feed(text)
    parser.close()
    return parser.items


_READERS = {".json": _json, ".jsonl": _json_lines, ".csv": _csv, ".toml": _toml,
            ".html": _markup, ".svg": _markup, ".vtu": _markup, ".pvd": _markup,
            ".printed": _lines, ".messages": _lines, ".exits": _exits}


def coarse(items):
    """The places without their numbers, and the texts of printed lines, each once: the same for two searches
    that end at different nodes."""
    once = dict.fromkeys((re.sub(r"\d+", "", item.place) if item.structural else item.text, item.structural)
                         for item in items)
    for place, structural in once:
        yield Item(place, "" if structural else place, structural=structural)


def read(name, text):
    """Items of an output, whose format is that of the end of its name: by default, lines of fields."""
    try:
        return list(_READERS.get(os.path.splitext(name)[1], _records)(text))
    except (ValueError, KeyError, struct.error, zlib.error) as error:
        return [Item(f"not readable as {os.path.splitext(name)[1]}: {error}"), *_lines(text)]
