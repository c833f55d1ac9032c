# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Features of patches of 32 x 32 cells, of the relief alone: none tells where a patch lies, nor how high."""

import numpy as np
from ground_measures import CURVATURE_SCALES, aspect_share, curvature, skew, slopes_of, smooth

SIDE = 32
RIM = 2  # cells left out
STRIDE = 16
SMALL_STRIDE = 4  # of grounds with few patches
LINES = ((0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1))
LEVEL = np.radians(1.0)
#: Forms by the numbers of lower and of higher lines (Jasiewicz & Stepinski 2013), as of r.geomorphon.
FORMS = np.array([[1, 1, 1, 8, 8, 9, 9, 9, 10], [1, 1, 8, 8, 8, 9, 9, 9, 0], [1, 4, 6, 6, 7, 7, 9, 0, 0],
                  [4, 4, 6, 6, 6, 7, 0, 0, 0], [4, 4, 5, 6, 6, 0, 0, 0, 0], [3, 3, 5, 5, 0, 0, 0, 0, 0],
                  [3, 3, 3, 0, 0, 0, 0, 0, 0], [3, 3, 0, 0, 0, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0, 0, 0, 0]])


def geomorphons(heights, spacing, search):
    """Forms 1 to 10 of all cells; lines of sight end at the border and before `search` cells of the longer spacing."""
    counts = [max(1, int(np.ceil(search * max(spacing) / np.hypot(down * spacing[1], right * spacing[0]))) - 1)
              for down, right in LINES]
    rim = max(counts)
    padded = np.pad(heights, rim, constant_values=np.nan)
    lower, higher = np.zeros(heights.shape, int), np.zeros(heights.shape, int)
    rows, columns = heights.shape
    for (down, right), count in zip(LINES, counts):
        step = np.hypot(down * spacing[1], right * spacing[0])
        sights = [np.arctan((padded[rim + n * down:rim + n * down + rows,
                                    rim + n * right:rim + n * right + columns] - heights) / (n * step))
                  for n in range(1, count + 1)]
        most, least = np.fmax.reduce(sights), np.fmin.reduce(sights)
        flat = (np.abs(most) <= LEVEL) & (np.abs(least) <= LEVEL) | np.isnan(most)
        higher += ~flat & (most + least > 0.0)
        lower += ~flat & (most + least < 0.0)
    return FORMS[lower, higher]


def kurtosis(values):
    rest = values - values.mean()
    return (rest**4).mean() / (rest**2).mean() ** 2


def correlation(one, two):
    return np.mean((one - one.mean()) * (two - two.mean())) / (one.std() * two.std() + 1e-300)


def coherence(slopes):
    """Of the structure tensor: 0 where slopes have no axis, 1 where all have one."""
    return np.abs((slopes**2).sum()) / (np.abs(slopes) ** 2).sum()


def patches_of(shape, stride):
    return [(row, column) for row in range(0, shape[0] - SIDE + 1, stride)
            for column in range(0, shape[1] - SIDE + 1, stride)]


def patches_of_halves(shape, stride):
    """Corners of patches that lie in either half, across the longer side."""
    first = shape[0] >= shape[1]
    middle = max(shape) // 2
    return [[(row + (middle if first and half else 0), column + (middle if not first and half else 0))
             for row, column in patches_of((middle, shape[1]) if first else (shape[0], middle), stride)]
            for half in (0, 1)]


def features(heights, spacing, scale):
    """Rows of features of the patches in each half of a ground, and their names. scale: mean slope of the place."""
    stride = STRIDE if max(heights.shape) // 2 > 4 * SIDE else SMALL_STRIDE
    grounds = {cells: smooth(heights, cells) for cells in CURVATURE_SCALES}
    slopes = {cells: slopes_of(ground, spacing) for cells, ground in ((0, heights), *grounds.items())}
    bent = {cells: curvature(heights, spacing, cells, RIM) for cells in CURVATURE_SCALES}
    forms = {search: geomorphons(heights, spacing, search) for search in (3, 10)}
    shape = [count - 2 * RIM for count in heights.shape]
    names = []

    def row_of(row, column):
        def cut(values):
            aside = (values.shape[0] - shape[0]) // 2
            return values[aside + row:aside + row + SIDE, aside + column:aside + column + SIDE]

        found = {}
        for cells, of_scale in slopes.items():
            part = cut(of_scale)
            sizes = np.abs(part) / scale
            found[f"slope {cells}, mean"] = np.log(sizes.mean() + 1e-3)
            found[f"slope {cells}, variation"] = sizes.std() / (sizes.mean() + 1e-3)
            found[f"slope {cells}, skew"] = skew(sizes) if sizes.std() else 0.0
            found[f"slope {cells}, gentle"] = (sizes < 0.25 * sizes.mean()).mean()
            found[f"slope {cells}, coherence"] = coherence(part + 1e-12)
        for folds in (4, 8):
            found[f"aspects, {folds}-fold"] = aspect_share(cut(slopes[0]) + 1e-12, folds)
        for cells, of_scale in bent.items():
            part = cut(of_scale) * max(spacing) / scale
            found[f"curvature {cells}, deviation"] = np.log(part.std() + 1e-4)
            found[f"curvature {cells}, skew"] = skew(part) if part.std() else 0.0
            found[f"curvature {cells}, kurtosis"] = np.log(kurtosis(part)) if part.std() else 0.0
            found[f"curvature {cells} with slope"] = correlation(part, np.abs(cut(slopes[cells])))
            found[f"curvature {cells} with size of slope's"] = correlation(np.abs(part), np.abs(cut(slopes[cells])))
        found["curvature 1 over 2"] = found["curvature 1, deviation"] - found["curvature 2, deviation"]
        found["curvature 2 over 4"] = found["curvature 2, deviation"] - found["curvature 4, deviation"]
        for search, of_search in forms.items():
            shares = np.bincount(cut(of_search).ravel(), minlength=11)[1:] / SIDE**2
            for form, share in enumerate(shares, 1):
                found[f"form {form}, search {search}"] = share
        names[:] = found
        return list(found.values())

    return [np.array([row_of(*corner) for corner in half]) for half in patches_of_halves(shape, stride)], names
