# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of data."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray


def leaves(data):
    """The data sets and tables in what a filter gives."""
    if data is None or not data.IsA("vtkCompositeDataSet"):
        return [] if data is None else [data]
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found += leaves(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def rows(data):
    """Points with their arrays, or the rows of a table, as bytes: one line each."""
    is_table = data.IsA("vtkTable")
    attributes = data.GetRowData() if is_table else data.GetPointData()
    arrays = [attributes.GetAbstractArray(index)
              for index in sorted(range(attributes.GetNumberOfArrays()), key=attributes.GetArrayName)
              if isinstance(attributes.GetAbstractArray(index), vtkDataArray)]
    columns = [vtk_to_numpy(array) for array in arrays
               if array.GetNumberOfTuples() and not (array.GetName() or "").startswith("vtk")]
    if data.IsA("vtkPointSet") and data.GetNumberOfPoints():
        columns.insert(0, vtk_to_numpy(data.GetPoints().GetData()))
    elif data.IsA("vtkImageData") and data.GetNumberOfPoints():
        columns.insert(0, np.array([data.GetPoint(index) for index in range(data.GetNumberOfPoints())]))
    columns = [np.ascontiguousarray(column.reshape(len(column), -1)).view(np.uint8) for column in columns]
    return np.ascontiguousarray(np.concatenate(columns, axis=1)) if columns else np.empty((0, 0), np.uint8)


def rows_by_path(data, path=""):
    """The rows of each block by the names on the way to it; None of a block that is null."""
    if data is None or not data.IsA("vtkDataObjectTree"):
        return {path: None if data is None else rows(data)}
    found = {}
    if data.IsA("vtkMultiBlockDataSet"):
        for k in range(data.GetNumberOfBlocks()):
            name = data.GetMetaData(k).Get(data.NAME()) if data.HasMetaData(k) else k
            found.update(rows_by_path(data.GetBlock(k), f"{path}/{name}"))
    else:
        for k, block in enumerate(leaves(data)):
            found.update(rows_by_path(block, f"{path}/{k}"))
    return found
