#!/usr/bin/env python3
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Build the web site: guide, design, errata, changes, a reference of the classes, and a gallery of the examples.

Usage: make_site.py FOLDER

FOLDER gets `source` (the collected pages), `xml` (Doxygen's) and `html`, whose index.html is the first
page. Any warning of Doxygen or Sphinx is an error. Needs Doxygen, Sphinx, MyST, Breathe and the theme
Furo.
"""

import ast
import html
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
DOCUMENTS = TOP / "Documentation"
sys.path.insert(0, str(TOP / "Testing"))

import classes as rows  # noqa: E402

# Pages in the order of the menu, below Documentation.
GUIDE = ("installing", "first-steps", "scenes", "entries", "classes", "terrain", "kriging", "drainage", "patterns", "plants", "forests",
         "stands", "wind", "sway", "sea", "currents", "particles", "seaweed", "underwater", "light", "python", "volumes",
         "saving", "blender", "speed", "clusters", "troubleshooting", "glossary")
DESIGN = ("numerics", "geometry", "terrain", "kriging", "drainage", "patterns", "plants", "wind", "sway", "sea", "currents",
          "particles", "seaweed", "light", "paraview", "requests", "volumes", "scenes", "measurements")

# Classes by field: title, page of the guide, page of the design, classes.
FIELDS = [(title, *pages, [name for name, field in {**rows.BASES, **rows.PASSES}.items() if field == title]
           + [row.name for row in rows.ROWS if row.field == title]) for title, pages in rows.FIELDS.items()]

# Rooms of Common: page of the design, and what they hold.
ROOMS = {
    "Numerics": ("numerics", "Random streams, Fourier transforms, quadrature, rotations, threads."),
    "Geometry": ("geometry", "Views, cells of boxes, height grids, pictures and atlases of pictures."),
    "Terrain": ("terrain", "Covariance models, turning bands, variograms and their fits, levels of terrain."),
    "Drainage": ("drainage", "Flow over terrain, rivers that cut into it, ground that drains and keeps its statistics."),
    "Landscapes": ("drainage", "Landscapes that grow by rivers and hillslopes over irregular points, in the kind of a place."),
    "Kriging": ("kriging", "Kriging with all data and in neighbourhoods, fields through data, cross-validation, normal scores."),
    "Patterns": ("patterns", "Laws of counts in quadrats, point processes, patterns by them, fits; windows, functions of "
                 "distance, envelopes, verdicts."),
    "Plants": ("plants", "Skeletons, skins, leaves, kinds of trees, scattered plants."),
    "Wind": ("wind", "Spectra, fields, loads."),
    "Sway": ("sway", "Modes and responses of beams, trunks and whole trees; leaves that move."),
    "Sea": ("sea", "Dispersion, spectra, wave trains, orbits, the surface and its colors."),
    "Currents": ("currents", "Flow primitives and their arrows, drift, splines of velocity."),
    "Particles": ("particles", "Suspended particles, masters and slaves, levels of detail, fog."),
    "Seaweed": ("seaweed", "Growth, meshes, equations of motion, wakes."),
    "Light": ("light", "The sun's place, the light of sun and sky, on planes too."),
}

# Examples in the order of the gallery: title, and picture in Documentation/pictures. One that is not here
# comes last, with the title that it gives itself and without a picture.
EXAMPLES = {
    "Examples/ParaView/demo.py": ("Demo", "twin-terrain.jpg"),
    "Examples/ParaView/scene.py": ("Place and twin", "paraview-window.jpg"),
    "Examples/ParaView/forest.py": ("Walk in a forest", "forest.jpg"),
    "Examples/ParaView/underwater.py": ("Under the waves", "underwater.jpg"),
    "Examples/Python/grow_terrain.py": ("Terrain", "terrain.jpg"),
    "Examples/Cxx/GrowTerrain.cxx": ("Terrain in C++", "terrain.jpg"),
    "Examples/Cxx/GrowThroughData.cxx": ("Terrain through data in C++, without VTK", "conditional.jpg"),
    "Examples/Python/fit_and_grow.py": ("Measured terrain", "variogram.png"),
    "Examples/Python/conditional_terrain.py": ("Terrain through data", "conditional.jpg"),
    "Examples/Python/regrow_patterns.py": ("Point patterns", "patterns.png"),
    "Examples/Python/planted_stands.py": ("Planted inventories", "stand-longleaf.jpg"),
    "Examples/Python/five_inventories.py": ("Five inventories", "five-inventories.jpg"),
    "Examples/Python/wind_spectrum.py": ("Wind spectra", "wind-spectrum.png"),
    "Examples/Python/swaying_trees.py": ("Swaying trees", "swaying-trees.jpg"),
    "Examples/Python/landscape_light.py": ("Light of sun and sky", "landscape-light.jpg"),
    "Examples/Python/sea_surface.py": ("Sea surface", "sea-surface.jpg"),
    "Examples/Python/drifting_particles.py": ("Drifting particles", "drifting-particles.jpg"),
    "Examples/Python/swaying_kelp.py": ("Swaying kelp", "swaying-kelp.jpg"),
    "Examples/Blender/forest.py": ("A glade by path tracing", "light-forest.jpg"),
    "Examples/Blender/underwater.py": ("A kelp bay by path tracing", "light-underwater.jpg"),
    "Examples/Python/pyvista_coast.py": ("Coast in PyVista", "pyvista-coast.jpg"),
}

CARDS = (
    ("guide/index.md", "User guide", "figure7.jpg",
     "Installing, your own data, the choice of parameters, a page a field."),
    ("gallery/index.md", "Gallery", "pyvista-coast.jpg", "Every example with its picture and its script."),
    ("api/index.md", "Classes", "figure8.jpg", "Sources, filters and the writer: properties, units, ranges, defaults."),
    ("common/index.md", "Numerics without VTK", "variogram.png", "The C++17 library Common, a page a room."),
    ("design/index.md", "Design", "models.jpg", "Architecture, formulas, methods and the reasons for them."),
    ("errata.md", "Errata", "figure2.jpg", "What the papers misprint or leave open."),
)


# --- links ----------------------------------------------------------------------------------------


def site_path(target):
    """Address of a file of the tree on the site, relative to its source; None if it is not there."""
    name = target.as_posix()
    fixed = {"README.md": "index.md", "CHANGELOG.md": "changes.md", "CONTRIBUTING.md": "contributing.md",
             "Examples": "gallery/index.md", "Examples/Python": "gallery/index.md",
             "Examples/Cxx": "gallery/GrowTerrain.md", "Examples/ParaView": "gallery/index.md"}
    if name in fixed:
        return fixed[name]
    if name.startswith("Examples/") and target.suffix in (".py", ".cxx"):
        return f"gallery/{target.stem}.md"
    if name.startswith("Documentation/") and target.suffix in (".md", ".jpg", ".png", ".svg"):
        return name[len("Documentation/"):]
    return None


def mend_link(match, origin, page):
    """A link of a page of the tree as one of the site; its text alone if it leads to what is not on the site."""
    mark, text, address = match.groups()
    if re.match(r"[a-z]+:|#", address):
        return match[0]
    path, _, anchor = address.partition("#")
    target = Path(os.path.normpath(origin.parent / path))
    place = site_path(target)
    if place is None:
        return text
    return f"{mark}[{text}]({os.path.relpath(place, Path(page).parent)}{'#' + anchor if anchor else ''})"


def link_names(line, page, known):
    """Names of classes and examples in code style become links, outside of links."""

    def link(match):
        target = known.get(match[1])
        if target is None or target == page:
            return match[0]
        return f"[`{match[1]}`]({os.path.relpath(target, Path(page).parent)})"

    parts = re.split(r"(!?\[[^\]]*\]\([^)]*\))", line)
    return "".join(part if k % 2 else re.sub(r"(?<!`)`([\w/.]+)`(?!`)", link, part) for k, part in enumerate(parts))


def mend(text, origin, page, known):
    """A page of the tree, ORIGIN below the top folder, as PAGE of the site."""
    blocks = re.split(r"(^ *```.*?^ *```$)", text, flags=re.M | re.S)
    for k in range(0, len(blocks), 2):
        block = re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)",
                       lambda match: mend_link(match, Path(origin), page), blocks[k])
        blocks[k] = "\n".join(
            line if line.startswith("#") else link_names(line, page, known) for line in block.split("\n"))
    # The list of contents: not shown where there is room for that of the theme.
    return re.sub(r"(?<=\n\n)((?: *- \[[^\]]*\]\(#[^)]*\)\n)+)", r":::{container} page-contents\n\1:::\n",
                  "".join(blocks), count=1)


def contents(*pages, depth=1, caption=""):
    """A list of pages for the menu, not shown on the page itself."""
    lines = ["```{toctree}", ":hidden:", f":maxdepth: {depth}", *([f":caption: {caption}"] if caption else []), "",
             *pages, "```", ""]
    return "\n".join(lines)


def breakable(name):
    """A name that may break where a word begins."""
    return re.sub(r"(?<=[a-z])(?=(Source|Filter|LevelOfDetail|Deformation|Algorithm|Writer)$|LevelOf)", "\u200b", name)


# --- the parts ------------------------------------------------------------------------------------


class Site:
    """The collected pages."""

    def __init__(self, folder):
        self.source, self.xml, self.html = (folder / name for name in ("source", "xml", "html"))
        self.classes = [name for _, _, _, names in FIELDS for name in names]
        there = sorted(
            file.relative_to(TOP).as_posix() for pattern in ("Python/*.py", "ParaView/*.py", "Cxx/*.cxx")
            for file in (TOP / "Examples").glob(pattern))
        self.examples = [name for name in EXAMPLES if name in there]
        self.examples += [name for name in there if name not in EXAMPLES]
        self.briefs = {}
        self.known = {name: f"api/{name}.md" for name in self.classes}
        self.known.update({name: site_path(Path(name)) for name in self.examples})
        self.known.update({Path(name).name: site_path(Path(name)) for name in self.examples})

    def write(self, page, text):
        path = self.source / page
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def copy_page(self, origin, page, more=""):
        text = (TOP / origin).read_text(encoding="utf-8")
        self.write(page, mend(text, origin, page, self.known) + ("\n" + more if more else ""))

    def readme_section(self, title, page):
        text = (TOP / "README.md").read_text(encoding="utf-8")
        found = re.search(rf"^## {re.escape(title)}\n.*?(?=^## |\Z)", text, re.M | re.S)
        if not found:
            sys.exit(f"README.md has no section '{title}'")
        return mend(found[0], "README.md", page, self.known)

    def documents(self):
        shutil.copytree(DOCUMENTS / "pictures", self.source / "pictures",
                        ignore=shutil.ignore_patterns("*.py", "__pycache__"))
        for name, pages in (("guide", GUIDE), ("design", DESIGN)):
            there = {path.stem for path in (DOCUMENTS / name).glob("*.md")} - {"index"}
            if there != set(pages):
                sys.exit(f"Documentation/{name} and make_site.py differ: {sorted(there ^ set(pages))}")
            self.copy_page(f"Documentation/{name}/index.md", f"{name}/index.md", contents(*pages))
            for page in pages:
                self.copy_page(f"Documentation/{name}/{page}.md", f"{name}/{page}.md")
        for path in DOCUMENTS.glob("*.md"):
            self.copy_page(f"Documentation/{path.name}", path.name)
        self.copy_page("CHANGELOG.md", "changes.md")
        self.copy_page("CONTRIBUTING.md", "contributing.md")

    def first_page(self):
        text = (HERE / "index.md").read_text(encoding="utf-8")
        text = text.replace("@CARDS@", cards("", CARDS))
        text = re.sub(r"@README (.*)@", lambda match: self.readme_section(match[1], "index.md"), text)
        more = sorted(path.stem for path in DOCUMENTS.glob("*.md") if path.stem != "errata")
        self.write("index.md", text + "\n" + contents("guide/index", "gallery/index", caption="Use")
                   + contents("api/index", "common/index", caption="Reference")
                   + contents("design/index", "errata", *more, "contributing", "changes", caption="Background"))

    # The reference.

    def classes_by_field(self):
        there = {path.stem for folder in rows.MODULES for path in (TOP / folder).glob("vtk*.h")}
        if there != set(self.classes):
            sys.exit(f"Classes and the fields of make_site.py differ: {sorted(there ^ set(self.classes))}")
        self.briefs = {name: words_of(self.class_xml(name).find("briefdescription")) for name in self.classes}
        page = ["# Classes", "", "All classes of the modules Sources, Filters, Rendering and IO, in C++ and in Python "
                "(`from littoral import ...`). From VTK 9.4 on a property has its Python name too: "
                "`SetTimeStep(0.1)` is "
                "`time_step = 0.1`.", ""]
        for title, guide, design, names in FIELDS:
            page += [f"## {title}", "", f"[Guide](../guide/{guide}.md), [design](../design/{design}.md)", ""]
            page += [f"- [{name}]({name}.md): {self.briefs[name]}" for name in names] + [""]
            for name in names:
                self.write(f"api/{name}.md", self.class_page(name, title, guide, design))
                self.plain_class_xml(name)
        entries = (f"{breakable(name)} <{name}>" for name in self.classes)
        self.write("api/index.md", "\n".join(page) + "\n" + contents(*entries))

    def class_xml(self, name):
        return ElementTree.parse(self.xml / f"class{name}.xml").getroot().find("compounddef")

    def class_page(self, name, field, guide, design):
        root = self.class_xml(name)
        bases = [base.text for base in root.findall("basecompoundref")]
        header = root.find("location").get("file")
        rows = []
        for member in root.iter("memberdef"):
            match = re.match(r"Set(\w+)$", member.findtext("name"))
            if member.get("kind") != "function" or member.get("prot") != "public" or not match:
                continue
            types = [words_of(param.find("type")) for param in member.findall("param")]
            text = words_of(member.find("briefdescription")) or words_of(member.find("detaileddescription"))
            if text and not any(row.startswith(f"| `{match[1]}`") for row in rows):
                kind = f"{types[0]} × {len(types)}" if len(types) > 1 else "".join(types)
                rows.append(f"| `{match[1]}` | {kind} | {text.replace('|', '/')} |")
        text = [f"# {name}", "", f"{self.briefs[name][:1].upper()}{self.briefs[name][1:]}.", "",
                f"{field}: [guide](../guide/{guide}.md), [design](../design/{design}.md). Header `{header}`, "
                f"based on {', '.join(self.link(base) for base in bases)}.", "",
                re.sub(r"\bDocumentation/([\w/-]+\.md)", r"[`Documentation/\1`](../\1)", link_names(
                    markdown_of(root.find("detaileddescription")), f"api/{name}.md", self.known)), ""]
        if rows:
            text += ["## Properties", "", "| property | type | meaning |", "|---|---|---|", *rows, ""]
        text += ["## Members", "", "```{doxygenclass} " + name, ":members:", ":undoc-members:", "```", ""]
        return "\n".join(text)

    def plain_class_xml(self, name):
        """Doxygen's XML without what the page says above its members, and without groups of setter and getter."""
        path = self.xml / f"class{name}.xml"
        tree = ElementTree.parse(path)
        root = tree.getroot().find("compounddef")
        for part in ("briefdescription", "detaileddescription"):
            root.find(part).clear()
        target = root.find("sectiondef[@kind='public-func']")
        members = list(target) if target is not None else []
        for section in root.findall("sectiondef[@kind='user-defined']"):
            members += [member for member in section if member.get("prot") == "public"]
            root.remove(section)
        if target is None:
            target = ElementTree.SubElement(root, "sectiondef", kind="public-func")
        for member in list(target):
            target.remove(member)
        target.extend(sorted(members, key=lambda member: int(member.find("location").get("line"))))
        tree.write(path, encoding="utf-8", xml_declaration=True)

    def link(self, name):
        return f"[{name}]({name}.md)" if name in self.known else f"`{name}`"

    def common_by_room(self):
        headers = installed_headers()
        rooms = {header.split("/")[0] for header in headers}
        if rooms != set(ROOMS):
            sys.exit(f"Rooms of Common and of make_site.py differ: {sorted(rooms ^ set(ROOMS))}")
        page = ["# Common", "", "The numerics in plain C++17, namespace `littoral`, without VTK: a room a field. Link "
                "with `Littoral::Common` and include headers by their paths, as in "
                "`#include \"Terrain/TurningBands.h\"`.", "",
                "| room | content | headers |", "|---|---|---|"]
        for room, (design, words) in ROOMS.items():
            own = [header for header in headers if header.startswith(room + "/")]
            page.append(f"| [{room}]({room}.md) | {words} | {len(own)} |")
            text = [f"# {room}", "", f"{words} [Design](../design/{design}.md).", ""]
            for header in own:
                group = re.sub(r"[/.]", "_", header)
                text += [f"## {header}", "", "```{doxygengroup} " + group, ":content-only:", ":members:",
                         ":undoc-members:", "```", ""]
                self.leave_namespace_out(group)
            self.write(f"common/{room}.md", "\n".join(text))
        self.write("common/index.md", "\n".join(page) + "\n\n" + contents(*ROOMS))

    def leave_namespace_out(self, group):
        """Each header is in the same namespace, which would be declared on each page."""
        for path in self.xml.glob("group__*.xml"):
            tree = ElementTree.parse(path)
            root = tree.getroot().find("compounddef")
            if root.findtext("compoundname") == group:
                for inner in root.findall("innernamespace"):
                    root.remove(inner)
                tree.write(path, encoding="utf-8", xml_declaration=True)

    # The gallery.

    def gallery(self):
        entries = []
        for name in self.examples:
            sentence, description, usage = describe(TOP / name)
            title, picture = EXAMPLES.get(name, (sentence, None))
            if picture and not (DOCUMENTS / "pictures" / picture).is_file():
                picture = None
            page = site_path(Path(name))
            language = "python" if name.endswith(".py") else "cpp"
            text = [f"# {title}", "", f"{sentence}.", ""]
            if picture:
                text += [f"![{title}](../pictures/{picture})", ""]
            text += ["```none", usage, "```", "", *([description, ""] if description else []), f"## {name}", "",
                     f"```{{literalinclude}} {os.path.relpath(TOP / name, (self.source / page).parent)}",
                     f":language: {language}", "```", ""]
            self.write(page, "\n".join(text))
            entries.append((Path(page).name, title, picture, sentence))
        head = ("# Gallery\n\nEvery example of the folder `Examples`. "
                "`./littoral run python3 Examples/Python/NAME.py FOLDER` runs one in Python, "
                "`./littoral run pvbatch Examples/ParaView/NAME.py FOLDER` one in ParaView.\n\n")
        self.write("gallery/index.md",
                   head + cards("../", entries) + "\n\n" + contents(*(Path(page).stem for page, *_ in entries)))


def cards(up, entries):
    """Pictures with a title and a line: (page, title, picture or None, words)."""
    lines = ["::::{container} cards", ""]
    for page, title, picture, words in entries:
        shown = f"[![{title}]({up}pictures/{picture})]({page})" if picture else f"[{title}]({page})"
        lines += [":::{container} card", shown, "", f"[{title}]({page})", "", words, ":::", ""]
    return "\n".join(lines + ["::::"])


def describe(path):
    """Title, description and usage of an example, by its docstring or its first comment."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        words = ast.get_docstring(ast.parse(text)) or path.stem
    else:
        comment = re.search(r"^// (?!SPDX).*(?:\n//.*)*", text, re.M)
        words = "\n".join(line[2:].strip() if k == 0 else line[2:] for k, line in enumerate(comment[0].split("\n")))
        words = re.sub(r"^   (?=\S)", "    ", words, flags=re.M)
    first, _, rest = words.partition("\n")
    title = first.strip().rstrip(".:")
    usage = [line.strip() for line in re.findall(r"^ {4,}\S.*$", rest, re.M)
             if re.match(r" +(python3|pvbatch|GrowTerrain|GrowThroughData|\./)", line)]
    prose = "\n".join(line for line in rest.split("\n") if line.strip() not in usage)
    # Lists that are set in columns stay as they are.
    prose = re.sub(r"((?:^ {4,}\S.*\n?)+)",
                   lambda match: "```none\n" + match[1].rstrip("\n") + "\n```\n", prose + "\n", flags=re.M)
    return title, prose.strip(), "\n".join(usage) or f"./littoral run python3 {path.relative_to(TOP)}"


def words_of(element):
    """The plain text of a piece of Doxygen's XML, on one line, for Markdown."""
    if element is None:
        return ""
    text = " ".join("".join(element.itertext()).split())
    return html.escape(text, quote=False).replace("*", r"\*").replace("_", r"\_").rstrip(".")


BLOCKS = ("itemizedlist", "orderedlist", "simplesect", "programlisting", "verbatim", "preformatted")


def markdown_of(element, indent=""):
    """A piece of Doxygen's XML as Markdown: paragraphs, lists, code, references."""
    parts = []
    for child in element if element is not None else ():
        if child.tag == "para":
            inline = escape(child.text)
            for piece in child:
                if piece.tag in BLOCKS:
                    parts += [indent + inline.strip()] if inline.strip() else []
                    parts.append(block_of(piece, indent))
                    inline = ""
                else:
                    inline += inline_of(piece)
                inline += escape(piece.tail)
            parts += [indent + " ".join(inline.split())] if inline.strip() else []
    return "\n\n".join(part for part in parts if part)


def block_of(piece, indent):
    if piece.tag in ("itemizedlist", "orderedlist"):
        mark = "- " if piece.tag == "itemizedlist" else "1. "
        items = [markdown_of(item, indent + " " * len(mark)) for item in piece.findall("listitem")]
        return "\n".join(indent + mark + item.lstrip() for item in items)
    if piece.tag == "simplesect":
        words = markdown_of(piece, indent).strip()
        if piece.get("kind") == "see":
            return indent + "See also " + ", ".join(f"`{word}`" for word in re.findall(r"\w+", words)) + "."
        return indent + words
    text = "\n".join("".join(line.itertext()) for line in piece.iter("codeline")) or "".join(piece.itertext())
    return "```none\n" + text.strip("\n") + "\n```"


def inline_of(piece):
    text = "".join(piece.itertext())
    if piece.tag == "computeroutput":
        return f"`{text}`"
    return {"emphasis": "*{}*", "bold": "**{}**"}.get(piece.tag, "{}").format(escape(text))


def escape(text):
    return re.sub(r"([*_\[\]<|])", r"\\\1", text or "")


def installed_headers():
    """Headers of Common, by their paths: all but those that Common/CMakeLists.txt calls private."""
    common = TOP / "Common"
    private = re.search(r"^set\(private_headers ([^)]*)\)$", (common / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    there = {path.relative_to(common).as_posix() for path in common.glob("*/*.h")}
    return sorted(there - set(private[1].split()))


# --- the two programs -----------------------------------------------------------------------------


def run_doxygen(site):
    shutil.rmtree(site.xml, ignore_errors=True)
    # Of Common what is installed, of the modules the classes.
    headers = ["Common/" + header for header in installed_headers()]
    headers += sorted(path.relative_to(TOP).as_posix() for folder in rows.MODULES
                      for path in (TOP / folder).glob("vtk*.h"))
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8")
    settings += (f'\nOUTPUT_DIRECTORY = "{site.xml.parent}"\nXML_OUTPUT = xml\nSTRIP_FROM_PATH = "{TOP}"\n'
                 f'INPUT_FILTER = "awk -f {HERE}/group.awk"\nINPUT = {" ".join(headers)}\n')
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=TOP, check=True)


def run_sphinx(site):
    version = re.search(r"^  VERSION ([\d.]+)$", (TOP / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
    environment = dict(os.environ, LITTORAL_VERSION=version, LITTORAL_XML=str(site.xml), PYTHONDONTWRITEBYTECODE="1")
    subprocess.run([sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html", "-d",
                    str(site.html.parent / "doctrees"), str(site.source), str(site.html)], env=environment, check=True)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    site = Site(folder)
    for old in (site.source, site.html):
        shutil.rmtree(old, ignore_errors=True)
    site.source.mkdir()
    shutil.copy(HERE / "conf.py", site.source)
    (site.source / "_static").mkdir()
    shutil.copy(HERE / "site.css", site.source / "_static")
    try:
        print("Doxygen: the headers", flush=True)
        run_doxygen(site)
        site.documents()
        site.classes_by_field()
        site.common_by_room()
        site.gallery()
        site.first_page()
        print("Sphinx: the pages", flush=True)
        run_sphinx(site)
    except subprocess.CalledProcessError as error:
        sys.exit(f"{error.cmd[0] if error.cmd[0] == 'doxygen' else 'sphinx'} warned or failed, see above")
    print(f"{len(list(site.html.rglob('*.html')))} pages; the first one is {site.html / 'index.html'}")


if __name__ == "__main__":
    main()
