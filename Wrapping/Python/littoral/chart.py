# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Variograms and spectra as charts: measurements as points, models as lines.

Both axes are logarithmic.
"""

import re

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws charts
from vtkmodules.vtkChartsCore import (
    vtkAxis, vtkChart, vtkChartLegend, vtkChartXY, vtkPlotPoints)
from vtkmodules.vtkCommonDataModel import vtkRectf
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .picture import write_png
from .tables import column, table_of
from .versions import set_plot_color

FONT = 19  # [pixels]
INK = (0.20, 0.22, 0.26)
GRID = (0.90, 0.90, 0.90)
BEST = (0.80, 0.27, 0.12)
OTHERS = (
    (0.13, 0.42, 0.62), (0.29, 0.56, 0.35), (0.55, 0.40, 0.65), (0.80, 0.62, 0.20),
    (0.40, 0.66, 0.72), (0.62, 0.62, 0.62))


def save_variogram_chart(filename, variogram, models, size=(1200, 750), oversampling=2):
    """Draw a variogram: a table of `Lag` [m], `Semivariance` [m2] and a column for each model.

    models: names of the columns to draw, best first.
    """
    names = ["Semivariance", *models]
    table = table_of({"Lag": 1e-3 * column(variogram, "Lag")} | {
        name: 1e-3 * column(variogram, name) for name in names})
    chart = vtkChartXY()
    for rank, model in enumerate(models):
        _add_line(chart, table, model, rank, oversampling)
    _add_points(chart, table, oversampling)
    _style_axis(chart.GetAxis(vtkAxis.BOTTOM), "Lag (km)", oversampling, column(table, "Lag"))
    _style_axis(
        chart.GetAxis(vtkAxis.LEFT), "Semivariance (1000 m\u00b2)", oversampling,
        column(table, "Semivariance"))
    _style_legend(chart, oversampling, vtkChartLegend.RIGHT)
    _write(chart, filename, size, oversampling)


def slope_area_chart(profiles, names, oversampling=2):
    """Chart of mean slope by drainage area: tables of `DrainageArea` [m2] and `Slope` [m/m] from `vtkGroundStatisticsFilter`.

    The axis of slopes is that of the first profile; others may leave the chart, as where water stands.
    """
    chart = vtkChartXY()
    colors = (INK, OTHERS[3], OTHERS[0])
    for profile, name, color in zip(profiles, names, colors):
        table = table_of({"Area": 1e-6 * column(profile, "DrainageArea"), "Slope": column(profile, "Slope")})
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(table, "Area", "Slope")
        line.SetLabel(f" {name}")
        set_plot_color(line, color)
        line.SetWidth(3.0 * oversampling)
    areas = np.concatenate([1e-6 * column(profile, "DrainageArea") for profile in profiles])
    slopes = column(profiles[0], "Slope")
    _style_axis(chart.GetAxis(vtkAxis.BOTTOM), "Drainage area (km\u00b2)", oversampling, areas)
    room = [0.3 * slopes[slopes > 0.0].min(), *slopes]  # for the legend
    _style_axis(chart.GetAxis(vtkAxis.LEFT), "Slope of streams", oversampling, np.array(room))
    _style_legend(chart, oversampling, vtkChartLegend.LEFT)
    return chart


def save_spectrum_chart(filename, spectra, components, size=(1200, 750), oversampling=2):
    """Draw power spectra: a table of `Frequency` [Hz] and two columns for each component.

    components: names of the columns with densities [m2/s2/Hz]; those of the model are in columns
    with ` model` appended to the name.
    """
    chart = vtkChartXY()
    for name, color in zip(components, (BEST, *OTHERS)):
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(spectra, "Frequency", f"{name} model")
        line.SetLabel(f" {name}: model")
        set_plot_color(line, color)
        line.SetWidth(2.5 * oversampling)
        points = chart.AddPlot(vtkChart.POINTS)
        points.SetInputData(spectra, "Frequency", name)
        points.SetLabel(f" {name}: field")
        points.SetMarkerStyle(vtkPlotPoints.CIRCLE)
        points.SetMarkerSize(8.0 * oversampling)
        set_plot_color(points, color)
    values = np.concatenate([column(spectra, name) for name in components])
    _style_axis(
        chart.GetAxis(vtkAxis.BOTTOM), "Frequency (Hz)", oversampling,
        column(spectra, "Frequency"))
    _style_axis(
        chart.GetAxis(vtkAxis.LEFT), "Power density (m\u00b2/s\u00b2/Hz)", oversampling, values)
    _style_legend(chart, oversampling, vtkChartLegend.LEFT)
    _write(chart, filename, size, oversampling)


def chart_renderer(chart, size, oversampling=2, viewport=(0.0, 0.0, 1.0, 1.0), paper=(1.0, 1.0, 1.0)):
    """A renderer of a chart in a part of a window, of a size [pixels] when it is written; margins are of 30 pixels."""
    renderer, actor, margin = vtkRenderer(), vtkContextActor(), 30 * oversampling
    renderer.SetViewport(*viewport)
    renderer.SetBackground(*paper)
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(margin, margin, *(s * oversampling - 2 * margin for s in size)))
    actor.GetScene().AddItem(chart)
    renderer.AddActor(actor)
    return renderer


def _write(chart, filename, size, oversampling):
    window = vtkRenderWindow()
    window.AddRenderer(chart_renderer(chart, size, oversampling))
    write_png(window, filename, size, oversampling)


def _add_line(chart, table, model, rank, oversampling):
    line = chart.AddPlot(vtkChart.LINE)
    line.SetInputData(table, "Lag", model)
    words = re.sub(r"(?<=[a-z])(?=[A-Z0-9])", " ", model)
    line.SetLabel(f" {words}" if rank else f" {words} (best)")
    set_plot_color(line, OTHERS[(rank - 1) % len(OTHERS)] if rank else BEST)
    line.SetWidth((1.6 if rank else 4.0) * oversampling)


def _add_points(chart, table, oversampling):
    points = chart.AddPlot(vtkChart.POINTS)
    points.SetInputData(table, "Lag", "Semivariance")
    points.SetLabel(" measured")
    points.SetMarkerStyle(vtkPlotPoints.CIRCLE)
    points.SetMarkerSize(7.0 * oversampling)
    set_plot_color(points, INK)


def _style_axis(axis, title, oversampling, values):
    positive = values[values > 0.0] if np.any(values > 0.0) else np.ones(1)
    axis.SetTitle(title)
    axis.SetBehavior(vtkAxis.FIXED)
    axis.SetLogScale(True)
    axis.SetUnscaledRange(0.8 * positive.min(), 1.25 * positive.max())
    axis.SetNotation(vtkAxis.PRINTF_NOTATION)
    axis.SetLabelFormat("%g")
    axis.GetPen().SetColorF(*INK)
    axis.GetGridPen().SetColorF(*GRID)
    for text in (axis.GetTitleProperties(), axis.GetLabelProperties()):
        text.SetFontSize(FONT * oversampling)
        text.SetColor(*INK)
        text.BoldOff()


def _style_legend(chart, oversampling, side):
    font = FONT * oversampling
    chart.SetShowLegend(True)
    legend = chart.GetLegend()
    legend.SetHorizontalAlignment(side)
    legend.SetVerticalAlignment(vtkChartLegend.BOTTOM)
    legend.SetLabelSize(font)
    legend.SetSymbolWidth(2 * font)
    legend.SetPadding(font // 3)
    legend.GetPen().SetOpacityF(0.0)
