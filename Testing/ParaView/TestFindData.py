# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Find Data on a scattered forest: a query by PlantId selects all of a plant and nothing else, which can be extracted.

The selection is shown over textured blocks.
"""

import numpy as np
import quick
from paraview import simple
from paraview.servermanager import Fetch
from paraview.vtk.util.numpy_support import vtk_to_numpy
from window import colors

PLANT = 5


def points_by_plant(data):
    """Number of points of each plant in all blocks."""
    counts = {}
    leaves = data.NewIterator()
    leaves.UnRegister(None)
    leaves.InitTraversal()
    while not leaves.IsDoneWithTraversal():
        ids = leaves.GetCurrentDataObject().GetPointData().GetArray("PlantId")
        if ids:
            for plant, count in zip(*np.unique(vtk_to_numpy(ids), return_counts=True)):
                counts[int(plant)] = counts.get(int(plant), 0) + int(count)
        leaves.GoToNextItem()
    return counts


def picture(view):
    simple.Render(view)
    return colors(view)


view = simple.CreateView("RenderView")
view.ViewSize = [240, 160]
sites = simple.QuadratPoints(Size=[60.0, 60.0], Quadrats=[5, 5])
tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=200, MainBranches=8, Orders=1)
forest = simple.PlantScatter(Sites=sites, Prototypes=[tree], UseLevels=0, UseCulling=0, FollowCamera=0)
simple.Show(forest, view)
simple.Render(view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [30.0, -60.0, 30.0], [30.0, 30.0, 4.0], [0.0, 0.0, 1.0]
counts = points_by_plant(Fetch(forest))
assert len(counts) > 10 and counts[PLANT] > 200, counts
before = picture(view)
simple.SetActiveSource(forest)
simple.QuerySelect(QueryString=f"PlantId == {PLANT}", FieldType="POINT", Source=forest)
found = simple.ExtractSelection(Input=forest, Selection=forest.GetSelectionInput(0))
found.UpdatePipeline()
selected = points_by_plant(Fetch(found))
assert selected == {PLANT: counts[PLANT]}, f"{selected}, not {counts[PLANT]} points of {PLANT}"
marked = np.abs(picture(view) - before).sum(axis=1) > 30
assert 0.0005 < marked.mean() < 0.3, f"{marked.mean():.4f} of the picture shows the selection"
