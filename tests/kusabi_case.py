"""Base class of the Python tests of the command. Their last two arguments are KUSABI SOURCES: the
command, and the folder of the sources.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop()).resolve()
KUSABI = sys.argv.pop()
EXAMPLES = SOURCES / "examples"


def moved(text, along_x):
    """A file with the corners of its meshes moved along x."""
    def numbers(match):
        points = json.loads(match[1])
        return "corners = " + json.dumps([[x + along_x, y] for x, y in points])
    return re.sub(r"corners = (\[\[.*\]\])", numbers, text)


def with_ends(held):
    """An interval of factors, or a range of sums of reactions, that `hold` has found, with its ends by name: `low` and
    `high` are held, `low_out` and `high_out` are not; None: there is none, or it is not known."""
    below, above = (held[key] for key in (("below", "above") if "below" in held else ("minimum", "maximum")))
    bounds = {"low": below["upper"], "low_out": below["lower"], "high": above["lower"], "high_out": above["upper"]}
    return {**held, **{end: bound and bound["value"] for end, bound in bounds.items()},
            **{f"{end}_proved": bool(bound) and bound["standing"] == "proved" for end, bound in bounds.items()}}


def without_digest(certificate):
    return certificate[:certificate.rindex("digest ")]


def sealed(body):
    """The certificate, or what was made of it, with its digest."""
    return f"{body}digest {hashlib.sha1(body.encode()).hexdigest()}\n"


def counted(body):
    """The same with the right number of lines of evidence, if it has any."""
    start = body.find("\nevidence\n")
    return sealed(re.sub(r"(?m)^end \d+$", f"end {body[start:].count(chr(10)) - 3}", body) if start >= 0 else body)


class KusabiCase(unittest.TestCase):
    """Each test has its own `folder`, and the path of a `result` file in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.result = self.folder / "result.json"

    def problem(self, text):
        """The path of a problem file with this text."""
        place = self.folder / "problem.toml"
        place.write_text(text)
        return place

    def kusabi(self, *words, **how):
        return subprocess.run([KUSABI, *map(str, words), "--serial"], capture_output=True, text=True, check=False, **how)

    def solve(self, command, name, *words):
        """The result, or part of it, of an example, which is then in the file `result`, too."""
        run = self.kusabi(command, EXAMPLES / name, *words, "--output", self.result)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        return json.loads(self.result.read_text())

    def refused(self, *words):
        """Standard error of a call that is refused: exit code 2 and one line."""
        run = self.kusabi(*words)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        return run.stderr

    def check_refusals(self, command, broken_texts, *words):
        """Expects a refusal of each text. @param broken_texts pairs of a malformed result and a part of its message"""
        text = self.result.read_text()
        for broken, why in broken_texts:
            with self.subTest(why):
                self.assertNotEqual(broken, text)
                self.result.write_text(broken)
                self.assertIn(why, self.refused(command, self.result, *words))
        self.result.write_text(text)


def without(content, *way):
    """The text of a result in which a key, or an entry of a list, is missing."""
    broken = json.loads(json.dumps(content))
    inner = broken
    for key in way[:-1]:
        inner = inner[key]
    del inner[way[-1]]
    return json.dumps(broken)


def nested(depth):
    """The text of an object with nested lists, of `depth` levels including the object."""
    return '{"result": ' + "[" * (depth - 1) + "]" * (depth - 1) + "}"


def main():
    unittest.main(argv=sys.argv)
