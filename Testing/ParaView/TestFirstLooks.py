# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2
"""What each entry of the menus shows first, with its defaults, in an empty view: way of drawing, colors, background,
lights, camera, and a picture with enough of it."""

import os

import numpy as np
import quick
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
# Colors of the background at the bottom and at the top, as the look of a mood demands: paler below a sky, darker below
# the surface of water.
SKIES = {"land": np.less, "sea": np.less, "water": np.greater}


def picture(view, name="look.png"):
    """The pixels of a view, row by row from below."""
    simple.SaveScreenshot(name, view)
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def empty_view():
    """A view as ParaView makes it."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [320, 200]
    view.OrientationAxesVisibility = 0
    simple.SetActiveView(view)
    return view


def look(name, source, port=0):
    """Shows an output in a view of its own, as a user's script would."""
    view = empty_view()
    shown = simple.Show(simple.OutputPort(source, port), view)
    simple.ResetCamera(view)
    simple.Render(view)
    with_it = picture(view)
    simple.Hide(simple.OutputPort(source, port), view)
    without = picture(view)
    drawn = np.abs(with_it - without).sum(axis=2) > 20
    colors = with_it[drawn]
    print(f"{name}: {drawn.mean():.3f} drawn, mean color {colors.mean(axis=0).round()}, spread "
          f"{colors.sum(axis=1).std():.0f}", flush=True)
    return view, shown, drawn.mean(), colors


def check(name, source, how, array, mood, share, spread=15.0, port=0, seen_from=None):
    """Checks the first look of an output."""
    view, shown, drawn, colors = look(name, source, port)
    assert shown.Representation == how, (name, shown.Representation)
    if array:
        assert shown.ColorArrayName[1] == array, (name, list(shown.ColorArrayName))
        assert shown.MapScalars == (array != "RGB"), name
    assert view.UseColorPaletteForBackground == 0 and view.BackgroundColorMode == "Gradient", name
    if mood in SKIES:
        assert SKIES[mood](sum(view.Background2), sum(view.Background)), name
        assert len(view.AdditionalLights) == 1 and view.AdditionalLights[0].Coords == "Scene", name
        sun = np.array(view.AdditionalLights[0].Position)
        side = np.hypot(sun[0], sun[1]) / sun[2]
        assert sun[2] > 0.0 and side > 0.5, f"{name}: the light is not from the side"
    assert drawn > share, f"{name}: {drawn:.4f} of the picture is drawn"
    assert colors.sum(axis=1).std() > spread, f"{name}: one flat patch"
    eye = np.array(view.CameraPosition) - np.array(view.CameraFocalPoint)
    if seen_from == "above":
        assert np.allclose(eye[:2], 0.0, atol=1e-6 * eye[2]), name
    else:
        assert list(view.CameraViewUp) == [0.0, 0.0, 1.0] and eye[2] > 0.0, name
        assert np.hypot(eye[0], eye[1]) > eye[2], f"{name} is seen from above"
    simple.Delete(view)
    return colors


# What one rank draws of all data, on any number of ranks.
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 128, 0, 128, 0, 0])
ground = check("Turning Bands Terrain", terrain, "Relief", "RGB", "land", 0.12)
red, green, blue = ground.mean(axis=0)
assert red > blue + 10 and green > blue + 10, "not the colors of the ground"
sea_state = simple.SeaState()
water = check("Sea State", sea_state, "Surface", "RGB", "sea", 0.4)
assert water.mean(axis=0)[2] > water.mean(axis=0)[0] + 10, "the sea is not blue"
check("Flow Primitive Vortex", simple.FlowPrimitive(FlowType="Vortex"), "Flow Arrows", "RGB", "water", 0.01)
check("Wind Field", simple.WindField(Dimensions=[60, 24, 12]), "Sections", "Velocity", "land", 0.05)


