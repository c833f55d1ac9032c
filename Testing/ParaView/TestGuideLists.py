# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Each numbered list of the guide is walked by a test of its own, and no test walks a list that is gone."""

import glob
import os
import re

from guide import lists, pages, read

HERE = os.path.dirname(os.path.abspath(__file__))

walked = set()
for file in glob.glob(os.path.join(HERE, "TestGuideLists?*.py")):
    found = re.findall(r'Walk\(__file__, "([^"]+)"(?:, (\d+))?\)', read(file))
    assert found, f"{file} walks no list"
    walked |= {(page, int(number or 0)) for page, number in found}
there = {(page, number) for page in pages() for number in range(len(lists(page)))}
assert there, "the guide has no numbered lists"
for page, number in sorted(there - walked):
    raise AssertionError(f"{page}.md: no test walks the list that begins {lists(page)[number][0]!r}")
for page, number in sorted(walked - there):
    raise AssertionError(f"{page}.md has no list {number}, which a test walks")
print(f"{len(there)} lists of the guide are walked")
