# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Twins of the real elevation model have its plane, and on average its variance.

One realisation holds few of the place's largest structures, so that its own variance scatters: by
the VarianceDeviation of the table. Twenty seeds tell the mean to a fifth of that.
"""

import numpy as np

from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image, read_elevation
from littoral.tables import column, model_names


def measure(image):
    """Mean, rises over the place and the variance less the plane."""
    heights = array_from_image(image).astype(float)
    y, x = (np.linspace(-0.5, 0.5, size) for size in heights.shape)
    rise_x = (heights * x).mean() / (x * x).mean()
    rise_y = (heights * y[:, None]).mean() / (y * y).mean()
    rest = heights - heights.mean() - rise_x * x - rise_y * y[:, None]
    return heights.mean(), rise_x, rise_y, rest.var()


place = read_elevation()
fit = vtkCovarianceFitFilter()
fit.SetInputData(place)
fit.Update()
fits = fit.GetOutput()
*plane, variance = measure(place)
sample = fits.GetFieldData().GetArray("SampleVariance").GetValue(0)
assert abs(variance / sample - 1.0) < 1e-6
told = column(fits, "VarianceDeviation")[0] / variance
names = model_names(fits)
assert abs(told - 0.12) < 0.005 and names[0] == "Bessel1", (told, names)
rough = column(fits, "VarianceDeviation")[names.index("Fractal")] / variance
assert abs(rough - 0.31) < 0.005, rough

SEEDS = range(1, 21)
ratios = []
for seed in SEEDS:
    twin = vtkTurningBandsTerrainSource()
    twin.SetInputData(fits)
    twin.SetWholeExtent(place.GetExtent())
    twin.SetOrigin(place.GetOrigin())
    twin.SetSpacing(place.GetSpacing())
    twin.SetSeed(seed)
    twin.Update()
    *grown, own = measure(twin.GetOutput())
    ratios.append(own / variance)
    # The plane of the place, to 1 m where the heights' standard deviation is 145 m.
    assert np.allclose(grown, plane, rtol=0.0, atol=1.0), (seed, grown, plane)

mean, scatter = np.mean(ratios), np.std(ratios)
print(f"{model_names(fits)[0]}: variance ratio {mean:.3f} +- {scatter:.3f}, told {told:.3f}")
assert abs(mean - 1.0) < 3.0 * told / len(SEEDS) ** 0.5, ratios
assert 0.5 < scatter / told < 1.5, ratios

# A twin is fitted alike: the same model, or one as good, and its range.
second = vtkCovarianceFitFilter()
second.SetInputData(twin.GetOutput())
second.Update()
again = second.GetOutput()
row = model_names(again).index(model_names(fits)[0])
assert not column(again, "AtBound")[row]
assert 0.5 < column(again, "Range")[row] / column(fits, "Range")[0] < 2.0
