# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure-sea-2.jpg of the user guide: the four flow primitives, and what drifts in their sum.

    ./littoral run pvpython Documentation/pictures/make_figure_sea_2.py [FOLDER]
"""

import math
import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import vtkCurrentDriftFilter, vtkFlowPrimitiveSource
from littoral.picture import label, write_jpg

SIZE = (1500, 424)
HALF = 3.0  # of the width of a panel [m]
PALE = (0.88, 0.95, 0.95)
DIM = (0.58, 0.74, 0.78)
DEEP, LIGHT = np.array([18, 62, 84]), np.array([196, 240, 226])
FRAMES = 46
TOP = 3.45  # above which the titles are [m]
BARE = dict(Strength=0.55, Axis=(1.0, 0.0, 0.0))
#: Title, note, flows as (type, properties), seconds.
PANELS = (
    ("Uniform", "one velocity", [("Uniform", BARE)], 2.6),
    ("Source", "away from a point", [("Source", dict(Strength=11.0, CoreRadius=0.3))], 1.5),
    ("Sink", "the opposite; it captures", [("Sink", dict(Strength=11.0, CoreRadius=0.3))], 2.6),
    ("Vortex", "around an axis", [("Vortex", dict(Strength=4.2, CoreRadius=0.5))], 2.0),
    ("Sum", "all four together",
     [("Uniform", dict(Strength=0.3, Axis=(1.0, 0.25, 0.0))),
      ("Source", dict(Strength=7.0, Center=(-1.7, -0.9, 0.0), CoreRadius=0.3)),
      ("Sink", dict(Strength=7.0, Center=(1.8, -1.2, 0.0), CoreRadius=0.3)),
      ("Vortex", dict(Strength=3.6, Center=(0.2, 1.3, 0.0), CoreRadius=0.5))], 2.2),
)


def flow(kind, properties):
    """One primitive; vortices turn about the viewer's axis."""
    source = vtkFlowPrimitiveSource()
    source.SetFlowType(("Uniform", "Source", "Sink", "Vortex").index(kind))
    source.SetAxis(0.0, 0.0, 1.0)
    for name, value in properties.items():
        getattr(source, "Set" + name)(*value if isinstance(value, tuple) else (value,))
    return source


def seeds():
    """Places on a disturbed lattice that is a little larger than the panel."""
    generator = np.random.Generator(np.random.Philox(5))
    step = 0.28
    x, y = np.meshgrid(*2 * [np.arange(-HALF - 1.6, HALF + 2.0, step)])
    places = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    places[:, :2] += generator.uniform(-0.45, 0.45, (x.size, 2)) * step
    return places


