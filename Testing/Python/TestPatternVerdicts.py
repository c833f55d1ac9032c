# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Mapped patterns, fitted and regrown: g of each lies in the global envelope of 99 simulations of the best process.

Three patterns are in Examples/Data/patterns; longleaf pines and the trees of Lansing Woods are read from the R package
spatstat.data, where it is installed.
"""
# run-with: python3

import csv
import shutil
import subprocess
import sys
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from littoral import vtkPatternVerdictFilter, vtkPointProcessSource

DATA = Path(__file__).resolve().parents[2] / "Examples" / "Data" / "patterns"
#: Name, lower left corner and side of the window [m], largest distance [m] (0: the default), of the R package or not.
PATTERNS = (
    ("japanesepines", (0.0, 0.0), 1.0, 0.0, False), ("redwood", (0.0, -1.0), 1.0, 0.0, False),
    ("cells", (0.0, 0.0), 1.0, 0.0, False), ("longleaf", (0.0, 0.0), 200.0, 20.0, True),
    ("lansing", (0.0, 0.0), 1.0, 0.1, True))


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


def main(wanted):
    """All patterns, or those that are named."""
    for name, origin, side, largest, of_package in PATTERNS:
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
        verdict.SetLargestDistance(largest)
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


if __name__ == "__main__":
    main(sys.argv[1:])
