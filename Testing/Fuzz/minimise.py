# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a failing case short: lines are taken out while the same fault stays."""

import ast
import re

import runner


def signature(fault):
    """What makes two faults the same: the kind and its words, without numbers."""
    kind, text = fault
    if kind in ("crash", "hang"):
        text = text.split(" in ", 1)[0]  # the signal
    return kind, re.sub(r"0x[0-9a-f]+|[-+.\d]+(e[-+]?\d+)?|\b(nan|inf)\b", "#", text)


def minimised(name, lines, fault):
    """The fewest lines with the fault that are found by taking out halves, quarters and so on, then single lines."""
    wanted = signature(fault)
    size = len(lines) // 2
    while size >= 1:
        at, found = 1, False  # the first line makes the object, the last one ends the case
        while at < len(lines) - 1:
            fewer = lines[:at] + lines[min(at + size, len(lines) - 1):]
            if signature(runner.run(name, fewer)) == wanted:
                lines, found = fewer, True
            else:
                at += size
        size = size if found and size == 1 else size // 2
    return simplified(name, lines, wanted)


def simpler(line):
    """The line with one call less that spoils an input, in each way."""
    def spoils(tree):
        return [node for node in ast.walk(tree)
                if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Call)]

    for index in range(len(spoils(ast.parse(line)))):
        tree = ast.parse(line)
        wanted = spoils(tree)[index]
        inner = wanted.args[0]
        wanted.func, wanted.args, wanted.keywords = inner.func, inner.args, inner.keywords
        yield ast.unparse(tree)


def simplified(name, lines, wanted):
    """The lines with fewer spoils and the same fault."""
    for at, line in enumerate(lines):
        for other in simpler(line):
            fewer = lines[:at] + [other] + lines[at + 1:]
            if signature(runner.run(name, fewer)) == wanted:
                return simplified(name, fewer, wanted)
    return lines


def calls(lines):
    """The methods that a short case calls with which functions: what tells causes of the same signal apart."""
    return frozenset(word for line in lines for word in re.findall(r"\b\w+(?=\()", line))


def script(name, played):
    """A Python script that plays cases."""
    def call(lines):
        body = "\n".join(f"    {line!r}," if len(line) < 400 else f"    # {line[:300]} ..." for line in lines)
        return f"replay.play({name!r}, [\n{body}\n])"

    return "\n".join(["import replay", "", *map(call, played)])
