"""examples/statics/: answers of `kusabi hold` and the closed forms of statics, with the sizes of the files.

    statics_examples_test.py KUSABI SOURCES
"""
import math
import pathlib
import sys
from fractions import Fraction

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KusabiCase, main, with_ends  # noqa: E402: beside the folder of this file

DIGITS = 1e-8  # relative
NONE = math.inf

INNER = [(65, 0), (56, 33), (33, 56), (0, 65), (-33, 56), (-56, 33), (-65, 0)]
OUTER = [(Fraction(6, 5) * x, Fraction(6, 5) * y) for x, y in INNER]
VOUSSOIR = 4  # weight of each


def leaning(share, wall):
    """Least coefficient mu of the floor at which a ladder of slope 4/3 stands whose load acts at a share of its length;
    wall: the coefficient there is wall * mu. From share = mu (T + wall mu) / (1 + wall mu^2), T = 4/3."""
    square, linear = wall * (1 - share), 4 / 3
    return (-linear + math.sqrt(linear**2 + 4 * square * share)) / (2 * square)


def standing(mu, wall, ladder, climber):
    """Distances of a climber from the top, in parts of the length, at which the ladder stands."""
    share = mu * (4 / 3 + wall * mu) / (1 + wall * mu**2)
    top = (ladder / 2 + climber) / (ladder + climber)
    return (top - share) * (ladder + climber) / climber, top * (ladder + climber) / climber


def on_incline(weight, width, height, mu):
    """Least and largest pull along an incline of slope 3/4, where it acts at the base of a block and at its top."""
    across, along = 0.8 * weight, 0.6 * weight
    slides = along - mu * across, along + mu * across
    topples = [(along * height / 2 + side * across * width / 2) / height for side in (-1, 1)]
    return slides, (max(slides[0], topples[0]), min(slides[1], topples[1]))


def solved(rows):
    """Solution of three linear equations, each with its right-hand side last: by Cramer's rule."""
    def determinant(columns):
        (a, b, c), (d, e, f), (g, h, i) = ([row[column] for column in columns] for row in rows)
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    columns = list(range(3))
    return [determinant(columns[:k] + [3] + columns[k + 1:]) / determinant(columns) for k in columns]


def moments(force_at, hinge, first, last):
    """Row of a force (X, Y) and the factor of the horizontal load: moments about a hinge of the voussoirs first to last."""
    (x, y), (at_x, at_y) = force_at, hinge
    centres = [[sum(points[k + end][axis] for points in (INNER, OUTER) for end in (0, 1)) / Fraction(4) for axis in (0, 1)]
               for k in range(first, last + 1)]
    return [-(y - at_y), x - at_x, -VOUSSOIR * sum(each[1] - at_y for each in centres),
            VOUSSOIR * sum(each[0] - at_x for each in centres)]


def folding():
    """Factor at which the arch turns about an outer springing, two corners of joints, and an inner springing."""
    return solved([moments(OUTER[0], INNER[2], 0, 1), moments(OUTER[0], OUTER[4], 0, 3), moments(OUTER[0], INNER[6], 0, 5)])[2]


def sliding(mu):
    """Factor at which the arch slides at a springing, and opens at both haunches and the crown. The force that the first
    voussoir exerts on the second one has the components X and Y; X - 4 lambda = -mu (Y + 4)."""
    haunch, crown, other = INNER[1], OUTER[3], INNER[5]
    return solved([moments(haunch, crown, 1, 2), moments(haunch, other, 1, 4), [1, mu, -VOUSSOIR, -mu * VOUSSOIR]])[2]


def thrust():
    """Least thrust of the arch under its own weight: inside at the haunch, outside at the crown."""
    return VOUSSOIR * sum(INNER[1][0] - sum(points[k][0] + points[k + 1][0] for points in (INNER, OUTER)) / Fraction(4)
                          for k in (1, 2)) / (OUTER[3][1] - INNER[1][1])


