# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure9.jpg: polygons a picture in forests, without and with levels of detail and cells.

Lines: a walk that turns back at the edge of the forest, and so looks out of it more often than an eye at any place.
Crosses: views spread evenly over all places and headings.

    ./littoral run pvpython Documentation/pictures/make_figure9.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws charts
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY, vtkPlotPoints
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkRectf
from vtkmodules.vtkRenderingContext2D import vtkPen
from vtkmodules.vtkViewsContext2D import vtkContextView

from littoral import vtkPlantScatterFilter, vtkQuadratPointSource, vtkReevesTreeSource
from littoral.picture import INK, label, write_jpg
from littoral.tables import table_of
from littoral.versions import set_plot_color

SIDE, EYE_HEIGHT = 500.0, 1.7  # [m]
FRAMES, STEP = 90, 5.0  # 1, [m]
VIEW_ANGLE, ASPECT = 45.0, 4.0 / 3.0  # [degrees], width by height
TREES = range(100, 1001, 100)

PICTURE = (1200, 760)
#: Column, words, color.
CURVES = (
    ("None", "neither", (0.35, 0.36, 0.39)),
    ("Levels", "levels of detail", (0.80, 0.55, 0.15)),
    ("Cells", "cells", (0.20, 0.45, 0.68)),
    ("Both", "both", (0.24, 0.52, 0.25)))


def prototypes():
    """Tree sources, and polygons of each in full."""
    trees, polygons = [], []
    for preset in (1, 2, 3):
        tree = vtkReevesTreeSource()
        tree.SetPreset(preset)
        tree.Update()
        high = tree.GetOutputDataObject(0).GetBlock(0)
        trees.append(tree)
        polygons.append(sum(high.GetBlock(k).GetNumberOfPolys() for k in range(high.GetNumberOfBlocks())))
    return trees, np.array(polygons)


def walk():
    """Places and directions of an eye that turns at random and stays in the forest."""
    random = np.random.default_rng(4)
    place, heading = np.array((0.5 * SIDE, 0.5 * SIDE)), 1.0
    for _ in range(FRAMES):
        heading += random.normal(0.0, 0.15)
        ahead = np.array((np.cos(heading), np.sin(heading)))
        if np.all(np.abs(place + STEP * ahead - 0.5 * SIDE) < 0.5 * SIDE):
            place = place + STEP * ahead
        else:
            heading += 0.7
        yield (*place, EYE_HEIGHT), (*ahead, 0.0)


def anywhere():
    """Places and directions spread evenly: multiples of powers of 1 / 1.2207, the root of g^4 = g + 1, but for wholes."""
    for x, y, turn in np.outer(np.arange(FRAMES) + 0.5, 1.2207440846 ** -np.arange(1.0, 4.0)) % 1.0:
        yield (SIDE * x, SIDE * y, EYE_HEIGHT), (np.cos(2.0 * np.pi * turn), np.sin(2.0 * np.pi * turn), 0.0)


