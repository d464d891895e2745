"""`kusabi hold --certificate`, `--grip` and `--total`: closed forms, proofs, and forgeries that are refused or prove
nothing wrong.

    python3 hold_certificate_test.py KUSABI SOURCES
"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import (  # noqa: E402: beside the folder of this file
    EXAMPLES, SOURCES, KusabiCase, counted, main, moved, sealed, with_ends, without_digest)
from hold_test import BELOW_CEILING, BLOCK, BOX, HEAD, LOAD, SOLID  # noqa: E402: beside this file

LADDER = EXAMPLES / "ladder.toml"
PEG = EXAMPLES / "peg-under-load.toml"
SLOPE = 4 / 3
#: Factors of the reference load at friction coefficient 0.4, by statics.
LEAST = -0.625
MIDDLE = (0.16 + 0.4 * SLOPE) / 1.16
MOST = (MIDDLE - 0.5) / (0.8 - MIDDLE)


def ranges(text):
    """[(low, high)] of a part of the sentence of `verify`."""
    if text is None:
        return []
    if "all factors" in text:
        return [(-math.inf, math.inf)]
    found = []
    for part in text.split(", "):
        numbers = [float(x) for x in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", part)]
        if part.startswith(("up to", "below")):
            found.append((-math.inf, numbers[0]))
        elif part.endswith("on") or part.startswith("above"):
            found.append((numbers[0], math.inf))
        else:
            found.append((numbers[0], numbers[-1]))
    return found


class HoldCertificate(KusabiCase):
    def written(self, file, *words):
        run = self.kusabi("hold", file, *words, "--certificate", self.folder / "cert", "--output", self.result)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        return (self.folder / "cert").read_text() if "--mu" in words else None

    def second_checked(self, name):
        checker = SOURCES / "verify" / "second_checker.py"
        return subprocess.run([sys.executable, checker, name], capture_output=True, check=False).returncode

    def verified(self, name, file):
        run = self.kusabi("verify", name, "--problem", file)
        return run, " ".join(run.stdout.split())

    def proved(self, name, file):
        run, said = self.verified(name, file)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertNotIn("refused", run.stdout + run.stderr)
        held = re.search(r"it can hold these factors of the reference load: (.*?)(?:;|$)", said)
        none = re.search(r"it cannot hold: (.*?)(?:;|$)", said)
        return ranges(held and held[1]), ranges(none and none[1]), said

    def test_both_bounds_of_a_coefficient_are_proved(self):
        self.written(LADDER)
        for end, what in (("lower", "it cannot hold the dead load"), ("upper", "it can hold the dead load")):
            said = self.proved(self.folder / f"cert.{end}", LADDER)[2]
            self.assertIn(what, said)
            mu = float(re.search(r"PROVED: at friction coefficient ([0-9.]+)", said)[1])
            self.assertAlmostEqual(mu, 1 / 3, delta=1e-8)
            self.assertEqual(mu < 1 / 3, end == "lower")

    def test_certificates_without_a_proof_are_not_written(self):
        place = self.problem(BELOW_CEILING + LOAD.format('"a", "b"', "[0.3, -1]"))  # its upper bound is computed
        missing = "No certificate of the upper bound was written"
        self.written(place)
        self.assertIn(missing, " ".join(json.loads(self.result.read_text())["verdict"]["missing"]))
        self.assertEqual([each.name for each in self.folder.glob("cert*")], ["cert.lower"])
        self.assertIn("it cannot hold the dead load", self.proved(self.folder / "cert.lower", place)[2])
        run = self.kusabi("hold", LADDER, "--mu", 0.4, "--node-limit", 1, "--certificate", self.folder / "new", "--output", self.result)
        self.assertEqual((run.returncode, (self.folder / "new").exists()), (3, False))
        self.assertIn("since the search ended early", " ".join(json.loads(self.result.read_text())["verdict"]["missing"]))

    def test_bounds_of_candidates_are_proved_under_loads(self):
        peg = (PEG, "--mu", "0.5"), [(-math.inf, -1.5), (1.5, math.inf)]
        ladder = (LADDER, "--mu", "0.4"), [(LEAST, MOST)]
        for call, truth in (ladder, peg):
            text = self.written(*call, "--cuts", "always")
            held, none, _ = self.proved(self.folder / "cert", call[0])
            for found, exact in zip(held, truth, strict=True):
                self.assertTrue(all(x == y or abs(x - y) < 1e-8 for x, y in zip(found, exact)), found)
            self.assertRegex(text, r"(?m)^none 1 2 .* weights")
            self.assertRegex(text, r"(?m)^cut 1 ")
            self.assertIn("bounds: ", self.verified(self.folder / "cert", call[0])[1])
            self.assertEqual(self.second_checked(self.folder / "cert"), 0)

    def test_bounds_of_candidates_are_those_of_their_theorem(self):
        body = without_digest(self.written(PEG, "--mu", "0.5", "--cuts", "always"))
        forged, number = self.folder / "forged", r"-?0x\S+"
        for pattern, change in (
                (rf"(?m)^(bound \d+ \d+ separated ){number}", lambda m: m[1] + "0x1p-60"),  # smaller than proved
                (rf"(?m)^(bound \d+ \d+ contact ){number}", lambda m: m[1] + "0x1p-20"),
                (rf" weights ({number}) ({number})", lambda m: f" weights {float.hex(float.fromhex(m[1]) / 64)} {m[2]}"),
                (r"(?m)^bound \d+ \d+ .*\n", lambda m: ""),  # of which others and nodes make use
                (r"(?m)^bound 2 .*\n", lambda m: m[0].replace("bound 2", "bound 1", 1))):  # of another theorem
            other = re.sub(pattern, change, body)
            self.assertNotEqual(other, body, pattern)
            forged.write_text(counted(re.sub(r"(?m)^bounds \d+", f"bounds {len(re.findall('(?m)^(?:bound|never) ', other))}", other)))
            run, said = self.verified(forged, PEG)
            self.assertEqual(run.returncode, 1, f"{pattern}: {said}")
            self.assertEqual(self.second_checked(forged), 1, pattern)
        forged.write_text(sealed(re.sub(r"(?m) weights .*", "", body)))
        run, said = self.verified(forged, PEG)
        self.assertEqual(run.returncode, 2, said)
        self.assertIn("expected the number of a theorem without loads, or with their weights", " ".join(run.stderr.split()))
        self.assertEqual(self.second_checked(forged), 2)

    def test_bounds_of_candidates_are_proved_at_a_total(self):
        text = (EXAMPLES / "wedge-in-groove.toml").read_text().replace("divisions = [4, 4]", "divisions = [1, 1]")
        place = self.folder / "groove.toml"
        place.write_text(text + '\n[[loads]]\nkind = "reference"\nnodes = ["block.0,1", "block.1,1"]\nforce = [0, 0.5]\n')
        ends = []
        for cuts in ("none", "always"):
            self.written(place, "--mu", "0.4", "--total", "1", "--cuts", cuts)
            ends.append(self.proved(self.folder / "cert", place)[:2])
        self.assertRegex((self.folder / "cert").read_text(), r"(?m)^cut 1 ")
        self.assertEqual(self.second_checked(self.folder / "cert"), 0)
        for one, other in zip(sum(ends[0], []), sum(ends[1], []), strict=True):
            self.assertTrue(all(x == y or abs(x - y) < 1e-8 for x, y in zip(one, other)), ends)

    def test_a_resumed_run_has_the_same_bounds(self):
        text = self.written(PEG, "--mu", "0.5", "--cuts", "always")
        again = self.written(PEG, "--mu", "0.5", "--cuts", "always", "--resume", self.folder / "state")
        self.assertEqual(sorted(again.splitlines()), sorted(text.splitlines()))

    def test_a_load_is_excluded_beside_wedged_parts(self):
        place = SOURCES / "tests" / "cases" / "load_beside_wedged_parts.toml"
        self.written(place)
        self.assertIn("it cannot hold the dead load", self.proved(self.folder / "cert.lower", place)[2])

    def test_factors_and_their_complement_are_proved(self):
        self.written(LADDER, "--mu", "0.4")
        held, none, _ = self.proved(self.folder / "cert", LADDER)
        ((low, high),) = held
        self.assertTrue(LEAST <= low <= LEAST + 1e-8 and MOST - 1e-8 <= high <= MOST)
        (below, above) = none
        self.assertEqual((below[0], above[1]), (-math.inf, math.inf))
        self.assertTrue(LEAST - 1e-8 <= below[1] <= LEAST and MOST <= above[0] <= MOST + 1e-8)

    def test_two_unbounded_intervals_are_proved(self):
        self.written(PEG, "--mu", "0.5")
        held, none, _ = self.proved(self.folder / "cert", PEG)
        self.assertEqual((held[0][0], held[1][1]), (-math.inf, math.inf))
        self.assertTrue(held[0][1] <= -1.5 and held[1][0] >= 1.5)
        self.assertTrue(-1.5 <= none[0][0] <= -1.5 + 1e-7 and 1.5 - 1e-7 <= none[-1][1] <= 1.5)
        self.written(PEG, "--mu", "0.76")
        self.assertEqual(self.proved(self.folder / "cert", PEG)[0], [(-math.inf, math.inf)])

    def test_another_structure_is_refused(self):
        self.written(LADDER, "--mu", "0.4")
        text = LADDER.read_text()
        for old, new in (("force = [0, -1]", "force = [0.5, -1]"), ("normal = [-1, 0]", "normal = [-1, 0.2]"),
                         ("[[contact]]", "[[contact]]\nfriction_factor = 0.5")):
            self.assertIn(old, text)
            other = self.folder / "other.toml"
            other.write_text(text.replace(old, new, 1))
            run, said = self.verified(self.folder / "cert", other)
            self.assertEqual(run.returncode, 1, f"{new}: {said}")
        alone = self.kusabi("verify", self.folder / "cert")  # about the numbers of the certificate
        self.assertEqual(alone.returncode, 0)
        self.assertIn("K, the loads and the friction are those of the certificate", " ".join(alone.stdout.split()))
        self.assertIn("it can hold these factors of the reference load: from -0.62499", " ".join(alone.stdout.split()))

    def test_a_load_that_supports_carry_has_no_forces_at_the_candidates(self):
        place = SOURCES / "tests" / "cases" / "load_that_supports_carry.toml"
        proof = self.folder / "carried"
        for options, written in (((), "carried.lower"), (("--mu", 2.6), "carried")):
            self.solve("hold", place, *options, "--certificate", proof)
            checked = self.kusabi("verify", self.folder / written, "--problem", place)
            self.assertIn("PROVED: ", checked.stdout)
            loads = [line for line in (self.folder / written).read_text().splitlines() if line.startswith("reference")]
            self.assertEqual(loads, ["reference 0x0p+0 0x0p+0"])

    def test_certificates_name_their_load_case(self):
        file = EXAMPLES / "peg-under-two-loads.toml"
        text = self.written(file, "--mu", "0.5", "--case", "side")
        run, said = self.verified(self.folder / "cert", file)
        self.assertEqual(run.returncode, 0, said)
        self.assertIn('not part of the certificate: load case "moment"', said)
        self.assertIn('PROVED: at friction coefficient 0.5 in load case "side"', said)
        other = self.folder / "other.cert"
        other.write_text(sealed(without_digest(text).replace("side", "lift")))
        run, said = self.verified(other, file)
        self.assertEqual(run.returncode, 1, said)
        self.assertIn('no load case "lift"', " ".join((run.stdout + run.stderr).split()))

    def test_forgeries_prove_nothing_wrong(self):
        text = self.written(LADDER, "--mu", "0.4")
        body = without_digest(text)
        forged = self.folder / "forged"
        for pattern, change in (
                (r"(none 1 2 (?:\S+ \S+ )*?0x1p\+0 )(\S+)", lambda m: m[1] + "0x0p+0"),  # a larger range
                (r"(?m)^(held 1 0x1p\+0 )(-?)\S+", lambda m: f"{m[1]}{m[2]}0x1p+1"),  # a factor that is not held
                (r"(?m)^infeasible .*\n", lambda m: ""),  # a missing node
                (r"(?m)^(infeasible \d+ )0 0", lambda m: f"{m[1]}1 0")):  # half of the patterns
            other = re.sub(pattern, change, body, count=1)
            self.assertNotEqual(other, body, pattern)
            forged.write_text(counted(other))
            run, said = self.verified(forged, LADDER)
            self.assertEqual(run.returncode, 1, f"{pattern}: {said}")
        generator = random.Random(1)
        begin = body.index("theorems ")
        outcomes = {}
        for _ in range(60):
            place = generator.randrange(begin, len(body))
            other = body[:place] + generator.choice("0123456789abcdef-+xp ") + body[place + 1:]
            forged.write_text(sealed(other))
            run, said = self.verified(forged, LADDER)
            outcomes[run.returncode] = outcomes.get(run.returncode, 0) + 1
            if run.returncode != 0:
                continue
            held, none, _ = self.proved(forged, LADDER)
            for low, high in held:
                self.assertTrue(LEAST - 1e-12 <= low and high <= MOST + 1e-12, said)
            for low, high in none:
                self.assertTrue(high <= LEAST + 1e-12 or low >= MOST - 1e-12, said)
        self.assertGreater(outcomes.get(1, 0) + outcomes.get(2, 0), 10, outcomes)

    def test_a_state_has_the_tangential_reactions_of_equilibrium(self):
        place = self.problem(BOX + LOAD.format('"bl", "br"', [0.15, -0.5]))  # friction 0.3 holds it
        body = without_digest(self.written(place, "--mu", "0.5"))
        half = "0x1p-1"
        self.assertIn(f"\nfriction {half} {half} ", body)
        forged = self.folder / "forged"

        def outcome(friction, share):
            other = body.replace(f"\nfriction {half} {half} ", f"\nfriction {friction} {friction} ")
            line = re.search(r"(?m)^held 1 .*$", other)[0].split(" ")
            line[6:8] = [(float.fromhex(x) * share).hex() for x in line[6:8]]
            forged.write_text(sealed(re.sub(r"(?m)^held 1 .*$", " ".join(line), other)))
            return self.kusabi("verify", forged)

        for friction, share, code in ((half, 1, 0), (half, 0.5, 0), ("0x1.999999999999ap-3", 1, 1),
                                      ("0x1.999999999999ap-3", 0.5, 1)):
            run = outcome(friction, share)
            with self.subTest(friction=friction, share=share):
                self.assertEqual(run.returncode, code, run.stdout + run.stderr)

    def test_a_state_has_no_reaction_where_nothing_resists(self):
        block = ("[nodes]\nbl = [0, 0]\nbr = [2, 0]\ntr = [2, 1]\ntl = [0, 1]\n[[elements]]" + SOLID +
                 '\nbetween = [["bl", "br", "tr", "tl"]]\n[[contact]]\nnodes = ["bl", "br"]\nnormal = [0, 1]\n'
                 "friction_factor = 0\n")
        body = without_digest(self.written(self.problem(HEAD + block + LOAD.format('"bl", "br"', [0, -0.5])), "--mu", "0.5"))
        forged = self.folder / "forged"
        for push, code in (("0x0p+0", 0), ("0x1p-60", 1), ("0x1p-4", 1)):
            forged.write_text(sealed(body.replace("\ndead -0x1p-1 0x0p+0 ", f"\ndead -0x1p-1 {push} ")))
            run = self.kusabi("verify", forged)
            with self.subTest(push=push):
                self.assertEqual(run.returncode, code, run.stdout + run.stderr)

    def test_motions_that_are_rounded_to_zero_count(self):
        folder = SOURCES / "tests" / "verify"
        run, said = self.verified(folder / "rounded_motion.cert", folder / "rounded_motion.toml")
        self.assertEqual(run.returncode, 1, said)
        self.assertIn("A is not pressed against the obstacle", said)

    def test_motions_beyond_all_doubles_are_refused(self):
        body = without_digest(self.written(self.problem(BOX + LOAD.format('"bl", "br"', [0.15, -0.5])), "--mu", "0.5"))
        forged = self.folder / "forged"
        forged.write_text(sealed(re.sub(r"(?m)^(held 1 .*) \S+ \S+$", r"\1 0x1.fp+1023 0x1.fp+1023", body)))
        for words in ((), ("--problem", self.folder / "problem.toml")):
            run = self.kusabi("verify", forged, *words)
            self.assertEqual(run.returncode, 1, run.stdout + run.stderr)

    def test_equilibrium_alone_excludes_loads_beside_wedged_configurations(self):
        # The box of hold_test slides up to a coefficient of 0.3; the wedge in its groove can be clamped from 0.268 on.
        place = self.folder / "box.toml"
        place.write_text(BOX + LOAD.format('"bl", "br"', [0.15, -0.5]))
        text = self.written(place, "--mu", "0.29")
        self.assertIn("at friction coefficient 0.29, it cannot hold the dead load", self.proved(self.folder / "cert", place)[2])
        body = without_digest(text)
        forged = self.folder / "forged"
        for pattern, new in ((r"(?m)^friction .*", "friction" + 6 * f" {(0.31).hex()}"),  # it is held
                             (r"(?m)^(infeasible \S+ \S+ \S+(?: \S+){6}) .*", r"\1" + 6 * " 0x0p+0"),  # no motion
                             (r"(?m)^(none \S+ \S+ )0x1p\+0", r"\1-0x1p+0"),  # the opposite load, which is not held either
                             (r"(?m)^(infeasible \S+ )0 0", r"\g<1>1 0")):  # half of the patterns
            other = re.sub(pattern, new, body, count=1)
            self.assertNotEqual(other, body, pattern)
            forged.write_text(sealed(other))
            run, said = self.verified(forged, place)
            self.assertIn(run.returncode, (1, 2), f"{pattern}: {said}")

    def test_all_loads_do_work_on_the_same_motion(self):
        # A square on one corner. Each load turns it; together they are a weight above that corner, which is held. The
        # forged node moves it straight down: the couple does no work there, the sum does. The condensed forces of each
        # load alone differ from this by the work on the turn, which nothing resists.
        loads = {"couple": ([0, -2], [0, 2]), "rest": ([0, 1], [0, -2])}
        corner = BLOCK.replace('"block.0,0", "block.1,0"', '"block.0,0"')
        for dead, reference, exception in (("couple", "rest", " except dead"), ("rest", "couple", "")):
            text = corner
            for kind, name in (("dead", dead), ("reference", reference)):
                for node, force in zip(('"block.0,1"', '"block.1,1"'), loads[name]):
                    text += LOAD.format(node, force).replace("dead", kind)
            place = self.problem(text)
            lines = without_digest(self.written(place, "--mu", "0.5")).splitlines()
            start = next(k for k, line in enumerate(lines) if line.startswith("theorems"))
            cone = "none 1 2 0x1p+0 0x0p+0 0x0p+0 0x1p+0" + exception
            forged = self.folder / "forged"
            forged.write_text(sealed("\n".join(lines[:start] + ["theorems 1", cone]) + "\nbounds 0\nevidence\n"
                                     "infeasible 1 0 0 0x0p+0 -0x1p+0 0x0p+0\nend 1\n"))
            run, said = self.verified(forged, place)
            self.assertEqual(run.returncode, 1, said)
            self.assertTrue(said.endswith("NOT PROVED"), said)

    def test_statics_alone_excludes_all_factors_but_one(self):
        # A post that stands on one point, its weight above it: any part of the reference load makes it fall over.
        post = SOURCES / "tests" / "cases" / "post_on_floor.toml"
        self.written(post, "--mu", 0.4)
        held, none, said = self.proved(self.folder / "cert", post)
        self.assertEqual(held, [(0, 0)])
        self.assertEqual(none, [(-math.inf, 0), (0, math.inf)], said)

    def test_sum_of_normal_reactions_of_a_ladder_is_that_of_statics(self):
        # Statics with the reaction T of the wall along it: N_floor = 1 - T, N_wall = (1/2 - T) / SLOPE. T is at most
        # mu N_wall, and N_wall is at most mu N_floor.
        mu = 0.4
        highest = mu * 0.5 / (SLOPE + mu)
        lowest = (0.5 - SLOPE * mu) / (1 - SLOPE * mu)
        least, most = (1 - t + (0.5 - t) / SLOPE for t in (highest, lowest))
        result = self.solve("hold", "ladder.toml", "--mu", mu, "--grip", "--certificate", self.folder / "cert")
        grip = with_ends(result["result"]["grip"])
        for end, wanted in (("low", least), ("high", most)):
            held, out = grip[end], grip[f"{end}_out"]
            self.assertAlmostEqual(held, wanted, delta=1e-8)
            self.assertLessEqual(min(held, out), wanted + 1e-12)
            self.assertGreaterEqual(max(held, out), wanted - 1e-12)
            self.assertTrue(grip[f"{end}_proved"] and grip[f"{end}_out_proved"])
        said = self.proved(self.folder / "cert", LADDER)[2]
        below, above = map(float, re.search(r"add up to ([0-9.]+) or more and ([0-9.]+) or less", said).groups())
        self.assertTrue(least - 1e-8 <= below <= least + 1e-12 and most - 1e-12 <= above <= most + 1e-8)

    def test_sums_of_decoupled_parts_are_added(self):
        # A ladder, another one with loads three times as large, and a peg without load that cannot be wedged.
        text = LADDER.read_text()
        body = moved(text[text.index("[[mesh]]"):], 10).replace("ladder", "other").replace("force = [0, -1]", "force = [0, -3]")
        peg = PEG.read_text()
        peg = moved(peg[peg.index("[[mesh]]"):peg.index("[[loads]]")], 20).replace("clearance = 0.001", "")
        place = self.folder / "parts.toml"
        place.write_text(text + body + peg)
        single = with_ends(self.solve("hold", LADDER, "--mu", 0.4, "--grip")["result"]["grip"])
        grip = with_ends(self.solve("hold", place, "--mu", 0.4, "--grip", "--certificate", self.folder / "cert")["result"]["grip"])
        said = self.proved(self.folder / "cert", place)[2]
        below, above = map(float, re.search(r"add up to ([0-9.]+) or more and ([0-9.]+) or less", said).groups())
        low, high = map(float, re.search(r"those of some states to ([0-9.]+) and ([0-9.]+)", said).groups())
        for end, found, state in (("low", below, low), ("high", above, high)):
            self.assertAlmostEqual(grip[end], 4 * single[end], delta=1e-7)
            self.assertAlmostEqual(found, grip[f"{end}_out"], delta=1e-11)
            self.assertAlmostEqual(state, grip[end], delta=1e-8)
        # Without the tree that excludes wedged configurations of the peg there is no upper bound.
        body = without_digest((self.folder / "cert").read_text())
        theorems = re.findall(r"(?m)^none .*$", body)
        (number,) = [k for k, each in enumerate(theorems, 1) if re.fullmatch(r"none \d+ 0", each)]
        other = re.sub(rf"(?m)^infeasible {number} .*\n", "", body)
        forged = self.folder / "forged"
        forged.write_text(counted(other))
        run, said = self.verified(forged, place)
        self.assertEqual(run.returncode, 1)
        self.assertNotIn("or less", said)

    def test_a_least_sum_of_zero_is_attained(self):
        place = self.folder / "free.toml"
        text = PEG.read_text()
        text = text[:text.index("[[loads]]")] + '[[supports]]\nnodes = ["peg.1,8"]\n'
        place.write_text(text + '[[springs]]\nnodes = ["peg.1,7"]\naxes = ["x"]\nstiffness = 1\n')
        result = self.solve("hold", place, "--mu", 0.5, "--grip", "--certificate", self.folder / "cert")
        grip = with_ends(result["result"]["grip"])
        self.assertEqual((grip["low"], grip["low_out"]), (0, 0))
        self.assertLess(grip["high_out"], 1e-6)
        said = self.proved(self.folder / "cert", place)[2]
        self.assertRegex(said, r"add up to 0 or more and [0-9.e-]+ or less, those of some states to 0 and ")

    def test_there_is_no_largest_sum_if_the_body_can_be_wedged(self):
        result = self.solve("hold", "ladder.toml", "--mu", 1.4, "--grip")
        self.assertTrue(result["result"]["grip"]["unbounded"])
        self.assertIn("no upper bound", " ".join(result["verdict"]["details"]))

    def test_there_is_no_largest_sum_if_a_pattern_has_a_state_and_is_wedged(self):
        # A bar between a rough inclined wall and a smooth vertical one: it may turn about its rough end. The load pulls both
        # ends from the walls.
        place = self.folder / "bar.toml"
        place.write_text("""
