"""Tests of bench/hostile/forge.py: true and false statements about a block on a floor, and well-formed forgeries.

    python3 forge_test.py BENCH_HOSTILE
"""
import hashlib
import pathlib
import random
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv.pop()).resolve()))
import forge  # noqa: E402

# Its weight is 2, and the friction coefficient 0.5: a push along the floor is held up to 1.
BLOCK = """name = "block"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [1.0, 0.0]
c = [1.0, 1.0]
d = [0.0, 1.0]
[[members]]
EA = 1.0
between = [["a", "b"], ["b", "c"], ["c", "d"], ["d", "a"], ["a", "c"], ["b", "d"]]
[[contact]]
nodes = ["a"]
normal = [0.0, 1.0]
[[contact]]
nodes = ["b"]
normal = [0.0, 1.0]
"""
FORCES = [{("c", 1): -1.0, ("d", 1): -1.0}, {("a", 0): 1.0}]
HEAD = """kusabi certificate 5 contact
dimension 2
candidates 2
name a
name b
friction 0x1p-1 0x1p-1
blocks 1
block 3
stiffness
0x1p+0
0x0p+0 0x1p+0
0x0p+0 0x0p+0 0x1p+0
0x0p+0 0x0p+0 0x0p+0 0x1p+0
motions 0
"""
LOADS = "clearance 0x0p+0 0x0p+0\ndead 0x0p+0 0x0p+0 0x0p+0 0x0p+0\nreference 0x0p+0 0x0p+0 0x0p+0 0x0p+0\n"
#: The factors from 0.5 are held up to 1, and none from 1.5 on.
HOLD = HEAD + "loads 2\ncase\n" + LOADS + """total
theorems 1
none 1 2 0x1p+0 0x1.8p+0 0x0p+0 0x1p+0
bounds 0
evidence
held 1 0x1p+0 0x1p-1 3 0 -0x1p-2 -0x1p-2
infeasible 1 0 0 0x0p+0 0x0p+0
end 2
digest
"""
PATTERNS = HEAD + "loads 0\ntheorems 1\nnone 1 0\nbounds 0\nevidence\ninfeasible 1 0 0 0x0p+0 0x0p+0\nend 1\ndigest\n"
HELD = "PROVED: at friction coefficient 0.5, it can hold these factors of the reference load: from -1 to 1; "
TRUTH = forge.Truth(BLOCK, FORCES, [0.0, 0.0])


def judge(text, output="friction coefficient: 0.5\n"):
    return forge.Judge(TRUTH, forge.Certificate(text), output)


class Sentences(unittest.TestCase):
    def assert_false(self, sentence, text=HOLD, count=1):
        self.assertEqual(len(list(judge(text).false_parts(sentence))), count, sentence)

    def test_true_ones_pass(self):
        self.assert_false(HELD + "it cannot hold: up to -1.001, from 1.001 on", count=0)
        self.assert_false(HELD + "the normal reactions of every state under the dead load add up to 1.9 or more and 2.1 or less, "
                          "those of some states to 2.0 and 2.0", count=0)
        self.assert_false("PROVED: the list of 0 patterns is complete: it cannot stick", PATTERNS, 0)

    def test_false_ranges(self):
        self.assert_false(HELD.replace("to 1", "on"))
        self.assert_false(HELD + "it cannot hold: from 0.5 to 0.6, from 2 on")
        self.assert_false("PROVED: at friction coefficient 0.5, it cannot hold the dead load")

    def test_false_sums(self):
        for sums in ("2.1 or more", "1 or more and 1.9 or less", "1 or more, those of some states to 1.5 and 2"):
            self.assert_false(HELD + f"the normal reactions of every state under the dead load add up to {sums}")

    def test_states_of_the_reference_load_add_nothing_with_a_total(self):
        text = HOLD.replace("total\n", "total 0x1p+1\n")
        held = HELD.replace("0.5,", "0.5 and with normal reactions that add up to 2,")
        self.assert_false(held, text, 0)
        self.assert_false(held.replace("to 1;", "on;"), text)
        self.assert_false(HELD, text)  # says nothing of it

    def test_incomplete_lists_and_wrong_counts(self):
        self.assert_false("PROVED: the list of 3 patterns is complete", PATTERNS)
        self.assert_false("PROVED: it can stick, by 0 patterns; other patterns are not decided", PATTERNS)


class Lines(unittest.TestCase):
    def false_lines(self, text, output=""):
        certificate = forge.Certificate(text)
        return len(list(forge.Judge(TRUTH, certificate, output).false_lines(certificate.text()[1])))

    def test_states_and_nodes(self):
        self.assertEqual(self.false_lines(HOLD), 0)
        self.assertEqual(self.false_lines(HOLD.replace("held 1 0x1p+0 0x1p-1", "held 1 0x1p+0 0x1.1p+0")), 1)
        self.assertEqual(self.false_lines(HOLD.replace("none 1 2 0x1p+0 0x1.8p+0", "none 1 2 0x1p+0 0x1p-1")), 1)
        self.assertEqual(self.false_lines(PATTERNS.replace("infeasible 1 0 0", "wedged 1 3 0")), 1)

    def test_refused_lines_and_those_that_repeat_them(self):
        line = "wedged 1 3 0 0x0p+0 0x0p+0\n"
        text = PATTERNS.replace("infeasible 1 0 0 0x0p+0 0x0p+0\n", line + line)
        self.assertEqual(self.false_lines(text), 1)
        self.assertEqual(self.false_lines(text, "forged:20: refused: wedged"), 0)


class Forgeries(unittest.TestCase):
    def test_are_well_formed(self):
        donors = [forge.Certificate(text) for text in (HOLD, PATTERNS)]
        for seed in range(200):
            own = forge.Certificate(random.Random(seed).choice((HOLD, PATTERNS)))
            self.assertTrue(forge.Forger(random.Random(seed), own, donors).changes())
            content, digest = own.text()[0].rsplit("digest ", 1)
            self.assertEqual(digest.strip(), hashlib.sha1(content.encode()).hexdigest())
            again = forge.Certificate(content + "digest\n")
            self.assertEqual(again.text()[0], own.text()[0])
            self.assertIn(f"end {len(again.evidence)}\n", content)


if __name__ == "__main__":
    unittest.main()
