# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Far plants of a forest of instances under Landscape Light are impostors: as bright and as large as in the level before,
also where they are exchanged for each other pixel by pixel, and their pictures last through a drag, but not through
other values. Without the light they are as before.
"""

import re

import quick
import TestInstances
from paraview import simple
from window import apart, picture, small_view

SIZE = (240, 150)


def scene():
    """A view of a row of trees before the sky."""
    view = small_view(SIZE)
    sites = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=TestInstances.SITES)
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=2500, LeafSize=0.6, MainBranches=12, Orders=1)
    forest = simple.PlantScatter(Sites=sites, Prototypes=[tree], OutputForm="Instances", FollowCamera=0,
                                 ViewPoint=[45.0, -60.0, 10.0], ViewDirection=[0.0, 1.0, -0.05], UseLevels=0)
    simple.Show(forest, view)
    simple.Render(view)  # sets the camera
    view.CameraPosition, view.CameraFocalPoint = [45.0, -60.0, 10.0], [45.0, 40.0, 5.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view, forest


def look_of(shown):
    """Where there are trees, darker than the sky, and their mean color."""
    trees = shown.sum(axis=2) < 330
    return trees, shown[trees].mean()


def at_level(view, forest, near, far):
    """The picture with the far level from a distance on."""
    forest.UseLevels, forest.NearDistance, forest.FarDistance = 1, near, far
    return picture(view)


def check_far(view, forest):
    trees, color = look_of(at_level(view, forest, 10.0, 1000.0))
    assert 0.1 < trees.mean() < 0.7, trees.mean()
    for distances in ((10.0, 30.0), (10.0, 130.0)):  # all far, and most of them being exchanged
        far, far_color = look_of(at_level(view, forest, *distances))
        overlap = (far & trees).sum() / (far | trees).sum()
        print(distances, "overlap", overlap, "color", far_color / color)
        assert overlap > 0.8, f"{distances}: {overlap}"
        assert abs(far_color / color - 1.0) < 0.08, f"{distances}: {far_color / color}"


def times_taken(view):
    """How often pictures of plants were taken."""
    props = view.GetRenderer().GetViewProps()
    mappers = [prop.GetMapper() for prop in map(props.GetItemAsObject, range(props.GetNumberOfItems()))
               if prop.IsA("vtkActor")]
    impostors = [mapper for mapper in mappers if mapper and mapper.IsA("vtkImpostorMapper")]
    return [int(re.search(r"TimesTaken: (\d+)", str(mapper))[1]) for mapper in impostors]


def check_drag(view, forest):
    """Pictures of plants are not taken anew for a drag, which shows them by another mapper of the view."""
    at_level(view, forest, 10.0, 30.0)
    view.LODThreshold = 0.0
    before = times_taken(view)
    for draw in (view.SMProxy.InteractiveRender, lambda: simple.Render(view)):
        draw()
        assert before and times_taken(view) == before, f"{times_taken(view)} times, {before} before"


def check_colors(view, forest):
    """Pictures of plants are taken anew for other values of the same points, by which they are colored."""
    shade = simple.Calculator(Input=forest.Prototypes[0], ResultArrayName="Shade", Function="0")
    forest.Prototypes = [shade]
    simple.Render(view)  # has the array from then on
    shown = simple.GetRepresentation(forest, view)
    shown.MapScalars = 1
    simple.ColorBy(shown, ("POINTS", "Shade"))
    shown.SetScalarBarVisibility(view, False)
    simple.GetColorTransferFunction("Shade").RGBPoints = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0]
    shade.Function = "1"
    drawn = at_level(view, forest, 10.0, 30.0)
    red, green = drawn[:, :, 0], drawn[:, :, 1]
    print("green", (green > red + 40).mean(), "red", (red > green + 40).mean())
    assert (green > red + 40).mean() > 0.04 and not (red > green + 40).any()


def main():
    view, forest = scene()
    dark = at_level(view, forest, 10.0, 30.0)
    forest.UseLevels = 0
    light = simple.LandscapeLight()
    simple.Show(light, view)
    check_far(view, forest)
    check_drag(view, forest)
    simple.Hide(light, view)
    assert apart(at_level(view, forest, 10.0, 30.0), dark, 16) < 0.002, "without the light"
    simple.Show(light, view)
    check_colors(view, forest)


if __name__ == "__main__":
    main()
