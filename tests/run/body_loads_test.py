"""Weight by `gravity`, forces of `temperature`, and displaced supports under `kusabi hold`: closed forms, and refusals.

    python3 body_loads_test.py KUSABI SOURCES
"""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KusabiCase, main, with_ends  # noqa: E402: beside the folder of this file

HEAD = 'name = "body"\ndimension = {dimension}\nunits = {{{{ length = "m", force = "N" }}}}\n'
#: A block of 2 x 1 on the floor.
BLOCK = HEAD.format(dimension=2) + """
{top}
[[mesh]]
name = "b"
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [3, 2]
E = 1000
nu = 0.3
thickness = 0.5
plane = "{plane}"
{material}
[[contact]]
nodes = ["b.bottom"]
normal = [0, 1]
"""
#: A brick of 2 x 1 between two walls, held at its middle.
BRICK = HEAD.format(dimension=2) + """
{top}
[[mesh]]
name = "b"
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [2, 2]
E = 1000
nu = 0.3
thickness = 0.5
plane = "{plane}"
expansion = 1e-3
[[supports]]
nodes = ["b.1,1"]
[[contact]]
nodes = ["b.left"]
normal = [1, 0]
[[contact]]
nodes = ["b.right"]
normal = [-1, 0]
"""
#: A bar from a support to a wall.
BAR = HEAD.format(dimension=2) + """
{top}
[nodes]
"s" = [0, 0]
"t" = [2, 0]
[[members]]
{material}
between = [["s", "t"]]
[[supports]]
nodes = ["s"]
{support}
[[supports]]
nodes = ["t"]
fixed = ["y"]
[[contact]]
nodes = ["t"]
normal = [-1, 0]
"""
#: Elements of each shape: their nodes, the volume, and the shares of its weight of some nodes.
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
MIDDLES = [(0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5)]
TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SHAPES = [
    (SQUARE, 1, {0: 1 / 4}),
    (SQUARE[:2] + SQUARE[3:], 1 / 2, {2: 1 / 3}),
    (SQUARE + MIDDLES, 1, {0: -1 / 12, 4: 1 / 3}),
    ([(0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5)], 1 / 2, {0: 0, 3: 1 / 3}),
    (TETRAHEDRON, 1 / 6, {1: 1 / 4}),
    ([(x, y, z) for z in (0, 1) for x, y in SQUARE], 1, {6: 1 / 8}),
    ([(x, y, z) for z in (0, 2) for x, y in SQUARE[:2] + SQUARE[3:]], 1, {5: 1 / 6}),
]


