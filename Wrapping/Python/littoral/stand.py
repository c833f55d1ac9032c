# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stands of trees from forest inventories.

    from littoral import stand
    trees = stand.read_inventory("plot.csv")
    forest = stand.plant(trees)
    forest.Update()

Lengths are in metres, x is east, y north, z up.
"""

import csv
import os

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

from . import errors
from .LittoralFilters import vtkPlantScatterFilter, vtkStandInventoryFilter
from .LittoralSources import vtkReevesTreeSource, vtkTextTableReader
from .properties import set_properties

#: Littoral's table of species, to be copied and edited: species, kind, curve, a, b, c.
SPECIES = os.path.join(os.path.dirname(__file__), "StandSpecies.csv")
#: Units of lengths.
UNITS = {"m": 1, "cm": 2, "mm": 3, "ft": 4, "in": 5}
#: Kinds of plants that Littoral's table names, as presets of vtkReevesTreeSource.
PRESETS = {"Pine": 1, "Oak": 2, "Birch": 3, "Shrub": 4}


def read_table(path):
    """The vtkTable of a file of separated values, as vtkTextTableReader reads it. Raises OSError and ValueError."""
    with open(path, "rb"):
        pass
    reader = vtkTextTableReader()
    reader.SetFileName(os.fspath(path))
    messages = errors.kept(reader)
    reader.Update()
    if messages:
        raise ValueError(messages[0])
    table = vtkTable()
    table.ShallowCopy(reader.GetOutput())
    return table


def table_of_words(names, columns):
    """Columns of words or numbers as a vtkTable of words."""
    table = vtkTable()
    for name, words in zip(names, columns):
        column = vtkStringArray()
        column.SetName(name.strip())
        for word in words:
            column.InsertNextValue(str(word))
        table.AddColumn(column)
    return table


def species_table(species):
    """A table of species of a path of a CSV file, of a dictionary {species: kind}, or as it is (vtkTable).

    The species of a dictionary are put before those of Littoral's table, with the curve that the species has there.
    """
    if isinstance(species, vtkTable):
        return species
    if not isinstance(species, dict):
        return read_table(species)
    with open(SPECIES, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))

    def curve(name):
        words = (name.lower(), name.lower().split(" ")[0])
        listed = ({n.lower(): row[2:] for row in reversed(rows[1:]) for n in row[0].split(";")}.get(w) for w in words)
        return next((c for c in listed if c), ["", "", "", ""])

    rows[1:1] = [[name, kind, *curve(name)] for name, kind in species.items()]
    return table_of_words(rows[0], zip(*rows[1:]))


def read_inventory(path, species=None, columns=None, units=None, **settings):
    """The trees of a forest inventory as points with the arrays `DBH`, `Height`, `CrownDiameter` [m] and `Species`.

    path: a CSV file with a row a tree, or a vtkTable. Columns x and y, and any of species, dbh, height, plot, status
    and treeid; ForestGEO's names gx, gy, sp and dbh [mm] are known. Other arrays and field data of the result are those
    of vtkStandInventoryFilter.
    species: table of species with the columns species, kind, curve, a, b, c: path of a CSV file, dictionary
    {species: kind} or vtkTable; default SPECIES.
    columns: names of columns by what they hold, as {"dbh": "marks"}; keys x, y, species, dbh, height, plot.
    units: units of numbers, as {"dbh": "in", "place": "ft"}; keys place, dbh, height, values m, cm, mm, ft, in. By
    default as the name of the column says (`dbh_mm`), else metres, and centimetres for dbh.
    settings: properties of vtkStandInventoryFilter, as Seed=2, Plot="A", KeepDead=True, CoordinateScale=924.

    Raises OSError, and ValueError with one sentence for what cannot be read.
    """
    stand = vtkStandInventoryFilter()
    name = "the table" if isinstance(path, vtkTable) else os.fspath(path)
    stand.SetInputData(0, path if isinstance(path, vtkTable) else read_table(path))
    if species is not None:
        stand.SetInputData(1, species_table(species))
    setters = {"x": stand.SetXColumn, "y": stand.SetYColumn, "species": stand.SetSpeciesColumn,
               "dbh": stand.SetDiameterColumn, "height": stand.SetHeightColumn, "plot": stand.SetPlotColumn}
    for key, column in (columns or {}).items():
        _of(setters, key, "columns")(column)
    setters = {"place": stand.SetCoordinateUnit, "dbh": stand.SetDiameterUnit, "height": stand.SetHeightUnit}
    for key, unit in (units or {}).items():
        _of(setters, key, "units")(_of(UNITS, unit, "units"))
    set_properties(stand, settings)
    messages = errors.kept(stand)
    stand.Update()
    if messages:
        raise ValueError(f"{name}: {messages[0]}")
    trees = vtkPolyData()
    trees.ShallowCopy(stand.GetOutput())
    return trees


def _of(choices, key, what):
    if key not in choices:
        raise ValueError(f"{what} has '{key}'; it may have {', '.join(choices)}")
    return choices[key]


def numbers(trees, name):
    """A point array of a stand as a NumPy array."""
    return vtk_to_numpy(trees.GetPointData().GetArray(name))


def words(data, name):
    """The words of a field array, as the `Kinds` of a stand."""
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())] if array else []


def tree_of(kind, height, diameter, crown):
    """The plant of a kind of PRESETS with a height, a diameter at breast height and a crown diameter [m]."""
    plant = vtkReevesTreeSource()
    plant.SetPreset(_of(PRESETS, kind, "kinds"))
    plant.SetSpeciesHeight(height)
    plant.SetSpeciesDiameter(diameter)
    plant.SetSpeciesCrown(crown)
    return plant


def prototypes(trees, classes=3, make=tree_of):
    """Plants for the trees of a stand, and the stand with the index of its plant as the array `Species`.

    classes: plants of each kind at most, the DiameterClasses of vtkStandInventoryFilter; a plant has the middle height,
    diameter and crown diameter of its class.
    make: a function of kind, height, diameter and crown diameter [m] that returns a plant source.
    Returns (stand, [plants]).
    """
    kinds = words(trees, "Kinds")
    x, y, _ = vtk_to_numpy(trees.GetPoints().GetData()).T
    rows = table_of_words(("x", "y", "species", "dbh_m", "height"), (
        x, y, [kinds[k] for k in numbers(trees, "Species")], numbers(trees, "DBH"), numbers(trees, "Height")))
    sized = read_inventory(rows, table_of_words(("species", "kind"), 2 * [dict.fromkeys(kinds)]), DefaultSpecies=kinds[0],
                           DiameterClasses=classes, AllowCoincident=True)
    sizes = (vtk_to_numpy(sized.GetFieldData().GetArray("Plant" + name)) for name in ("Height", "DBH", "CrownDiameter"))
    plants = [make(kind, *map(float, size)) for kind, *size in zip(words(sized, "Kinds"), *sizes)]
    stand = vtkPolyData()
    stand.ShallowCopy(trees)
    stand.GetPointData().AddArray(sized.GetPointData().GetArray("Species"))
    return stand, plants


def plant(trees, terrain=None, classes=3, make=tree_of, **settings):
    """The scattered plants of a stand, each with the height and the diameter at breast height of its tree.

    trees: points of read_inventory(). terrain: vtkImageData with `Elevation` [m] that covers them; default none.
    classes, make: as of prototypes(). settings: properties of vtkPlantScatterFilter, as OutputForm=1.
    Returns a vtkPlantScatterFilter, with UseLevels and UseCulling off unless they are set.
    """
    stand, plants = prototypes(trees, classes, make)
    forest = vtkPlantScatterFilter()
    forest.SetInputData(0, stand)
    for each in plants:
        forest.AddPrototypeConnection(each.GetOutputPort())
    if terrain is not None:
        forest.SetInputData(2, terrain)
    return set_properties(forest, {"UseLevels": False, "UseCulling": False, **settings})
