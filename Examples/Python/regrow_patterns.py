# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Three classical point patterns: read from CSV, analysed, classified, and regrown.

    python3 regrow_patterns.py [FOLDER]     writes patterns.png into FOLDER
"""

import os
import sys
import tempfile

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  (draws charts)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY, vtkPlotPoints
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkRectf
from vtkmodules.vtkViewsContext2D import vtkContextView

from littoral import vtkQuadratAnalysisFilter, vtkQuadratPointSource
from littoral.picture import write_png
from littoral.tables import table_of
from littoral.versions import set_plot_color

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "patterns")

#: Name, title, lower left corner of the unit square, color.
PATTERNS = (
    ("japanesepines", "Japanese black pines", (0, 0), (0.20, 0.45, 0.30)),
    ("redwood", "Redwood seedlings", (0, -1), (0.72, 0.32, 0.18)),
    ("cells", "Biological cells", (0, 0), (0.20, 0.40, 0.65)),
)
CELL, GAP, TITLE = 330, 26, 46


def read_points(name):
    """A CSV file with columns x and y as vtkPolyData."""
    filename = os.path.join(DATA, name + ".csv")
    table = np.genfromtxt(filename, delimiter=",", names=True, deletechars='"')
    xyz = np.column_stack([table[column] for column in table.dtype.names] + [np.zeros(len(table))])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(xyz, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def analyse(points, origin):
    """The table of fits of a pattern on a unit square."""
    analysis = vtkQuadratAnalysisFilter()
    analysis.SetInputData(points)
    analysis.SetOrigin(origin)
    analysis.SetSize(1.0, 1.0)
    analysis.Update()
    return analysis.GetOutput()


def regrow(fits, seed):
    """Points by the first law of a table of fits."""
    source = vtkQuadratPointSource()
    source.SetInputData(fits)
    source.SetSeed(seed)
    source.Update()
    return source.GetOutput()


def panel(points, origin, title, color, place, scale):
    """A square chart with the points of a pattern, at a position [pixels]."""
    xyz = vtk_to_numpy(points.GetPoints().GetData())
    chart = vtkChartXY()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(*(scale * v for v in (*place, CELL, CELL))))
    plot = chart.AddPlot(vtkChart.POINTS)
    plot.SetInputData(table_of({"x": xyz[:, 0], "y": xyz[:, 1]}), "x", "y")
    plot.SetMarkerStyle(vtkPlotPoints.CIRCLE)
    plot.SetMarkerSize(8.0 * scale)
    set_plot_color(plot, color)
    chart.SetTitle(title)
    chart.GetTitleProperties().SetFontSize(15 * scale)
    for axis_id, start in ((vtkAxis.BOTTOM, origin[0]), (vtkAxis.LEFT, origin[1])):
        axis = chart.GetAxis(axis_id)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(start - 0.02, start + 1.02)
        axis.SetTitle("")
        axis.SetLabelsVisible(False)
        axis.SetTicksVisible(False)
        axis.SetGridVisible(False)
    return chart


def main(folder):
    """Analyse, regrow and plot all three."""
    scale = 2
    view = vtkContextView()
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    known = {"japanesepines": "random", "redwood": "clustered", "cells": "regular"}
    for k, (name, title, origin, color) in enumerate(PATTERNS):
        measured = read_points(name)
        fits = analyse(measured, origin)
        fields = fits.GetFieldData()
        pattern = fields.GetAbstractArray("Pattern").GetValue(0)
        index = fields.GetArray("DispersionIndex").GetValue(0)
        law = fits.GetColumnByName("Law").GetValue(0)
        print(f"{title}: {pattern} (index of dispersion {index:.2f}), best law {law}")
        assert pattern == known[name], f"{name} is known as {known[name]}"
        twin = regrow(fits, seed=k + 1)
        x = GAP + k * (CELL + GAP)
        upper, lower = GAP + CELL + TITLE, GAP
        scene = view.GetScene()
        scene.AddItem(panel(measured, origin, f"{title}: {pattern}", color, (x, upper), scale))
        scene.AddItem(panel(twin, origin, f"regrown: {law}", color, (x, lower), scale))
    os.makedirs(folder, exist_ok=True)
    size = (GAP + 3 * (CELL + GAP), 2 * (CELL + TITLE))
    write_png(view.GetRenderWindow(), os.path.join(folder, "patterns.png"), size, scale)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-"))
