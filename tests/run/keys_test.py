"""Keys in docs/problem-files.md, compared with those of the reader.

    python3 keys_test.py KUSABI SOURCES
"""
import pathlib
import re
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

PAGE = SOURCES / "docs" / "problem-files.md"
WITH_NODES = {"except", "every"}  # a table of their own, for all lists of nodes
# Sections of the page, in its order, and an empty value of each. Keys of [nodes] are names of
# nodes.
SECTIONS = [
    ("members", ""), ("elements", ""), ("mesh", ""), ("mesh", 'name = "b"\nfile = "doorstop.msh"'), ("material", 'groups = ["stop.rubber"]'),
    ("supports", ""), ("ties", ""), ("springs", ""), ("stiffness", ""), ("contact", ""), ("loads", ""), ("uncertainty", ""),
    ("uncertainty", 'name = "c"'), ("combinations", ""), ("actions", ""),
]
# Text before a section with an unknown key, and its header, where they differ from the others.
BEFORE = {"combinations": '[[actions]]\nname = "snow"\n', "actions": '[combinations]\nrule = "6.10"\nreference = "snow"\n'}
HEADERS = {"combinations": "[combinations]"}


def page_sections():
    """Pairs of a section and its keys, in the order of the table."""
    table = PAGE.read_text().split("\n## Every key\n\n")[1].split("\n\n")[0]
    found = []
    for row in table.splitlines()[2:]:
        section, keys = row.split(" | ")[:2]
        if section != "|":
            found.append((re.sub(r"[|`\[\] ]", "", section), set()))
        found[-1][1].update(re.findall(r"`(\w+)`", keys))
    return [(section, keys | (WITH_NODES if "nodes" in keys else set())) for section, keys in found]


class Keys(KusabiCase):
    def known(self, addition):
        """Known keys, as listed by the reader for a section with an unknown key."""
        problem = self.folder / "problem.toml"
        problem.write_text((EXAMPLES / "doorstop.toml").read_text() + addition)
        shutil.copy(EXAMPLES / "doorstop.msh", self.folder)
        said = self.refused("show", problem)
        self.assertIn('unknown key "zzz"', said)
        return set(re.search(r"expected one of ([\w, ]+)", said)[1].split(", "))

    def test_the_table_has_all_keys(self):
        table = page_sections()
        self.assertEqual([name for name, _ in table], ["topofthefile", "nodes", *(name for name, _ in SECTIONS)])
        self.assertEqual(self.known("[zzz]\n"), table[0][1] | {name for name, _ in table[1:]})
        for (name, start), (_, keys) in zip(SECTIONS, table[2:]):
            with self.subTest(name):
                self.assertEqual(self.known(f"\n{BEFORE.get(name, '')}{HEADERS.get(name, f'[[{name}]]')}\n{start}\nzzz = 1\n"), keys)

    def test_the_table_has_the_keys_of_node_lists(self):
        besides = PAGE.read_text().split("Wherever a table has `nodes`, it may also have\n\n")[1].split("\n\n")[0]
        self.assertEqual(set(re.findall(r"(?m)^\| `(\w+)` \|", besides)), WITH_NODES)


if __name__ == "__main__":
    main()