name = "bar"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [1, 0]
[[members]]
between = [["a", "b"]]
EA = 1
[[contact]]
nodes = ["a"]
normal = [0.9659258262890683, 0.25881904510252074]
[[contact]]
nodes = ["b"]
normal = [-1, 0]
friction_factor = 0
[[loads]]
kind = "dead"
nodes = ["a"]
force = [0.01, 0]
[[loads]]
kind = "dead"
nodes = ["b"]
force = [-0.01, 0]
""")
        self.assertEqual(self.solve("patterns", place, "--mu", 0.4)["result"]["count"], 1)
        result = self.solve("hold", place, "--mu", 0.4, "--grip")
        self.assertEqual(result["verdict"]["exit_code"], 0)
        self.assertTrue(result["result"]["grip"]["unbounded"])
        self.assertIn("no upper bound", " ".join(result["verdict"]["details"]))

    def test_a_groove_holds_the_loads_of_statics_at_a_total(self):
        # At a sum of 1 a load along its axis between -(mu cos + sin) and mu cos - sin: theory/loads.md.
        angle, mu = math.radians(15), 0.4
        text = (EXAMPLES / "wedge-in-groove.toml").read_text().replace("divisions = [4, 4]", "divisions = [1, 1]")
        place = self.folder / "groove.toml"
        place.write_text(text + '\n[[loads]]\nkind = "reference"\nnodes = ["block.0,1", "block.1,1"]\nforce = [0, 0.5]\n')
        result = self.solve("hold", place, "--mu", mu, "--total", 1, "--certificate", self.folder / "cert")
        held = with_ends(*result["result"]["intervals"])
        self.assertAlmostEqual(held["low"], -(mu * math.cos(angle) + math.sin(angle)), delta=1e-8)
        self.assertAlmostEqual(held["high"], mu * math.cos(angle) - math.sin(angle), delta=1e-8)
        proved, none, said = self.proved(self.folder / "cert", place)
        self.assertEqual((len(proved), len(none)), (1, 2))
        self.assertIn("normal reactions that add up to 1", said)

    def test_a_total_with_large_displacements_is_proved(self):
        case = SOURCES / "tests" / "cases" / "total_of_far_displacements.toml"
        result = self.solve("hold", case, "--mu", 1.74231, "--total", 1.5395190209950314, "--certificate", self.folder / "cert")
        held = with_ends(*result["result"]["intervals"])
        ((low, high),) = self.proved(self.folder / "cert", case)[0]
        self.assertAlmostEqual(low, held["low"], delta=1e-11)
        self.assertAlmostEqual(high, held["high"], delta=1e-11)

    def test_a_total_at_a_limit_has_the_factors_of_rational_programs(self):
        # By linear programs in rational numbers, of all patterns: bench/hostile/hold.py.
        case = SOURCES / "tests" / "cases" / "total_at_a_limit.toml"
        held = with_ends(*self.solve("hold", case, "--mu", 1.03178, "--total", 1.2236448818295438)["result"]["intervals"])
        self.assertAlmostEqual(held["low"], -1.5470855433539605, delta=1e-7)
        self.assertAlmostEqual(held["high"], 0.06368385942367348, delta=1e-7)

    def test_a_total_is_that_of_one_part(self):
        # The other ladder is not loaded, but at 1.4 it can be wedged with any sum.
        text = LADDER.read_text()
        mesh, loads = text.index("[[mesh]]"), text.index("[[loads]]")
        place = self.folder / "two.toml"
        place.write_text(text + "\n" + moved(text[mesh:loads], 10).replace('"ladder', '"other'))
        refused = self.refused("hold", place, "--mu", 1.4, "--total", 0.1)
        self.assertIn("--total: the candidates are in 2 decoupled parts", refused)
        self.written(place, "--mu", 0.4)
        certificate = self.folder / "cert"
        body = certificate.read_text()
        certificate.write_text(sealed(without_digest(body).replace("\ntotal\n", "\ntotal 0x1p-3\n")))
        self.assertIn("expected no total, since it is that of one block", self.refused("verify", certificate, "--problem", place))

    def test_a_total_without_a_state_proves_nothing(self):
        body = self.written(LADDER, "--mu", 0.4)
        certificate = self.folder / "cert"
        body = body[:body.index("\ntotal")] + "\ntotal 0x1p-3\ntheorems 0\nbounds 0\nevidence\nend 0\n"
        certificate.write_text(sealed(body))
        run, said = self.verified(certificate, LADDER)
        self.assertEqual(run.returncode, 3)
        self.assertIn("NOTHING PROVED", said)
        # The same in a file without loads.
        bare = self.folder / "bare.toml"
        bare.write_text(LADDER.read_text().split("[[loads]]")[0])
        certificate.write_text(sealed(re.sub(r"(?m)^(dead|reference) .*$", r"\1" + 4 * " 0x0p+0", body)))
        run, said = self.verified(certificate, bare)
        self.assertEqual(run.returncode, 3)
        self.assertIn("NOTHING PROVED", said)

    def test_a_state_of_the_reference_load_alone_leads_nowhere_at_a_total(self):
        # Its own reactions would add to those of any other state of its pattern: with a sum of sqrt 2 the tip holds the
        # factors from -0.5 to 0.5 (tests/cases/two_bars_at_a_total.toml), not those beyond.
        case = SOURCES / "tests" / "cases" / "two_bars_at_a_total.toml"
        body = without_digest(self.written(case, "--mu", 1, "--total", math.sqrt(2)))
        alone = "held 1 0x0p+0 0x1p+0 1 0 0x0p+0\n"
        end = body.rindex("end ")
        forged = self.folder / "forged"
        forged.write_text(counted(body[:end] + alone + body[end:]))
        held, none, _ = self.proved(forged, case)
        self.assertTrue(all(-0.5 <= low and high <= 0.5 for low, high in held), held)

    def test_totals_and_grips_are_not_combined(self):
        self.assertIn("expected one of them", self.refused("hold", LADDER, "--mu", 0.4, "--total", 1, "--grip"))
        self.assertIn("--mu", self.refused("hold", LADDER, "--grip"))


if __name__ == "__main__":
    main()
