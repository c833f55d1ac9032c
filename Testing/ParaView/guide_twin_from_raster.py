# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list of the macro that makes the twin of a raster, in the window."""

import quick
from paraview import simple

from guide import compare

PAGE = "scenes"


def prepare():
    place = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0], Seed=3)
    simple.SaveData("place.vti", proxy=place)
    simple.ResetSession()


def twin(view):
    fit = simple.CovarianceFit(Input=simple.XMLImageDataReader(FileName=["place.vti"]))
    twin = simple.TurningBandsTerrainFromFits(
        Input=simple.OutputPort(fit, 0), WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0])
    valleys = simple.Drainage(Input=twin, Target=fit.Input)
    simple.Show(simple.TerrainLevelOfDetail(Input=simple.OutputPort(valleys, 0)), view)
    simple.Show(simple.OutputPort(valleys, 1), view)


def walk(walk):
    walk.next()
    walk.open("place.vti")
    walk.apply()
    walk.next("Seed", "Twin")
    walk.macro("twin_from_raster")
    walk.look("twin")


def check():
    compare("twin", twin, 0.2)
