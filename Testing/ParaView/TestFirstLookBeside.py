# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""First looks beside what is shown already: what takes the place of what, and whose camera and choices stay."""

import numpy as np
import quick
from first_looks import SIZE
from mistakes import Messages
from paraview import simple
from states import visible
from window import picture, small_view


def new_terrain():
    return simple.TurningBandsTerrain(WholeExtent=[0, 32, 0, 32, 0, 0], Spacing=[4.0, 4.0, 1.0])


def check_own_camera():
    """A camera that someone has set is left alone, also with another source and in a second reset."""
    view = small_view(SIZE)
    simple.Show(new_terrain(), view)
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (0, 0, 900), (64, 64, 0), (0, 1, 0)
    simple.Show(simple.QuadratPoints(Quadrats=[5, 5]), view)
    simple.Render(view)
    assert list(view.CameraPosition) == [0.0, 0.0, 900.0]
    simple.ResetCamera(view)
    assert list(view.CameraViewUp) == [0.0, 1.0, 0.0]
    simple.Delete(view)


def check_twin_on_raster():
    """A twin replaces the flat picture of its place, where ParaView shows that in two dimensions."""
    image = simple.Calculator(Input=new_terrain(), ResultArrayName="Height", Function="Elevation")
    image.UpdatePipeline()
    fits = simple.CovarianceFit(Input=image)
    fits.Array = ["POINTS", "Height"]
    twin = simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 32, 0, 32, 0, 0], Spacing=[4.0, 4.0, 1.0])
    for dimensions, is_replaced in (("2D", True), ("3D", False)):
        view = small_view(SIZE)
        view.InteractionMode = dimensions
        flat = simple.Show(image, view)
        flat.SetRepresentationType("Surface")
        simple.ResetCamera(view)
        simple.Render(view)
        simple.Show(twin, view)
        simple.Render(view)
        assert (flat.Visibility == 0) == is_replaced, dimensions
        assert (list(view.CameraViewUp) == [0.0, 0.0, 1.0]) == is_replaced, dimensions
        assert view.InteractionMode == "3D", dimensions
        simple.Delete(view)


def check_kelp_under_sea():
    """What is near the eye stays when the sea is shown out to the horizon."""
    kelp = simple.Seaweed()
    view = small_view(SIZE)
    simple.Show(kelp, view)
    simple.ResetCamera(view)
    simple.Render(view)
    sea = simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6)
    simple.Show(sea, view)
    simple.Render(view)
    with_it = picture(view)
    simple.Hide(kelp, view)
    drawn = (np.abs(with_it - picture(view)).sum(axis=2) > 20).mean()
    print(f"Kelp under the sea: {drawn:.3f} drawn", flush=True)
    assert drawn > 0.02, f"{drawn:.4f} of the picture is kelp"
    simple.Delete(view)


def check_forest_on_map():
    """A forest replaces the map of its sites, unless something else is shown there or the map has another color."""
    sites = simple.QuadratPoints(Size=[50, 50], Quadrats=[6, 6])
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=1500, MainBranches=8, Orders=1)
    for change, is_replaced in ((None, True), ("Background", False), ("other", False)):
        view = small_view(SIZE)
        simple.Show(sites, view)
        simple.ResetCamera(view)
        simple.Render(view)
        if change == "Background":
            view.Background = [0.9, 0.9, 1.0]
        elif change == "other":
            simple.Show(simple.Plane(), view)
        simple.Show(simple.PlantScatter(Sites=sites, Prototypes=[tree]), view)
        simple.Hide(sites, view)
        simple.Render(view)
        eye = np.array(view.CameraPosition) - np.array(view.CameraFocalPoint)
        assert (np.hypot(eye[0], eye[1]) > eye[2]) == is_replaced, (change, eye)
        assert (len(view.AdditionalLights) == 1) == is_replaced, change
        if is_replaced:
            pixels = picture(view)
            drawn = (pixels[:, :, 1] > pixels[:, :, 2] + 10).mean()
            print(f"Forest on a map: {drawn:.3f} green", flush=True)
            assert drawn > 0.02, f"{drawn:.4f} of the picture is green"
        simple.Delete(view)


def check_view_after_table():
    """What a filter makes of a table is shown where the scene is, not in a view of its own beside the table."""
    scene, sea = small_view(SIZE), simple.SeaState()
    sheet = simple.CreateView("SpreadSheetView")
    simple.SetActiveView(sheet)
    simple.SeaStatistics(Input=sea)
    assert simple.GetActiveView() == sheet, "a chart goes where it is best"
    measured = simple.MeasuredSeaState(Input=sea)
    assert simple.GetActiveView().SMProxy.GetXMLName() == "RenderView"
    simple.Delete(measured)
    simple.Delete(sheet)
    simple.Delete(scene)


def check_terrain_over_survey():
    """A terrain that takes the place of the map of its survey brings its light, as one that is alone does."""
    survey = simple.QuadratPoints(Quadrats=[4, 4], Size=[120.0, 120.0])
    heights = simple.Calculator(Input=survey, ResultArrayName="Elevation", Function="700+sin(coordsX/17)")
    view = small_view(SIZE)
    simple.Show(heights, view)
    simple.ResetCamera(view)
    simple.Render(view)
    assert len(visible(view)) == 1, visible(view)
    terrain = simple.ConditionalTerrain(Input=heights, Grid=new_terrain(), Model="Simple Exponential",
                                        StandardDeviation=1.0, Range=30.0)
    simple.Show(terrain, view)
    simple.Render(view)
    shown = visible(view)
    assert len(shown) == 2 and any(name.startswith("Light") for name in shown), shown
    simple.Delete(view)


def check_first_data_after_mistake():
    """What had no data at first, for want of a grid, is looked at once it has some, from the same side."""
    survey = simple.Calculator(Input=simple.QuadratPoints(Quadrats=[6, 6], Size=[120.0, 120.0]),
                               ResultArrayName="Elevation", Function="700+sin(coordsX/17)")
    grid = simple.TurningBandsTerrain(WholeExtent=[0, 30, 0, 30, 0, 0], Spacing=[4, 4, 1])
    field = simple.ConditionalTerrain(Input=survey, KrigingType="External Drift", Model="Simple Exponential",
                                      StandardDeviation=1.0, Range=30.0)
    view = small_view(SIZE)
    with Messages() as messages:
        simple.Show(field, view)
        simple.ResetCamera(view)
        simple.Render(view)
    assert len(messages.lines) == 1 and "as Grid" in messages.lines[0], messages.lines
    without = picture(view)
    field.Grid = grid
    simple.Render(view)
    drawn = (np.abs(picture(view) - without).sum(axis=2) > 20).mean()
    print(f"Conditional Terrain after a mistake: {drawn:.3f} drawn", flush=True)
    assert drawn > 0.1, f"{drawn:.4f} of the picture is drawn"
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0]
    # Later changes leave the camera.
    place = list(view.CameraPosition)
    field.Seed = 5
    simple.Render(view)
    assert list(view.CameraPosition) == place
    simple.Delete(view)


check_own_camera()
check_forest_on_map()
check_twin_on_raster()
check_kelp_under_sea()
check_view_after_table()
check_terrain_over_survey()
check_first_data_after_mistake()
