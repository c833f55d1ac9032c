# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of terrains as blocks in a row, off screen with plain VTK."""

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from ..LittoralRendering import vtkLandscapePass
from ..picture import FAINT, INK, label, write_png
from ..properties import set_properties
from . import relief

#: Part of the height of a picture for panels below blocks.
BELOW = 0.42
#: Colors of panels, as the floor has in its light, and of a pale sky at the lower and the upper edge of a picture.
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
