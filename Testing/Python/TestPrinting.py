# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a class prints of itself tells each of its properties by name, with the value that its getter gives."""

import math
import re
import sys
from pathlib import Path

import littoral

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Fuzz"))
from introspection import all_classes, own_kinds

#: Other names of a property, and what is an object or a row of a list.
OTHERS = {"MiddleDistance": "NearDistance", "Camera": "Renderer"}
WORDS = {"on": 1.0, "off": 0.0}


def numbers(text):
    """The numbers in a printed value; None if it is another text."""
    try:
        return [WORDS[word] if word in WORDS else float(word) for word in text.replace(",", " ").strip("()").split()]
    except ValueError:
        return None


def agrees(text, value):
    """Whether a printed value is that of a getter."""
    values = list(value) if isinstance(value, (tuple, list)) else [value]
    if any(isinstance(item, str) or item is None for item in values):
        return str(values[0] or "") in text
    printed = numbers(text)
    return printed is not None and len(printed) == len(values) and all(
        math.isclose(a, float(b), rel_tol=1e-5, abs_tol=1e-300) for a, b in zip(printed, values))


def faults(name):
    """What a class's print does not tell, and the number of properties that it tells."""
    made = getattr(littoral, name)()
    lines = dict(re.findall(r"^ *(\w+): *(.*)$", str(made), re.MULTILINE))
    methods = set().union(*(vars(kind) for kind in own_kinds(type(made))))
    found, told = [], 0
    for method in sorted(methods):
        prop = method[3:]
        if not method.startswith("Set") or "Get" + prop not in methods:
            continue
        try:
            value = getattr(made, "Get" + prop)()
        except TypeError:
            continue  # of a row of a list
        prop = OTHERS.get(prop, prop)
        if prop not in lines:
            found.append(f"{name}: {prop} is not printed")
        elif not agrees(lines[prop], value) and prop != "Renderer":
            found.append(f"{name}: {prop} is {value}, printed as {lines[prop]}")
        else:
            told += 1
    return found, told


results = [faults(name) for name in all_classes()]
complaints = [complaint for found, _ in results for complaint in found]
count = sum(told for _, told in results)
print(*complaints, f"{len(results)} classes print {count} properties", sep="\n")
assert count > 300
sys.exit(1 if complaints else 0)
