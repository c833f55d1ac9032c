# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Beam Tree Deformation from ParaView: its inputs, properties and times."""
import quick
from gusts import INFORMATION, WIND
from paraview import simple
from paraview.servermanager import Fetch


def skeleton(plant):
    """The points of High/Skeleton."""
    points = Fetch(plant).GetBlock(0).GetBlock(0).GetPoints()
    return [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]


tree = simple.ReevesTree()
wind = simple.ProgrammableSource(OutputDataSetType="vtkImageData", Script=WIND,
                                 ScriptRequestInformation=INFORMATION)
sway = simple.BeamTreeDeformation(Input=tree, Wind=wind, NumberOfModes=2, DampingRatio=0.05)
sway.UpdatePipeline(3.0)
first = skeleton(sway)
sway.UpdatePipeline(8.0)
second = skeleton(sway)
sway.UpdatePipeline(3.0)
assert skeleton(sway) == first
assert len(first) == len(skeleton(tree)) > 100
assert first != second and first != skeleton(tree)
print("moves", sorted(abs(a[0] - b[0]) for a, b in zip(first, second))[-1], "m between two times")

# A partitioned data set collection is taken as well; ParaView's conversion loses what wood a plant is of.
parts = simple.ConvertToPartitionedDataSetCollection(Input=tree)
swaying = [simple.BeamTreeDeformation(Input=one, Wind=wind, WoodFromPlants=0) for one in (tree, parts)]
for one in swaying:
    one.UpdatePipeline(3.0)
assert skeleton(swaying[0]) == skeleton(swaying[1]) != skeleton(tree)

# The wind blows along x: lift takes the trunk to the right, by as much as drag along where both coefficients are alike.
rest = skeleton(tree)
assert sway.LiftCoefficient == 0.0
sway.LiftCoefficient = 1.1
sway.UpdatePipeline(3.0)
lifted = skeleton(sway)
along, right = lifted[12][0] - rest[12][0], rest[12][1] - lifted[12][1]
assert along > 0.0 and abs(right / along - 1.0) < 0.1, (along, right)
print("lift: a joint of the trunk goes", along, "m along the wind,", right, "m to the right")

# Of scattered plants all levels are shown at once, of one plant the level that moves.
view = simple.CreateView("RenderView")
moving = ["/Root/High/Skin", "/Root/High/Leaves"]
assert list(simple.Show(sway, view).BlockSelectors) == moving
sites = simple.PointSource(NumberOfPoints=5, Radius=30.0)
wood = simple.PlantScatter(Sites=sites, Prototypes=[tree], FollowCamera=0, UseLevels=0, UseCulling=0)
shown = simple.Show(simple.BeamTreeDeformation(Input=wood, Wind=wind, Prototypes=[tree]), view)
assert list(shown.BlockSelectors) == moving + ["/Root/Medium", "/Root/Low"], list(shown.BlockSelectors)
