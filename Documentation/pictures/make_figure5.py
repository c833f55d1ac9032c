# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure5.jpg: how a branch takes its motion from those of three orthogonal beams.

    ./littoral run pvpython Documentation/pictures/make_figure5.py [FOLDER]

FOLDER: default, that of this script.

The beams are measured, not drawn by hand: four equal cantilevers stand in the same gusty wind, along x, y, z and along
a direction between them. Eq. 25, with the factor 1/2 that it lacks, makes the fourth's motion from the others'.
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws charts
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectf)
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkPlaneSource
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import vtkBeamTreeDeformationFilter, vtkWindFieldSource
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.plants import add_daylight
from littoral.tables import table_of

SIZE = (1400, 700)
LENGTH, RADIUS, NODES = 2.0, 0.0055, 25  # of a beam [m], [m], 1
BEAM = np.array((0.48, 0.50, 0.72))  # the direction of the fourth
#: Name, direction, color.
BEAMS = (("along x", (1.0, 0.0, 0.0), (0.80, 0.30, 0.13)), ("along y", (0.0, 1.0, 0.0), (0.20, 0.45, 0.68)),
         ("along z", (0.0, 0.0, 1.0), (0.30, 0.54, 0.25)), ("any beam", BEAM / np.linalg.norm(BEAM), (0.35, 0.20, 0.42)))
SHOWN, SPAN, STEP = 1.82, 8.0, 0.02  # of the picture on the left, of the curves [s]
DIRECTION = np.radians(35.0)  # where the wind blows to


def beam_along(direction):
    """A cantilever on a short post, as a plant: its foot is 4 m above the ground."""
    places = np.array((0.0, 0.0, 4.0)) + np.outer(np.linspace(0.0, LENGTH, NODES), direction)
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=True))
    data.SetPoints(points)
    lines.InsertNextCell(NODES, list(range(NODES)))
    data.SetLines(lines)
    parents, radii = vtkIntArray(), vtkFloatArray()
    parents.SetName("ParentId")
    radii.SetName("Radius")
    for node in range(NODES):
        parents.InsertNextValue(node - 1)
        radii.InsertNextValue(RADIUS)
    data.GetPointData().AddArray(parents)
    data.GetPointData().AddArray(radii)
    high, plant = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    high.SetBlock(0, data)
    high.GetMetaData(0).Set(high.NAME(), "Skeleton")
    plant.SetBlock(0, high)
    plant.GetMetaData(0).Set(plant.NAME(), "High")
    return plant


def same_wind_everywhere():
    """The wind at one place of a field, with the same gusts for all four beams."""
    source = vtkWindFieldSource()
    source.SetDimensions(800, 4, 4)
    source.SetTimeStep(0.05)
    source.SetReferenceSpeed(8.0)
    source.SetRoughnessLength(0.3)
    source.Update()
    field = source.GetOutput()
    line = vtk_to_numpy(field.GetPointData().GetArray("Velocity")).reshape(4, 4, 800, 3)[2, 2].astype(float)
    c, s = np.cos(DIRECTION), np.sin(DIRECTION)
    turned = np.column_stack((c * line[:, 0] - s * line[:, 1], s * line[:, 0] + c * line[:, 1], line[:, 2]))
    image, velocity, speed = vtkImageData(), numpy_to_vtk(np.tile(turned, (4, 1)), deep=True), vtkDoubleArray()
    image.SetDimensions(800, 2, 2)
    image.SetOrigin(0.0, -50.0, -50.0)
    image.SetSpacing(50.0, 100.0, 100.0)  # it comes with 1000 m/s, and so at once to all
    velocity.SetName("Velocity")
    image.GetPointData().AddArray(velocity)
    speed.SetName("ConvectionSpeed")
    speed.InsertNextValue(1000.0)
    image.GetFieldData().AddArray(speed)
    return image


