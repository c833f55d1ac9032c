# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Seaweeds in ParaView: presets, every property, first look, a bed of them on the sea's floor."""

import numpy as np
import quick
from paraview import simple
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import plants

SEGMENTS = ("Width", "Thickness", "Length", "YoungModulus", "DampingRatio", "Density", "Across", "Tissue",
            "Attachment", "RestTheta", "RestPhi")


def height(proxy):
    """Height of the blades in full [m]."""
    return plants.block(Fetch(proxy), "High", "Leaves").GetBounds()[5]


sizes = {"Sugar Kelp": (1.0, 3.0), "Giant Kelp": (10.0, 30.0), "Eelgrass": (0.3, 1.0)}
for preset, (low, high) in sizes.items():
    weed = simple.Seaweed(Preset=preset)
    assert low < height(weed) < high, preset
    assert plants.block(Fetch(weed), "Low").GetNumberOfPolys() == 4
    skeleton = plants.block(Fetch(weed), "High", "Skeleton")
    for name in SEGMENTS:
        assert skeleton.GetPointData().GetArray(name), name

custom = simple.Seaweed(
    Preset="Custom", Form="Canopy", NumberOfFronds=2, HoldfastRadius=0.1, SpreadAngle=20.0, StipeLength=5.0,
    StipeRadius=0.01, BladeLength=0.5, BladeWidth=0.1, BladeThickness=0.001, Ruffle=0.1, BladeSpacing=0.5,
    FloatRadius=0.015, StipeModulus=2e7, BladeModulus=5e6, DampingRatio=0.2, StipeDensity=1030.0,
    BladeDensity=1040.0, FloatDensity=250.0, Variation=0.1, SegmentsPerBranch=8, Seed=4)
skeleton = plants.block(Fetch(custom), "High", "Skeleton")
tissue = vtk_to_numpy(skeleton.GetPointData().GetArray("Tissue"))
density = vtk_to_numpy(skeleton.GetPointData().GetArray("Density"))
modulus = vtk_to_numpy(skeleton.GetPointData().GetArray("YoungModulus"))
for kind, wanted, stiffness in ((0, 1030.0, 2e7), (1, 1040.0, 5e6), (2, 250.0, 2e7)):
    assert np.all(density[tissue == kind] == wanted) and np.any(tissue == kind), kind
    assert np.all(modulus[tissue == kind] == np.float32(stiffness)), kind

simple._DisableFirstRenderCameraReset()
view = simple.CreateView("RenderView")
view.ViewSize = [200, 200]
shown = simple.Show(custom, view)
assert shown.MapScalars == 0 and "/Root/High/Skin" in shown.BlockSelectors
assert not any("Skeleton" in block for block in shown.BlockSelectors)

# A bed: kelp and eelgrass stand on the floor, and not where it is too deep.
floor = simple.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0], Spacing=[2.0, 2.0, 1.0])
simple.UpdatePipeline(proxy=floor)
ground = Fetch(floor)
heights = vtk_to_numpy(ground.GetPointData().GetArray("Elevation"))
sites = simple.QuadratPoints(Size=[70.0, 70.0], Quadrats=[8, 8], MeanPerQuadrat=2.0)
deepest = float(np.median(heights))
bed = simple.PlantScatter(
    Sites=sites, Prototypes=[simple.Seaweed(), simple.Seaweed(Preset="Eelgrass")], Terrain=floor, FollowCamera=0,
    UseLevels=0, UseCulling=0, HeightRange=[deepest, float(heights.max()) + 1.0])
simple.UpdatePipeline(proxy=bed)
data = Fetch(bed)
table = data.GetFieldData()
species = vtk_to_numpy(table.GetArray("Species"))
feet = vtk_to_numpy(table.GetArray("Position"))
assert set(species) == {0, 1} and 20 < len(species)
assert feet[:, 2].min() >= deepest, "plants stand too deep"
skeleton = plants.block(data, "High", "Skeleton")
points = vtk_to_numpy(skeleton.GetPoints().GetData())
roots = vtk_to_numpy(skeleton.GetPointData().GetArray("ParentId")) == -1
assert roots.sum() == len(species), "not one root a plant"
assert np.abs(points[roots] - feet).max() < 1e-3, "roots are not at the feet"
for name in SEGMENTS:
    assert skeleton.GetPointData().GetArray(name), name
across = vtk_to_numpy(skeleton.GetPointData().GetArray("Across"))
assert np.abs(np.linalg.norm(across, axis=1) - 1.0).max() < 1e-5

# The lower levels stand there as well.
levels = simple.PlantScatter(
    Sites=sites, Prototypes=[simple.Seaweed(Preset="Giant Kelp")], FollowCamera=0, UseCulling=0,
    ViewPoint=[35.0, -5.0, 10.0], ViewDirection=[0.0, 1.0, 0.0], NearDistance=20.0, FarDistance=45.0)
simple.UpdatePipeline(proxy=levels)
data = Fetch(levels)
shown = {name: data.GetFieldData().GetArray(name).GetTuple1(0) for name in ("PlantsHigh", "PlantsMedium", "PlantsLow")}
print(shown)
assert min(shown.values()) > 0, "a level is not used"
assert plants.block(data, "Low").GetNumberOfPolys() == 4 * shown["PlantsLow"]
assert plants.block(data, "Medium", "Crown").GetNumberOfPolys() > 100
