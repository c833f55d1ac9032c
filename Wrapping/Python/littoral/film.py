# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Films of image files."""

from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter

from . import files


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
