# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=1
# run-with: python3 tier=all
"""Twins with valleys have the measures of their place, within the tolerances of the design.

    python3 TestValleys.py [SEED...]

Places: the Jacksboro fault; and R's `volcano` and the Kagwene sanctuary of its package
spatstat.data, where R and the package are there. Seeds: 1 and 2, or those that are given. Heights,
semivariance, curvature and depressions are measured here, by NumPy and a flood of its own; the
concavity by vtkGroundStatisticsFilter.
"""

import heapq
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

from littoral import (
    vtkCovarianceFitFilter,
    vtkDrainageFilter,
    vtkGroundStatisticsFilter,
    vtkTurningBandsTerrainSource,
)
from littoral.elevation import array_from_image, image_from_array, read_elevation
from littoral.tables import column

SEEDS = [int(seed) for seed in sys.argv[1:]] or [1, 2]

#: Rows from south to north. Of Kagwene, the largest part without holes.
SCRIPT = """
write.table(volcano, "volcano.txt", row.names = FALSE, col.names = FALSE)
if (requireNamespace("spatstat.data", quietly = TRUE)) {
  kagwene <- spatstat.data::gorillas.extra$elevation$v[20:141, 35:153]
  write.table(kagwene, "kagwene.txt", row.names = FALSE, col.names = FALSE)
}
"""


def places():
    """Names, images."""
    yield "Jacksboro", read_elevation()
    if not shutil.which("Rscript"):
        print("without R: Jacksboro alone")
        return
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["Rscript", "-e", SCRIPT], cwd=folder, check=True)
        for name, spacing in (("volcano", 10.0), ("kagwene", 30.70955)):
            path = os.path.join(folder, name + ".txt")
            if os.path.exists(path):
                yield name, image_from_array(np.loadtxt(path), (spacing, spacing))


def depression_fraction(heights):
    """Share of the cells that water must cover before it can leave over the border."""
    ground, columns = heights.ravel().tolist(), heights.shape[1]
    dry = np.ones(heights.shape, bool)
    dry[1:-1, 1:-1] = False
    rim = [(ground[cell], cell) for cell in np.flatnonzero(dry).tolist()]
    reached, sunk = bytearray(dry.tobytes()), 0
    steps = [step + across for step in (-columns, 0, columns) for across in (-1, 0, 1)]
    heapq.heapify(rim)
    while rim:
        water, cell = heapq.heappop(rim)
        for step in steps:
            near = cell + step
            if 0 <= near < len(ground) and not reached[near]:
                reached[near] = 1
                sunk += water > ground[near]
                heapq.heappush(rim, (max(water, ground[near]), near))
    return sunk / len(ground)


def skew(values):
    rest = values - values.mean()
    return (rest**3).mean() / (rest**2).mean() ** 1.5


def semivariances(heights):
    """Along x and y, at lags from 1 to 100 cells or half the shorter side."""
    lags = np.unique(np.geomspace(1, min(100, min(heights.shape) // 2), 24).astype(int))
    result = []
    for lag in lags:
        along = heights[:, lag:] - heights[:, :-lag]
        across = heights[lag:] - heights[:-lag]
        result.append(0.5 * np.mean(np.concatenate([along.ravel() ** 2, across.ravel() ** 2])))
    return np.array(result)


def curvature(heights, spacing):
    inner = 2.0 * heights[1:-1, 1:-1]
    return ((heights[1:-1, 2:] + heights[1:-1, :-2] - inner) / spacing[0] ** 2
            + (heights[2:, 1:-1] + heights[:-2, 1:-1] - inner) / spacing[1] ** 2)


def measures(image):
    """Depressions, integral, skewness of heights, concavity, skewness of curvature, variogram."""
    heights = array_from_image(image).astype(float)
    statistics = vtkGroundStatisticsFilter()
    statistics.SetInputData(image)
    statistics.Update()
    integral = (heights.mean() - heights.min()) / np.ptp(heights)
    concavity = column(statistics.GetOutputDataObject(0), "Concavity")[0]
    return (depression_fraction(heights), integral, skew(heights), concavity,
            skew(curvature(heights, image.GetSpacing())), semivariances(heights))


for name, place in places():
    sunk, integral, height_skew, concavity, _, variogram = measures(place)
    fit = vtkCovarianceFitFilter()
    fit.SetInputData(place)
    twin = vtkTurningBandsTerrainSource()
    twin.SetInputConnection(fit.GetOutputPort(0))
    twin.SetWholeExtent(place.GetExtent())
    twin.SetOrigin(place.GetOrigin())
    twin.SetSpacing(place.GetSpacing())
    drainage = vtkDrainageFilter()
    drainage.SetInputConnection(twin.GetOutputPort())
    drainage.SetInputData(1, place)
    for seed in SEEDS:
        twin.SetSeed(seed)
        drainage.Update()
        got = measures(drainage.GetOutput())
        ratios = got[5] / variogram
        print(f"{name} {seed}: sunk {got[0]:.3f} ({sunk:.3f}), integral {got[1]:.3f} "
              f"({integral:.3f}), skew {got[2]:.2f} ({height_skew:.2f}), concavity {got[3]:.2f} "
              f"({concavity:.2f}), curvature {got[4]:.2f}, semivariance {ratios.min():.2f} to "
              f"{ratios.max():.2f}")
        assert got[0] <= max(0.05, sunk)
        assert abs(got[1] - integral) <= 0.03
        assert abs(got[2] - height_skew) <= 0.15
        assert abs(got[3] - concavity) <= 0.10
        assert abs(got[4]) <= 1.0
        assert 0.9 <= ratios.min() and ratios.max() <= 1.1
