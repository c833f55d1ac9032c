# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
"""Five public inventories: measured, fitted, regrown and planted.

    python3 five_inventories.py [FOLDER] [--quick]

writes five-inventories.jpg into FOLDER, a row for each inventory: the map; the pair correlation of the map with the
global envelope of 99 patterns of the process that is best by the envelope test; a pattern of that process; and plants on
it. The inventories are those of Debian's package r-cran-spatstat.data, read by R; without it the example says so and ends.
--quick, for a test, draws one of which this project has a file, at half the size.
"""

import os
import shutil
import subprocess
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkRectf
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import stand, vtkPatternVerdictFilter, vtkPointProcessSource
from littoral.gallery.floor import BROADLEAVED, SAVANNA, light, plant_actors
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.tables import column, table_of
from littoral.versions import set_plot_color

PAPER = (0.97, 0.965, 0.95)
#: Left edges of the columns and lower edges of the rows, as parts of the picture.
COLUMNS = (0.0, 0.185, 0.445, 0.63, 1.0)
ROW, TOP = 0.192, 0.04
PICTURE = (1600, 1840)  # pixels

#: Name in R; title; side of the plot [m]; degree of the trend; side [m], kind, median height [m] and variation of the
#: plants, None for those of the inventory. Seedlings and saplings stand there as grown trees, four and ten times as far
#: apart.
INVENTORIES = (
    ("longleaf", "Longleaf pines", 200.0, 2, None),
    ("lansing", "Lansing Woods", 281.6, 0, None),
    ("redwood", "Redwood seedlings", 23.0, 0, (92.0, "Pine", 15.0, 0.15)),
    ("japanesepines", "Japanese black pines", 5.7, 0, (57.0, "Pine", 9.0, 0.2)),
    ("cells", "Cells", 1.0, 0, (24.0, "Shrub", 2.4, 0.1)),
)
#: Inventory that --quick draws.
QUICK = "japanesepines"
#: Diameter at breast height [cm] over height [m] of pines that stand alone.
OPEN_GROWN = 1.5


def read(name):
    """Positions in a unit square, and columns `dbh` [cm] and `species` where the inventory has them; None without R."""
    script = f"""library(spatstat.data); p <- {name}; w <- p$window; s <- w$xrange[2] - w$xrange[1]
d <- data.frame(x=(p$x - w$xrange[1]) / s, y=(p$y - w$yrange[1]) / s)
if (is.numeric(p$marks)) d$dbh <- p$marks
if (is.factor(p$marks)) d$species <- as.character(p$marks)
write.csv(d[!duplicated(d[, c("x", "y")]), ], row.names=FALSE, quote=FALSE)"""
    if not shutil.which("Rscript"):
        return None
    run = subprocess.run(["Rscript", "-e", script], capture_output=True, text=True, check=False)
    if run.returncode:
        return None
    rows = [line.split(",") for line in run.stdout.splitlines()]
    return {key: np.array([row[k] for row in rows[1:]], str if key == "species" else float)
            for k, key in enumerate(rows[0])}


def read_file(name):
    """Positions of an inventory in a unit square, from a file of this project."""
    file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "patterns", f"{name}.csv")
    return dict(zip("xy", np.loadtxt(file, delimiter=",", skiprows=1).T))


def points_of(x, y):
    """Positions as vtkPolyData."""
    points, data = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.column_stack((x, y, np.zeros(len(x)))), deep=True))
    data.SetPoints(points)
    return data


def judge(found, side, degree):
    """The verdict on a map in metres, with a trend of the degree."""
    verdict = vtkPatternVerdictFilter()
    verdict.SetInputData(points_of(side * found["x"], side * found["y"]))
    verdict.SetSize(side, side)
    verdict.SetTrendDegree(degree)
    verdict.Update()
    return verdict


def regrow(verdict, seed=2):
    """Positions of a pattern of the first process of a verdict [m]."""
    source = vtkPointProcessSource()
    source.SetInputConnection(verdict.GetOutputPort())
    source.SetSeed(seed)
    source.Update()
    return vtk_to_numpy(source.GetOutput().GetPoints().GetData())[:, :2].astype(float)


def trees_on(places, found, kind, seed=3):
    """Trees at places: with diameters or species drawn from the inventory, or of a kind and about a height."""
    draw = np.random.default_rng(seed)
    count = len(places)
    columns = {"x": places[:, 0], "y": places[:, 1]}
    if kind:
        _, preset, height, spread = kind
        heights = height * np.exp(spread * draw.standard_normal(count))
        columns |= {"species": [preset.lower()] * count, "height": heights}
        columns |= {"dbh": OPEN_GROWN * heights} if preset == "Pine" else {}
    if "dbh" in found:
        columns |= {"dbh": draw.choice(found["dbh"], count), "species": ["longleaf pine"] * count}
    if "species" in found:
        columns |= {"species": draw.choice(found["species"], count)}
    table = stand.table_of_words(columns, ((str(word) for word in words) for words in columns.values()))
    kinds = {"pine": "Pine", "shrub": "Shrub"} if kind else None
    return stand.read_inventory(table, species=kinds)


