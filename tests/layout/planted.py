"""Base class of the tests of scripts in .ci: a small source tree with violations."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = sys.argv.pop()  # the script


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)

    def check(self):
        """The script's exit code and the lines that it prints."""
        run = subprocess.run([sys.executable, CHECK, self.root], capture_output=True, text=True, check=False)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout.splitlines()
