# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Films of image files, and of views of ParaView with motion blur."""

import os
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter

from . import files

_CODES = np.arange(256) / 255.0
#: Light of each byte of a picture  (IEC 61966-2-1)
_LIGHT = np.where(_CODES <= 0.04045, _CODES / 12.92, ((_CODES + 0.055) / 1.055) ** 2.4)


def save_film(filename, pictures, frames_per_second=24):
    """Write PNG files of one size as an Ogg Theora film (`.ogv`), which browsers and VLC show."""
    reader, writer = vtkPNGReader(), vtkOggTheoraWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetRate(frames_per_second)
    writer.SetQuality(2)
    writer.SubsamplingOff()
    with files.replaced(filename) as path:
        writer.SetFileName(path)
        for number, picture in enumerate(pictures):
            reader.SetFileName(picture)
            reader.Update()
            if number == 0:
                writer.Start()
            writer.Write()
        writer.End()
        if writer.GetError():
            raise OSError(f"{filename} cannot be written.")


def exposure_times(time, duration, blur=0.5, exposures=8):
    """Middles of equal parts of the time that a shutter is open, from the time of a frame on [s].

    duration: of the frame [s]; blur: share of it that the shutter is open, 0 to 1.
    """
    return [time + blur * duration * (part + 0.5) / exposures for part in range(exposures)]


def exposed(pictures):
    """The picture of a film that is exposed to pictures of one size for equal times: the mean of their light.

    pictures: vtkImageData with bytes in the code of sRGB, as the result.
    """
    light, count, result = 0.0, 0, vtkImageData()
    for picture in pictures:
        light, count = light + _LIGHT[vtk_to_numpy(picture.GetPointData().GetScalars())], count + 1
        result.CopyStructure(picture)
    codes = np.searchsorted(0.5 * (_LIGHT[1:] + _LIGHT[:-1]), light / count).astype(np.uint8)
    result.GetPointData().SetScalars(numpy_to_vtk(codes, deep=True))
    return result


def blurred_frames(view, blur=0.5, exposures=8):
    """The frames of the animation of a view of ParaView, each exposed to pictures while the shutter is open.

    blur: share of the time to the next frame, 0 to 1.
    """
    from paraview import simple

    scene = simple.GetAnimationScene()
    before, duration = scene.AnimationTime, _frame_time(scene)

    def picture_at(time):
        scene.AnimationTime = time
        return view.SMProxy.CaptureWindow(1)

    for frame in range(int(scene.NumberOfFrames)):
        times = exposure_times(scene.StartTime + frame * duration, duration, blur, exposures)
        yield exposed(map(picture_at, times))
    scene.AnimationTime = before


def save_animation(filename, view, blur=0.5, exposures=8):
    """Write the `blurred_frames` of a view of ParaView as an Ogg Theora film, as long as its times tell."""
    from paraview import simple

    writer = vtkPNGWriter()
    with tempfile.TemporaryDirectory() as folder:
        names = []
        for frame in blurred_frames(view, blur, exposures):
            names.append(os.path.join(folder, f"{len(names)}.png"))
            writer.SetFileName(names[-1])
            writer.SetInputData(frame)
            writer.Write()
        duration = _frame_time(simple.GetAnimationScene())
        save_film(filename, names, max(round(1.0 / duration), 1) if duration > 0.0 else 24)


def _frame_time(scene):
    """Time from a frame of an animation to the next one [s]."""
    return (scene.EndTime - scene.StartTime) / max(int(scene.NumberOfFrames) - 1, 1)
