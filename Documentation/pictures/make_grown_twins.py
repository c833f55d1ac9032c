# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw grown-twins.jpg: the Jacksboro fault and grown twins of it as hillshades, each lit from two sides.

    ./littoral run python3 Documentation/pictures/make_grown_twins.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, read_elevation, twin_of

EXAGGERATION = 2.0
SUN_ELEVATION = 40.0  # degrees
AZIMUTHS = (315.0, 60.0)  # degrees from north
GAP = 4  # pixels


def grown(place, seed):
    drainage = vtkDrainageFilter()
    drainage.SetInputData(twin_of(place, seed))
    drainage.SetInputData(1, place)
    drainage.SetSeed(seed)
    drainage.GrowOn()
    drainage.Update()
    return array_from_image(drainage.GetOutput())


def hillshade(heights, spacing, azimuth):
    """Lambert's law, 0 to 255, rows from south to north."""
    y, x = np.gradient(EXAGGERATION * heights, spacing[1], spacing[0])
    sun, elevation = np.radians(azimuth), np.radians(SUN_ELEVATION)
    light = np.sin(elevation) - np.cos(elevation) * (np.sin(sun) * x + np.cos(sun) * y)
    return 255.0 * np.clip(light / np.sqrt(1.0 + x**2 + y**2), 0.0, 1.0)


place = read_elevation()
spacing = place.GetSpacing()
grounds = [array_from_image(place).astype(float), grown(place, 1), grown(place, 2)]
rows = [np.hstack([np.pad(hillshade(ground, spacing, azimuth), GAP, constant_values=255) for ground in grounds])
        for azimuth in reversed(AZIMUTHS)]
pixels = np.vstack(rows).astype(np.uint8)
image = vtkImageData()
image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
image.GetPointData().SetScalars(numpy_to_vtk(pixels.ravel(), deep=True))
writer = vtkJPEGWriter()
writer.SetInputData(image)
writer.SetQuality(88)
writer.SetFileName(os.path.join(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(__file__), "grown-twins.jpg"))
writer.Write()
