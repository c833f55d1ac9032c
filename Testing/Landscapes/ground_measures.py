# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What tells a place from a random surface, as numbers.

Grids of heights [m] are [row, column], with spacings (x, y) [m].

Aspects, slopes, curvature and heights are NumPy's here. Flow, channels and geomorphons are those of
vtkGroundStatisticsFilter, which tests hold to closed forms, to SAGA and to GRASS.
"""

import numpy as np

from littoral import vtkDrainageFilter, vtkGroundStatisticsFilter
from littoral.elevation import array_from_image, image_from_array
from littoral.tables import column

CURVATURE_SCALES = (1, 2, 4)  # cells
SEARCHES = (3, 10, 30)  # cells
FINE_STREAMS = 20  # cells; of 100 small grids have too few streams for ratios that stay when they are turned
HORTON = ("BifurcationRatio", "LengthRatio", "AreaRatio")
DIRECTIONS = ((0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1))  # rows and columns
STRAIGHT_RUN = 12  # cells


def slopes_of(heights, spacing):
    """Gradients of the inner cells, x + iy."""
    x = (heights[1:-1, 2:] - heights[1:-1, :-2]) / (2 * spacing[0])
    y = (heights[2:, 1:-1] - heights[:-2, 1:-1]) / (2 * spacing[1])
    return x + 1j * y


def aspect_share(slopes, folds):
    """|sum s exp(i n a)| / sum s."""
    sizes = np.abs(slopes)
    return abs((sizes * np.exp(1j * folds * np.angle(slopes))).sum()) / sizes.sum()


def distance(one, two):
    """Kolmogorov's, of two samples."""
    both = np.concatenate([one.ravel(), two.ravel()])
    shares = [np.searchsorted(np.sort(sample.ravel()), both, "right") / sample.size for sample in (one, two)]
    return np.abs(shares[0] - shares[1]).max()


def block_variation(sizes):
    """Deviation over mean of mean slopes of squares, a tenth of the shorter side."""
    side = min(sizes.shape) // 10
    rows, columns = sizes.shape[0] // side, sizes.shape[1] // side
    means = sizes[:rows * side, :columns * side].reshape(rows, side, columns, side).mean((1, 3))
    return means.std() / means.mean()


def skew(values):
    rest = values - values.mean()
    return (rest**3).mean() / (rest**2).mean() ** 1.5


def smooth(heights, cells):
    """Gauss filter of so many cells, on the grid that is mirrored at its edges."""
    whole = np.block([[heights, heights[:, ::-1]], [heights[::-1], heights[::-1, ::-1]]])
    y, x = np.meshgrid(*(2 * np.pi * np.fft.fftfreq(n) for n in whole.shape), indexing="ij")
    waves = np.fft.fft2(whole) * np.exp(-0.5 * cells**2 * (x**2 + y**2))
    return np.fft.ifft2(waves).real[:heights.shape[0], :heights.shape[1]]


def curvature(heights, spacing, cells, rim=None):
    """Five-point Laplacian after a Gauss filter, without a rim: default, of twice its cells."""
    ground = smooth(heights, cells)
    inner = 2.0 * ground[1:-1, 1:-1]
    bent = ((ground[1:-1, 2:] + ground[1:-1, :-2] - inner) / spacing[0] ** 2
            + (ground[2:, 1:-1] + ground[:-2, 1:-1] - inner) / spacing[1] ** 2)
    rim = (2 * cells if rim is None else rim) - 1
    return bent[rim:-rim, rim:-rim]


