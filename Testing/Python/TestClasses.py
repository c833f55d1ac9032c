# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each class that can be made is in all places where classes are named one by one."""

import sys
from pathlib import Path

import littoral

TOP = Path(__file__).resolve().parents[2]
# Files, and what stands there for a class.
PLACES = {"paraview-plugin/*.xml": 'class="{}"', "Testing/Hashes/hash_outputs.py": '"{}"',
          "Documentation/guide/classes.md": "| `{}` |"}


def is_abstract(kind):
    """Whether a class is a base of others only."""
    try:
        kind()
    except TypeError:
        return True
    return False


names = [name for name in littoral.__all__ if not is_abstract(getattr(littoral, name))]
missing = []
for files, entry in PLACES.items():
    text = "".join(file.read_text(encoding="utf-8") for file in TOP.glob(files))
    missing += [f"{files} has no {entry.format(name)}" for name in names if entry.format(name) not in text]
print(len(names), "classes", *missing, sep="\n")
assert len(names) > 20, names
sys.exit(1 if missing else 0)
