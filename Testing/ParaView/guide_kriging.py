# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a survey to a field through its data, in the window."""

import math

import quick
from paraview import simple

from guide import compare
from player import difference

PAGE = "kriging"


def write_survey(file):
    """Heights of hills at 90 places."""
    with open(file, "w", encoding="utf-8") as out:
        out.write("x,y,height\n")
        for k in range(90):
            x, y = (617.0 * k) % 1000.0, (379.0 * k + 0.11 * k * k) % 1000.0
            out.write(f"{x:.1f},{y:.1f},{200 + 60 * math.sin(x / 170.0) * math.cos(y / 210.0):.2f}\n")


def through(view, **settings):
    table = simple.CSVReader(FileName=["survey.csv"])
    points = simple.TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="height")
    field = simple.ConditionalTerrain(Input=points, **settings)
    for port in 0, 2:
        simple.Show(simple.OutputPort(field, port), view)


def smooth(view):
    through(view, Result="Kriging Estimate", KrigingVariance=1, CrossValidation=1)


def check_field():
    """In the client: the field is looked at from the side in daylight, and its data are on it."""
    view = simple.GetActiveView()
    assert view.GetXMLName() == "RenderView", view.GetXMLName()
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0] and view.UseColorPaletteForBackground == 0
    assert len(view.AdditionalLights) == 1
    field = simple.GetActiveSource()
    assert field.ErrorArray == "None", field.ErrorArray
    dots = simple.GetDisplayProperties(simple.OutputPort(field, 2), view)
    assert dots.Visibility == 1 and dots.Representation == "Points" and dots.ColorArrayName[1] in ("", None)
    missed = [abs(a - b) for a, b in zip(*columns(field, "Value", "Field"))]
    assert len(missed) == 90 and max(missed) < 1e-9 * 60, max(missed)


def columns(field, *names):
    """Columns of the output Data."""
    table = field.GetClientSideObject().GetOutputDataObject(1)
    return [[table.GetColumnByName(name).GetValue(k) for k in range(table.GetNumberOfRows())] for name in names]


def check_estimate():
    """In the client: what the last step has added."""
    field = simple.GetActiveSource()
    assert field.PointData.GetArray("KrigingVariance").GetRange()[0] >= 0.0
    errors = columns(field, "StandardizedError")[0]
    assert len(errors) == 90 and all(map(math.isfinite, errors))


def prepare():
    write_survey("survey.csv")


def walk(walk):
    walk.next("X Column", "Y Column", "Z Column")
    walk.open("survey.csv", "GDALVectorReader")
    walk.apply()
    walk.entry("Filters > Alphabetical > Table To Points")
    walk.choose("XColumn", "x")
    walk.choose("YColumn", "y")
    walk.choose("ZColumn", "height")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Conditional Terrain")
    walk.next("Relief", "Points", "Seed", "Keep All Data Arrays", "Array", "Error Array")
    walk.apply()
    walk.call(check_field)
    walk.look("field")
    walk.next("Data", "SpreadSheet View", "StandardizedError")
    walk.say("Result")
    walk.say("Kriging Estimate")
    walk.choose("Result", "Kriging Estimate")
    walk.tick("Kriging Variance")
    walk.tick("Cross Validation")
    walk.apply()
    walk.call(check_estimate)
    walk.look("estimate")


def check():
    compare("field", through, 0.2)
    compare("estimate", smooth, 0.2)
    part = difference("field.png", "estimate.png")
    assert part > 0.01, f"the estimate looks like the field: {part:.1%} differ"