def renderer_at(row, first, last):
    """A renderer of columns of a row."""
    renderer = vtkRenderer()
    low = 1.0 - TOP - (row + 1) * ROW
    renderer.SetViewport(COLUMNS[first], low, COLUMNS[last], low + ROW)
    renderer.SetBackground(*PAPER)
    return renderer


def draw_map(renderer, x, y, color, text, species=None):
    """Points of a unit square, with its frame and a line of text."""
    kinds = sorted(set(species)) if species is not None else []
    shades = ((0.30, 0.52, 0.30), (0.80, 0.56, 0.22), (0.42, 0.50, 0.62), (0.66, 0.34, 0.28), (0.56, 0.62, 0.24),
              (0.55, 0.45, 0.60))
    colors = np.array([shades[kinds.index(word)] if kinds else color for word in (species if kinds else x)])
    radius = float(np.clip(0.10 / np.sqrt(len(x)), 0.004, 0.012))
    angles = np.arange(16) * 2.0 * np.pi / 16.0
    corners = np.column_stack((x, y))[:, None] + radius * np.column_stack((np.cos(angles), np.sin(angles)))
    for part, tint in ((corners, colors), (np.array([[[0, 0], [1, 0], [1, 1], [0, 1]]], float), None)):
        points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        flat = np.concatenate((part.reshape(-1, 2), np.zeros((part.shape[0] * part.shape[1], 1))), axis=1)
        points.SetData(numpy_to_vtk(flat, deep=True))
        for k in range(len(part)):
            ring = list(range(part.shape[1] * k, part.shape[1] * (k + 1)))
            cells.InsertNextCell(len(ring) + (tint is None), ring + ring[:1] if tint is None else ring)
        data.SetPoints(points)
        if tint is None:
            data.SetLines(cells)
        else:
            data.SetPolys(cells)
            rgb = numpy_to_vtk((255.0 * np.repeat(tint, part.shape[1], axis=0)).astype(np.uint8), deep=True)
            data.GetPointData().SetScalars(rgb)
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(*FAINT)
        actor.GetProperty().SetLineWidth(2.0)
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.5, 0.46, 0.0)
    camera.SetPosition(0.5, 0.46, 10.0)
    camera.SetParallelScale(0.66)
    renderer.AddActor(label(text, (0.5, 0.085), 34, FAINT))


def draw_curve(renderer, verdict, size):
    """The pair correlation of a map within the envelope of its best process."""
    envelope = verdict.GetOutput(1)
    names = ("Distance", "Measured", "Theoretical", "Mean", "GlobalLow", "GlobalHigh")
    values = {name: column(envelope, name) for name in names}
    table = table_of(values)
    chart = vtkChartXY()
    band = chart.AddPlot(vtkChart.AREA)
    band.SetInputData(table)
    for k, name in enumerate(("Distance", "GlobalLow", "GlobalHigh")):
        band.SetInputArray(k, name)
    band.GetBrush().SetColorF(0.80, 0.85, 0.80, 1.0)
    for name, color, width in (("Theoretical", (0.6, 0.6, 0.6), 1.5), ("Mean", (0.35, 0.55, 0.38), 3.0), ("Measured", INK, 4.5)):
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(table, "Distance", name)
        set_plot_color(line, color)
        line.SetWidth(width)
    for which, title, high in (
            (vtkAxis.BOTTOM, "distance [m]", values["Distance"].max()),
            (vtkAxis.LEFT, "", 1.05 * max(np.nanmax(values["GlobalHigh"][1:]), np.nanmax(values["Measured"][1:])))):
        axis = chart.GetAxis(which)
        axis.SetTitle(title)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(0.0, high)
        axis.SetCustomTickPositions(ticks_up_to(high))
        axis.SetNotation(vtkAxis.PRINTF_NOTATION)
        axis.SetLabelFormat("%g")
        axis.GetPen().SetColorF(*FAINT)
        axis.GetGridPen().SetColorF(0.90, 0.90, 0.88)
        for text in (axis.GetTitleProperties(), axis.GetLabelProperties()):
            text.SetFontSize(30)
            text.SetColor(*FAINT)
            text.BoldOff()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(0.0, 0.10 * size[1], 0.98 * size[0], 0.86 * size[1]))
    actor = vtkContextActor()
    actor.GetScene().AddItem(chart)
    renderer.AddActor(actor)
    law, p = (verdict.GetOutput(0).GetValueByName(0, name) for name in ("Law", "PValue"))
    renderer.AddActor(label(f"{spelled(law.ToString())}: p = {p.ToDouble():.2f}", (0.55, 0.085), 34, FAINT))


