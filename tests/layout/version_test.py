"""The version of CMakeLists.txt is that of the citation, of the Debian changelog, and of the newest
section of NEWS.md; its date in the citation is that of the changelog.

    python3 version_test.py SOURCES
"""
import email.utils
import pathlib
import re
import sys
import unittest

SOURCES = pathlib.Path(sys.argv.pop())


def found(file, pattern):
    """First group of the first match in a file."""
    match = re.search(pattern, (SOURCES / file).read_text(), re.MULTILINE)
    return match.group(1) if match else f"no match in {file}"


class Version(unittest.TestCase):
    def test_is_the_same_in_all_places(self):
        version = found("CMakeLists.txt", r"^  VERSION (\d+\.\d+\.\d+)$")
        self.assertEqual(found("CITATION.cff", r"^version: (.*)$"), version)
        self.assertEqual(found("cmake/debian/changelog.Debian", r"^kusabi \((.*)-\d+\)"), version)
        self.assertEqual(found("NEWS.md", r"^## (.*)$"), version)

    def test_has_one_date(self):
        changed = email.utils.parsedate_to_datetime(found("cmake/debian/changelog.Debian", r"^ -- .*>  (.*)$"))
        self.assertEqual(found("CITATION.cff", r"^date-released: (.*)$"), changed.date().isoformat())


if __name__ == "__main__":
    unittest.main()
