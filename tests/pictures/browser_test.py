"""Tests of the page of kusabi report in a real browser: on a phone, in dark mode, printed, with the keyboard, and
with many patterns. Headless Chromium opens copies of pages, each in a frame as wide as a phone, with a
script that examines them (page_probe.js).

    python3 browser_test.py KUSABI SOURCES

Exit code 77 (skipped): there is no Chromium (Debian: chromium).
"""
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop()).resolve()
KUSABI = sys.argv.pop()
BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
if BROWSER is None:
    print("skipped: there is no Chromium to open pages with (Debian: chromium)")
    sys.exit(77)
PROBE = (pathlib.Path(__file__).resolve().parent / "page_probe.js").read_text()
PHONE = 360
# Patterns of the longest page; more every night.
MANY = 10000 if "KUSABI_THOROUGH" in os.environ else 1000
PAPER = 700  # A4 between its margins
# Cards outside of the viewport are laid out, too.
ALL_LAID_OUT = "<style>li.answer { content-visibility: visible !important; }</style>"
HARNESS = """<!DOCTYPE html><meta charset="utf-8"><title>frames</title><body><script>
const found = {};
addEventListener("message", event => {
  const frame = [...document.querySelectorAll("iframe")].find(each => each.contentWindow === event.source);
  found[frame.name] = event.data;
  document.title = JSON.stringify(found);
});
</script>"""


