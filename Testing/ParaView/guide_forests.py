# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from sites and a tree to a forest, in the window; then the view is dragged."""

import quick
from paraview import simple

from guide import WINDOW, compare
from player import difference

PAGE = "forests"

VIEWPORT = f"{WINDOW}/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container" \
    "/Frame.0/CentralWidgetFrame/Viewport"


def wood(view):
    sites = simple.QuadratPoints(Size=[200.0, 200.0])
    simple.Show(simple.PlantScatter(Sites=sites, Prototypes=simple.ReevesTree()), view)


def walk(walk):
    walk.next()
    walk.entry("Sources > Littoral > Quadrat Points")
    walk.set("Size", [200, 200], said="Size to 200 200 [m]")
    walk.apply()
    walk.next("Gardner Plant")
    walk.say("Reeves Tree")
    walk.source("ReevesTree")
    walk.apply()
    walk.next("Terrain")
    walk.select(0)
    walk.entry("Filters > Littoral > Plant Scatter")
    walk.take_input("Prototypes", "Plant", "/0/1/0|0")
    walk.apply()
    walk.look("wood")
    walk.next("Near Distance", "Far Distance", "Move Tolerance", "Turn Tolerance", "Interactive Detail")
    walk.say("Follow Camera")
    walk.event(VIEWPORT, "mousePress", "(0.5,0.5,1,1,0)")
    walk.event(VIEWPORT, "mouseMove", "(0.7,0.5,1,0,0)")
    walk.event(VIEWPORT, "mouseRelease", "(0.7,0.5,1,0,0)")
    walk.look("dragged")


def check():
    compare("wood", wood, 0.2)
    compare("dragged", wood, 0.2)
    assert difference("wood.png", "dragged.png") > 0.05, "the view was not dragged"
