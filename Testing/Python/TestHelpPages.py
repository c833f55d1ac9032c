# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each source and filter has a page in ParaView's help that lists its properties with the defaults of its panel, and is in
the file that the button "?" looks it up in, by the name that the button gives it."""

import glob
import html
import os
import re
import sqlite3
import sys
import xml.etree.ElementTree
import zlib

import littoral

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.path.abspath(os.path.join(os.path.dirname(littoral.__file__), *[".."] * 4))
PAGES = os.path.join(BUILD, "paraview-plugin", "help")


def proxies():
    """All sources and filters by their pages: (group, name)."""
    found = {}
    for path in glob.glob(os.path.join(TOP, "paraview-plugin", "*.xml")):
        for group in xml.etree.ElementTree.parse(path).getroot().iter("ProxyGroup"):
            for proxy in group:
                if group.get("name") in ("sources", "filters") and proxy.tag.endswith("Proxy"):
                    found[group.get("name"), proxy.get("name")] = proxy
    return found


def properties(proxy, known):
    """Labels and defaults of a proxy, of those that it derives from, and of a scene."""
    base = known.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")))
    found = dict(properties(base, known)) if base is not None else {}
    names = {one.get("name"): one for one in proxy if one.tag.endswith("Property")}
    found.update({name: one.get("default_values") for name, one in names.items()})
    found.update({one.get("property"): one.get("values") for one in proxy.findall("Scene/Set")})
    return found


def rows(page):
    """Defaults of a page by the names of properties."""
    with open(page, encoding="utf-8") as file:
        cells = re.findall(r"<th>([^<]*)</th>\s*<td>[^<]*</td>\s*<td>([^<]*)<", file.read())
    return {html.unescape(name).replace(" ", ""): " ".join(html.unescape(value).split()) for name, value in cells}


def pages_of_help():
    """Texts of a Qt help file by their names: the length of each, then the bytes of zlib."""
    (path,) = glob.glob(os.path.join(BUILD, "paraview-plugin", "paraview_help", "*.qch"))
    with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as file:
        rows_of_file = file.execute("SELECT n.Name, d.Data FROM FileNameTable n JOIN FileDataTable d ON d.Id = n.FileId")
        return {name: zlib.decompress(data[4:]) for name, data in rows_of_file if data}


if not glob.glob(os.path.join(PAGES, "sources.*.html")):
    print("skipped: the help pages are not built")
    sys.exit(125)
checked, known, in_help = 0, proxies(), pages_of_help()
for (group, name), proxy in known.items():
    shown = rows(os.path.join(PAGES, f"{group}.{name}.html"))
    assert shown, f"{name}: a page without properties"
    with open(os.path.join(PAGES, f"{group}.{name}.html"), "rb") as file:
        assert in_help.get(f"{group}.{name}.html") == file.read(), f"{name}: not the page of the help"
    for one, default in properties(proxy, known).items():
        if one in shown and default is not None:
            assert shown[one] == " ".join(default.split()), f"{name}: {one} is {default}, not {shown[one]!r} of its page"
            checked += 1
print(f"{len(known)} pages, {checked} defaults")
assert len(known) > 40 and checked > 400
