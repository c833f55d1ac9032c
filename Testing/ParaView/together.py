# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that share one process, whose start takes longer than most of them: each in a session of its own."""

import os
import runpy

import quick
from paraview import simple

HERE = os.path.dirname(os.path.abspath(__file__))


def run(*names):
    for name in names:
        print(f"{name}:", flush=True)
        runpy.run_path(os.path.join(HERE, f"{name}.py"))
        simple.ResetSession()
