# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package gives the classes; properties have the defaults that the documentation says."""

import littoral
from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource

source = vtkTurningBandsTerrainSource()
assert source.GetModel() == vtkTurningBandsTerrainSource.Fractal
assert source.GetWholeExtent() == (0, 500, 0, 500, 0, 0)
assert source.GetSpacing() == (2.0, 2.0, 1.0)
source.Update()
elevation = source.GetOutput().GetPointData().GetScalars()
low, high = elevation.GetRange()
assert elevation.GetName() == "Elevation"
assert high - low > 50.0, "the default terrain has no relief"
assert "FractalDimension" in str(source)
assert vtkCovarianceFitFilter().GetNumberOfOutputPorts() == 2
assert hasattr(littoral, "vtkTurningBandsTerrainSource")
