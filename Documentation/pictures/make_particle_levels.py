# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure-sea-4.jpg, -5.jpg and -6.jpg: which particles a view needs, masters and slaves, and changes of level.

    ./littoral run pvpython Documentation/pictures/make_particle_levels.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import (
    vtkParticleFogFilter, vtkParticleLevelOfDetailFilter, vtkParticleOrbitFilter, vtkSeaStateSource)
from littoral.picture import FAINT, INK, label, write_jpg

PAPER = (0.975, 0.972, 0.965)
NEAR, MIDDLE, FAR = (0.85, 0.36, 0.13), (0.16, 0.50, 0.42), (0.28, 0.45, 0.68)
VOLUME, GREY = (0.16, 0.42, 0.66), (0.70, 0.70, 0.68)
WATER = ((0.80, 0.91, 0.93), (0.52, 0.72, 0.79))


# Drawing ------------------------------------------------------------------------------------------


class Sheet:
    """A picture in pixels, y upwards; later drawings lie over earlier ones."""

    def __init__(self, width, height):
        self.size = (width, height)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(*PAPER)
        self.layer = 0.0

    def _draw(self, outlines, colors, as_lines, width=1.0):
        self.layer += 1.0
        points, cells, first = vtkPoints(), vtkCellArray(), 0
        rows = [np.column_stack((outline, np.full(len(outline), self.layer))) for outline in outlines]
        points.SetData(numpy_to_vtk(np.concatenate(rows), deep=True))
        for outline in outlines:
            cells.InsertNextCell(len(outline), range(first, first + len(outline)))
            first += len(outline)
        data = vtkPolyData()
        data.SetPoints(points)
        (data.SetLines if as_lines else data.SetPolys)(cells)
        rgba = np.array([(*color, 1.0)[:4] for color in colors])
        data.GetCellData().SetScalars(numpy_to_vtk(np.round(255.0 * rgba).astype(np.uint8), deep=True))
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetLineWidth(2.0 * width)
        self.renderer.AddActor(actor)

    def areas(self, outlines, colors):
        """Polygons with a color (red, green, blue and, optionally, opacity) each, or one for all."""
        if len(outlines):
            self._draw(outlines, _each(colors, outlines), False)

    def lines(self, outlines, colors, width=1.0):
        """Lines; width in pixels."""
        if len(outlines):
            self._draw(outlines, _each(colors, outlines), True, width)

    def discs(self, centers, radii, colors):
        """Filled circles."""
        radii = np.broadcast_to(radii, len(centers))
        self.areas([circle(c, r) for c, r in zip(centers, radii)], colors)

    def text(self, words, x, y, height, color=INK, justified="left"):
        """Text whose upper edge is at y."""
        actor = label(words, (x / self.size[0], y / self.size[1]), 2 * height, color)
        if justified == "left":
            actor.GetTextProperty().SetJustificationToLeft()
        self.renderer.AddActor(actor)

    def write(self, folder, name, quality=80):
        """Draw off screen and write a JPEG."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5 * self.size[1])
        camera.SetFocalPoint(0.5 * self.size[0], 0.5 * self.size[1], 0.0)
        camera.SetPosition(0.5 * self.size[0], 0.5 * self.size[1], 500.0)
        camera.SetClippingRange(1.0, 600.0)
        window = vtkRenderWindow()
        window.AddRenderer(self.renderer)
        write_jpg(window, os.path.join(folder, f"{name}.jpg"), self.size, quality)


def _each(colors, outlines):
    return [colors] * len(outlines) if np.ndim(colors[0]) == 0 else colors


def circle(center, radius, parts=40):
    """An outline."""
    angle = np.linspace(0.0, 2.0 * np.pi, parts, endpoint=False)
    return np.asarray(center) + radius * np.column_stack((np.cos(angle), np.sin(angle)))


def closed(outline):
    """The outline as a line that ends where it starts."""
    return np.vstack((outline, outline[:1]))


def box(low, high):
    """A rectangle."""
    return np.array(((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])))


def dashes(line, on=2, period=4):
    """Parts of a line."""
    return [line[k:k + on + 1] for k in range(0, len(line) - on, period)]


# Particles ----------------------------------------------------------------------------------------


def data_of(places):
    """Points as a data set."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places, dtype=float), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def windy_sea(wind):
    """A sea state with all waves along x."""
    sea = vtkSeaStateSource()
    sea.SetWindSpeed(wind)
    sea.SetSpreading(0.0)
    sea.Update()
    return sea


