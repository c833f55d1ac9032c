# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Inventories from files: what is read, what is refused, and the trees that are planted, measured on their polygons."""

import os
import shutil
import subprocess
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import stand
from littoral.plants import block

FOLDER = tempfile.mkdtemp()


def written(text, name="plot.csv", encoding="utf-8"):
    path = os.path.join(FOLDER, name)
    with open(path, "w", encoding=encoding) as file:
        file.write(text)
    return path


def refused(words, text, **settings):
    """A ValueError of one sentence on a text or a table."""
    try:
        stand.read_inventory(written(text) if isinstance(text, str) else text, **settings)
    except ValueError as error:
        assert words in str(error), f"{error} instead of {words}"
        return
    raise AssertionError(f"nothing was refused: {words}")


def triangles_of(polys):
    """Corners of the triangles of cells, [n, 3]."""
    return vtk_to_numpy(polys.GetConnectivityArray()).reshape(-1, 3)


def girth(points, triangles, height):
    """Length of the closed level cut of a surface that is nearest to the axis [m]."""
    z = points[:, 2]
    ends = {}
    segments = []
    for corners in triangles[(z[triangles] < height).any(axis=1) & (z[triangles] >= height).any(axis=1)]:
        cut = []
        for a, b in zip(corners, np.roll(corners, -1)):
            if (z[a] < height) != (z[b] < height):
                place = points[a] + (height - z[a]) / (z[b] - z[a]) * (points[b] - points[a])
                cut.append((ends.setdefault(tuple(np.round(place[:2], 5)), len(ends)), place[:2]))
        if len(cut) == 2:
            segments.append(cut)
    loop = list(range(len(ends)))

    def root(k):
        while loop[k] != k:
            k = loop[k]
        return k

    for (a, _), (b, _) in segments:
        loop[root(a)] = root(b)
    lengths, places = {}, {}
    for (a, p), (_, q) in segments:
        lengths[root(a)] = lengths.get(root(a), 0.0) + np.hypot(*(p - q))
        places.setdefault(root(a), []).append(0.5 * (p + q))
    return lengths[min(places, key=lambda k: np.hypot(*np.mean(places[k], axis=0)))]


def measured(forest, count):
    """Heights above the feet and diameters by girth at breast height of scattered plants, from their polygons [m]."""
    data = forest.GetOutputDataObject(0)
    feet = vtk_to_numpy(data.GetFieldData().GetArray("Position"))
    heights = np.zeros(count)
    for name in ("Skin", "Leaves"):
        part = block(data, "High", name)
        plants = vtk_to_numpy(part.GetPointData().GetArray("PlantId"))
        z = vtk_to_numpy(part.GetPoints().GetData())[:, 2] - feet[plants, 2]
        np.maximum.at(heights, plants, z)
    skin = block(data, "High", "Skin")
    points = vtk_to_numpy(skin.GetPoints().GetData()).astype(float)
    owners = vtk_to_numpy(skin.GetPointData().GetArray("PlantId"))
    triangles = triangles_of(skin.GetPolys())
    of_triangle = owners[triangles[:, 0]]
    diameters = np.zeros(count)
    for plant in range(count):
        own = triangles[of_triangle == plant]
        height = 1.3 if heights[plant] > 2.6 else 0.5 * heights[plant]
        diameters[plant] = girth(points - feet[plant], own, height) / np.pi
    return heights, diameters


def check_planted(trees, name, forest=None):
    """Height and DBH of each planted tree within 1 %."""
    forest = forest or stand.plant(trees)
    forest.Update()
    count = trees.GetNumberOfPoints()
    for what, values in zip(("Height", "DBH"), measured(forest, count)):
        error = np.abs(values / stand.numbers(trees, what) - 1.0).max()
        print(f"{name}: {what} of {count} trees within {100.0 * error:.3f} %")
        assert error < 0.01, (name, what, error)


# Files -----------------------------------------------------------------------------------------------------------------
trees = stand.read_inventory(written("\ufeffx;y;species;dbh_mm\n1;2;oak;300\n5;7;Pinus palustris;\n"))
assert np.allclose(stand.numbers(trees, "DBH")[0], 0.3) and stand.words(trees, "Kinds") == ["Pine", "Oak"]
assert list(stand.numbers(trees, "Imputed")) == [2, 3]
trees = stand.read_inventory(written("X;Y;Species;DBH\n3,5;4,25;Fagus sylvatica;25,4\n8;14,2;Quercus robur;35\n"))
assert trees.GetPoint(0)[:2] == (3.5, 4.25) and np.allclose(stand.numbers(trees, "DBH"), (0.254, 0.35))
trees = stand.read_inventory(written('"x","y","marks"\n"1","2","12"\n"4","2","8"\n'), columns={"dbh": "marks"},
                             units={"dbh": "in", "place": "ft"}, Seed=3)
assert np.allclose(stand.numbers(trees, "DBH"), (0.3048, 0.2032)) and np.isclose(trees.GetPoint(1)[0], 1.2192)
same = stand.read_inventory(written('"x","y","marks"\n"1","2","12"\n"4","2","8"\n'), columns={"dbh": "marks"},
                            units={"dbh": "in", "place": "ft"}, Seed=3)