def width(name):
    return PAPER if name.endswith("printed") else PHONE


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.pages = {}
        example = lambda name: SOURCES / "examples" / name
        cls.solve("patterns", "patterns", example("space-truss.toml"), "--mu", 0.65)
        cls.solve("body", "critical", example("wedge-in-groove.toml"))
        cls.solve("limit", "limit", example("gust.toml"), "--alpha", 0.5)
        cls.solve("sweep", "sweep", example("plane-truss.toml"), "--mu", "0.5:0.8:0.1")
        cls.solve("taper", "critical", example("morse-taper.toml"))
        cls.many(250), cls.many(MANY)
        for name, page in list(cls.pages.items()):
            brief = name.startswith("many")
            page = page.replace("<html ", f'<html data-look="{"briefly" if brief else "closely"}" ', 1)
            page = page.replace("<meta charset", f"<script>{PROBE}</script>{'' if brief else ALL_LAID_OUT}<meta charset", 1)
            (cls.folder / f"{name}.html").write_text(page)
            # Print styles, applied on the screen.
            (cls.folder / f"{name}-printed.html").write_text(page.replace("@media print", "@media screen"))
        # The first frames are in view, where a view that turns is drawn again.
        cls.light = cls.visit(["taper", "patterns", "body", "limit", "sweep", "taper-printed", "patterns-printed", "limit-printed", "many-250",
                               f"many-{MANY}"], ["--force-prefers-reduced-motion"])
        cls.dark = cls.visit(["patterns", "body", "limit", "sweep", "taper"], ["--blink-settings=preferredColorScheme=0"])

    @classmethod
    def kusabi(cls, *words):
        run = subprocess.run([KUSABI, *map(str, words), "--serial"], capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr

    @classmethod
    def report(cls, name, result):
        page = cls.folder / "report.html"
        cls.kusabi("report", result, "--output", page)
        cls.pages[name] = page.read_text()

    @classmethod
    def solve(cls, name, command, file, *words):
        result = cls.folder / f"{name}.json"
        cls.kusabi(command, file, *words, "--output", result)
        cls.report(name, result)

    @classmethod
    def many(cls, count):
        """A page of `count` patterns: those of a small truss, repeated."""
        result = cls.folder / "few.json"
        cls.kusabi("patterns", SOURCES / "examples/plane-truss.toml", "--mu", 0.8, "--output", result)
        document = json.loads(result.read_text())
        patterns = document["result"]["patterns"]
        document["result"].update(count=count, patterns=[patterns[i % len(patterns)] for i in range(count)])
        result.write_text(json.dumps(document))
        cls.report(f"many-{count}", result)

    @classmethod
    def chromium(cls, *words):
        call = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--enable-logging=stderr", "--v=0",
                f"--user-data-dir={cls.folder / 'profile'}", *words]
        run = subprocess.run(call, capture_output=True, text=True, check=False, timeout=240)
        assert run.returncode == 0, run.stderr
        cls.console = [line for line in run.stderr.splitlines() if "CONSOLE" in line]
        return run.stdout

    @classmethod
    def visit(cls, names, words):
        """Findings of the probes in these pages, by name."""
        frames = "".join(f'<iframe name="{name}" width="{width(name)}" height="800" src="{name}.html" style="border: 0">'
                         '</iframe>' for name in names)
        harness = cls.folder / "harness.html"
        harness.write_text(HARNESS + frames)
        dump = cls.chromium(*words, "--virtual-time-budget=10000", "--dump-dom", harness.as_uri())
        assert not cls.console, cls.console
        title = re.search("<title>(.*?)</title>", dump, re.DOTALL)[1]
        found = json.loads(html.unescape(title))
        assert set(found) == set(names), (sorted(found), names)
        return found

    def test_no_page_has_an_error(self):
        for found in (self.light, self.dark):
            for name, seen in found.items():
                self.assertEqual(seen["faults"], [], name)

    def test_pages_fit_a_phone_and_paper(self):
        for name, seen in self.light.items():
            with self.subTest(name):
                self.assertEqual(seen["inner"], width(name))
                self.assertLessEqual(seen["closed"], width(name))
                self.assertLessEqual(seen.get("open", 0), width(name))

    def test_text_has_sufficient_contrast_in_light_and_dark_mode(self):
        for found, dark in ((self.light, False), (self.dark, True)):
            for name in ("patterns", "body", "limit", "taper"):
                with self.subTest(name, dark=dark):
                    seen = found[name]
                    self.assertEqual(seen["dark"], dark)
                    self.assertGreaterEqual(seen["contrast"]["ratio"], 4.5, seen["contrast"]["of"])
        self.assertNotEqual(self.light["body"]["paper"], self.dark["body"]["paper"])

    def test_letters_in_pictures_are_large_enough_on_a_phone(self):
        for name in ("patterns", "body", "limit", "sweep", "taper"):
            with self.subTest(name):
                letters = self.light[name]["letters"]
                self.assertGreater(letters["height"], 8, letters["of"])

    def test_all_controls_can_be_reached_by_keyboard(self):
        for name in ("patterns", "body", "limit", "taper"):
            self.assertEqual(self.light[name]["reach"], [], name)

    def test_a_body_in_space_can_be_rotated(self):
        view = self.light["taper"]["turning"]
        self.assertGreater(view["drawn"], 0.1)
        self.assertTrue(view["turned"])
        self.assertFalse(view["picture"])
        self.assertTrue(self.light["taper-printed"]["turning"]["picture"])
        self.assertIsNone(self.light["body"]["turning"])

    def test_the_gallery_is_filtered_and_sorted(self):
        gallery = self.light["patterns"]["gallery"]
        patterns = json.loads((self.folder / "patterns.json").read_text())
        name = patterns["problem"]["contact"][0]["node"]
        count = patterns["result"]["count"]
        with_it = sum(name in pattern["contact"] for pattern in patterns["result"]["patterns"])
        self.assertEqual(gallery["said"], [f"{count} of {count} shown", f"{with_it} of {count} shown"])
        self.assertEqual(gallery["found"], with_it)
        self.assertLess(with_it, count)
        self.assertTrue(gallery["right"] and gallery["sorted"])

    def test_print_has_no_controls_and_no_folded_parts(self):
        for name in ("patterns", "limit"):
            printed = self.light[f"{name}-printed"]
            self.assertFalse(printed["controls"])
            self.assertEqual(printed["folded"], 0)
        self.assertTrue(self.light["patterns"]["controls"])
        self.assertGreater(self.light["patterns"]["folded"], 0)
        paper = self.folder / "paper.pdf"
        (self.folder / "whole.html").write_text(self.pages["patterns"])
        self.chromium(f"--print-to-pdf={paper}", (self.folder / "whole.html").as_uri())
        self.assertEqual(self.console, [])
        sheets = re.findall(rb"/Type\s*/Page\b", paper.read_bytes())
        self.assertGreater(len(sheets), 2)
        self.assertLess(len(sheets), 15)  # the first ten and a table

    # Limit: a browser loads a page of this size within about a second.
    def test_a_page_of_many_patterns_is_complete_and_small(self):
        for count in (250, MANY):
            name = f"many-{count}"
            seen = self.light[name]
            self.assertEqual(seen["gallery"]["said"][0], f"{count} of {count} shown")
            self.assertTrue(seen["gallery"]["right"] and seen["gallery"]["sorted"])
            self.assertLess(seen["elements"], 20000 + 12 * count)
            self.assertLess(len(self.pages[name]), 1e6 + 500 * count)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
