"""Tests of .ci/check_words: each forbidden term in a small source tree is reported in one line.

    python3 check_words_test.py CHECK_WORDS
"""
import unittest

from planted import Planted

PAGE = """# Words

```words
gift -> transfer
loose body -> unconstrained body
give way -> relax
```

```folders
engine
docs
```
"""


class CheckWords(Planted):
    def setUp(self):
        super().setUp()
        self.write("docs/words.md", PAGE)
        self.write("engine/rank.hpp", "// Rank: protocol of one rank.\nstruct Rank {};\n")

    def test_accepts_sources_and_the_page_itself(self):
        self.assertEqual(self.check(), (0, ["1 files in 2 folders: no forbidden term of docs/words.md"]))

    def test_finds_terms_in_comments_with_a_plural(self):
        self.write("engine/rank.cpp", "// Rank.\nint sent = 0;  // Gifts and loose\tbody\n")
        self.assertEqual(self.check(), (1, [
            "engine/rank.cpp:2: 'gifts'; expected: transfer",
            "engine/rank.cpp:2: 'loose body'; expected: unconstrained body"]))

    def test_finds_terms_in_identifiers(self):
        self.write("engine/rank.cpp", "double give_way = 0;\nclass LooseBody;\nint gifted = 0;\n")
        self.assertEqual(self.check(), (1, [
            "engine/rank.cpp:1: 'give way'; expected: relax",
            "engine/rank.cpp:2: 'loose body'; expected: unconstrained body"]))

    def test_finds_terms_in_scripts_without_a_suffix_but_not_in_data(self):
        self.write("engine/start", "#!/bin/bash\nsent=gift\n")
        self.write("engine/stop.sh", "gift=1\n")
        self.write("engine/data", "gift\n")
        self.assertEqual(self.check(), (1, [
            "engine/start:2: 'gift'; expected: transfer", "engine/stop.sh:1: 'gift'; expected: transfer"]))

    def test_ignores_strings_quotations_and_other_folders(self):
        self.write("engine/rank.cpp", '// Section "A loose body".\nauto key = "gift \\" sent";\n')
        self.write("run/main.cpp", "int gift = 0;\n")
        self.assertEqual(self.check()[0], 0)

    def test_finds_terms_in_pages_but_not_in_their_code(self):
        self.write("docs/engine.md", "A `gift` in [code](gift.md).\n```\ngift\n```\nA gift.\n")
        self.assertEqual(self.check(), (1, ["docs/engine.md:5: 'gift'; expected: transfer"]))

    def test_finds_comments_without_a_noun(self):
        self.write("engine/rank.cpp", "// Whether a rank waits.\nbool waits;  ///< what it does\n"
                                      "// The rank\n// which waits.\n# Which\n")
        self.assertEqual(self.check(), (1, [
            "engine/rank.cpp:1: a comment begins with 'Whether'; expected its noun",
            "engine/rank.cpp:2: a comment begins with 'what'; expected its noun"]))

    def test_refuses_an_invalid_page(self):
        for text, line in ((PAGE.replace("gift ->", "Gift ->"), r"^docs/words.md:4: 'Gift -> transfer'; expected TERM"),
                           (PAGE.replace("\nengine\n", "\nengines\n"), "^docs/words.md:10: engines is not a folder"),
                           ("# Words\n", "^docs/words.md: no block fenced as ```words")):
            with self.subTest(line):
                self.write("docs/words.md", text)
                code, lines = self.check()
                self.assertEqual(code, 2)
                self.assertRegex(lines[0], line)


if __name__ == "__main__":
    unittest.main()
