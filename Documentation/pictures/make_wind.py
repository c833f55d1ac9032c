# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure4.jpg of the user guide: two sections through a wind field.

    ./littoral run pvpython Documentation/pictures/make_wind.py [FOLDER]
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkGlyphSource2D
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

from littoral import vtkWindFieldSource
from littoral.picture import FAINT, INK, label, write_jpg

SIZE = (1400, 860)
LENGTH = 300.0  # of the sections [m]
SPEEDS = ((3.0, 0.08, 0.16, 0.36), (6.0, 0.13, 0.38, 0.56), (9.0, 0.28, 0.62, 0.62),
          (12.0, 0.66, 0.82, 0.58), (15.0, 0.98, 0.92, 0.62))  # [m/s] and color


def make_wind():
    """A fine box along x: velocities by layer, column and sample; spacing; height of the first."""
    source = vtkWindFieldSource()
    source.SetDimensions(1200, 81, 32)
    source.SetTimeStep(0.1)
    source.SetLateralSpacing(1.25)
    source.SetVerticalSpacing(2.0)
    source.SetRoughnessLength(0.1)
    source.Update()
    image = source.GetOutput()
    size = image.GetDimensions()
    velocity = vtk_to_numpy(image.GetPointData().GetArray("Velocity"))
    return velocity.reshape(size[2], size[1], size[0], 3), image.GetSpacing(), image.GetOrigin()[2]


def colors():
    """Colors of speeds."""
    function = vtkColorTransferFunction()
    for speed in SPEEDS:
        function.AddRGBPoint(*speed)
    return function


def section(speed, origin, spacing):
    """An actor of speeds, rows upwards."""
    image = vtkImageData()
    image.SetDimensions(speed.shape[1], speed.shape[0], 1)
    image.SetOrigin(0.0, origin, 0.0)
    image.SetSpacing(*spacing, 1.0)
    image.GetPointData().SetScalars(numpy_to_vtk(speed.ravel(), deep=True))
    surface, mapper, actor = vtkImageDataGeometryFilter(), vtkPolyDataMapper(), vtkActor()
    surface.SetInputData(image)
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(colors())
    mapper.InterpolateScalarsBeforeMappingOn()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def arrows(vectors, origin, spacing, every):
    """An actor of arrows in the plane: tails on every so many samples."""
    rows = np.arange(every[0] // 2, vectors.shape[0] - 2, every[0])
    columns = np.arange(every[1] // 2, vectors.shape[1] - every[1], every[1])
    x, y = np.meshgrid(columns * spacing[0], origin + rows * spacing[1])
    flat = np.zeros((x.size, 3))
    flat[:, 0], flat[:, 1], flat[:, 2] = x.ravel(), y.ravel(), 1.0
    points, data = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(flat, deep=True))
    data.SetPoints(points)
    tips = np.zeros((x.size, 3))
    tips[:, :2] = vectors[np.ix_(rows, columns)].reshape(-1, 2)
    data.GetPointData().SetVectors(numpy_to_vtk(tips, deep=True))
    shape, glyphs, mapper, actor = (
        vtkGlyphSource2D(), vtkGlyph3D(), vtkPolyDataMapper(), vtkActor())
    shape.SetGlyphTypeToThickArrow()
    shape.SetCenter(0.5, 0.0, 0.0)
    shape.FilledOn()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(shape.GetOutputPort())
    glyphs.SetScaleModeToScaleByVector()
    glyphs.SetScaleFactor(0.9)
    mapper.SetInputConnection(glyphs.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    actor.GetProperty().LightingOff()
    return actor


def panel(actors, viewport, middle, height):
    """A renderer that looks straight at a section."""
    renderer = vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.5 * LENGTH, middle, 0.0)
    camera.SetPosition(0.5 * LENGTH, middle, 100.0)
    camera.SetParallelScale(0.5 * height)
    return renderer


def legend():
    """The bar of speeds."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors())
    bar.SetTitle("m/s")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.0f")
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(40)
        text.SetColor(*INK)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    bar.SetPosition(0.925, 0.3)
    bar.SetWidth(0.06)
    bar.SetHeight(0.42)
    return bar


def main(folder):
    """Draw both sections, one above the other."""
    velocity, spacing, bottom = make_wind()
    count = int(LENGTH / spacing[0]) + 1
    layer = round((10.0 - bottom) / spacing[2])
    upright = velocity[:, velocity.shape[1] // 2, :count]
    flat = velocity[layer, :, :count]
    window = vtkRenderWindow()
    back = vtkRenderer()
    back.SetBackground(1.0, 1.0, 1.0)
    back.AddActor(label("A gusty wind, cut upright along its way: 300 m long, 62 m high",
                        (0.46, 0.985), 50, INK))
    back.AddActor(label(f"and level, {bottom + layer * spacing[2]:.0f} m above the ground, "
                        "100 m wide", (0.46, 0.60), 50, INK))
    back.AddActor(label("Arrows: the wind in the plane of the section. Colors: its speed. "
                        "The whole pattern moves to the right with 10 m/s.",
                        (0.46, 0.05), 38, FAINT))
    back.AddActor(legend())
    scale = 0.88 * SIZE[0] / LENGTH / SIZE[1]  # share of the picture's height for a metre
    for vectors, axes, step, start, low, every in (
            (upright, (0, 2), spacing[2], bottom, 0.64, (4, 15)),
            (flat, (0, 1), spacing[1], 0.0, 0.075, (7, 15))):
        height = (vectors.shape[0] - 1) * step
        speed = np.linalg.norm(vectors, axis=2)
        grid = (spacing[0], step)
        actors = [section(speed, start, grid), arrows(vectors[..., axes], start, grid, every)]
        window.AddRenderer(panel(actors, (0.02, low, 0.90, low + scale * height),
                                 start + 0.5 * height, height))
    window.AddRenderer(back)
    back.SetLayer(0)
    window.SetNumberOfLayers(2)
    renderers = window.GetRenderers()
    for index in range(2):
        renderers.GetItemAsObject(index).SetLayer(1)
    write_jpg(window, os.path.join(folder, "figure4.jpg"), SIZE)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
