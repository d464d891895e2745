"""Comparison of answers: for each part one pair that agrees and one that does not, and the ends of a run with
commands that crash, refuse or never decide. No answer is computed, so the test needs no kusabi.

    python3 relations_test.py
"""

import ast
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import agreement  # noqa: E402 (below the path of the folder around)
import commands  # noqa: E402
import positions  # noqa: E402
from agreement import Disagreement, RoundedAnew, Undecided  # noqa: E402
from checks import Finding  # noqa: E402
from known import Known  # noqa: E402
from questions import Answer, Asker, Question  # noqa: E402
from relation import Changed  # noqa: E402
from sources import Case  # noqa: E402
from table import Unfit  # noqa: E402


def changed(**expected):
    return Changed({}, original=[0, 1], **expected)


EXACT = changed()
ROUNDED = changed(exact=False, error=4e-16)


def answer(result, code=0, standing="proved"):
    return Answer(code, "said", {"reason": "searched", "standing": standing, **result}, ["a", "b"])


def pattern(contact, margin=0.1):
    separated = [name for name in "ab" if name not in contact]
    return {"contact": list(contact), "separated": separated, "state": "feasible" if margin else "flat",
            "margin": margin}


def patterns(*found, count=None, **how):
    return answer({"count": count or len(found), "patterns": found}, **how)


def rays(*contacts, count=7):
    return answer({"count": count, "cones": [{**pattern(contact), "idle": []} for contact in contacts]})


def bracket(lower, upper, proved=True):
    ends = {"lower": (lower, True), "upper": (upper, proved)}
    return {end: None if value is None else {"value": value, "standing": "proved" if known else "computed"}
            for end, (value, known) in ends.items()}


def critical(*ends):
    return answer({"critical_friction": bracket(*ends)})


def sweep(counts):
    return answer({"points": [{"mu": mu, "count": count} for mu, count in counts.items()]})


def hold(*intervals, proved=True, code=0, **more):
    listed = [{"standing": "proved" if proved else "computed", "below": bracket(None, low), "above": bracket(high, None)}
              for low, high in intervals]
    return answer({"intervals": listed, **more}, code)


def holding(*ends):
    return answer({"holding_friction": bracket(*ends)})


def grip(least, most):
    sums = {"held": True, "standing": "proved", "minimum": bracket(None, least), "maximum": bracket(most, None),
            "unbounded": most is None}
    return hold((0.0, 1.0), grip=sums)


def limit(low=-1.0, high=2.0, nominal=2.0, **more):
    return answer({"kind": "load-interval", "nominal_interval": [low, high], "nominal": nominal, **more})


def guaranteed(low, high, empty=False):
    return {"uncertain": {"half_width": 1.0}, "carried_at_none": "proved" if empty else None,
            "minimum": bracket(low, low + 1e-9), "maximum": bracket(high, high + 1e-9)}


def loss(lower, upper, fatal=False):
    return answer({"kind": "member-loss", "fatal": "proved" if fatal else None, "factor": bracket(lower, upper)})


def mip(objective, bound, said="optimal", code=0):
    known = bound is not None
    return answer({"state": said, "objective": objective,
                   "bound": {"value": bound, "standing": "proved"} if known else None}, code)


