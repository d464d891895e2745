"""Differences are found and sorted into the right kind: in texts of each format, and from end to end with a
command that is broken on purpose.

    python3 sorting_test.py KUSABI
"""

import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from calls import all_calls, cases_without_call
from comparing import NUMBERS, STRUCTURE, WORDS, compare, compare_summaries, summary
from reading import read

KUSABI = str(pathlib.Path(sys.argv.pop()).resolve()) if len(sys.argv) > 1 else ""
HERE = pathlib.Path(__file__).resolve().parent

RESULT = {"result": {"count": 2,
                     "list": [{"margin": 0.125, "contact": ["b13", "b23"]}, {"margin": None, "contact": []}],
                     "sentence": "It sticks from 0.47 on.", "proved": True}}


def changed(value, *way):
    """RESULT with another value at the place."""
    other = json.loads(json.dumps(RESULT))
    inner = other
    for key in way[:-1]:
        inner = inner[key]
    if value is None:
        del inner[way[-1]]
    else:
        inner[way[-1]] = value
    return json.dumps(other)


def vtu(numbers, packed):
    data = struct.pack(f"<{len(numbers)}d", *numbers)
    if packed:
        block = zlib.compress(data)
        header = struct.pack("<4Q", 1, 1 << 15, len(data), len(block))
        text = base64.b64encode(header) + base64.b64encode(block)
    else:
        text = base64.b64encode(struct.pack("<Q", len(data)) + data)
    compressor = ' compressor="vtkZLibDataCompressor"' if packed else ""
    return (f'<VTKFile{compressor}><DataArray type="Float64" Name="u" format="binary">'
            f'{text.decode()}</DataArray></VTKFile>')


class Sorting(unittest.TestCase):
    def check(self, name, old, new, *kinds):
        """Expects these kinds of differences, in the texts and in rows of a table. With another structure,
        rows have no other kinds."""
        one, other = read(name, old), read(name, new)
        self.assertEqual([difference.kind for difference in compare(one, other)], list(kinds))
        of_rows = [difference.kind for difference in compare_summaries(summary(one), summary(other))]
        self.assertEqual(of_rows, [STRUCTURE] if STRUCTURE in kinds else list(kinds))

    def test_result_files(self):
        text = json.dumps(RESULT)
        self.check("r.json", text, json.dumps(RESULT, indent=1))
        self.check("r.json", text, changed(3, "result", "count"), NUMBERS)
        self.check("r.json", text, changed(0.1250001, "result", "list", 0, "margin"), NUMBERS)
        self.check("r.json", text, changed("It sticks from 0.48 on.", "result", "sentence"), NUMBERS)
        self.check("r.json", text, changed("It slips from 0.47 on.", "result", "sentence"), WORDS)
        self.check("r.json", text, changed(["b13", "b24"], "result", "list", 0, "contact"), WORDS)
        self.check("r.json", text, changed(False, "result", "proved"), WORDS)
        self.check("r.json", text, changed(None, "result", "proved"), STRUCTURE)
        self.check("r.json", text, changed("2", "result", "count"), STRUCTURE)
        self.check("r.json", text, changed([], "result", "list"), STRUCTURE)
        self.check("r.json", '{"a": 1, "b": 1}', '{"b": 1, "a": 1}', STRUCTURE)
        self.check("r.json", text, text[:-1], STRUCTURE, WORDS)

    def test_largest_difference_is_named(self):
        old, new = ('{"a": [1, %s, 3]}' % number for number in ("2", "2.5"))
        line, = (difference.line for difference in compare(read("r.json", old), read("r.json", new)))
        self.assertEqual(line, "1, by up to 2.0e-01: a[1]: number 2.0 → 2.5")

    def test_tables(self):
        text = "pattern,margin,contact\n1,0.5,b13\n2,0.25,b23\n"
        self.check("t.csv", text, text.replace("0.25", "0.26"), NUMBERS)
        self.check("t.csv", text, text.replace("b23", "b24"), WORDS)
        self.check("t.csv", text, text.replace("margin", "slack"), STRUCTURE)
        self.check("t.csv", text, text + "3,0.1,b33\n", STRUCTURE)

    def test_printed_lines(self):
        text = "2 patterns\nwith a margin of 0.5\n"
        self.check("run.printed", text, text.replace("0.5", "-0.5"), NUMBERS)
        self.check("run.printed", text, text.replace("with", "without"), WORDS)
        self.check("run.printed", text, text + "and more\n", WORDS)
        self.check("run.printed", text, text.replace(" a ", "   a "))

    def test_pages_and_pictures(self):
        text = '<svg viewBox="0 0 9 9"><path d="M10,4L5,6"/><text class="t1">2 kN</text></svg>'
        self.check("p.svg", text, text.replace("L5", "L7"), NUMBERS)
        self.check("p.svg", text, text.replace("2 kN", "3 kN"), NUMBERS)
        self.check("p.svg", text, text.replace("kN", "N"), WORDS)
        self.check("p.svg", text, text.replace("t1", "t2"), WORDS)
        self.check("p.svg", text, text.replace(' class="t1"', ""), STRUCTURE)
        self.check("p.html", text, text.replace('<path d="M10,4L5,6"/>', ""), STRUCTURE)

    def test_arrays_for_paraview(self):
        for packed in (False, True):
            self.check("p.vtu", vtu([1, 2, 3], packed), vtu([1, 2, 3.5], packed), NUMBERS)
            self.check("p.vtu", vtu([1, 2, 3], packed), vtu([1, 2], packed), STRUCTURE)

    def test_certificates_and_problem_files(self):
        text = "kusabi certificate 5 contact\nname b13\nnode 0x1.8p+0 0x1p-3\n"
        self.check("certificate", text, text.replace("p-3", "p-4"), NUMBERS)
        self.check("certificate", text, text.replace("b13", "b14"), WORDS)
        self.check("certificate", text, text.replace(" 0x1p-3", ""), STRUCTURE)
        problem = '# of two bars\nname = "a"\nEA = 2.5\n'
        self.check("p.toml", problem, problem.replace("2.5", "2.6"), NUMBERS)
        self.check("p.toml", problem, problem.replace("of", "with"), WORDS)
        self.check("p.toml", problem, problem.replace("EA", "E"), STRUCTURE, WORDS)

    def test_rounding_errors_are_none_in_a_table(self):
        row = summary(read("r.json", '{"a": [1e3, 0.0, 0.1]}'))
        for text in ('{"a": [1000.0000000001, 1e-13, 0.09999999999999999]}', '{"a": [1e3, -2e-14, 0.1]}'):
            self.assertEqual(compare_summaries(row, summary(read("r.json", text))), [])
        for text in ('{"a": [1000.001, 0, 0.1]}', '{"a": [1e3, 0, 0.1000001]}', '{"a": [1e3, 1e-8, 0.1]}',
                     '{"a": [0.1, 0, 1e3]}'):
            differences = compare_summaries(row, summary(read("r.json", text)))
            self.assertEqual([difference.kind for difference in differences], [NUMBERS])


