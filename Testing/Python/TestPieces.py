# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3
"""What ranks have together is what one has alone: lengths, areas and volumes of all cells, integrals of all arrays and
numbers of rows of each class's outputs, in 1, 2 and 3 pieces; and ghosts of images and seas are what neighbours have."""

import os
import sys
import unittest
from pathlib import Path

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
for folder in "Hashes", "Fuzz":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / folder))
# pylint: disable=wrong-import-position
import introspection
import numpy
import recipes
from hash_outputs import leaves, make
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonCore import (
    vtkIdList, vtkInformation, vtkInformationVector, vtkLogger, vtkOutputWindow, vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

import littoral


def measures_of(leaf):
    """The length, area and volume of each cell, and its number of vertices."""
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(leaf)
    sizes.Update()
    cells = sizes.GetOutput().GetCellData()
    return {name: vtk_to_numpy(cells.GetArray(name)).astype(float) for name in ("VertexCount", "Length", "Area", "Volume")}


def means_of(leaf, array):
    """The mean of an array over the corners of each cell."""
    values = vtk_to_numpy(array).astype(float).reshape(leaf.GetNumberOfPoints(), -1)
    ids = vtkIdList()
    means = numpy.empty(leaf.GetNumberOfCells())
    for cell in range(len(means)):
        leaf.GetCellPoints(cell, ids)
        means[cell] = values[[ids.GetId(corner) for corner in range(ids.GetNumberOfIds())]].mean()
    return means


def integrals_of(data):
    """Sums over a data object, by the paths of its leaves."""
    sums = {}
    for path, leaf in leaves(data) if data else ():
        if isinstance(leaf, vtkImageData) and leaf.GetScalarType() == VTK_UNSIGNED_CHAR:
            continue  # a picture to draw other outputs with, which each rank has
        if isinstance(leaf, vtkTable):
            sums[path, "rows"] = leaf.GetNumberOfRows()
        elif isinstance(leaf, vtkDataSet) and leaf.GetNumberOfCells() > 0:
            measures = measures_of(leaf)
            sums.update({(path, name): own.sum() for name, own in measures.items()})
            weights = sum(measures.values())
            points = leaf.GetPointData()
            for index in range(points.GetNumberOfArrays()):
                array = points.GetArray(index)
                if array is not None and array.GetNumberOfTuples() == leaf.GetNumberOfPoints():
                    sums[path, array.GetName()] = numpy.nansum(weights * means_of(leaf, array))
    return sums


def ask(made, port, piece, pieces):
    """Asks for a piece of an output."""
    requests = vtkInformationVector()
    for index in range(made.GetNumberOfOutputPorts()):
        request = vtkInformation()
        request.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
        request.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
        request.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
        requests.SetInformationObject(index, request)
    made.Update(port, requests)


def integrals(made, pieces):
    """Those of all outputs in so many pieces."""
    sums = {}
    for piece in range(pieces):
        made.Modified()  # since VTK 9.3 another piece of a table is no other request
        for port in range(made.GetNumberOfOutputPorts()):
            ask(made, port, piece, pieces)
            for key, value in integrals_of(made.GetOutputDataObject(port)).items():
                sums[port, *key] = sums.get((port, *key), 0.0) + value
    return sums


def working(name):
    """A working object of a class of its own."""
    made = make(name, **recipes.settings(name))
    for port, other in enumerate(recipes.inputs(name)):
        made.SetInputConnection(port, recipes.source(other).GetOutputPort())
    return made


def box_of(image, extent):
    """The values of each array of points in an extent, but for marks of ghosts."""
    first = image.GetExtent()
    rows = tuple(slice(extent[2 * axis] - first[2 * axis], extent[2 * axis + 1] + 1 - first[2 * axis]) for axis in (2, 1, 0))
    points = image.GetPointData()
    return {points.GetArrayName(n): vtk_to_numpy(points.GetArray(n)).reshape(*image.GetDimensions()[::-1], -1)[rows]
            for n in range(points.GetNumberOfArrays()) if points.GetArrayName(n) != "vtkGhostType"}


class Pieces(unittest.TestCase):
    """All classes with outputs."""

    @classmethod
    def setUpClass(cls):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)

    def test_ghosts_of_images(self):
        """A piece with a level of ghosts has a row of its neighbours more, with the values of the whole; of all cells
        those that are no ghosts are there once."""
        images = 0
        for name in introspection.all_classes():
            if not getattr(littoral, name)().GetNumberOfOutputPorts():
                continue
            made = working(name)
            made.Update()
            whole = made.GetOutputDataObject(0)
            if not isinstance(whole, vtkImageData) or whole.GetNumberOfCells() < 9:
                continue
            images += 1
            alone = vtkImageData()
            alone.DeepCopy(whole)
            cells = 0
            for piece in range(3):
                with self.subTest(name, piece=piece):
                    made.UpdatePiece(piece, 3, 0)
                    own = whole.GetExtent()
                    made.UpdatePiece(piece, 3, 1)
                    part = made.GetOutputDataObject(0)
                    extent = part.GetExtent()
                    all_points = alone.GetExtent()
                    for axis in range(3):
                        low, high = 2 * axis, 2 * axis + 1
                        self.assertEqual(extent[low], max(all_points[low], own[low] - 1))
                        self.assertEqual(extent[high], min(all_points[high], own[high] + 1))
                    there = box_of(part, extent)
                    for array, values in box_of(alone, extent).items():
                        numpy.testing.assert_array_equal(there[array], values, err_msg=array)
                    cells += int((vtk_to_numpy(part.GetCellGhostArray()) == 0).sum())
            self.assertEqual(cells, alone.GetNumberOfCells(), name)
        self.assertGreater(images, 4)

    def test_ghosts_of_a_sea(self):
        """A level of ghosts is a sector on each side, whose triangles the neighbours have; of all points and triangles
        those that are no ghosts are there once."""

        def corners_of(part, is_ghost):
            places = vtk_to_numpy(part.GetPoints().GetData())
            ids = vtk_to_numpy(part.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            marks = part.GetCellGhostArray()
            marks = vtk_to_numpy(marks) if marks else numpy.zeros(len(ids))
            return {places[row].tobytes() for row in ids[(marks > 0) == is_ghost]}

        surface = make("vtkSeaSurfaceFilter", [recipes.source("vtkSeaStateSource")], SetSectors=(30,), SetRadius=(50.0,))
        surface.Update()
        whole = vtkPolyData()
        whole.DeepCopy(surface.GetOutput())
        every = corners_of(whole, False)
        for pieces, levels in (3, 1), (3, 2), (2, 200), (1, 1), (40, 1):
            points, own, ghosts = 0, [], 0
            for piece in range(pieces):
                surface.UpdatePiece(piece, pieces, levels)
                part = surface.GetOutput()
                if not part.GetNumberOfPoints():
                    continue
                own.append(corners_of(part, False))
                around = corners_of(part, True)
                ghosts += len(around)
                self.assertLessEqual(around, every - own[-1])
                marks = part.GetPointGhostArray()
                points += int((vtk_to_numpy(marks) == 0).sum()) if marks else part.GetNumberOfPoints()
            self.assertEqual(sum(map(len, own)), len(every))
            self.assertEqual(set().union(*own), every)
            self.assertEqual(points, whole.GetNumberOfPoints(), (pieces, levels))
            sectors = sum(min(2 * levels, 30 - len(one) * 30 // len(every)) for one in own)
            self.assertEqual(ghosts, sectors * len(every) // 30)

    def test_each(self):
        measured = 0
        for name in introspection.all_classes():
            if not getattr(littoral, name)().GetNumberOfOutputPorts():
                continue
            with self.subTest(name):
                made = working(name)
                whole = integrals(made, 1)
                measured += len(whole)
                for pieces in 2, 3:
                    parts = integrals(made, pieces)
                    self.assertEqual(parts.keys(), whole.keys())
                    for key, value in whole.items():
                        self.assertAlmostEqual(parts[key], value, delta=1e-5 * abs(value) + 1e-9, msg=f"{key} of {pieces}")
        self.assertGreater(measured, 200)


unittest.main(verbosity=2)
