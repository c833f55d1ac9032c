# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list of the macro that makes a forest of a table, in the window."""

import quick
from paraview import simple

from guide import compare

PAGE = "scenes"

SPECIES = ["Pine", "Oak", "Birch"]
TREES = [(0, 0, "Pine", 10), (20, 0, "Oak", 12), (0, 30, "Birch", 8), (20, 30, "Oak", 6), (40, 10, "Pine", 14)]


def forest(view):
    """The trees of the table, of the heights of the table, and the meadow below them."""
    trees = [simple.ReevesTree(Preset=name) for name in SPECIES]
    for tree in trees:
        tree.UpdatePipeline()
    heights = [tree.GetDataInformation().GetBounds()[5] for tree in trees]
    with open("sites.csv", "w", encoding="utf-8") as sites:
        sites.write("x,y,Species,Scale,SiteId\n")
        for number, (x, y, species, height) in enumerate(TREES):
            kind = SPECIES.index(species)
            sites.write(f"{x},{y},{kind},{height / heights[kind]!r},{number}\n")
    sites = simple.TableToPoints(Input=simple.CSVReader(FileName=["sites.csv"]), XColumn="x", YColumn="y", a2DPoints=1)
    plants = simple.PlantScatter(Sites=sites, Prototypes=trees, ScaleVariation=0)
    simple.Show(plants, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.0, -3.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.4)  # the bounds are those of the trees as seen
    x0, x1, y0, y1, z0, _ = plants.GetDataInformation().GetBounds()
    margin = 0.03 * (x1 - x0 + y1 - y0)
    meadow = simple.Plane(Origin=[x0 - margin, y0 - margin, z0], Point1=[x1 + margin, y0 - margin, z0],
                          Point2=[x0 - margin, y1 + margin, z0])
    simple.Show(meadow, view).DiffuseColor = [0.42, 0.40, 0.22]


def prepare():
    with open("trees.csv", "w", encoding="utf-8") as table:
        table.write("x,y,species,height\n" + "".join(f"{x},{y},{kind.lower()},{h}\n" for x, y, kind, h in TREES))


def walk(walk):
    walk.next("CSV Reader")
    for word in ("x", "y", "species", "height"):
        walk.say(word)
    walk.open("trees.csv", "GDALVectorReader")
    walk.apply()
    walk.next()
    walk.macro("forest_from_table")
    walk.look("forest")


def check():
    compare("forest", forest, 0.05)