def check_others():
    """All other entries."""
    fits = simple.CovarianceFit(Input=terrain)
    check("From Fits", simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 128, 0, 128, 0, 0]), "Relief",
          "RGB", "land", 0.10)
    check("Image Sections", simple.ImageSections(Input=simple.WindField(Dimensions=[60, 24, 12])), "Surface", "Velocity",
          "land", 0.05)
    check("Terrain Level Of Detail", simple.TerrainLevelOfDetail(Input=terrain), "Full Surface", "RGB", "land", 0.12)
    check("Sea Surface", simple.SeaSurface(Input=sea_state), "Full Surface", "RGB", "sea", 0.4)
    for flow, least in (("Uniform", 0.02), ("Source", 0.01), ("Sink", 0.01)):
        source = simple.FlowPrimitive(FlowType=flow)
        arrows = check(f"Flow Primitive {flow}", source, "Flow Arrows", "RGB", "water", least)
        assert arrows.mean(axis=0)[0] > 100, "arrows are not bright"
    check("Quadrat Points", simple.QuadratPoints(), "Points", None, "paper", 0.005, spread=0.0,
          seen_from="above")
    check("Seaweed", simple.Seaweed(), "Surface", "RGB", "water", 0.02)
    for name in ("AonoKuniiTree", "ReevesTree", "GardnerPlant"):
        check(name, getattr(simple, name)(), "Full Surface", "RGB", "land", 0.03)


def check_twin_on_raster():
    """A twin replaces the flat picture of its place, where ParaView shows that in two dimensions."""
    image = simple.Calculator(Input=terrain, ResultArrayName="Height", Function="Elevation")
    image.UpdatePipeline()
    fits = simple.CovarianceFit(Input=image)
    fits.Array = ["POINTS", "Height"]
    twin = simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 128, 0, 128, 0, 0])
    for dimensions, is_replaced in (("2D", True), ("3D", False)):
        view = simple.CreateView("RenderView")
        view.InteractionMode = dimensions
        simple.SetActiveView(view)
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
    view = empty_view()
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
    sites = simple.QuadratPoints(Size=[200, 200])
    pine = simple.ReevesTree(Preset="Pine")
    for change, is_replaced in ((None, True), ("Background", False), ("other", False)):
        view = empty_view()
        simple.Show(sites, view)
        simple.ResetCamera(view)
        simple.Render(view)
        if change == "Background":
            view.Background = [0.9, 0.9, 1.0]
        elif change == "other":
            simple.Show(simple.Plane(), view)
        simple.Show(simple.PlantScatter(Sites=sites, Prototypes=[pine]), view)
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


def check_particles():
    """Particles keep their look through every filter: radii from their array, as lit spheres."""
    particles = simple.SuspendedParticles()
    drift = simple.CurrentDrift(Input=particles, Currents=[simple.FlowPrimitive()])
    orbits = simple.ParticleOrbits(Input=particles, SeaState=sea_state)
    for name, source in (("Suspended Particles", particles), ("Current Drift", drift), ("Particle Orbits", orbits)):
        check(name, source, "Point Gaussian", "RGB", "water", 0.01)
    for source in (particles, drift, orbits, simple.ParticleLevelOfDetail(Input=particles, SeaState=sea_state)):
        shown = simple.Show(source, empty_view())
        assert shown.Representation == "Point Gaussian" and shown.ShaderPreset == "Sphere"
        assert shown.ScaleByArray == 1 and list(shown.SetScaleArray) == ["POINTS", "Radius"]
        assert 1.0 <= shown.GaussianRadius < 50.0, shown.GaussianRadius
    # A surface on the orbits of the sea is no cloud of particles.
    shown = simple.Show(simple.ParticleOrbits(Input=simple.Plane(), SeaState=sea_state), empty_view())
    assert shown.Representation == "Surface", shown.Representation
    return particles


