"""Calls of the pages, compared with their output on the pages; tools/docs finds a wrong page, and corrects it.

    python3 docs_test.py DOCS BUILD MPIRUN
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

MPIRUN = sys.argv.pop()
BUILD = sys.argv.pop()
DOCS = pathlib.Path(sys.argv.pop())
ROOT = DOCS.parent.parent
PAGE = """# A page

<a id="place"></a>See [here](#a-page), [there](#place), [and there](other.md#other-page), with `--mu`.

| a | b |
|---|---|
| 1 | `x\\|y` |

```sh
kusabi patterns examples/two-bars.toml --mu 2.5 --output two.json
```
```text
…
    1   5.000e-01  tip
…
Yes, it can stick …
```

<!-- exit code: 2 -->
```sh
kusabi patterns nowhere.toml --mu 2
```

    kusabi draw two.json --output two.svg

![two bars](two.svg)

<!-- on the site: ![two bars, deformed](images/two.svg) -->

<!-- run instead, this takes a year: echo a year -->
    mpirun -np 1000 kusabi patterns examples/two-bars.toml --mu 1000

    a year

<!-- not run: nobody knows what it does -->
    run/nothing

<!-- needs: no-such-program -->
    kusabi patterns no-such-file.toml --mu 1

<!-- printed by: sed -n 2,3p two.txt -->
<!-- run before: printf '1\\n2.500\\n3\\n' > two.txt -->

    2.501
    3

<!-- printed by:
head -n 1 two.txt
echo end
-->

    1
    end
"""


class Docs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page = pathlib.Path(folder.name) / "page.md"
        self.picture = self.page.with_name("two.svg")
        self.page.with_name("other.md").write_text("# `Other` page\n")

    def call(self, *words):
        run = subprocess.run([DOCS, *words, "--build", BUILD, "--mpirun", MPIRUN], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1 if run.stderr else 0)
        return run.stderr.splitlines()

    def faults(self, text):
        self.page.write_text(text)
        return self.call("--check", self.page)

    def made(self):
        """A correct page, and its picture."""
        self.page.write_text(PAGE)
        self.assertEqual(self.call(self.page), [])
        self.assertEqual(self.page.read_text(), PAGE)

    def found(self, old, new):
        """The one fault of a changed page."""
        self.assertEqual(PAGE.count(old), 1)
        faults = self.faults(PAGE.replace(old, new))
        self.assertEqual(len(faults), 1, faults)
        return faults[0]

    def test_pages_have_the_output_of_their_calls(self):
        self.assertEqual(self.call("--check"), [])

    def test_each_fault_of_a_page_is_reported(self):
        self.made()
        self.assertEqual(self.faults(PAGE), [])
        for old, new, what in (
                ("5.000e-01", "5.100e-01", "page.md:13: '5.100e-01 tip"), ("01  tip", "01  all", "page.md:13: 'all"),
                ("…\nYes, it can", "Yes, it can", "page.md:13: "), ("stick …", "stick", "page.md:13: 'nothing'; expected"),
                ("2.501", "2.5100", "page.md:"), ("    3\n", "    4\n", "'4'; expected '3'"),
                ("code: 2", "code: 0", "exit code 2; expected 0: nowhere.toml"), ("a year -->", "a month -->", "'year'; expected 'month'"),
                ("printed by:\n", "printed by\n", "page.md:47: comment is not read; expected <!-- printed by: "),
                ("head -n 1", "head -n 2", "'end'; expected '2.500 end'"),
                ("needs: no-such-program", "needs: bash", "exit code 2; expected 0: no-such-file.toml"),
                ("not run: nobody", "note: nobody", "exit code 127; expected 0: "),
                ("(#a-page)", "(#a-side)", "page.md:3: link to '#a-side': there is no such heading"),
                ("(#place)", "(#places)", "link to '#places'"), ("#other-page", "#page", "link to 'other.md#page'"),
                ("with `--mu`", "with `--my 1`", "page.md:3: '--my 1': kusabi has no option --my"),
                ("other.md#", "others.md#", "there is no such file"), ("| `x", "| 2 | `x", "3 cells; expected 2"),
                ("|---|---|\n", "", "a row without a table")):
            with self.subTest(new):
                self.assertIn(what, self.found(old, new))

    def test_an_outdated_or_missing_picture_is_reported(self):
        self.made()
        self.picture.write_text(self.picture.read_text().replace("<svg", "<svg class='old'", 1))
        self.assertIn("two.svg: line 2: ", self.faults(PAGE)[0])
        self.picture.unlink()
        self.assertIn("two.svg: is missing", " ".join(self.faults(PAGE)))

    def test_output_is_rewritten_with_its_abridgements(self):
        self.page.write_text(PAGE.replace("5.000e-01  tip", "5.100e-01  all").replace("2.501", "2.9"))
        self.call(self.page)
        self.assertEqual(self.page.read_text(), PAGE.replace("2.501", "2.500"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
