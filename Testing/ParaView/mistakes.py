# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Usual inputs of each entry of the plugin's menus, and mistakes with it, the typical one first, by the rows of classes."""

import functools
import math
import os
import sys
import tempfile

import quick
from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import classes
from classes import EMPTY, UNMOVED

SMALL_WIND = dict(Dimensions=[100, 16, 8])


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


def tree():
    return simple.ReevesTree(NumberOfLeaves=100)


def sites():
    return simple.QuadratPoints(Size=[50.0, 50.0], Quadrats=[5, 5])


def particles():
    return simple.SuspendedParticles(Density=0.1)


def image():
    return simple.Wavelet()


def blocks():
    return simple.GroupDatasets(Input=simple.Sphere())


def inventory(head="x,y,species,dbh"):
    """An opened table of twenty oaks."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write(head + "\n" + "".join(f"{5 * (k % 5)},{6 * (k // 5)},oak,{20 + k}\n" for k in range(20)))
    return simple.CSVReader(FileName=[file.name])


def many_trees():
    """A table of 400 oaks, maples and pines."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write("x,y,species,dbh\n")
        for k in range(400):
            x, y = 5.0 * (k % 20) + 2.0 * math.sin(9.1 * k), 5.0 * (k // 20) + 2.0 * math.cos(7.7 * k)
            file.write(f"{x:.1f},{y:.1f},{('oak', 'sugar maple', 'loblolly pine')[k % 3]},{25 + 15 * math.sin(k):.1f}\n")
    return simple.CSVReader(FileName=[file.name])


def measured_spectrum():
    """A table as of a buoy, S = 1e-4 f^-5 exp(-(0.1 / f)^4) [m^2 / Hz]."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write("Frequency,Density\n")
        for k in range(5, 60):
            f = 0.01 * k
            file.write(f"{f:.2f},{1e-4 * f ** -5 * math.exp(-((0.1 / f) ** 4)):.6g}\n")
    return simple.CSVReader(FileName=[file.name])


def __getattr__(name):
    """The functions of ParaView, for the rows of classes."""
    return getattr(simple, name)


def shown_inputs(entry):
    """What an entry is usually applied to: the inputs by the names of their properties. A source has none."""
    for row in classes.ROWS:
        for own in row.entries:
            if own.proxy == entry:
                if entry in row.shown:
                    return row.shown[entry](sys.modules[__name__])
                feeders = [getattr(simple, classes.BY_NAME[name].entries[0].proxy) for name in row.fed_by]
                return {own.ports[port]: make() for port, make in enumerate(feeders) if port in own.ports}
    return {}


# The proxy, its inputs and properties, what the one message names, and what comes out.
MISTAKES = [(made.entry, functools.partial(made.given, sys.modules[__name__]), made.words, made.result)
            for row in classes.ROWS for made in row.mistakes]
