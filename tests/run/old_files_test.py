"""Files of older versions (tests/old-files/) are still read.

    python3 old_files_test.py KUSABI SOURCES
"""
import os
import shutil
import sys
import pathlib

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

os.environ["KUSABI"] = KUSABI
sys.path.append(str(SOURCES / "run" / "python"))
import kusabi  # noqa: E402: of the sources

OLD = SOURCES / "tests" / "old-files" / "0.1"


class OldFiles(KusabiCase):
    def proved(self, name, *words):
        run = self.kusabi("verify", OLD / name, *words)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("PROVED", run.stdout)
        return run.stdout

    def test_certificates_are_proved(self):
        self.assertIn("the list of 1 pattern is complete", self.proved("patterns.cert"))
        self.assertIn("the list of 11 patterns is complete", self.proved("plane-truss.cert"))
        self.assertIn("it cannot stick", self.proved("critical.cert.lower"))
        self.assertIn("the list of 1 pattern is complete", self.proved("critical.cert.upper"))
        self.assertIn("between 2.954320376", self.proved("limit.cert"))

    def test_certificates_are_proved_for_their_structures(self):
        self.proved("patterns.cert", "--problem", EXAMPLES / "two-bars.toml")
        self.proved("limit.cert", "--problem", EXAMPLES / "static-gap.toml")

    def test_a_changed_certificate_is_refused(self):
        text = (OLD / "patterns.cert").read_text()
        changed = self.folder / "changed.cert"
        changed.write_text(text.replace("0x1.4p+1", "0x1.5p+1"))
        self.assertNotEqual(changed.read_text(), text)
        self.assertNotEqual(self.kusabi("verify", changed).returncode, 0)

    def test_results_are_read(self):
        counts = {"patterns": 1, "plane-truss": 11, "rays": 16}
        for name in ("patterns", "plane-truss", "critical", "rays", "limit", "mip"):
            with self.subTest(name):
                result = kusabi.load(OLD / f"{name}.json")
                self.assertEqual(result["version"], "0.1.0")
                if name in counts:
                    self.assertEqual(result.answer["count"], counts[name])
        # The answers are those of the current version.
        new = self.solve("critical", "two-bars.toml")["result"]["critical_friction"]
        old = kusabi.load(OLD / "critical.json").answer["critical_friction"]
        self.assertLess(abs(old["lower"] - new["lower"]), 1e-7)
        self.assertLess(abs(old["upper"] - new["upper"]), 1e-7)

    def test_results_without_a_structure_are_not_drawn(self):
        for command in ("draw", "report"):
            self.assertIn("'structure' is missing", self.refused(command, OLD / "patterns.json"))

    def test_a_checkpoint_is_refused_and_kept(self):
        for name in ("state", "state.1.0"):
            shutil.copy(OLD / name, self.folder)
        message = self.refused("patterns", EXAMPLES / "plane-truss.toml", "--mu", 0.8, "--resume", self.folder / "state")
        self.assertIn("is not a state to resume from", message)
        for name in ("state", "state.1.0"):
            self.assertEqual((self.folder / name).read_bytes(), (OLD / name).read_bytes())


if __name__ == "__main__":
    main()
