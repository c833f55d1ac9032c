# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a raster of heights to a terrain like it, in the window, with a small raster of the test."""

import quick
from paraview import simple

from guide import WINDOW, compare
from player import difference

PAGE = "first-steps"


def open_example():
    """In the client: something, as the example of `./littoral gui` is, which has a test of its own."""
    simple.Show(simple.ReevesTree(NumberOfLeaves=100))
    simple.Render()


def write_raster(file):
    place = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0], Seed=3)
    simple.SaveData(file, proxy=place)
    simple.ResetSession()


def twin(view):
    place = simple.XMLImageDataReader(FileName=["place.vti"])
    fits = simple.OutputPort(simple.CovarianceFit(Input=place), 0)
    grown = simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0])
    simple.Show(grown, view)
    return place, grown


def relief(view):
    place, grown = twin(view)
    simple.Hide(grown, view)
    simple.Show(place, view).SetRepresentationType("Relief")
    heights = grown.PointData["Elevation"].GetRange()  # the last Apply fits the colors to what it shows, the twin
    simple.GetColorTransferFunction("Elevation").RescaleTransferFunction(*heights)


def prepare():
    write_raster("place.vti")


def walk(walk):
    walk.next("./littoral gui", "Reset Session")  # with a server: none here
    walk.call(open_example)
    walk.say("Edit > Reset Session")
    walk.empty()
    walk.next("Elevation Raster", "Projection", "Relief")  # TestRasters opens one
    walk.open("place.vti")
    walk.apply()
    walk.next("Use No Data Value")
    walk.entry("Filters > Littoral > Covariance Fit")
    walk.apply()
    walk.next("Use Measured Grid", "Seed")
    walk.say("Fits")
    walk.select(0, 0, 0)
    walk.entry("Filters > Littoral > Turning Bands Terrain From Fits")
    walk.set("Whole Extent", [0, 60, 0, 40, 0, 0], widget="LineEdit")
    walk.set("Spacing", [10, 10, 1])
    walk.apply()
    walk.say("Relief")
    walk.look("twin")
    walk.next("File > Save Data", ".tif")
    walk.next("Filters > Common > Warp By Scalar", "Scale Factor")
    walk.eye(0)
    walk.eye(0, 0, 0, 0)
    walk.select(0)
    walk.say("Relief")
    walk.event(f"{WINDOW}/representationToolbar/displayRepresentation/comboBox", "set_string", "Relief")
    walk.look("relief")


def check():
    kept = compare("twin", twin, 0.2)
    assert {"XYChartView", "SpreadSheetView"} <= set(kept["views"]), f"the views are {kept['views']}"
    compare("relief", relief, 0.2)
    part = difference("relief.png", "twin.png")
    assert part > 0.2, f"the twin is still shown: {part:.1%} of the picture have changed"