def check_drift_beside_currents():
    """Points that drift take the place of the points where they start, and the currents stay."""
    view = empty_view()
    particles = simple.SuspendedParticles()
    currents = simple.FlowPrimitive(FlowType="Vortex")
    start, arrows = simple.Show(particles, view), simple.Show(currents, view)
    drift = simple.CurrentDrift(Input=particles, Currents=[currents])
    drifting = simple.Show(drift, view)
    simple.Render(view)
    assert (start.Visibility, arrows.Visibility, drifting.Visibility) == (0, 1, 1)
    # Else the window's Apply hides all inputs.
    assert drift.GetHints().FindNestedElementByName("Visibility").GetAttribute("replace_input") == "0"
    start.Visibility = 1
    simple.Show(drift, view)
    assert start.Visibility == 1, "a choice of the user is undone"
    simple.Delete(view)


def check_view_after_table():
    """What a filter makes of a table is shown where the scene is, not in a view of its own beside the table."""
    scene = empty_view()
    sheet = simple.CreateView("SpreadSheetView")
    simple.SetActiveView(sheet)
    simple.SeaStatistics(Input=sea_state)
    assert simple.GetActiveView() == sheet, "a chart goes where it is best"
    measured = simple.MeasuredSeaState(Input=sea_state)
    assert simple.GetActiveView().SMProxy.GetXMLName() == "RenderView"
    simple.Delete(measured)
    simple.Delete(sheet)
    simple.Delete(scene)


def check_first_data_after_mistake():
    """What had no data at first, for want of a grid, is looked at once it has some, from the same side."""
    survey = simple.Calculator(Input=simple.QuadratPoints(Quadrats=[6, 6], Size=[120.0, 120.0]),
                               ResultArrayName="Elevation", Function="700+sin(coordsX/17)")
    grid = simple.TurningBandsTerrain(WholeExtent=[0, 30, 0, 30, 0, 0], Spacing=[4, 4, 1])
    field = simple.ConditionalTerrain(Input=survey, KrigingType="External Drift", Model="Simple Exponential",
                                      StandardDeviation=1.0, Range=30.0)
    view = empty_view()
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    simple.Show(field, view)
    simple.ResetCamera(view)
    simple.Render(view)
    vtkOutputWindow.SetInstance(before)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
    assert window.GetOutput().count("as Grid") == 1, window.GetOutput()
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


def check_legend():
    """The legend of a wind has words and a unit."""
    view = empty_view()
    shown = simple.Show(simple.WindField(Dimensions=[60, 24, 12]), view)
    simple.Render(view)
    legend = simple.GetScalarBar(shown.LookupTable, view)
    assert (legend.Title, legend.ComponentTitle) == ("Wind speed [m/s]", ""), (legend.Title, legend.ComponentTitle)
    simple.Delete(view)


def check_fog(particles):
    """Fog absorbs as 1 - exp(-F s U) over the unit distance U, for one factor F."""
    fog = simple.ParticleFog(Input=particles, Dimensions=[24, 24, 24])
    check("Particle Fog", fog, "Volume", "Extinction", "water", 0.10, spread=5.0)
    shown = simple.Show(fog, empty_view())
    points = np.array(shown.ScalarOpacityFunction.Points).reshape(-1, 4)
    depth = -np.log1p(-points[1:, 1]) / (points[1:, 0] * shown.ScalarOpacityUnitDistance)
    assert np.allclose(depth, depth[0], rtol=1e-9) and depth[0] >= 1.0, depth
    assert np.isclose(points[-1, 0], fog.PointData["Extinction"].GetRange()[1])


def check_textures():
    """The images of a plant, its other outputs, are shown as images, without a message."""
    for port in (1, 2):
        shown = simple.Show(simple.OutputPort(simple.ReevesTree(NumberOfLeaves=50), port), empty_view())
        assert shown.Representation != "Full Surface", port


if RANKS == 1:
    check_others()
    check_textures()
    check_forest_on_map()
    check_twin_on_raster()
    check_kelp_under_sea()
    check_drift_beside_currents()
    check_view_after_table()
    check_first_data_after_mistake()
    check_legend()
    check_fog(check_particles())
os.remove("look.png")
