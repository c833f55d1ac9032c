# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays cases again, in this process: for the scripts that fuzz.py prints, and for a debugger."""

import os
import sys

os.environ.setdefault("VTK_SMP_BACKEND_IN_USE", "Sequential")
sys.dont_write_bytecode = True

import oracle  # noqa: E402


def play(name, lines):
    """Shows each line before it is run, and ends with the fault."""
    def show(number):
        print(lines[number] if number < len(lines) else "the same with a fresh object", flush=True)

    try:
        print("no fault, the end was", oracle.play(name, lines, show))
    except oracle.Fault as fault:
        sys.exit(": ".join(fault.args))
