"""verify/second_checker.py, which shares nothing with `kusabi verify`, has the same conclusions, of certificates of
each kind and of forgeries.

    python3 second_checker_test.py KUSABI SOURCES

The exit codes must be equal, and the sentences word for word, but for this:

- The last digit of numbers may differ, since one has enclosures where the other has fractions, and each corrects
  motions and forces in its own way. Both are bounds.
- The sums of normal reactions of some states: each may name those of other states.
- After the conclusion `kusabi verify` may add what the certificate claims nothing about; this is not a conclusion.
- Messages about malformed certificates and reasons of refusals are in the words of each.
"""
import math
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tests"), str(ROOT / "bench" / "hostile")]
from kusabi_case import (  # noqa: E402: in tests
    EXAMPLES, SOURCES, KusabiCase, counted, main, sealed, without_digest)
from verdicts import NUMBER, SAME_NUMBERS, conclusion  # noqa: E402: in bench/hostile

CASES = SOURCES / "tests" / "cases"
FORGED = SOURCES / "tests" / "verify" / "certificates"
CHECKER = SOURCES / "verify" / "second_checker.py"
LADDER = EXAMPLES / "ladder.toml"
BRIDGE = EXAMPLES / "truss-bridge.toml"


class SecondChecker(KusabiCase):
    def second(self, path):
        run = subprocess.run([sys.executable, CHECKER, path], capture_output=True, text=True, check=False)
        self.assertNotIn("Traceback", run.stderr)
        self.assertNotIn("CHECKER IS WRONG", run.stdout)
        return run

    def both(self, path, file=None):
        """The runs of `kusabi verify`, with --problem for states under load, and of the second checker."""
        of_loads = file and re.search(r"(?m)^loads 2$", path.read_text())
        return self.kusabi("verify", path, *(["--problem", file] if of_loads else [])), self.second(path)

    def check_same(self, path, file=None):
        """Expects the same conclusion, word for word, up to the last digit of its numbers."""
        first, second = self.both(path, file)
        self.assertEqual(first.returncode, second.returncode,
                         f"{path}: {first.stdout}{first.stderr}\n{second.stdout}{second.stderr}")
        if first.returncode == 2:
            return first
        said, says = conclusion(first.stdout), second.stdout.splitlines()[-1]
        self.assertEqual(re.sub(NUMBER, "#", said), re.sub(NUMBER, "#", says))
        for a, b in zip(re.findall(NUMBER, said), re.findall(NUMBER, says)):
            self.assertTrue(math.isclose(float(a), float(b), rel_tol=SAME_NUMBERS, abs_tol=SAME_NUMBERS),
                            f"{said}\n{says}")
        return first

    def certificates(self, command, file, *words):
        """The certificates of a run, and its file."""
        run = self.kusabi(command, file, *words, "--certificate", self.folder / "cert", "--output", self.result)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        found = sorted(path for path in self.folder.glob("cert*"))
        self.assertTrue(found, run.stdout)
        return found

    def check_all(self, calls):
        for command, file, *words in calls:
            with self.subTest(" ".join(map(str, (command, file.name, *words)))):
                for path in self.certificates(command, file, *words):
                    self.assertIn(self.check_same(path, file).returncode, (0, 3))
                    path.unlink()

    def test_lists_and_bounds_of_the_friction_coefficient(self):
        self.check_all([("patterns", EXAMPLES / "two-bars.toml", "--mu", 2.5),
                        ("patterns", EXAMPLES / "plane-truss.toml", "--mu", 0.7),
                        ("critical", EXAMPLES / "plane-truss.toml"), ("critical", LADDER),
                        ("patterns", EXAMPLES / "wedge-in-groove.toml", "--mu", 0.4),
                        ("patterns", EXAMPLES / "snap-hook.toml", "--mu", 0.5),
                        ("patterns", EXAMPLES / "press-fit.toml", "--mu", 0.2),
                        ("patterns", CASES / "plane_truss_and_post.toml", "--mu", 0.7),
                        ("patterns", CASES / "self_holding_corner.toml", "--mu", 0.7),
                        ("critical", CASES / "two_pieces.toml")])

    def test_bounds_and_cuts(self):
        self.check_all([("critical", EXAMPLES / "plane-truss.toml", "--cuts", "always"),
                        ("patterns", EXAMPLES / "wedge-in-groove.toml", "--mu", 0.4, "--cuts", "always"),
                        ("critical", CASES / "loose_with_cuts.toml", "--cuts", "always")])

    def test_a_quadratic_form(self):
        # One candidate with F_nn = 2/3 and F_nt = -1/3: it cannot stick below 2, with P = -1 and S = F_nt.
        (path,) = self.certificates("patterns", EXAMPLES / "two-bars.toml", "--mu", 2.5)
        head = re.sub(r"(?s)evidence\n.*", "", path.read_text())
        for mu, code in ((1.9, 0), (2.1, 1)):
            numbers = " ".join(map(float.hex, (-1.0, -1 / 3, 0.005)))
            head = re.sub("friction .*", f"friction {mu.hex()}", head)
            path.write_text(sealed(f"{head}evidence\nform 1 0 0 {numbers}\nend 1\n"))
            self.assertEqual(self.check_same(path).returncode, code)

    def test_states_under_load(self):
        peg, bars = EXAMPLES / "peg-under-load.toml", CASES / "two_bars_at_a_total.toml"
        self.check_all([("hold", LADDER), ("hold", LADDER, "--mu", 0.4),
                        ("hold", peg, "--mu", 0.5), ("hold", peg, "--mu", 0.76),
                        ("hold", bars, "--mu", 1, "--total", math.sqrt(2)),
                        ("hold", CASES / "corner_bracket.toml", "--mu", 0.5),
                        ("hold", CASES / "smooth_block.toml", "--mu", 0.5, "--grip")])

    def test_a_total_without_a_dead_load(self):
        # The share of the dead load counts here as well: half of a state has half of the total.
        text = re.sub(r'\[\[loads\]\]\nkind = "dead"\n.*\n.*\n', "", (CASES / "two_bars_at_a_total.toml").read_text())
        self.assertNotIn("dead", text)
        self.check_all([("hold", self.problem(text), "--mu", 1, "--total", math.sqrt(2))])

    def test_no_dead_load(self):
        """All factors of a sign are excluded, but 0 is held."""
        text = re.sub(r'\[\[loads\]\]\nkind = "dead"\n(?:(?!\[\[).*\n)*', "", LADDER.read_text())
        self.assertNotIn('"dead"', text)
        file = self.problem(text)
        (path,) = self.certificates("hold", file, "--mu", 0.4)
        self.assertIn("it can hold these factors of the reference load: 0; it cannot hold: below 0, above 0",
                      conclusion(self.check_same(path, file).stdout))

    def test_what_the_claim_is_about(self):
        noise = "entries of a load below 2^-60 of its largest taken as zero"
        (path,) = self.certificates("hold", CASES / "two_bars_at_a_total.toml", "--mu", 1, "--total", math.sqrt(2))
        *_, claim, _ = self.second(path).stdout.splitlines()
        self.assertIn("about the numbers in this certificate", claim)
        self.assertNotIn(noise, claim)
        # The force of the bars is along the normal; a tangential component may be a rounding error of zero.
        text = path.read_text()
        body = re.sub(r"(?m)^(dead \S+) 0x0p\+0$", r"\1 0x1p-80", without_digest(text))
        self.assertNotEqual(body, without_digest(text))
        path.write_text(sealed(body))
        *_, claim, _ = self.second(path).stdout.splitlines()
        self.assertIn(noise, claim)

    def test_the_sum_of_the_normal_reactions(self):
        (path,) = self.certificates("hold", LADDER, "--mu", 0.4, "--grip")
        said, says = (conclusion(run.stdout).partition(", those of some states")[0] for run in self.both(path, LADDER))
        self.assertEqual(said, says)
        self.assertIn("add up to", said)
        low, high = map(float, re.search(r"those of some states to (\S+) and (\S+)", self.second(path).stdout).groups())
        self.assertAlmostEqual(low, 1.173076923, delta=1e-8)
        self.assertAlmostEqual(high, 1.5, delta=1e-8)

    def test_limit_loads(self):
        self.check_all([("limit", EXAMPLES / "paper" / "limit-3x3.toml", "--alpha", 40),
                        ("limit", EXAMPLES / "static-gap.toml", "--alpha", 0.45),
                        ("limit", EXAMPLES / "static-gap.toml", "--alpha", 1),  # not carried at any factor
                        ("limit", EXAMPLES / "gust.toml", "--alpha", 0.45), ("limit", BRIDGE, "--alpha", 1),
                        ("limit", EXAMPLES / "steel-mast.toml"), ("limit", EXAMPLES / "roof-truss.toml"),
                        ("limit", CASES / "groups.toml"), ("limit", CASES / "lambda_zero_not_carried.toml"),
                        ("limit", CASES / "uplift.toml", "--alpha", 1.5),
                        ("limit", CASES / "uplift.toml", "--alpha", 2.5),
                        ("limit", CASES / "two_cases_words.toml"), ("limit", CASES / "unloaded_strut.toml"),
                        ("limit", CASES / "cable_stay.toml")])

    def test_losses_and_struts(self):
        struts = self.problem(re.sub(r"(compression = \d+)( *})", r"\1, residual = 0.3\2", BRIDGE.read_text()))
        self.assertIn("residual", struts.read_text())
        self.check_all([("limit", BRIDGE, "--lose", 1, "--alpha", 1), ("limit", BRIDGE, "--lose", 2),
                        ("limit", BRIDGE, "--lose", 1, "--sudden", 2),
                        ("limit", EXAMPLES / "gust.toml", "--lose", 1, "--sudden", 1.5),
                        ("limit", CASES / "force_of_a_lost_member.toml", "--lose", 1),
                        ("limit", EXAMPLES / "steel-mast.toml", "--lose", 1), ("limit", struts, "--alpha", 1),
                        ("limit", struts, "--lose", 1)])

    def test_a_load_case_without_uncertain_loads(self):
        two_cases = BRIDGE.read_text() + "".join(f'[[loads]]\nkind = "dead"\nnodes = ["t1"]\nforce = [0.0, {y}]\ncase = "{name}"\n'
                                                 for name, y in (("snow", -1.0), ("none", 0.0)))
        file = self.problem(re.sub(r"(?m)^\[\[uncertainty\]\].*$", '[[uncertainty]]\ncase = "snow"', two_cases))
        self.check_all([("limit", file, "--alpha", 1), ("limit", file, "--lose", 1, "--alpha", 1), ("limit", file, "--lose", 1)])

    def test_residual_strengths_above_the_strengths_are_refused(self):
        struts = self.problem(re.sub(r"(compression = \d+)( *})", r"\1, residual = 0.3\2", BRIDGE.read_text()))
        (path,) = self.certificates("limit", struts, "--alpha", 1)
        body = without_digest(path.read_text())
        path.write_text(sealed(re.sub(r"(?m)^(member(?: \S+){4}) \S+", r"\1 0x1p+20", body)))
        self.assertEqual([run.returncode for run in self.both(path)], [2, 2])

    def test_certificates_of_the_other_tests(self):
        for path in sorted(FORGED.glob("*.cert")):
            with self.subTest(path.name):
                self.check_same(path)

    def check_forgeries(self, path, file, forgeries):
        """Each is a pattern, its replacement, and the exit codes expected."""
        body = without_digest(path.read_text())
        for pattern, new, codes in forgeries:
            with self.subTest(f"{path.name}: {pattern}"):
                other = re.sub(pattern, new, body, count=1)
                self.assertNotEqual(other, body)
                forged = self.folder / "forged"
                forged.write_text(counted(other))
                self.assertIn(self.check_same(forged, file).returncode, codes)

    def test_forged_lists(self):
        (path,) = self.certificates("patterns", EXAMPLES / "plane-truss.toml", "--mu", 0.7)
        self.check_forgeries(path, None, (
            (r"(?m)^infeasible .*\n", "", (1,)),  # a missing node
            (r"(?m)^wedged .*\n", "", (1,)),  # a missing pattern
            (r"(?m)^infeasible (\S+ \S+ \S+) .*\n", r"\g<0>marginal \1\n", (1,)),  # another claim of the same node
            (r"(?m)^infeasible (\S+ \S+ \S+) .*\n", r"marginal \1\n", (3,)),  # a weaker claim
            (r"(?m)^infeasible (\S+ \S+ \S+) (-?)0x",
             lambda m: f"infeasible {m[1]} {'' if m[2] else '-'}0x", (0, 1)),
            (r"(?m)^(infeasible \S+ \S+) \S+", r"\1 ff", (2,)),  # candidates that do not exist
            (r"(?m)^name .*\n(name .*\n)", r"\1\1", (2,)), (r"(?m)^blocks 1\nblock 1f", "blocks 1\nblock f", (2,)),
            (r"(?m)^friction \S+", "friction -0x1p-1", (2,)), (r"(?m)^friction \S+", "friction nan", (2,)),
            (r"(?m)^friction \S+", "friction inf", (2,)), (r"(?m)^friction \S+", "friction 0x1p+1024", (2,)),
            (r"(?m)^friction \S+", "friction 0x1p-5000", (2,)), (r"(?m)^(friction .*)", r"\1 0x1p-1", (2,)),
            (r"(?m)^(infeasible 1 \S+ \S+)( \S+)+$", r"\1" + 5 * " 0x0p+0", (1,)),
            (r"(?m)^(wedged 1 \S+ \S+) \S+", r"\1 0x1p+9", (1,)),  # beyond the cone of friction
            (r"(?m)^friction .*", "friction" + 5 * f" {(0.3).hex()}", (1,)),
            (r"(?m)^(stiffness\n)", r"\1-", (1,)),  # not definite
            (r"(?m)^theorems 1\nnone 1 0\n", "theorems 0\n", (2,))))
        # The digest is that of another text.
        path.write_text(path.read_text().replace("friction 0x1.6", "friction 0x1.5"))
        self.assertEqual(self.check_same(path).returncode, 2)

    def test_forged_states_under_load(self):
        (path,) = self.certificates("hold", LADDER, "--mu", 0.4, "--grip")
        self.check_forgeries(path, LADDER, (
            (r"(none 1 2 (?:\S+ \S+ )*?0x1p\+0 )(\S+)", r"\g<1>0x0p+0", (1,)),  # a larger range
            (r"(?m)^(held 1 0x1p\+0 )(-?)\S+", r"\1\g<2>0x1p+1", (1,)),  # a factor that is not held
            (r"(?m)^infeasible .*\n", "", (1,)),
            (r"(?m)^(infeasible \d+ )0 0", r"\g<1>1 0", (1,)),  # half of the patterns
            (r"(?m)^infeasible 3 ", "infeasible 4 ", (1, 2)),  # a node of another theorem
            (r"(?m)^(none 1 \d+) \S+ \S+", r"\1 0x0p+0 0x0p+0", (2,)),  # a load of zero
            (r"(?m)^(held 1) \S+ \S+", r"\1 0x0p+0 0x0p+0", (2,)), (r"below \S+", "below 0x1.4p+0", (1,)), (r"above \S+", "above 0x1.4p+0", (1,))))

    def test_forged_limit_loads_and_losses(self):
        (path,) = self.certificates("limit", EXAMPLES / "gust.toml", "--alpha", 0.45)
        self.check_forgeries(path, None, (
            (r"(?m)^column \S+", "column 0x1p-1", (1,)), (r"(?m)^(node 0 .*) (\S+)$", r"\1 0x1p+9", (1,)),
            (r"(?m)^load -?\S+", "load 0x1p+0", (1,)), (r"(?m)^(motion) .*", lambda m: m[1] + 99 * " 0x0p+0", (2,)),
            (r"(?m)^cut .*\n", "", (2,)), (r"(?m)^(member \d+ \d+) \S+", r"\1 0x1p-9", (1,)),
            (r"(?m)^(column .*) \S+ (\S+)$", r"\1 0x0p+0 \2", (2,)), (r"(?m)^(theorem 1) largest", r"\1 least", (2,)),
            (r"(?m)^(theorem 1 largest strength 0) 0x1p\+0", r"\1 0x1p+1", (2,)),
            (r"(?s)(theorem 1 least.*?\nnodes )\d+\n(node [^\n]*\n)+", r"\g<1>0\n", (0,))))  # the bound of the motion
        path.unlink()
        (path,) = self.certificates("limit", EXAMPLES / "static-gap.toml", "--alpha", 1)  # not carried at any factor
        opposite = (r"(?m)^motion .*", lambda m: re.sub(" (-?)0x", lambda n: " 0x" if n[1] else " -0x", m[0]), (0,))
        self.check_forgeries(path, None, (opposite, (r"(?sm)^(theorem 1) none(.*)end", r"\1 largest\2cuts 0\nnodes 0\nend", (1,))))
        path.unlink()
        (path,) = self.certificates("limit", BRIDGE, "--lose", 1, "--alpha", 1)
        self.check_forgeries(path, None, (
            (r"(?m)^(states \d+) \S+", r"\1 0x1p+0", (1,)), (r"(?m)^lost 1 \d+", "lost 1 9", (0, 1)),
            (r"(?m)^(theorem .* strength) 1 ", r"\1 2 ", (1,)), (r"(?m)^(theorem .* strength) 1 ", r"\1 0 ", (2,)),
            (r"(?m)^states \d+ (.*)\nstate ", r"states 9 \1\nstate 1", (2,)), (r"(?m)^force \d+", "force 99", (2,)),
            (r"(?m)^(forces \S+ \d+ \d+) \S+", r"\1 0x1p+9", (0, 1)), (r"(?m)^column \S+", "column 0x1p+2", (1,))))

    def test_load_cases_with_different_losses(self):
        """One sentence has the theorems on all load cases, so those of a case may not be about fewer losses."""
        (path,) = self.certificates("limit", BRIDGE, "--lose", 1, "--alpha", 1)
        head, case, theorem = re.fullmatch(r"(?s)(.*)cases 1\ncase(.*)theorems 1\ntheorem 1(.*)end\n",
                                           without_digest(path.read_text())).groups()
        count = head.count("\nmember ")
        all_kept = f"0x1p+0 {count} " + " ".join(map(str, range(count))) + "\n"
        for old, new, code in (("", "", 0), ("0x1p+0 0\n", all_kept, 2), ("strength 1 0x1p+0", "strength 1 0x1.001p+0", 2),
                               ("strength 1", "strength 2", 2)):
            with self.subTest(new):
                other = theorem.replace(old, new, 1)
                other = re.sub(r"lost 1 \d+", "lost 0", other) if "0x1p+0 0" in old else other
                for one, two in ((theorem, other), (other, theorem)):
                    path.write_text(sealed(f"{head}cases 2\ncase one{case}case two{case}theorems 2\n"
                                           f"theorem 1{one}theorem 2{two}end\n"))
                    self.assertEqual(self.check_same(path).returncode, code)

    def test_numbers_that_are_no_doubles(self):
        """`kusabi verify` rounds them; the second checker refuses them."""
        (path,) = self.certificates("patterns", EXAMPLES / "two-bars.toml", "--mu", 2.5)
        body = without_digest(path.read_text())
        path.write_text(sealed(re.sub(r"friction \S+", "friction 0x1.4000000000000001p+1", body)))
        self.assertEqual(self.second(path).returncode, 2)

    def test_motions_that_are_no_modes(self):
        (path,) = self.certificates("patterns", EXAMPLES / "wedge-in-groove.toml", "--mu", 0.4)
        self.check_forgeries(path, None, ((r"(?m)^(motions 3\n)\S+", r"\g<1>0x1p+3", (1,)),))
        self.assertIn("not rigid-body modes", self.second(self.folder / "forged").stdout)

    def test_a_dead_load_that_does_no_work(self):
        """A motion on which the dead load does no work says nothing of states under the dead load alone. Of two points,
        the dead load presses one on its support, the reference load pulls the other one off."""
        head = f"""kusabi certificate 5 contact
dimension 2
candidates 2
name pressed
name pulled
friction 0x1p-1 0x1p-1
blocks 1
block 3
stiffness
0x0p+0
{2 * ' 0x0p+0'}
{3 * ' 0x0p+0'}
{4 * ' 0x0p+0'}
motions 4
0x1p+0 0x0p+0 0x0p+0 0x0p+0
0x0p+0 0x1p+0 0x0p+0 0x0p+0
0x0p+0 0x0p+0 0x1p+0 0x0p+0
0x0p+0 0x0p+0 0x0p+0 0x1p+0
loads 2
case
clearance 0x0p+0 0x0p+0
dead -0x1p+0 0x0p+0 0x0p+0 0x0p+0
reference 0x0p+0 0x0p+0 0x1p+0 0x0p+0
total
theorems 1
none 1 2 0x1p+0 LOW 0x1p+0 0x1p+0
bounds 0
evidence
infeasible 1 0 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 -0x1p+0 0x0p+0
end 1
""".replace("\n ", "\n")
        path = self.folder / "cert"
        for low, code in (("0x1p-1", 0), ("0x0p+0", 1)):
            path.write_text(sealed(head.replace("LOW", low)))
            run = self.second(path)
            self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        self.assertNotIn("PROVED:", run.stdout)


if __name__ == "__main__":
    main()