THETA, PHI = math.atan(7 / 24), math.atan(1 / 4)
LONG, WIDE, APART = 5, 10, 4  # the drawer
# File, options, and the least coefficient; inf: none up to the limit of the search, 1000.
COEFFICIENTS = [
    ("climber-on-a-ladder", (), leaning(0.9, 1 / 2)),
    ("block-on-an-incline", (), 3 / 4),
    ("tall-block-on-an-incline", (), NONE),
    ("block-pushed-low-or-high", ("--case", "low"), 0),
    ("bracket-on-a-pole", (), 120 / (2 * 150)),
    ("drawer", (), min(LONG / (2 * APART), LONG / WIDE)),
    ("brake-with-a-lever", ("--case", "clockwise"), NONE),
    ("brake-with-a-lever", ("--case", "anticlockwise"), 2.4 / 1.6),
    ("block-pulled-from-under-another", (), 0),
    ("lifting-tongs", (), 1 / ((6 * (1 + 3 / 4) + 3) / 6)),
    ("wedge-under-a-load", (), math.tan(THETA / 2)),
    ("pier-under-thrust", (), 0),
    ("three-logs", (), math.tan(math.radians(15))),
    ("arch-of-six-voussoirs", (), thrust() / (3 * VOUSSOIR)),
]
# File, coefficient, options, and the least and the largest load factor; inf: none.
FACTORS = [
    ("climber-on-a-ladder", 0.5, (), standing(0.5, 1 / 2, 0.2, 0.8)),
    ("block-on-an-incline", 0.5, (), on_incline(5, 10, 5, 0.5)[0]),
    ("tall-block-on-an-incline", 1, (), on_incline(5, 5, 10, 1)[1]),
    ("block-pushed-low-or-high", 0.4, ("--case", "low"), (-0.4 * 10, 0.4 * 10)),
    ("block-pushed-low-or-high", 0.4, ("--case", "high"), (-10 * 2 / (2 * 4), 10 * 2 / (2 * 4))),
    # |W + V| = 2 mu (W s + V c) / h, with W = 1
    ("bracket-on-a-pole", 0.5, (), [(sign * 150 / 120 - 1) / (1 - sign * 20 / 120) for sign in (-1, 1)]),
    ("brake-with-a-lever", 0.5, ("--case", "clockwise"), (10 * (2.4 + 0.5 * 1.6) / (0.5 * 4 * 5), NONE)),
    ("brake-with-a-lever", 0.5, ("--case", "anticlockwise"), (10 * (2.4 - 0.5 * 1.6) / (0.5 * 4 * 5), NONE)),
    ("block-pulled-from-under-another", 0.4, (), [sign * (0.4 * 3 + 0.2 * 1) for sign in (-1, 1)]),
    ("lifting-tongs", 0.45, (), (-1, NONE)),
    ("gripper", 0.5, ("--total", 25), (-25 * (0.5 * 24 + 7) / 25, 25 * (0.5 * 24 - 7) / 25)),
    ("wedge-under-a-load", 0.25, (), (math.sin(THETA - 2 * PHI) / math.cos(THETA), math.tan(THETA + 2 * PHI))),
    ("pier-under-thrust", 0.4, (), [sign * 0.4 * (2 + 1) for sign in (-1, 1)]),
    ("pier-under-thrust", 0.6, (), [sign * (2 + 4) * 2 / (2 * 4) for sign in (-1, 1)]),
    ("three-logs", 0.27, (), (-1, NONE)),
    ("arch-of-six-voussoirs", 0.8, (), (-folding(), folding())),
    ("arch-of-six-voussoirs", 0.5, (), (-sliding(Fraction(1, 2)), sliding(Fraction(1, 2)))),
]


class Statics(KusabiCase):
    def check_end(self, held, out, wanted):
        """The closed form is between a number that is held and one that is not, both within DIGITS."""
        low, high = sorted((held, out))
        room = DIGITS * max(1, abs(wanted))
        self.assertAlmostEqual(held, wanted, delta=room)
        self.assertAlmostEqual(out, wanted, delta=room)
        self.assertLessEqual(low, wanted + 1e-12)
        self.assertGreaterEqual(high, wanted - 1e-12)

    def check_certificates(self, file, *names):
        """Expects these certificates of the last call, and that they are proved; removes them."""
        found = sorted(self.folder.glob("cert*"))
        self.assertEqual([path.name for path in found], list(names))
        for path in found:
            run = self.kusabi("verify", path, "--problem", file)
            self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
            self.assertIn("\nPROVED: ", run.stdout)
            path.unlink()

    def hold(self, name, *words):
        """The result of a call with a certificate, and the problem file; every bound is proved."""
        result = self.solve("hold", f"statics/{name}.toml", *words, "--certificate", self.folder / "cert")
        self.assertEqual(result["verdict"]["exit_code"], 0, result["verdict"])
        self.assertNotIn("computed", result["verdict"]["sentence"])
        return result["result"], result["problem"]["file"]

    def test_coefficients_are_those_of_statics(self):
        for name, words, wanted in COEFFICIENTS:
            with self.subTest(name, words=words):
                result, file = self.hold(name, *words)
                lower, upper = (result["holding_friction"][end] for end in ("lower", "upper"))
                if wanted == NONE:
                    self.assertEqual((lower, upper), ({"value": 1000, "standing": "proved"}, None))
                    self.check_certificates(file, "cert.lower")
                elif wanted == 0:
                    self.assertEqual((upper["value"], upper["standing"]), (0, "proved"))
                    self.check_certificates(file, "cert.upper")
                else:
                    self.assertEqual((lower["standing"], upper["standing"]), ("proved", "proved"))
                    self.check_end(upper["value"], lower["value"], wanted)
                    self.check_certificates(file, "cert.lower", "cert.upper")

    def test_factors_are_those_of_statics(self):
        for name, mu, words, wanted in FACTORS:
            with self.subTest(name, mu=mu, words=words):
                result, file = self.hold(name, "--mu", mu, *words)
                held, = map(with_ends, result["intervals"])
                self.assertEqual((held["standing"], result["outside"]), ("proved", "proved"))
                for end, number in zip(("low", "high"), wanted):
                    if abs(number) == NONE:
                        self.assertIsNone(held[end])
                    else:
                        self.assertTrue(held[f"{end}_proved"])
                        self.check_end(held[end], held[f"{end}_out"], number)
                self.check_certificates(file, "cert")

    def test_pushes_at_two_heights_are_a_parallelogram(self):
        """Its edges: sliding, |low + high| = mu W, and tipping, |low + 4 high| = W b / 2."""
        piece, = self.solve("hold", "statics/block-pushed-low-or-high.toml", "--mu", 0.4, "--diagram")["result"]["pieces"]
        wanted = [((4 * slides - tips) / 3, (tips - slides) / 3) for slides in (-4, 4) for tips in (-10, 10)]
        found = piece["vertices"]
        self.assertEqual(len(found), 4)
        for one, other in zip(sorted(map(tuple, found)), sorted(wanted)):
            for number, truth in zip(one, other):
                self.assertAlmostEqual(number, truth, delta=1e-6)

    def test_a_tapered_part_sticks_between_fingers_that_do_not_move(self):
        found = self.solve("critical", "statics/gripper.toml")["result"]["critical_friction"]
        self.check_end(found["upper"]["value"], found["lower"]["value"], 7 / 24)


if __name__ == "__main__":
    main()
