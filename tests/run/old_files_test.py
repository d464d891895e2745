"""Certificates of older versions (tests/old-files/) are still proved, and their checkpoints refused.

    python3 old_files_test.py KUSABI SOURCES
"""
import shutil
import sys
import pathlib

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

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

    def test_a_checkpoint_is_refused_and_kept(self):
        for name in ("state", "state.1.0"):
            shutil.copy(OLD / name, self.folder)
        message = self.refused("patterns", EXAMPLES / "plane-truss.toml", "--mu", 0.8, "--resume", self.folder / "state")
        self.assertIn("is not a state to resume from", message)
        for name in ("state", "state.1.0"):
            self.assertEqual((self.folder / name).read_bytes(), (OLD / name).read_bytes())


if __name__ == "__main__":
    main()
