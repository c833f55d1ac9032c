# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""In coarse maps of shadows all levels of instances cast those of the medium level. The picture is as near to one with
maps of 64 times as many texels, which have all leaves, as that of the merged forest, of which all maps have all leaves.
"""

import numpy as np
import quick
import TestInstances
from paraview import simple
from window import picture, small_view

SIZE = (240, 150)


def scene():
    """A view from within a wood, whose nearest trees are in full."""
    view = small_view(SIZE)
    sites = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=TestInstances.SITES)
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=2500, LeafSize=0.6, MainBranches=12, Orders=1)
    forest = simple.PlantScatter(Sites=sites, Prototypes=[tree], FollowCamera=0, ViewPoint=[45.0, 10.0, 5.0],
                                 ViewDirection=[0.0, 1.0, -0.05], NearDistance=40.0, FarDistance=200.0, UseCulling=0)
    ground = simple.Plane(Origin=[-5.0, -5.0, 0.0], Point1=[95.0, -5.0, 0.0], Point2=[-5.0, 115.0, 0.0])
    for one in (forest, ground):
        simple.Show(one, view)
    light = simple.Show(simple.LandscapeLight(), view, SunElevation=40.0, SunAzimuth=150.0, CoverRadius=0.0)
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint = [45.0, -10.0, 12.0], [45.0, 60.0, 4.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view, forest, light


def main():
    view, forest, light = scene()
    shown = {}
    for form, size in (("Merged", "4096"), ("Merged", "512"), ("Instances", "512")):
        forest.OutputForm, light.MapSize = form, size
        shown[form, size] = picture(view)
    fine, whole, short = shown.values()
    errors = [np.abs(one - fine).max(axis=2) for one in (whole, short)]
    means = [error.mean() for error in errors]
    ends = [np.percentile(error, 99) for error in errors]
    print("from fine maps: mean", means, "99th percentile", ends, "from each other", np.abs(whole - short).mean())
    assert means[1] < means[0] + 1.0 and ends[1] < ends[0] + 8.0, (means, ends)
    assert abs((short - whole).mean()) < 0.5, (short - whole).mean()
    assert not np.array_equal(short, whole)


if __name__ == "__main__":
    main()
