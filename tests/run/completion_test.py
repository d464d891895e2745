"""Output of `kusabi --completion` and `kusabi --manual`: bash completes calls with it, zsh and fish
accept it, and man reports no errors. Shells and man that are not installed are skipped.

    python3 completion_test.py KUSABI SOURCES
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file


def printed(*words):
    return subprocess.run([KUSABI, *words], check=True, capture_output=True, text=True).stdout


class Completion(KusabiCase):
    @classmethod
    def setUpClass(cls):
        cls.script = printed("--completion", "bash")

    def completed(self, line, folder="."):
        """Completions of bash for the last word of the line."""
        words = line.split(" ")
        call = (f"{self.script}\ncompopt() {{ :; }}\nCOMP_WORDS=({' '.join(map(shlex.quote, words))})\n"
                f"COMP_CWORD={len(words) - 1}\n_kusabi\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"")
        run = subprocess.run(["bash", "--norc", "-u", "-c", call], cwd=folder, capture_output=True, text=True)
        self.assertEqual(run.stderr, "")
        return run.stdout.split()

    @classmethod
    def files(cls, folder):
        for name in ("truss.toml", "other.json"):
            (pathlib.Path(folder) / name).touch()
        (pathlib.Path(folder) / "pictures").mkdir()

    def test_subcommands_are_completed(self):
        self.assertEqual(self.completed("kusabi pat"), ["patterns"])
        self.assertIn("example", self.completed("kusabi "))
        self.assertIn("help", self.completed("kusabi "))
        self.assertEqual(self.completed("kusabi --ver"), ["--version"])
        self.assertEqual(self.completed("kusabi example "), ["space-truss", "plane-truss", "grid", "dome", "tower"])
        self.assertEqual(self.completed("kusabi help exp"), ["export"])
        self.assertEqual(self.completed("kusabi help bench u"), ["uts"])
        self.assertEqual(self.completed("kusabi --completion z"), ["zsh"])

    def test_options_and_choices_are_completed(self):
        self.assertEqual(self.completed("kusabi patterns truss.toml --resu"), ["--resume", "--resume-wait"])
        self.assertEqual(self.completed("kusabi patterns --sort "), ["number", "margin", "contact", "critical"])
        self.assertEqual(self.completed("kusabi patterns --sort = mar"), ["margin"])
        self.assertEqual(self.completed("kusabi patterns --sort ="), ["number", "margin", "contact", "critical"])
        self.assertEqual(self.completed("kusabi example grid --b"), ["--bays"])
        self.assertIn("-o", self.completed("kusabi report -"))
        self.assertEqual(self.completed("kusabi patterns --mu "), [])
        self.assertEqual(self.completed("kusabi limit --mu"), [])

    def test_files_are_completed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.files(folder)
            self.assertEqual(sorted(self.completed("kusabi patterns ", folder)), ["other.json", "pictures", "truss.toml"])
            self.assertEqual(self.completed("kusabi patterns truss.toml --output o", folder), ["other.json"])
            self.assertEqual(self.completed("kusabi patterns truss.toml --vtu ", folder), ["pictures"])
            self.assertEqual(self.completed("kusabi patterns --mu 0.5 tr", folder), ["truss.toml"])
            self.assertEqual(self.completed("kusabi example grid tr", folder), [])

    def check_syntax(self, shell, *options):
        if shutil.which(shell) is None:
            self.skipTest(f"{shell} is not installed")
        with tempfile.NamedTemporaryFile("w", suffix="." + shell) as script:
            script.write(printed("--completion", shell))
            script.flush()
            run = subprocess.run([shell, *options, script.name], capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_zsh_accepts_the_script(self):
        self.check_syntax("zsh", "-n")

    def test_fish_accepts_the_script(self):
        self.check_syntax("fish", "--no-execute")

    def test_each_subcommand_and_group_has_a_manual_page(self):
        help_text = printed("help").split("Options of kusabi itself")[0]
        names = re.findall(r"^  (\w+(?: [\w-]+)?)  ", help_text, re.MULTILINE)
        self.assertIn("bench uts", names)
        groups = {name.split()[0] for name in names if " " in name}
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "-D", f"kusabi={KUSABI}", "-D", f"output={folder}", "-P", SOURCES / "cmake/manual.cmake"], check=True)
            pages = {path.stem: path.read_text() for path in pathlib.Path(folder, "man").iterdir()}
            self.assertEqual(set(pages), {"kusabi", *("kusabi-" + name.replace(" ", "-") for name in {*names, *groups})})
            for page, text in pages.items():
                for other in re.findall(r"\.BR (kusabi\S*) \(1\)", text):
                    self.assertIn(other.replace("\\-", "-"), pages, page)
            if shutil.which("mandoc") is not None:
                run = subprocess.run(["mandoc", "-T", "lint", *pathlib.Path(folder, "man").iterdir()], capture_output=True, text=True)
                self.assertEqual(run.stdout + run.stderr, "")

    def test_manual_pages_have_no_errors(self):
        if shutil.which("groff") is None:
            self.skipTest("groff is not installed")
        for words in ((), ("patterns",), ("limit",), ("example", "grid")):
            page = printed("--manual", *words)
            run = subprocess.run(["groff", "-man", "-Tutf8", "-ww"], input=page, capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn("stopped early or is partly undecided", run.stdout)


if __name__ == "__main__":
    main()
