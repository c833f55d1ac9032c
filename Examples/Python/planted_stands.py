# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all args=.
"""Two forest inventories, planted: longleaf pines with their diameters, and a wood of oaks, hickories and maples.

    python3 planted_stands.py [FOLDER]

writes stand-longleaf.jpg and stand-lansing.jpg into FOLDER: the map of each inventory, and the wood from inside it. The
inventories are those of Debian's package r-cran-spatstat.data, read by R; without it the example says so and ends.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import stand
from littoral.gallery.floor import BROADLEAVED, SAVANNA, light, plant_actors
from littoral.picture import INK, label, write_jpg
from littoral.plants import level_actors

PICTURE = (1500, 700)  # pixels
MAP = 0.42  # part of the width
#: Colors of species on the map, in the order of their numbers.
COLORS = ((0.30, 0.52, 0.30), (0.80, 0.56, 0.22), (0.42, 0.50, 0.62), (0.66, 0.34, 0.28), (0.56, 0.62, 0.24), (0.55, 0.45, 0.60))

#: Script of R that writes each inventory, and how it is read.
LONGLEAF = ("write.csv(data.frame(x=longleaf$x, y=longleaf$y, dbh=longleaf$marks, species='longleaf pine'), "
            "file='{}', row.names=FALSE)")
LANSING = "write.csv(data.frame(x=lansing$x, y=lansing$y, species=lansing$marks), file='{}', row.names=FALSE)"
STANDS = (
    ("longleaf", LONGLEAF, {}, "Longleaf pines, 4 ha in Georgia", (88.0, -14.0, 3.2), (3.0, 6.0),
     SAVANNA, {"SunAzimuth": 262.0, "SunElevation": 24.0, "CoverHeight": 0.55, "CoverRadius": 70.0}),
    # 924 feet scaled to 1; two trees have the same place.
    ("lansing", LANSING, {"CoordinateScale": 924.0, "units": {"place": "ft"}, "AllowCoincident": True},
     "Lansing Woods, 7.9 ha in Michigan", (140.0, -3.0, 1.9), (0.0, 6.0),
     BROADLEAVED, {"SunAzimuth": 118.0, "SunElevation": 38.0, "CoverHeight": 0.25, "CoverRadius": 50.0}),
)


def inventory(command, filename):
    """Let R write an inventory. Whether it could."""
    script = "library(spatstat.data); " + command.format(filename)
    return shutil.which("Rscript") is not None and \
        subprocess.run(["Rscript", "-e", script], capture_output=True, check=False).returncode == 0


def species_of(trees):
    """Names of the species, the most frequent first."""
    names = trees.GetPointData().GetAbstractArray("SpeciesName")
    counts = Counter(names.GetValue(k) for k in range(names.GetNumberOfValues()))
    return [name for name, _ in counts.most_common()]


def disks(trees):
    """The crowns on the ground, with colors of their species."""
    places = vtk_to_numpy(trees.GetPoints().GetData())
    radii = 0.5 * stand.numbers(trees, "CrownDiameter")
    color = {name: COLORS[k % len(COLORS)] for k, name in enumerate(species_of(trees))}
    names = trees.GetPointData().GetAbstractArray("SpeciesName")
    own = np.array([color[names.GetValue(k)] for k in range(len(places))])
    angles = np.arange(24) * 2.0 * np.pi / 24.0
    ring = np.column_stack((np.cos(angles), np.sin(angles), np.zeros(24)))
    order = np.argsort(-radii)
    height = np.arange(len(order))[:, None, None] * np.array((0.0, 0.0, 1e-3))  # small ones on top
    corners = places[order][:, None] + radii[order][:, None, None] * ring + height
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(corners.reshape(-1, 3), deep=True))
    for k in range(len(order)):
        cells.InsertNextCell(24, range(24 * k, 24 * k + 24))
    shade = 0.85 + 0.15 * np.random.default_rng(1).random((len(order), 1))
    colors = np.repeat(own[order] * shade, 24, axis=0)
    rgb = numpy_to_vtk((255.0 * colors).astype(np.uint8), deep=True)
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(rgb)
    return data


def actor_of(data, ambient=0.25):
    """Actor of polygons with their colors."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(ambient)
    actor.GetProperty().SetDiffuse(1.0 - ambient)
    return actor


