# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of surfaces with baked light, rendered off screen with plain VTK.

Positions in an image are fractions of its width and height, from the lower left.
"""

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkWindowToImageFilter)

from . import display, files, scene

INK = (0.16, 0.18, 0.22)
FAINT = (0.40, 0.43, 0.48)


def save_block(filename, image, exaggeration=1.0, size=(1200, 800)):
    """Render one terrain as a block on a pale floor."""
    _save_blocks(filename, [image], exaggeration, scene.natural_color, [], size)


def save_pair(filename, images, titles, notes, exaggeration=1.0,
              coloring=scene.natural_color, size=(1600, 760)):
    """Render two terrains of the same size as blocks, side by side on a pale floor.

    titles, notes: a large and a small line of text under each.
    """
    _save_blocks(filename, images, exaggeration, coloring, list(zip(titles, notes)), size)


def save_picture(filename, surfaces, eye, focus, view_angle, labels=(), size=(1600, 760),
                 oversampling=2):
    """Render surfaces before a pale sky.

    eye, focus: camera [m]; view_angle: vertical [degrees]; labels: arguments of `label`.
    """
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*scene.BACKGROUND[0])
    renderer.SetBackground2(*scene.BACKGROUND[1])
    renderer.UseFXAAOn()
    for surface in surfaces:
        renderer.AddActor(lit_actor(surface))
    for text, place, height, color in labels:
        renderer.AddActor(label(text, place, height * oversampling, color))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*focus)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(view_angle)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    write_png(window, filename, size, oversampling)


def lit_actor(data):
    """Actor with the colors of the array `RGB`, without lighting."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def label(text, place, height, color=INK):
    """Text with the center of its upper edge at a position; height in pixels."""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(*place)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(height)
    style.SetColor(*color)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToTop()
    return actor


def write_png(window, filename, size, oversampling=2):
    """Render a window off screen, larger by `oversampling`, and write it at a size [pixels].

    Raises OSError, with an old file as it was, and RuntimeError where there is no display.
    """
    _write(vtkPNGWriter(), window, filename, size, oversampling)


def write_jpg(window, filename, size, quality=88, oversampling=2):
    """Write a JPEG file like `write_png`; quality: 0 to 100."""
    writer = vtkJPEGWriter()
    writer.SetQuality(quality)
    _write(writer, window, filename, size, oversampling)


def _write(writer, window, filename, size, oversampling):
    """Render a window off screen and pass it to a writer."""
    display.require(window)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size[0] * oversampling, size[1] * oversampling)
    window.Render()
    grab, shrink = vtkWindowToImageFilter(), vtkImageResize()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetOutputDimensions(size[0], size[1], 1)
    writer.SetInputConnection(shrink.GetOutputPort())
    files.write(writer, filename)


def _save_blocks(filename, images, exaggeration, coloring, texts, size):
    """Render blocks in a row, in haze, with texts below them."""
    width = scene.width_of(images[0])
    eye, focus, angle = scene.row_camera(width, len(images), size[0] / size[1])
    distance = np.linalg.norm(eye - focus)
    blocks, labels = [], []
    for image, center in zip(images, scene.row_centers(width, len(images))):
        block = scene.relief_block(image, exaggeration, coloring=coloring, center=center)
        blocks.append(scene.add_haze(block, eye, distance - 0.5 * width, distance + 0.9 * width))
    floor = scene.floor_shadow([block.GetBounds() for block in blocks])
    for k, (title, note) in enumerate(texts):
        place = (k + 0.48) / len(texts)
        labels += [(title, (place, 0.125), 25, INK), (note, (place, 0.078), 17, FAINT)]
    save_picture(filename, blocks + [floor], eye, focus, angle, labels, size)
