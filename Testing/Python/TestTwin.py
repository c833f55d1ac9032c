# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The fit of the real elevation model and the fit of its twin agree."""

from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource
from littoral.elevation import read_elevation
from littoral.tables import column, model_names

place = read_elevation()
fit = vtkCovarianceFitFilter()
fit.SetInputData(place)
fit.Update()
measured = fit.GetOutput()
best = model_names(measured)[0]

good = 0
SEEDS = range(1, 11)
for seed in SEEDS:
    twin = vtkTurningBandsTerrainSource()
    twin.SetInputData(measured)
    twin.SetWholeExtent(place.GetExtent())
    twin.SetOrigin(place.GetOrigin())
    twin.SetSpacing(place.GetSpacing())
    twin.SetSeed(seed)
    second = vtkCovarianceFitFilter()
    second.SetInputConnection(twin.GetOutputPort())
    second.Update()
    grown = second.GetOutput()
    row = model_names(grown).index(best)
    criterion = column(grown, "AICc")
    distance = criterion[row] - criterion[0]
    ratio = column(grown, "Variance")[row] / column(measured, "Variance")[0]
    agrees = distance <= 2.0 and abs(ratio - 1.0) <= 0.25
    print(f"seed {seed}: {best} is {distance:.2f} of AICc from the best, variance ratio {ratio:.3f}")
    good += agrees
    # The seed of the demonstration is held to the criterion itself.
    assert agrees or seed != 1, "the twin of the demonstration is not like the place"
    assert abs(column(grown, "Mean")[0] - column(measured, "Mean")[0]) < 80.0

# One realisation holds few of the place's largest structures, so that its own variance scatters.
print(f"{good} of {len(SEEDS)} seeds agree")
assert good >= 7
