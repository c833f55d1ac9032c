# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure8.jpg of the user guide: four species at their three levels of detail.

    ./littoral run pvpython Documentation/pictures/make_plant_levels.py [FOLDER]
"""

import math
import os
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from littoral import vtkPlantScatterFilter, vtkReevesTreeSource
from littoral.gallery.pictures import look, pale_renderer
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.plants import add_daylight, block, level_actors, plant_actor

SIZE = (1100, 990)
SPECIES = ("Pine", "Oak", "Birch", "Shrub")
WIDTH = {"Pine": 13.0, "Oak": 18.0, "Birch": 14.0, "Shrub": 11.0}  # [m]
LEVELS = ("High", "Medium", "Low")
DISTANCE, VIEW_ANGLE = 150.0, 6.9  # of the eye [m] and of the picture [degrees]
EYE = (0.0, -DISTANCE, 12.0)


def standing(source, x, eye):
    """The plant at a site, where its level Low faces the eye."""
    points, site = vtkPoints(), vtkPolyData()
    points.InsertNextPoint(x, 0.0, 0.0)
    site.SetPoints(points)
    plant = vtkPlantScatterFilter()
    plant.SetInputData(0, site)
    plant.AddPrototypeConnection(source.GetOutputPort())
    plant.SetScaleVariation(0.0)
    plant.SetTintVariation(0.0)
    plant.SetViewPoint(*eye)
    plant.UseCullingOff()
    return plant


def polygons(source, level):
    """Number of polygons of a level."""
    names = {"High": ("Skin", "Leaves"), "Medium": ("Trunk", "Crown"), "Low": ()}[level]
    data = block(source.GetOutputDataObject(0), level)
    parts = [block(data, name) for name in names] or [data]
    return sum(part.GetNumberOfPolys() for part in parts)


def shadow(x, radius):
    """A soft dark disk on the ground."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(0.0)
    disk.SetOuterRadius(radius)
    disk.SetCircumferentialResolution(60)
    disk.Update()
    actor = plant_actor(disk.GetOutput())
    actor.SetPosition(x + 0.25 * radius, 0.0, -0.05)
    actor.SetScale(1.0, 0.8, 1.0)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0.62, 0.68, 0.66)
    actor.GetProperty().SetOpacity(0.5)
    return actor


def panel(level, row):
    """A renderer with all species at a level, in a row of the picture."""
    renderer = pale_renderer()
    low = 1.0 - (row + 1) / len(LEVELS)
    renderer.SetViewport(0.0, low, 1.0, low + 1.0 / len(LEVELS))
    add_daylight(renderer)
    seen = 2.0 * DISTANCE * math.tan(math.radians(0.5 * VIEW_ANGLE)) * len(LEVELS) * SIZE[0] / SIZE[1]
    x = -0.5 * sum(WIDTH.values())
    for name in SPECIES:
        source = vtkReevesTreeSource()
        source.SetPreset(getattr(source, name))
        x += 0.5 * WIDTH[name]
        renderer.AddActor(shadow(x, 0.25 * WIDTH[name]))
        plant = standing(source, x, EYE)
        plant.SetNearDistance(1e4 if level == "High" else 0.0)
        plant.SetFarDistance(0.0 if level == "Low" else 1e4)
        plant.Update()
        for actor in level_actors(plant, level, cut_leaves=True):
            renderer.AddActor(actor)
        place = 0.5 + x / seen
        number = polygons(plant, level)
        text = f"{number:,} polygon{'s' if number > 1 else ''}".replace(",", "\u2009")
        renderer.AddActor(label(f"{name}: {text}", (place, 0.085), 22, FAINT))
        x += 0.5 * WIDTH[name]
    renderer.AddActor(label(level, (0.07, 0.95), 36, INK))
    look(renderer, EYE, (0.0, 0.0, 6.4), VIEW_ANGLE)
    return renderer


def main(folder):
    """Draw it into a folder."""
    window = vtkRenderWindow()
    for row, level in enumerate(LEVELS):
        window.AddRenderer(panel(level, row))
    write_jpg(window, os.path.join(folder, "figure8.jpg"), SIZE)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
