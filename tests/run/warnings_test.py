"""Plausible but wrong inputs cause warnings or errors; correct ones do not.

    python3 warnings_test.py KUSABI SOURCES
"""
import json
import math
import pathlib
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

CASES = SOURCES / "tests" / "cases"
HEAD = 'name = "{name}"\ndimension = {dimension}\nunits = {{ length = "mm", force = "N" }}\n\n[[mesh]]\nname = "w"\nfile = "{mesh}"\n'
STEEL = 'E = 210000.0\nnu = 0.3\nthickness = 10.0\nplane = "strain"\n'
WALLS = '\n[[contact]]\nnodes = ["w.left wall", "w.right wall"]\nnormal = "surface"\n'
CONE = "{{ point = [0, 0, -190.8113668772821], axis = [0, 0, 1], half_angle = {}, body = \"inside\" }}"


class Problems(KusabiCase):
    def problem(self, text, mesh):
        shutil.copy(CASES / mesh, self.folder)
        return super().problem(text)

    def groove(self, more="", material='[[material]]\ngroups = ["w.steel"]\n' + STEEL):
        head = HEAD.format(name="groove", dimension=2, mesh="vg_o1_msh22.msh")
        return self.problem(head + material + WALLS + more, "vg_o1_msh22.msh")

    def plug(self, normal):
        head = HEAD.format(name="plug", dimension=3, mesh="plug_lc8_o1.msh")
        return self.problem(head + "E = 210000.0\nnu = 0.3\n" + f'\n[[contact]]\nnodes = ["w.seat"]\nnormal = {normal}\n',
                            "plug_lc8_o1.msh")

    def said(self, *words):
        run = self.kusabi(*words)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        return run


WEDGE = """name = "wedge"
dimension = 2
units = {{ length = "mm", force = "N" }}
[[mesh]]
name = "w"
corners = [[-0.5, 0.0], [0.5, 0.0], [0.7679491924311227, 1.0], [-0.7679491924311227, 1.0]]
divisions = [{across}, 4]
E = 1000.0
nu = 0.3
thickness = 1.0
plane = "strain"
"""


class Surfaces(Problems):
    def test_faces_between_two_groups_belong_to_neither(self):
        # A wedge of 15 degrees sticks from tan 15 degrees on, on any mesh. With one element across, the
        # ends of both sides are the corners of its upper and lower edges.
        groups = {"together": [["w.left", "w.right"]], "apart": [["w.left"], ["w.right"]]}
        for across in (1, 2):
            for how, lists in groups.items():
                with self.subTest(how, across=across):
                    contact = "".join(f'[[contact]]\nnodes = {json.dumps(names)}\nnormal = "surface"\n' for names in lists)
                    file = self.folder / "wedge.toml"
                    file.write_text(WEDGE.format(across=across) + contact)
                    run = self.said("critical", file, "--output", self.result)
                    self.assertNotIn("warning", run.stderr)
                    bracket = json.loads(self.result.read_text())["result"]["critical_friction"]
                    self.assertAlmostEqual(bracket["lower"]["value"], math.tan(math.radians(15)), delta=1e-7)
                    self.assertAlmostEqual(bracket["upper"]["value"], math.tan(math.radians(15)), delta=1e-7)


class Shown(Problems):
    """Output of `kusabi show`, which solves nothing."""

    def test_touching_surfaces_are_listed(self):
        text = self.said("show", EXAMPLES / "peg-in-hole.toml").stdout
        self.assertRegex(text, r"body \d against body \d: 7 candidates, one normal \(0.9701, 0.2425\)\n")
        self.assertIn("coincident  none that are not joined", text)
        self.assertIn("the bracket (critical) in about a second", text)
        text = self.said("show", EXAMPLES / "morse-taper.toml").stdout
        self.assertIn("16 candidates, normals of a cone of half angle 1.5° about an axis", text)
        self.assertIn("can move along x, y and z", text)
        self.assertIn("nodes that are not joined, see the warnings", self.said("show", CASES / "dup.toml").stdout)

    def test_large_problems_have_a_warning_of_their_cost(self):
        file = self.folder / "large.toml"
        file.write_text(WEDGE.format(across=1).replace(", 4]", ", 200]") +
                        '[[contact]]\nnodes = ["w.left", "w.right"]\nnormal = "surface"\n')
        text = self.said("show", file).stdout
        self.assertIn("the list of all patterns may not end", text)
        self.assertIn("every = 7", text)

    def test_a_page_is_written(self):
        page = self.folder / "page.html"
        self.said("show", EXAMPLES / "morse-taper.toml", "--html", page)
        text = page.read_text()
        self.assertIn("data-scene", text)
        self.assertIn("E = 210000 N/mm², ν = 0.3", text)
        self.assertIn("24 × ten-node tetrahedron", text)


