"""`kusabi hold`: closed forms, sentences, exit codes, refusals.

    python3 hold_test.py KUSABI SOURCES
"""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main  # noqa: E402: beside the folder of this file

LADDER = (EXAMPLES / "ladder.toml").read_text()
PEG = (EXAMPLES / "peg-under-load.toml").read_text()
SLOPE = 4 / 3


def heaviest(mu):
    """Of a climber at 8/10 of the ladder, in units of its weight: by statics."""
    middle = (mu * mu + mu * SLOPE) / (1 + mu * mu)
    return (middle - 0.5) / (0.8 - middle)


class Hold(KusabiCase):
    def problem(self, text):
        place = self.folder / "problem.toml"
        place.write_text(text)
        return place

    def check_end(self, held, out, wanted):
        """The closed form is between a factor that is held and one that is not, both near."""
        self.assertAlmostEqual(held, wanted, delta=1e-8 * max(1, abs(wanted)))
        self.assertLessEqual(min(held, out), wanted + 1e-12)
        self.assertGreaterEqual(max(held, out), wanted - 1e-12)

    def test_friction_of_a_ladder(self):
        result = self.solve("hold", "ladder.toml")
        found = result["result"]["holding_friction"]
        self.check_end(found["upper"], found["lower"], 1 / 3)
        self.assertTrue(found["lower_proved"] and found["upper_proved"])
        # By statics: N_floor + mu N_wall = 1, N_wall = mu N_floor.
        reactions = found["state"]["reactions"]
        self.assertAlmostEqual(reactions["ladder.0,0"][0], 0.9, delta=1e-6)
        self.assertAlmostEqual(reactions["ladder.10,0"][0], 0.3, delta=1e-6)
        self.assertEqual(result["verdict"]["exit_code"], 0)
        self.assertRegex(result["verdict"]["sentence"], r"below friction coefficient 0\.3333\d+; at 0\.3333\d+ it can\.$")

    def test_climbers_on_a_ladder(self):
        for mu in (0.4, 0.5):
            result = self.solve("hold", "ladder.toml", "--mu", mu)
            (held,) = result["result"]["intervals"]
            self.check_end(held["high"], held["high_out"], heaviest(mu))
            self.check_end(held["low"], held["low_out"], -0.625)
            self.assertTrue(held["proved"] and held["low_proved"] and held["high_proved"])
        (held,) = self.solve("hold", "ladder.toml", "--mu", 0.6)["result"]["intervals"]
        self.assertIsNone(held["high"])
        self.check_end(held["low"], held["low_out"], -0.625)
        result = self.solve("hold", "ladder.toml", "--mu", 1.4)
        self.assertIn("It can hold any load at friction coefficient 1.4", result["verdict"]["sentence"])

    def test_a_peg_jams_if_it_is_tilted_either_way(self):
        for mu in (0.5, 0.74):
            result = self.solve("hold", "peg-under-load.toml", "--mu", mu)
            low, high = result["result"]["intervals"]
            self.assertEqual((low["low"], high["high"]), (None, None))
            self.check_end(low["high"], low["high_out"], -0.75 / mu)
            self.check_end(high["low"], high["low_out"], 0.75 / mu)
        self.assertEqual(result["verdict"]["answer"]["outside"], "proved")
        self.assertIn("any load", self.solve("hold", "peg-under-load.toml", "--mu", 0.76)["verdict"]["sentence"])

    def test_a_dead_load_alone(self):
        text = LADDER.split("[[loads]]\nkind = \"reference\"")[0]
        for mu, sentence in ((0.34, "It can hold the dead load at friction coefficient 0.34."),
                             (0.33, "It cannot hold the dead load at friction coefficient 0.33.")):
            result = self.solve("hold", self.problem(text), "--mu", mu)
            self.assertEqual(result["verdict"]["sentence"], sentence)
            self.assertEqual(result["verdict"]["exit_code"], 0)

    def test_constrained_bodies_hold_every_load(self):
        text = LADDER + '\n[[supports]]\nnodes = ["ladder.10,1"]\n'
        text += '\n[[springs]]\nnodes = ["ladder.0,1"]\naxes = ["x"]\nstiffness = 1\n'
        for words in ((), ("--mu", 0.1)):
            result = self.solve("hold", self.problem(text), *words)
            self.assertIn("the supports constrain every body", result["verdict"]["sentence"])
            self.assertEqual(result["verdict"]["exit_code"], 0)

    def test_a_load_that_nothing_resists(self):
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

    def test_other_commands_name_it(self):
        said = self.kusabi("critical", EXAMPLES / "peg-under-load.toml").stderr
        self.assertIn("kusabi critical ignores 3 loads of the file", said)
        self.assertIn("expected kusabi hold", said)
        self.assertIn("ignores the clearance or interference of 4 contact candidates", said)

    def test_refusals(self):
        bare = LADDER.split("[[loads]]")[0]
        self.assertIn("there is no dead load", self.refused("hold", self.problem(bare)))
        self.assertIn("there is no load", self.refused("hold", self.problem(bare), "--mu", 0.4))
        cases = LADDER.replace('force = [0, -1]\n', 'force = [0, -1]\ncase = "a"\n', 1)
        self.assertIn('expected --case with one of them: "a"', self.refused("hold", self.problem(cases)))
        both = PEG.replace("clearance = 0.001", "clearance = 0.001\ninterference = 0.001")
        self.assertIn("interference and clearance in one group", self.refused("hold", self.problem(both)))

    def test_limits_leave_a_partial_answer(self):
        result = self.solve("hold", "peg-under-load.toml", "--mu", 0.5, "--node-limit", 3)
        self.assertEqual(result["verdict"]["exit_code"], 3)
        self.assertEqual(result["status"], "node-limit")


if __name__ == "__main__":
    assert math.isclose(heaviest(0.5), 3.5)
    main()
