# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""A forest that follows the camera, made by the proxies with their defaults."""

import quick
from paraview import simple
from window import apart, picture

view = simple.CreateView("RenderView")
view.ViewSize = [200, 150]
simple.SetActiveView(view)
sites = simple.QuadratPoints()
oak, pine = simple.ReevesTree(Preset="Oak"), simple.ReevesTree(Preset="Pine")
forest = simple.PlantScatter(Sites=sites, Prototypes=[oak, pine])
shown = simple.Show(forest, view)
assert shown.ColorArrayName[1] == "RGB" and shown.MapScalars == 0, "plants are not in their own colors"
for array in "PlantId", "RGB":  # by the map of an array that is chosen, and as they are again
    simple.ColorBy(shown, ("POINTS", array))
    assert shown.MapScalars == (array != "RGB"), f"{array}: {shown.MapScalars}"
assert "/Root/High/Skin" in shown.BlockSelectors and not any("Skeleton" in block for block in shown.BlockSelectors)


def counter(name):
    """A number of the forest's field data."""
    return forest.GetDataInformation().GetFieldDataInformation().GetArrayInformation(name).GetComponentRange(0)[0]


def look(eye, focus):
    """Draw from a point towards another."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = eye, focus, [0.0, 0.0, 1.0]
    simple.Render(view)


look([500.0, 500.0, 10.0], [500.0, 600.0, 10.0])
assert counter("PlantsInAll") == 400.0
ahead = counter("PlantsShown")
assert 20.0 < ahead < 300.0, ahead

# Leaves keep their shapes by the map of an array, near and far.
natural = picture(view)
simple.ColorBy(shown, ("POINTS", "PlantId"))
mapped = picture(view)
simple.ColorBy(shown, ("POINTS", "RGB"))
simple.Hide(forest, view)
empty = picture(view)
simple.Show(forest, view)
shares = apart(natural, empty), apart(mapped, empty)
assert shares[1] > 0.75 * shares[0] > 0.02, shares  # some colors of the map are those of the sky
look([500.0, -1000.0, 10.0], [500.0, 500.0, 10.0])
assert counter("PlantsShown") > ahead and counter("PlantsHigh") == 0.0, "the forest does not follow the camera"
look([500.0, -1000.0, 10.0], [500.0, -2000.0, 10.0])
assert counter("PlantsShown") == 0.0, "plants behind the eye"

terrain = simple.TurningBandsTerrain(WholeExtent=[0, 256, 0, 256, 0, 0], Spacing=[4.0, 4.0, 1.0])
forest.Terrain, forest.FollowCamera = terrain, 0
forest.UseCulling, forest.Weights = 0, [1.0, 0.0]
simple.UpdatePipeline(proxy=forest)
species = forest.GetDataInformation().GetFieldDataInformation().GetArrayInformation("Species")
assert counter("PlantsShown") == 400.0
assert species.GetComponentRange(0) == (0.0, 0.0), "a prototype of weight 0 is used"
heights = forest.GetDataInformation().GetFieldDataInformation().GetArrayInformation("Position").GetComponentRange(2)
assert heights[1] > heights[0], "plants are not on the terrain"

# A terrain that is taken away leaves nothing.
forest.Terrain = None
simple.UpdatePipeline(proxy=forest)
heights = forest.GetDataInformation().GetFieldDataInformation().GetArrayInformation("Position").GetComponentRange(2)
assert heights == (0.0, 0.0), f"the terrain stays connected: {heights}"
