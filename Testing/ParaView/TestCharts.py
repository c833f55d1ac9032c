# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Charts come up ready to print: series, axes, legends and pictures; what a user changes stays."""

import os

import quick
from paraview import servermanager, simple
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkImagingCore import vtkImageDifference

HERE = os.path.dirname(os.path.abspath(os.environ.get("LITTORAL_CLIENT_SCRIPT", __file__)))


def show(source, port, kind="XYChartView"):
    """A new view of an output, and its display."""
    view = simple.CreateView(kind)
    view.ViewSize = [400, 300]
    return simple.Show(simple.OutputPort(source, port), view), view


def pairs(values):
    """A property of names and values as a dictionary."""
    return dict(zip(values[::2], values[1::2]))


def compare(view, name):
    """Compare a picture with its baseline. Baselines are of ParaView 5.11; other versions lay out charts differently."""
    simple.Render(view)
    if __name__ != "__main__":
        return  # in the window, which sizes its views itself
    simple.SaveScreenshot(f"{name}.png", view, ImageResolution=[400, 300])
    versions = servermanager.vtkSMProxyManager
    if (versions.GetVersionMajor(), versions.GetVersionMinor()) != (5, 11):
        return
    images = []
    for path in (f"{name}.png", os.path.join(HERE, "Baseline", f"{name}.png")):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        images.append(reader)
    difference = vtkImageDifference()
    difference.SetInputConnection(images[0].GetOutputPort())
    difference.SetImageConnection(images[1].GetOutputPort())
    difference.Update()
    error = difference.GetThresholdedError()
    print(f"{name}: error {error:.1f}")
    assert error < 15.0, f"{name}.png differs from its baseline by {error}"


terrain = simple.TurningBandsTerrain(WholeExtent=[0, 200, 0, 150, 0, 0], Model="Spherical", Range=80.0, StandardDeviation=40.0)
fit = simple.CovarianceFit(Input=terrain)
fit.UpdatePipeline()
best = [fit.GetDataInformation(0).GetArrayInformation("Model", 6).GetStringValue(k) for k in range(3)]
assert best[0] == "Spherical", best
chart, view = show(fit, 1)
assert chart.UseIndexForXAxis == 0 and chart.XArrayName == "Lag"
assert set(chart.SeriesVisibility) == {"Semivariance", *best}, chart.SeriesVisibility
markers, lines = pairs(chart.SeriesMarkerStyle), pairs(chart.SeriesLineStyle)
assert markers["Semivariance"] == "4" and lines["Semivariance"] == "0", "measured values are no points"
assert all(markers[name] == "0" for name in best)
assert [lines[name] for name in best] == ["1", "2", "4"], "lines are alike in a print without colors"
assert pairs(chart.SeriesLabel)["SimpleExponential"] == "Simple Exponential"
assert (view.BottomAxisTitle, view.LeftAxisTitle) == ("Lag [m]", "Semivariance [m²]")
assert view.BottomAxisLogScale == 1 and view.LeftAxisLogScale == 1
assert view.LegendLocation == "BottomRight"
compare(view, "chart-variogram")

# Other data have other best models, until someone chooses.
terrain.Model = "Double Exponential"
fit.UpdatePipeline()
assert "DoubleExponential" in chart.SeriesVisibility and len(chart.SeriesVisibility) == 4, chart.SeriesVisibility
chart.SeriesVisibility = ["Semivariance", "Telis"]
view.LeftAxisLogScale = 0
terrain.Model = "Spherical"
fit.UpdatePipeline()
assert set(chart.SeriesVisibility) == {"Semivariance", "Telis"}, "a choice of series does not stay"
assert view.LeftAxisLogScale == 0, "a choice of axes does not stay"

# A view whose axes someone has set is left alone, and so is one that shows something else.
own = simple.CreateView("XYChartView")
own.LeftAxisTitle = "Mine"
simple.Show(simple.OutputPort(fit, 1), own)
assert own.LeftAxisTitle == "Mine" and own.BottomAxisTitle == "" and own.BottomAxisLogScale == 0
wind = simple.WindField(Dimensions=[600, 32, 8])
statistics = simple.WindStatistics(Input=wind)
simple.Show(simple.OutputPort(statistics, 0), view)
assert view.BottomAxisTitle == "Lag [m]"

# The first columns are those that matter.
table, sheet = show(fit, 0, "SpreadSheetView")
shown = {"Model", "Variance", "Range", "AtBound", "AICc"}
assert not shown & set(sheet.HiddenColumnLabels) and "TrendWidth" in sheet.HiddenColumnLabels

