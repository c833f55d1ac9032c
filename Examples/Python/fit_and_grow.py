# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Fit covariance models to an elevation model and grow a synthetic twin, in one pipeline.

    python3 fit_and_grow.py [FOLDER [ELEVATION_MODEL]]

ELEVATION_MODEL: .npz, .vti, GeoTIFF or another raster in metres; default: the Jacksboro fault, Tennessee. Writes
variogram.png and grown.vti into FOLDER.
"""

import os
import sys
import tempfile

from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource
from littoral.chart import save_variogram_chart
from littoral.elevation import JACKSBORO, read_elevation, write_vti
from littoral.tables import model_names

folder = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-")
place = read_elevation(sys.argv[2] if len(sys.argv) > 2 else JACKSBORO)
os.makedirs(folder, exist_ok=True)

fit = vtkCovarianceFitFilter()
fit.SetInputData(place)

source = vtkTurningBandsTerrainSource()
source.SetInputConnection(fit.GetOutputPort(0))
source.UseMeasuredGridOn()
source.Update()

fits = fit.GetOutput(0)
models = model_names(fits)
print("models, best first:", *models)
save_variogram_chart(os.path.join(folder, "variogram.png"), fit.GetOutput(1), models)
write_vti(source.GetOutput(), os.path.join(folder, "grown.vti"))
print("variogram.png and grown.vti are in", folder)
