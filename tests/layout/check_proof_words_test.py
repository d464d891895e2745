"""Tests of .ci/check_proof_words: each word of proof in a text outside answer/ is reported in one line.

    python3 check_proof_words_test.py CHECK_PROOF_WORDS
"""
import unittest

from planted import Planted


class CheckProofWords(Planted):
    def found(self, text, file="run/table.cpp"):
        """Lines and words that are reported."""
        self.write(file, text)
        code, lines = self.check()
        self.assertEqual(code, 1 if "in a text" in lines[0] else 0, lines)
        return [tuple(line.split("'")[0:2]) for line in lines] if code else []

    def test_finds_each_word_in_any_case(self):
        for word in ("proved", "Proven", "PROVED", "unproved", "not proved", "prove", "proof", "guaranteed", "certain"):
            with self.subTest(word):
                self.assertEqual(self.found(f'int a;\nauto text = "the bound is {word}.";\n'),
                                 [("run/table.cpp:2: ", word.removeprefix("not "))])

    def test_finds_words_of_standings_that_are_not_names(self):
        for line in ('return is ? "proved" : "computed";', 'csv.word("proved");', 'page.words(row, is ? "" : "proved");', 'text += fmt::format("{}, {}", bound, "proved");'):
            with self.subTest(line):
                self.assertEqual(self.found(line), [("run/table.cpp:1: ", "proved")])

    def test_finds_words_that_are_cut_in_two_literals(self):
        self.assertEqual(self.found('auto text = "a bound is "\n    "pro" "ved";\n'), [("run/table.cpp:1: ", "proved")])

    def test_finds_words_after_the_description_of_an_option(self):
        self.assertEqual(self.found('table.flag("--prove", &it, "prove it");\nauto text = "proved";\n'),
                         [("run/table.cpp:2: ", "proved")])

    def test_accepts_names_comments_options_and_descriptions(self):
        for line in ('json["proved"] = true;', 'json = {{"proved", is}, {"lower_proved", is}};', 'field("unproved", it);',
                     'out << "row,lower,proved,upper\\n";', '// A proof: "proved".', 'auto text = "--prove was not given";',
                     'table.flag("--prove", &it, "prove it");', 'R r{.name = "a", .purpose = "exact proof of a claim"};',
                     '#include "verify/wedged/proof.hpp"', 'auto text = "an uncertain load, and the guaranteed_interval";'):
            with self.subTest(line):
                self.assertEqual(self.found(line), [])

    def test_leaves_the_rooms_of_proof_alone(self):
        for file in ("answer/words.cpp", "verify/proof.cpp", "tests/run/table_test.cpp"):
            self.write(file, 'auto text = "it is proved";\n')
        self.assertEqual(self.found(""), [])


if __name__ == "__main__":
    unittest.main()