def draw_map(trees, title, window):
    """The crowns from above, in the left part of a window."""
    renderer = vtkRenderer()
    renderer.SetViewport(0.0, 0.0, MAP, 1.0)
    renderer.SetBackground(0.97, 0.965, 0.95)
    renderer.AddActor(actor_of(disks(trees), 1.0))
    x0, x1, y0, y1 = trees.GetBounds()[:4]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.0)
    camera.SetPosition(0.5 * (x0 + x1), 0.5 * (y0 + y1), 100.0)
    camera.SetParallelScale(0.60 * (y1 - y0))
    window.AddRenderer(renderer)
    # Letters of twice their height: the picture is halved.
    renderer.AddActor(label(title, (0.5, 0.985), 44, INK))
    for k, name in enumerate(species_of(trees)):
        place = (k + 0.5) / len(species_of(trees)), 0.055
        renderer.AddActor(label(name, place, 34, tuple(0.75 * c for c in COLORS[k % len(COLORS)])))
    renderer.ResetCameraClippingRange()


def woods_beyond(trees, side, rings=2):
    """Actors of the trees of a stand, seen from its southern edge, again in squares around it, at their lowest level."""
    forest = stand.plant(trees, UseLevels=True, NearDistance=0.0, FarDistance=1e-3)
    forest.Update()
    actors = []
    for row in range(rings + 1):
        for column in range(-rings, rings + 1):
            for actor in level_actors(forest, "Low") if row or column else ():
                actor.SetPosition(column * side, row * side, 0.0)
                actors.append(actor)
    return actors


def draw_wood(trees, eye, heading, colors, settings, window):
    """The planted trees, in the right part of a window. heading: from north to east, and up from level [degrees].
    colors: of ground and grass; settings: properties of the light."""
    renderer = vtkRenderer()
    renderer.SetViewport(MAP, 0.0, 1.0, 1.0)
    aspect = (1.0 - MAP) * PICTURE[0] / PICTURE[1]
    forest = stand.plant(trees, UseLevels=True, UseCulling=False, NearDistance=90.0, FarDistance=200.0)
    azimuth, up = np.radians(heading)
    towards = (np.sin(azimuth) * np.cos(up), np.cos(azimuth) * np.cos(up), np.sin(up))
    forest.SetViewPoint(*eye)
    forest.SetViewDirection(*towards)
    forest.SetViewAngle(58.0)
    forest.SetAspectRatio(aspect)
    forest.Update()
    for actor in plant_actors(forest) + woods_beyond(trees, trees.GetBounds()[1]):
        renderer.AddActor(actor)
    light(renderer, colors, CloudCover=0.25, Visibility=3000.0, ExposureCompensation=1.0, **settings)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*(e + t for e, t in zip(eye, towards)))
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(58.0)
    camera.SetClippingRange(0.5, 9000.0)
    window.AddRenderer(renderer)
    return forest


def report(name, trees):
    """A line of numbers of a stand."""
    diameters, heights = stand.numbers(trees, "DBH"), stand.numbers(trees, "Height")
    drawn = stand.numbers(trees, "Imputed")
    hectares = trees.GetFieldData().GetArray("Area").GetValue(0) / 1e4
    print(f"{name}: {len(diameters)} trees on {hectares:.1f} ha, basal area "
          f"{0.25 * np.pi * (diameters ** 2).sum() / hectares:.1f} m2/ha, DBH {100.0 * diameters.min():.1f} to "
          f"{100.0 * diameters.max():.1f} cm ({(drawn % 2).sum()} drawn), height {heights.min():.1f} to "
          f"{heights.max():.1f} m ({(drawn // 2).sum()} drawn), plants {', '.join(stand.words(trees, 'Kinds'))}")


def main(folder):
    """Both stands as pictures."""
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        for name, command, settings, title, eye, heading, *look in STANDS:
            filename = os.path.join(work, name + ".csv")
            if not inventory(command, filename):
                print("There are no inventories: R and its package spatstat.data are not installed.")
                return
            trees = stand.read_inventory(filename, **settings)
            report(name, trees)
            window = vtkRenderWindow()
            draw_map(trees, title, window)
            forest = draw_wood(trees, eye, heading, *look, window)
            write_jpg(window, os.path.join(folder, f"stand-{name}.jpg"), PICTURE)
            del forest


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
