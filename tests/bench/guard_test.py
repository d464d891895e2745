"""Tests of bench/guard: the comparison with its table, the counts that it reads, and its exit codes.

    python3 guard_test.py BENCH_GUARD
"""
import contextlib
import io
import pathlib
import re
import runpy
import sys
import tempfile
import unittest
from unittest import mock

GUARD = pathlib.Path(sys.argv.pop()).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(GUARD))
import measure  # noqa: E402
import table  # noqa: E402
from calls import Row, bracket  # noqa: E402
from rows import DAILY, ROWS  # noqa: E402

FACTS = {"compiler": "GCC 12", "processor": "x86_64 with AVX2"}
ROW = Row("small", call=None, answer=None, expected="solved, 27 found")
AMOUNTS = {"instructions": 1_000_000, "allocated": 50_000, "heap_peak": 4_000, "result": 900}
COUNTS = {"ranks.opened": 237, "blocks.bound_programs": 540}


def run(answer="exit code 0, solved, 27 found", counts=COUNTS, **amounts):
    return table.Measurement(answer, AMOUNTS | amounts, counts)


class Comparison(unittest.TestCase):
    def setUp(self):
        self.table = table.Table(FACTS, {})
        self.table.renew(ROW.name, run(), "first measurement")

    def failures(self, measurement, same_machine=True):
        return table.failures(ROW, self.table, measurement, same_machine)

    def test_equal_runs_pass(self):
        self.assertEqual(self.failures(run()), [])

    def test_five_percent_of_instructions_pass_and_six_fail_in_both_directions(self):
        for passes, fails, change in ((1_050_000, 1_060_000, "+6.0"), (950_000, 940_000, "-6.0")):
            self.assertEqual(self.failures(run(instructions=passes)), [])
            self.assertEqual(self.failures(run(instructions=fails)),
                             [f"small: instructions 1,000,000 before, {fails:,} now ({change} %; at most 5 % "
                              "more or less)"])

    def test_an_amount_that_appears_or_disappears_fails_on_any_machine(self):
        more, fewer = run(certificate=700), run()
        del fewer.amounts["heap_peak"]
        for same_machine in (True, False):
            self.assertEqual(self.failures(more, same_machine), ["small: certificate none before, 700 now"])
            self.assertEqual(self.failures(fewer, same_machine), ["small: heap_peak 4,000 before, none now"])

    def test_one_node_more_or_less_fails(self):
        for nodes in (236, 238):
            self.assertEqual(self.failures(run(counts=COUNTS | {"ranks.opened": nodes})),
                             [f"small: ranks.opened 237 before, {nodes} now"])

    def test_a_count_that_appears_or_disappears_fails(self):
        self.assertEqual(self.failures(run(counts=COUNTS | {"ranks.escalated": 1})),
                         ["small: ranks.escalated 0 before, 1 now"])
        self.assertEqual(self.failures(run(counts={"ranks.opened": 237})),
                         ["small: blocks.bound_programs 540 before, 0 now"])

    def test_a_wrong_answer_or_exit_code_fails(self):
        for answer in ("exit code 0, solved, 26 found", "exit code 3, solved, 27 found"):
            self.assertEqual(self.failures(run(answer)),
                             [f'small: the answer is "{answer}", expected "exit code 0, solved, 27 found"'])

    def test_more_memory_and_longer_files_fail(self):
        self.assertEqual(len(self.failures(run(allocated=60_000, heap_peak=5_000, result=1_000))), 3)

    def test_on_another_machine_counts_and_files_are_judged_and_instructions_are_not(self):
        other = run(counts=COUNTS | {"ranks.opened": 238}, instructions=2_000_000, allocated=60_000,
                    heap_peak=5_000, result=1_000)
        self.assertEqual([line.split()[1] for line in self.failures(other, same_machine=False)],
                         ["ranks.opened", "result"])

    def test_a_row_without_an_entry_fails(self):
        self.assertEqual(table.failures(ROW, table.Table(FACTS, {}), run(), True),
                         ["small: not in the table"])