#: (part, command, effect of the change, answer, answers that agree with it, answers that do not)
COMPARED = [
    ("crash", "patterns", EXACT, patterns(), [patterns()], [Answer(-11, ""), Answer(134, "")]),
    ("crash", "patterns", EXACT, Answer(-11, ""), [], [Answer(-11, "")]),
    ("exit code", "patterns", EXACT, patterns(), [patterns()], [Answer(1, ""), Answer(2, "")]),
    ("standing", "limit", EXACT, limit(), [limit()], [
        answer({**limit().result, "standing": "computed"})]),
    ("cones", "patterns", EXACT, patterns(pattern("a")), [patterns(pattern("a"))],
     [patterns(pattern("b")), patterns(pattern("a", None)), patterns(pattern("a"), pattern("b", None))]),
    ("cones", "patterns", ROUNDED, patterns(pattern("a")), [patterns(pattern("a"))],
     [patterns(pattern("a"), pattern("b"))]),
    ("count", "patterns", EXACT, patterns(pattern("a"), count=3), [patterns(pattern("a"), count=3)],
     [patterns(pattern("a"), count=4)]),
    ("margins", "patterns", EXACT, patterns(pattern("a")), [patterns(pattern("a", 0.1001))],
     [patterns(pattern("a", 0.101))]),
    ("cones", "rays", EXACT, rays("a", "b"), [rays("b", "a")], [rays("a"), rays("a", "ab")]),
    ("count", "rays", EXACT, rays("a"), [rays("a")], [rays("a", count=8)]),
    ("bracket", "critical", EXACT, critical(0.5, 0.6), [critical(0.55, 0.7)],
     [critical(0.7, 0.8), critical(0.5, None)]),
    ("bracket", "critical", ROUNDED, critical(0.5, 0.6), [critical(0.5, 0.6)], [critical(0.7, 0.8)]),
    ("count", "sweep", EXACT, sweep({0.5: 1, 1.0: 2}), [sweep({0.5: 1, 1.0: 2})], [sweep({0.5: 1, 1.0: 3})]),
    ("points", "sweep", EXACT, sweep({0.5: 1, 1.0: 2}), [sweep({0.5: 1, 1.0: 2})],
     [sweep({0.5: 1}), sweep({0.5: 1, 1.5: 2}), sweep({0.5: 1, 1.0: 2, 1.5: 2})]),
    ("bracket", "hold", EXACT, holding(0.2, 0.3), [holding(0.2, 0.3)], [holding(0.4, 0.5)]),
    ("intervals", "hold", EXACT, hold((0.0, None)), [hold((0.0, None)), hold((-3.0, -3.0), (0.0, None))],
     [hold((0.0, 5.0)), hold((None, None)), hold(), hold((0.0, 1.0), (2.0, None))]),
    ("intervals", "hold", changed(slope=-1.0), hold((0.0, None)), [hold((None, 0.0))], [hold((0.0, None))]),
    ("intervals", "hold", ROUNDED, hold((0.0, 1.0)), [hold((0.0, 1.0))], [hold((0.0, 2.0))]),
    ("intervals", "hold", EXACT, hold((0.0, 1.0)), [], [hold((0.0, 2.0), code=3)]),
    ("grip", "hold", EXACT, grip(1.0, 2.0), [grip(1.0, 2.0)],
     [grip(1.0, 3.0), grip(1.0, None), hold((0.0, 1.0))]),
    ("grip", "hold", EXACT, hold((0.0, 1.0)), [hold((0.0, 1.0))], [grip(1.0, 2.0)]),
    ("grip", "hold", changed(force=1e-6), grip(1.0, 2.0), [grip(1e-6, 2e-6)], [grip(1e-6, 2.1e-6)]),
    ("nominal_interval", "limit", EXACT, limit(), [limit()], [limit(low=-1.1), answer({"kind": "load-interval", "nominal": 2.0})]),
    ("nominal", "limit", EXACT, limit(), [limit()], [limit(nominal=2.1), limit(nominal=None)]),
    ("guaranteed_interval", "limit", EXACT, limit(**guaranteed(-0.5, 1.0)), [limit(**guaranteed(-0.5, 1.0))],
     [limit(), limit(**guaranteed(-0.5, 1.0, empty=True))]),
    ("guaranteed_interval, upper", "limit", EXACT, limit(**guaranteed(-0.5, 1.0)),
     [limit(**guaranteed(-0.5, 1.0))], [limit(**guaranteed(-0.5, 1.1))]),
    ("member loss", "limit", EXACT, loss(0.5, 0.6), [loss(0.5, 0.6)],
     [loss(0.7, 0.8), loss(0.5, 0.6, fatal=True), limit()]),
    ("answer", "mip", EXACT, mip(3.0, 3.0), [mip(3.0, 3.0)], [mip(None, None, "infeasible")]),
    ("optimum", "mip", EXACT, mip(3.0, 3.0), [mip(3.0, 3.0)], [mip(2.0, 2.0)]),
    ("bound", "mip", EXACT, mip(3.0, 3.0), [], [mip(4.0, 3.5, code=3)]),
]

#: (command, answer, answer that rounding may leave of it where directions are special)
ROUNDING_DECIDES = [
    ("rays", rays("a", "b"), rays("a")),
    ("rays", rays("a"), rays("a", count=8)),
    ("sweep", sweep({0.5: 1}), sweep({0.5: 2})),
    ("critical", critical(0.5, 0.5, False), critical(0.6, 0.7)),
    ("hold", holding(0.5, 0.5, False), holding(0.6, 0.7)),
    ("hold", hold((0.0, 1.0), proved=False), hold((0.0, 2.0))),
]


