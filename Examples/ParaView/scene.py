# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch args=. args=--quick
# run-with: pvbatch tier=all
"""A ParaView scene: a measured terrain and a twin grown from its statistics.

    ./littoral gui                    opens it in ParaView
    pvbatch scene.py [FOLDER]         writes scene.png and scene.pvsm into FOLDER; with --quick behind it
                                      small, of coarse ground, for a test

Change `Seed` of the twin and press Apply: another terrain with the same statistics appears, with
its shadows. The chart shows the measured variogram and the fitted models.
"""

import os
import sys
import tempfile

from paraview import servermanager, simple

from littoral.elevation import array_from_image, image_from_array, read_elevation
from littoral.gallery.relief import BASE, beds, floor, light_of, row_camera, row_centers, tints, width_of
from littoral.gallery.views import light, look, reader, show_colored
from littoral.tables import model_names
from littoral.versions import move_display

EXAGGERATION = 3.0

#: Red, green, blue of the measured points and of the models, best first.
COLOURS = ("0.2 0.2 0.25", "0.8 0.27 0.12", "0.15 0.45 0.7", "0.3 0.6 0.35", "0.75 0.55 0.15")


def show_block(name, terrain, place, center, view):
    """Show a terrain as a block beside others, with tints of the heights of a place and cut sides."""
    heights, width = array_from_image(place), width_of(place)
    depth = BASE * width / EXAGGERATION + float(heights.max() - heights.min())
    ground = simple.TerrainLevelOfDetail(registrationName=f"Ground of {name}", Input=terrain, NumberOfLevels=1,
                                         UseCulling=0, FollowCamera=0)
    surface = simple.ExtractBlock(registrationName=f"Surface of {name}", Input=ground, Selectors=["/Root/Level0"])
    edge = simple.FeatureEdges(registrationName=f"Edge of {name}", Input=surface, FeatureEdges=0, NonManifoldEdges=0)
    sides = simple.LinearExtrusion(
        registrationName=f"Sides of {name}", Input=edge, Vector=[0.0, 0.0, -depth], Capping=0)
    beds_of = simple.Elevation(registrationName=f"Beds of {name}", Input=sides, ScalarRange=[0.0, 1.0],
                               LowPoint=[0.0, 0.0, float(heights.max()) - depth],
                               HighPoint=[0.0, 0.0, float(heights.max())])
    x, y = (0.5 * sum(place.GetBounds()[2 * k:2 * k + 2]) for k in (0, 1))
    # The color map editor of ParaView 5.11's window fails on the histogram of what is active and not drawn.
    simple.SetActiveSource(None)
    for source, colors in ((ground, tints(heights)), (beds_of, beds())):
        shown = simple.Show(source, view)
        shown.ColorArrayName, shown.MapScalars = ["POINTS", "Elevation"], 1
        shown.LookupTable = simple.CreateLookupTable(
            RGBPoints=[number for row in colors for number in row], ColorSpace="RGB", AutomaticRescaleRangeMode="Never")
        shown.Scale = [1.0, 1.0, EXAGGERATION]
        move_display(shown, [center[0] - x, center[1] - y, BASE * width - float(heights.min()) * EXAGGERATION])


def grown_like(fits, place):
    """The twin: a terrain on the grid of the measured one, from the table of fits."""
    return simple.TurningBandsTerrainFromFits(
        registrationName="Twin", Input=fits, WholeExtent=place.GetExtent(),
        Origin=place.GetOrigin(), Spacing=place.GetSpacing())


def show_variogram(fit, view):
    """Show the second output of the fit as a chart: measured points, fitted lines."""
    fit.UpdatePipeline()
    models = model_names(servermanager.Fetch(simple.OutputPort(fit, 0)))
    shown = simple.Show(simple.OutputPort(fit, 1), view, "XYChartRepresentation")
    shown.UseIndexForXAxis = 0
    shown.XArrayName = "Lag"
    shown.SeriesVisibility = ["Semivariance"] + models[:4]
    shown.SeriesMarkerStyle = ["Semivariance", "4"]
    shown.SeriesMarkerSize = ["Semivariance", "7"]
    shown.SeriesLineStyle = ["Semivariance", "0"]
    shown.SeriesLineThickness = [models[0], "4"]
    colors = dict(zip(["Semivariance"] + models, COLOURS))
    shown.SeriesColor = [
        word for name, color in colors.items() for word in (name, *color.split())]
    view.LeftAxisLogScale = view.BottomAxisLogScale = 1
    view.BottomAxisTitle = "Lag (m)"
    view.LeftAxisTitle = "Semivariance (m\u00b2)"
    view.ShowLegend = 1
    view.LegendLocation = "BottomRight"
    view.BottomAxisTitleFontSize = view.LeftAxisTitleFontSize = 12
    simple.Render(view)


def prepare_view(view, folder, width, count):
    """Set up a view for a row of blocks: floor, camera and light."""
    show_colored(reader("Floor", floor(width, count), folder), view)
    eye, focus, angle = row_camera(width, count, view.ViewSize[0] / view.ViewSize[1])
    settings = light_of(width, sum((a - b) ** 2 for a, b in zip(eye, focus)) ** 0.5)
    light(view, VisibilityDistance=settings.pop("Visibility"), LightsColorMaps=1, **settings)
    look(view, eye, focus, angle)


def build(folder, size, quick=False):
    """Build the pipeline and its views, of a size in pixels; quick: of coarse ground. Returns the render view."""
    place = read_elevation()
    if quick:
        place = image_from_array(array_from_image(place)[::3, ::3], [3.0 * side for side in place.GetSpacing()])
    measured = reader("Jacksboro fault", place, folder)
    fit = simple.CovarianceFit(registrationName="Fit", Input=measured)
    twin = grown_like(fit, place)

    # The ParaView window already has a view; a script has to create one.
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = size
    layout = simple.GetLayout(view)
    width = width_of(place)
    for name, terrain, center in zip(("the place", "the twin"), (measured, twin), row_centers(width, 2)):
        show_block(name, terrain, place, center, view)

    chart = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(chart, layout, layout.SplitVertical(0, 0.6))
    show_variogram(fit, chart)
    prepare_view(view, folder, width, 2)
    simple.SetActiveView(view)
    simple.SetActiveSource(twin)
    simple.Render(view)
    return view


def main():
    """Build the scene; in batch, also write image and state."""
    simple._DisableFirstRenderCameraReset()
    folder = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-")
    os.makedirs(folder, exist_ok=True)
    quick = "--quick" in sys.argv
    view = build(folder, [400, 190] if quick else [1600, 760], quick)
    if __name__ == "__main__" and len(sys.argv) > 1:
        simple.SaveScreenshot(os.path.join(folder, "scene.png"), view)
        simple.SaveState(os.path.join(folder, "scene.pvsm"))


main()
