# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Markdown pages: links, anchors, lists of contents, named files, the sources of measured figures, the
architecture picture, the tables of the site."""

import functools
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
TOP = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "Documentation" / name) for name in ("", "site", "pictures")]

import make_classes  # noqa: E402
import make_entries  # noqa: E402
import make_site  # noqa: E402

NAMED = re.compile(r"\b(?:Documentation|Examples|Testing|Common|Support|CMake|packaging|paraview-plugin|Wrapping)"
                   r"/[\w./-]+")


def pages(top=TOP):
    """All Markdown pages of the tree, but for templates of the site."""
    roots = [top, *(top / name for name in ("Documentation", "Examples", "packaging") if (top / name).is_dir())]
    found = list(roots[0].glob("*.md")) + [path for root in roots[1:] for path in root.rglob("*.md")]
    return sorted(path for path in found if path.parent.name != "site")


def prose(path):
    """The text without blocks of code."""
    return re.sub(r"^ *```.*?^ *```$", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)


def headings(path):
    return [(len(marks), words.strip()) for marks, words in re.findall(r"^(#+) (.+)$", prose(path), re.M)]


def anchors(path):
    """Of the headings, as forges and MyST form them; the second of a name gets -1, and so on."""
    found, count = set(), {}
    for _, words in headings(path):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", words)
        name = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        found.add(name if name not in count else f"{name}-{count[name]}")
        count[name] = count.get(name, 0) + 1
    return found


def broken_links(top=TOP):
    broken = []
    for page in pages(top):
        for address in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
            if re.match(r"[a-z]+:", address):
                continue
            name, _, anchor = address.partition("#")
            target = Path(os.path.normpath(page.parent / name)) if name else page
            if not target.exists():
                broken.append(f"{page.relative_to(top)}: there is no {address}")
            elif anchor and (target.suffix != ".md" or anchor not in anchors(target)):
                broken.append(f"{page.relative_to(top)}: {name or 'the page'} has no heading #{anchor}")
    return broken


#: What is measured: shares, costs, factors, tolerances, scatter, fractions, and numbers of two decimals or more.
FIGURE = re.compile(r"""(?<![\w.,])(?:
    \d[\d ]*(?:\.\d+)?[ ](?:%|(?:ns|µs|ms|kB|MB|GB|times)\b)
  | ±[ ]?\d+(?:\.\d+)?
  | \d+(?:\.\d+)?e-\d+
  | \d+\.\d\d+
  | 0\.\d(?![ ]m(?:\b|²)))(?!\.?\d)""", re.X)
#: What is not: code, addresses, comments, versions after a name, defaults.
OTHER = re.compile(r"`[^`]*`|\]\([^)]*\)|<!--.*?-->|\b(?:[A-Z]+[a-zA-Z]+|default(?: of)?) \d+\.[\d.]+", re.S)
#: Where it is from: a test or benchmark by its name, a file of the tree, a work by author and year.
PROGRAM = re.compile(r"\b(?:Test[A-Z]\w+|(?:vtk)?bench_\w+)\b")
FILE = re.compile(r"\b(?:Testing|Examples|Documentation|Common|Support|Sources|Filters|Rendering|IO|Wrapping|CMake|paraview-plugin)"
                  r"/[\w/.-]*\w")
WORK = re.compile(r"\b[A-Z][\w-]+(?: et al\.)?,? \(?(?:1[89]|20)\d\d\b")
PRINTS = re.compile(r"\bprintf?\b|std::cout|\bcat\(|\becho\b")


def blocks(text):
    """Paragraphs, items of lists and tables; of tables without the rows of properties and columns."""
    for block in re.split(r"\n\s*\n", text):
        if block.lstrip().startswith("|"):
            yield "\n".join(row for row in block.splitlines() if not re.match(r" *\| [*`]", row))
        elif not block.startswith("#"):
            yield from re.split(r"\n(?= *(?:-|\d+\.) )", block)


def figures(block):
    return FIGURE.findall(re.sub(r"\s+", " ", OTHER.sub(" ", block)))


@functools.lru_cache
def programs():
    """Tests and benchmarks by their names."""
    found = {}
    for path in TOP.glob("Testing/*/**/*"):
        if PROGRAM.fullmatch(path.stem):
            found.setdefault(path.stem, []).append(path)
    return found


def sources(words):
    """Texts of what is named as a source; what benchmarks measure is printed by their library."""
    paths = [path for name in PROGRAM.findall(words) for path in programs().get(name, [])]
    paths += [path for path in (TOP / name for name in FILE.findall(words)) if path.is_file()]
    return ["print" if "Benchmarks" in path.parts else path.read_text(encoding="utf-8", errors="replace") for path in paths]


def forms_of(figure):
    """A figure as programs have it: 5 % is 5 and 0.05."""
    number = re.search(r"\d[\d ]*(?:\.\d+)?(?:e-\d+)?", figure)[0].replace(" ", "")
    return [number, *([f"{float(number) / 100.0:g}"] if "%" in figure else [])]


def figures_without_source(page):
    """Blocks with figures that no source holds or prints; of a table, sources of the blocks beside it count too."""
    missing, around = [], list(blocks(prose(page)))
    for n, block in enumerate(around):
        found = figures(block)
        words = "\n".join(around[max(n - 1, 0):n + 2]) if block.lstrip().startswith("|") else block
        forms = [form for figure in found for form in forms_of(figure)]
        if found and not WORK.search(words) and not any(
                PRINTS.search(text) or any(form in text for form in forms) for text in sources(words)):
            missing.append(f"{page.name}: {', '.join(found)}: {' '.join(block.split())[:90]}")
    return missing


class Documents(unittest.TestCase):
    """Pages of the tree, without Sphinx."""

    def test_links_and_anchors(self):
        self.assertGreater(len(pages()), 30)
        self.assertEqual(broken_links(), [])

    def test_broken_links_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.md").write_text(
                "# A\n\n## B c?\n\n[x](#b-c) [x](#b) [x](b.md) [x](a.md#a) [x](a.md#d)\n", encoding="utf-8")
            self.assertEqual(broken_links(Path(folder)), [
                "a.md: the page has no heading #b", "a.md: there is no b.md", "a.md: a.md has no heading #d"])

    def test_lists_of_contents(self):
        folder = TOP / "Documentation"
        for page in sorted([*folder.glob("guide/*.md"), *folder.glob("design/*.md")]):
            sections = [entry for entry in headings(page)[1:] if entry[0] <= 3]
            if len(sections) < 2 or page == TOP / "Documentation" / "guide" / "index.md":
                continue
            with self.subTest(page=str(page.relative_to(TOP))):
                listed = re.findall(r"^( *)- \[(.*)\]\(#", page.read_text(encoding="utf-8"), re.M)
                self.assertEqual([(2 + len(space) // 2, words) for space, words in listed], sections)

    def test_each_page_is_in_its_index(self):
        for name in ("guide", "design"):
            folder = TOP / "Documentation" / name
            text = (folder / "index.md").read_text(encoding="utf-8")
            for page in folder.glob("*.md"):
                if page.name != "index.md":
                    self.assertIn(f"]({page.name})", text, page)

    def test_named_files_are_there(self):
        missing = []
        for page in pages():
            for code in re.findall(r"`([^`\n]+)`", page.read_text(encoding="utf-8")):
                missing += [f"{page.relative_to(TOP)}: {name}" for name in NAMED.findall(code)
                            if not (TOP / name.rstrip("./")).exists() and not re.search(r"\.\.\.|<|NAME", code)]
        for header in [path for name in ("Common", *make_site.rows.MODULES) for path in (TOP / name).rglob("*.h")]:
            missing += [f"{header.relative_to(TOP)}: {name}" for name in
                        re.findall(r"\bDocumentation/[\w./-]+\.md", header.read_text(encoding="utf-8"))
                        if not (TOP / name).exists()]
        self.assertEqual(missing, [])

    def test_measured_figures_have_a_source(self):
        missing = [line for name in ("guide", "design") for page in sorted((TOP / "Documentation" / name).glob("*.md"))
                   if page.name not in ("classes.md", "entries.md") for line in figures_without_source(page)]
        self.assertEqual(missing, [], "name the test, benchmark or script that measures it, as in <!-- TestSea -->")

    def test_figures_without_source_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "a.md"
            page.write_text("# A 0.25\n\nIt takes 3 ms.\n\nWithin 0.5 % <!-- TestSea -->, 2.31 by Airy (1845).\n\n"
                            "- 1.25 times\n- ParaView 5.11 has 3 of 4 m; `0.25`\n\n| *Share* | 0.25 |\n\n"
                            "By TestNothing 7 %.\n", encoding="utf-8")
            self.assertEqual([line.split(":")[1] for line in figures_without_source(page)],
                             [" 3 ms", " 1.25 times", " 7 %"])

    def test_page_of_classes(self):
        page = (TOP / "Documentation" / "guide" / "classes.md").read_text(encoding="utf-8")
        self.assertEqual(make_classes.page(), page, "call Documentation/make_classes.py")
        for row in make_classes.rows():
            header = next(path for path in TOP.glob(f"*/{row.name}.h"))
            brief = re.search(r"@brief +(.*)", header.read_text(encoding="utf-8"))[1]
            self.assertIn(f"| `{row.name}` | {row.entry} | {brief} |", page)
            ports = make_classes.ports_of(make_classes.comment_of(row.name)[1:])
            is_made = row.entry not in ("a base class", "a mapper", "a render pass")
            self.assertTrue(make_classes.cell(ports, "output") or row.name.endswith("Writer") or not is_made, row.name)
            has_input = row.name.endswith(("Filter", "Writer")) and is_made
            self.assertTrue(make_classes.cell(ports, "input") or not has_input, row.name)

    def test_ports_of_a_comment(self):
        ports = make_classes.ports_of([
            "Input: any vtkPointSet. Optional window (port 1): vtkPolyData with one polygon.",
            "Output 0: a vtkTable with the columns `A`, `B` and `C` [m2], `D` (a number) and `E`[3] [m/s], by `F`. "
            "Field data: `G`.", "Output 1: the same data at the requested time, with `H` [s].", "The numbers are exact."])
        self.assertEqual([make_classes.cell(ports, kind) for kind in ("input", "output")], [
            "`vtkPointSet`<br>1: optional, `vtkPolyData`",
            "0: `vtkTable`; `A` [m2], `B` [m2], `C` [m2], `D`, `E` [m/s]; field data `G`<br>"
            "1: the same data at the requested time; `H` [s]"])

    def test_readme_is_short(self):
        self.assertLessEqual(len((TOP / "README.md").read_text(encoding="utf-8").split()), 700)

    def test_architecture_picture(self):
        pictures = TOP / "Documentation" / "pictures"
        with tempfile.TemporaryDirectory() as folder:
            fresh = Path(folder) / "architecture.svg"
            subprocess.run([sys.executable, "-B", str(pictures / "make_architecture.py"), str(fresh)], check=True)
            self.assertEqual(fresh.read_text(encoding="utf-8"),
                             (pictures / "architecture.svg").read_text(encoding="utf-8"),
                             "call Documentation/pictures/make_architecture.py")


class Entries(unittest.TestCase):
    """The entries of ParaView's menus in pictures."""

    FOLDER = TOP / "Documentation" / "pictures" / "window"

    def test_each_entry_has_its_pictures(self):
        page = (TOP / "Documentation" / "guide" / "entries.md").read_text(encoding="utf-8")
        entries = make_entries.read_entries()
        self.assertGreater(len(entries), 30)
        known = set()
        for _, name, label, what in entries:
            self.assertIn(f"### {label}\n\n{what}\n", page)
            for picture, most in ((make_entries.file_of(name), 60), (make_entries.file_of(name) + "-mistake", 25)):
                path = self.FOLDER / (picture + ".jpg")
                known.add(path.name)
                self.assertTrue(path.is_file(), f"call Documentation/pictures/make_entries.py {name}")
                self.assertLessEqual(path.stat().st_size, most * 1024, picture)
                self.assertIn(f"](../pictures/window/{path.name})", page)
            self.assertIn(f"*A mistake:* {make_entries.read_messages()[name]}\n", page)
        self.assertEqual({path.name for path in self.FOLDER.glob("*.jpg")} - known, set())


