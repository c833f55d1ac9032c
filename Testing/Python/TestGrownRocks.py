# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""A twin of the Jacksboro fault of two rocks, or under two uplifts, has rivers as steep as stream power says.

Steepness S A^0.45 of cells to which 100 drain, its mean in the western half over that in the eastern: doubling the
uplift of the west, or halving its erodibility, shall double it over both. What differs between the halves by chance is
left out by the inverse: the ratio of the two is 4.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, read_elevation, twin_of

PLACE = read_elevation()
TERRAIN = twin_of(PLACE)
WIDTH, HEIGHT, _ = TERRAIN.GetDimensions()
IS_WEST = np.arange(WIDTH) < WIDTH // 2


def contrast(name, factor):
    """Mean steepness, and mean slope, in the west over those in the east."""
    values = numpy_to_vtk(np.tile(np.where(IS_WEST, factor, 1.0), HEIGHT), deep=True)
    values.SetName(name)
    terrain = TERRAIN.NewInstance()
    terrain.ShallowCopy(TERRAIN)
    terrain.GetPointData().AddArray(values)
    drainage = vtkDrainageFilter()
    drainage.SetInputData(terrain)
    drainage.SetInputData(1, PLACE)
    drainage.SetMethodToGrowth()
    drainage.UseRockOn()
    drainage.Update()
    ground = drainage.GetOutput()
    heights = array_from_image(ground).astype(float)
    areas, directions = (vtk_to_numpy(ground.GetPointData().GetArray(each)).reshape(HEIGHT, WIDTH)
                         for each in ("DrainageArea", "FlowDirection"))
    dx, dy = ground.GetSpacing()[:2]
    j, i = np.nonzero((directions >= 0) & (areas >= 100 * dx * dy))
    steps = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)])[directions[j, i]]
    falls = heights[j, i] - heights[j + steps[:, 1], i + steps[:, 0]]
    steepness = falls / np.hypot(dx * steps[:, 0], dy * steps[:, 1]) * areas[j, i] ** 0.45
    slopes = np.hypot(*np.gradient(heights, dy, dx))
    west = IS_WEST[i]
    return np.array([steepness[west].mean() / steepness[~west].mean(),
                     slopes[:, IS_WEST].mean() / slopes[:, ~IS_WEST].mean()])


for name, power in (("UpliftFactor", 1.0), ("Erodibility", -1.0)):
    rivers, slopes = contrast(name, 2.0**power) / contrast(name, 0.5**power)
    print(f"{name}: steepness of rivers {rivers:.2f}, slopes {slopes:.2f}")
    assert 4.0 / 1.6 < rivers < 4.0 * 1.6, (name, rivers)
    assert 1.5 < slopes < 5.0, (name, slopes)