class BodyLoads(KusabiCase):
    def grip(self, text, mu=0.3):
        """Both ends of the sum of the normal reactions; proved."""
        grip = with_ends(self.solve("hold", self.problem(text), "--mu", mu, "--grip", "--certificate", self.folder / "cert")["result"]["grip"])
        verified = self.kusabi("verify", self.folder / "cert", "--problem", self.folder / "problem.toml")
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        self.assertTrue(grip["low_proved"] and grip["high_proved"])
        return grip["low"], grip["high"]

    def test_a_floor_carries_the_weight(self):
        for plane in ("stress", "strain"):
            text = BLOCK.format(top="gravity = [0, -9.81]", plane=plane, material="density = 3")
            for end in self.grip(text):
                self.assertAlmostEqual(end, 3 * 9.81 * 2 * 1 * 0.5, delta=1e-7)

    def test_a_block_on_a_slope_requires_the_tangent_of_its_angle(self):
        angle = math.radians(20)
        text = BLOCK.format(top=f"gravity = [{math.sin(angle)}, {-math.cos(angle)}]", plane="strain", material="density = 1")
        found = self.solve("hold", self.problem(text))["result"]["holding_friction"]
        self.assertAlmostEqual(found["upper"]["value"], math.tan(angle), delta=1e-8)
        self.assertAlmostEqual(found["lower"]["value"], math.tan(angle), delta=1e-8)

    def test_weight_is_divided_among_the_nodes_of_each_shape(self):
        for nodes, volume, shares in SHAPES:
            dimension = len(nodes[0])
            names = [f"n{i}" for i in range(len(nodes))]
            gravity = [0.0] * (dimension - 1) + [-2.0]
            text = HEAD.format(dimension=dimension).format() + f"gravity = {gravity}\n[nodes]\n"
            text += "".join(f"{name} = {[float(x) for x in node]}\n" for name, node in zip(names, nodes))
            text += "[[elements]]\nE = 1\nnu = 0\ndensity = 3\nbetween = [" + str(names).replace("'", '"') + "]\n"
            text += 'thickness = 1\nplane = "stress"\n' if dimension == 2 else ""
            text += f'[[contact]]\nnodes = ["n0"]\nnormal = {[0] * (dimension - 1) + [1]}\n'
            loads = self.solve("hold", self.problem(text), "--mu", 1)["problem"]["structure"]["dead_loads"]
            weights = {each["node"]: -each["force"][-1] for each in loads}
            with self.subTest(len(nodes)):
                self.assertAlmostEqual(sum(weights.values()), 6 * volume, delta=1e-12)
                for node, share in shares.items():
                    self.assertAlmostEqual(weights.get(node, 0), 6 * volume * share, delta=1e-12)

    def test_bars_have_weight_at_their_ends(self):
        text = BAR.format(top="gravity = [3, 0]", material="E = 100\nA = 0.5\ndensity = 7", support="")
        for end in self.grip(text):
            self.assertAlmostEqual(end, 7 * 0.5 * 2 / 2 * 3, delta=1e-8)

    def test_a_warm_brick_presses_its_walls(self):
        for plane, pressure in (("stress", 1000 * 1e-3 * 20), ("strain", 1000 * 1e-3 * 20 / 0.7)):
            # Without friction it is free to expand along the walls.
            for end in self.grip(BRICK.format(top="temperature = 20", plane=plane), 0):
                self.assertAlmostEqual(end, 2 * pressure * 0.5, delta=1e-6)

    def test_a_cold_brick_has_no_reactions(self):
        # If it could turn about its support, the work of its thermal forces would be that of rounding.
        text = BRICK.format(top="temperature = -20", plane="stress") + '[[supports]]\nnodes = ["b.1,0"]\nfixed = ["x"]\n'
        grip = with_ends(self.solve("hold", self.problem(text), "--mu", 0, "--grip")["result"]["grip"])
        self.assertEqual((grip["low"], grip["high"]), (0, 0))
        self.assertLess(grip["high_out"], 1e-7)

    def test_a_warm_bar_presses_its_wall(self):
        text = BAR.format(top="temperature = 30", material="EA = 200\nexpansion = 1e-3", support="")
        for end in self.grip(text):
            self.assertAlmostEqual(end, 200 * 1e-3 * 30, delta=1e-8)

    def test_a_displaced_support_presses_the_wall(self):
        text = BAR.format(top="", material="EA = 200", support="displacement = [0.01, 0]")
        for end in self.grip(text):
            self.assertAlmostEqual(end, 200 / 2 * 0.01, delta=1e-8)
        away = self.problem(BAR.format(top="", material="EA = 200", support="displacement = [-0.01, 0]"))
        self.assertEqual(with_ends(self.solve("hold", away, "--mu", 0.3, "--grip")["result"]["grip"])["high"], 0)

    def test_a_displaced_edge_is_an_interference(self):
        body = BRICK.format(top="", plane="strain").replace('[[contact]]\nnodes = ["b.left"]\nnormal = [1, 0]\n', "")
        body = body.replace('nodes = ["b.1,1"]', 'nodes = ["b.left"]\nMOVED')
        moved = self.grip(body.replace("MOVED", "displacement = [0.02, 0]"))
        pressed = self.grip(body.replace("MOVED", "") + "interference = 0.02\n")
        for one, other in zip(moved, pressed):
            self.assertAlmostEqual(one, other, delta=1e-7 * other)
        self.assertGreater(moved[0], 1)

    def test_a_displaced_obstacle_presses_the_bar(self):
        # The bar touches a node of another bar, which is held and moves towards it.
        text = BAR.replace('"t" = [2, 0]', '"t" = [2, 0]\n"u" = [2, 0]\n"v" = [3, 0]').replace(
            "[[supports]]", '[[members]]\nEA = 50\nbetween = [["u", "v"]]\n[[supports]]\nnodes = ["u"]\nMOVED\n[[supports]]\nnodes = ["v"]\n[[supports]]', 1)
        text = text.replace("normal = [-1, 0]", 'normal = [-1, 0]\nagainst = ["u"]')
        text = text.format(top="", material="EA = 200", support="")
        for end in self.grip(text.replace("MOVED", "displacement = [-0.01, 0]")):
            self.assertAlmostEqual(end, 200 / 2 * 0.01, delta=1e-8)

    def test_other_subcommands_warn_that_they_ignore_body_loads(self):
        said = self.kusabi("critical", self.problem(BRICK.format(top="temperature = 20", plane="stress"))).stderr
        self.assertIn("kusabi critical ignores temperature and displaced supports", said)

    def test_invalid_keys_are_refused(self):
        for top, material, why in (("gravity = [0, -1]", "", "gravity has no effect; expected the density of a material"),
                                   ("temperature = 3", "", "temperature has no effect; expected the expansion of a material"),
                                   ("", "density = -1", "density is -1; expected 0 or a positive number")):
            text = BLOCK.format(top=top, plane="stress", material=material)
            self.assertIn(why, self.refused("hold", self.problem(text)))
        text = BAR.format(top="", material="EA = 2\ndensity = 1", support="")
        self.assertIn("density stands without A", self.refused("hold", self.problem(text)))
        text = BAR.format(top="", material="EA = 2", support="").replace('fixed = ["y"]', 'fixed = ["y"]\ndisplacement = [1, 0]')
        self.assertIn("displacement along x, which is not fixed", self.refused("hold", self.problem(text)))
        text = BAR.format(top="gravity = [1, 0]", material="E = 2\nA = 1\ndensity = 1", support="") + '[[members]]\nEA = 1\nbetween = [["s", "u"], ["t", "u"]]\n'
        text = text.replace('"t" = [2, 0]', '"t" = [2, 0]\n"u" = [2, 1]')
        self.assertIn("2 elements and members have no density", self.kusabi("hold", self.problem(text)).stderr)


if __name__ == "__main__":
    main()