def amplitude(sea, height):
    """The largest displacement of a particle at a height [m]."""
    table = sea.GetOutput()
    a, k = (vtk_to_numpy(table.GetColumnByName(name)) for name in ("Amplitude", "WaveNumber"))
    return (a * np.exp(np.outer(height, k))).sum(axis=1)


def block_of(levels, index, *names):
    """Places and arrays of a block."""
    block = levels.GetOutputDataObject(0).GetBlock(index)
    if block.GetNumberOfPoints() == 0:
        return np.zeros((0, 3)), *(np.zeros(0, int) for _ in names)
    arrays = [vtk_to_numpy(block.GetPointData().GetArray(name)).copy() for name in names]
    return vtk_to_numpy(block.GetPoints().GetData()).copy(), *arrays


def paths(data, sea, times):
    """Places of particles over times: moment, particle, axis."""
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputData(0, data)
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    found = []
    for time in times:
        orbits.UpdateTimeStep(time)
        found.append(vtk_to_numpy(orbits.GetOutputDataObject(0).GetPoints().GetData()).copy())
    return np.array(found)


def cells_of(places, cell, group=4):
    """Cells of whole groups, as the filter makes them: members."""
    cells, stack = [], [np.arange(len(places))]
    while stack:
        members = stack.pop()
        if len(members) <= cell:
            cells.append(members)
            continue
        axis = np.argmax(np.ptp(places[members], axis=0))
        members = members[np.lexsort((members, places[members, axis]))]
        half = (len(members) + group - 1) // group // 2 * group
        stack += [members[:half], members[half:]]
    return cells


# Figures ------------------------------------------------------------------------------------------


