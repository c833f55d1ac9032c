# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Each numbered list of the guide is walked by a module guide_*.py, which a test plays, no module walks one that is gone,
and what a walk does is what the words of its steps say; here none is played.
"""

import glob
import importlib
import os
import re

from guide import lists, pages, read, walk

HERE = os.path.dirname(os.path.abspath(__file__))

walked = set()
for file in glob.glob(os.path.join(HERE, "guide_*.py")):
    page, number = re.search(r'^PAGE(?:, NUMBER)? = "([^"]+)"(?:, (\d+))?$', read(file), re.MULTILINE).groups()
    walked.add((page, int(number or 0)))
played = {name for file in glob.glob(os.path.join(HERE, "Test*.py"))
          for name in re.findall(r"^import (guide_\w+)$", read(file), re.MULTILINE)}
there = {(page, number) for page in pages() for number in range(len(lists(page)))}
assert there, "the guide has no numbered lists"
modules = {os.path.splitext(os.path.basename(file))[0] for file in glob.glob(os.path.join(HERE, "guide_*.py"))}
assert played == modules, f"no test plays {modules - played}"
for page, number in sorted(there - walked):
    raise AssertionError(f"{page}.md: no module walks the list that begins {lists(page)[number][0]!r}")
for page, number in sorted(walked - there):
    raise AssertionError(f"{page}.md has no list {number}, which a module walks")
walk(*map(importlib.import_module, sorted(modules)))
print(f"{len(there)} lists of the guide are walked")