class SiteTables(unittest.TestCase):
    """What make_site.py lists is what the tree has."""

    def test_pages(self):
        for name, listed in (("guide", make_site.GUIDE), ("design", make_site.DESIGN)):
            there = {path.stem for path in (TOP / "Documentation" / name).glob("*.md")} - {"index"}
            self.assertEqual(sorted(listed), sorted(there))

    def test_classes_and_rooms(self):
        classes = [name for _, _, _, names in make_site.FIELDS for name in names]
        there = [path.stem for folder in make_site.rows.MODULES for path in (TOP / folder).glob("vtk*.h")]
        self.assertEqual(sorted(classes), sorted(there))
        rooms = [path.name for path in (TOP / "Common").iterdir() if path.is_dir()]
        self.assertEqual(sorted(make_site.ROOMS), sorted(rooms))

    def test_each_example_has_title_and_picture(self):
        there = [path.relative_to(TOP).as_posix() for kind in ("py", "cxx")
                 for path in (TOP / "Examples").rglob("*." + kind)]
        self.assertEqual(sorted(make_site.EXAMPLES), sorted(there))
        for name, (title, picture) in make_site.EXAMPLES.items():
            self.assertTrue(title)
            self.assertTrue((TOP / "Documentation" / "pictures" / picture).is_file(), name)
            sentence, _, usage = make_site.describe(TOP / name)
            self.assertGreater(len(sentence), 10, name)
            self.assertTrue(usage, name)


if __name__ == "__main__":
    unittest.main()