def figure_4(folder):
    """Cells first, then orbits: a slice of the sea from the side."""
    sheet, scale, left, top = Sheet(1500, 690), 58.0, 25.0, 600.0
    length, depth = 25.0, 9.1
    random = np.random.default_rng(11)
    places = np.column_stack((random.uniform(3.0, length - 0.2, 480), random.uniform(-0.02, 0.02, 480),
                              random.uniform(-depth + 0.15, -0.1, 480)))
    sea = windy_sea(4.6)
    eye = np.array((1.0, 0.0, -4.4))
    levels = vtkParticleLevelOfDetailFilter()
    levels.SetInputData(0, data_of(places))
    levels.SetSeaStateConnection(sea.GetOutputPort())
    levels.SetViewPoint(*eye)
    levels.SetViewDirection(1.0, 0.0, 0.0)
    levels.SetViewAngle(22.0)
    levels.SetParticlesPerCell(12)
    levels.UseLevelsOff()
    levels.Update()
    kept = np.zeros(len(places), bool)
    kept[block_of(levels, 0, "ParticleId")[1]] = True
    cells = cells_of(places, 12)
    reach = amplitude(sea, places[:, 2])

    def at(points):
        return np.asarray(points)[..., (0, -1)] * scale + (left, top)

    steps = 40
    for step in range(steps):
        low, high = -depth * (step + 1) / steps, -depth * step / steps
        shade = tuple(a + (b - a) * step / steps for a, b in zip(*WATER))
        sheet.areas([at(box((0.0, low), (length, high)))], shade)
    surface = np.column_stack((np.linspace(0.0, length, 300), np.zeros(300), np.zeros(300)))
    wave = at(paths(data_of(surface), sea, (3.0,))[0])
    sheet.areas([np.vstack((wave[k:k + 2], at(((wave[k + 1, 0] - left) / scale, -0.5)), at(((wave[k, 0] - left) / scale, -0.5))))
                 for k in range(299)], WATER[0])
    sheet.areas([np.vstack((wave[k:k + 2], (wave[k + 1, 0], top + 80.0), (wave[k, 0], top + 80.0))) for k in range(299)], PAPER)
    sheet.lines([wave], (0.10, 0.35, 0.45), 2.5)
    half = np.radians(11.0)
    sides = [np.array((eye[[0, 2]], eye[[0, 2]] + (length - eye[0]) * np.array((1.0, np.tan(a)))))
             for a in (-half, half)]
    tested = np.zeros(len(places), bool)
    boxes, colors = [], []
    for members in cells:
        corner = places[members].min(axis=0)[[0, 2]], places[members].max(axis=0)[[0, 2]]
        wide = box(corner[0] - (ball := amplitude(sea, places[members, 2].max())[0] + 0.01), corner[1] + ball)
        slope = np.tan(half) * (wide[:, 0] - eye[0])
        tested[members] = (wide[:, 1] - eye[2] <= slope).any() and (wide[:, 1] - eye[2] >= -slope).any()
        boxes.append(at(box(corner[0] - 0.05, corner[1] + 0.05)))
        colors.append((1.0, 0.93, 0.70, 0.75) if tested[members[0]] else (1.0, 1.0, 1.0, 0.22))
    seen = levels.GetOutputDataObject(0).GetFieldData().GetArray("CellsShown").GetTuple1(0)
    assert sum(tested[members[0]] for members in cells) == seen, "the cells are not those of the filter"
    assert not (kept & ~tested).any(), "a particle is kept in a cell that is not"
    sheet.areas(boxes, colors)
    sheet.lines([closed(outline) for outline in boxes], (0.45, 0.55, 0.58, 0.55), 1.0)
    sheet.areas([np.vstack((at(sides[0]), at(sides[1][1:])))], (*VOLUME, 0.13))
    sheet.lines([at(side) for side in sides], VOLUME, 2.0)
    inside = kept & (np.abs(np.arctan2(places[:, 2] - eye[2], places[:, 0] - eye[0])) > half)
    for chosen, color in ((inside, NEAR), (tested & ~kept, FAR)):
        sheet.lines([closed(circle(c, r * scale)) for c, r in zip(at(places[chosen]), reach[chosen])], (*color, 0.60), 1.2)
    tracks = paths(data_of(places[kept]), sea, np.linspace(0.0, 3.2, 60))
    sheet.lines([at(tracks[:, n]) for n in range(tracks.shape[1])], (*NEAR, 0.85), 1.4)
    sheet.discs(at(places[~tested]), 3.6, GREY)
    sheet.discs(at(places[tested & ~kept]), 4.6, FAR)
    sheet.discs(at(places[kept]), 4.6, NEAR)
    sheet.discs([at(eye)], 12.0, (1.0, 1.0, 1.0))
    sheet.discs([at(eye)], 8.5, VOLUME)
    y = 58
    for x, color, words in ((40, NEAR, f"{kept.sum()} kept: their orbits reach the view"),
                             (560, FAR, f"{(tested & ~kept).sum()} tested, orbits outside"),
                             (1000, GREY, f"{(~tested).sum()} not looked at: their cell is outside")):
        sheet.discs([(x, y - 14)], 9.0, color)
        sheet.text(words, x + 20, y, 23)
    sheet.text("Orbits are circles whose radius shrinks with depth; the balls about centers are what is tested", 40, 682, 22, FAINT)
    sheet.write(folder, "figure-sea-4")