def sway_of(direction, wind):
    """The filter that moves it."""
    sway = vtkBeamTreeDeformationFilter()
    sway.SetInputDataObject(0, beam_along(direction))
    sway.SetInputDataObject(1, wind)
    sway.SetWoodDensity(95.0)  # light: an upright beam is then as fast as a level one, as eq. 25 wants them
    sway.SetDampingRatio(0.04)
    return sway


def nodes_at(sway, time):
    """Positions at a time."""
    sway.UpdateTimeStep(time)
    return vtk_to_numpy(sway.GetOutput().GetBlock(0).GetBlock(0).GetPoints().GetData()).astype(float)


def small_amplitude(moved, direction):
    """The tip's deflection across the beam, as the beam theory has it: the arc is of the beam's length."""
    away = moved - moved[0]
    return away[-1] - (away[-1] @ direction) * np.asarray(direction)


def curves(sways):
    """Times; deflections of the tips [beam, time, axis]."""
    times = np.arange(0.0, SPAN, STEP)
    tips = np.array([[small_amplitude(nodes_at(sway, t), direction) for t in times]
                     for sway, (_, direction, _) in zip(sways, BEAMS)])
    return times, tips


def actor_of(source, color, opacity=1.0):
    """A surface in one color."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*color)
    look.SetOpacity(opacity)
    look.SetAmbient(0.35)
    return actor


def tube(places, color, radius, opacity=1.0):
    """A beam as a tube."""
    data, points, lines, round_ = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkTubeFilter()
    points.SetData(numpy_to_vtk(places, deep=True))
    data.SetPoints(points)
    lines.InsertNextCell(len(places), list(range(len(places))))
    data.SetLines(lines)
    round_.SetInputData(data)
    round_.SetRadius(radius)
    round_.SetNumberOfSides(24)
    round_.CappingOn()
    return actor_of(round_, color, opacity)


def arrow(start, vector, color):
    """An arrow from a point."""
    length = np.linalg.norm(vector)
    source = vtkArrowSource()
    source.SetTipResolution(24)
    source.SetShaftResolution(16)
    source.SetShaftRadius(min(0.06, 0.012 / length))
    source.SetTipRadius(min(0.16, 0.035 / length))
    source.SetTipLength(min(0.4, 0.12 / length))
    actor = actor_of(source, color)
    axis = np.asarray(vector) / length
    actor.SetScale(length)
    turn = np.degrees(np.arccos(np.clip(axis[0], -1.0, 1.0)))
    actor.RotateWXYZ(turn, 0.0, -axis[2], axis[1])
    actor.SetPosition(*start)
    return actor


def beams_view(sways):
    """The beams at one moment, at rest and bent."""
    renderer = vtkRenderer()
    renderer.SetViewport(0.0, 0.06, 0.46, 0.9)
    renderer.SetBackground(1.0, 1.0, 1.0)
    add_daylight(renderer, (200.0, 45.0))
    floor = vtkPlaneSource()
    for corner, setter in zip(((-0.5, -0.6), (2.6, -0.6), (-0.5, 2.6)),
                              (floor.SetOrigin, floor.SetPoint1, floor.SetPoint2)):
        setter(*corner, 3.6)
    plate = actor_of(floor, (0.93, 0.92, 0.89))
    plate.GetProperty().LightingOff()
    renderer.AddActor(plate)
    for sway, (_, direction, color) in zip(sways, BEAMS):
        rest = np.array((0.0, 0.0, 4.0)) + np.outer(np.linspace(0.0, LENGTH, NODES), direction)
        bent = nodes_at(sway, SHOWN)
        renderer.AddActor(tube(rest, (0.72, 0.72, 0.72), 0.012, 0.6))
        renderer.AddActor(tube(bent, color, 0.032))
        shadow = bent.copy()
        shadow[:, 2] = 3.61
        dark = tube(shadow, (0.80, 0.79, 0.76), 0.02)
        dark.GetProperty().LightingOff()
        renderer.AddActor(dark)
        if np.linalg.norm(bent[-1] - rest[-1]) > 0.05:
            renderer.AddActor(arrow(rest[-1], bent[-1] - rest[-1], color))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.95, 0.65, 4.75)
    camera.SetPosition(4.6, -7.2, 7.6)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(22.0)
    return renderer


def chart(times, tips, made, axis, name, place):
    """Deflections along an axis: those of the beams, and the fourth's from the recipe."""
    picture = vtkChartXY()
    picture.SetAutoSize(False)
    picture.SetSize(vtkRectf(*place))
    columns = {"t": times}
    for beam, (words, _, _) in enumerate(BEAMS):
        columns[words] = tips[beam, :, axis]
    columns["eq. 25"] = made[:, axis]
    table = table_of(columns)
    for column, (_, _, color) in enumerate(BEAMS):
        if np.ptp(tips[column, :, axis]) < 1e-4:
            continue  # a beam along the axis does not go that way
        plot = picture.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, 0, 1 + column)
        plot.SetColorF(*color)
        plot.SetWidth(3.0 if column < 3 else 7.0)
    plot = picture.AddPlot(vtkChart.LINE)
    plot.SetInputData(table, 0, 5)
    plot.SetColorF(0.98, 0.80, 0.25)
    plot.SetWidth(3.0)
    plot.GetPen().SetLineType(2)
    for side, title in ((vtkAxis.BOTTOM, "time [s]" if axis == 2 else ""), (vtkAxis.LEFT, name)):
        line = picture.GetAxis(side)
        line.SetTitle(title)
        for text in (line.GetTitleProperties(), line.GetLabelProperties()):
            text.SetFontSize(26)
            text.SetBold(False)
            text.SetColor(*INK)
        line.GetGridPen().SetColorF(0.92, 0.92, 0.92)
    across = picture.GetAxis(vtkAxis.BOTTOM)
    across.SetBehavior(vtkAxis.FIXED)
    across.SetRange(0.0, SPAN)
    return picture


