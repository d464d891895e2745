"""Site of tools/site: its links have targets, and it loads nothing from the net. Skipped without
MkDocs.

    python3 site_test.py SITE BUILD
"""
import html.parser
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

BUILD = sys.argv.pop()
SITE = pathlib.Path(sys.argv.pop())


class Page(html.parser.HTMLParser):
    """Anchors and links of a page."""

    def __init__(self, text):
        super().__init__()
        self.names, self.links, self.loaded = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.names |= {values[key] for key in ("id", "name") if values.get(key)}
        if values.get("href"):
            (self.loaded if tag == "link" else self.links).append(values["href"])
        if values.get("src"):
            self.loaded.append(values["src"])


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.site = pathlib.Path(cls.folder.name) / "site"
        subprocess.run([SITE, "--no-api", "--build", BUILD, "--to", cls.site], check=True, stdout=subprocess.DEVNULL)
        cls.pages = {path: Page(path.read_text()) for path in cls.site.rglob("*.html") if path.name != "404.html"}

    def test_has_all_pages_and_the_reports(self):
        documents = SITE.parent.parent / "docs"
        expected = {path.relative_to(documents.parent).with_suffix(".html") for path in documents.rglob("*.md")}
        expected = {path.with_name("index.html") if path.stem == "README" else path for path in expected}
        made = {path.relative_to(self.site) for path in self.pages}
        self.assertEqual(expected - made, set())
        self.assertGreaterEqual(len([path for path in made if path.parent.name == "gallery"]), 6)

    def test_has_pictures_that_are_not_in_the_repository(self):
        papers = next(page for path, page in self.pages.items() if path.relative_to(self.site) == pathlib.Path("docs/papers.html"))
        for name in ("wedged-table-1", "limit-figure-5", "limit-figure-10"):
            self.assertIn(f"images/{name}.svg", papers.loaded)
            self.assertTrue((self.site / "docs" / "images" / f"{name}.svg").exists())

    def test_links_have_targets(self):
        for path, page in self.pages.items():
            for link in page.links:
                target = urllib.parse.urlsplit(link)
                if target.scheme:
                    continue
                file = (path.parent / urllib.parse.unquote(target.path)).resolve() if target.path else path.resolve()
                file = file / "index.html" if file.is_dir() else file
                self.assertTrue(file.exists(), f"{path}: {link}")
                if target.fragment and file.suffix == ".html":
                    names = next(other for name, other in self.pages.items() if name.resolve() == file).names
                    self.assertIn(urllib.parse.unquote(target.fragment), names, f"{path}: {link}")

    def test_nothing_is_loaded_from_the_internet(self):
        for path, page in self.pages.items():
            for link in page.loaded:
                self.assertIn(urllib.parse.urlsplit(link).scheme, ("", "data"), f"{path}: {link}")

    def test_another_folder_is_not_overwritten(self):
        with tempfile.TemporaryDirectory() as other:
            (pathlib.Path(other) / "thesis.tex").touch()
            run = subprocess.run([SITE, "--build", BUILD, "--to", other], capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 1)
            self.assertIn("is not a site", run.stderr)
            self.assertTrue((pathlib.Path(other) / "thesis.tex").exists())


if __name__ == "__main__":
    if shutil.which("mkdocs") is None:
        sys.exit(77)
    unittest.main()
