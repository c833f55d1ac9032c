# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of fitted models and variograms, as `vtkTable`."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOCore import vtkDelimitedTextWriter

from . import files


def column(table, name):
    """A column of numbers as an array."""
    return vtk_to_numpy(table.GetColumnByName(name))


def table_of(columns):
    """A table of a dictionary {name: numbers}."""
    table = vtkTable()
    for name, values in columns.items():
        array = numpy_to_vtk(np.array(values, np.float64), deep=True)
        array.SetName(name)
        table.AddColumn(array)
    return table


def model_names(fits):
    """Names of the fitted models, in the order of the rows."""
    names = fits.GetColumnByName("Model")
    return [names.GetValue(row) for row in range(fits.GetNumberOfRows())]


def one_model(fits, model):
    """A table with only the row of one model, as input of a source."""
    row = model_names(fits).index(model)
    table = vtkTable()
    for k in range(fits.GetNumberOfColumns()):
        whole = fits.GetColumn(k)
        part = whole.NewInstance()
        part.SetName(whole.GetName())
        part.SetNumberOfComponents(whole.GetNumberOfComponents())
        part.InsertNextTuple(row, whole)
        table.AddColumn(part)
    table.GetFieldData().ShallowCopy(fits.GetFieldData())
    return table


def write_csv(table, filename):
    """Write a table as comma-separated values. Raises OSError, with an old file as it was."""
    writer = vtkDelimitedTextWriter()
    writer.SetInputData(table)
    files.write(writer, filename)
