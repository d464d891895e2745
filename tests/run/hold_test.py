"""`kusabi hold`: closed forms, sentences, exit codes, refusals.

    python3 hold_test.py KUSABI SOURCES
"""
import csv
import fractions
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, SOURCES, KusabiCase, main, moved, with_ends  # noqa: E402: beside the folder of this file

LADDER = (EXAMPLES / "ladder.toml").read_text()
PEG = (EXAMPLES / "peg-under-load.toml").read_text()
SLOPE = 4 / 3
HEAD = 'name = "p"\ndimension = 2\nunits = { length = "m", force = "N" }\n'
LOAD = '\n[[loads]]\nkind = "dead"\nnodes = [{}]\nforce = {}\n'
SOLID = '\nE = 1000\nnu = 0.3\nthickness = 1\nplane = "strain"\n'
#: On a floor.
BLOCK = HEAD + '[[mesh]]\nname = "block"\ncorners = [[0, 0], [1, 0], [1, 1], [0, 1]]\ndivisions = [1, 1]' + SOLID + """
[[contact]]
nodes = ["block.0,0", "block.1,0"]
normal = [0, 1]
"""
#: A box with a groove, on a floor, and a wedge in the groove; the walls lean by 15 degrees.
BOX = HEAD + """
[nodes]
bl = [-1.5, -1]
br = [1.5, -1]
tl = [-1.5, 1]
tr = [1.5, 1]
l0 = [-0.5, 0]
r0 = [0.5, 0]
l1 = [-0.7679491924311227, 1]
r1 = [0.7679491924311227, 1]
a0 = [-0.5, 0]
a1 = [0.5, 0]
a2 = [0.7679491924311227, 1]
a3 = [-0.7679491924311227, 1]
[[elements]]""" + SOLID + """
between = [["bl", "br", "r0", "l0"], ["bl", "l0", "l1", "tl"], ["br", "tr", "r1", "r0"], ["a0", "a1", "a2", "a3"]]
[[contact]]
nodes = ["bl", "br"]
normal = [0, 1]
[[contact]]
nodes = ["a0", "a3"]
normal = [0.9659258262890683, 0.25881904510252074]
against = [{ nodes = ["l0"], weights = [1.0] }, { nodes = ["l1"], weights = [1.0] }]
[[contact]]
nodes = ["a1", "a2"]
normal = [-0.9659258262890683, 0.25881904510252074]
against = [{ nodes = ["r0"], weights = [1.0] }, { nodes = ["r1"], weights = [1.0] }]
"""
#: On a floor.
TRIANGLE = """
name = "triangle"
dimension = 2
units = { length = "m", force = "N" }
[nodes]
a = [0, 0]
b = [1, 0]
c = [0.5, 1]
[[members]]
EA = 100
between = [["a", "b"], ["b", "c"], ["a", "c"]]
[[contact]]
nodes = ["a", "b"]
normal = [0, 1]
"""
#: The same with c right above a, and without gap below a ceiling without friction, which carries nothing.
BELOW_CEILING = TRIANGLE.replace("[0.5, 1]", "[0, 1]") + """
[[contact]]
nodes = ["c"]
normal = [0, -1]
friction_factor = 0
"""


def heaviest(mu):
    """Of a climber at 8/10 of the ladder, in units of its weight: by statics."""
    middle = (mu * mu + mu * SLOPE) / (1 + mu * mu)
    return (middle - 0.5) / (0.8 - middle)