def ticks_up_to(high):
    """Three to five round numbers from 0 on."""
    step = 10.0 ** np.floor(np.log10(high / 3.0))
    step *= max(factor for factor in (1.0, 2.0, 5.0) if factor * step <= high / 3.0)
    ticks = vtkDoubleArray()
    for k in range(int(high / step) + 1):
        ticks.InsertNextValue(k * step)
    return ticks


def spelled(name):
    """`LogGaussianCox` as words."""
    words = "".join(" " + letter.lower() if letter.isupper() else letter for letter in name).strip()
    return {"log gaussian cox": "log-Gaussian Cox"}.get(words, words.replace("matern", "Matérn").capitalize())


def draw_stand(renderer, trees, side, colors):
    """Plants on ground of colors, seen from the southern edge."""
    heights = stand.numbers(trees, "Height")
    eye = (0.5 * side, -0.50 * side, 0.20 * side + 1.1 * float(np.median(heights)))
    focus = (0.5 * side, 0.5 * side, 0.4 * float(np.median(heights)))
    towards = np.subtract(focus, eye)
    forest = stand.plant(trees, UseLevels=True, NearDistance=55.0, FarDistance=170.0, AspectRatio=1.88)
    forest.SetViewPoint(*eye)
    forest.SetViewDirection(*(towards / np.linalg.norm(towards)))
    forest.SetViewAngle(36.0)
    forest.Update()
    for actor in plant_actors(forest):
        renderer.AddActor(actor)
    light(renderer, colors, SunAzimuth=255.0, SunElevation=24.0, CloudCover=0.25, Visibility=15000.0,
          ExposureCompensation=0.9, ShadowDistance=2.5 * side, CoverRadius=60.0, CoverHeight=0.3)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*focus)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(36.0)
    camera.SetClippingRange(0.02 * side, 60.0 * side)
    return forest


def main(folder, quick):
    """All rows as a picture."""
    os.makedirs(folder, exist_ok=True)
    window, kept = vtkRenderWindow(), []
    inventories = [each for each in INVENTORIES if each[0] == QUICK] if quick else INVENTORIES
    for row, (name, title, side, degree, kind) in enumerate(inventories):
        found = read_file(name) if quick else read(name)
        if found is None:
            print("There are no inventories: R and its package spatstat.data are not installed.")
            return
        verdict = judge(found, side, degree)
        places = regrow(verdict)
        law = verdict.GetOutput(0).GetValueByName(0, "Law").ToString()
        p = verdict.GetOutput(0).GetValueByName(0, "PValue").ToDouble()
        print(f"{name}: {len(found['x'])} points, best {law}, p = {p:.2f}; regrown {len(places)}")
        assert p > 0.05, name
        parts = [renderer_at(row, k, k + 1) for k in range(4)]
        draw_map(parts[0], found["x"], found["y"], (0.24, 0.42, 0.30), f"{title}: {len(found['x'])}", found.get("species"))
        size = [2 * PICTURE[k] * s for k, s in enumerate((COLUMNS[2] - COLUMNS[1], ROW))]
        draw_curve(parts[1], verdict, size)
        ground = kind[0] if kind else side
        trees = trees_on(ground / side * places, found, kind)
        names = trees.GetPointData().GetAbstractArray("SpeciesName") if "species" in found else None
        species = [names.GetValue(k) for k in range(len(places))] if names else None
        draw_map(parts[2], *(places / side).T, (0.24, 0.42, 0.30), f"regrown: {len(places)}", species)
        kept.append(draw_stand(parts[3], trees, ground, BROADLEAVED if "species" in found else SAVANNA))
        for part in parts:
            window.AddRenderer(part)
    head = vtkRenderer()
    head.SetViewport(0.0, 1.0 - TOP, 1.0, 1.0)
    head.SetBackground(*PAPER)
    for k, text in enumerate(("measured", "fitted: pair correlation g", "regrown", "planted")):
        head.AddActor(label(text, (0.5 * (COLUMNS[k] + COLUMNS[k + 1]), 0.85), 38, INK))
    window.AddRenderer(head)
    write_jpg(window, os.path.join(folder, "five-inventories.jpg"), [length // 2 for length in PICTURE] if quick else PICTURE)


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else ".", "--quick" in sys.argv)
