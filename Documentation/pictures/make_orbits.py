# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure-sea-1.jpg of the user guide: orbits of particles in deep, intermediate and shallow water.

    ./littoral run pvpython Documentation/pictures/make_orbits.py [FOLDER]
"""

import math
import os
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import vtkParticleOrbitFilter, vtkSeaStateSource
from littoral.picture import FAINT, INK, label, write_jpg

SIZE = (1500, 620)
WAVELENGTH = 10.0  # [m]
HEIGHT = 5.4  # that a panel shows [m]
#: Title, depth [wavelengths], note.
PANELS = (
    ("Deep", 1.0, "deeper than half a wavelength:\ncircles that shrink with depth"),
    ("Intermediate", 0.22, "in between:\nellipses that flatten towards the bed"),
    ("Shallow", 0.045, "less than a twentieth of it:\nas long at the bed as above"),
)
TIMES = 72


def train(depth, amplitude):
    """A table with one train of the wavelength, on water of a depth [m]."""
    k = 2.0 * math.pi / WAVELENGTH
    sea = vtkSeaStateSource()
    sea.SetWaterDepth(depth)
    sea.SetSpreading(0.0)
    sea.SetNumberOfTrains(1)
    sea.Update()
    table = sea.GetOutput()
    frequency = math.sqrt(9.80665 * k * math.tanh(k * depth))
    for name, value in (("Amplitude", amplitude), ("AngularFrequency", frequency),
                        ("WaveNumber", k), ("Direction", 0.0), ("Phase", 0.0)):
        table.GetColumnByName(name).SetValue(0, value)
    return table, 2.0 * math.pi / frequency


def at_rest(places):
    """Points at x, z [m]."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for x, z in places:
        points.InsertNextPoint(x, 0.0, z)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def moved(places, table, time):
    """Places of particles with these centers at a time [s], as x, z."""
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputData(0, at_rest(places))
    orbits.SetInputData(1, table)
    orbits.UpdateTimeStep(time)
    points = orbits.GetOutput().GetPoints()
    return [points.GetPoint(i)[::2] for i in range(points.GetNumberOfPoints())]


def drawing(places, kind, color, width=1.0, layer=0.0):
    """A line, polygon or dots through places."""
    data = at_rest(places)
    cells = vtkCellArray()
    if kind == "dots":
        for i in range(len(places)):
            cells.InsertNextCell(1, [i])
        data.SetVerts(cells)
    else:
        cells.InsertNextCell(len(places), list(range(len(places))))
        (data.SetLines if kind == "line" else data.SetPolys)(cells)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.SetPosition(0.0, -layer, 0.0)
    look = actor.GetProperty()
    look.LightingOff()
    look.SetColor(*color)
    look.SetLineWidth(width)
    look.SetPointSize(width)
    look.RenderPointsAsSpheresOn()
    return actor


def band(upper, lower, color, layer):
    """Quadrilaterals between two lines."""
    data = at_rest(upper + lower)
    cells, n = vtkCellArray(), len(upper)
    for i in range(n - 1):
        cells.InsertNextCell(4, [i, i + 1, n + i + 1, n + i])
    data.SetPolys(cells)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.SetPosition(0.0, -layer, 0.0)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*color)
    return actor


def panel(index, title, share, note):
    """A side view of the water with orbits, and the particles at one moment."""
    renderer = vtkRenderer()
    renderer.SetViewport(index / len(PANELS), 0.0, (index + 1) / len(PANELS), 1.0)
    renderer.SetBackground(0.965, 0.97, 0.965)
    depth = share * WAVELENGTH
    amplitude = min(0.42, 0.24 * depth)
    table, period = train(depth, amplitude)
    half = 0.5 * HEIGHT * SIZE[0] / len(PANELS) / SIZE[1]
    bottom = max(-depth, -4.2)
    xs = [-half - 1.0 + (2.0 * half + 2.0) * i / 240 for i in range(241)]
    moment = 0.3 * period
    surface = moved([(x, 0.0) for x in xs], table, moment)
    steps = 24
    for step in range(steps):
        shades = []
        for part in (step / steps, (step + 1) / steps):
            shades.append([(x, z + part * (bottom - z)) for x, z in surface])
        fade = step / (steps - 1) * min(1.0, -bottom / 4.2)
        color = [a + fade * (b - a) for a, b in zip((0.62, 0.82, 0.86), (0.16, 0.42, 0.54))]
        renderer.AddActor(band(shades[0], shades[1], color, 0.0))
    renderer.AddActor(drawing(surface, "line", (0.10, 0.35, 0.45), 5.0, 0.1))
    if depth < 4.2:
        bed = [(x, bottom) for x in (xs[0], xs[-1])]
        renderer.AddActor(band(bed, [(x, -5.0) for x, _ in bed], (0.80, 0.72, 0.56), 0.2))
        renderer.AddActor(drawing(bed, "line", (0.50, 0.42, 0.28), 4.0, 0.3))
    columns = (-1.35, 0.0, 1.35) if share > 0.1 else (-1.1, 1.1)
    rows = (0.0, 0.25, 0.5, 0.75, 1.0) if share > 0.1 else (0.0, 0.5, 1.0)
    reach = -bottom if depth < 4.2 else 3.3
    centers = [(x, -part * reach) for x in columns for part in rows]
    paths = [moved(centers, table, period * i / TIMES) for i in range(TIMES + 1)]
    for particle in range(len(centers)):
        path = [places[particle] for places in paths]
        renderer.AddActor(drawing(path, "line", (0.04, 0.17, 0.24), 3.5, 0.4))
    renderer.AddActor(drawing(moved(centers, table, moment), "dots", (0.93, 0.45, 0.16), 20.0, 0.6))
    renderer.AddActor(label(title, (0.5, 0.975), 62, INK))
    renderer.AddActor(label(note, (0.5, 0.885), 34, FAINT))
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * HEIGHT)
    camera.SetPosition(0.0, -50.0, -1.1)
    camera.SetFocalPoint(0.0, 0.0, -1.1)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCameraClippingRange()
    return renderer


def main(folder):
    """Draw the three panels side by side."""
    window = vtkRenderWindow()
    for index, (title, share, note) in enumerate(PANELS):
        window.AddRenderer(panel(index, title, share, note))
    write_jpg(window, os.path.join(folder, "figure-sea-1.jpg"), SIZE)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
