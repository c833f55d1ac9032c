# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""FollowCamera: levels of detail change with the camera, and after a state; TestServers has it before a server."""

import math
import os

import quick
from paraview import simple

NUMBER = 400  # of plants


def counts(forest):
    """Number of plants at each level, from the field data of what is shown."""
    forest.UpdatePipeline()
    fields = forest.GetDataInformation().GetFieldDataInformation()
    return [fields.GetArrayInformation("Plants" + level).GetComponentRange(0)[0]
            for level in ("High", "Medium", "Low")]


def forest_in(view):
    """A forest with few leaves on flat ground, shown."""
    sites = simple.QuadratPoints(Size=[400.0, 400.0], Quadrats=[20, 20])
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)
    forest = simple.PlantScatter(
        registrationName="Forest", Sites=sites, Prototypes=[tree], NearDistance=60.0, FarDistance=250.0)
    shown = simple.Show(forest, view)
    assert shown.MapScalars == 0, "colors go through a color map"
    return forest


def stand(view, distance):
    """Put the camera in front of the forest, and draw."""
    view.CameraPosition = [200.0, -distance, 30.0]
    view.CameraFocalPoint = [200.0, 200.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.Render(view)


def check_follows(forest, view, where):
    """The levels are those of the camera's place in each picture."""
    stand(view, 20.0)
    near = counts(forest)
    stand(view, 2000.0)
    far = counts(forest)
    assert near[0] > 0, f"{where}: nothing is at the highest level near by: {near}"
    assert far[0] == far[1] == 0 and far[2] > 0, f"{where}: not all are at the lowest level: {far}"
    stand(view, 20.0)
    assert counts(forest) == near, f"{where}: the way back gives other levels"


def check_parallel(forest, view, where):
    """In parallel projection no plant on the picture is lost, and levels go by the scale, not by the distance."""
    def look(scale, height):
        view.CameraParallelProjection = 1
        view.CameraPosition = [200.0, -300.0, height]
        view.CameraFocalPoint = [200.0, 200.0, height]
        view.CameraViewUp = [0.0, 0.0, 1.0]
        view.CameraParallelScale = scale
        simple.Render(view)
        return counts(forest)

    # Half of a picture of 4 by 3 is 4 / 3 of the scale: all of the 400 m, which a perspective that shows as much at the
    # focal point does not near by.
    whole = look(170.0, 0.0)
    assert sum(whole) == NUMBER, f"{where}: of {NUMBER} plants in parallel projection {sum(whole)} are kept"
    assert whole[2] == NUMBER, f"{where}: not all are at one level: {whole}"
    near = look(10.0, 0.0)
    assert near[0] > 0 and near[1] == near[2] == 0, f"{where}: not all are at the highest level: {near}"
    assert near[0] < NUMBER / 4, f"{where}: {near[0]} of {NUMBER} plants are kept in a tenth of the forest"
    assert sum(look(10.0, 200.0)) == 0, f"{where}: plants far below the picture are kept"
    view.CameraParallelProjection = 0
    stand(view, 20.0)
    assert counts(forest)[1] > 0, f"{where}: it does not come back to perspective"


def check_horizontal(forest, view, where):
    """An angle across the picture is that of the camera's height over its width, in wide and in tall views."""
    camera = view.GetActiveCamera()
    camera.SetUseHorizontalViewAngle(1)
    size = list(view.ViewSize)
    for wide, tall in ([200, 50], [50, 200]):
        view.ViewSize = [wide, tall]
        stand(view, 20.0)
        wide, tall = view.ViewSize
        half = math.tan(math.radians(camera.GetViewAngle()) / 2) * tall / wide
        angle = math.degrees(2 * math.atan(half))
        assert abs(forest.ViewAngle - angle) < 1e-6, f"{where}: ViewAngle {forest.ViewAngle}, not {angle}"
    camera.SetUseHorizontalViewAngle(0)
    view.ViewSize = size
    stand(view, 20.0)
    assert abs(forest.ViewAngle - camera.GetViewAngle()) < 1e-6, f"{where}: it does not come back to a vertical angle"


def check_screenshot(forest, view, where):
    """A screenshot larger than the view, which is drawn in tiles, has the levels of a view of its size."""
    size = list(view.ViewSize)
    stand(view, 20.0)
    for wide, tall in ([2 * size[0], 2 * size[1]], [3 * size[0], size[1]]):
        simple.SaveScreenshot(os.path.abspath("tiles.png"), view, ImageResolution=[wide, tall])
        seen, height = counts(forest), forest.ViewHeight
        assert height == tall, f"{where}: levels for {height} pixels in a screenshot {tall} high"
        view.ViewSize = [wide, tall]
        stand(view, 20.0)
        assert seen == counts(forest), f"{where}: {seen} in a screenshot of {wide} x {tall}, not {counts(forest)}"
        view.ViewSize = size
        stand(view, 20.0)


def check_turn(forest, view, where):
    """A turn is nothing new to a forest of instances that is not culled; it is to one that is."""
    forest.OutputForm, forest.UseCulling = "Instances", 0
    stand(view, 20.0)
    before = list(forest.ViewDirection)
    view.GetActiveCamera().Yaw(25.0)
    simple.Render(view)
    assert list(forest.ViewDirection) == before, f"{where}: it takes another direction"
    forest.UseCulling = 1
    simple.Render(view)
    assert list(forest.ViewDirection) != before, f"{where}: a culled forest does not follow a turn"
    forest.OutputForm = "Merged"


def check_beside(forest, view, other, where):
    """The active view, which shows nothing of the forest, leaves its levels to the camera of the other view."""
    simple.SetActiveView(other)
    stand(view, 20.0)
    near = counts(forest)
    for one in (other, view, other):
        simple.Render(one)
    assert counts(forest) == near and near[0] > 0, f"{where}: {counts(forest)} plants beside a sphere, not {near}"
    stand(view, 2000.0)
    simple.Render(other)
    assert counts(forest)[0] == 0, f"{where}: it follows the camera of the active view"
    simple.SetActiveView(view)


def sphere_beside():
    """A view of something else far away."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [100, 100]
    simple.Show(simple.Sphere(Center=[5000.0, 0.0, 0.0]), view)
    simple.ResetCamera(view)
    return view


def check_here(where):
    """Ticked, not ticked, and after a state file."""
    view = next(iter(simple.GetViews(viewtype="RenderView")), None) or simple.CreateView("RenderView")
    view.ViewSize = [200, 150]
    forest = forest_in(view)
    forest.UseCulling = 0
    simple.ResetCamera(view)
    forest.UseCulling = 1
    simple.Render(view)
    assert sum(counts(forest)) == NUMBER, f"{where}: {counts(forest)} plants in the first picture, not {NUMBER}"
    check_follows(forest, view, where)
    check_parallel(forest, view, where)
    check_horizontal(forest, view, where)
    check_screenshot(forest, view, where)
    check_turn(forest, view, where)

    forest.FollowCamera = 0
    stand(view, 20.0)
    before = counts(forest)
    stand(view, 2000.0)
    assert counts(forest) == before, f"{where}: it follows though it should not"
    forest.FollowCamera = 1

    other = sphere_beside()
    check_beside(forest, view, other, where)
    simple.SetActiveView(other)
    state = os.path.abspath(f"follow-{where}.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
    forest = simple.FindSource("Forest")
    views = simple.GetViews(viewtype="RenderView")
    view = next(one for one in views if any(getattr(shown, "Input", None) == forest for shown in one.Representations))
    # ParaView 5.13 with Qt 6 warns of its frame buffer where a new view's first picture waits for data that change.
    simple.Render(view)
    check_follows(forest, view, f"{where}, after a state")
    check_beside(forest, view, next(one for one in views if one != view), f"{where}, after a state")


if __name__ != "TestFollowCamera":
    check_here("window" if os.environ.get("LITTORAL_CLIENT_SCRIPT") else "batch")
