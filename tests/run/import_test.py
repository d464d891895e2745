"""`kusabi import` of decks of Abaqus/CAE and CalculiX, and what `critical` then finds in the file.

    python3 import_test.py KUSABI SOURCES
"""
import json
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main  # noqa: E402: beside the folder of this file

SLOPE = math.tan(math.radians(15))  # of both walls of the groove
GRID = [(i / 2 - 0.5, j / 2) for j in range(3) for i in range(3)]  # 3 x 3 nodes of the wedge


def place(x, y):
    """A node of the wedge: 1 wide at the bottom, wider at the top by twice the slope."""
    return (x * (1 + 2 * SLOPE * y), y)


def wedge_in_parts():
    """As Abaqus/CAE writes it: the wedge is drawn lying and turned into the groove, whose walls are rigid."""
    return (EXAMPLES / "wedge.inp").read_text()


def wedge_by_hand():
    nodes = "\n".join(f"{tag} = [{place(*at)[0]!r}, {place(*at)[1]!r}]" for tag, at in enumerate(GRID, 1))
    elements = ", ".join(str([str(n) for n in (f, f + 1, f + 4, f + 3)]) for f in (1, 2, 4, 5)).replace("'", '"')
    return f"""name = "wedge"
dimension = 2
units = {{ length = "mm", force = "N" }}
[nodes]
{nodes}
[[elements]]
E = 210000.0
nu = 0.3
thickness = 10.0
plane = "strain"
between = [{elements}]
[[contact]]
nodes = ["3", "6", "9"]
normal = [-1, {SLOPE!r}]
[[contact]]
nodes = ["1", "4", "7"]
normal = [1, {SLOPE!r}]
"""


class Imports(KusabiCase):
    def written(self, name, text):
        file = self.folder / name
        file.write_text(text)
        return file

    def bracket(self, problem):
        output = self.folder / "answer.json"
        run = self.kusabi("critical", problem, "--output", output)
        self.assertEqual(run.returncode, 0, run.stderr)
        answer = json.loads(output.read_text())["result"]["critical_friction"]
        return answer["lower"]["value"], answer["upper"]["value"]

    def test_a_file_written_through_a_link_names_the_deck(self):
        (self.folder / "deep" / "er").mkdir(parents=True)
        (self.folder / "wedge.inp").write_text(wedge_in_parts())
        (self.folder / "link").symlink_to(self.folder / "deep" / "er")
        there = self.folder / "link" / "wedge.toml"
        self.kusabi("import", self.folder / "wedge.inp", "--output", there)
        self.assertEqual(self.kusabi("show", there).returncode, 0)

    def test_a_wedge_of_abaqus_cae_has_the_critical_coefficient_of_statics(self):
        deck = self.written("wedge.inp", wedge_in_parts())
        problem = self.folder / "wedge.toml"
        run = self.kusabi("import", deck, "--output", problem, "--units", "mm,N")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("elements of type CPE4R are read as CPE4", run.stderr)
        self.assertNotIn("needs editing", run.stderr)
        self.assertIn("--mu 0.3", problem.read_text())
        found = self.bracket(problem)
        by_hand = self.bracket(self.written("hand.toml", wedge_by_hand()))
        for number in (*found, *by_hand):  # it sticks between walls at 15 degrees from tan(15 degrees) on
            self.assertAlmostEqual(number, SLOPE, delta=1e-7)

    def test_the_file_names_the_deck_from_its_own_folder(self):
        deck = self.written("wedge.inp", wedge_in_parts())
        (self.folder / "problems").mkdir()
        problem = self.folder / "problems" / "wedge.toml"
        self.assertEqual(self.kusabi("import", deck, "-o", problem).returncode, 0)
        self.assertIn('file = "../wedge.inp"', problem.read_text())
        self.assertEqual(self.kusabi("show", problem).returncode, 0)

    def test_without_an_output_the_file_is_printed(self):
        deck = self.written("wedge.inp", wedge_in_parts())
        self.assertIn('[[contact]]', self.kusabi("import", deck).stdout)

    def test_entries_that_need_editing_are_reported_and_marked(self):
        deck = self.written("wedge.inp", wedge_in_parts().replace("*Elastic", "*Hyperelastic"))
        problem = self.folder / "wedge.toml"
        run = self.kusabi("import", deck, "-o", problem)
        self.assertEqual(run.returncode, 0)
        self.assertIn("the problem file needs editing: ", run.stderr)
        self.assertIn("# E and nu of an isotropic material", problem.read_text())

    def test_wrong_calls_are_refused(self):
        deck = self.written("wedge.inp", wedge_in_parts())
        for words, message in (((self.folder / "wedge.msh",), "not an input deck"),
                               ((deck, "--units", "mm"), "expected LENGTH,FORCE"),
                               ((self.folder / "none.inp",), "cannot be read")):
            run = self.kusabi("import", *words)
            self.assertEqual(run.returncode, 2)
            self.assertIn(message, run.stderr)


if __name__ == "__main__":
    main()