def points_of(places):
    """Points in double precision."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    return points


def paths(flows, seconds):
    """Places [frame, particle, axis], speeds, and which were captured at the end."""
    data = vtkPolyData()
    data.SetPoints(points_of(seeds()))
    drift = vtkCurrentDriftFilter()
    drift.SetInputData(0, data)
    drift.SetTimeStep(0.02)
    drift.KeepInWaterOff()
    drift.GenerateCurrentOn()
    sources = [flow(*one) for one in flows]
    for source in sources:
        drift.AddCurrentConnection(source.GetOutputPort())
    places, speeds = [], []
    for frame in range(FRAMES):
        drift.UpdateTimeStep(seconds * frame / (FRAMES - 1))
        output = drift.GetOutput()
        places.append(vtk_to_numpy(output.GetPoints().GetData()).copy())
        current = vtk_to_numpy(output.GetPointData().GetArray("Current"))
        speeds.append(np.linalg.norm(current, axis=1))
    captured = vtk_to_numpy(output.GetPointData().GetArray("Captured")).astype(bool)
    return np.array(places), np.array(speeds), captured


def trails(places, speeds):
    """Ribbons that widen and brighten from where a particle was to where it is; faster ones are brighter."""
    frames, count = places.shape[:2]
    along = np.gradient(places, axis=0)
    length = np.linalg.norm(along, axis=2, keepdims=True)
    side = np.stack([-along[..., 1], along[..., 0], np.zeros(along.shape[:2])], -1) / np.maximum(length, 1e-9)
    share = np.linspace(0.0, 1.0, frames)[:, None, None]
    half = 0.020 * share ** 0.8 * (length > 1e-7)
    edges = np.stack([places - half * side, places + half * side], 2)  # frame, particle, side, axis
    bright = np.clip(speeds / 1.5, 0.0, 1.0)[..., None] ** 0.6
    color = DEEP + share ** 1.4 * (0.25 + 0.75 * bright) * (LIGHT - DEEP)
    colors = np.repeat(color[:, :, None, :], 2, 2)
    index = np.arange(frames * count * 2).reshape(frames, count, 2)
    quads = np.stack([index[:-1, :, 0], index[1:, :, 0], index[1:, :, 1], index[:-1, :, 1]], -1).reshape(-1)
    data = vtkPolyData()
    data.SetPoints(points_of(edges.reshape(-1, 3)))
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtk(quads, deep=True, array_type=vtkIdTypeArray().GetDataType()))
    data.SetPolys(cells)
    data.GetPointData().SetScalars(numpy_to_vtk(
        colors.reshape(-1, 3).astype(np.uint8), deep=True, array_type=vtkUnsignedCharArray().GetDataType()))
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def disc(center, radius, color, layer, sides=40):
    """A filled circle."""
    angles = 2.0 * math.pi * np.arange(sides) / sides
    places = np.column_stack([center[0] + radius * np.cos(angles), center[1] + radius * np.sin(angles),
                              np.full(sides, layer)])
    data = vtkPolyData()
    data.SetPoints(points_of(places))
    cells = vtkCellArray()
    cells.InsertNextCell(sides, list(range(sides)))
    data.SetPolys(cells)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*color)
    return actor


def dots(places, captured):
    """Small discs where particles are now."""
    actors = []
    for place, held in zip(places, captured):
        if not held and max(abs(place[0]), abs(place[1])) < HALF + 0.6:
            actors.append(disc(place, 0.043, (0.97, 0.72, 0.40), 0.02, 14))
    return actors


def panel(index, title, note, flows, seconds):
    """Trails of particles in one current."""
    renderer = vtkRenderer()
    width = 1.0 / len(PANELS)
    renderer.SetViewport(index * width + 0.002, 0.0, (index + 1) * width - 0.002, 1.0)
    renderer.SetBackground(*(DEEP / 255.0))
    places, speeds, captured = paths(flows, seconds)
    renderer.AddActor(trails(places, speeds))
    for actor in dots(places[-1], captured):
        renderer.AddActor(actor)
    for kind, properties in flows:
        if kind != "Uniform":
            center = properties.get("Center", (0.0, 0.0, 0.0))
            color = {"Source": (0.98, 0.93, 0.72), "Sink": (0.03, 0.12, 0.18), "Vortex": (0.75, 0.93, 0.90)}[kind]
            renderer.AddActor(disc(center, 0.16, PALE, 0.05))
            renderer.AddActor(disc(center, 0.125, color, 0.06))
    aspect = SIZE[1] / (SIZE[0] * width)
    renderer.AddActor(label(title, (0.5, 0.965), 52, PALE))
    renderer.AddActor(label(note, (0.5, 0.855), 30, DIM))
    cover = vtkPolyData()
    places = [(x, y, 0.1) for x, y in ((-4.0, TOP), (4.0, TOP), (4.0, 9.0), (-4.0, 9.0))]
    cover.SetPoints(points_of(np.array(places)))
    cells = vtkCellArray()
    cells.InsertNextCell(4, [0, 1, 2, 3])
    cover.SetPolys(cells)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(cover)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*(DEEP / 255.0))
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(HALF * aspect)
    middle = HALF * (aspect - 1.0)
    camera.SetPosition(0.0, middle, 10.0)
    camera.SetFocalPoint(0.0, middle, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    renderer.ResetCameraClippingRange()
    return renderer


def main(folder):
    """Draw the panels side by side."""
    window = vtkRenderWindow()
    paper = vtkRenderer()
    paper.SetBackground(1.0, 1.0, 1.0)
    window.AddRenderer(paper)
    for index, parts in enumerate(PANELS):
        window.AddRenderer(panel(index, *parts))
    write_jpg(window, os.path.join(folder, "figure-sea-2.jpg"), SIZE, quality=70)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
