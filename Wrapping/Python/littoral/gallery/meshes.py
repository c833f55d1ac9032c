# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons and points of arrays, as `vtkPolyData`."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def _data_of(places):
    """Data with points at positions [n, 3], in single precision."""
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places, np.float32), deep=True))
    data.SetPoints(points)
    return data


def _cells_of(corners):
    """Cells with the points of each row [cell, corner]."""
    cells = vtkCellArray()
    cells.SetData(corners.shape[1], numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    return cells


def polygons(places, corners, colors=None):
    """Polygons between positions [n, 3], with the colors of these, as bytes or from 0 to 1, as the array `RGB`.

    corners: numbers of positions [polygon, corner].
    """
    data = _data_of(places)
    data.SetPolys(_cells_of(corners))
    if colors is None:
        return data
    if colors.dtype != np.uint8:
        colors = np.round(255.0 * np.clip(colors, 0.0, 1.0)).astype(np.uint8)
    data.GetPointData().SetScalars(add_array(data, "RGB", colors))
    return data


def vertices(places, **arrays):
    """Vertices at positions [n, 3], with point arrays."""
    data = _data_of(places)
    data.SetVerts(_cells_of(np.arange(len(places))[:, None]))
    for name, values in arrays.items():
        add_array(data, name, values)
    return data


def add_array(data, name, values):
    """Add a point array to data; returns it."""
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    return array