# The slopes of streams by drainage area with their law, and the hypsometric curve.
ground = simple.GroundStatistics(Input=terrain)
chart, view = show(ground, 1)
assert chart.XArrayName == "DrainageArea" and set(chart.SeriesVisibility) == {"Slope", "PowerLaw"}
markers, lines = pairs(chart.SeriesMarkerStyle), pairs(chart.SeriesLineStyle)
assert (markers["Slope"], lines["Slope"]) == ("4", "0") and (markers["PowerLaw"], lines["PowerLaw"]) == ("0", "1")
assert (view.BottomAxisTitle, view.LeftAxisTitle) == ("Drainage area [m²]", "Slope [m/m]")
assert view.BottomAxisLogScale == 1 and view.LeftAxisLogScale == 1
compare(view, "chart-ground")
chart, view = show(ground, 2)
assert chart.XArrayName == "Fraction" and set(chart.SeriesVisibility) == {"Elevation"}
assert view.BottomAxisLogScale == 0 and view.LeftAxisTitle == "Elevation [m]"
_, sheet = show(ground, 0, "SpreadSheetView")
shown = {"DepressionFraction", "HypsometricIntegral", "ElevationSkewness", "Concavity", "CurvatureSkewness"}
assert not shown & set(sheet.HiddenColumnLabels) and "HackExponent" in sheet.HiddenColumnLabels

# The variogram of a survey with its model, from a filter whose other outputs have no chart.
survey = simple.PointSource(NumberOfPoints=60, Radius=50.0)
field = simple.ConditionalTerrain(Input=simple.Elevation(Input=survey, LowPoint=[-50, 0, 0], HighPoint=[50, 0, 0]),
                                  KrigingType="Linear Drift", Dimensions=[20, 20], Model="Spherical")
chart, view = show(field, 3)
assert chart.XArrayName == "Lag" and set(chart.SeriesVisibility) == {"Semivariance", "Fitted"}, chart.SeriesVisibility
assert (view.BottomAxisTitle, view.LeftAxisTitle) == ("Lag [m]", "Semivariance")

analysis = simple.QuadratAnalysis(
    Input=simple.QuadratPoints(Quadrats=[30, 20], Law="Negative Binomial", MeanPerQuadrat=2.0))
# The same sheet for another table: columns of both are as wanted.
simple.Show(simple.OutputPort(analysis, 0), sheet)
assert not {"Law", "Verdict", "AIC", "PValue"} & set(sheet.HiddenColumnLabels)
bars, view = show(analysis, 1, "XYBarChartView")
law = analysis.GetDataInformation(0).GetArrayInformation("Law", 6).GetStringValue(0)
assert bars.XArrayName == "Points" and set(bars.SeriesVisibility) == {"Observed", law}, bars.SeriesVisibility
assert view.BottomAxisTitle == "Points per quadrat" and view.BottomAxisLogScale == 0
compare(view, "chart-quadrats")

# L is drawn about that of a random pattern.
pattern = simple.PointPatternStatistics(Input=analysis.Input, NumberOfSimulations=19)
chart, view = show(pattern, 0)
assert set(chart.SeriesVisibility) == {"L(r) - r", "Theoretical", "GlobalLow", "GlobalHigh"}, chart.SeriesVisibility
assert pairs(chart.SeriesLabel)["L(r) - r"] == "L(r) - r"

COMPONENTS = ("Along", "Across", "Up")
for port, x, name, logarithmic in ((0, "Frequency", "spectrum", (1, 1)), (1, "Frequency", "coherence", (1, 0)),
                                   (2, "Height", "profile", (1, 0))):
    chart, view = show(statistics, port)
    assert chart.XArrayName == x and (view.BottomAxisLogScale, view.LeftAxisLogScale) == logarithmic
    if port < 2:
        assert set(chart.SeriesVisibility) == {*COMPONENTS, *(f"{name}Model" for name in COMPONENTS)}
        colors = [value for value in chart.SeriesColor]
        at = {name: colors[colors.index(name) + 1:colors.index(name) + 4] for name in ("Up", "UpModel", "Along")}
        assert at["Up"] == at["UpModel"] != at["Along"], "measurement and model have different colors"
    compare(view, f"chart-wind-{name}")

waves = simple.SeaStatistics(Input=simple.SeaState(NumberOfTrains=60))
for port, x, name in ((0, "Frequency", "spectrum"), (1, "Direction", "directions")):
    chart, view = show(waves, port)
    assert chart.XArrayName == x and len(chart.SeriesVisibility) == 2 and "Trains" in chart.SeriesVisibility
    assert "[" in view.BottomAxisTitle and "[" in view.LeftAxisTitle, "axes without units"
    compare(view, f"chart-sea-{name}")

# A state file keeps what has been chosen.
chart.SeriesVisibility = ["Trains"]
view.BottomAxisTitle, view.LegendLocation = "", "TopLeft"
state = os.path.abspath("charts.pvsm")
simple.SaveState(state)
simple.ResetSession()
simple.LoadState(state)
views = [view for view in simple.GetViews() if view.GetXMLName() == "XYChartView"]
kept = [view for view in views if view.LegendLocation == "TopLeft" and view.BottomAxisTitle == ""]
assert len(kept) == 1, f"{len(kept)} of {len(views)} charts have the legend that was chosen"
simple.Render(kept[0])
assert list(kept[0].Representations[0].SeriesVisibility) == ["Trains"], "a state file does not keep the series"