def compare(command, effect, one, other):
    agreement.compare(Question(command), one, other, effect)


class Answers(unittest.TestCase):

    def test_answers_that_agree(self):
        for part, command, effect, one, agreeing, _ in COMPARED:
            for other in agreeing:
                with self.subTest(part=part, command=command, other=other):
                    compare(command, effect, one, other)

    def test_answers_that_differ(self):
        for part, command, effect, one, _, different in COMPARED:
            for other in different:
                with self.subTest(part=part, command=command, other=other):
                    with self.assertRaises(Disagreement) as found:
                        compare(command, effect, one, other)
                    self.assertEqual(found.exception.part, part)
                    self.assertNotIsInstance(found.exception, RoundedAnew)

    def test_rounding_decides_flat_states_only(self):
        for command, one, other in ROUNDING_DECIDES:
            with self.subTest(command=command):
                with self.assertRaises(RoundedAnew):
                    compare(command, ROUNDED, one, other)
                with self.assertRaises(Disagreement) as found:
                    compare(command, EXACT, one, other)
                self.assertNotIsInstance(found.exception, RoundedAnew)

    def test_patterns_at_a_limit_are_open_where_coordinates_are_rounded(self):
        with self.assertRaises(Undecided):
            compare("patterns", ROUNDED, patterns(pattern("a")), patterns(pattern("a"), pattern("b", 1e-9)))

    def test_each_part_has_a_pair(self):
        """Parts are the words that agreement.py gives to a disagreement."""
        calls = [each for each in ast.walk(ast.parse((HERE / "agreement.py").read_text(encoding="utf-8")))
                 if isinstance(each, ast.Call) and len(each.args) >= 2
                 and not isinstance(each.func, ast.Attribute)]
        raised = {each.args[0].value for each in calls
                  if isinstance(each.args[0], ast.Constant) and isinstance(each.args[0].value, str)}
        self.assertLess({"crash", "cones", "bracket"}, raised)
        self.assertEqual(raised - {part for part, *_ in COMPARED}, set())


class Commands(unittest.TestCase):
    """Relations between commands, whose answers are given by their command."""

    CASE = Case("pressed wedge 1/1", "pressed wedge",
                {"dimension": 2, "loads": [{"kind": kind, "nodes": ["a"], "force": [0.0, -1.0]}
                                           for kind in ("dead", "reference")]}, [])

    def check(self, relation, answers):
        rng = mock.Mock(**{"uniform.return_value": 0.25, "sample": lambda items, count: items[:count]})
        asked = lambda question, table=None, *more: answers(question, table)
        relation(asked, rng, self.CASE, 1.0)

    def test_cones_of_rays_are_compared_and_not_only_counted(self):
        given = {"patterns": patterns(pattern("a")), "rays": rays("a")}
        self.check(commands.rays_of_patterns, lambda question, _: given[question.command])
        given["rays"] = rays("b")
        with self.assertRaisesRegex(Disagreement, "only on one side"):
            self.check(commands.rays_of_patterns, lambda question, _: given[question.command])

    def test_more_friction_holds_intervals_without_an_end(self):
        at = {1.0: hold((0.0, None)), 1.5: hold((0.0, None))}
        self.check(commands.more_friction, lambda question, _: at[question.mu])
        at[1.5] = hold((0.0, 5.0))
        with self.assertRaisesRegex(Disagreement, "inf"):
            self.check(commands.more_friction, lambda question, _: at[question.mu])

    def test_ends_of_factors_without_a_comparison_are_open(self):
        held = {True: hold((None, None)), False: hold(), None: hold(code=3)}

        def with_dead_load(state):
            return lambda _, table: hold((None, None)) if table is None else held[state]

        self.check(commands.ends_of_factors, with_dead_load(True))
        with self.assertRaises(Disagreement):
            self.check(commands.ends_of_factors, with_dead_load(False))
        with self.assertRaises(Undecided):
            self.check(commands.ends_of_factors, with_dead_load(None))

    def test_the_factor_zero_without_a_comparison_is_open(self):

        def at_coefficients(answer):
            return lambda question, _: holding(0.5, 0.5) if question.mu is None else answer(question.mu)

        self.check(commands.zero_and_dead_load, at_coefficients(lambda mu: hold((-1.0, 1.0)) if mu > 0.5
                                                                else hold()))
        with self.assertRaises(Disagreement):
            self.check(commands.zero_and_dead_load, at_coefficients(lambda mu: hold()))
        with self.assertRaises(Undecided):
            self.check(commands.zero_and_dead_load, at_coefficients(lambda mu: hold((0.0, 1.0))))

    def test_sums_without_a_comparison_are_open(self):

        def with_sums(beyond):
            return lambda question, _: grip(1.0, 2.0) if question.total is None else beyond

        self.check(commands.sums_of_reactions, with_sums(hold()))
        with self.assertRaises(Disagreement):
            self.check(commands.sums_of_reactions, with_sums(hold((-1.0, 1.0))))
        with self.assertRaises(Undecided):
            self.check(commands.sums_of_reactions, with_sums(hold(code=3)))


