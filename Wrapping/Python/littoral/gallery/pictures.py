# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of terrains as blocks in a row, off screen with plain VTK.

Positions in an image are fractions of its width and height, from the lower left.
"""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkRectf
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from ..LittoralRendering import vtkLandscapePass
from ..picture import FAINT, INK, label, write_png
from ..properties import set_properties
from . import relief

#: Part of the height of a picture for panels below blocks.
BELOW = 0.42
#: Their background, that of the floor in its light; and a pale sky, at the lower and the upper edge of a picture.
PAPER, SKY = (0.955, 0.950, 0.940), ((0.96, 0.955, 0.945), (0.74, 0.80, 0.86))


def save_blocks(filename, images, exaggeration=1.0, texts=(), size=(1200, 800), water=False, panels=()):
    """Render terrains of the same size as blocks in a row on a pale floor.

    texts: a large and a small line under each; water: whether lakes and rivers are shown; panels: renderers below.
    """
    count, width, share = len(images), relief.width_of(images[0]), BELOW if panels else 0.0
    eye, focus, angle = relief.row_camera(width, count, size[0] / (size[1] * (1.0 - share)))
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetViewport(0.0, share, 1.0, 1.0)
    renderer.AddActor(relief.actor_of(relief.floor(width, count)))
    for image, center in zip(images, relief.row_centers(width, count)):
        for actor in relief.block(image, exaggeration, center, water):
            renderer.AddActor(actor)
    for k, (title, note) in enumerate(texts):
        renderer.AddActor(label(title, ((k + 0.5) / count, 0.07 + 38.0 / (size[1] * (1.0 - share))), 50, INK))
        renderer.AddActor(label(note, ((k + 0.5) / count, 0.07), 34, FAINT))
    renderer.SetPass(set_properties(vtkLandscapePass(), relief.light_of(width, np.linalg.norm(eye - focus))))
    look(renderer, eye, focus, angle)
    for each in (renderer, *panels):
        window.AddRenderer(each)
    write_png(window, filename, size)


def _panel(left, right):
    """A renderer of a part of the width below blocks."""
    renderer = vtkRenderer()
    renderer.SetViewport(left, 0.0, right, BELOW)
    renderer.SetBackground(*PAPER)
    return renderer


def table_panel(titles, rows, left=0.0, right=0.62):
    """A table below blocks: texts of rows, each with its name first, a column for each title; `*` before a text: bold."""
    renderer, count = _panel(left, right), len(titles)
    for k, row in enumerate([("", *titles), *rows]):
        for column, text in enumerate(row):
            place = 0.40 + 0.60 * (column - 0.5) / count if column else 0.04
            actor = label(text.lstrip("*"), (place, 0.93 - 0.86 * k / (len(rows) + 1)), 34, INK if k else FAINT)
            if column == 0:
                actor.GetTextProperty().SetJustificationToLeft()
            actor.GetTextProperty().SetBold(text.startswith("*"))
            renderer.AddActor(actor)
    return renderer


def chart_panel(chart, size, left=0.62, right=1.0):
    """A vtkChartXY below blocks in a picture of a size [pixels], twice as large as it is written."""
    renderer, actor = _panel(left, right), vtkContextActor()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(0.0, 40.0, 2.0 * size[0] * (right - left) - 40.0, 2.0 * size[1] * BELOW - 70.0))
    actor.GetScene().AddItem(chart)
    renderer.AddActor(actor)
    return renderer


def pale_renderer():
    """A renderer before a pale sky."""
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*SKY[0])
    renderer.SetBackground2(*SKY[1])
    renderer.UseFXAAOn()
    return renderer


def look(renderer, eye, focus, view_angle):
    """Place the camera of a renderer [m, degrees]."""
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*focus)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(view_angle)
    renderer.ResetCameraClippingRange()
