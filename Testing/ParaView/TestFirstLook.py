# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a user sees first: natural colors and a view from the side, but only in an empty view."""

import quick
from paraview import simple

view = simple.CreateView("RenderView")
view.ViewSize = [300, 200]
simple.SetActiveView(view)

simple.Show(simple.Forest(), view)
for part in ("Trees", "Ground"):
    shown = simple.GetDisplayProperties(simple.FindSource(part), view)
    assert shown.ColorArrayName[1] == "RGB" and shown.MapScalars == 0, "no natural colors"
    if part == "Trees":
        assert "/Root/High/Skin" in shown.BlockSelectors
        assert not any("Skeleton" in block for block in shown.BlockSelectors)
simple.Render(view)
assert list(view.CameraViewUp) == [0.0, 0.0, 1.0], view.CameraViewUp
assert view.CameraPosition[2] > view.CameraFocalPoint[2] + 10.0, "the eye is not above the forest"
assert view.CameraPosition[1] < view.CameraFocalPoint[1] - 10.0, "north is not ahead"

# A camera that someone has set is left alone, also with another source and in a second reset.
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (0, 0, 900), (200, 200, 0), (0, 1, 0)
simple.Show(simple.ReevesTree(), view)
simple.Render(view)
assert list(view.CameraPosition) == [0.0, 0.0, 900.0]
simple.ResetCamera(view)
assert list(view.CameraViewUp) == [0.0, 1.0, 0.0]

# Each kind of plant, with its defaults.
for kind in (simple.AonoKuniiTree, simple.GardnerPlant, simple.ReevesTree):
    plant = kind()
    shown = simple.Show(plant, view)
    assert shown.MapScalars == 0 and list(shown.BlockSelectors) == ["/Root/High/Skin", "/Root/High/Leaves"]
    low = simple.ExtractBlock(Input=plant, Selectors=["/Root/Low"])
    low.UpdatePipeline()
    assert low.GetDataInformation().GetNumberOfCells() == 4
    simple.Hide(plant, view)
ternary = simple.AonoKuniiTree(Preset="Custom", Branching="Ternary", Iterations=2, Variation=0.0, NumberOfLeaves=0)
wood = simple.ExtractBlock(Input=ternary, Selectors=["/Root/High/Skeleton"])
wood.UpdatePipeline()
branches = (3 ** 3 - 1) // 2
assert wood.GetDataInformation().GetNumberOfCells() == branches, wood.GetDataInformation().GetNumberOfCells()

# Terrain has the colors of the ground unless it has its own or none are wanted.
terrain = simple.TerrainLevelOfDetail(
    Input=simple.TurningBandsTerrain(WholeExtent=[0, 64, 0, 64, 0, 0]), UseCulling=0)
simple.UpdatePipeline(proxy=terrain)
assert terrain.PointData.GetArray("RGB").GetRange(1)[1] > 0
terrain.GroundColors = 0
simple.UpdatePipeline(proxy=terrain)
assert terrain.PointData.GetArray("RGB") is None
