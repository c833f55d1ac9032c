# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
# run-with: pvbatch mpi=1,2 tier=all
"""The first looks of a terrain, a sea, a flow and a wind: what one rank draws of all data, on one rank and on two."""

import numpy as np
import quick
from first_looks import SIZE, check
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from window import small_view


def check_legend(shown):
    """The legend of a wind has words and a unit."""
    legend = simple.GetScalarBar(shown.LookupTable, simple.GetActiveView())
    assert (legend.Title, legend.ComponentTitle) == ("Wind speed [m/s]", ""), (legend.Title, legend.ComponentTitle)


def lights():
    """Displays of the Landscape Lights in the active view."""
    return [one for one in simple.GetActiveView().Representations
            if one.SMProxy.GetXMLName() == "LandscapeLightRepresentation"]


def check_lit(_):
    """A terrain alone has a low sun before ParaView's background."""
    assert [(one.ShowSky, one.SunElevation) for one in lights()] == [(0, 25.0)], "no Landscape Light"


def check_other_light(terrain):
    """A Landscape Light that someone adds takes the place of that of the first look."""
    view = small_view(SIZE)
    simple.Show(terrain, view)
    shown = simple.Show(simple.LandscapeLight(), view)
    assert [one.Visibility for one in lights()] == [0, 1] and shown.ShowSky == 1, "two lights"
    simple.Delete(view)


def check_own_light(terrain):
    """A view that has a user's background keeps its light."""
    view = small_view(SIZE)
    view.BackgroundColorMode, view.UseColorPaletteForBackground = "Single Color", 0
    simple.Show(terrain, view)
    assert not lights(), "a Landscape Light in a view of someone's own"
    simple.Delete(view)


def check_slopes(terrain):
    """Soil stays on nine tenths of the slopes of a square kilometre, as they are below 40 degrees."""
    grid = servermanager.Fetch(terrain)
    heights = vtk_to_numpy(grid.GetPointData().GetArray("Elevation")).reshape(grid.GetDimensions()[1::-1])
    steepness = np.hypot(*np.gradient(heights, *grid.GetSpacing()[1::-1]))
    share = (steepness < np.tan(np.radians(40.0))).mean()
    assert share > 0.9, f"only {share:.2f} of the slopes are below 40 degrees"


def check_four():
    check_slopes(simple.TurningBandsTerrain())
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 128, 0, 128, 0, 0])
    ground = check("Turning Bands Terrain", terrain, "Relief", "RGB", "land", 0.12, display=check_lit)
    check_own_light(terrain)
    red, green, blue = ground.mean(axis=0)
    assert red > blue + 10 and green > blue + 10, "not the colors of the ground"
    water = check("Sea State", simple.SeaState(), "Surface", "RGB", "sea", 0.4)
    assert water.mean(axis=0)[2] > water.mean(axis=0)[0] + 10, "the sea is not blue"
    check("Flow Primitive Vortex", simple.FlowPrimitive(FlowType="Vortex"), "Flow Arrows", "RGB", "water", 0.01)
    check("Wind Field", simple.WindField(Dimensions=[60, 24, 12]), "Sections", "Velocity", "land", 0.05,
          display=check_legend)


if __name__ == "__main__":
    check_four()
