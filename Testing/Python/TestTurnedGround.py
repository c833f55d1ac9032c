# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3
"""Statistics of the same ground are the same: turned by a quarter, mirrored, in other units, and without its rim; and its
streams are those of its drainage."""

import numpy as np

from littoral import vtkDrainageFilter, vtkGroundStatisticsFilter
from littoral.elevation import array_from_image, image_from_array, read_elevation
from littoral.tables import column

STREAMS = 20  # cells
FOOT = 0.3048  # m
#: Powers of the unit of length; others have none.
UNITS = {"ElevationStandardDeviation": 1, "CurvatureStandardDeviation": -1, "HeadArea": 2, "DrainageDensity": -1}
RIM = 0.025  # of a side
RATIOS = ("BifurcationRatio", "LengthRatio", "AreaRatio")


def measured(filter_, heights, spacing):
    filter_.SetInputData(image_from_array(np.ascontiguousarray(heights), spacing))
    filter_.SetStreamThreshold(STREAMS)
    filter_.Update()
    return filter_


def numbers(heights, spacing):
    table = measured(vtkGroundStatisticsFilter(), heights, spacing).GetOutput(0)
    found = {table.GetColumnName(n): table.GetColumn(n).GetTuple1(0) for n in range(table.GetNumberOfColumns())}
    del found["Steepness"]  # for an area of 1 m2, by the concavity, on which its unit depends
    return found


place = read_elevation()
heights, spacing = array_from_image(place).astype(float), place.GetSpacing()[:2]
known = numbers(heights, spacing)
assert not any(np.isnan(value) for value in known.values()), known

for name, same in (("turned", numbers(heights[::-1].T, spacing[::-1])), ("mirrored", numbers(heights[:, ::-1], spacing))):
    # Of equal ways on flats the first direction is taken
    off = {key: abs(same[key] / value - 1.0) for key, value in known.items()}
    assert max(off.values()) < 0.1, (name, off)

feet = numbers(heights / FOOT, [side / FOOT for side in spacing])
for key, value in known.items():
    assert abs(feet[key] * FOOT ** UNITS.get(key, 0) / value - 1.0) < 1e-5, (key, feet[key], value)

rows, columns = (int(RIM * size) for size in heights.shape)
inner = numbers(heights[rows:-rows, columns:-columns], spacing)
for key in ("DrainageDensity", *RATIOS):
    assert abs(inner[key] / known[key] - 1.0) < 0.1, (key, inner[key], known[key])

streams = column(measured(vtkGroundStatisticsFilter(), heights, spacing).GetOutput(3), "Streams")
drainage = vtkDrainageFilter()
drainage.CarveOff()
rivers = measured(drainage, heights, spacing).GetOutputDataObject(1)
assert rivers.GetNumberOfCells() == sum(streams), (rivers.GetNumberOfCells(), streams)
print("the same ground has the same statistics")
