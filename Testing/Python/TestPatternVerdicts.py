# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=redwood
# run-with: python3 tier=all
"""Mapped patterns, fitted and regrown: g of each lies in the global envelope of 99 simulations of the best process, at
all distances up to a quarter of the side.

Three patterns are in Examples/Data/patterns; longleaf pines and the trees of Lansing Woods are read from the R package
spatstat.data, where it is installed.
"""

import csv
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

from littoral import vtkPatternVerdictFilter, vtkPointPatternStatisticsFilter, vtkPointProcessSource

DATA = Path(__file__).resolve().parents[2] / "Examples" / "Data" / "patterns"
#: Name, lower left corner and side of the window [m], degree of the trend, of the R package or not.
PATTERNS = (
    ("japanesepines", (0.0, 0.0), 1.0, 0, False), ("redwood", (0.0, -1.0), 1.0, 0, False),
    ("cells", (0.0, 0.0), 1.0, 0, False), ("longleaf", (0.0, 0.0), 200.0, 2, True), ("lansing", (0.0, 0.0), 1.0, 0, True))


def mapped(name, of_package):
    """Positions of a pattern, or None."""
    if not of_package:
        with open(DATA / f"{name}.csv", encoding="utf-8") as file:
            return [(float(row["x"]), float(row["y"])) for row in csv.DictReader(file)]
    if not shutil.which("Rscript"):
        return None
    script = f"""if (!requireNamespace("spatstat.data", quietly=TRUE)) quit(status=3)
data({name}, package="spatstat.data")
write.table(unique(data.frame(x={name}$x, y={name}$y)), row.names=FALSE, col.names=FALSE)"""
    run = subprocess.run(["Rscript", "--vanilla", "-e", script], capture_output=True, text=True, check=False)
    return [tuple(map(float, line.split())) for line in run.stdout.splitlines()] if run.returncode == 0 else None


def points_of(positions):
    """Positions as vtkPolyData."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for x, y in positions:
        points.InsertNextPoint(x, y, 0.0)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def sums_over(places, side):
    """Sums over points of 1, u, v, u^2, u v and v^2; u and v go from -1 to 1 over the plot."""
    u, v = 2.0 * places.T / side - 1.0
    return np.array([len(u), u.sum(), v.sum(), (u * u).sum(), (u * v).sum(), (v * v).sum()])


def check_trend(source, positions, side, seeds=100):
    """The most likely trend has these sums of the pattern as means, and so do the patterns that are regrown."""
    found = np.empty((seeds, 6))
    for seed in range(seeds):
        source.SetSeed(seed + 1)
        source.Update()
        found[seed] = sums_over(vtk_to_numpy(source.GetOutput().GetPoints().GetData())[:, :2].astype(float), side)
    wanted, error = sums_over(positions, side), found.std(axis=0, ddof=1) / np.sqrt(seeds)
    print("sums of the trend:", wanted.round(1), "regrown:", found.mean(axis=0).round(1), "+-", error.round(1))
    assert (np.abs(found.mean(axis=0) - wanted) < 3.0 * error).all()
    level = np.array([1.0, 0.0, 0.0, 1.0 / 3.0, 0.0, 1.0 / 3.0]) * len(positions)
    assert (np.abs(found.mean(axis=0) - level) > 6.0 * error).any()


def check_statistics(verdict, side):
    """The statistics of the pattern against the process with its trend have its verdict."""
    statistics = vtkPointPatternStatisticsFilter()
    statistics.SetInputData(verdict.GetInputDataObject(0, 0))
    statistics.SetInputConnection(2, verdict.GetOutputPort())
    statistics.SetSize(side, side)
    statistics.SetFunctionToPairCorrelation()
    statistics.SetEdgeCorrection(vtkPointPatternStatisticsFilter.Translation)
    statistics.SetNumberOfSteps(64)
    statistics.Update()
    p = statistics.GetOutput(1).GetColumnByName("PValue").GetValue(0)
    print("statistics with the trend: p =", p)
    assert p > 0.05


def check_broken_table(verdict):
    """A trend with a coefficient too few is one error."""
    table, errors = vtkTable(), []
    table.DeepCopy(verdict.GetOutput())
    table.GetFieldData().GetArray("Trend").SetNumberOfTuples(5)
    source = vtkPointProcessSource()
    source.SetInputData(table)
    source.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    source.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    source.Update()
    assert len(errors) == 1 and source.GetOutput().GetNumberOfPoints() == 0


def main(wanted):
    """All patterns, or those that are named."""
    for name, origin, side, degree, of_package in PATTERNS:
        if wanted and name not in wanted:
            continue
        positions = mapped(name, of_package)
        if not positions:
            print(f"{name}: skipped, R or its package spatstat.data is not installed")
            continue
        verdict = vtkPatternVerdictFilter()
        verdict.SetInputData(points_of(positions))
        verdict.SetOrigin(origin)
        verdict.SetSize(side, side)
        verdict.SetTrendDegree(degree)
        verdict.Update()
        table = verdict.GetOutput()
        for row in range(table.GetNumberOfRows()):
            print(name, *(table.GetValueByName(row, column) for column in ("Law", "Kind", "Verdict", "PValue")))
        assert table.GetValueByName(0, "Verdict").ToString() == "best"
        assert table.GetValueByName(0, "PValue").ToDouble() > 0.05, name
        envelope = verdict.GetOutput(1)
        for row in range(envelope.GetNumberOfRows()):
            low, measured, high = (
                envelope.GetValueByName(row, column).ToDouble() for column in ("GlobalLow", "Measured", "GlobalHigh"))
            assert not measured < low and not measured > high, (name, row)
        source = vtkPointProcessSource()
        source.SetInputConnection(verdict.GetOutputPort())
        source.Update()
        count = source.GetOutput().GetNumberOfPoints()
        print(name, len(positions), "points, regrown", count)
        assert 0.4 * len(positions) < count < 2.5 * len(positions), name
        if degree:
            check_trend(source, np.array(positions), side)
            check_statistics(verdict, side)
            check_broken_table(verdict)


if __name__ == "__main__":
    main(sys.argv[1:])
