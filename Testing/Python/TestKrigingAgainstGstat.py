# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Kriging against gstat: simple, ordinary, linear, quadratic and external drift, a spherical model, a nugget, and each
datum from the others. Skipped where R or gstat is not installed.
"""

import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from littoral import vtkConditionalTerrainFilter
from littoral.tables import column

if not shutil.which("Rscript") or subprocess.run(
        ["Rscript", "-e", "library(gstat)"], capture_output=True, check=False).returncode:
    print("no R with gstat")
    sys.exit(125)

SIZE, SPACING, DEVIATION, RANGE, MEAN = 15, 3.0, 3.0, 12.0, 101.0
# Each case: kriging type, formula and model of gstat, settings of the filter.
CASES = {
    "simple": (0, "z ~ 1", 'vgm(9, "Exp", 12)', {"Mean": MEAN, "UseDataMean": False}),
    "ordinary": (1, "z ~ 1", 'vgm(9, "Exp", 12)', {}),
    "linear": (2, "z ~ x + y", 'vgm(9, "Exp", 12)', {}),
    "quadratic": (3, "z ~ x + y + I(x^2) + I(x * y) + I(y^2)", 'vgm(9, "Exp", 12)', {}),
    "external": (4, "z ~ d", 'vgm(9, "Exp", 12)', {}),
    "spherical": (1, "z ~ 1", 'vgm(9, "Sph", 20)', {"Model": 6, "Range": 20.0}),
    "error": (2, "z ~ x + y", 'vgm(9, "Exp", 12, add.to = vgm(0.5, "Err", 0))', {"Nugget": 0.5}),
    "anisotropy": (1, "z ~ 1", 'vgm(9, "Exp", 12, anis = c(60, 0.4))',
                   {"AnisotropyRatio": 2.5, "AnisotropyAngle": 30.0}),
    "neighbors": (1, "z ~ 1", 'vgm(9, "Exp", 12)', {"NumberOfNeighbors": 9}),
}
SCRIPT = """
suppressMessages({library(sp); library(gstat)})
all <- read.table(file("stdin"), header = TRUE)
s <- all[all$known == 1, ]; n <- all[all$known == 0, ]
coordinates(s) <- ~x+y; coordinates(n) <- ~x+y
k <- krige(FORMULA, s, n, MODEL, debug.level = 0 MORE)
c <- krige.cv(FORMULA, s, MODEL, debug.level = 0, verbose = FALSE MORE)
show <- function(a, b) write.table(format(cbind(a, b), digits = 15), row.names = FALSE, col.names = FALSE,
                                   quote = FALSE)
show(k$var1.pred, k$var1.var)
show(c$var1.pred, c$var1.var)
"""

random = np.random.default_rng(11)
places = random.uniform(0.0, SPACING * (SIZE - 1), (40, 2))
nodes = SPACING * np.column_stack([np.tile(np.arange(SIZE), SIZE), np.repeat(np.arange(SIZE), SIZE)])
# A drift that is linear between the points of the grid, as the filter has it
plane = 0.3 * nodes[:, 0] - 0.2 * nodes[:, 1] + 7.0
drift = plane + 0.01 * nodes[:, 0] * nodes[:, 1]
at_data = 0.3 * places[:, 0] - 0.2 * places[:, 1] + 7.0 + 0.01 * places[:, 0] * places[:, 1]
heights = MEAN + 3.0 * random.normal(size=len(places)) + 0.1 * at_data
rows = "x y z d known\n" + "".join(
    f"{x!r} {y!r} {z!r} {d!r} 1\n"
    for (x, y), z, d in zip(places.tolist(), heights.tolist(), at_data.tolist())) + "".join(
    f"{x!r} {y!r} 0 {d!r} 0\n" for (x, y), d in zip(nodes.tolist(), drift.tolist()))

points = vtkPoints()
points.SetDataTypeToDouble()
points.SetData(numpy_to_vtk(np.column_stack([places, heights]), deep=True))
survey = vtkPolyData()
survey.SetPoints(points)
grid = vtkImageData()
grid.SetDimensions(SIZE, SIZE, 1)
grid.SetSpacing(SPACING, SPACING, 1.0)
array = numpy_to_vtk(drift, deep=True)
array.SetName("Elevation")
grid.GetPointData().SetScalars(array)

for name, (kind, formula, model, settings) in CASES.items():
    more = f", beta = {MEAN}" if name == "simple" else ", nmax = 9" if name == "neighbors" else ""
    script = SCRIPT.replace("FORMULA", formula).replace("MODEL", model).replace("MORE", more)
    answer = subprocess.run(["Rscript", "-e", script], input=rows, capture_output=True, text=True, check=True).stdout
    peer = np.array([line.split() for line in answer.splitlines()], float)
    made = vtkConditionalTerrainFilter()
    made.SetInputData(survey)
    made.SetInputData(1, grid)
    made.SetModelToSimpleExponential()
    made.SetStandardDeviation(DEVIATION)
    made.SetRange(RANGE)
    made.SetResultToKrigingEstimate()
    made.SetKrigingType(kind)
    made.KrigingVarianceOn()
    made.CrossValidationOn()
    for key, value in settings.items():
        getattr(made, "Set" + key)(value)
    made.Update()
    values = made.GetOutput().GetPointData()
    table = made.GetOutputDataObject(1)
    # gstat's cross-validation gives the variance of the field, and so does each of ours but for the noise.
    noise = settings.get("Nugget", 0.0)
    ours = (vtk_to_numpy(values.GetArray("Elevation")), vtk_to_numpy(values.GetArray("KrigingVariance")),
            column(table, "LeaveOneOutEstimate"), column(table, "LeaveOneOutStandardDeviation")**2 - noise)
    theirs = (peer[:SIZE * SIZE, 0], peer[:SIZE * SIZE, 1], peer[SIZE * SIZE:, 0], peer[SIZE * SIZE:, 1])
    worst = [abs(a - b).max() for a, b in zip(ours, theirs)]
    print(f"{name}: estimate {worst[0]:.1e}, variance {worst[1]:.1e}; "
          f"left out {worst[2]:.1e}, {worst[3]:.1e}", flush=True)
    assert max(worst) < 1e-6, name
