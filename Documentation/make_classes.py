#!/usr/bin/env python3
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make the page of classes, Documentation/guide/classes.md, from the rows of the classes and their headers.

Usage: make_classes.py [FILE] (default: the page itself). Testing/Documents compares the page with a fresh one.
"""

import re
import sys
from collections import namedtuple
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TOP / "Testing"))

import classes  # noqa: E402

PAGE = TOP / "Documentation" / "guide" / "classes.md"
HEAD = """# Classes

The classes by field, in C++ and in Python (`from littoral import ...`); in ParaView they are entries of *Sources >
Littoral* and *Filters > Littoral*, or formats of files. The outputs are listed with their blocks, arrays, columns and
field data; what each means, and each property with its unit, range and default, stands in the header of the class, which
`./littoral docs` makes a web page of. Lengths are in metres, x to the east, y to the north, z up. Angles are in degrees
in properties and in radians in data.

`Documentation/make_classes.py` makes this page from the headers: a unit is the one that stands beside the name there.
"""
Row = namedtuple("Row", "name field entry")
Port = namedtuple("Port", "kind number optional types names fields")
TYPES = r"\bvtk(?:ImageData|Table|PolyData|PointSet|MultiBlockDataSet|PartitionedDataSetCollection)\b"


# --- the rows -------------------------------------------------------------------------------------


def entry_of(row):
    """Place of a class in ParaView: labels of menus, or a format of files."""
    menus = {"Open": "*File > Open*: ", "Save": "*File > Save Data*: "}
    return ", ".join(f"{menus.get(entry.menu, '')}*{entry.label}*" for entry in row.entries)


def rows():
    """The classes in the order of the fields: name, field, entry."""
    bases = [Row(name, field, "a base class") for name, field in classes.BASES.items()]
    passes = [Row(name, field, "a mapper" if name.endswith("Mapper") else "a render pass")
              for name, field in classes.PASSES.items()]
    made = [Row(row.name, row.field, entry_of(row)) for row in classes.ROWS]
    return [row for field in classes.FIELDS for row in made + passes + bases if row.field == field]


# --- the headers ----------------------------------------------------------------------------------


def comment_of(name):
    """The paragraphs of a class's comment, the first one being its brief."""
    header = next(TOP / folder / f"{name}.h" for folder in classes.MODULES
                  if (TOP / folder / f"{name}.h").exists())
    lines = re.search(r"/\*\*\n(.*?)\n \*/", header.read_text(encoding="utf-8"), re.S)[1].split("\n")
    text = "\n".join(line[3:] for line in lines)
    text = re.sub(r"^@class.*\n|^@sa.*", "", text, flags=re.M).replace("@brief   ", "", 1)
    return [" ".join(paragraph.split()) for paragraph in re.split(r"\n(?=\n|- )", text) if paragraph.strip()]


def names_in(text):
    """The arrays that a text names in code style, with the units beside them; `A`, `B` and `C` [m] share theirs."""
    text = re.sub(r"\bbut `\w+`(?:(?:,| and) `\w+`)*", "", text)
    text = re.sub(r"\b(by|for|from|in|of) `[^`]*`", r"\1", text)
    pieces, names, waiting = re.split(r"`([A-Z][A-Za-z0-9]*)`", text), {}, []
    for name, after in zip(pieces[1::2], pieces[2::2]):
        waiting.append(name)
        if after.strip() in (",", "and"):
            listed = after.strip() == "and"
            continue
        after = re.sub(r"\([^()]*\)", "", after)
        found = re.match(r"[^\[]{0,60}(?:\[\d\])?[^\[]{0,9}\[([^\]]*[a-z][^\]]*)\]", after)
        unit = f" [{found[1]}]".replace("^", "") if found else ""
        shares = len(waiting) > 1 and listed and not after.startswith("[")
        for one in waiting:
            names[one] = names.get(one) or (unit if shares or one == name else "")
        waiting = []
    return names


