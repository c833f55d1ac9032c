# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure6.jpg: cells over a forest, what of them a view keeps, and the picture that it gives.

    ./littoral run pvpython Documentation/pictures/make_figure6.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

from littoral import vtkPlantScatterFilter, vtkQuadratPointSource, vtkReevesTreeSource
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.plants import level_actors, plant_actor

SIDE, TREES_A_SIDE = 400.0, 20  # [m], 1
EYE, HEADING = np.array((150.0, 14.0, 5.0)), np.radians(68.0)
VIEW_ANGLE, ASPECT = 33.0, 1.75  # [degrees], width by height
NEAR, FAR = 70.0, 180.0  # [m]

PICTURE = (1600, 900)  # pixels, as all places and sizes below
MAP, LEFT, BOTTOM = 812, 40, 30
VIEW = (904, 464, 662, 378)  # left, bottom, width, height

PAPER, KEPT, LINES = (0.975, 0.972, 0.965), (1.0, 0.93, 0.70), (0.80, 0.79, 0.77)
VOLUME = (0.16, 0.42, 0.66)
LEVELS = ((0.80, 0.30, 0.13), (0.30, 0.54, 0.25), (0.20, 0.45, 0.58))
CULLED = (0.77, 0.77, 0.75)


def scatter():
    """The forest as the view shows it; place [m], crown radius [m] of all of its trees."""
    sites = vtkQuadratPointSource()
    sites.SetQuadrats(TREES_A_SIDE, TREES_A_SIDE)
    sites.SetSize(SIDE, SIDE)
    sites.SetSeed(3)
    forest = vtkPlantScatterFilter()
    forest.SetInputConnection(0, sites.GetOutputPort())
    radii = []
    for preset in (1, 2, 3):
        tree = vtkReevesTreeSource()
        tree.SetPreset(preset)
        tree.Update()
        bounds = part(tree, "Medium", "Crown").GetBounds()
        radii.append(0.5 * (bounds[1] - bounds[0]))
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetViewPoint(EYE)
    forest.SetViewDirection(np.cos(HEADING), np.sin(HEADING), 0.0)
    forest.SetViewAngle(VIEW_ANGLE)
    forest.SetAspectRatio(ASPECT)
    forest.SetNearDistance(NEAR)
    forest.SetFarDistance(FAR)
    forest.UseCullingOff()
    forest.Update()
    crowns = np.array(radii)[field(forest, "Species")] * field(forest, "Scale")
    places = field(forest, "Position")[:, :2]
    forest.UseCullingOn()
    forest.Update()
    return forest, places, crowns


def field(forest, name):
    """A field array of the forest, as numbers."""
    return vtk_to_numpy(forest.GetOutputDataObject(0).GetFieldData().GetArray(name)).copy()


def cells_of(sites):
    """Columns, rows, corner, size of a cell, and the cell (column, row) of each site."""
    low, size = sites.min(axis=0), np.ptp(sites, axis=0)
    step = np.sqrt(size[0] * size[1] / len(sites))
    count = np.round(size / step).astype(int)
    step = size / count
    return count, low, step, np.minimum(((sites - low) / step).astype(int), count - 1)


def place(points):
    """Metres on the ground to pixels of the picture."""
    return np.asarray(points)[..., :2] * (MAP / SIDE) + (LEFT, BOTTOM)


def drawn(outlines, colors, depth, as_lines=False, width=1.0):
    """Actor of polygons or lines [pixels] with a color (red, green, blue, opacity) each."""
    points, cells = vtkPoints(), vtkCellArray()
    rows = np.concatenate([np.column_stack((o, np.full(len(o), depth))) for o in outlines])
    points.SetData(numpy_to_vtk(rows, deep=True))
    first = 0
    for outline in outlines:
        cells.InsertNextCell(len(outline), range(first, first + len(outline)))
        first += len(outline)
    data = vtkPolyData()
    data.SetPoints(points)
    (data.SetLines if as_lines else data.SetPolys)(cells)
    rgba = np.round(255.0 * np.asarray(colors)).astype(np.uint8)
    data.GetCellData().SetScalars(numpy_to_vtk(rgba, deep=True))
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetLineWidth(2.0 * width)
    return actor


def blob(center, radius, random):
    """The outline of a crown from above."""
    angle = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
    lobes = 1.0 + sum(
        0.22 / waves * np.sin(waves * angle + random.uniform(0.0, 7.0)) for waves in range(4, 10))
    return center + radius * lobes[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))


