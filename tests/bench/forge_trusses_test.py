"""Tests of bench/hostile/forge_losses.py and forge_limit.py: true and false sentences about three bars, and well-formed
forgeries.

    python3 forge_trusses_test.py BENCH_HOSTILE
"""
import hashlib
import pathlib
import random
import re
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv.pop()).resolve()))
import forge_limit  # noqa: E402
import forge_losses as forge  # noqa: E402

# A node on a vertical bar and two inclined by 45 degrees, each with a strength of 1. A vertical load is carried up to
# 1 + sqrt(2), to sqrt(2) without the vertical bar, to 1 without an inclined one, whose counterpart then has no force.
TEXT = """kusabi certificate 5 truss
dimension 2
nodes 4
node 0x0p+0 free 0x0p+0 free
node 0x0p+0 fixed 0x1p+0 fixed
node -0x1p+0 fixed 0x1p+0 fixed
node 0x1p+0 fixed 0x1p+0 fixed
members 3
member 0 1 0x1p+0 0x1p+0 0x1p+0
member 0 2 0x1p+0 0x1p+0 0x1p+0
member 0 3 0x1p+0 0x1p+0 0x1p+0
cases 1
case
dead 0
reference 1
force 0 0x0p+0 -0x1p+0
uncertain 0
theorems 1
theorem 1 largest strength 1 0x1p+0 0
lost 1 1
load
motion 0x1p+0 -0x1p+0
states 2 0x1p+0
state 1 0
forces 0x1p+0 1 0 0x1p+0
state 2 1 2
forces 0x1p+0 2 1 0x1.6a09e6p-1 2 0x1.6a09e6p-1
end
digest
"""
LEAST = "PROVED: after the loss of any member the load factor is at least 1; after the loss of 0-2 it is at most 1"


def with_width(text):
    """A horizontal uncertain load of up to 0.5, which one inclined bar and the vertical one carry as well."""
    column = "uncertain 1\ncolumn 0x1p-1 1 0 0 0x1p+0 gust\n"
    return re.sub(r"(?m)^(forces .*)$", r"\1\nforces 0x0p+0 0", text.replace("uncertain 0\n", column).replace("load\n", "load 0x1p-1\n"))


class Sentences(unittest.TestCase):
    def assert_false(self, sentence, count=1, text=TEXT):
        judge = forge.Judge(forge.Certificate(text), range(4))
        self.assertEqual(len(list(judge.false_parts(sentence))), count, sentence)
        self.assertGreater(judge.checked, 0)

    def test_true_ones_pass(self):
        self.assert_false(LEAST, 0)
        self.assert_false("PROVED: after the loss of 0-1 the load factor is at most 1.41421356238", 0)
        self.assert_false("PROVED: without any loss the load factor is at most 2.42", 0)
        kept = TEXT.replace("strength 1 0x1p+0 0", "strength 1 0x1p+0 2 1 2").replace("lost 1 1", "lost 1 0")
        self.assert_false("PROVED: after the loss of any member except 0-2 0-3 (kept) the load factor is at least 1.4; "
                          "after the loss of 0-1 it is at most 1.5", 0, kept)

    def test_false_bounds(self):
        self.assert_false(LEAST.replace("least 1;", "least 1.000001;"))
        self.assert_false(LEAST.replace("most 1", "most 0.99999"))
        self.assert_false(LEAST.replace("of 0-2", "of 0-1"))
        self.assert_false("PROVED: after the loss of 0-1 the load factor is at most 1.414")
        self.assert_false("PROVED: without any loss the load factor is at most 2.41")

    def test_false_losses(self):
        self.assert_false(LEAST.replace("any member", "any 2 members"))
        self.assert_false(LEAST.replace("any member", "any member except 0-2 (kept)"))
        self.assert_false(LEAST.replace("any member", "any member in each of 2 load cases"))
        self.assert_false("PROVED: after the loss of 0-2 the dead load is carried at no load factor")

    def test_uncertain_loads(self):
        text = with_width(TEXT)
        every = LEAST.replace("any member", "any member and under every admissible load (alpha = 0.5)")
        self.assert_false(every, text=text)
        self.assert_false(every.replace("least 1;", "least 0.5;").replace("most 1", "most 0.5"), 0, text)
        fatal = "PROVED: {} some admissible dead load (alpha = 0.5) is carried at no load factor"
        self.assert_false(fatal.format("after the loss of 0-1"), text=text)
        self.assert_false(fatal.format("after the loss of 0-2 and 0-3"), 0, text.replace("strength 1", "strength 2"))