def measure(trees, polygons, number, views):
    """Mean polygons a picture, in the order of CURVES."""
    sites = vtkQuadratPointSource()
    sites.SetQuadrats(10, number // 10)
    sites.SetSize(SIDE, SIDE)
    forest = vtkPlantScatterFilter()
    forest.SetInputConnection(0, sites.GetOutputPort())
    for tree in trees:
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetViewAngle(VIEW_ANGLE)
    forest.SetAspectRatio(ASPECT)
    sums = np.zeros(4)
    for point, direction in views:
        forest.SetViewPoint(*point)
        forest.SetViewDirection(*direction)
        for cells in (False, True):
            forest.SetUseCulling(cells)
            forest.Update()
            fields = forest.GetOutputDataObject(0).GetFieldData()
            # All of the shown trees in full are what there would be without levels of detail.
            sums[2 if cells else 0] += polygons[vtk_to_numpy(fields.GetArray("Species"))].sum()
            sums[3 if cells else 1] += fields.GetArray("PolygonsShown").GetValue(0)
    return sums / len(views)


def style(axis, title, values, font):
    """A logarithmic or linear axis with these labels."""
    axis.SetTitle(title)
    axis.SetBehavior(vtkAxis.FIXED)
    axis.SetNotation(vtkAxis.PRINTF_NOTATION)
    axis.SetLabelFormat("%g")
    axis.GetPen().SetColorF(*INK)
    axis.GetGridPen().SetColorF(0.90, 0.90, 0.90)
    axis.SetRange(values[0], values[-1])
    for text in (axis.GetTitleProperties(), axis.GetLabelProperties()):
        text.SetFontSize(font)
        text.SetColor(*INK)
        text.BoldOff()


def main(folder):
    """Measure, and draw the chart into a folder."""
    trees, polygons = prototypes()
    means, others = (np.array([measure(trees, polygons, number, list(views())) for number in TREES])
                     for views in (walk, anywhere))
    for what, values in (("walk", means), ("anywhere", others)):
        print(what, "one in", values[-1, :1] / values[-1])
    table = table_of({"Trees": np.array(TREES, dtype=float)} | {
        name: means[:, k] for k, (name, _, _) in enumerate(CURVES)} | {
        "Other" + name: others[:, k] for k, (name, _, _) in enumerate(CURVES)})
    chart = vtkChartXY()
    for name, _, color in CURVES:
        for kind in (vtkChart.LINE, vtkChart.POINTS):
            plot = chart.AddPlot(kind)
            plot.SetInputData(table, "Trees", name)
            set_plot_color(plot, color)
            plot.SetWidth(6.0 if kind == vtkChart.LINE else 1.0)
            if kind == vtkChart.POINTS:
                plot.SetMarkerStyle(vtkPlotPoints.CIRCLE)
                plot.SetMarkerSize(18.0)
        plot = chart.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, "Trees", "Other" + name)
        set_plot_color(plot, color)
        plot.GetPen().SetLineType(vtkPen.DASH_LINE)
        plot.SetWidth(4.0)
    left, bottom = chart.GetAxis(vtkAxis.LEFT), chart.GetAxis(vtkAxis.BOTTOM)
    style(bottom, "Trees in the scene", (0.0, 1050.0), 38)
    marks = np.arange(0.0, 1001.0, 200.0)
    bottom.SetCustomTickPositions(numpy_to_vtk(marks, deep=True))
    style(left, "Polygons a picture, mean", (1e3, 1e8), 38)
    low, high = (10.0 ** turn(np.log10(values)) for turn, values in
                 ((np.floor, min(means.min(), others.min())), (np.ceil, means.max())))
    left.SetLogScale(True)
    left.SetUnscaledRange(low, high)
    exponents = np.arange(np.log10(low), np.log10(high) + 0.5)
    names = {3: "1 thousand", 4: "10 thousand", 5: "100 thousand", 6: "1 million", 7: "10 million", 8: "100 million"}
    words = vtkStringArray()
    for exponent in exponents:
        words.InsertNextValue(names[int(round(exponent))])
    left.SetCustomTickPositions(numpy_to_vtk(exponents, deep=True), words)
    box = vtkRectf(40.0, 40.0, 2.0 * PICTURE[0] - 500.0, 2.0 * PICTURE[1] - 80.0)
    chart.SetAutoSize(False)
    chart.SetSize(box)
    view = vtkContextView()
    view.GetScene().AddItem(chart)
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    window = view.GetRenderWindow()
    for k, (_, words, color) in enumerate(CURVES):
        part = (np.log10(means[-1, k]) - np.log10(low)) / np.log10(high / low)
        y = 0.128 + part * 0.836
        walked, other = (values[-1, 0] / values[-1, k] for values in (means, others))
        gain = "" if k == 0 else f": 1 in {walked:.0f} ({other:.0f})"
        actor = label(words + gain, (0.795, y + 0.008), 36, color)
        actor.GetTextProperty().SetJustificationToLeft()
        view.GetRenderer().AddActor(actor)
    write_jpg(window, os.path.join(folder, "figure9.jpg"), PICTURE, quality=92)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