def arc(radius, half):
    """A part of a circle about the eye, across the view [pixels]."""
    angle = np.linspace(HEADING - half, HEADING + half, 60)
    return place(EYE[:2] + radius * np.column_stack((np.cos(angle), np.sin(angle))))


def clipped(outline):
    """The part of a convex outline [m] that lies on the map."""
    for axis, bound, sign in ((0, 0.0, 1), (0, SIDE, -1), (1, 0.0, 1), (1, SIDE, -1)):
        kept = []
        for a, b in zip(outline, np.roll(outline, -1, axis=0)):
            inside_a, inside_b = sign * (a[axis] - bound) >= 0, sign * (b[axis] - bound) >= 0
            if inside_a:
                kept.append(a)
            if inside_a != inside_b:
                kept.append(a + (bound - a[axis]) / (b[axis] - a[axis]) * (b - a))
        outline = np.array(kept)
    return outline


def map_actors(forest, sites, crowns):
    """The plan: cells, view volume, trees."""
    level = np.full(len(sites), 3)
    level[field(forest, "PlantId")] = field(forest, "Level")
    count, low, step, cell = cells_of(sites)
    kept = {tuple(c) for c in cell[level < 3]}
    assert len(kept) == field(forest, "CellsShown")[0], "the cells are not those of the filter"
    boxes = {(i, j): place(low + step * np.array(((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))))
             for i in range(count[0]) for j in range(count[1])}
    yield drawn([boxes[c] for c in kept], [(*KEPT, 1.0)] * len(kept), 1.0)
    outlines = [np.vstack((box, box[:1])) for box in boxes.values()]
    yield drawn(outlines, [(*LINES, 1.0)] * len(outlines), 2.0, as_lines=True)
    half = np.arctan(np.tan(np.radians(VIEW_ANGLE / 2)) * ASPECT)
    far = [EYE[:2] + 900.0 * np.array((np.cos(a), np.sin(a))) for a in (HEADING - half, HEADING + half)]
    wedge = place(clipped(np.array([EYE[:2], *far])))
    yield drawn([wedge], [(*VOLUME, 0.10)], 3.0)
    random = np.random.default_rng(1)
    radius = crowns * MAP / SIDE
    colors = np.array((*LEVELS, CULLED))[level]
    centers = place(sites)
    yield drawn([blob(c + (2.0, -2.5), r, random) for c, r in zip(centers, radius)],
                [(0.2, 0.2, 0.15, 0.20 if k < 3 else 0.07) for k in level], 4.0)
    yield drawn([blob(c, r, random) for c, r in zip(centers, radius)],
                [(*c, 1.0) for c in colors], 5.0)
    light = 1.0 - 0.66 * (1.0 - colors)
    yield drawn([blob(c + (-0.22 * r, 0.25 * r), 0.52 * r, random) for c, r in zip(centers, radius)],
                [(*c, 0.8) for c in light], 6.0)
    for distance in (NEAR, FAR):
        ring = arc(distance, half)
        dashes = [ring[k:k + 3] for k in range(0, len(ring) - 2, 4)]
        yield drawn(dashes, [(*VOLUME, 1.0)] * len(dashes), 7.0, as_lines=True, width=2.4)
    sides = [np.array((wedge[0], p)) for p in (wedge[1], wedge[-1])]
    yield drawn(sides, [(*VOLUME, 1.0)] * 2, 7.0, as_lines=True, width=2.0)
    for distance in (NEAR, FAR):
        x, y = place(EYE[:2] + (distance + 12.0) * np.array((np.cos(HEADING + half + 0.02), np.sin(HEADING + half + 0.02))))
        yield written(f"{distance:.0f} m", x - 52, y + 4, 16, VOLUME)
    eye = place(EYE)
    for size, color, depth in ((13.0, (1.0, 1.0, 1.0, 1.0), 8.0), (9.0, (*VOLUME, 1.0), 9.0)):
        angle = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
        yield drawn([eye + size * np.column_stack((np.cos(angle), np.sin(angle)))], [color], depth)


def written(text, x, y, size, color, left=True):
    """Text that starts, or is centered, at x; y: of its upper edge."""
    actor = label(text, (x / PICTURE[0], y / PICTURE[1]), 2 * size, color)
    if left:
        actor.GetTextProperty().SetJustificationToLeft()
    return actor


