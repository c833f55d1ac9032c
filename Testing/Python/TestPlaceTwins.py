# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=window
# run-with: python3 tier=all
"""Grown and quilted twins have the slopes, curvature, variogram and heights of their place, and no grain of the grid.

    python3 TestPlaceTwins.py [window | SEED...]

Place: the Jacksboro fault, or its middle with `window`. The fitted model is rounded to four digits: a fit ends in other
digits with another mathematical library, and growth makes another twin of each. All is measured here by NumPy: shares
of four- and eight-fold symmetry in the aspects, Kolmogorov's distance of slopes against that of the Gaussian twin,
gentle slopes, means of blocks, curvature at two cells, semivariance, heights, cells in depressions; and of the whole place, quilted, slopes of
rivers by drainage area on filled ground (Ground Statistics).
"""

import sys
from itertools import product
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkTable

from littoral import vtkCovarianceFitFilter, vtkDrainageFilter, vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image, image_from_array, read_elevation
from littoral.tables import column

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Landscapes"))
from ground_gates import steepness_ratio  # noqa: E402
from ground_measures import (  # noqa: E402
    aspect_share, block_variation, distance, drained, lags_of, semivariances, skew, slopes_of, statistics)

WINDOW = sys.argv[1:] == ["window"]
SEEDS = [1] if WINDOW else [int(seed) for seed in sys.argv[1:]] or [1, 2, 3]


def rounded(table):
    """The table with all numbers of its rows rounded to four digits."""
    copy = vtkTable()
    copy.DeepCopy(table)
    for n in range(copy.GetNumberOfColumns()):
        numbers = copy.GetColumn(n)
        for row in range(copy.GetNumberOfRows() if numbers.IsA("vtkDoubleArray") else 0):
            numbers.SetValue(row, float(f"{numbers.GetValue(row):.4g}"))
    return copy


def curvature_deviation(heights, spacing):
    """Of the Laplacian after a Gauss filter of two cells, by its Fourier transform on the mirrored grid."""
    whole = np.block([[heights, heights[:, ::-1]], [heights[::-1], heights[::-1, ::-1]]])
    y, x = np.meshgrid(*(2 * np.pi * np.fft.fftfreq(n) for n in whole.shape), indexing="ij")
    waves = np.fft.fft2(whole) * np.exp(-2.0 * (x**2 + y**2))
    waves *= (2 * np.cos(x) - 2) / spacing[0] ** 2 + (2 * np.cos(y) - 2) / spacing[1] ** 2
    return np.fft.ifft2(waves).real[4:heights.shape[0] - 4, 4:heights.shape[1] - 4].std()


def rivers(heights):
    """Concavity, and mean slopes by drainage area."""
    full = statistics(drained(heights, spacing)[0], spacing)
    return {"concavity": column(full.GetOutput(0), "Concavity")[0],
            "profile": np.array([column(full.GetOutput(1), name) for name in ("DrainageArea", "Slope")])}


place = read_elevation()
spacing = place.GetSpacing()[:2]
if WINDOW:
    place = image_from_array(array_from_image(place)[80:240, 60:260], spacing)
heights = array_from_image(place).astype(float)
slopes = slopes_of(heights, spacing)
sizes = np.abs(slopes)
sunk_of_place = column(statistics(heights, spacing).GetOutput(0), "DepressionFraction")[0]
fit, twin, drainage = vtkCovarianceFitFilter(), vtkTurningBandsTerrainSource(), vtkDrainageFilter()
fit.SetInputData(place)
fit.Update()
twin.SetInputData(rounded(fit.GetOutput()))
twin.UseMeasuredGridOn()
drainage.SetInputConnection(twin.GetOutputPort())
drainage.SetInputData(1, place)
METHODS = {"grown": vtkDrainageFilter.Growth, "quilted": vtkDrainageFilter.Quilting}
for seed, method in product(SEEDS, METHODS):
    twin.SetSeed(seed)
    drainage.SetSeed(seed)
    drainage.SetMethod(METHODS[method])
    drainage.Update()
    random = np.abs(slopes_of(array_from_image(twin.GetOutput()).astype(float), spacing))
    grown = array_from_image(drainage.GetOutput())
    turned = slopes_of(grown, spacing)
    got = np.abs(turned)
    shares = [aspect_share(turned, folds) for folds in (4, 8)]
    far = distance(got.ravel(), sizes.ravel()), distance(random.ravel(), sizes.ravel())
    gentle = [(ground < 0.25 * ground.mean()).mean() for ground in (got, sizes)]
    blocks = block_variation(got) / block_variation(sizes)
    curved = curvature_deviation(grown, spacing) / curvature_deviation(heights, spacing)
    ratios = semivariances(grown, lags_of(heights)) / semivariances(heights, lags_of(heights))
    integral = [(ground.mean() - ground.min()) / np.ptp(ground) for ground in (grown, heights)]
    sunk = drainage.GetOutput().GetFieldData().GetArray("DepressionFraction").GetComponent(0, 1)
    print(f"{method}, seed {seed}: aspects {shares[0]:.3f} {shares[1]:.3f} ({aspect_share(slopes, 4):.3f} "
          f"{aspect_share(slopes, 8):.3f}), slopes {far[0]:.3f} (Gaussian {far[1]:.3f}), gentle {gentle[0]:.3f} "
          f"({gentle[1]:.3f}), blocks {blocks:.2f}, curvature {curved:.2f}, semivariance {ratios.min():.2f} to "
          f"{ratios.max():.2f}, sunk {sunk:.3f}, integral {integral[0]:.3f} ({integral[1]:.3f}), skew {skew(grown):.2f} "
          f"({skew(heights):.2f})")
    assert sunk <= (0.0 if method == "grown" else max(0.05, sunk_of_place))
    assert shares[0] < 1.5 * aspect_share(slopes, 4) + 0.01 and shares[1] < 1.5 * aspect_share(slopes, 8) + 0.01
    assert far[0] < (0.8 if WINDOW else 0.6) * far[1]
    assert abs(gentle[0] - gentle[1]) < 0.05
    assert abs(blocks - 1.0) < 0.3 and abs(curved - 1.0) < 0.2
    assert 0.88 < ratios.min() and ratios.max() < 1.15
    if method == "quilted" and not WINDOW:
        ratio = steepness_ratio(rivers(grown.astype(float)), rivers(heights))
        print(f"  rivers {ratio:.3f}")
        assert abs(ratio - 1.0) < 0.15
    assert abs(integral[0] - integral[1]) < 0.03 and abs(skew(grown) - skew(heights)) < 0.15