class Moved(unittest.TestCase):
    """The distance grows with the structure, so the rounding does not."""

    @staticmethod
    def moved(size, near=1.0):
        table = {"nodes": {"a": [0.0, 0.0], "b": [0.3 * size, size], "c": [0.3 * size * near, size * near]}}
        rng = mock.Mock(**{"choice.return_value": 1.0})
        return positions._moved(1e6)(rng, {"dimension": 2, **table}, None)

    def test_error_does_not_depend_on_the_size(self):
        for size in (0.01, 1.0, 1234.5):
            changed = self.moved(size)
            self.assertEqual(changed.error, 1e6 * positions.ROUNDING)
            self.assertTrue(1e6 <= changed.table["nodes"]["a"][0] / size <= 4e6)

    def test_nodes_closer_than_the_rounding_are_left_out(self):
        with self.assertRaises(Unfit):
            self.moved(1.0, near=1 + 1e-9)


class KnownFailures(unittest.TestCase):
    LINE = "turned | hold | grip | grid 1/5"
    KEY = ("turned", "hold", "grid 1/5")

    def known(self, families=""):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "known.toml"
            path.write_text(f'[[failure]]\nlines = ["{self.LINE}"]\nfamilies = [{families}]\n')
            return Known(path)

    def test_a_line_is_obsolete_if_its_check_agrees_or_does_not_apply(self):
        for outcome, obsolete in (("agree", True), ("unfit", True), ("different", False),
                                  ("open: no answer in time", False)):
            with self.subTest(outcome=outcome):
                lines = self.known().obsolete({self.KEY: outcome})
                self.assertEqual(lines, [tuple(self.LINE.split(" | "))] if obsolete else [])

    def test_a_family_needs_a_line(self):
        known = self.known('"turned | hold | grip | grid", "turned | hold | grip | rods"')
        self.assertEqual(known.obsolete({self.KEY: "different"}), [("turned", "hold", "grip", "rods")])
        self.assertIn(("turned", "hold", "grip", "grid"), known.obsolete({self.KEY: "agree"}))

    def test_a_family_excuses_one_part_only(self):
        known = self.known('"turned | hold | grip | grid"')
        finding = lambda part: Finding(("grid 1/6", "grid", "turned", "hold"), part, "", [])
        self.assertTrue(known.expects(finding("grip")))
        self.assertFalse(known.expects(finding("crash")))


class Runs(unittest.TestCase):
    """Whole runs with scripts in place of the command."""

    def command(self, body):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "command"
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)
        return path

    def printed(self, body):
        """Output of a run that has to fail."""
        done = subprocess.run([
            sys.executable, HERE, "--kusabi", self.command(body), "--families", "girder", "--count", "16",
            "--known", os.devnull
        ], capture_output=True, encoding="utf-8")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        return done.stdout

    def test_a_crash_on_both_sides_is_different(self):
        printed = self.printed("kill -s SEGV $$")
        self.assertIn(" | crash | ", printed)
        self.assertIn("0 agree, 0 open, 0 known, ", printed)

    def test_a_refusal_of_generated_structures_is_different(self):
        printed = self.printed("exit 2")
        self.assertIn(" | refused | ", printed)
        self.assertIn("0 agree, 0 open, 0 known, ", printed)

    def test_a_command_that_decides_nothing_fails(self):
        printed = self.printed("exit 3")
        self.assertIn(" 0 known, 0 different", printed)
        self.assertIn("fewer than half of the checks agree", printed)

    def test_defaults_of_the_caller_do_not_count(self):
        command = self.command('echo "defaults: $KUSABI_CONFIG"')
        with mock.patch.dict(os.environ, {"KUSABI_CONFIG": "of-the-caller.toml"}):
            self.assertEqual(Asker(command, command.parent).run(), (0, "defaults: \n"))


if __name__ == "__main__":
    unittest.main()