def legend(forest):
    """Legend of the colors, with numbers."""
    random = np.random.default_rng(2)
    shown = [int(field(forest, f"Plants{name}")[0]) for name in ("High", "Medium", "Low")]
    trees = int(field(forest, "PlantsInAll")[0])
    polygons = field(forest, "PolygonsShown")[0], field(forest, "PolygonsInAll")[0]
    texts = (
        f"High: {shown[0]} trees, up to {NEAR:.0f} m, branches and leaves",
        f"Medium: {shown[1]} trees, up to {FAR:.0f} m, trunk and tufts of leaves",
        f"Low: {shown[2]} trees, beyond, a picture each",
        f"Culled: {trees - sum(shown)} trees, not processed")
    left = VIEW[0] + 16
    for line, (text, color) in enumerate(zip(texts, (*LEVELS, CULLED))):
        y = 368 - 46 * line
        yield drawn([blob(np.array((left, y)), 13.0, random)], [(*color, 1.0)], 5.0)
        yield written(text, left + 34, y + 12, 19, INK)
    square = np.array(((-13, -13), (13, -13), (13, 13), (-13, 13)))
    y = 368 - 46 * 4
    yield drawn([square + (left, y)], [(*KEPT, 1.0)], 5.0)
    yield drawn([np.vstack((square, square[:1])) + (left, y)], [(*LINES, 1.0)], 6.0, as_lines=True)
    cells = int(field(forest, "CellsShown")[0]), int(field(forest, "CellsInAll")[0])
    yield written(f"Cells that the view volume meets: {cells[0]} of {cells[1]} with trees", left + 34, y + 12, 19, INK)
    count = [f"{number:,.0f}".replace(",", " ") for number in polygons]
    yield written(f"Polygons: {count[0]} of {count[1]}, one in {polygons[1] / polygons[0]:.0f}", left - 14, 112, 25, INK)
    yield written("What the eye sees", VIEW[0], PICTURE[1] - 14, 19, FAINT)
    yield written("The forest from above, 400 m wide", LEFT, PICTURE[1] - 14, 19, FAINT)


def part(forest, *names):
    """A block of the forest by its path."""
    data = forest.GetOutputDataObject(0)
    for name in names:
        index = next(k for k in range(data.GetNumberOfBlocks()) if data.GetMetaData(k).Get(data.NAME()) == name)
        data = data.GetBlock(index)
    return data


def eye_renderer(forest):
    """The forest from the eye."""
    renderer = vtkRenderer()
    left, bottom, width, height = VIEW
    renderer.SetViewport(
        left / PICTURE[0], bottom / PICTURE[1], (left + width) / PICTURE[0], (bottom + height) / PICTURE[1])
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.90, 0.93, 0.95)
    renderer.SetBackground2(0.55, 0.72, 0.88)
    renderer.AutomaticLightCreationOff()
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(12)
    for direction, intensity in (((-0.7, -0.5, 0.6), 1.1), ((0.0, 0.0, 1.0), 0.5), ((0.8, -0.6, 0.1), 0.4)):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*(1000.0 * np.array(direction)))
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
    ground = vtkPlaneSource()
    ground.SetOrigin(-1500.0, -1500.0, 0.0)
    ground.SetPoint1(2000.0, -1500.0, 0.0)
    ground.SetPoint2(-1500.0, 2000.0, 0.0)
    ground.Update()
    meadow = plant_actor(ground.GetOutput())
    meadow.GetProperty().SetColor(0.45, 0.52, 0.29)
    meadow.GetProperty().LightingOff()
    renderer.AddActor(meadow)
    for level in ("High", "Medium", "Low"):
        for actor in level_actors(forest, level, cut_leaves=True):
            renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(*(EYE + (np.cos(HEADING), np.sin(HEADING), 0.0)))
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetClippingRange(1.0, 2500.0)
    return renderer


def main(folder):
    """Draw the picture into a folder."""
    forest, sites, crowns = scatter()
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(*PAPER)
    for actor in (*map_actors(forest, sites, crowns), *legend(forest)):
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * PICTURE[1])
    camera.SetFocalPoint(0.5 * PICTURE[0], 0.5 * PICTURE[1], 0.0)
    camera.SetPosition(0.5 * PICTURE[0], 0.5 * PICTURE[1], 100.0)
    camera.SetClippingRange(1.0, 200.0)
    window.AddRenderer(renderer)
    window.AddRenderer(eye_renderer(forest))
    write_jpg(window, os.path.join(folder, "figure6.jpg"), PICTURE, quality=66)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
