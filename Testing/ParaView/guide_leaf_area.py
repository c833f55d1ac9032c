# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a plot to its leaf area, in the window, with the plot that is shipped."""

import os
import shutil
import struct

import quick  # noqa: F401
from paraview import simple

from guide import TOP
from player import drawn

PAGE, NUMBER = "stands", 1


def index():
    fields = simple.FindSource("ForestDensity1").GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    return fields.GetArray("LeafAreaIndex").GetValue(0), fields.GetArray("LeafMass").GetValue(0)


def keep_index():
    """In the client: leaf area index and mass of the image."""
    with open("leaves.txt", "w", encoding="ascii") as out:
        print(*index(), file=out)


def prepare():
    shutil.copy(os.path.join(TOP, "Examples", "Data", "stand", "plot.csv"), "leaf_plot.csv")
    os.makedirs("leaf", exist_ok=True)
    os.replace("leaf_plot.csv", "leaf/plot.csv")


def walk(walk):
    walk.next()
    walk.say("plot.csv")
    walk.open("leaf/plot.csv", "GDALVectorReader")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Stand Inventory")
    walk.apply()
    walk.next("Profile", "Gaps")
    walk.entry("Filters > Littoral > Forest Density")
    walk.set("Bounds", [0, 50, 0, 50, 0, 30], said="Bounds 0 50 0 50 0 30 [m]")
    walk.set("Cell Size", [2, 2, 1], said="Cell Size 2 2 1 [m]")
    walk.apply()
    walk.look("leaves")
    walk.call(keep_index)
    walk.next(".dat", ".nc")
    walk.save("leaves.bdf")
    walk.next()
    walk.say("Trees")
    walk.select(0, 0, 0, 3)
    walk.save("leaves.amrwind")


def records(data):
    """Records of a file of Fortran."""
    place = 0
    while place < len(data):
        size, = struct.unpack_from("<i", data, place)
        yield data[place + 4:place + 4 + size]
        place += size + 8


def check():
    with open("leaves.txt", encoding="ascii") as file:
        area, mass = map(float, file.read().split())
    with open("leaves.bdf", "rb") as file:
        parts = list(records(file.read()))
    sides = struct.unpack("<3d", parts[1])
    sum_of_cells = sum(struct.unpack("<d", part)[0] for part in parts[4::2]) * sides[0] * sides[1] * sides[2]
    with open("leaves.amrwind", encoding="ascii") as file:
        rows = [line.split() for line in file if line.strip()]
    print(f"leaf area index {area:.2f}, leaves of {mass:.0f} kg, in the file {sum_of_cells:.0f} kg, {len(rows)} trees")
    assert 3.0 < area < 7.0 and abs(sum_of_cells / mass - 1.0) < 1e-5 and len(rows) == 100
    assert drawn("leaves.png") > 0.05