def figure_5(folder):
    """A master and its slaves: at random places around it, and at places of their own."""
    sheet, scale, level = Sheet(1500, 760), 300.0, -1.6
    sea = windy_sea(5.0)
    random = np.random.default_rng(4)
    places = np.vstack(((0.0, 0.0, level), np.column_stack((
        0.62 * np.cos([0.55, 2.45, 4.3]), np.zeros(3), level + 0.62 * np.sin([0.55, 2.45, 4.3])))))
    places += 0.08 * random.standard_normal(places.shape) * (1.0, 0.0, 1.0)
    times = np.linspace(0.0, 4.4, 120)
    for panel, (placement, title) in enumerate(((1, "Scattered, as in the paper"), (0, "Own Place"))):
        center = np.array((375.0 + 750.0 * panel, 375.0))
        levels = vtkParticleLevelOfDetailFilter()
        levels.SetInputData(0, data_of(places))
        levels.SetSeaStateConnection(sea.GetOutputPort())
        levels.SetViewPoint(0.0, -7.0, level)
        levels.SetOffsetRange(0.35, 0.95)
        levels.SetSlavePlacement(placement)
        levels.SetTrainSelectionToAllTrains()
        levels.SetSeed(24)
        levels.Update()
        block = levels.GetOutputDataObject(0).GetBlock(1)
        rest, ids, masters, bound = block_of(levels, 1, "ParticleId", "MasterId", "ErrorBound")
        assert len(rest) == 4 and (masters[1:] == 0).all(), "not one group"
        tracks = paths(block, sea, times)
        middle = places[ids[0]]

        def at(points):
            return (np.asarray(points)[..., (0, 2)] - middle[[0, 2]]) * scale + center

        sheet.areas([box((center[0] - 362, 20), (center[0] + 362, 700))], (0.90, 0.945, 0.95))
        sheet.discs([center], 0.95 * scale, (0.80, 0.90, 0.92))
        sheet.discs([center], 0.35 * scale, (0.90, 0.945, 0.95))
        for radius, words in ((0.35, "least offset"), (0.95, "largest offset")):
            ring = circle(center, radius * scale, 160)
            sheet.lines(dashes(closed(ring), 2, 4), (*FAINT, 0.8), 1.5)
            sheet.text(words, center[0], center[1] + radius * scale + 26, 19, FAINT, "center")
        own = paths(data_of(rest), sea, times)
        for n in range(1, 4):
            sheet.lines(dashes(at(own[:, n]), 2, 4), (*FAINT, 0.9), 1.6)
            sheet.lines([at(np.array((rest[0], rest[n])))], (*MIDDLE, 0.45), 1.4)
            sheet.lines([at(tracks[:, n])], MIDDLE, 2.6)
        sheet.lines([at(tracks[:, 0])], NEAR, 3.4)
        sheet.discs(at(tracks[70, 1:]), 9.0, MIDDLE)
        sheet.discs(at(tracks[70, :1]), 12.0, NEAR)
        worst = np.linalg.norm(tracks - own, axis=2).max()
        sheet.text(title, center[0] - 362, 750, 32)
        sheet.text(f"farthest from an orbit of its own {worst:.2f} m, bound {bound.max():.2f} m", center[0], 55, 21, FAINT, "center")
    sheet.discs([(490, 726)], 11.0, NEAR)
    sheet.text("master", 508, 740, 24)
    sheet.discs([(620, 726)], 9.0, MIDDLE)
    sheet.text("slaves", 637, 740, 24)
    sheet.lines(dashes(np.column_stack((np.linspace(1010, 1080, 13), np.full(13, 726.0))), 2, 4), (*FAINT, 1.0), 1.8)
    sheet.text("their own orbits would be these", 1092, 740, 24)
    sheet.write(folder, "figure-sea-5")


