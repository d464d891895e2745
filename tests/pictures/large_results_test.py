"""Tests of kusabi draw and report with large result files: answers that are not drawn take no memory.

    python3 large_results_test.py KUSABI SOURCES
"""
import json
import os
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KUSABI, KusabiCase, main  # noqa: E402: beside the folder of this file


class LargeResults(KusabiCase):
    def megabytes(self, *words):
        """Peak memory of a call."""
        # The output is not written to a file, which would be synced together with all other pending
        # writes.
        child = subprocess.Popen([KUSABI, *map(str, words), "--serial", "--quiet"], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(child.returncode, 0)
        return usage.ru_maxrss / 1024

    def test_a_file_longer_than_any_problem_is_read(self):
        self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        with self.result.open("a") as file:
            file.write(" " * (65 << 20))
        for command in ("report", "draw"):
            self.megabytes(command, self.result)

    def test_answers_without_a_picture_take_no_memory(self):
        result = self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        structure, patterns = result["problem"]["structure"], result["result"]["patterns"]
        more = 5000
        structure["node_names"] += [f"more {i}" for i in range(more)]
        structure["positions"] += [[0, 0]] * more
        for pattern in patterns:
            del pattern["all_displacements"], pattern["support_reactions"]

        def needed(count, *words):
            result["result"]["patterns"] = [patterns[i % len(patterns)] for i in range(count)]
            self.result.write_text(json.dumps(result))
            return self.megabytes(words[0], self.result, *words[1:])

        # One pattern in a picture takes more than 24 bytes per node; two thousand of them take 240
        # MB.
        for words, shown in ((("report",), 60), (("draw",), 60), (("draw", "--pattern", 50), 60)):
            with self.subTest(words):
                self.assertLess(needed(shown + 2000, *words) - needed(shown, *words), 80)

    def test_a_body_of_many_nodes_is_read_in_linear_time(self):
        # A linear search for each name takes 10^10/2 steps: ten seconds.
        result = self.solve("patterns", "two-bars.toml", "--mu", 2.5)
        structure, pattern = result["problem"]["structure"], result["result"]["patterns"][0]
        names = [f"more {i}" for i in range(100000)]
        structure["node_names"] += names
        structure["positions"] += [[0, 0]] * len(names)
        pattern["all_displacements"] += [[0, 0]] * len(names)
        pattern["support_reactions"].update({name: [0, 0] for name in names})
        self.result.write_text(json.dumps(result))
        before = os.times()
        self.megabytes("draw", self.result, "--pattern", 1)
        after = os.times()
        self.assertLess(after.children_user - before.children_user, 2)


if __name__ == "__main__":
    main()