class Calls(unittest.TestCase):
    def test_each_problem_file_of_tests_cases_has_a_call(self):
        self.assertEqual(cases_without_call(all_calls()), [])


# A command that changes the outputs of the real one.
BROKEN = """\
#!/usr/bin/env python3
import pathlib, subprocess, sys
done = subprocess.run([{kusabi!r}, *sys.argv[1:]], capture_output=True, text=True)
out, code, result = done.stdout, done.returncode, pathlib.Path("result.json")
{change}
sys.stdout.write(out)
sys.stderr.write(done.stderr)
sys.exit(code)
"""


@unittest.skipUnless(KUSABI, "no command")
class Broken(unittest.TestCase):
    """The whole program, on one call."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def frozen(self, kusabi, *words):
        call = [sys.executable, str(HERE), "--kusabi", kusabi, "--only", "mip cases/objective_rhs", *words]
        done = subprocess.run(call, capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return done

    def broken(self, change):
        script = self.folder / "broken"
        script.write_text(BROKEN.format(kusabi=KUSABI, change=change))
        script.chmod(0o755)
        return script

    def test_breakages(self):
        table, kept = self.folder / "table.tsv", self.folder / "kept"
        renewed = self.frozen(KUSABI, "--renew", "--against", str(table), "--keep", str(kept))
        self.assertEqual(renewed.returncode, 0, renewed.stdout)
        for change, kind, output, row in (
                ("out = out.replace('optimum is', 'optimum was')", WORDS, "run.printed", "printed"),
                ("result.write_text(result.read_text().replace('13.0', '13.1'))", NUMBERS, "result.json",
                 "result.json"),
                ("result.write_text(result.read_text().replace('\"gap\":', '\"slack\":'))", STRUCTURE,
                 "result.json", "result.json"),
                ("result.unlink()", STRUCTURE, "result.json", "result.json"),
                ("pathlib.Path('tests/cases/tie.toml').write_text('overwritten')", STRUCTURE,
                 "tests/cases/tie.toml", "tests/cases/tie.toml"),
                ("code = 1", STRUCTURE, "all.exits", "messages"),
                ("import os; os.abort()", STRUCTURE, "all.exits", "messages")):
            script = self.broken(change)
            for against in (table, kept, *([KUSABI] if kind == WORDS else [])):
                with self.subTest(change, against=against):
                    done = self.frozen(script, "--against", str(against))
                    self.assertEqual(done.returncode, 1, done.stdout)
                    self.assertIn(f" {kind}: {row if against == table else output}: ", done.stdout)
                    self.assertEqual("did not end by itself: run: signal 6" in done.stdout, "abort" in change)
        script = self.broken("out = out.replace('13', '14')")
        for expected, code in (("words,structure", 1), ("numbers", 0)):
            done = self.frozen(script, "--against", str(kept), "--expect", expected)
            self.assertEqual(done.returncode, code, done.stdout)
        for against in (table, kept, KUSABI):
            same = self.frozen(KUSABI, "--against", str(against))
            self.assertEqual(same.returncode, 0, same.stdout)

    def test_a_crash_fails_though_both_crash_and_is_not_written(self):
        crashing = self.broken("import os; os.abort()")
        table, kept = self.folder / "table.tsv", self.folder / "kept"
        renewed = self.frozen(crashing, "--renew", "--against", str(table), "--keep", str(kept))
        self.assertEqual(renewed.returncode, 1, renewed.stdout)
        self.assertNotIn("mip", table.read_text())
        same = self.frozen(crashing, "--against", str(kept))
        self.assertIn("objective_rhs: the same\n", same.stdout)
        self.assertEqual(same.returncode, 1, same.stdout)

    def test_a_row_of_the_table_without_a_call_fails(self):
        table = self.folder / "table.tsv"
        self.frozen(KUSABI, "--renew", "--against", str(table))
        with table.open("a") as file:
            file.write("mip of nothing\tprinted\t0\t0\t0\t0.0\n")
        done = self.frozen(KUSABI, "--against", str(table))
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("a row of the table has no call: mip of nothing\n", done.stdout)

    def test_words_that_no_call_has_are_an_error(self):
        call = [sys.executable, str(HERE), "--kusabi", KUSABI, "--only", "no such call"]
        done = subprocess.run(call, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (2, 'no call has "no such call" in its name\n'))


if __name__ == "__main__":
    unittest.main()
