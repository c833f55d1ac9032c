# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters that draw what data describe: the surface of a sea, arrows of flows, sections of an image."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import littoral


def errors_of(algorithm):
    """The errors of an update."""
    found = []

    def note(_, __, text):
        found.append(text)

    note.CallDataType = "string0"
    tags = [(algorithm, algorithm.AddObserver(vtkCommand.ErrorEvent, note)),
            (algorithm.GetExecutive(), algorithm.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None))]
    algorithm.Modified()
    algorithm.Update()
    for object_, tag in tags:
        object_.RemoveObserver(tag)
    return found


def column(table, name):
    """A column of a table or a point array."""
    return vtk_to_numpy(table.GetColumnByName(name)).astype(float)


# Sea: near the center, the sum of all trains; eq. 2 of the paper with their phases.
sea = littoral.vtkSeaStateSource()
sea.SetWaterDepth(12.0)
sea.SetSeaLevel(2.0)
sea.Update()
surface = littoral.vtkSeaSurfaceFilter()
surface.SetInputConnection(sea.GetOutputPort())
surface.SetCenter(500.0, -300.0)
surface.SetRadius(2000.0)
surface.UpdateTimeStep(4.5)
out = surface.GetOutput()
points = vtk_to_numpy(out.GetPoints().GetData())
trains = sea.GetOutput()
k, w, a = (column(trains, name) for name in ("WaveNumber", "AngularFrequency", "Amplitude"))
angle, phase = column(trains, "Direction"), column(trains, "Phase")
phi = k * (500.0 * np.cos(angle) - 300.0 * np.sin(angle)) - w * 4.5 + phase
across = a / np.tanh(k * 12.0)
center = np.array([500.0 + (across * np.sin(phi) * np.cos(angle)).sum(),
                   -300.0 + (across * np.sin(phi) * np.sin(angle)).sum(), 2.0 - (a * np.cos(phi)).sum()])
assert np.allclose(points[0], center, atol=1e-4), (points[0], center)
# The variance of the elevation near the center is that of the trains; far away it is flat.
reach = np.hypot(points[:, 0] - 500.0, points[:, 1] + 300.0)
near = points[(reach > 20.0) & (reach < 250.0), 2]
assert abs(near.mean() - 2.0) < 0.15 and 0.7 < near.std() / np.sqrt(0.5 * (a * a).sum()) < 1.3, near.std()
assert abs(reach.max() - 2000.0) < 3.0
normals = vtk_to_numpy(out.GetPointData().GetNormals())
assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5) and out.GetPointData().GetArray("Jacobian")
colors = vtk_to_numpy(out.GetPointData().GetArray("RGB")).astype(float)
assert colors[reach > 1900.0].mean(axis=0).sum() > 1.3 * colors[reach < 30.0].mean(axis=0).sum(), "no haze far away"
# Foam is where the Jacobian is below the threshold, white from 0.32 below it on, and nothing else changes.
assert surface.GetFoamThreshold() == 0.42
jacobian = vtk_to_numpy(out.GetPointData().GetArray("Jacobian")).copy()
surface.SetFoamThreshold(0.95)
surface.UpdateTimeStep(4.5)
foamy = vtk_to_numpy(surface.GetOutput().GetPointData().GetArray("RGB")).astype(float)
assert (jacobian < 0.9).sum() > 20 and np.all(foamy[jacobian > 0.951] == colors[jacobian > 0.951])
assert np.all(foamy[jacobian < 0.9].sum(axis=1) > colors[jacobian < 0.9].sum(axis=1))
surface.WaterColorsOff()
surface.UpdateTimeStep(4.5)
assert surface.GetOutput().GetPointData().GetArray("RGB") is None
time_range = surface.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_RANGE())
assert tuple(time_range) == (0.0, 60.0)
surface.SetSpacing(0.0)
assert [("Spacing is 0 m" in text) for text in errors_of(surface)] == [True]
surface.SetSpacing(0.6)
surface.SetChoppiness(1.5)
assert [("Choppiness is 1.5" in text) for text in errors_of(surface)] == [True]

# Pieces are sectors; those beyond them are empty.
surface.SetChoppiness(1.0)
surface.UpdatePiece(0, 1, 0)
whole = surface.GetOutput().GetNumberOfPolys()
halves = []
for piece in range(2):
    surface.UpdatePiece(piece, 2, 0)
    halves.append(surface.GetOutput().GetNumberOfPolys())
assert halves == [whole / 2, whole / 2]
surface.UpdatePiece(3, 2, 0)
assert surface.GetOutput().GetNumberOfPoints() == 0

# Flows: no arrow is where none flows, and another input is refused in one sentence.
flow = littoral.vtkFlowPrimitiveSource()
arrows = littoral.vtkFlowArrowFilter()
arrows.SetInputConnection(flow.GetOutputPort())
arrows.Update()
speed = vtk_to_numpy(arrows.GetOutput().GetPointData().GetArray("Speed"))
assert np.allclose(speed, 0.2)
points = vtk_to_numpy(arrows.GetOutput().GetPoints().GetData())
assert 1.55 < np.hypot(points[:, 1], points[:, 2]).max() < 1.8
other = vtkPolyData()
other.SetPoints(arrows.GetOutput().GetPoints())
arrows.SetInputData(other)
assert ["no flow primitives" in text for text in errors_of(arrows)] == [True]
arrows.SetInputData(vtkPolyData())
assert errors_of(arrows) == [] and arrows.GetOutput().GetNumberOfPoints() == 0

# Sections of an image whose values are its coordinates.
image = vtkImageData()
image.SetExtent(2, 14, -3, 5, 1, 7)
image.SetSpacing(2.0, 1.0, 0.5)
image.SetOrigin(10.0, 20.0, 30.0)
image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
places = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
array = numpy_to_vtk(places, deep=True)
array.SetName("Place")
image.GetPointData().AddArray(array)
sections = littoral.vtkImageSectionFilter()
sections.SetInputData(image)
sections.Update()
cut = sections.GetOutput()
points = vtk_to_numpy(cut.GetPoints().GetData())
assert np.array_equal(points, vtk_to_numpy(cut.GetPointData().GetArray("Place")))
assert len(points) == 13 * 9 + 13 * 7 + 3 * 9 * 7
assert cut.GetNumberOfCells() == 12 * 8 + 12 * 6 + 3 * 8 * 6
sections.SetCrossSections(0)
sections.Update()
assert sections.GetOutput().GetNumberOfPoints() == 13 * 9 + 13 * 7
sections.SetCrossSections(-1)
assert ["CrossSections is -1" in text for text in errors_of(sections)] == [True]
