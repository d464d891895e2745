"""Images of the pages: those of the repository are what tools/figures draws, which also draws all that the site shows.

    python3 figures_test.py FIGURES BUILD
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

    def test_images_of_the_repository_are_up_to_date(self):
        self.assertEqual(self.faults(), [])

    def test_outdated_and_unknown_images_are_reported(self):
        image = self.images / "wedge-in-groove.svg"
        text = image.read_text()
        shutil.copy(image, self.images / "another.svg")
        image.write_text(re.sub(r' x1="(\d+)', lambda its: f' x1="{int(its[1]) + 3}', text, count=1))
        self.assertNotEqual(image.read_text(), text)
        found = self.faults()
        self.assertEqual(len(found), 3, found)
        self.assertRegex(found[0], "another.svg: nothing draws it")
        self.assertRegex(found[1], r"wedge-in-groove.svg: line \d+: \d+.*; expected \d")
        self.assertRegex(found[2], "6 images in docs/; expected at most 5")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