class Files(unittest.TestCase):
    def test_a_table_is_read_as_it_was_written_with_a_line_for_each_row(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "table.json"
            written = table.Table(FACTS, {})
            for name in ("b", "a"):
                written.renew(name, run(), "first measurement")
            written.write(path)
            self.assertEqual(table.Table.read(path), written)
            lines = [line.strip()[:4] for line in path.read_text().splitlines()]
            self.assertLess(lines.index('"a":'), lines.index('"b":'))

    def test_the_first_different_fact_is_named(self):
        known = table.Table(FACTS, {})
        self.assertEqual(known.other_facts(FACTS), "")
        self.assertEqual(known.other_facts(FACTS | {"compiler": "GCC 13"}),
                         "compiler is GCC 13, but GCC 12 in the table")

    def test_the_committed_table_has_each_daily_row_and_no_unknown_one(self):
        measured = set(table.Table.read().rows)
        self.assertLessEqual(measured, {row.name for row in ROWS})
        self.assertLessEqual({row.name for row in DAILY}, measured)


class Page(unittest.TestCase):
    def test_each_row_supports_a_claim_of_bench_readme(self):
        page = (GUARD.parent / "README.md").read_text()
        last_cells = re.findall(r"^\|.*\| `([\w-]+)` \|$", page, re.MULTILINE)
        self.assertEqual(sorted(last_cells), sorted(row.name for row in ROWS))


class Reading(unittest.TestCase):
    def test_counts_are_summed_over_ranks_and_searches_and_times_are_left_out(self):
        ranks = [{"opened": 3, "seconds": 0.5, "requests": 0}, {"opened": 4, "seconds": 1.5, "requests": 0}]
        searches = [{"phase": "dive", "friction": 0.5, "programs": 2}]
        blocks = [{"bound_programs": 5}, {"bound_programs": 6}]
        result = {"statistics": {"ranks": ranks, "searches": searches},
                  "result": {"count": 9, "wide": True, "blocks": blocks}}
        self.assertEqual(measure.work(result),
                         {"ranks.opened": 7, "searches.programs": 2, "blocks.bound_programs": 11})

    def test_a_bracket_must_be_proved_narrow_and_contain_the_truth(self):
        def said(low, high, proved=True):
            ends = {"lower": {"value": low, "standing": "proved" if proved else "computed"},
                    "upper": {"value": high, "standing": "proved"}}
            return bracket("ends", 0.5)({"status": "solved", "result": {"ends": ends}}, "")
        right = "solved, proved to 1e-06, 0.5"
        self.assertEqual(said(0.5 - 1e-7, 0.5 + 1e-7), right)
        for wrong in (said(0.5 - 1e-7, 0.5 + 1e-7, proved=False), said(0.499, 0.501), said(0.6, 0.6)):
            self.assertNotEqual(wrong, right)


class Measuring(unittest.TestCase):
    """A row whose two runs, as it is and under valgrind, are replaced."""

    def measured(self, *codes):
        def run_with(words, folder, environment):
            code = next(ends)
            for word in words:
                if word.startswith("--log-file="):
                    pathlib.Path(word.split("=")[1]).write_text("I   refs:      1,234\n")
            return code, "value 7", "heap total: 20, heap peak: 10", mock.Mock(ru_utime=0.1, ru_stime=0.1)

        ends = iter(codes)
        row = Row("seven", lambda kusabi, folder: [kusabi], lambda result, printed: printed, "value 7")
        with mock.patch.object(measure, "_run", run_with):
            return measure.measure(row, "kusabi")

    def test_equal_exit_codes_give_answer_and_amounts(self):
        found = self.measured(0, 0)
        self.assertEqual(found.answer, "exit code 0, value 7")
        self.assertEqual(found.amounts, {"instructions": 1234, "allocated": 20, "heap_peak": 10})

    def test_another_exit_code_under_valgrind_is_an_error(self):
        with self.assertRaisesRegex(measure.GuardError, "exit code -11 under valgrind, 0 without it"):
            self.measured(0, -11)


class Command(unittest.TestCase):
    """The whole command with a table of its own and measurements that are given to it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "table.json"
        self.row = next(row for row in ROWS if row.name == "readme-patterns")
        written = table.Table(FACTS, {})
        written.renew(self.row.name, run(), "first measurement")
        written.write(self.path)

    def guard(self, measurement, *words, facts=FACTS):
        """The exit code and the printed text."""
        out = io.StringIO()
        read, write = table.Table.read, table.Table.write
        with (mock.patch.object(table.Table, "read", lambda: read(self.path)),
              mock.patch.object(table.Table, "write", lambda own: write(own, self.path)),
              mock.patch.object(measure, "measure", lambda row, kusabi: measurement),
              mock.patch.object(measure, "facts", lambda kusabi: facts),
              mock.patch.object(measure, "require_valgrind"), contextlib.redirect_stderr(out),
              mock.patch.object(sys, "argv", ["guard", *words]), contextlib.redirect_stdout(out),
              self.assertRaises(SystemExit) as end):
            runpy.run_path(str(GUARD), run_name="__main__")
        return end.exception.code, out.getvalue()

    def test_passes_when_equal_and_fails_on_one_node_more_with_the_way_to_renew(self):
        self.assertEqual(self.guard(run(), "--row", self.row.name)[0], 0)
        code, said = self.guard(run(counts=COUNTS | {"ranks.opened": 238}), "--row", self.row.name)
        self.assertEqual(code, 1)
        self.assertIn("readme-patterns: ranks.opened 237 before, 238 now", said)
        self.assertIn('--renew readme-patterns --reason "..."', said)

    def test_a_renewed_row_passes_and_keeps_its_reason(self):
        other = run(counts=COUNTS | {"ranks.opened": 238})
        self.assertEqual(self.guard(other, "--renew", self.row.name, "--reason", "another rule")[0], 0)
        self.assertEqual(table.Table.read(self.path).rows[self.row.name]["reason"], "another rule")
        self.assertEqual(self.guard(other, "--row", self.row.name)[0], 0)

    def test_the_last_sentence_says_whether_instructions_were_judged(self):
        self.assertIn("All 1 rows are as in the table.\n", self.guard(run(), "--row", self.row.name)[1])
        code, said = self.guard(run(instructions=2_000_000), "--row", self.row.name,
                                facts=FACTS | {"compiler": "GCC 13"})
        self.assertEqual(code, 0)
        self.assertIn("Answers, counts and files of all 1 rows are as in the table. Instructions and bytes "
                      "of the heap were not judged: compiler is GCC 13, but GCC 12 in the table.\n", said)

    def test_a_program_that_is_not_built_is_an_error(self):
        code, said = self.guard(run(), "--row", "engine-knapsack", "--kusabi", "/nowhere/kusabi")
        self.assertEqual(code, 2)
        self.assertIn("/nowhere/bench/guard/guard_knapsack is not built", said)

    def test_against_another_command_a_wrong_answer_fails_and_programs_of_one_are_left_out(self):
        words = ("--row", self.row.name, "engine-knapsack",
                 "--kusabi", "/nowhere/new", "--against", "/nowhere/old")
        code, said = self.guard(run(), *words)
        self.assertEqual(code, 0)
        self.assertIn("engine's example is left out", said)
        code, said = self.guard(run("exit code 0, solved, 26 found"), *words)
        self.assertEqual(code, 1)
        self.assertIn('the answer is "exit code 0, solved, 26 found"', said)

    def test_a_wrong_answer_is_not_renewed(self):
        before = self.path.read_text()
        wrong = run("exit code 1, failed")
        self.assertEqual(self.guard(wrong, "--renew", self.row.name, "--reason", "none")[0], 1)
        self.assertEqual(self.path.read_text(), before)


if __name__ == "__main__":
    unittest.main()
