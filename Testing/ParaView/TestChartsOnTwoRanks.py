# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Charts of a server with two ranks: the series, rows and pictures are those without a server, not once for each rank."""

import shutil
import sys

import quick
from paraview import simple
from player import difference
from server import connected

PORT = 21551
SIZE = [300, 200]


def make():
    """Each chart: its filter, its output, and the kind of its view."""
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 60, 0, 0], Seed=4)
    simple.SetActiveSource(terrain)  # ParaView takes the default of an array from the active source
    fit = simple.CovarianceFit(Input=terrain)
    patterns = simple.QuadratAnalysis(Input=simple.QuadratPoints(Quadrats=[30, 20]))
    wind = simple.WindStatistics(Input=simple.WindField(Dimensions=[60, 8, 5]))
    sea = simple.SeaStatistics(Input=simple.SeaState(NumberOfTrains=17))
    return {"fit": (fit, 1, "XYChartView"), "patterns": (patterns, 1, "XYBarChartView"),
            "wind": (wind, 0, "XYChartView"), "sea": (sea, 0, "XYChartView")}


def draw(folder):
    """Draw all charts; the series and the number of rows of each."""
    found = {}
    for name, (table, port, kind) in make().items():
        view = simple.CreateView(kind)
        view.ViewSize = SIZE
        output = simple.OutputPort(table, port)
        chart = simple.Show(output, view)
        simple.Render(view)
        simple.SaveScreenshot(f"{folder}-{name}.png", view, ImageResolution=SIZE)
        found[name] = list(chart.SeriesVisibility), output.GetDataInformation().GetNumberOfRows()
    return found


if not shutil.which("mpirun"):
    sys.exit(125)
wanted = draw("alone")
for name, (series, rows) in wanted.items():
    assert series and rows, f"{name}: the chart is empty"
with connected(PORT, 2):
    seen = draw("ranks")
for name in wanted:
    assert seen[name] == wanted[name], f"{name}: series and rows are {seen[name]}, not {wanted[name]}"
    part = difference(f"ranks-{name}.png", f"alone-{name}.png")
    print(f"{name}: {len(wanted[name][0])} series, {wanted[name][1]} rows, {part:.2%} of the picture is another", flush=True)
    assert part < 0.002, f"{name}: {part:.2%} of the picture is another"
