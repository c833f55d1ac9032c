# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes with each entry of the plugin's menus, the typical one of an entry first, by the rows of classes."""

import functools
import os
import sys
import tempfile

import quick
from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import classes
from classes import EMPTY, UNMOVED
from examples import Examples

pv = Examples(simple)
SMALL_WIND, tree, sites, particles, inventory = pv.SMALL_WIND, pv.tree, pv.sites, pv.particles, pv.inventory


class Messages:
    """What is printed meanwhile: VTK, ParaView and its window write to file descriptor 2."""

    def __enter__(self):
        self.file = tempfile.TemporaryFile()
        self.before = os.dup(2)
        os.dup2(self.file.fileno(), 2)
        return self

    def __exit__(self, *_):
        sys.stderr.flush()
        os.dup2(self.before, 2)
        os.close(self.before)
        self.file.seek(0)
        lines = self.file.read().decode(errors="replace").splitlines()
        self.lines = [line for line in lines if any(word in line for word in ("ERR|", "WARN|", "ERROR:", "Warning:"))]


# The proxy, its inputs and properties, what the one message names, and what comes out.
MISTAKES = [(made.entry, functools.partial(made.given, pv), made.words, made.result)
            for row in classes.ROWS for made in row.mistakes]
