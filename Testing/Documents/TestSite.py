# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""The web site is built without a warning, and its pages hold what they promise.

Needs Doxygen, Sphinx, MyST, Breathe and Furo.
"""

import importlib.util
import re
import shutil
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path

sys.dont_write_bytecode = True
TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Testing"))

import classes  # noqa: E402

SITE = Path("site").resolve()
HTML = SITE / "html"


class Addresses(HTMLParser):
    """The links and the names of places of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.names = [], {""}
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if attrs.get("id"):
            self.names.add(attrs["id"])
        if tag == "img" or tag == "a":
            self.links.append(attrs.get("src") or attrs.get("href") or "")


class Site(unittest.TestCase):
    """One build for all."""

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SITE, ignore_errors=True)
        cls.build = subprocess.run(
            [sys.executable, "-B", str(TOP / "Documentation" / "site" / "make_site.py"), str(SITE)],
            capture_output=True, text=True, check=False)
        cls.pages = {path: Addresses(path.read_text(encoding="utf-8")) for path in HTML.rglob("*.html")
                     if path.name not in ("genindex.html", "search.html")}

    def test_no_warning(self):
        self.assertEqual(self.build.returncode, 0, (self.build.stdout + self.build.stderr)[-4000:])
        self.assertNotIn("WARNING", self.build.stdout + self.build.stderr)

    def test_links(self):
        broken = []
        for page, addresses in self.pages.items():
            for link in addresses.links:
                if re.match(r"[a-z]+:", link):
                    continue
                name, _, anchor = link.partition("#")
                target = (page.parent / name).resolve() if name else page
                if not target.is_file():
                    broken.append(f"{page.relative_to(HTML)}: {link}")
                elif target in self.pages and anchor not in self.pages[target].names:
                    broken.append(f"{page.relative_to(HTML)}: {link}")
        self.assertGreater(len(self.pages), 80)
        self.assertEqual(broken, [])

    def test_class_pages_have_all_setters(self):
        for header in [path for name in classes.MODULES for path in (TOP / name).glob("vtk*.h")]:
            text = (HTML / "api" / f"{header.stem}.html").read_text(encoding="utf-8")
            public = re.split(r"^protected:", header.read_text(encoding="utf-8"), flags=re.M)[0]
            for name in re.findall(r"^  vtkSet\w*Macro\((\w+)", public, re.M):
                self.assertTrue(f">Set{name}<" in text, f"{header.stem} without Set{name}")
            self.assertFalse("Unnamed Group" in text, header.stem)

    def test_room_pages_have_all_functions(self):
        text = (HTML / "common" / "Sea.html").read_text(encoding="utf-8")
        for name in ("WaveNumber", "WaveFrequency", "DepthRegime", "RegimeName"):
            self.assertTrue(f">{name}<" in text, name)


if __name__ == "__main__":
    missing = [name for name in ("sphinx", "myst_parser", "breathe", "furo") if importlib.util.find_spec(name) is None]
    if shutil.which("doxygen") is None:
        missing.append("doxygen")
    if missing:
        print(f"skipped: there is no {', '.join(missing)}; ./littoral setup documentation installs them")
        sys.exit(125)
    unittest.main()
