# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from the CSV file of an inventory to a wood, in the window."""

import quick
from paraview import servermanager, simple

from guide import compare

PAGE = "stands"

#: Pines of three sizes and an oak: x, y [m], species, diameter at breast height [cm].
TREES = ((0, 0, "Pinus taeda", 8), (12, 3, "Pinus taeda", 20), (25, 0, "Pinus taeda", 45), (14, 15, "oak", 30))


def wood(view):
    """The plants that the inventory asks for, on its trees."""
    stand = simple.StandInventory(Inventory=simple.CSVReader(FileName=["plot.csv"]), DiameterClasses=3)
    sizes = servermanager.Fetch(stand).GetFieldData()
    trees = []
    for k, kind in enumerate(("Pine", "Pine", "Pine", "Oak")):
        height, diameter, crown = (sizes.GetArray(f"Plant{name}").GetValue(k) for name in ("Height", "DBH", "CrownDiameter"))
        trees.append(simple.ReevesTree(Preset=kind, SpeciesHeight=height, SpeciesDiameter=diameter, SpeciesCrown=crown))
    plants = simple.PlantScatter(Sites=stand, Prototypes=trees)
    simple.Show(plants, view)
    simple.ResetCamera(view)
    x0, x1, y0, y1, z0, _ = stand.GetDataInformation().GetBounds()
    margin = 0.03 * (x1 - x0 + y1 - y0)
    meadow = simple.Plane(Origin=[x0 - margin, y0 - margin, z0], Point1=[x1 + margin, y0 - margin, z0],
                          Point2=[x0 - margin, y1 + margin, z0])
    simple.Show(meadow, view).DiffuseColor = [0.42, 0.40, 0.22]


def prepare():
    with open("plot.csv", "w", encoding="utf-8") as table:
        table.write("x,y,species,dbh\n" + "".join(f"{x},{y},{name},{dbh}\n" for x, y, name, dbh in TREES))


def walk(walk):
    walk.next("CSV Reader", "Text Table")  # TestTextTableReader opens one
    walk.open("plot.csv", "GDALVectorReader")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Stand Inventory")
    walk.apply()
    walk.next("Diameter Classes", "Plant Scatter")
    walk.macro("forest_from_inventory")
    walk.look("wood")


def check():
    compare("wood", wood, 0.05)
