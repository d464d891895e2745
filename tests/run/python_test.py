"""run/python/kusabi.py runs the command and reads its files, alone and on two ranks.

    python3 python_test.py KUSABI SOURCES
"""
import ast
import csv
import json
import os
import pathlib
import sys
import types
import unittest.mock

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402

TRUSS = EXAMPLES / "space-truss.toml"


def without_statistics(result):
    return {key: value for key, value in result.items() if key != "statistics"}


class Python(KusabiCase):
    def setUp(self):
        super().setUp()
        chosen = unittest.mock.patch.dict(os.environ, {"KUSABI": KUSABI})
        chosen.start()
        self.addCleanup(chosen.stop)

    def test_a_result_is_that_of_the_command(self):
        expected = self.solve("patterns", "space-truss.toml", "--mu", 0.65)
        for ranks in (None, 2):
            with self.subTest(ranks=ranks):
                result = kusabi.run("patterns", TRUSS, mu=0.65, ranks=ranks)
                self.assertEqual(without_statistics(result), without_statistics(expected))
                self.assertEqual(len(result["statistics"]["ranks"]), ranks or 1)
                self.assertFalse(result.partial)
                self.assertEqual(result.remarks, [])
        self.assertEqual(result.answer, expected["result"])
        self.assertEqual(result.candidates, [each["node"] for each in expected["problem"]["contact"]])
        self.assertEqual(result.structure, expected["problem"]["structure"])
        self.assertEqual(kusabi.load(self.result), expected)

    def test_options_are_those_of_the_command(self):
        kept = self.folder / "kept.json"
        result = kusabi.run("mip", SOURCES / "tests" / "programs" / "knapsack.lp", cuts="disjunctive", no_tighten=True,
                            no_dive=False, time_limit=None, output=kept)
        self.assertEqual(result["options"], {"cuts": "disjunctive", "branching": "paper", "order": "depth-first",
                                             "no_tighten": True, "no_dive": False})
        self.assertEqual(kusabi.load(kept), result)
        class Float64(float):
            """As in NumPy 2."""

            def __repr__(self):
                return f"np.float64({float(self)})"

        mu = 0.1 + 0.2  # with all digits
        for same in (mu, Float64(mu)):
            self.assertEqual(kusabi.run("rays", EXAMPLES / "plane-truss.toml", mu=same)["options"]["mu"], mu)

    def test_a_problem_may_be_a_text(self):
        for ranks in (None, 2):
            result = kusabi.run("critical", "-", input=(EXAMPLES / "two-bars.toml").read_text(), ranks=ranks)
            self.assertEqual(result["problem"]["name"], kusabi.run("critical", EXAMPLES / "two-bars.toml")["problem"]["name"])

    def test_a_file_name_is_not_read_as_an_option(self):
        odd = self.folder / "--mu"
        odd.write_text((EXAMPLES / "two-bars.toml").read_text())
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        with unittest.mock.patch.dict(os.environ, {"KUSABI": os.path.abspath(KUSABI)}):
            os.chdir(self.folder)
            self.assertEqual(kusabi.run("critical", "--mu")["problem"]["file"], "./--mu")

    def test_wrong_input_raises_one_line(self):
        wrong = self.folder / "wrong.toml"
        wrong.write_text(TRUSS.read_text().replace("dimension", "dimensoin"))
        message = self.refused("patterns", wrong, "--mu", 1).rstrip("\n")
        for ranks in (None, 2):
            with self.subTest(ranks=ranks), self.assertRaises(kusabi.WrongInput) as caught:
                kusabi.run("patterns", wrong, mu=1, ranks=ranks)
            self.assertEqual(str(caught.exception), message)
            self.assertEqual(caught.exception.returncode, 2)
        with self.assertRaisesRegex(kusabi.WrongInput, "--fricton"):
            kusabi.run("patterns", TRUSS, mu=1, fricton=1)
        # A warning precedes the error, and is not part of it.
        with self.assertRaisesRegex(kusabi.WrongInput, "^--method polyhedral: "):
            kusabi.run("patterns", EXAMPLES / "paper" / "elastic-body.toml", mu=1, method="polyhedral")

    def test_a_proof_that_is_refused_is_a_failure(self):
        certificate = self.folder / "a.cert"
        truss = EXAMPLES / "plane-truss.toml"
        kusabi.run("patterns", truss, mu=0.8, certificate=certificate)
        self.assertIn("\nPROVED: ", kusabi.call("verify", certificate, problem=truss))
        with self.assertRaisesRegex(kusabi.Failed, r"a\.cert: refused: ") as caught:
            kusabi.call("verify", certificate, problem=EXAMPLES / "two-bars.toml", ranks=2)
        self.assertEqual(caught.exception.returncode, 1)

    def test_a_failing_launcher_is_a_failure(self):
        launcher = self.folder / "launcher"
        dashes = "-" * 74
        launcher.write_text(f"#!/bin/sh\ncat >&2 <<END\n{dashes}\nThere are not enough slots\nto be had.\n{dashes}\nEND\nexit 213\n")
        launcher.chmod(0o755)
        with unittest.mock.patch.dict(os.environ, {"KUSABI_MPIRUN": str(launcher)}):
            with self.assertRaisesRegex(kusabi.Failed, "^There are not enough slots$"):
                kusabi.run("patterns", TRUSS, mu=1, ranks=2)

    def test_a_run_that_is_stopped_is_partial(self):
        for command, name, options in (("patterns", "space-truss.toml", {"mu": 0.65, "node_limit": 2}),
                                       ("critical", "space-truss.toml", {"node_limit": 2}),
                                       ("rays", "plane-truss.toml", {"mu": 0.6, "node_limit": 2, "method": "tree"}),
                                       ("mip", "../tests/programs/generalised-assignment.mps", {"node_limit": 2})):
            with self.subTest(command):
                result = kusabi.run(command, EXAMPLES / name, output=self.result, **options)
                self.assertTrue(result.partial)
                self.assertIn("node-limit", result.remarks[0])
                self.assertTrue(kusabi.load(self.result).partial)

    def test_an_undecided_answer_is_partial(self):
        result = self.solve("patterns", "two-bars.toml", "--mu", 2)
        for answered in (True, False):
            result["verdict"]["answered"] = answered
            self.result.write_text(json.dumps(result))
            self.assertEqual(kusabi.load(self.result).partial, not answered)
        for command, words in (("limit", ("gust.toml",)), ("limit", ("gust.toml", "--alpha", 0.5)),
                               ("critical", ("two-bars.toml",)), ("mip", ("../tests/programs/parity.lp",))):
            self.solve(command, *words)
            self.assertFalse(kusabi.load(self.result).partial)

    def test_rows_are_those_of_the_table(self):
        place = self.folder / "table.csv"
        for command, name, options in (("patterns", "plane-truss.toml", {"mu": 0.8}), ("critical", "plane-truss.toml", {}),
                                       ("rays", "plane-truss.toml", {"mu": 0.6}), ("limit", "gust.toml", {"alpha": 0.5}),
                                       ("limit", "gust.toml", {}), ("mip", "../tests/programs/knapsack.lp", {})):
            with self.subTest(command=command, options=options):
                rows = kusabi.run(command, EXAMPLES / name, csv=place, **options).rows()
                with place.open(newline="") as file:
                    table = list(csv.DictReader(file))
                self.assertEqual(len(rows), len(table))
                shared = [key for key in table[0] if key in rows[0] and key != "state"]
                self.assertGreaterEqual(len(shared), 1)
                for row, cells in zip(rows, table):
                    for key in shared:
                        value = row[key]
                        if isinstance(value, float):
                            self.assertEqual(float(cells[key]), value)
                        else:
                            expected = "" if value is None else " ".join(value) if isinstance(value, list) else str(value)
                            self.assertEqual(cells[key], expected)
                if command == "limit":
                    self.assertEqual(list(rows[0]), list(table[0]))

    def test_rows_of_a_sweep_are_patterns_points_or_steps(self):
        result = kusabi.run("sweep", EXAMPLES / "plane-truss.toml", mu="0.5:0.8:0.1")
        self.assertFalse(result.partial)
        births = result.rows()
        self.assertEqual([row["pattern"] for row in births], list(range(1, 12)))
        self.assertEqual([row["upper"] for row in births], sorted(row["upper"] for row in births))
        self.assertEqual([row["count"] for row in result.rows("points")], [1, 1, 5, 11])
        stairs = result.rows("staircase")
        for point in result.rows("points"):
            within = [step["count"] for step in stairs if step["from"] <= point["mu"] <= step["to"]]
            self.assertEqual(within, [point["count"]])
        with self.assertRaisesRegex(kusabi.Error, "no table 'curve'; expected one of points, staircase, patterns"):
            result.rows("curve")
        loads = kusabi.run("sweep", EXAMPLES / "gust.toml", alpha="0:0.6:0.2")
        self.assertEqual([row["alpha"] for row in loads.rows()], [0, 0.2, 0.4, 0.6])
        self.assertEqual(loads.rows("curve")[0]["yielding"], ["a0-a1", "a1-a2", "a1-b1"])
        self.assertTrue(kusabi.run("sweep", EXAMPLES / "two-bars.toml", mu="1,2,3", output=self.result).partial)
        self.assertTrue(kusabi.load(self.result).partial)  # 2 is critical

    def test_a_data_frame_is_made_if_pandas_is_installed(self):
        result = kusabi.run("patterns", EXAMPLES / "plane-truss.toml", mu=0.8)
        with unittest.mock.patch.dict(sys.modules, {"pandas": None}):
            self.assertEqual(result.to_dataframe(), result.rows())
        frame = types.SimpleNamespace(DataFrame=lambda rows: ("frame", rows))
        with unittest.mock.patch.dict(sys.modules, {"pandas": frame}):
            self.assertEqual(result.to_dataframe(), ("frame", result.rows()))

    def test_a_missing_command_is_reported(self):
        for variable in ("KUSABI", "KUSABI_MPIRUN"):
            with unittest.mock.patch.dict(os.environ, {variable: "/nowhere/at-all"}):
                with self.assertRaisesRegex(kusabi.NotFound, "/nowhere/at-all.*" + variable):
                    kusabi.run("patterns", TRUSS, mu=1, ranks=2)

    def test_a_file_that_is_no_result_is_refused(self):
        for text, why in (("", "is no JSON"), ("[1]", "'command' is missing"), ('{"command": "mip"}', "'problem' is missing"),
                          ("[" * 100000, "is no JSON")):
            self.result.write_text(text)
            with self.subTest(text[:20]), self.assertRaisesRegex(kusabi.WrongInput, why):
                kusabi.load(self.result)
        with self.assertRaises(OSError):
            kusabi.load(self.folder / "nowhere.json")

    def test_module_requires_only_python_3_9(self):
        tree = ast.parse(pathlib.Path(kusabi.__file__).read_text(), feature_version=(3, 9))
        needed = {name.name for node in tree.body if isinstance(node, ast.Import) for name in node.names}
        self.assertLessEqual(needed, {"json", "os", "pathlib", "shlex", "shutil", "subprocess", "tempfile"})


if __name__ == "__main__":
    main()
