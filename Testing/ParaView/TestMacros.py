# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Macros: a forest of a CSV file has its trees, species and heights; a twin has the grid and the variance of its place."""
import contextlib
import io
import os
import runpy
import tempfile

import numpy as np
import quick
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

MACROS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "paraview-plugin", "Macros")


def run(name):
    runpy.run_path(os.path.join(MACROS, name))


with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "trees.csv")
    with open(file, "w", encoding="utf-8") as out:
        out.write("x,y,species,height\n0,0,pine,10\n20,0,oak,12\n0,30,Birch,8\n20,30,elm,6\n")
    table = simple.CSVReader(FileName=[file])
    table.UpdatePipeline()
    simple.SetActiveSource(table)
    run("forest_from_table.py")
forest = simple.GetActiveSource()
forest.UseLevels = 0
forest.UseCulling = 0
forest.UpdatePipeline()
sites = servermanager.Fetch(simple.FindSource("Sites"))
assert sites.GetNumberOfPoints() == 4 and sites.GetPoint(2)[:2] == (0.0, 30.0)
assert vtk_to_numpy(sites.GetPointData().GetArray("Species")).tolist() == [0, 1, 2, 1]
bones = servermanager.Fetch(forest).GetBlock(0).GetBlock(0)
points = vtk_to_numpy(bones.GetPoints().GetData())
for (x, y), height in {(0, 0): 10.0, (20, 0): 12.0, (0, 30): 8.0, (20, 30): 6.0}.items():
    near = np.hypot(points[:, 0] - x, points[:, 1] - y) < 8.0
    top = points[near, 2].max()
    assert 0.75 * height < top < 1.01 * height, f"a tree of {height} m reaches {top} m"
print("a forest of four trees has their heights")

simple.ResetSession()
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "plot.csv")
    with open(file, "w", encoding="utf-8") as out:
        out.write("gx,gy,sp,dbh,status\n0,0,Pinus taeda,250,A\n20,0,oak,420,A\n0,30,oak,NA,A\n20,30,elm,60,D\n")
    table = simple.CSVReader(FileName=[file])
    table.UpdatePipeline()
    simple.SetActiveSource(table)
    run("forest_from_inventory.py")
    stand = servermanager.Fetch(simple.FindSource("Stand"))
forest = simple.GetActiveSource()
forest.UseLevels = 0
forest.UseCulling = 0
forest.UpdatePipeline()
data = servermanager.Fetch(forest)
assert data.GetFieldData().GetArray("PlantsShown").GetValue(0) == 3
tops = np.zeros(3)
for part in (1, 2):
    leaf = data.GetBlock(0).GetBlock(part)
    np.maximum.at(tops, vtk_to_numpy(leaf.GetPointData().GetArray("PlantId")),
                  vtk_to_numpy(leaf.GetPoints().GetData())[:, 2])
assert np.allclose(tops, vtk_to_numpy(stand.GetPointData().GetArray("Height")), rtol=1e-4), tops
print("an inventory has the heights of its trees")

simple.ResetSession()
place = simple.TurningBandsTerrain(WholeExtent=[0, 150, 0, 120, 0, 0], Spacing=[10.0, 10.0, 1.0], Seed=5)
place.UpdatePipeline()
simple.SetActiveSource(place)
run("twin_from_raster.py")
twin = simple.GetActiveSource()
twin.UpdatePipeline()
assert tuple(twin.GetDataInformation().GetBounds()[:4]) == (0.0, 1500.0, 0.0, 1200.0)
heights = [vtk_to_numpy(servermanager.Fetch(one).GetPointData().GetScalars()) for one in (place, twin)]
assert (heights[0] != heights[1]).any()
ratio = heights[1].std() / heights[0].std()
assert 0.4 < ratio < 2.5, ratio
print("a twin has", ratio, "times the standard deviation of its place")

# Something else selected, or nothing: one sentence, and nothing is made.
for selected in (simple.Sphere(), None):
    simple.SetActiveSource(selected)
    before = len(simple.GetSources())
    for name in ("twin_from_raster.py", "forest_from_table.py", "forest_from_inventory.py"):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            run(name)
        assert said.getvalue().startswith("Select ") and said.getvalue().count("\n") == 1, said.getvalue()
    assert len(simple.GetSources()) == before