class Hold(KusabiCase):
    def check_end(self, held, out, wanted):
        """The closed form is between a factor that is held and one that is not, both near."""
        self.assertAlmostEqual(held, wanted, delta=1e-8 * max(1, abs(wanted)))
        self.assertLessEqual(min(held, out), wanted + 1e-12)
        self.assertGreaterEqual(max(held, out), wanted - 1e-12)

    def test_friction_of_a_ladder_is_that_of_statics(self):
        result = self.solve("hold", "ladder.toml")
        found = result["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 1 / 3)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved"] * 2)
        # By statics: N_floor + mu N_wall = 1, N_wall = mu N_floor.
        reactions = found["state"]["reactions"]
        self.assertAlmostEqual(reactions["ladder.0,0"][0], 0.9, delta=1e-6)
        self.assertAlmostEqual(reactions["ladder.10,0"][0], 0.3, delta=1e-6)
        self.assertEqual(result["verdict"]["exit_code"], 0)
        self.assertRegex(result["verdict"]["sentence"], r"below friction coefficient 0\.3333\d+; at 0\.3333\d+ it can\.$")

    def test_climbers_on_a_ladder_are_those_of_statics(self):
        for mu in (0.4, 0.5):
            result = self.solve("hold", "ladder.toml", "--mu", mu)
            held = with_ends(*result["result"]["intervals"])
            self.check_end(held["high"], held["high_out"], heaviest(mu))
            self.check_end(held["low"], held["low_out"], -0.625)
            self.assertEqual((held["standing"], held["low_out_proved"], held["high_out_proved"]), ("proved", True, True))
        held = with_ends(*self.solve("hold", "ladder.toml", "--mu", 0.6)["result"]["intervals"])
        self.assertIsNone(held["high"])
        self.check_end(held["low"], held["low_out"], -0.625)
        result = self.solve("hold", "ladder.toml", "--mu", 1.4)
        self.assertIn("It can hold the reference load at any factor at friction coefficient 1.4: it can be wedged there",
                      result["verdict"]["sentence"])

    def test_a_peg_jams_if_it_is_tilted_either_way(self):
        for mu in (0.5, 0.74):
            result = self.solve("hold", "peg-under-load.toml", "--mu", mu)
            low, high = map(with_ends, result["result"]["intervals"])
            self.assertEqual((low["low"], high["high"]), (None, None))
            self.check_end(low["high"], low["high_out"], -0.75 / mu)
            self.check_end(high["low"], high["low_out"], 0.75 / mu)
        self.assertEqual(result["result"]["outside"], "proved")
        self.assertIn("any factor", self.solve("hold", "peg-under-load.toml", "--mu", 0.76)["verdict"]["sentence"])

    def test_a_dead_load_alone_is_decided(self):
        text = LADDER.split("[[loads]]\nkind = \"reference\"")[0]
        for mu, sentence in ((0.34, "It can hold the dead load at friction coefficient 0.34."),
                             (0.33, "It cannot hold the dead load at friction coefficient 0.33.")):
            result = self.solve("hold", self.problem(text), "--mu", mu)
            self.assertEqual(result["verdict"]["sentence"], sentence)
            self.assertEqual(result["verdict"]["exit_code"], 0)

    def test_a_load_at_a_contact_is_held_by_that_contact(self):
        # The friction of the only loaded candidate decides; the block may turn about it.
        text = BLOCK + LOAD.format('"block.0,0"', [0.3, -1])
        result = self.solve("hold", self.problem(text))
        found = result["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 0.3)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved"] * 2)
        result = self.solve("hold", self.problem(text), "--mu", 0.31, "--grip")
        self.assertEqual(result["verdict"]["exit_code"], 0, result["verdict"])
        for end in ("low", "high"):
            self.assertAlmostEqual(with_ends(result["result"]["grip"])[end], 1, delta=1e-6)

    def test_the_least_coefficient_that_is_not_zero(self):
        """A block whose horizontal load is about 1e-6 of its weight, the least coefficient of a cone, slips below."""
        for share in (1 + 1e-9, 1 + 1e-8, 1, 1 - 1e-8):
            with self.subTest(share):
                text = BLOCK + LOAD.format('"block.0,0", "block.1,0"', [1e-6 * share, -1.0])
                found = self.solve("hold", self.problem(text))["result"]["holding_friction"]
                self.assertAlmostEqual(found["upper"]["value"], 1e-6, delta=1e-13)
                room = 0 if found["lower"]["standing"] == "proved" else 2e-14  # of a margin that is numerically zero
                self.assertLessEqual(found["lower"]["value"], 1e-6 * share + room)

    def test_a_part_wedged_in_another_one_does_not_hold_it(self):
        # A box with a wedge in its groove stands on the floor: the wedge can be clamped from tan 15 degrees = 0.268 on, and
        # the box slides up to 0.3.
        place = self.problem(BOX + LOAD.format('"bl", "br"', [0.15, -0.5]))
        found = self.solve("hold", place)["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 0.3)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved"] * 2)
        result = self.solve("hold", place, "--mu", 0.29)
        self.assertEqual(result["verdict"]["exit_code"], 0, result["verdict"])
        self.assertIn("It cannot hold the dead load", result["verdict"]["sentence"])

    def test_constrained_bodies_hold_every_load(self):
        text = LADDER + '\n[[supports]]\nnodes = ["ladder.10,1"]\n'
        text += '\n[[springs]]\nnodes = ["ladder.0,1"]\naxes = ["x"]\nstiffness = 1\n'
        for words in ((), ("--mu", 0.1)):
            result = self.solve("hold", self.problem(text), *words)
            self.assertIn("the supports constrain every body", result["verdict"]["sentence"])
            self.assertEqual(result["verdict"]["exit_code"], 0)

    def test_a_load_without_resistance_cannot_be_held(self):
        text = LADDER.replace('normal = [-1, 0]', 'normal = [0, 1]').split("[[loads]]\nkind = \"reference\"")[0]
        text = text.replace("normal = [0, 1]", "normal = [0, 1]\nfriction_factor = 0")
        text = text.replace("force = [0, -1]", "force = [1, -1]")
        result = self.solve("hold", self.problem(text))
        self.assertIn("It cannot hold the dead load", result["verdict"]["sentence"])

    def test_interference_is_the_opposite_of_clearance(self):
        pressed = PEG.replace("clearance = 0.001", "interference = 0.001")
        also = PEG.replace("clearance = 0.001", "clearance = -0.001")
        first, second = (self.solve("hold", self.problem(text), "--mu", 0.5)["result"] for text in (pressed, also))
        self.assertEqual(first, second)

    def test_bounds_of_candidates_leave_the_answer_and_fewer_nodes(self):
        found, opened = [], []
        for cuts in ("none", "always"):
            result = self.solve("hold", "press-fit.toml", "--mu", 0.3, "--grip", "--cuts", cuts)
            self.assertEqual((result["options"]["cuts"], result["verdict"]["exit_code"]), (cuts, 0))
            interval, grip = with_ends(*result["result"]["intervals"]), with_ends(result["result"]["grip"])
            found.append([interval["low"], interval["high"], grip["low"], grip["high"]])
            opened.append(sum(each["opened"] for each in result["statistics"]["searches"]))
        for one, other in zip(*found):
            self.assertAlmostEqual(one, other, delta=1e-8 * abs(one))
        self.assertLess(2 * opened[1], opened[0])

    def test_other_subcommands_warn_that_they_ignore_loads(self):
        said = self.kusabi("critical", EXAMPLES / "peg-under-load.toml").stderr
        self.assertIn("kusabi critical ignores 3 loads of the file", said)
        self.assertIn("kusabi hold searches states under load", said)
        self.assertIn("ignores the clearance or interference of 4 contact candidates", said)

    def test_invalid_calls_are_refused(self):
        for words in (("--mu", "0.4,0.3"), ("--mu", "-0.1"), ("--mu", "0.1:0.2"), ("--mu", "0.1,0.2", "--diagram"),
                      ("--mu", "0.1,0.2", "--certificate", self.folder / "cert")):
            self.assertIn("--mu", self.refused("hold", EXAMPLES / "ladder.toml", *words))
        self.assertIn("expected 0, or 1e-06", self.refused("hold", EXAMPLES / "ladder.toml", "--mu-max", 1e-9))
        bare = LADDER.split("[[loads]]")[0]
        self.assertIn("there is no dead load", self.refused("hold", self.problem(bare)))
        self.assertIn("there is no load", self.refused("hold", self.problem(bare), "--mu", 0.4))
        both = PEG.replace("clearance = 0.001", "clearance = 0.001\ninterference = 0.001")
        self.assertIn("interference and clearance in one group", self.refused("hold", self.problem(both)))

    def test_states_at_a_limit_bound_the_coefficient_from_above(self):
        # The resultant passes through b, so that a has no reaction under any friction coefficient: proved, since the
        # load acts at neither.
        result = self.solve("hold", self.problem(TRIANGLE + LOAD.format('"c"', "[1, -2]")))
        found = result["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 0.5)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved"] * 2)
        self.assertRegex(result["verdict"]["sentence"], r"below friction coefficient 0\.49999; at 0\.50001 it can\.")
        text = BELOW_CEILING + LOAD.format('"a", "b"', "[0.3, -1]")
        found = self.solve("hold", self.problem(text))["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 0.3)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved", "computed"])

    def check_motion(self, motion, friction, words, loads):
        """A motion of one body on which each contact opens at least mu times as fast as it slides."""
        self.assertEqual([body["motion"] for body in motion["bodies"]], [words])
        velocities = {each["node"]: each["velocity"] for each in motion["moving"]}
        for name, normal, along in friction:
            v = velocities.get(name, [0, 0])
            opens, slides = (sum(a * b for a, b in zip(v, axis)) for axis in (normal, along))
            self.assertGreaterEqual(opens, motion["friction"] * abs(slides) - 1e-9, name)
            self.assertEqual(name in motion["sliding"], abs(slides) > 1e-3 and opens < motion["friction"] * abs(slides) + 1e-3)
        work = sum(a * b for node, force in loads.items() for a, b in zip(velocities[node], force))
        self.assertGreater(work, 0)

    def test_a_ladder_slips_about_the_point_where_both_limit_reactions_meet(self):
        contacts = (("ladder.0,0", (0, 1), (1, 0)), ("ladder.10,0", (-1, 0), (0, 1)))
        result = self.solve("hold", EXAMPLES / "ladder.toml")  # the lines of slopes 3 and -1/3 above the middle
        (motion,) = result["result"]["excluding_motions"]
        self.check_motion(motion, contacts, "turns clockwise about (1.5, 4.5)", {"ladder.5,0": (0, -1)})
        self.assertIn("Why not with less friction? Statics alone excludes it: if the body turns clockwise about "
                      "(1.5, 4.5), the load does positive work, and reactions within their friction cones can only add to it. Contact slides at "
                      "ladder.0,0, ladder.10,0.", " ".join(result["verdict"]["details"]))
        result = self.solve("hold", EXAMPLES / "ladder.toml", "--mu", 0.4)
        less, more = result["result"]["excluding_motions"]
        climber = {"ladder.5,0": (0, -1), "ladder.8,0": (0, 0.626)}
        self.check_motion(less, contacts, 'turns anticlockwise about "ladder.0,0"', climber)
        self.assertEqual((less["opening"], less["sliding"]), (["ladder.10,0"], []))
        x = 5.2 / 2.9  # 2.5 x = 4 + 0.4 (3 - x)
        climber["ladder.8,0"] = 0, -0.483
        self.check_motion(more, contacts, f"turns clockwise about ({x:.4g}, {2.5 * x:.4g})", climber)
        self.assertLess(less["factor"], -0.625)
        self.assertGreater(more["factor"], heaviest(0.4))

    def test_a_pushed_block_slides_or_turns_over(self):
        text = BLOCK + LOAD.format('"block.0,1", "block.1,1"', "[0, -0.5]") + LOAD.format('"block.0,1"', "[1, 0]").replace("dead", "reference")
        floor = tuple((f"block.{k},0", (0, 1), (1, 0)) for k in (0, 1))
        for mu, end, words in ((0.3, 0.3, "moves along (0.9578, 0.2873)"), (0.8, 0.5, 'turns clockwise about "block.1,0"')):
            result = self.solve("hold", self.problem(text), "--mu", mu)
            more = result["result"]["excluding_motions"][-1]
            self.assertAlmostEqual(more["factor"], end, delta=1e-7)
            self.check_motion(more, floor, words, {"block.0,1": (end + 1e-3, -0.5), "block.1,1": (0, -0.5)})
            self.assertEqual(more["opening"], ["block.0,0"] if mu == 0.8 else [])
        page = self.folder / "page.html"
        self.kusabi("report", self.result, "--output", page)
        self.assertIn('id="why-not"', page.read_text())
        self.assertIn("motion that no reaction resists", page.read_text())

    def test_a_cube_in_space_turns_over_an_edge(self):
        places = ((0, 0), (1, 0), (1, 1), (0, 1))
        text = 'name = "cube"\ndimension = 3\nunits = { length = "m", force = "N" }\n[nodes]\n'
        text += "".join(f"{name}{x}{y} = [{x}, {y}, {z}]\n" for name, z in (("b", 0), ("t", 1)) for x, y in places)
        foot, top = (", ".join(f'"{name}{x}{y}"' for x, y in places) for name in "bt")
        text += f'[[elements]]\nE = 1000\nnu = 0.3\nbetween = [[{foot}, {top}]]\n[[contact]]\nnodes = [{foot}]\nnormal = [0, 0, 1]\n'
        text += LOAD.format(top, "[0, 0, -0.25]") + LOAD.format(top, "[0.25, 0, 0]").replace("dead", "reference")
        result = self.solve("hold", self.problem(text), "--mu", 0.8)
        more = result["result"]["excluding_motions"][-1]
        self.assertAlmostEqual(more["factor"], 0.5, delta=1e-7)
        self.assertRegex(more["bodies"][0]["motion"], r"^turns about the axis through \(1, [-0-9.e]+, 0\) along \(0, 1, 0\) by the right-hand rule$")
        self.assertEqual(sorted(more["opening"]), ["b00", "b01"])

    def test_motions_of_a_reference_load_alone_have_its_direction(self):
        # A block without weight on a floor: it holds a press down, and nothing that pulls it up.
        text = BLOCK + LOAD.format('"block.0,1", "block.1,1"', "[0, -1]").replace("dead", "reference")
        result = self.solve("hold", self.problem(text), "--mu", 0.5)
        (less,) = result["result"]["excluding_motions"]
        self.assertEqual(less["factor"], -1)
        self.assertTrue(less["opening"])  # lifted, or turned about one of its corners: both open alike
        self.check_motion(less, (), less["bodies"][0]["motion"], {"block.0,1": (0, 1), "block.1,1": (0, 1)})

    def test_loads_that_no_candidate_resists_name_no_motion(self):
        # A square that touches at a corner: its loads turn it about that, whatever the reactions.
        text = BLOCK.replace('nodes = ["block.0,0", "block.1,0"]\nnormal = [0, 1]', 'nodes = ["block.0,0"]\nnormal = [-1, 1]')
        text += LOAD.format('"block.1,1"', "[-1, 1]").replace("dead", "reference")
        self.assertNotIn("excluding_motions", self.solve("hold", self.problem(text), "--mu", 0.3)["result"])

    def test_what_is_not_held_at_any_coefficient_does_not_blame_friction(self):
        text = BLOCK + LOAD.format('"block.0,1"', "[0, 1]")
        result = self.solve("hold", self.problem(text))
        self.assertIn("Why not? Statics alone excludes it: if ", " ".join(result["verdict"]["details"]))

    def test_gaps_alone_name_the_direction_of_the_reference_load(self):
        # A block with a gap below it and no weight: any pull lifts it, and there is no factor of it beside 0.
        text = BLOCK + "clearance = 0.001\n" + LOAD.format('"block.0,1", "block.1,1"', "[0, -1]").replace("dead", "reference")
        result = self.solve("hold", self.problem(text), "--mu", 0.5)
        (less,) = result["result"]["excluding_motions"]
        self.assertEqual(less["factor"], -1)

    def test_a_part_may_need_less_friction_than_the_solver_takes(self):
        # One block needs a coefficient of 1e-7, the other one none; 1e-6 times its factor is below the least of the solver.
        other = BLOCK[len(HEAD):].replace("block", "other").replace("[[0, 0], [1, 0], [1, 1], [0, 1]]", "[[5, 0], [6, 0], [6, 1], [5, 1]]")
        text = BLOCK + other + "friction_factor = 0.5\n"
        text += LOAD.format('"block.0,1", "block.1,1"', "[1e-7, -1]") + LOAD.format('"other.0,1", "other.1,1"', "[0, -1]")
        found = self.solve("hold", self.problem(text))["result"]["holding_friction"]
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["proved", "proved"])
        self.assertTrue(found["lower"]["value"] <= 1e-7 <= found["upper"]["value"])

    def test_stiffness_that_decides_names_no_motion(self):
        # Reactions that grow with the load balance it: statics alone excludes nothing.
        self.assertNotIn("excluding_motions", self.solve("hold", EXAMPLES / "peg-under-load.toml", "--mu", 0.5)["result"])

    def test_one_factor_of_equilibrium_is_between_doubles_that_are_not_held(self):
        # A seesaw, whose loads are in equilibrium at 3/7, which is no double.
        text = TRIANGLE.replace("[1, 0]", "[0.3, 0.1]").replace("[0.5, 1]", "[-0.7, 0.1]").replace('nodes = ["a", "b"]', 'nodes = ["a"]')
        text += LOAD.format('"b"', "[0, -1]") + LOAD.format('"c"', "[0, -1]").replace("dead", "reference")
        result = self.solve("hold", self.problem(text), "--mu", 0.5)
        held = with_ends(*result["result"]["intervals"])
        self.assertEqual((held["low"], held["standing"], held["state"]["factor"]), (held["high"], "computed", held["low"]))
        self.assertTrue(fractions.Fraction(held["low_out"]) < fractions.Fraction(3, 7) < fractions.Fraction(held["high_out"]))
        self.assertAlmostEqual(held["state"]["reactions"]["a"][0], 10 / 7, delta=1e-6)
        self.assertRegex(result["verdict"]["sentence"], r"about 0\.428571 \(computed, not proved\), and none below 0\.42857 or above 0\.42858")
        # The table shows that double, and neither a range without a factor nor another one.
        table = self.kusabi("hold", self.folder / "problem.toml", "--mu", 0.5).stdout
        self.assertRegex(table, rf"\n +1 +{held['low']} +{held['low']} +computed +a\n")
        self.assertIn(f"at factor {held['low']}: a", table)

    def test_an_end_at_zero_is_exact(self):
        # The strut of the file, by statics: factors from 0, where its weight is on its foot, to mu (1 + mu) / (1 + mu^2).
        place, proof = SOURCES / "tests" / "cases" / "end_at_zero.toml", self.folder / "proof"
        result = self.solve("hold", place, "--mu", 0.3, "--certificate", proof)
        answer, [held] = result["result"], map(with_ends, result["result"]["intervals"])
        self.assertEqual((held["low_out"], held["low"], held["standing"]), (0, 0, "proved"))
        self.check_end(held["high"], held["high_out"], 0.39 / 1.09)
        self.assertEqual((answer["open"], answer["outside"], result["verdict"]["exit_code"]), (False, "proved", 0))
        checked = self.kusabi("verify", proof, "--problem", place)
        self.assertRegex(checked.stdout, r"PROVED: .*from 0 to 0\.35779\d+; it cannot hold: below 0, from")
        # A triangle that stands on one point holds nothing but a load through that point.
        text = TRIANGLE.replace('nodes = ["a", "b"]', 'nodes = ["a"]')
        text += LOAD.format('"a"', "[0.3, -1]") + LOAD.format('"b"', "[0.7, 0.2]").replace("dead", "reference")
        result = self.solve("hold", self.problem(text), "--mu", 0.5)
        answer, [held] = result["result"], map(with_ends, result["result"]["intervals"])
        self.assertEqual((held["low"], held["high"], held["standing"]), (0, 0, "proved"))
        self.assertEqual((answer["open"], answer["outside"], result["verdict"]["exit_code"]), (False, "proved", 0))

    def test_parts_that_may_hold_one_factor_are_undecided(self):
        # Each holds a range of pushes; they have the end -0.6 in common.
        part = TRIANGLE + LOAD.format('"c"', "[0, -2]") + LOAD.format('"c"', "[1, 0]").replace("dead", "reference")
        nodes, rest = part[:part.index("[[members]]")], part[part.index("[[members]]"):]
        second = rest.replace('"a"', '"d"').replace('"b"', '"e"').replace('"c"', '"f"').replace("[0, -2]", "[1.2, -2]")
        place = self.problem(nodes + "d = [10, 0]\ne = [11, 0]\nf = [10.5, 1]\n" + rest + second)
        result = self.solve("hold", place, "--mu", 0.3)
        self.assertEqual((result["result"]["intervals"], result["result"]["open"]), ([], True))
        self.assertIn("It is not known whether", result["verdict"]["sentence"])

    def test_an_end_without_a_factor_that_is_not_held_is_open(self):
        result = self.solve("hold", SOURCES / "tests" / "cases" / "open_end.toml", "--mu", 0.5)
        for each in map(with_ends, result["result"]["intervals"]):
            for end in ("low", "high"):
                if each[end] is not None and each[f"{end}_out"] is None:
                    self.assertFalse(each[f"{end}_out_proved"])
                    self.assertEqual((result["result"]["open"], result["result"]["outside"]), (True, None))

    def test_tables_and_files_have_one_standing_of_an_interval(self):
        for name, mu, standing in (("open_end", 0.5, "states proved"), ("end_at_zero", 0.3, "proved"), ("computed_equilibrium", 0.5, "computed")):
            place = SOURCES / "tests" / "cases" / f"{name}.toml"
            result = self.solve("hold", place, "--mu", mu, "--csv", self.folder / "a.csv")
            (row,) = csv.DictReader((self.folder / "a.csv").read_text().splitlines())
            (interval,) = result["result"]["intervals"]
            self.assertEqual((interval["standing"], row["standing"]), (standing, standing))
            self.assertRegex(self.kusabi("hold", place, "--mu", mu).stdout, rf"\n    1 .*  {standing}  ")
            report = self.folder / "a.html"
            self.assertEqual(self.kusabi("report", self.result, "--output", report).returncode, 0)
            self.assertIn(f"<td>{standing}</td>", report.read_text())

    def test_supports_have_a_state_whatever_is_known_of_its_sum(self):
        # The least sum at 0.7 is between 0.899 and 1.616.
        place = SOURCES / "tests" / "cases" / "grip_of_a_pair.toml"
        for mu in (0.5, 0.7):
            result = self.solve("hold", place, "--mu", mu, "--grip", "--csv", self.folder / "a.csv")
            grip = result["result"]["grip"]
            self.assertEqual((grip["held"], grip["standing"], grip["minimum"]["lower"]), (True, "proved", {"value": 0, "standing": "proved"}))
            self.assertNotEqual((grip["minimum"]["upper"] or {"value": 1})["value"], 0)
            self.assertNotIn("That there is a state", " ".join(result["verdict"]["details"]))
            self.assertIn("The least sum of the normal reactions is not known.", result["verdict"]["reservations"])
            (row,) = csv.DictReader((self.folder / "a.csv").read_text().splitlines())
            self.assertEqual([row[f"sum_{key}"] for key in ("at_least", "at_least_standing", "at_most", "at_most_standing")],
                             ["0", "proved", "", "not known"])

    def test_nothing_is_proved_of_a_large_body_without_a_certificate(self):
        # More than 2000 displacements are not enclosed on the way. Statics: 0.1 is the ratio of the load's components.
        text = BLOCK.replace("divisions = [1, 1]", "divisions = [40, 30]").replace("block.1,0", "block.40,0")
        place = self.problem(text + LOAD.format('"block.20,30"', [0.1, -1]))
        result = self.solve("hold", place)
        found = result["result"]["holding_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 0.1)
        self.assertEqual([found[end]["standing"] for end in ("lower", "upper")], ["computed"] * 2)
        self.assertIn("(computed, not proved)", result["verdict"]["sentence"])
        table = self.kusabi("hold", place).stdout
        self.assertRegex(table, r"\nholding friction coefficient: between 0\.\d+ and 0\.\d+ \(computed, not proved\)\n")
        result = self.solve("hold", place, "--mu", 0.2, "--csv", self.folder / "a.csv")
        self.assertEqual([each["standing"] for each in result["result"]["intervals"]], ["computed"])
        (row,) = csv.DictReader((self.folder / "a.csv").read_text().splitlines())
        self.assertEqual(row["standing"], "computed")

    def test_factors_are_complete_if_the_search_ends_with_the_grip_range(self):
        claims = set()
        for nodes in range(1, 100):
            result = self.solve("hold", "ladder.toml", "--mu", 0.4, "--grip", "--node-limit", nodes)
            answer, verdict = result["result"], result["verdict"]
            if result["status"] == "solved":
                self.assertIn("grip", answer)
                break
            claims.add(answer["open"])
            self.assertNotIn("grip", answer)
            self.assertEqual((verdict["nodes_left"], verdict["missing"]),
                             (None, ["The range of the sum of the normal reactions is not known."]))
            self.assertEqual(answer["outside"], None if answer["open"] else "proved")
            self.assertEqual("none below" in verdict["sentence"], not answer["open"])
            self.assertEqual("not known" in verdict["sentence"], answer["open"])
        self.assertEqual((result["status"], claims), ("solved", {False, True}))

    def test_there_is_no_claim_about_other_factors_where_all_are_held(self):
        result = self.solve("hold", "ladder.toml", "--mu", "0.4,1.4")["result"]
        self.assertEqual([point["outside"] for point in result["points"]], ["proved", None])
        alone = self.problem(LADDER.split("[[loads]]\nkind = \"reference\"")[0])
        for mu, outside in ((0.34, None), (0.33, "proved")):
            self.assertEqual(self.solve("hold", alone, "--mu", mu)["result"]["outside"], outside)

    def test_the_load_case_is_named(self):
        cases = LADDER.replace('kind = "reference"', 'kind = "reference"\ncase = "climb"')
        for words in ((), ("--mu", 0.4), ("--mu", "0.4,0.5")):
            result = self.solve("hold", self.problem(cases), "--case", "climb", *words)
            self.assertIn('in load case "climb"', result["verdict"]["sentence"])
            answer = result["result"]
            self.assertEqual(answer.get("points", [answer])[0]["case"], "climb")

    def test_uncertain_loads_are_refused(self):
        interval = LADDER.replace("force = [0, -1]", "force = [[-0.5, 0.5], -1]", 1)
        refused = self.refused("hold", self.problem(interval))
        self.assertIn("an uncertain load has a half-width", refused)
        place, nodes = self.problem(LADDER), '\n[[uncertainty]]\nnodes = ["ladder.0,1"]\naxes = ["x"]\n'
        certificate = self.folder / "cert"
        self.solve("hold", place, "--mu", 0.4, "--certificate", certificate)
        self.assertEqual(self.kusabi("verify", certificate, "--problem", place).returncode, 0)
        self.problem(LADDER + nodes + "alpha = 0.1\n")
        for words in (("hold", place), ("hold", place, "--mu", 0.4), ("verify", certificate, "--problem", place)):
            self.assertIn("an uncertain load has a half-width", self.refused(*words))
        said = self.kusabi("hold", self.problem(LADDER + nodes)).stderr
        self.assertIn("kusabi hold ignores 1 uncertain load without a half-width", said)

    def test_actions_with_a_range_of_factors_are_refused(self):
        actions = """
[combinations]
rule = "6.10"
reference = "climber"
[[actions]]
name = "weight"
permanent = [{}, 1.35]
forces = [{{ nodes = ["ladder.5,0"], force = [0, -1] }}]
[[actions]]
name = "climber"
variable = 1.5
psi0 = 0.6
forces = [{{ nodes = ["ladder.8,0"], force = [0, -1] }}]
"""
        bare = LADDER.split("[[loads]]")[0]
        words = ("--mu", 0.4, "--case", "6.10 climber leads")
        self.assertIn("an uncertain load has a half-width", self.refused("hold", self.problem(bare + actions.format(1)), *words))
        held = with_ends(*self.solve("hold", self.problem(bare + actions.format(1.35)), *words)["result"]["intervals"])
        self.assertAlmostEqual(held["high"], heaviest(0.4) * 1.35 / 1.5, delta=1e-8)

    def test_several_coefficients_have_the_answers_of_each(self):
        place = self.problem(PEG)
        mus = [0.4, 0.5, 0.74, 0.76, 2]
        words = ("--csv", self.folder / "a.csv", "--svg", self.folder / "a.svg", "--grip")
        result = self.solve("hold", place, "--mu", ",".join(map(str, mus)), *words)
        report = self.folder / "a.html"
        self.assertEqual(self.kusabi("report", self.result, "--output", report).returncode, 0)
        self.assertIn('id="loads"', report.read_text())
        self.assertEqual(self.kusabi("draw", self.result, "--output", self.folder / "b.svg").returncode, 0)
        points = result["result"]["points"]
        self.assertEqual([each["friction"] for each in points], mus)
        for mu, point in zip(mus, points):
            alone = self.solve("hold", place, "--mu", mu, "--grip")
            self.assertEqual(point["grip"], alone["result"]["grip"])
            self.assertEqual(point["intervals"], alone["result"]["intervals"])
        self.assertEqual([len(each["intervals"]) for each in points], [2, 2, 2, 1, 1])
        upper = with_ends(points[1]["intervals"][1])
        self.check_end(upper["low"], upper["low_out"], 0.75 / 0.5)
        rows = list(csv.DictReader((self.folder / "a.csv").read_text().splitlines()))
        self.assertEqual([row["mu"] for row in rows], ["0.4", "0.4", "0.5", "0.5", "0.74", "0.74", "0.76", "2"])
        self.assertEqual([row["low"] == "" for row in rows], [True, False] * 3 + [True, True])
        self.assertEqual({row["standing"] for row in rows}, {"proved"})
        self.assertRegex(result["verdict"]["sentence"], r"at 5 friction coefficients: at 0.4 all up to -1.875.* at 2 all;")
        self.assertEqual((self.folder / "a.svg").read_text(), (self.folder / "b.svg").read_text())

    def test_several_coefficients_of_a_dead_load_are_decided(self):
        text = LADDER.split("[[loads]]\nkind = \"reference\"")[0]
        table = self.folder / "a.csv"
        result = self.solve("hold", self.problem(text), "--mu", "0.31:0.35:0.01", "--csv", table)
        rows = csv.DictReader(table.read_text().splitlines())
        self.assertEqual([row["standing"] for row in rows], ["none, proved"] * 3 + ["proved"] * 2)
        held = {each["friction"]: len(each["intervals"]) for each in result["result"]["points"]}
        self.assertEqual(held, {0.31: 0, 0.32: 0, 0.33: 0, 0.34: 1, 0.35: 1})
        self.assertEqual(result["verdict"]["sentence"], "These are the answers for the dead load at 5 friction coefficients: at 0.31 it cannot be held, "
                                                        "at 0.35 it can be held; the table has the other coefficients.")

    def test_only_what_exact_arithmetic_proves_is_proved(self):
        cases = SOURCES / "tests" / "cases"
        # A weight 0.1 m beside the only candidate: the bar falls over, whatever a decoupled truss carries.
        falls = self.solve("hold", cases / "light_beside_heavy_load.toml")
        self.assertEqual(falls["result"]["reason"], "unbalanced")
        # 5e-13 m beside it: held up to the digits of a file, and not exactly.
        leans = self.solve("hold", cases / "lean_by_5e_13.toml")["result"]["holding_friction"]
        self.assertEqual(leans["upper"], {"value": 0, "standing": "computed"})
        # The least coefficient is 3.01924067848957, by 60 digits; that of doubles leaves a moment.
        lever = self.solve("hold", cases / "lever_under_load_2e11.toml")["result"]["holding_friction"]
        for end, right in (("lower", lever["lower"]["value"] <= 3.01924067848957), ("upper", lever["upper"]["value"] >= 3.01924067848957)):
            self.assertTrue(right or lever[end]["standing"] == "computed", lever)
        self.assertEqual(lever["lower"]["standing"], "proved")

    def test_a_body_on_a_hinge_holds_balanced_loads_only(self):
        # It may turn about the line of its candidates and supports.
        hinge = self.solve("hold", SOURCES / "tests" / "cases" / "hinge_about_candidates.toml")
        self.assertNotIn("any load", hinge["verdict"]["sentence"])

    def test_a_stopped_run_has_the_answers_of_searched_coefficients(self):
        mus = (0.4, 0.5, 0.6)
        alone = [self.solve("hold", "peg-under-load.toml", "--mu", mu)["result"]["intervals"] for mu in mus]
        numbers = set()
        for limit in (20, 90, 150, 180, 200, 220):
            result = self.solve("hold", "peg-under-load.toml", "--mu", ",".join(map(str, mus)), "--node-limit", limit,
                                "--csv", self.folder / "a.csv", "--svg", self.folder / "a.svg")
            self.assertEqual(result["verdict"]["exit_code"], 3)
            points = result["result"]["points"]
            self.assertEqual([each["intervals"] for each in points], alone[:len(points)])
            sentence = result["verdict"]["sentence"]
            if points:
                self.assertIn(f"at {len(points)} of 3 friction coefficients (the others are not known):", sentence)
            else:
                self.assertEqual(sentence, "The loads that it can hold are not known.")
                self.assertIn("no load is known to be held", (self.folder / "a.svg").read_text())
            self.assertTrue((self.folder / "a.csv").read_text().startswith("mu,"))
            numbers.add(len(points))
        self.assertEqual(numbers, {0, 1, 2})

    def test_a_stopped_run_claims_no_load_that_an_unsearched_part_may_not_hold(self):
        # Two ladders, the second one with its weight higher up, which requires more friction and holds fewer climbers.
        other = moved(LADDER[LADDER.index("[[mesh]]"):], 10).replace("ladder", "other").replace("other.5,0", "other.7,0")
        place = self.problem(LADDER + other)
        held = with_ends(*self.solve("hold", place, "--mu", 0.5)["result"]["intervals"])
        bracket = self.solve("hold", place)["result"]["holding_friction"]
        known = set()
        for limit in range(1, 13):
            result = self.solve("hold", place, "--mu", 0.5, "--node-limit", limit)
            if result["status"] == "solved":
                continue
            self.assertEqual(result["verdict"]["exit_code"], 3)
            for each in map(with_ends, result["result"]["intervals"]):
                self.assertTrue(held["low"] <= each["low"] and each["high"] <= held["high"], (limit, each))
            if not result["result"]["intervals"]:
                self.assertIn("It is not known whether", result["verdict"]["sentence"])
            known.add(len(result["result"]["intervals"]))
        self.assertIn(0, known)
        known = set()
        for limit in range(1, 13):
            result = self.solve("hold", place, "--node-limit", limit)
            if result["status"] == "solved":
                continue
            self.assertEqual(result["verdict"]["exit_code"], 3)
            found = result["result"]["holding_friction"]
            known.add(found["upper"] is None)
            if found["upper"] is None:
                self.assertIsNone(found["pattern"])
            else:
                self.assertGreaterEqual(found["upper"]["value"], bracket["lower"]["value"], limit)
            if found["lower"] is not None:
                self.assertLessEqual(found["lower"]["value"], bracket["upper"]["value"], limit)
        self.assertIn(True, known)

    def test_limits_leave_a_partial_answer(self):
        result = self.solve("hold", "peg-under-load.toml", "--mu", 0.5, "--node-limit", 3)
        self.assertEqual(result["verdict"]["exit_code"], 3)
        self.assertEqual(result["status"], "node-limit")


if __name__ == "__main__":
    assert math.isclose(heaviest(0.5), 3.5)
    main()