def lags_of(heights):
    """From 1 to 100 cells or half the shorter side."""
    return np.unique(np.geomspace(1, min(100, min(heights.shape) // 2), 24).astype(int))


def semivariances(heights, lags):
    """Along x and y."""
    pairs = [((heights[:, lag:] - heights[:, :-lag]), (heights[lag:] - heights[:-lag])) for lag in lags]
    return np.array([0.5 * np.mean(np.concatenate([x.ravel() ** 2, y.ravel() ** 2])) for x, y in pairs])


def statistics(heights, spacing, threshold=100, search=10):
    """vtkGroundStatisticsFilter, updated."""
    filter_ = vtkGroundStatisticsFilter()
    filter_.SetInputData(image_from_array(heights, spacing))
    filter_.SetStreamThreshold(threshold)
    filter_.SetSearchRadius(search)
    filter_.Update()
    return filter_


def drained(heights, spacing):
    """Heights to which water fills depressions, and drainage areas [cells]."""
    drainage = vtkDrainageFilter()
    drainage.SetInputData(image_from_array(heights, spacing))
    drainage.CarveOff()
    drainage.Update()
    depths, areas = (array_from_image(drainage.GetOutput(), name) for name in ("DepressionDepth", "DrainageArea"))
    return heights + depths, areas / (spacing[0] * spacing[1])


def shifted(values, rows, columns, outside):
    """Values of the cells so many rows and columns on."""
    result = np.full_like(values, outside)
    here, there = (tuple(slice(max(0, way * step), size + min(0, way * step))
                         for step, size in zip((rows, columns), values.shape)) for way in (-1, 1))
    result[here] = values[there]
    return result


def trunk_valleys(heights, areas):
    """Cells of rivers of a fiftieth of the map with its highest quarter within a twelfth of its side, six ways."""
    high = heights >= np.quantile(heights, 0.75)
    ways = np.zeros(heights.shape, int)
    for row, column in DIRECTIONS:
        reach = round(min(heights.shape) / 12 / np.hypot(row, column))
        ways += np.any([shifted(high, n * row, n * column, False) for n in range(1, reach + 1)], axis=0)
    return ((areas >= heights.size / 50) & (ways >= 6)).sum() / np.sqrt(heights.size)


def straight_streams(heights, areas, spacing):
    """Share of the cells of streams of 100 cells and more in straight runs between banks.

    Banks are two cells off and higher by a tenth of the mean slope.
    """
    falls = np.array([(heights - shifted(heights, *step, np.inf)) / np.hypot(step[0] * spacing[1], step[1] * spacing[0])
                      for step in DIRECTIONS])
    streams = (areas >= 100) & (falls.max(0) > 0)
    bank = 0.2 * np.abs(slopes_of(heights, spacing)).mean() * np.sqrt(spacing[0] * spacing[1])
    found = 0
    for way, (row, column) in enumerate(DIRECTIONS):
        along = streams & (falls.argmax(0) == way)
        starts = np.all([shifted(along, n * row, n * column, False) for n in range(STRAIGHT_RUN)], axis=0)
        runs = np.any([shifted(starts, -n * row, -n * column, False) for n in range(STRAIGHT_RUN)], axis=0)
        for side in (-2, 2):
            runs &= shifted(heights, side * column, -side * row, np.inf) > heights + bank
        found += runs.sum()
    return found / max(1, streams.sum())


def form_shares(heights, spacing, search):
    return np.array(column(statistics(heights, spacing, search=search).GetOutput(4), "Share"))


def halves(heights):
    """The two halves of a grid, across its longer side."""
    if heights.shape[0] < heights.shape[1]:
        middle = heights.shape[1] // 2
        return heights[:, :middle], heights[:, middle:]
    middle = heights.shape[0] // 2
    return heights[:middle], heights[middle:]


def ground_measures(heights, spacing, lags=None):
    """A dictionary of numbers and arrays; semivariances at lags [cells], default lags_of() it."""
    slopes = slopes_of(heights, spacing)
    sizes = np.abs(slopes)
    result = {
        "four": aspect_share(slopes, 4), "eight": aspect_share(slopes, 8), "slopes": sizes.ravel(),
        "gentle": (sizes < 0.25 * sizes.mean()).mean(), "blocks": block_variation(sizes),
        "integral": (heights.mean() - heights.min()) / np.ptp(heights), "skew": skew(heights),
        "semivariance": semivariances(heights, lags_of(heights) if lags is None else lags)}
    for cells in CURVATURE_SCALES:
        bent = curvature(heights, spacing, cells)
        result[f"curved{cells}"], result[f"bent{cells}"] = bent.std(), skew(bent)
    raw = statistics(heights, spacing)
    first = raw.GetOutput(0)
    result["sunk"] = column(first, "DepressionFraction")[0]
    finer = statistics(heights, spacing, FINE_STREAMS).GetOutput(0)
    result["horton"] = np.array([column(finer, name)[0] for name in HORTON])
    result["hack"] = column(first, "HackExponent")[0]
    threshold = 1000 if heights.size >= 100000 else 100
    relief = statistics(heights, spacing, threshold).GetOutput(5)
    result["relief"] = np.array(column(relief, "Height")) / heights.std()
    full, areas = drained(heights, spacing)
    result["trunks"], result["straight"] = trunk_valleys(full, areas), straight_streams(full, areas, spacing)
    full = statistics(full, spacing)
    first = full.GetOutput(0)
    result["concavity"], result["density"] = (column(first, name)[0] for name in ("Concavity", "DrainageDensity"))
    profile = full.GetOutput(1)
    result["profile"] = np.array([column(profile, name) for name in ("DrainageArea", "Slope")])
    for search in SEARCHES:
        result[f"forms{search}"] = form_shares(heights, spacing, search)
    return result
