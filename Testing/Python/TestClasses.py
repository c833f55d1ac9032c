# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each class that can be made is in all places where classes are named one by one."""

import sys
from pathlib import Path

import littoral

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Testing"))
import classes  # noqa: E402

# Files, and what stands there for a class.
PLACES = {"paraview-plugin/*.xml": 'class="{}"', "Documentation/guide/classes.md": "| `{}` |"}


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
    missing += [f"{files} has no {entry.format(name)}" for name in names
                if entry.format(name) not in text and not (files.endswith(".xml") and name.endswith("Mapper"))]
missing += [f"Testing/classes.py has no row of {name}" for name in names
            if name not in classes.BY_NAME and name not in classes.PASSES]
# What is read or written is hashed by a function of its own.
text = (TOP / "Testing" / "Hashes" / "hash_outputs.py").read_text(encoding="utf-8")
missing += [f"hash_outputs.py makes no {row.name}" for row in classes.ROWS if row.is_of_files and f'"{row.name}"' not in text]
print(len(names), "classes", *missing, sep="\n")
assert len(names) > 20, names
sys.exit(1 if missing else 0)
