"""Tests of .ci/check_arrows: each violation in a small source tree is reported in one line.

    python3 check_arrows_test.py CHECK_ARROWS
"""
import unittest

from planted import Planted

TABLE = "low:\nlow/cellar: low\nhigh: low low/cellar\n"
PAGE = "# Architecture\n\n```arrows\n{}```\n"


class CheckArrows(Planted):
    def setUp(self):
        super().setUp()
        self.write("docs/architecture.md", PAGE.format(TABLE))
        self.write("low/stone.hpp", "#include <vector>\n")
        self.write("low/cellar/wine.hpp", '#include "low/stone.hpp"\n')
        self.write("high/roof.cpp", '#include "roof.hpp"\n#include "low/cellar/wine.hpp"\n')
        self.write("high/roof.hpp", "")
        self.write("tests/roof_test.cpp", '#include "high/roof.hpp"\n')

    def test_accepts_includes_permitted_by_the_table(self):
        code, lines = self.check()
        self.assertEqual((code, len(lines)), (0, 1))
        self.assertRegex(lines[0], "^4 sources in 3 modules")

    def test_names_file_and_line_of_a_wrong_include(self):
        self.write("low/stone.hpp", '// a stone\n#  include "high/roof.hpp"\n')
        self.assertEqual(self.check(), (1, ["low/stone.hpp:2: module low may not include module high (allowed: none)"]))

    def test_a_nested_module_is_separate_from_its_parent(self):
        self.write("low/stone.hpp", '#include "cellar/wine.hpp"\n')
        self.assertEqual(self.check(), (1, ["low/stone.hpp:1: module low may not include module low/cellar (allowed: none)"]))

    def test_headers_in_detail_folders_are_private(self):
        self.write("low/detail/mortar.hpp", "")
        self.write("low/stone.hpp", '#include "low/detail/mortar.hpp"\n')
        self.assertEqual(self.check()[0], 0)
        self.write("high/roof.hpp", '#include "low/detail/mortar.hpp"\n')
        self.assertEqual(
            self.check(),
            (1, ["high/roof.hpp:1: low/detail/mortar.hpp is a detail of module low; expected a public header"]))

    def test_no_module_includes_tests(self):
        self.write("high/roof.hpp", '#include "tests/roof_test.cpp"\n')
        self.assertEqual(
            self.check(),
            (1, ["high/roof.hpp:1: module high may not include module tests (allowed: low low/cellar)"]))

    def test_finds_a_cycle_of_modules(self):
        self.write("docs/architecture.md", PAGE.format(TABLE.replace("low:", "low: high")))
        self.assertEqual(
            self.check(), (1, ["docs/architecture.md: modules include each other in a circle: low -> high -> low"]))

    def test_refuses_a_source_outside_all_modules(self):
        self.write("shed/spade.hpp", "")
        self.write("low/attic/box.hpp", "")
        self.assertEqual(self.check(), (1, [
            "low/attic/box.hpp: low/attic is not a module; expected it beside the others of low/ in docs/architecture.md",
            "shed/spade.hpp: in no module; expected its folder among those of docs/architecture.md"]))

    def test_refuses_an_include_of_a_missing_file(self):
        self.write("high/roof.hpp", '#include "low/brick.hpp"\n')
        self.assertEqual(self.check(), (
            1, ['high/roof.hpp:1: no file "low/brick.hpp"; expected a path from the root of the sources']))

    def test_refuses_a_module_without_sources(self):
        self.write("docs/architecture.md", PAGE.format(TABLE + "garden: low\n"))
        self.assertEqual(self.check(), (
            1, ["docs/architecture.md: garden has no source; expected a module with at least one"]))

    def test_refuses_a_table_with_an_unknown_module(self):
        self.write("docs/architecture.md", PAGE.format(TABLE + "garden: pond\n"))
        code, lines = self.check()
        self.assertEqual(code, 2)
        self.assertRegex(lines[0], r"/docs/architecture.md:7: pond is not a module; expected one that has a line$")


if __name__ == "__main__":
    unittest.main()
