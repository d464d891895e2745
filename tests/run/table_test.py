"""Tables of --csv contain the numbers of the result file, bit for bit, in the columns of
docs/result-files.md.

    python3 table_test.py KUSABI SOURCES
"""
import csv
import json
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main  # noqa: E402: beside the folder of this file

AXES = {2: ("n", "t"), 3: ("n", "t1", "t2")}
ODD = 'a, "b" c'


class Table(KusabiCase):
    def table(self, command, name, *words):
        """The result, and the rows of the table as dicts."""
        place = self.folder / "table.csv"
        result = self.solve(command, name, *words, "--csv", place)
        with place.open(newline="") as file:
            rows = list(csv.reader(file, strict=True))
        for row in rows:
            self.assertEqual(len(row), len(rows[0]))
        return result, [dict(zip(rows[0], row)) for row in rows[1:]]

    def same(self, cell, value):
        self.assertEqual(cell, "" if value is None else cell)
        if value is not None:
            self.assertEqual(float(cell), value)

    def check_configurations(self, result, entries, rows):
        problem = result["problem"]
        for entry, row in zip(entries, rows):
            for letter, key in (("r", "reaction"), ("u", "displacement")):
                for at, candidate in enumerate(problem["contact"]):
                    for axis, component in enumerate(AXES[problem["d"]]):
                        self.same(row.pop(f"{letter}_{component} {candidate['node']}"),
                                  entry[key][at][axis] if key in entry else None)

    def check_patterns(self, result, rows, *numbers):
        patterns = result["result"]["patterns"]
        self.assertEqual([row.pop("pattern") for row in rows], [str(i) for i in range(1, len(patterns) + 1)])
        self.check_configurations(result, patterns, rows)
        for pattern, row in zip(patterns, rows):
            for key in ("contact", "separated", "inactive"):
                self.assertEqual(row.pop(key).split(), pattern.get(key, []))
            self.assertEqual(row.pop("block"), str(pattern.get("block", 1)))
            self.assertEqual(row.pop("state", None), pattern.get("state"))
            for key in numbers:
                self.same(row.pop(key), pattern[key])
            self.assertEqual(row, {})  # there are no other columns

    def test_has_the_numbers_of_patterns(self):
        for name, mu, least in (("space-truss.toml", 0.65, 2), ("plane-truss.toml", 0.8, 2), ("two-bars.toml", 0.5, 0),
                                ("../tests/cases/two_pieces.toml", 1, 0),
                                ("../tests/cases/plane_truss_and_post.toml", 0.5, 1)):
            with self.subTest(name):
                result, rows = self.table("patterns", name, "--mu", mu)
                self.assertGreaterEqual(len(rows), least)
                self.check_patterns(result, rows, "margin", "margin_upper")

    def test_has_the_numbers_of_critical(self):
        for words in ((), ("--method", "newton", "--mu-max", 0.6)):
            with self.subTest(words):
                result, rows = self.table("critical", "plane-truss.toml", *words)
                self.assertGreater(len(rows), 0)
                self.check_patterns(result, rows, "lower", "upper")

    def test_has_the_numbers_of_rays(self):
        letters = {"sticks": "x", "slides +": "+", "slides -": "-", "separates": "o", "idle": "."}
        result, rows = self.table("rays", "plane-truss.toml", "--mu", 0.6)
        rays = result["result"]["rays"]
        self.assertEqual([row.pop("ray") for row in rows], [str(ray["number"]) for ray in rays])
        self.check_configurations(result, rays, rows)
        self.assertEqual(rows, [{"state": "".join(letters[each] for each in ray["state"])} for ray in rays])

    def check_members(self, result, rows):
        answer, structure = result["result"], result["problem"]["structure"]
        self.assertEqual(len(rows), len(structure["members"]))
        for at, row in enumerate(rows):
            ends = [structure["node_names"][node] for node in structure["members"][at]]
            self.assertEqual([row.pop("first"), row.pop("second")], ends)
            self.assertEqual(row.pop("member"), structure["member_names"][at])
            for column, force in zip(("yield_tension", "yield_compression"), structure["yield_forces"][at]):
                self.same(row.pop(column), force)
            for key in ("nominal_forces", "nominal_utilisation", "forces", "utilisation"):
                self.same(row.pop(key), answer[key][at] if key in answer else None)
            for key in ("nominal_mode", "collapse_mode"):
                yielding = {tuple(each["member"]): each["in"] for each in answer.get(key, {}).get("yielding", [])}
                self.assertEqual(row.pop(key), yielding.get(tuple(ends), ""))
            self.assertEqual(row, {})

    def test_has_the_numbers_of_limit(self):
        for words in ((), ("--alpha", 0.5)):
            with self.subTest(words):
                self.check_members(*self.table("limit", "gust.toml", *words))

    def test_has_the_numbers_of_mip(self):
        result, rows = self.table("mip", "../tests/programs/knapsack.lp")
        self.assertEqual({row["column"]: float(row["value"]) for row in rows}, result["result"]["columns"])
        result, rows = self.table("mip", "../tests/programs/parity.lp")
        self.assertEqual((result["result"]["state"], rows), ("infeasible", []))

    def test_names_are_quoted(self):
        truss = self.folder / "odd.toml"
        name = self.solve("patterns", "two-bars.toml", "--mu", 2)["problem"]["contact"][0]["node"]
        source = (EXAMPLES / "two-bars.toml").read_text()
        odd = json.dumps(ODD)
        truss.write_text(source.replace(f'"{name}"', odd).replace(f"\n{name} =", f"\n{odd} ="))
        result, rows = self.table("patterns", truss, "--mu", 2)
        self.assertEqual(result["problem"]["contact"][0]["node"], ODD)
        self.assertEqual(rows[0]["contact"], ODD)
        self.assertIn(f"r_n {ODD}", rows[0])

    def test_standard_output_has_only_the_table(self):
        place = self.folder / "table.csv"
        result = self.solve("critical", "plane-truss.toml", "--csv", place)
        run = self.kusabi("critical", result["problem"]["file"], "--csv", "-")
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, place.read_text(), ""))

    def test_one_file_for_two_outputs_is_refused(self):
        place = self.folder / "one"
        message = self.refused("patterns", EXAMPLES / "two-bars.toml", "--mu", 2, "--csv", place, "--output", place)
        self.assertIn("--output", message)
        self.assertFalse(place.exists())


if __name__ == "__main__":
    main()
