# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure-sea-7.jpg of the user guide: a segment on its parent.

    ./littoral run pvpython Documentation/pictures/make_figure_sea_7.py [FOLDER]
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkBillboardTextActor3D, vtkPolyDataMapper, vtkRenderWindow)

from littoral.gallery.pictures import look, pale_renderer
from littoral.picture import INK, write_jpg

SIZE = (520, 440)
THETA, PHI = np.radians(52.0), np.radians(40.0)
H = 1.55  # along the parent
PARENT, OWN = (0.16, 0.42, 0.55), (0.78, 0.50, 0.14)
PALE = 0.55  # how much paler planes and arcs are


def turned(base, theta, phi):
    """X, Y, Z turned by theta about Y and then by phi about the new X."""
    x, y, z = base
    level = np.sin(theta) * x + np.cos(theta) * z
    return (np.cos(theta) * x - np.sin(theta) * z, np.cos(phi) * y + np.sin(phi) * level,
            np.cos(phi) * level - np.sin(phi) * y)


def actor_of(data, color, opacity=1.0):
    """Actor of a data set in one color."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetAmbient(0.35)
    return actor


def tube(places, radius, color):
    """A tube along places."""
    places = np.array(places, dtype=float)
    points, lines, data, tubes = vtkPoints(), vtkCellArray(), vtkPolyData(), vtkTubeFilter()
    points.SetData(numpy_to_vtk(places, deep=True))
    lines.InsertNextCell(len(places))
    for k in range(len(places)):
        lines.InsertCellPoint(k)
    data.SetPoints(points)
    data.SetLines(lines)
    tubes.SetInputData(data)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(16)
    tubes.CappingOn()
    tubes.Update()
    return actor_of(tubes.GetOutput(), color)


def arrow(renderer, foot, along, length, color, text):
    """An axis with its name."""
    tip = foot + length * along
    renderer.AddActor(tube([foot, tip], 0.014, color))
    cone = vtkConeSource()
    cone.SetResolution(24)
    cone.SetHeight(0.13)
    cone.SetRadius(0.045)
    cone.SetDirection(*along)
    cone.SetCenter(*(tip + 0.05 * along))
    cone.Update()
    renderer.AddActor(actor_of(cone.GetOutput(), color))
    name(renderer, tip + 0.2 * along, text, color)


def name(renderer, place, text, color):
    """A word at a place, facing the viewer."""
    words = vtkBillboardTextActor3D()
    words.SetInput(text)
    words.SetPosition(*place)
    style = words.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(36)
    style.SetColor(*color)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    renderer.AddActor(words)


def arc(renderer, middle, start, end, radius, color, text):
    """The angle between two unit vectors."""
    whole = np.arccos(np.clip(start @ end, -1.0, 1.0))
    side = (end - (start @ end) * start) / np.sin(whole)
    steps = np.linspace(0.0, whole, 40)[:, None]
    renderer.AddActor(tube(middle + radius * (np.cos(steps) * start + np.sin(steps) * side), 0.011, color))
    half = np.cos(0.5 * whole) * start + np.sin(0.5 * whole) * side
    name(renderer, middle + (radius + 0.2) * half, text, color)


def main(folder):
    """Draw it into a folder."""
    renderer = pale_renderer()
    parent = tuple(np.array(axis, dtype=float) for axis in ((1, 0, 0), (0, 0, 1), (0, -1, 0)))
    foot = np.zeros(3)
    start = foot + H * parent[1]
    half_way = turned(parent, THETA, 0.0)
    own = turned(parent, THETA, PHI)
    renderer.AddActor(tube([foot, foot + 2.0 * parent[1]], 0.075, PARENT))
    renderer.AddActor(tube([start, start + 1.25 * own[1]], 0.06, OWN))
    for axis, text in zip(parent, ("Xp", "Yp", "Zp")):
        arrow(renderer, foot, axis, 2.3 if text == "Yp" else 0.8, PARENT, text)
    for axis, text in zip(own, ("X", "Y", "Z")):
        arrow(renderer, start, axis, 1.6 if text == "Y" else 0.75, OWN, text)
    faint = tuple(PALE + (1.0 - PALE) * c for c in PARENT)
    for axis in (parent[0], parent[2]):
        renderer.AddActor(tube([start, start + 0.75 * axis], 0.008, faint))
    arc(renderer, start, parent[0], half_way[0], 0.6, INK, "theta")
    arc(renderer, start, parent[1], own[1], 0.66, INK, "phi")
    aside = foot - 0.22 * parent[0]
    renderer.AddActor(tube([aside, aside + H * parent[1]], 0.009, INK))
    for end in (aside, aside + H * parent[1]):
        renderer.AddActor(tube([end - 0.06 * parent[0], end + 0.06 * parent[0]], 0.009, INK))
    name(renderer, aside + 0.5 * H * parent[1] - 0.13 * parent[0], "h", INK)
    beside = start + 0.95 * own[1] + 0.22 * own[2]
    name(renderer, beside, "L", INK)
    look(renderer, (3.2, -8.6, 6.2), (0.2, 0.0, 1.3), 18.0)
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "figure-sea-7.jpg"), SIZE)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
