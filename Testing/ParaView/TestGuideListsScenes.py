# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""The guide's list of a macro, in the window: a twin of a terrain."""

import os
import shutil

import quick
from paraview import simple

from guide import TOP, WINDOW, Walk, compare

MACROS = os.path.join(TOP, "paraview-plugin", "Macros")


def write_raster(file):
    place = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0], Seed=3)
    simple.SaveData(file, proxy=place)
    simple.ResetSession()


def run(walk, name):
    """Import a macro and choose it in the menu."""
    walk.say(f"Macros > {name}")
    walk.event(f"{WINDOW}/menubar/menu_Macros", "activate", "actionMacroCreate")
    walk.event(f"{WINDOW}/FileOpenDialog", "filesSelected", os.path.join(MACROS, f"{name}.py"))
    walk.event(f"{WINDOW}/menubar/menu_Macros", "activate", name)


def twin(view):
    fit = simple.CovarianceFit(Input=simple.XMLImageDataReader(FileName=["place.vti"]))
    place = simple.TurningBandsTerrainFromFits(
        Input=simple.OutputPort(fit, 0), WholeExtent=[0, 60, 0, 40, 0, 0], Spacing=[10.0, 10.0, 1.0])
    simple.Show(simple.TerrainLevelOfDetail(Input=place), view)


def main():
    shutil.rmtree("settings", ignore_errors=True)
    os.environ["XDG_CONFIG_HOME"] = os.path.abspath("settings")  # where ParaView keeps an imported macro
    write_raster("place.vti")
    walk = Walk(__file__, "scenes")
    walk.next()
    walk.open("place.vti")
    walk.apply()
    walk.next("Seed", "Twin")
    run(walk, "twin_from_raster")
    walk.look("twin")
    walk.end()
    compare("twin", twin, 0.2)


if __name__ == "__main__":
    main()
