"""Images of the pages, compared with those of kusabi draw; run/figures finds a wrong one.

    python3 figures_test.py RUN_FIGURES BUILD
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = sys.argv.pop()
FIGURES = pathlib.Path(sys.argv.pop())
IMAGES = FIGURES.parent.parent / "docs" / "images"


class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.images = pathlib.Path(folder.name) / "images"
        shutil.copytree(IMAGES, self.images)

    def faults(self):
        run = subprocess.run([FIGURES, "--check", "--build", BUILD, "--images", self.images], capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.returncode, 1 if run.stderr else 0)
        return run.stderr.splitlines()

    def test_all_are_what_comes_out(self):
        self.assertEqual(self.faults(), [])

    def test_what_is_not_is_named(self):
        moved, renamed = self.images / "limit-figure-3.svg", self.images / "limit-figure-4.svg"
        text = moved.read_text()
        place = re.search(r'<circle|<line class="bar tension|<line class="bar compression', text).start()
        moved.write_text(text[:place] + re.sub(r'x1="(\d+)', lambda its: f'x1="{int(its[1]) + 3}', text[place:], count=1))
        renamed.rename(self.images / "another.svg")
        found = self.faults()
        self.assertEqual(len(found), 3, found)
        self.assertRegex(found[0], "another.svg: nothing draws it")
        self.assertRegex(found[1], r"limit-figure-3.svg: line \d+: \d+.\d+; expected \d")
        self.assertRegex(found[2], "limit-figure-4.svg: is missing")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
