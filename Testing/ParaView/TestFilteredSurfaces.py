# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Ways of drawing that show what data describe: the surfaces that are drawn, against the data."""

import numpy as np
import quick
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

view = simple.CreateView("RenderView")
view.ViewSize = [120, 80]
simple.SetActiveView(view)


def drawn(shown):
    """Points and point data of what a representation draws, block by block."""
    simple.Render(view)
    side = shown.GetClientSideObject()
    if hasattr(side, "GetActiveRepresentation"):
        side = side.GetActiveRepresentation()
    blocks = side.GetRenderedDataObject(0)
    iterator = blocks.NewIterator()
    iterator.InitTraversal()
    found = []
    while not iterator.IsDoneWithTraversal():
        data = iterator.GetCurrentDataObject()
        if data.GetNumberOfPoints():
            found.append((vtk_to_numpy(data.GetPoints().GetData()).astype(float), data.GetPointData(), data))
        iterator.GoToNextItem()
    assert isinstance(blocks, vtkCompositeDataSet) and found, "nothing is drawn"
    return found


# Terrain: z is the elevation, at every sample.
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 40, 0, 0])
points, arrays, _ = drawn(simple.Show(terrain, view))[0]
image = simple.servermanager.Fetch(terrain)
elevation = vtk_to_numpy(image.GetPointData().GetArray("Elevation")).reshape(41, 61)
column, row = np.rint(points[:, 0] / 2.0).astype(int), np.rint(points[:, 1] / 2.0).astype(int)
assert len({*zip(column, row)}) == elevation.size, "samples are left out"
assert np.allclose(points[:, 2], elevation[row, column], atol=1e-4)
assert arrays.GetArray("RGB") and arrays.GetNormals()
simple.HideAll(view)

# Sea: a regular wave on deep water, z = -a cos(k d . x0 - w t) at the time of the view, x = x0 + a sin(...).
sea = simple.SeaState(Spectrum="Regular", SeaBy="Height And Period", SignificantWaveHeight=1.5, PeakPeriod=6.0,
                      MeanDirection=30.0)
shown = simple.Show(sea, view)
for time in (0.0, 7.25):
    view.ViewTime = time
    points, _, _ = drawn(shown)[0]
    w = 2.0 * np.pi / 6.0
    k = w * w / 9.80665
    along = points[:, 0] * np.cos(np.pi / 6) + points[:, 1] * np.sin(np.pi / 6)
    near = np.hypot(points[:, 0], points[:, 1]) < 300.0
    rest = along.copy()
    for _ in range(60):  # where a point was at rest
        rest = along - 0.75 * np.sin(k * rest - w * time + np.pi)
    height = -0.75 * np.cos(k * rest - w * time + np.pi)
    assert np.abs(points[near, 2] - height[near]).max() < 2e-3, np.abs(points[near, 2] - height[near]).max()
    assert np.abs(points[near, 2]).max() > 0.74
simple.HideAll(view)

# Flows: drawn out to their radius of influence, about their center.
flow = simple.FlowPrimitive(FlowType="Vortex", Axis=[0.0, 0.0, 1.0], Center=[3.0, -2.0, 5.0], InfluenceRadius=8.0)
points, arrays, _ = drawn(simple.Show(flow, view))[0]
reach = np.linalg.norm(points - [3.0, -2.0, 5.0], axis=1)
assert 8.0 < reach.max() < 8.2, reach.max()
speed = vtk_to_numpy(arrays.GetArray("Speed"))
assert speed.max() > 0.0 and (speed == 0.0).any()
simple.HideAll(view)

# Wind: sections hold samples of the image, the lowest layer whole.
wind = simple.WindField(Dimensions=[20, 8, 6])
points, arrays, _ = drawn(simple.Show(wind, view))[0]
field = simple.servermanager.Fetch(wind)
velocity = vtk_to_numpy(field.GetPointData().GetArray("Velocity"))
mine = vtk_to_numpy(arrays.GetArray("Velocity"))
for point, value in zip(points[::7], mine[::7]):
    assert np.allclose(velocity[field.FindPoint(point)], value)
lowest = np.isclose(points[:, 2], points[:, 2].min())
assert len({tuple(p) for p in points[lowest].round(6)}) == 20 * 8
