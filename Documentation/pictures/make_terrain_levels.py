# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure7.jpg: real terrain in levels of detail, seen from above the viewer who asks for them.

    ./littoral run pvpython Documentation/pictures/make_terrain_levels.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

from littoral import vtkTerrainLevelOfDetailFilter
from littoral.elevation import array_from_image, image_from_array, read_elevation
from littoral.picture import FAINT, INK, label, write_jpg

EXAGGERATION = 3.0
SIZE = (1000, 560)  # pixels
NEAR, FAR, LEVELS = 5000.0, 20000.0, 5  # [m]
COLOURS = ((0.33, 0.62, 0.45), (0.55, 0.68, 0.36), (0.91, 0.79, 0.45), (0.86, 0.57, 0.38),
           (0.62, 0.44, 0.56))
SEAM = (0.80, 0.05, 0.12)


def terrain():
    """The Jacksboro elevation model, its heights exaggerated."""
    image = read_elevation()
    heights = array_from_image(image)
    spacing = image.GetSpacing()
    return image_from_array(EXAGGERATION * (heights - heights.min()), spacing[:2])


def surface(data, color, edges=True):
    """Actor of a block, lit, with its mesh."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    style = actor.GetProperty()
    style.SetColor(*color)
    style.SetAmbient(0.25)
    style.SetDiffuse(0.85)
    style.SetSpecular(0.0)
    style.SetEdgeVisibility(edges)
    style.SetEdgeColor(*(0.72 * np.array(color)))
    style.SetLineWidth(1.0)
    return actor


def swatch(place, color):
    """A patch of color with its upper edge at a place."""
    actor = label("\u00a0\u00a0\u00a0\u00a0", place, 24, color)
    actor.GetTextProperty().SetBackgroundColor(*color)
    actor.GetTextProperty().SetBackgroundOpacity(1.0)
    return actor


def main(folder):
    """Draw the picture into a folder."""
    image = terrain()
    x0, x1, y0, y1, _, top = image.GetBounds()[:4] + (0.0, image.GetScalarRange()[1])
    wide, deep = x1 - x0, y1 - y0
    eye = np.array((x0 + 0.5 * wide, y0 - 0.02 * deep, 0.8 * top))
    levels = vtkTerrainLevelOfDetailFilter()
    levels.SetInputData(image)
    levels.SetViewPoint(*eye)
    levels.SetSelectionToDistance()
    levels.SetNearDistance(NEAR)
    levels.SetFarDistance(FAR)
    levels.SetNumberOfLevels(LEVELS)
    levels.SetTileSize(16)
    levels.UseCullingOff()
    levels.Update()
    output = levels.GetOutput()

    renderer = vtkRenderer()
    renderer.SetBackground(0.975, 0.972, 0.965)
    for level in range(LEVELS):
        renderer.AddActor(surface(output.GetBlock(level), COLOURS[level]))
    seams = surface(output.GetBlock(LEVELS), SEAM, edges=False)
    seams.GetProperty().LightingOff()
    renderer.AddActor(seams)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPositional(False)
    sun.SetPosition(-1.0, 0.5, 1.1)
    sun.SetFocalPoint(0.0, 0.0, 0.0)
    renderer.AddLight(sun)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(x0 + 0.5 * wide, y0 - 0.66 * deep, 0.62 * deep)
    camera.SetFocalPoint(x0 + 0.5 * wide, y0 + 0.36 * deep, 0.02 * deep)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(34.0)
    renderer.ResetCameraClippingRange()
    counts = output.GetFieldData()
    shown, full = (counts.GetArray(name).GetValue(0)
                   for name in ("PolygonsShown", "PolygonsAtFullDetail"))
    renderer.AddActor(label("Terrain in levels of detail", (0.5, 0.972), 44, INK))
    renderer.AddActor(label(
        f"{shown:,.0f} triangles in place of {full:,.0f}", (0.5, 0.915), 30, FAINT))
    for level, color in enumerate(COLOURS + (SEAM,)):
        text = f"level {level}" if level < LEVELS else "seams"
        place = 0.14 + 0.145 * level
        renderer.AddActor(swatch((place - 0.052, 0.058), color))
        renderer.AddActor(label(text, (place + 0.005, 0.06), 30, INK))
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "figure7.jpg"), SIZE, quality=90)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
