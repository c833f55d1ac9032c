# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of render windows as files, drawn off screen, and lines of text in them."""

import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws charts
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkTextActor, vtkWindowToImageFilter

from . import display, files

#: Colors of text.
INK = (0.16, 0.18, 0.22)
FAINT = (0.40, 0.43, 0.48)


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
    grab.ShouldRerenderOff()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetOutputDimensions(size[0], size[1], 1)
    writer.SetInputConnection(shrink.GetOutputPort())
    files.write(writer, filename)