# The same bars, with a horizontal uncertain load of up to 0.5: factors from -1.91421 to 1.91421, without it to 2.41421.
LIMIT = with_width(TEXT)[:with_width(TEXT).index("theorems")] + """theorems 2
theorem 1 largest strength 0 0x1p+0 0
lost 0
load 0x1p-1
motion 0x1p+0 -0x1p+0
cuts 1
cut 0 0x0p+0 2 1 0x1p-1 2 -0x1p-1
nodes 2
node 1 0 + 0x0p+0 0 0x1p+0 0x1p+0 0x0p+0 0x0p+0
node 1 0 - 0x1p-3 1 0 0x1p-1 0x1p+0 0x1p+0 0x0p+0 0x0p+0
theorem 1 least strength 0 0x1p+0 0
lost 0
load -0x1p-1
motion 0x1p+0 -0x1p+0
cuts 0
nodes 0
end
digest
"""
FACTORS = "PROVED: the worst-case load factor for alpha = 0.5 is between 1.914 and 1.915"


class LimitLoads(unittest.TestCase):
    def assert_false(self, sentence, count=1, text=LIMIT):
        judge = forge_limit.Judge(forge_limit.Certificate(text))
        self.assertEqual(len(judge.false_parts(sentence)), count, sentence)
        self.assertGreater(judge.checked, 0)

    def test_true_and_false_factors(self):
        self.assert_false(FACTORS + "; every load factor from -1.914 to 1.914 is carried under every admissible load; no factor below -1.915 is carried", 0)
        self.assert_false(FACTORS.replace("1.914 ", "1.9143 "))
        self.assert_false(FACTORS.replace("1.915", "1.9142"))
        self.assert_false(FACTORS.replace("between 1.914 and 1.915", "at most 1.9"))
        self.assert_false(FACTORS.replace("0.5", "0.4"))
        for part in ("every load factor from -1.92 to 1.9 is carried under every admissible load", "no factor below -1.9 is carried",
                     "no load factor is carried under every admissible load: the least factor of one is -1.9 or more"):
            self.assert_false(f"{FACTORS}; {part}")

    def test_loads_that_are_carried(self):
        none = "PROVED: for alpha = {} some admissible load is carried at no load factor"
        self.assert_false(none.format(0.5))
        self.assert_false(none.format(2), 0, LIMIT.replace("column 0x1p-1", "column 0x1p+1"))

    def test_strengths_after_buckling(self):
        claims = LIMIT[LIMIT.index("theorem 1"):LIMIT.index("end\n")]
        text = LIMIT.replace("end\n", claims.replace("strength", "residual") + "end\n").replace("theorems 2", "theorems 4")
        text = re.sub(r"(?m)^(member 0 [23] .*) 0x1p\+0$", r"\1 0x0p+0", text)
        between, struts = FACTORS.replace("1.914 ", "{} "), ", while no strut falls below its residual strength"
        # Without compression one inclined bar carries the uncertain load, with a force up of 0.5; the vertical one is down to -1.
        self.assert_false(between.format(1.91) + struts, 0, text)
        self.assert_false(FACTORS + "; every load factor from -0.5 to 1.9 is carried under every admissible load" + struts, 0, text)
        self.assert_false(FACTORS + "; every load factor from -0.51 to 1.9 is carried under every admissible load" + struts, 1, text)

    def test_forgeries_are_well_formed(self):
        donors = [forge_limit.Certificate(LIMIT)]
        for seed in range(300):
            own = forge_limit.Certificate(LIMIT)
            self.assertTrue(forge_limit.Forger(random.Random(seed), own, donors).changes())
            self.assertEqual(forge_limit.Certificate(own.text()).text(), own.text())


class Forgeries(unittest.TestCase):
    def test_are_well_formed(self):
        donors = [forge.Certificate(text) for text in (TEXT, with_width(TEXT))]
        for seed in range(300):
            own = forge.Certificate(random.Random(seed).choice((TEXT, with_width(TEXT))))
            self.assertTrue(forge.Forger(random.Random(seed), own, donors).changes())
            content, digest = own.text().rsplit("digest ", 1)
            self.assertEqual(digest.strip(), hashlib.sha1(content.encode()).hexdigest())
            self.assertEqual(forge.Certificate(own.text()).text(), own.text())


if __name__ == "__main__":
    unittest.main()
