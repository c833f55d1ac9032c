# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Hillshades of places and their twins, for make_twins.py and make_contact_sheet.py."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, twin_of

EXAGGERATION = 2.0
SUN_ELEVATION = 40.0  # degrees
GAP = 4  # pixels


def twin(place, seed, method=vtkDrainageFilter.Quilting):
    """Heights of a twin of a place."""
    drainage = vtkDrainageFilter()
    drainage.SetInputData(twin_of(place, seed))
    drainage.SetInputData(1, place)
    drainage.SetSeed(seed)
    drainage.SetMethod(method)
    drainage.Update()
    return array_from_image(drainage.GetOutput())


def hillshade(heights, spacing, azimuth, exaggeration=EXAGGERATION):
    """Lambert's law, 0 to 255, rows from south to north; azimuth in degrees from north."""
    y, x = np.gradient(exaggeration * heights, spacing[1], spacing[0])
    sun, elevation = np.radians(azimuth), np.radians(SUN_ELEVATION)
    light = np.sin(elevation) - np.cos(elevation) * (np.sin(sun) * x + np.cos(sun) * y)
    return 255.0 * np.clip(light / np.sqrt(1.0 + x**2 + y**2), 0.0, 1.0)


def write_jpeg(rows, path):
    """Panels of gray numbers, rows from the lowest up, as one picture."""
    pixels = np.vstack([np.hstack([np.pad(panel, GAP, constant_values=255) for panel in row]) for row in rows])
    pixels = pixels.astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.ravel(), deep=True))
    writer = vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetQuality(88)
    writer.SetFileName(path)
    writer.Write()