def port_of(sentence, optional):
    """The port that a sentence begins to describe, or None."""
    begin = re.match(
        r"(?:- |The (?=\w+ is a)|Optional )?(inputs?|outputs?|window)\b,?(?: \(?(?:port )?(\d)(?: and (\d))?)?",
        sentence, re.I) or re.match(r"(port|- .*\(port) (\d)()", sentence)
    if begin is None:
        return None
    numbers = " and ".join(number for number in begin.groups()[1:] if number)
    kind = "output" if begin[1].lower().startswith("output") else "input"
    return Port(kind, numbers, kind == "input" and (optional or "optional" in sentence[:40].lower()), [], {}, {})


def types_in(sentence, kind):
    """Data of a port: types of VTK; else the classes that make it; else the first words."""
    sentence = re.sub(r",? \(?(optional|repeatable)( and repeatable)?\b\)?", "", sentence)
    types = list(dict.fromkeys(f"`{one}`" for one in re.findall(TYPES, sentence)))
    makers = re.search(r"(?:from|as in) ((?:(?:a |the | or )?vtk\w+)+)", sentence)
    if kind == "input" and makers and makers[0].startswith("from"):
        words = "from " + re.sub(r"(?:a |the )?(vtk\w+)", r"`\1`", makers[1])
        return [f"{types[0]} {words}" if types and sentence.index(types[0][1:-1]) < makers.start() else words]
    if types:
        return types[:1] if kind == "output" else types
    if kind == "output" and makers:
        return [f"as `{makers[1]}`"]
    words = re.search(r"(?:: |, | is )([a-z][^,.;:(]*?)(?= with |[,.;:(]|$)", sentence)
    return [words[1].strip()] if words else []


def ports_of(paragraphs):
    """Ports of a class and their words, by the sentences that begin with a port or with field data."""
    ports, optional = [], False
    for paragraph in paragraphs:
        port, in_fields = None, False
        optional = optional and paragraph.startswith("- ")
        for sentence in re.split(r"(?<=[.:]) (?=[A-Z])|(?<=;) (?=port \d)|(?<=Inputs:) (?=port)", paragraph):
            begun = port_of(sentence, optional)
            if re.match(r"(Optional )?[Ii]nputs:$", sentence):
                optional = sentence.startswith("Optional")
            elif begun:
                port, in_fields = begun, False
                ports.append(port)
                port.types.extend(types_in(sentence, port.kind))
            elif re.match(r"Field data|- `|`", sentence):
                outputs = [one for one in ports if one.kind == "output"]
                port = outputs[0 if sentence.startswith("`") else -1] if outputs else port
                in_fields = sentence.startswith("Field data")
            if port:
                names = port.fields if in_fields else port.names
                names.update({**names_in(sentence), **names})
    return ports


# --- the page -------------------------------------------------------------------------------------


def cell(ports, kind):
    """The ports of one kind as a cell of a table."""
    words = []
    for port in (one for one in ports if one.kind == kind):
        parts = [", ".join(port.types), listed(port.names)]
        parts += [f"field data {listed(port.fields)}"] if port.fields else []
        text = "; ".join(part for part in parts if part)
        if text:
            words.append((f"{port.number}: " if port.number else "") + ("optional, " if port.optional else "") + text)
    return "<br>".join(words)


def listed(names):
    return ", ".join(f"`{name}`{unit}" for name, unit in names.items())


def page():
    """The page as text."""
    parts, fields, made = [HEAD], {}, rows()
    for row in made:
        fields.setdefault(row.field, []).append(row)
    parts.insert(1, "".join(f"- [{field}](#{field.lower().replace(' ', '-')})\n" for field in fields))
    for field, members in fields.items():
        lines = [f"## {field}", "", "| class | in ParaView | what it does | inputs | outputs |",
                 "|---|---|---|---|---|"]
        for row in members:
            brief, *paragraphs = comment_of(row.name)
            ports = ports_of(paragraphs)
            lines.append(f"| `{row.name}` | {row.entry} | {brief} | {cell(ports, 'input')} | {cell(ports, 'output')} |")
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    (Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE).write_text(page(), encoding="utf-8")