class Warnings(Problems):
    def test_unconnected_coincident_nodes_have_a_warning(self):
        message = self.said("critical", CASES / "dup.toml").stderr
        self.assertIn("kusabi: warning: ", message)
        self.assertIn("5 nodes are at the place of another node without connection", message)
        self.assertIn("the structure is of 2 bodies", message)
        shown = self.said("show", CASES / "dup.toml").stdout
        self.assertIn("2, not connected with each other", shown)
        self.assertEqual(shown.count("unconstrained, can move along x and y and turn"), 2)

    def test_quiet_runs_have_warnings_in_the_result_file_only(self):
        file = self.folder / "quiet.json"
        run = self.said("critical", CASES / "dup.toml", "--quiet", "--output", file)
        self.assertEqual(run.stderr, "")
        self.assertIn("at the place of another node", json.loads(file.read_text())["warnings"][0])

    def test_ignored_loads_have_a_warning(self):
        file = self.groove('\n[[loads]]\nkind = "dead"\nnodes = ["w.20"]\nforce = [0, -100]\n')
        for words in (("critical",), ("patterns", "--mu", 0.1), ("sweep", "--mu", "0.1,0.2")):
            message = self.said(words[0], file, *words[1:]).stderr
            self.assertIn(f"kusabi {words[0]} ignores 1 load of the file", message)
            self.assertIn("problem.toml:21:", message)

    def test_the_reference_load_of_patterns_is_not_ignored(self):
        load = '\n[[loads]]\nkind = "{}"\nnodes = ["w.20"]\nforce = [0, -100]\n'
        self.assertNotIn("ignores", self.said("patterns", self.groove(load.format("reference")), "--mu", 0.1).stderr)
        both = self.groove(load.format("reference") + load.format("dead"))
        self.assertIn("problem.toml:26:", self.said("patterns", both, "--mu", 0.1).stderr)
        self.assertIn("ignores 1 load", self.said("patterns", both, "--mu", 0.1).stderr)

    def test_candidates_off_the_cone_have_a_warning(self):
        message = self.said("critical", self.plug(CONE.format(6)), "--time-limit", 20).stderr
        self.assertIn("candidates are not on one cone with this axis and half_angle", message)
        self.assertIn("wrong for all candidates", message)
        self.assertNotIn("candidates are not", self.said("show", self.plug(CONE.format(3))).stderr)
        self.assertNotIn("candidates are not", self.said("show", EXAMPLES / "morse-taper.toml").stderr)

    def test_candidates_off_the_plane_have_a_warning(self):
        head = HEAD.format(name="groove", dimension=2, mesh="vg_o1_msh22.msh") + STEEL
        for normal, is_right in (("[1, 0.26794919243112270]", True), ("[1, 0]", False)):  # of the left wall: 15 degrees
            file = self.problem(head + f'\n[[contact]]\nnodes = ["w.left wall"]\nnormal = {{ plane = {normal} }}\n', "vg_o1_msh22.msh")
            self.assertEqual("not on one plane with this normal" in self.said("show", file).stderr, not is_right)

    def test_facets_that_differ_by_more_than_the_friction_angle_have_a_warning(self):
        message = self.said("critical", self.plug('"surface"')).stderr
        self.assertIn('normal = "surface" is the mean of faces that differ by up to', message)
        self.assertIn("the coefficient may be off by up to", message)
        self.assertNotIn("faces that differ", self.said("critical", self.groove()).stderr)
        # At a coefficient of 5 they differ by less than the friction angle.
        self.assertNotIn("faces that differ", self.said("patterns", self.plug('"surface"'), "--mu", 5, "--node-limit", 1).stderr)

    def test_a_sweep_has_the_warning_for_its_smallest_coefficient(self):
        message = self.said("sweep", self.plug('"surface"'), "--mu-max", 0.0139, "--width", 1e-6).stderr
        self.assertRegex(message, r"degrees of the friction coefficient 0\.01382;")

    def test_hold_has_the_same_warning(self):
        file = self.plug('"surface"\ninterference = 0.001')
        for mu, is_doubted in ((0.05, True), (5, False)):
            message = self.said("hold", file, "--mu", mu, "--node-limit", 1).stderr
            self.assertEqual("is the mean of faces that differ by up to" in message, is_doubted)

    def test_a_factor_that_may_be_meant_as_the_coefficient_has_a_warning(self):
        message = self.said("critical", self.groove("friction = 0.15\n")).stderr
        self.assertIn("friction = 0.15 is the former name of friction_factor", message)
        self.assertEqual(self.said("critical", self.groove("friction_factor = 0.15\n")).stderr.count("factor"), 0)
        self.assertIn("friction_factor and friction_coefficient in one group",
                      self.refused("show", self.groove("friction_factor = 1\nfriction_coefficient = 0.3\n")))
        self.assertIn("expected friction_factor or friction_coefficient only", self.refused("show", self.groove("friction = 1\nfriction_factor = 1\n")))

    def test_correct_files_have_no_warnings(self):
        for file in (*EXAMPLES.rglob("*.toml"), *CASES.glob("*.toml")):
            if file.name not in ("dup.toml", "long_lever_critical.toml", "lever_1e12.toml"):
                message = self.kusabi("show", file).stderr
                for fault in ("nothing joins", "candidates are not on", "former name of friction_factor"):
                    self.assertNotIn(fault, message, file.name)


