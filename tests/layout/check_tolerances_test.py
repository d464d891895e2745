"""Tests of .ci/check_tolerances: each violation in a small source tree is reported in one line.

    python3 check_tolerances_test.py CHECK_TOLERANCES
"""
import unittest

from planted import Planted

ROWS = """| name | file | value | relative to | why |
|---|---|---|---|---|
| `near` | `solvers/plane.hpp` | `1e-9` | \\|x\\| | rounding |
| `far` | `verify/plane.cpp` | `1 / near` | 1 | the other side |
| `width` | `run/critical/ends.hpp` | `1e-8` | 1 | an option |
"""


class CheckTolerances(Planted):
    def setUp(self):
        super().setUp()
        self.write("docs/tolerances.md", "# Numbers\n\n" + ROWS)
        self.write("solvers/plane.hpp", "inline constexpr double near = 1e-9;\n")
        self.write("verify/plane.cpp",
                   "constexpr double infinity = std::numeric_limits<double>::infinity();\n"
                   "constexpr double far =\n    1 / near;\n")
        self.write("run/critical/ends.hpp", "struct Ends {\n  double width = 1e-8;  // of a cell\n};\n")
        self.write("problems/families/bridge.cpp", "constexpr double span = 30;\n")

    def test_accepts_a_correct_page(self):
        self.assertEqual(self.check(), (0, ["2 numbers in the sources, 3 in docs/tolerances.md: the same"]))

    def test_finds_a_changed_value(self):
        self.write("solvers/plane.hpp", "// near\ninline constexpr double near = 1e-6;\n")
        self.assertEqual(self.check(), (1, [
            "solvers/plane.hpp:2: near = 1e-6 is not in docs/tolerances.md; line 5 has 1e-9",
            "docs/tolerances.md:5: solvers/plane.hpp has no near = 1e-9"]))

    def test_finds_a_new_number(self):
        self.write("nodes/limit/cut.cpp", "constexpr double kept = 0.5, lost = 0.1;\n")
        self.assertEqual(self.check(), (1, [
            "nodes/limit/cut.cpp:1: kept = 0.5 is not in docs/tolerances.md",
            "nodes/limit/cut.cpp:1: lost = 0.1 is not in docs/tolerances.md"]))

    def test_finds_a_moved_number(self):
        self.write("verify/line.cpp", "constexpr long double far = 1 / near;\n")
        (self.root / "verify/plane.cpp").unlink()
        self.assertEqual(self.check(), (1, [
            "verify/line.cpp:1: far = 1/near is not in docs/tolerances.md; line 6 has it in verify/plane.cpp",
            "docs/tolerances.md:6: verify/plane.cpp has no far = 1/near"]))

    def test_finds_a_changed_member(self):
        self.write("run/critical/ends.hpp", "struct Ends {\n  double width = 1e-7;\n  double half_width = 1e-8;\n};\n")
        self.assertEqual(self.check(), (1, ["docs/tolerances.md:7: run/critical/ends.hpp has no width = 1e-8"]))

    def test_refuses_a_row_without_a_reason(self):
        self.write("docs/tolerances.md", ROWS.replace("| rounding |", "| |"))
        code, lines = self.check()
        self.assertEqual(code, 2)
        self.assertRegex(lines[0], r"/docs/tolerances.md:3: .*; expected \| `name` \| `file` \| `value`")


if __name__ == "__main__":
    unittest.main()
