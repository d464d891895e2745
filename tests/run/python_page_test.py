"""Programs on docs/python.md run and print the output shown.

    python3 python_page_test.py KUSABI SOURCES

Blocks that import a library that is not installed are skipped.
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

PAGE = SOURCES / "docs" / "python.md"


class Page(KusabiCase):
    def test_blocks_print_the_output_of_the_page(self):
        (self.folder / "examples").symlink_to(EXAMPLES)
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "kusabi").symlink_to(pathlib.Path(KUSABI).resolve())
        (programs / "python3").symlink_to(sys.executable)
        environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "PYTHONPATH": os.pathsep.join(
            filter(None, [str(SOURCES / "run" / "python"), os.environ.get("PYTHONPATH")]))}
        environment.pop("KUSABI", None)
        text = PAGE.read_text()
        blocks = re.findall(r"^```(python|sh)\n(.*?)^```\n```text\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        self.assertEqual(len(blocks), len(re.findall(r"^```(?:python|sh)$", text, re.MULTILINE)))
        for language, program, shown in blocks:
            imported = re.findall(r"^import (\w+)", program, re.MULTILINE)
            missing = [name for name in imported if name != "kusabi" and importlib.util.find_spec(name) is None]
            # DataFrames require pandas.
            if "to_dataframe" in program and importlib.util.find_spec("pandas") is None:
                missing.append("pandas")
            if missing:
                print(f"skipped, for there is no {missing[0]}: {program.splitlines()[-1]}", file=sys.stderr)
                continue
            with self.subTest(program):
                words = [sys.executable, "-c", program] if language == "python" else ["sh", "-e", "-c", program]
                run = subprocess.run(words, cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
                self.assertEqual((run.returncode, run.stdout), (0, shown), run.stderr)


if __name__ == "__main__":
    main()
