"""tools/papers finds a wrong figure in docs/papers.md.

    python3 papers_test.py PAPERS BUILD
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

BUILD = sys.argv.pop()
PAPERS = pathlib.Path(sys.argv.pop())
RIGHT = "| 25 | 25 | same |"


class Papers(unittest.TestCase):
    def check(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".md") as page:
            page.write(text)
            page.flush()
            return subprocess.run([PAPERS, "--quick", "--check", "--build", BUILD, "--page", page.name],
                                  capture_output=True, text=True, check=False)

    def setUp(self):
        self.page = (PAPERS.parent.parent / "docs" / "papers.md").read_text()

    def test_a_wrong_figure_is_reported_alone(self):
        self.assertEqual(self.page.count(RIGHT), 1)
        run = self.check(self.page.replace(RIGHT, "| 25 | 24 | same |"))
        self.assertEqual(run.returncode, 1)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"wedged-plane: '\| Figures 8, 9: .*\| 25 \| 24 \| same \|'; expected '.*\| 25 \| 25 \| same \|'")

    def test_a_table_without_a_computation_is_refused(self):
        run = self.check(self.page.replace("figures: seconds", "figures: minutes"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("expected [", run.stderr)


if __name__ == "__main__":
    unittest.main()