def main(folder):
    """Measure, compare, draw."""
    wind = same_wind_everywhere()
    sways = [sway_of(direction, wind) for _, direction, _ in BEAMS]
    times, tips = curves(sways)
    u = np.array(BEAMS[3][1])
    half = 0.5 * tips[:3].sum(axis=0)
    made = half - np.outer(half @ u, u)
    error = np.sqrt(((made - tips[3]) ** 2).sum(axis=-1).mean() / (tips[3] ** 2).sum(axis=-1).mean())
    print(f"tips go up to {np.linalg.norm(tips, axis=-1).max():.3f} m; eq. 25 misses the beam by {100.0 * error:.2g} % rms")
    window, back = vtkRenderWindow(), vtkRenderer()
    back.SetBackground(1.0, 1.0, 1.0)
    wide, high = 2 * SIZE[0], 2 * SIZE[1]
    for axis, name in enumerate("xyz"):
        actor = vtkContextActor()
        place = (0.47 * wide, (0.63 - 0.27 * axis) * high, 0.52 * wide, 0.26 * high)
        actor.GetScene().AddItem(chart(times, tips, made, axis, f"{name} [m]", place))
        back.AddActor(actor)
    back.AddActor(label("Three beams and any other in the same wind", (0.23, 0.985), 52, INK))
    back.AddActor(label("Where their tips go, along x, y and z", (0.74, 0.985), 52, INK))
    for index, (words, _, color) in enumerate(BEAMS):
        back.AddActor(label(words, (0.07 + 0.11 * index, 0.055), 40, color))
    back.AddActor(label("dashed: half the sum of the three, across the fourth", (0.74, 0.055), 40, FAINT))
    window.AddRenderer(back)
    window.AddRenderer(beams_view(sways))
    window.GetRenderers().GetItemAsObject(1).SetLayer(1)
    window.SetNumberOfLayers(2)
    write_jpg(window, os.path.join(folder, "figure5.jpg"), SIZE, quality=86)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
