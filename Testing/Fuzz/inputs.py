# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that somebody could connect: the data of another class, spoiled in one way or more. All return the data."""

from vtkmodules import vtkCommonDataModel
from vtkmodules.vtkCommonCore import vtkDataArray, vtkFloatArray, vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection, vtkPointSet, vtkPolyData, vtkTable)

TYPES = ["vtkPolyData", "vtkImageData", "vtkTable", "vtkMultiBlockDataSet", "vtkPartitionedDataSet",
         "vtkPartitionedDataSetCollection", "vtkUnstructuredGrid", "vtkStructuredGrid", "vtkRectilinearGrid",
         "vtkUniformGrid", "vtkHyperTreeGrid", "vtkMutableDirectedGraph"]
ODD_NUMBERS = [float("nan"), float("inf"), -1.0, 0.0, 1e300, 5e-324, 2147483647.0]


def empty(kind):
    """A data object of a type with nothing in it."""
    return getattr(vtkCommonDataModel, kind)()


def leaves(data):
    """The data without blocks below a data object, in order."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data] if data else []
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def attributes(leaf):
    """Where a leaf keeps its arrays."""
    found = [leaf.GetFieldData()]
    if isinstance(leaf, vtkDataSet):
        found += [leaf.GetPointData(), leaf.GetCellData()]
    elif isinstance(leaf, vtkTable):
        found.append(leaf.GetRowData())
    return found


def holders(data, name):
    """Places of all arrays of a name: (attributes, array)."""
    return [(place, place.GetAbstractArray(name)) for leaf in leaves(data) for place in attributes(leaf)
            if place.GetAbstractArray(name)]


def names(data):
    """Names of all arrays, each once."""
    return sorted({place.GetArrayName(index) for leaf in leaves(data) for place in attributes(leaf)
                   for index in range(place.GetNumberOfArrays()) if place.GetArrayName(index)})


def drop(data, name):
    """Takes arrays of that name away."""
    for place, _ in holders(data, name):
        place.RemoveArray(name)
    return data


def shorten(data, name, tuples):
    """Leaves arrays of that name with so many tuples."""
    for _, array in holders(data, name):
        array.Resize(tuples)
        array.SetNumberOfTuples(min(tuples, array.GetNumberOfTuples()))
    return data


def reshape(data, name, components):
    """Gives arrays of that name other components."""
    for place, array in holders(data, name):
        if isinstance(array, vtkDataArray):
            other = array.NewInstance()
            other.SetName(name)
            other.SetNumberOfComponents(components)
            other.SetNumberOfTuples(array.GetNumberOfTuples())
            other.Fill(1.0)
            place.RemoveArray(name)
            place.AddArray(other)
    return data


def retype(data, name, kind):
    """Makes arrays of that name such of another type: int, float or string, with as many values."""
    for place, array in holders(data, name):
        other = {"int": vtkIntArray, "float": vtkFloatArray, "string": vtkStringArray}[kind]()
        other.SetName(name)
        other.SetNumberOfComponents(array.GetNumberOfComponents())
        other.SetNumberOfTuples(array.GetNumberOfTuples())
        for index in range(array.GetNumberOfValues()):
            other.SetVariantValue(index, array.GetVariantValue(index))
        place.RemoveArray(name)
        place.AddArray(other)
    return data


def spoil(data, name, number, index=0):
    """Writes a number into arrays of that name, at an index that wraps; below 0 it fills all."""
    for _, array in holders(data, name):
        if isinstance(array, vtkDataArray) and array.GetNumberOfValues() > 0:
            if index < 0:
                array.Fill(number)
            else:
                tuple_, part = divmod(index % array.GetNumberOfValues(), array.GetNumberOfComponents())
                array.SetComponent(tuple_, part, number)
        if hasattr(array, "Modified"):
            array.Modified()
    return data


def move(data, number, index=0):
    """Writes a number into the coordinates of a point, or of an image's origin."""
    for leaf in leaves(data):
        if isinstance(leaf, vtkImageData):
            leaf.SetOrigin(number, 0.0, 0.0)
        elif isinstance(leaf, vtkPointSet) and leaf.GetNumberOfPoints() > 0:
            leaf.GetPoints().SetPoint(index % leaf.GetNumberOfPoints(), number, 0.0, 1.0)
    return data


def stretch(data, number):
    """Gives images that spacing in x."""
    for leaf in leaves(data):
        if isinstance(leaf, vtkImageData):
            leaf.SetSpacing(number, 1.0, 1.0)
    return data


def unpoint(data):
    """Takes points away that cells and arrays go on naming."""
    for leaf in leaves(data):
        if isinstance(leaf, vtkPointSet):
            leaf.SetPoints(vtkPoints())
    return data


def miswire(data, point):
    """Adds a line between the first point and one that may be missing."""
    for leaf in leaves(data):
        if isinstance(leaf, vtkPolyData):
            lines = vtkCellArray()
            lines.DeepCopy(leaf.GetLines())
            lines.InsertNextCell(2)
            lines.InsertCellPoint(0)
            lines.InsertCellPoint(point)
            leaf.SetLines(lines)
    return data


def replace(data, index, other):
    """Puts another object, or None, in the place of a leaf of blocks."""
    if isinstance(data, vtkMultiBlockDataSet) and data.GetNumberOfBlocks() > 0:
        index %= data.GetNumberOfBlocks()
        block = data.GetBlock(index)
        if isinstance(block, vtkMultiBlockDataSet) and block.GetNumberOfBlocks() > 0:
            replace(block, index + 1, other)
        else:
            data.SetBlock(index, other)
    return data


def nest(data, kind):
    """The data as the second block or partition of a data object of that type, behind an absent one."""
    outer = empty(kind)
    if isinstance(outer, vtkMultiBlockDataSet):
        outer.SetBlock(1, data)
    elif isinstance(outer, vtkPartitionedDataSet):
        outer.SetPartition(1, data if isinstance(data, vtkDataSet) else None)
    elif isinstance(outer, vtkPartitionedDataSetCollection):
        outer.SetPartition(1, 0, data if isinstance(data, vtkDataSet) else None)
    return outer


def random_spoiling(rng, text, sample):
    """The text of a call that spoils the data which `text` stands for; `sample` is such data."""
    name = rng.choice(names(sample) or ["none"])
    index = rng.choice([0, rng.randrange(1000)])
    number = repr(rng.choice(ODD_NUMBERS))
    return rng.choice([
        f"drop({text}, {name!r})", f"shorten({text}, {name!r}, {rng.choice([0, 1, 3])})",
        f"reshape({text}, {name!r}, {rng.choice([1, 2, 3, 4, 9])})",
        f"retype({text}, {name!r}, {rng.choice(['int', 'float', 'string'])!r})",
        f"spoil({text}, {name!r}, {number}, {rng.choice([-1, index])})", f"spoil({text}, {name!r}, {number}, {index})",
        f"move({text}, {number}, {index})", f"stretch({text}, {number})", f"unpoint({text})",
        f"miswire({text}, {rng.choice([-1, 100000, 2**40])})",
        f"replace({text}, {rng.randrange(4)}, {rng.choice(['None', f'empty({rng.choice(TYPES)!r})'])})",
        f"nest({text}, {rng.choice(TYPES[3:6])!r})"])
