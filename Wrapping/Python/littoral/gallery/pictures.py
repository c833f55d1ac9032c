# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of terrains as blocks in a row, off screen with plain VTK.

Positions in an image are fractions of its width and height, from the lower left.
"""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkRectf
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from ..LittoralRendering import vtkLandscapePass
from ..picture import FAINT, INK, label, write_png
from ..properties import set_properties
from . import relief
from .colors import natural_color

#: The floor before blocks, in their light; and a pale sky, at the lower and the upper edge of a picture.
PAPER, SKY = (0.955, 0.950, 0.940), ((0.96, 0.955, 0.945), (0.74, 0.80, 0.86))


def save_block(filename, image, exaggeration=1.0, size=(1200, 800)):
    """Render one terrain as a block on a pale floor."""
    _save_blocks(filename, [image], exaggeration, natural_color, [], size)


def save_pair(filename, images, titles, notes, exaggeration=1.0,
              coloring=natural_color, size=(1600, 760)):
    """Render two terrains of the same size as blocks, side by side on a pale floor.

    titles, notes: a large and a small line of text under each.
    """
    _save_blocks(filename, images, exaggeration, coloring, list(zip(titles, notes)), size)


def save_grounds(filename, grounds, rivers, titles, notes, rows, chart=None, exaggeration=1.0, size=(1600, 960)):
    """Render terrains of the same size with lakes and rivers as blocks in a row, above a table of numbers and a chart.

    grounds, rivers: outputs 0 and 1 of `vtkDrainageFilter` without carving; rows: of the table, each a name and a text
    for each terrain, which stands in bold if it begins with `*`; chart: a `vtkChartXY`, or None.
    """
    share = 0.42  # of the height, for the table
    width, count, aspect = relief.width_of(grounds[0]), len(grounds), size[0] / (size[1] * (1.0 - share))
    eye, focus, angle = relief.row_camera(width, count, aspect)
    window, above, below = vtkRenderWindow(), vtkRenderer(), vtkRenderer()
    above.SetViewport(0.0, share, 1.0, 1.0)
    below.SetViewport(0.0, 0.0, 1.0, share)
    below.SetBackground(*PAPER)
    for ground, lines, center in zip(grounds, rivers, relief.row_centers(width, count)):
        above.AddActor(actor_of(relief.lake_block(ground, exaggeration, center)))
        for line, order in relief.river_lines(lines, ground, exaggeration, center):
            actor = actor_of(line)
            actor.GetProperty().LightingOff()
            actor.GetProperty().SetLineWidth((0.5 + 0.7 * order) * 1.6)
            above.AddActor(actor)
    _light(above, width, count, np.linalg.norm(eye - focus))
    look(above, eye, focus, angle)
    for k, (title, note) in enumerate(zip(titles, notes)):
        place = (k + 0.5) / count
        above.AddActor(label(title, (place, 0.15), 50, INK))
        above.AddActor(label(note, (place, 0.07), 34, FAINT))
    _add_table(below, [title.split(",")[0] for title in titles], rows, 0.03, 0.60 if chart else 0.97)
    window.AddRenderer(above)
    window.AddRenderer(below)
    if chart:
        window.AddRenderer(_chart_renderer(chart, (0.63, 0.01, 0.985, share), size))
    write_png(window, filename, size)


def _add_table(renderer, titles, rows, left, right):
    """Texts of a table, its names at the left and a column for each title; bold where a text begins with `*`."""
    first = left + 0.36 * (right - left)
    columns = [first + (k + 0.5) * (right - first) / len(titles) for k in range(len(titles))]
    step = 0.86 / (len(rows) + 1)
    for k, row in enumerate([("", *titles), *rows]):
        height = 0.93 - step * k
        for place, text in zip([left, *columns], row):
            actor = label(text.lstrip("*"), (place, height), 34, FAINT if k == 0 else INK)
            if place == left:
                actor.GetTextProperty().SetJustificationToLeft()
            actor.GetTextProperty().SetBold(text.startswith("*"))
            renderer.AddActor(actor)


def _chart_renderer(chart, viewport, size):
    """A renderer of a chart in a part of a picture, oversampled by two."""
    renderer, actor = vtkRenderer(), vtkContextActor()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(*PAPER)
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(
        0.0, 30.0, 2.0 * size[0] * (viewport[2] - viewport[0]), 2.0 * size[1] * (viewport[3] - viewport[1]) - 60.0))
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


def actor_of(data):
    """Actor of data with the colors of the array `RGB`."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    return actor


def _light(renderer, width, count, distance):
    """The light on a row of blocks, and the floor under them."""
    renderer.AddActor(actor_of(relief.floor(width, count)))
    renderer.SetPass(set_properties(vtkLandscapePass(), relief.light_of(width, distance)))


def _save_blocks(filename, images, exaggeration, coloring, texts, size):
    """Render blocks in a row with texts below them."""
    width = relief.width_of(images[0])
    eye, focus, angle = relief.row_camera(width, len(images), size[0] / size[1])
    renderer, window = vtkRenderer(), vtkRenderWindow()
    for image, center in zip(images, relief.row_centers(width, len(images))):
        renderer.AddActor(actor_of(relief.relief_block(image, exaggeration, coloring, center)))
    for k, (title, note) in enumerate(texts):
        place = (k + 0.48) / len(texts)
        renderer.AddActor(label(title, (place, 0.125), 50, INK))
        renderer.AddActor(label(note, (place, 0.078), 34, FAINT))
    _light(renderer, width, len(images), np.linalg.norm(eye - focus))
    look(renderer, eye, focus, angle)
    window.AddRenderer(renderer)
    write_png(window, filename, size)
