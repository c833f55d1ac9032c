# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3
"""Headers of Common include, or declare, what they name of the standard library, of GLM and of each other.

By the text: hygiene.common-headers-complete compiles them.
"""

import functools
import os
import re
import sys
from pathlib import Path

COMMON = Path(os.environ["LITTORAL_SOURCE_DIR"]) / "Common"
#: Headers with names of the standard library, each of which is enough.
STANDARD = {
    "algorithm": "clamp max min upper_bound", "array": "array", "atomic": "atomic memory_order_relaxed", "cmath": "abs cos floor fmax fmin fmod hypot isfinite isnan pow "
    "sin sqrt", "complex": "complex", "cstddef": "ptrdiff_t size_t", "cstring": "memcpy", "cstdint": "int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t",
    "functional": "function greater", "initializer_list": "initializer_list", "iterator": "next prev",
    "limits": "numeric_limits", "map": "map", "memory": "shared_ptr unique_ptr", "numeric": "accumulate iota partial_sum",
    "optional": "optional", "set": "set", "sstream": "ostringstream", "stdexcept": "runtime_error",
    "string": "string to_string", "string_view": "string_view",
    "type_traits": "conditional_t enable_if_t remove_reference_t", "utility": "index_sequence make_index_sequence move",
    "variant": "variant", "vector": "vector"}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
TYPE = re.compile(r"^(?:struct|class|enum class|using) (?:alignas\(\d+\) )?(\w+)(?! *;)", re.M)
OWN = re.compile(r"\b(?:struct|class|enum class|typename) (\w+)\b")  # declared in the header itself
USED = re.compile(r"(?<![.:\w])[A-Z]\w+(?=::|>|[&*]| [\w&*])|(?<=<)[A-Z]\w+")  # as types are


@functools.lru_cache(maxsize=None)
def text_of(path):
    """A header without comments and texts."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", (COMMON / path).read_text(encoding="utf-8"), flags=re.S)


@functools.lru_cache(maxsize=None)
def included(path):
    """What a header includes, and what that does."""
    found = set(re.findall(r"#include <(.*)>", text_of(path)))
    for other in re.findall(r'#include "(.*)"', text_of(path)):
        found |= {other} | included(other)
    return frozenset(found)


headers = sorted(str(path.relative_to(COMMON)) for path in COMMON.glob("*/*.h"))
home_of = {name: path for path in headers for name in TYPE.findall(text_of(path))}
missing = []
for path in headers:
    code = re.sub(r"#include.*", "", text_of(path))
    for name in sorted(set(re.findall(r"\bstd::(\w+)", code))):
        if HEADER_OF.get(name, "?") not in included(path):
            missing.append(f"{path}: std::{name} of <{HEADER_OF.get(name, '?')}>")
    if "glm::" in code and not any(name.startswith("glm/") for name in included(path)):
        missing.append(f"{path}: glm")
    for name in sorted(set(USED.findall(code)) - set(OWN.findall(code))):
        if home_of.get(name, path) not in {path, *included(path)}:
            missing.append(f"{path}: {name} of {home_of[name]}")
print("Not included:" if missing else f"{len(headers)} headers", *missing, sep="\n")
sys.exit(bool(missing))
