# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Plants of textured quadrics in ParaView: blocks, a forest of two kinds, the wind, the picture on the leaves."""

import os
import tempfile

import numpy as np
import quick
from gusts import INFORMATION, WIND
from paraview import simple
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import plants


def leaves_of(proxy):
    """Points of the leaves in full, and the joint of each."""
    leaves = plants.block(Fetch(proxy), "High", "Leaves")
    return (vtk_to_numpy(leaves.GetPoints().GetData()).astype(float),
            vtk_to_numpy(leaves.GetPointData().GetArray("JointIds"))[:, 0])


def polygons(proxy):
    """Number of polygons of the leaves in full and of the lowest level."""
    data = Fetch(proxy)
    return plants.block(data, "High", "Leaves").GetNumberOfPolys(), plants.block(data, "Low").GetNumberOfPolys()


bush = simple.GardnerPlant(Preset="Bush")
assert polygons(bush)[0] > 5000 and polygons(bush)[1] == 4
custom = simple.GardnerPlant(
    Preset="Custom", Height=5.0, CrownRadius=1.5, CrownBase=1.0, TrunkRadius=0.1, NumberOfQuadrics=3,
    Shells=2, Terms=5, Frequency="4", Offset=0.8, CenterThreshold=0.05, SilhouetteThreshold=0.3,
    Variation=0.1, Seed=4)
assert 300 < polygons(custom)[0] < polygons(bush)[0]

simple._DisableFirstRenderCameraReset()
view = simple.CreateView("RenderView")
view.ViewSize = [300, 300]
shown = simple.Show(bush, view)
assert shown.MapScalars == 0 and list(shown.BlockSelectors) == ["/Root/High/Skin", "/Root/High/Leaves"]
simple.Hide(bush, view)

# The wind moves each tuft as a whole.
wind = simple.ProgrammableSource(OutputDataSetType="vtkImageData", Script=WIND,
                                 ScriptRequestInformation=INFORMATION)
sway = simple.BeamTreeDeformation(Input=bush, Wind=wind, NumberOfModes=1, DampingRatio=0.05)
sway.UpdatePipeline(3.0)
rest, joints = leaves_of(bush)
moved, _ = leaves_of(sway)
assert np.abs(moved - rest).max() > 1e-4, "the wind does not move the leaves"
for joint in set(joints):
    tuft = np.flatnonzero(joints == joint)
    ends = tuft[[0, len(tuft) // 2, -1]]
    for a, b in ((0, 1), (1, 2)):
        lengths = [np.linalg.norm(p[ends[a]] - p[ends[b]]) for p in (rest, moved)]
        assert abs(lengths[0] - lengths[1]) < 1e-5, "a tuft changes its form"

# A forest of both kinds, with the common picture of their leaves.
sites = simple.QuadratPoints(Size=[30.0, 30.0], Quadrats=[4, 4], MeanPerQuadrat=1.0)
forest = simple.PlantScatter(
    Sites=sites, Prototypes=[simple.ReevesTree(Preset="Shrub"), bush], FollowCamera=0, UseLevels=0, UseCulling=0)
simple.UpdatePipeline(proxy=forest)
species = vtk_to_numpy(Fetch(forest).GetFieldData().GetArray("Species"))
assert set(species) == {0, 1}


def background(folder):
    """Number of pixels of the view in which nothing is seen."""
    shot = os.path.join(folder, "forest.png")
    simple.SaveScreenshot(shot, view)
    pixels = vtk_to_numpy(Fetch(simple.PNGSeriesReader(FileNames=[shot])).GetPointData().GetScalars())
    return np.count_nonzero((pixels[:, :3] == (255, 0, 255)).all(axis=1))


view.CameraPosition, view.CameraFocalPoint = [15.0, -9.0, 4.0], [15.0, 12.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.BackgroundColorMode, view.Background, view.UseColorPaletteForBackground = "Single Color", [1.0, 0.0, 1.0], 0
view.OrientationAxesVisibility = 0
with tempfile.TemporaryDirectory() as folder:
    picture = os.path.join(folder, "leaves.png")
    simple.SaveData(picture, simple.OutputPort(forest, 2))
    texels = vtk_to_numpy(Fetch(simple.PNGSeriesReader(FileNames=[picture])).GetPointData().GetScalars())
    forest_shown = simple.Show(forest, view)
    forest_shown.BlockSelectors = [f"/Root/{part}" for part in ("High/Skin", "High/Leaves", "Medium", "Low")]
    cut_out = 300 * 300 - background(folder)
    forest_shown.SetRepresentationType("Surface")
    covered = 300 * 300 - background(folder)
assert 0.1 < (texels[:, 3] < 128).mean() < 0.9, "the picture of the leaves has no outline"
print(covered, "pixels without the picture,", cut_out, "with it")
assert covered > 5000, "no forest in the picture"
assert 0.5 * covered < cut_out < 0.97 * covered, "the leaves are not cut out"