def figure_6(folder):
    """Weights of the levels over distance, particles and fog below them."""
    sheet, scale, left = Sheet(1500, 800), 82.0, 90.0
    middle, far, band, reach = 3.0, 12.0, 1.0, 16.2
    random = np.random.default_rng(2)
    count = 3600
    places = np.column_stack((random.uniform(0.0, reach, count), random.uniform(-2.0, 2.0, count),
                              random.uniform(-4.6, -3.4, count)))
    sea = windy_sea(6.0)
    levels = vtkParticleLevelOfDetailFilter()
    levels.SetInputData(0, data_of(places))
    levels.SetSeaStateConnection(sea.GetOutputPort())
    levels.SetViewPoint(0.0, 0.0, -4.0)
    levels.SetViewDirection(1.0, 0.0, 0.0)
    levels.SetMiddleDistance(middle)
    levels.SetFarDistance(far)
    levels.SetBlendDistance(band)
    levels.UseCullingOff()
    levels.Update()
    fog = vtkParticleFogFilter()
    fog.SetInputConnection(levels.GetOutputPort())
    fog.UseBoundsOn()
    fog.SetBounds(0.0, reach, -2.0, 2.0, -4.6, -3.4)
    fog.SetDimensions(34, 9, 2)
    fog.Update()
    image = fog.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(2, 9, 34).mean(axis=0)

    def across(points, base, height):
        points = np.asarray(points, dtype=float)
        return points * (scale, height) + (left, base)

    # Weights.
    base, height = 480.0, 230.0
    d = np.linspace(0.0, reach, 400)

    def step(x):
        part = np.clip(0.5 * (x / band + 1.0), 0.0, 1.0)
        return part * part * (3.0 - 2.0 * part)

    weights = (1.0 - step(d - middle), step(d - middle) - step(d - far), step(d - far))
    for weight, color in zip(weights, (NEAR, MIDDLE, FAR)):
        quads = [across(((d[k], 0.0), (d[k + 1], 0.0), (d[k + 1], weight[k + 1]), (d[k], weight[k])), base, height)
                 for k in range(399) if weight[k] + weight[k + 1] > 0.0]
        sheet.areas(quads, (*color, 0.16))
        first, last = np.flatnonzero(weight > 0.0)[[0, -1]]
        part = slice(max(first - 1, 0), last + 2)
        sheet.lines([across(np.column_stack((d, weight))[part], base, height)], color, 3.0)
    sheet.lines([across(((0.0, 0.0), (reach, 0.0)), base, height)], INK, 1.5)
    for value in range(0, 17, 2):
        sheet.lines([across(((value, 0.0), (value, -0.03)), base, height)], INK, 1.5)
        sheet.text(f"{value}", left + value * scale, base - 12, 20, FAINT, "center")
    sheet.text("m", left + 16.45 * scale, base - 12, 20, FAINT)
    for place, words, color in ((1.0, "Near: orbits of their own", NEAR), (7.0, "MasterSlave: one orbit for four", MIDDLE),
                                 (14.5, "Far: fog", FAR)):
        sheet.text(words, left + place * scale + (40 if place < 2 else 0), 770, 26, color, "center")
    sheet.text("1", 60, base + height + 12, 22, FAINT)
    sheet.text("0", 60, base + 10, 22, FAINT)
    for place, words in ((middle, "D_m"), (far, "D_M")):
        line = np.column_stack((np.full(80, left + place * scale), np.linspace(base, base + height, 80)))
        sheet.lines(dashes(line, 1, 3), (*FAINT, 0.7), 1.5)
        sheet.text(words, left + place * scale + 8, base + height + 4, 22, FAINT)

    # Particles and fog from above.
    base, height = 230.0, 85.0
    sheet.areas([across(box((0.0, -2.0), (reach, 2.0)), base, height)], (0.035, 0.16, 0.23))
    top = np.percentile(values[:, -8:], 85)
    for axis in (0, 1, 0, 1, 0, 1):  # linear between samples, as the field is
        fine = np.repeat(values, 2, axis=axis)
        ahead = np.roll(fine, -1, axis=axis)
        values = np.delete(0.5 * (fine + ahead), -1, axis=axis)
    rows, columns = values.shape
    size = np.array((reach / columns, 4.0 / rows))
    quads, colors = [], []
    for i in range(columns):
        for j in range(rows):
            share = min(1.0, values[j, i] / top)
            if share > 0.0:
                low = np.array((i, j)) * size - (0.0, 2.0)
                quads.append(across(box(low, low + size), base, height))
                colors.append((0.50, 0.69, 0.86, 0.75 * share))
    sheet.areas(quads, colors)
    for index, color in ((0, (1.0, 0.68, 0.38)), (1, (0.55, 0.92, 0.76))):
        shown, alpha = block_of(levels, index, "Alpha")
        size = 3.0 + 1.2 * random.random(len(shown))
        sheet.discs(across(shown[:, :2], base, height), size, [(*color, a) for a in alpha])
    sheet.text("particles and the fog from above, the eye at the left", left, 50, 22, FAINT)
    sheet.write(folder, "figure-sea-6", 68)


def main(folder):
    """Draw the three pictures into a folder."""
    for figure in (figure_4, figure_5, figure_6):
        figure(folder)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
