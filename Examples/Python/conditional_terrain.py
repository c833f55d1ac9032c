# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""Measure a place at 600 points, and make fields through them.

    python3 conditional_terrain.py [FOLDER [ELEVATION_MODEL]] [--quick]

ELEVATION_MODEL: .npz, .vti, .dem or GeoTIFF; default: the Jacksboro fault, Tennessee. Writes
conditional.jpg into FOLDER: the place; the survey; the kriging estimate; two conditional fields;
the kriging standard deviation. --quick, for a test, takes every third height along each axis.
"""

import os
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkJPEGWriter

from littoral import vtkConditionalTerrainFilter, vtkCovarianceFitFilter
from littoral.elevation import JACKSBORO, array_from_image, image_from_array, read_elevation
from littoral.tables import column

words = [word for word in sys.argv[1:] if word != "--quick"]
folder = words[0] if words else tempfile.mkdtemp(prefix="littoral-")
place = read_elevation(words[1] if len(words) > 1 else JACKSBORO)
if "--quick" in sys.argv:
    place = image_from_array(array_from_image(place)[::3, ::3], [3.0 * side for side in place.GetSpacing()[:2]])
os.makedirs(folder, exist_ok=True)
heights = array_from_image(place).astype(float)
spacing = place.GetSpacing()[:2]

# A survey: 600 points of the place, with their heights.
random = np.random.default_rng(2)
spots = random.permutation(heights.size)[:600]
rows, columns = spots // heights.shape[1], spots % heights.shape[1]
origin = np.array(place.GetOrigin()[:2])
points = vtkPoints()
points.SetDataTypeToDouble()
points.SetData(numpy_to_vtk(np.column_stack(
    [origin[0] + spacing[0] * columns, origin[1] + spacing[1] * rows, heights[rows, columns]]), deep=True))
survey = vtkPolyData()
survey.SetPoints(points)  # without an array: z is the height

# Roughness of the place, which so few heights do not tell well.
fit = vtkCovarianceFitFilter()
fit.SetInputData(place)

conditional = vtkConditionalTerrainFilter()
conditional.SetInputData(survey)
conditional.SetInputData(1, place)
conditional.SetInputConnection(2, fit.GetOutputPort(0))
fields = []
for seed in 1, 2:
    conditional.SetSeed(seed)
    conditional.Update()
    fields.append(array_from_image(conditional.GetOutput()).copy())
    table = conditional.GetOutputDataObject(1)
    miss = np.abs(column(table, "Field") - column(table, "Value")).max()
    print(f"seed {seed}: the field misses the data by at most {miss:.1e} m")

conditional.SetResultToKrigingEstimate()
conditional.KrigingVarianceOn()
conditional.CrossValidationOn()
conditional.Update()
kriged = array_from_image(conditional.GetOutput()).copy()
deviation = np.sqrt(array_from_image(conditional.GetOutput(), "KrigingVariance"))
told = conditional.GetOutputDataObject(1).GetFieldData()
print("model", told.GetAbstractArray("Model").GetValue(0),
      "range", round(told.GetArray("Range").GetValue(0)), "m")
print("each datum from the others: off by",
      round(told.GetArray("RootMeanSquareError").GetValue(0)), "m (root mean square)")
print("the estimate is off by", round(np.sqrt(((kriged - heights)**2).mean())), "m over the whole place,",
      "a conditional field by", round(np.sqrt(((fields[0] - heights)**2).mean())), "m")


def colored(surface):
    """Colors by height."""
    stops = np.array([[94, 122, 78], [150, 160, 100], [196, 176, 126], [150, 120, 96], [236, 232, 226]]) / 255.0
    part = np.clip((surface - heights.min()) / np.ptp(heights), 0.0, 1.0) * (len(stops) - 1)
    return np.stack([np.interp(part, range(len(stops)), stops[:, k]) for k in range(3)], axis=-1)


def shaded(surface):
    """The same with light from the upper left."""
    rise_y, rise_x = np.gradient(surface, spacing[1], spacing[0])
    light = (1.0 + 2.5 * (rise_x - rise_y)) / np.sqrt(1.0 + 6.25 * (rise_x**2 + rise_y**2)) / 1.3
    return np.clip(colored(surface) * np.clip(light, 0.35, 1.25)[..., None], 0.0, 1.0)


known = np.full((*heights.shape, 3), 0.97)
colors = colored(heights)
for row, across in zip(rows, columns):
    known[max(0, row - 2):row + 3, max(0, across - 2):across + 3] = colors[row, across]
gray = np.repeat((1.0 - 0.8 * deviation / deviation.max())[..., None], 3, axis=-1)
panels = [[shaded(heights), known, shaded(kriged)], [shaded(fields[0]), shaded(fields[1]), gray]]
gap = np.ones((heights.shape[0], 8, 3))
lines = [np.hstack([line[0], gap, line[1], gap, line[2]]) for line in panels[::-1]]
pixels = (255.0 * np.vstack([lines[0], np.ones((8, lines[0].shape[1], 3)), lines[1]])).astype(np.uint8)
picture = vtkImageData()
picture.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
picture.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
writer = vtkJPEGWriter()
writer.SetInputData(picture)
writer.SetQuality(85)
writer.SetFileName(os.path.join(folder, "conditional.jpg"))
writer.Write()
print("conditional.jpg is in", folder)
