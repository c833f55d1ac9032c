# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How near a zoomed ground is to the place whose means it was zoomed from.

Grids of heights [m] are [row, column], with spacings (x, y) [m]. Cubic convolution, slopes and distances are NumPy's
here; drainage areas are vtkDrainageFilter's without carving, and what zooms is vtkTerrainZoomFilter.
"""

import numpy as np

from littoral import vtkDrainageFilter, vtkTerrainZoomFilter
from littoral.elevation import array_from_image, image_from_array

FACTOR = 3
CHANNELS = (100, 300, 1000)  # least drainage areas of channels [fine cells]
QUANTILES = (0.1, 0.5, 0.9, 0.99)  # of slopes


def whole_blocks(place):
    """The place without rows and columns that make no whole coarse cell."""
    rows, columns = (FACTOR * (count // FACTOR) for count in place.shape)
    return place[:rows, :columns]


def block_means(heights):
    rows, columns = heights.shape
    return heights.reshape(rows // FACTOR, FACTOR, columns // FACTOR, FACTOR).mean((1, 3))


def cubic_rows(values):
    """Cubic convolution at thirds between columns, which go on by reflection in the points of the edge."""
    before, after = 2 * values[:, :1] - values[:, 2:0:-1], 2 * values[:, -1:] - values[:, -2:-4:-1]
    wide = np.hstack([before, values, after])
    fine = np.empty((values.shape[0], FACTOR * values.shape[1]))
    for n in range(FACTOR):
        place = (n + 0.5) / FACTOR - 0.5
        t, first = place % 1.0, int(np.floor(place)) + 1
        weights = 0.5 * np.array([-t**3 + 2 * t**2 - t, 3 * t**3 - 5 * t**2 + 2, -3 * t**3 + 4 * t**2 + t, t**3 - t**2])
        parts = [weight * wide[:, first + k:first + k + values.shape[1]] for k, weight in enumerate(weights)]
        fine[:, n::FACTOR] = sum(parts)
    return fine


def cubic(coarse):
    return cubic_rows(cubic_rows(coarse).T).T


def zoomed(coarse, spacing):
    """vtkTerrainZoomFilter's, with all properties as they are; spacing: of the fine cells."""
    zoom = vtkTerrainZoomFilter()
    zoom.SetInputData(image_from_array(coarse, [FACTOR * one for one in spacing]))
    zoom.SetFactor(FACTOR)
    zoom.Update()
    return array_from_image(zoom.GetOutput())


def long_waves(heights):
    """The heights' waves that are longer than two coarse cells along both axes, on the grid mirrored at its edges: all
    that any coarse grid of that spacing can tell, and more than means of cells do."""
    whole = np.block([[heights, heights[:, ::-1]], [heights[::-1], heights[::-1, ::-1]]])
    y, x = np.meshgrid(*(np.fft.fftfreq(count) for count in whole.shape), indexing="ij")
    kept = np.fft.fft2(whole) * (np.maximum(np.abs(x), np.abs(y)) <= 0.5 / FACTOR)
    return np.fft.ifft2(kept).real[:heights.shape[0], :heights.shape[1]]


def steepness(heights, spacing):
    """Sizes of the slopes of inner cells."""
    y, x = (heights[2:, 1:-1] - heights[:-2, 1:-1]), (heights[1:-1, 2:] - heights[1:-1, :-2])
    return np.hypot(x / (2 * spacing[0]), y / (2 * spacing[1])).ravel()


def slope_ratios(got, wanted):
    """Quantiles of slopes and their mean, over those wanted; NaN where none is wanted."""
    ratios = [(np.quantile(got, part), np.quantile(wanted, part)) for part in QUANTILES]
    ratios.append((got.mean(), wanted.mean()))
    return np.array([is_ / shall if shall > 0.0 else np.nan for is_, shall in ratios])


def channels(heights, spacing, cells):
    """Rows and columns of the cells into which so many drain."""
    drainage = vtkDrainageFilter()
    drainage.SetInputData(image_from_array(heights, spacing))
    drainage.CarveOff()
    drainage.Update()
    areas = array_from_image(drainage.GetOutput(), "DrainageArea")
    return np.argwhere(areas >= 0.999 * cells * spacing[0] * spacing[1]).astype(float)


def offset(these, others):
    """Root mean square of the distances to the nearest others [cells]; NaN where one has none."""
    nearest = [((others - one) ** 2).sum(1).min() for one in these] if others.size else []
    return np.sqrt(np.mean(nearest)) if nearest else np.nan


def offsets(heights, place, spacing):
    """For each of CHANNELS: how far the ground's channels are from the place's, and the place's from the ground's."""
    pairs = [(channels(heights, spacing, cells), channels(place, spacing, cells)) for cells in CHANNELS]
    return np.array([(offset(here, there), offset(there, here)) for here, there in pairs])