assert (stand.numbers(trees, "Height") == stand.numbers(same, "Height")).all()
plain = "x;y;species;dbh\n3,5;4,25;H\u00eatre;25,4\n8;14,2;\"Quercus robur\";35\n"
for text, encoding in ((plain, "utf-8"), ("sep=;\n" + plain, "latin-1"), (plain.replace(";", "\t"), "utf-16")):
    trees = stand.read_inventory(written(text, encoding=encoding))
    assert trees.GetPoint(0)[:2] == (3.5, 4.25) and np.allclose(stand.numbers(trees, "DBH"), (0.254, 0.35))
    assert stand.words(trees, "Unlisted") == ["H\u00eatre"], encoding

# Species of the user: a dictionary, and a table -------------------------------------------------------------------------
ash = "x,y,sp,dbh\n1,2,FREX,30\n9,2,Quercus alba,30\n"
trees = stand.read_inventory(written(ash), species={"FREX": "Birch"})
assert stand.words(trees, "Kinds") == ["Birch", "Oak"] and stand.words(trees, "Unlisted") == []
table = written("species,kind,curve,a,b,c\nFREX,Fern,Weibull,30,0.04,0.8\nhardwood,Oak\n", "species.csv")
trees = stand.read_inventory(written(ash), species=table, HeightVariation=0.0)
assert stand.words(trees, "Kinds") == ["Fern", "Oak"]
assert np.isclose(stand.numbers(trees, "Height")[0], 30.0 * (1.0 - np.exp(-0.04 * 30.0**0.8)) - 0.0, rtol=1e-9)
assert os.path.isfile(stand.SPECIES) and stand.read_table(stand.SPECIES).GetNumberOfRows() > 40

# What is refused --------------------------------------------------------------------------------------------------------
refused("no columns x and y", "a,b\n1,2\n")
refused("no column 'Dicke'; the table has x, y", "x,y\n1,2\n", columns={"dbh": "Dicke"})
refused("columns has 'girth'", "x,y\n1,2\n", columns={"girth": "x"})
refused("units has 'yard'", "x,y\n1,2\n", units={"place": "yard"})
refused("no property Trees", "x,y\n1,2\n", Trees=3)
refused("rows 1 and 2 stand at the same place", "x,y\n1,2\n1,2\n")
refused("set DiameterUnit, to cm or mm or in", "x,y,dbh\n1,2,31\n4,2,28\n", units={"dbh": "m"})
refused("row 3 has 3 cells", "x,y\n1,2\n1,2,3\n")
refused("the file has no rows", "\n")
refused("close the quote of row 2", 'x,y,species,dbh\n1,2,"oak,30\n4,2,oak,30\n9,2,oak,30\n')
refused("two are named dbh", "x,y,dbh,dbh\n1,2,30,17\n")
refused("set DiameterColumn: dbh_furlong", "x,y,dbh_furlong\n1,2,30\n")
refused("open the file as Text Table", stand.table_of_words(["x;y;dbh"], [["1;2;30"]]))
try:
    stand.read_inventory(os.path.join(FOLDER, "absent.csv"))
    raise AssertionError("a file that is not there was read")
except OSError:
    pass

# Planted: kinds, sizes, parts of the table unknown ----------------------------------------------------------------------
rng = np.random.default_rng(5)
rows = ["x,y,species,dbh,height"]
for k in range(24):
    species = ("longleaf pine", "white oak", "birch")[k % 3]
    dbh = np.exp(rng.uniform(np.log(1.5), np.log(90.0)))
    rows.append(f"{6 * (k % 6)},{7 * (k // 6)},{species},{dbh:.2f},{'' if k % 4 else round(1.4 + 22.0 * (1.0 - np.exp(-dbh / 25.0)), 1)}")
mixed = stand.read_inventory(written("\n".join(rows)))
sites, plants = stand.prototypes(mixed, classes=2)
assert len(plants) == 6 and sorted(set(stand.numbers(sites, "Species"))) == list(range(6))

# As instances, and merged, the same trees.
forest = stand.plant(mixed, OutputForm=1)
forest.Update()
points = forest.GetOutput().GetBlock(0)
scales = vtk_to_numpy(points.GetPointData().GetArray("Scale"))
index = vtk_to_numpy(points.GetPointData().GetArray("Prototype"))
tops = {k: max(forest.GetOutput().GetBlock(int(k)).GetBlock(part).GetBounds()[5] for part in (0, 1)) for k in set(index)}
assert np.allclose([scales[k, 2] * tops[i] for k, i in enumerate(index)], stand.numbers(mixed, "Height"), rtol=1e-5)
forest.SetOutputForm(0)
check_planted(mixed, "three kinds", forest)

# A real stand, where R is -----------------------------------------------------------------------------------------------
longleaf = os.path.join(FOLDER, "longleaf.csv")
script = (f"library(spatstat.data); write.csv(data.frame(x=longleaf$x, y=longleaf$y, dbh=longleaf$marks, "
          f"species='longleaf pine'), '{longleaf}', row.names=FALSE)")
if shutil.which("Rscript") and subprocess.run(["Rscript", "-e", script], capture_output=True, check=False).returncode == 0:
    trees = stand.read_inventory(longleaf)
    diameters = stand.numbers(trees, "DBH")
    assert trees.GetNumberOfPoints() == 584 and np.isclose(diameters.max(), 0.759) and np.isclose(diameters.min(), 0.02)
    with open(longleaf, encoding="utf-8") as file:
        lines = file.read().splitlines()
    part = stand.read_inventory(written("\n".join(lines[:1] + lines[1::20])))
    check_planted(part, "longleaf, each twentieth tree")
else:
    print("R or its package spatstat.data is not here: the stand of longleaf pines is left out")
shutil.rmtree(FOLDER)