class Messages(Problems):
    """Each message names the cause and the remedy, in one line."""

    def test_a_misspelt_group_has_a_suggestion(self):
        message = self.refused("show", self.groove(material='[[material]]\ngroups = ["w.Steel"]\n' + STEEL))
        self.assertIn('problem.toml:9:11: no mesh has a group "w.Steel"', message)
        self.assertIn('did you mean "w.steel"?', message)

    def test_incomplete_meshes_of_gmsh_have_a_remedy(self):
        for mesh, *words in (("nosurf.msh", "no elements of dimension 2", "Physical Surface", "Mesh.SaveAll = 1"),
                             ("nophys.msh", '"w.left wall" does not exist', "its mesh has no groups", "Physical Curve"),
                             ("q9.msh", "a quadrilateral of 9 nodes", "Mesh.SecondOrderIncomplete = 1")):
            message = self.refused("show", self.problem(HEAD.format(name="w", dimension=2, mesh=mesh) + STEEL + WALLS, mesh))
            for word in words:
                self.assertIn(word, message)

    def test_an_almost_incompressible_body_is_reported(self):
        message = self.refused("critical", self.groove(material='[[material]]\ngroups = ["w.steel"]\n' + STEEL.replace("0.3", "0.4999999")))
        self.assertIn("nu is 0.4999999", message)
        self.assertNotIn("axial", message)

    def test_abaqus_files_in_parts_and_with_contact_are_read(self):
        for mesh, walls, warning in (("parts.inp", ("w.left", "w.right"), "*PREPRINT is left out"),
                                     ("contact.inp", ("w.SL", "w.SR"), "kusabi import writes a problem file")):
            contact = "".join(f'\n[[contact]]\nnodes = ["{wall}"]\nnormal = "surface"\n' for wall in walls)
            run = self.said("critical", self.problem(HEAD.format(name="w", dimension=2, mesh=mesh) + contact, mesh))
            self.assertIn("0.2679491", run.stdout)  # tan(15 degrees)
            self.assertIn(warning, run.stderr)

    def test_no_help_ends_with_two_stops(self):
        for command in ("patterns", "rays", "critical", "limit", "sweep", "mip", "verify", "show", "draw", "report"):
            text = " ".join(self.said(command, "--help").stdout.split())
            self.assertNotIn(". .", text, command)

    def test_one_pattern_is_in_the_singular(self):
        said = self.said("sweep", EXAMPLES / "two-bars.toml", "--mu", "2.5").stdout
        self.assertIn("there is 1 sign pattern ", said)


if __name__ == "__main__":
    main()
