# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Five mapped patterns, measured, fitted and regrown: which process makes such a pattern?

    python3 regrow_inventories.py [FOLDER]

writes inventories.png into FOLDER, with a column a pattern: the measured map, a map by the best process, and the pair
correlation g of the measured one in the global envelope of 99 simulations. The patterns are those of Debian's package
r-cran-spatstat.data, read by R; without it those of Examples/Data/patterns alone are drawn.
"""

import csv
import os
import shutil
import subprocess
import sys
from pathlib import Path

import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  (draws charts)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkRectf, vtkTable
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from littoral import vtkPatternVerdictFilter, vtkPointProcessSource
from littoral.picture import write_png

DATA = Path(__file__).resolve().parents[1] / "Data" / "patterns"
COLUMN, MAP, CHART = 330, 330, 240  # pixels
#: Name, title, lower left corner and side of the window, largest distance (0: the default).
PATTERNS = (
    ("japanesepines", "65 pine saplings", (0.0, 0.0), 1.0, 0.0),
    ("redwood", "62 redwood seedlings", (0.0, -1.0), 1.0, 0.0),
    ("cells", "42 biological cells", (0.0, 0.0), 1.0, 0.0),
    ("longleaf", "584 longleaf pines", (0.0, 0.0), 200.0, 0.0),
    ("lansing", "2251 trees of Lansing Woods", (0.0, 0.0), 1.0, 0.1))


def mapped(name):
    """Positions of a pattern, or None."""
    if (DATA / f"{name}.csv").exists():
        with open(DATA / f"{name}.csv", encoding="utf-8") as file:
            return [(float(row["x"]), float(row["y"])) for row in csv.DictReader(file)]
    if not shutil.which("Rscript"):
        return None
    script = (f"data({name}, package='spatstat.data'); "
              f"write.table(unique(data.frame({name}$x, {name}$y)), row.names=FALSE, col.names=FALSE)")
    run = subprocess.run(["Rscript", "--vanilla", "-e", script], capture_output=True, text=True, check=False)
    return [tuple(map(float, line.split())) for line in run.stdout.splitlines()] if run.returncode == 0 else None


def points_of(positions):
    """Positions as vtkPolyData."""
    points, data = vtkPoints(), vtkPolyData()
    points.SetDataTypeToDouble()
    for x, y in positions:
        points.InsertNextPoint(x, y, 0.0)
    data.SetPoints(points)
    return data


def table_of(**columns):
    """Lists of numbers as a table."""
    table = vtkTable()
    for name, values in columns.items():
        array = vtkFloatArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        table.AddColumn(array)
    return table


def chart_at(column, bottom, height, title):
    """An empty chart in a cell of the picture."""
    chart = vtkChartXY()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(column * COLUMN + 4, bottom, COLUMN - 8, height))
    chart.SetTitle(title)
    chart.GetTitleProperties().SetFontSize(15)
    for side in (vtkAxis.LEFT, vtkAxis.BOTTOM):
        chart.GetAxis(side).SetTitle("")
        chart.GetAxis(side).GetLabelProperties().SetFontSize(11)
        chart.GetAxis(side).SetGridVisible(False)
    return chart


def draw_map(chart, positions, origin, side):
    """Points in their square window."""
    if not positions:
        return
    plot = chart.AddPlot(vtkChart.POINTS)
    plot.SetInputData(table_of(x=[p[0] for p in positions], y=[p[1] for p in positions]), 0, 1)
    plot.SetMarkerStyle(4)
    plot.SetMarkerSize(6.0 if len(positions) < 100 else 3.5 if len(positions) < 1000 else 2.2)
    plot.SetColor(40, 92, 60, 255)
    for axis, start in ((vtkAxis.BOTTOM, origin[0]), (vtkAxis.LEFT, origin[1])):
        chart.GetAxis(axis).SetBehavior(vtkAxis.FIXED)
        chart.GetAxis(axis).SetRange(start, start + side)


def draw_envelope(chart, envelope):
    """The measured function and the global band."""
    values = {name: [envelope.GetValueByName(row, name).ToDouble() for row in range(envelope.GetNumberOfRows())]
              for name in ("Distance", "Measured", "Mean", "GlobalLow", "GlobalHigh")}
    table = table_of(**values)
    for name, color, width in (("GlobalLow", (150, 160, 170), 1.5), ("GlobalHigh", (150, 160, 170), 1.5),
                               ("Mean", (200, 160, 90), 1.2), ("Measured", (40, 92, 60), 2.2)):
        plot = chart.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, "Distance", name)
        plot.SetColor(*color, 255)
        plot.SetWidth(width)
    chart.GetAxis(vtkAxis.LEFT).SetBehavior(vtkAxis.FIXED)
    chart.GetAxis(vtkAxis.LEFT).SetRange(0.0, min(4.0, 1.1 * max(values["GlobalHigh"] + values["Measured"])))


def judged(positions, origin, side, largest):
    """The verdict on a pattern."""
    verdict = vtkPatternVerdictFilter()
    verdict.SetInputData(points_of(positions))
    verdict.SetOrigin(origin)
    verdict.SetSize(side, side)
    verdict.SetLargestDistance(largest)
    verdict.Update()
    return verdict


def main(folder):
    """All patterns that are there."""
    os.makedirs(folder, exist_ok=True)
    found = [(pattern, positions) for pattern in PATTERNS if (positions := mapped(pattern[0]))]
    size = len(found) * COLUMN, 2 * MAP + CHART
    actor, renderer, window = vtkContextActor(), vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for column, ((name, title, origin, side, largest), positions) in enumerate(found):
        verdict = judged(positions, origin, side, largest)
        laws = verdict.GetOutput()
        row = next(k for k in range(laws.GetNumberOfRows()) if laws.GetValueByName(k, "ProcessId").ToInt() >= 0)
        best, p = laws.GetValueByName(0, "Law").ToString(), laws.GetValueByName(0, "PValue").ToDouble()
        source = vtkPointProcessSource()
        source.SetInputConnection(verdict.GetOutputPort())
        source.Update()
        grown = source.GetOutput()
        process = laws.GetValueByName(row, "Law").ToString()
        print(f"{name}: best {best}, p {p:.2f}; regrown as {process}, {grown.GetNumberOfPoints()} points")
        draw = chart_at(column, MAP + CHART, MAP, title)
        draw_map(draw, positions, origin, side)
        actor.GetScene().AddItem(draw)
        draw = chart_at(column, CHART, MAP, f"regrown: {process}")
        draw_map(draw, [grown.GetPoint(k)[:2] for k in range(grown.GetNumberOfPoints())], origin, side)
        actor.GetScene().AddItem(draw)
        draw = chart_at(column, 0, CHART, f"g, and its envelope: {best}, p = {p:.2f}")
        draw_envelope(draw, verdict.GetOutput(1))
        actor.GetScene().AddItem(draw)
    renderer.AddActor(actor)
    actor.GetScene().SetRenderer(renderer)
    window.AddRenderer(renderer)
    write_png(window, os.path.join(folder, "inventories.png"), size, oversampling=1)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
