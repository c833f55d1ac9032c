# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""A place averaged to a third and zoomed by 3 has its slopes and its drainage lines again.

    python3 TestZoom.py [FILE SPACING]...

Places: the Jacksboro fault; or heights as rows of text, with the spacing of both axes [m], which are shown alone. Slopes, Kolmogorov's distance, distances of channels and cubic convolution are NumPy's here;
areas are vtkDrainageFilter's without carving.
"""

import sys

import numpy as np

from littoral import vtkDrainageFilter, vtkTerrainZoomFilter
from littoral.elevation import array_from_image, image_from_array, read_elevation

FACTOR = 3


def along_rows(values):
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


def slopes_of(heights, spacing):
    y, x = (heights[2:, 1:-1] - heights[:-2, 1:-1]), (heights[1:-1, 2:] - heights[1:-1, :-2])
    return np.hypot(x / (2 * spacing[0]), y / (2 * spacing[1])).ravel()


def distance(one, two):
    """Kolmogorov's, of two samples."""
    both = np.concatenate([one, two])
    shares = [np.searchsorted(np.sort(sample), both, "right") / sample.size for sample in (one, two)]
    return np.abs(shares[0] - shares[1]).max()


def channels(heights, spacing, cells):
    drainage = vtkDrainageFilter()
    drainage.SetInputData(image_from_array(heights, spacing))
    drainage.CarveOff()
    drainage.Update()
    areas = array_from_image(drainage.GetOutput(), "DrainageArea")
    return np.argwhere(areas >= 0.999 * cells * spacing[0] * spacing[1]).astype(float)


def offset(these, others):
    """Root mean square of the distances to the nearest others."""
    nearest = [((others - one) ** 2).sum(1).min() for one in these] if others.size else []
    return np.sqrt(np.mean(nearest)) if nearest else np.nan


def show(place, spacing):
    """Prints what comes back, cubic convolution first; the zoomed ground's ratios of slopes, both offsets, distances."""
    rows, columns = (FACTOR * (count // FACTOR) for count in place.shape)
    place = place[:rows, :columns]
    coarse = place.reshape(rows // FACTOR, FACTOR, columns // FACTOR, FACTOR).mean((1, 3))
    zoom = vtkTerrainZoomFilter()
    zoom.SetInputData(image_from_array(coarse, [FACTOR * one for one in spacing]))
    zoom.SetFactor(FACTOR)
    zoom.Update()
    zoomed = array_from_image(zoom.GetOutput())
    means = zoomed.reshape(coarse.shape[0], FACTOR, coarse.shape[1], FACTOR).mean((1, 3))
    padded = np.pad(coarse, 1, mode="edge")
    around = np.array([padded[y:y + coarse.shape[0], x:x + coarse.shape[1]] for y in range(3) for x in range(3)])
    assert (np.abs(means - coarse) <= 0.5 * np.ptp(around, axis=0) + 1e-6).all()
    wanted = slopes_of(place, spacing)
    offsets, distances = [], []
    for ground in (along_rows(along_rows(coarse).T).T, zoomed):
        got = slopes_of(ground, spacing)
        ratios = [np.quantile(got, part) / np.quantile(wanted, part) for part in (0.1, 0.5, 0.9, 0.99)]
        ratios.append(got.mean() / wanted.mean())
        distances.append(distance(got, wanted))
        offsets.append([offset(channels(ground, spacing, cells), channels(place, spacing, cells))
                        for cells in (100, 300, 1000)])
        print(f"offsets {np.round(offsets[-1], 2)} cells, quantiles and mean of slopes {np.round(ratios, 3)}, "
              f"distance {distances[-1]:.3f}")
    return np.array(ratios), offsets, distances


for name, step in zip(sys.argv[1::2], sys.argv[2::2]):
    print(name)
    show(np.loadtxt(name), (float(step), float(step)))
if len(sys.argv) == 1:
    image = read_elevation()
    slopes, offsets, distances = show(array_from_image(image).astype(float), image.GetSpacing()[:2])
    assert (abs(slopes - 1.0) < 0.1).all()
    assert distances[1] < 0.5 * distances[0]
    assert offsets[1][2] < 0.75 * offsets[0][2]
