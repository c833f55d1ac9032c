# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a measured pattern of points to one like it, in the window."""

import os

import quick
from paraview import simple

from guide import TOP, compare
from player import PANEL

PAGE = "patterns"

FILE = os.path.join(TOP, "Examples", "Data", "patterns", "redwood.csv")


def regrown(view):
    table = simple.CSVReader(FileName=[FILE])
    points = simple.TableToPoints(Input=table, XColumn="x", YColumn="y", a2DPoints=1)
    counts = simple.QuadratAnalysis(Input=points, Origin=[0.0, -1.0], Size=[1.0, 1.0])
    fits = simple.OutputPort(counts, 0)
    simple.Show(simple.QuadratPointsFromFits(Input=fits), view)


def walk(walk):
    walk.next("CSV Reader")
    walk.open(FILE, "GDALVectorReader")
    walk.apply()
    walk.entry("Filters > Alphabetical > Table To Points")
    walk.choose("XColumn", "x")
    walk.choose("YColumn", "y")
    walk.say("2D Points")
    walk.event(f"{PANEL}/Create2DPoints/CheckBox", "set_boolean", "true")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Quadrat Analysis")
    walk.set("Origin", [0, -1])
    walk.set("Size", [1, 1])
    walk.say("Quadrats 0 0")
    walk.say("Quadrats")
    walk.apply()
    walk.next("Seed")
    walk.say("Fits")
    walk.select(0, 0, 0, 0)
    walk.entry("Filters > Littoral > Quadrat Points From Fits")
    walk.apply()
    walk.look("regrown")


def check():
    kept = compare("regrown", regrown, 0.005)
    assert {"XYBarChartView", "SpreadSheetView"} <= set(kept["views"]), f"the views are {kept['views']}"
