# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Water of a landscape: where it gathers, how wet that makes the ground, and brooks as bands on it.

Lengths are in metres. Grids are [row, column], rows from south to north, from (0, 0), with a spacing (dx, dy).
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..elevation import array_from_image
from ..LittoralFilters import vtkDrainageFilter
from .heights import blur, steepness

#: Drainage area from which there is a brook, and that of a brook one metre wide [m2]; exponent of the width.
LEAST_AREA, METRE_AREA, WIDTH_EXPONENT = 4e4, 1e5, 0.45
#: Least slope in the wetness of the ground.
LEAST_SLOPE = 0.005
#: Places across a brook, in widths, and how uneven its banks are.
ACROSS, RAGGED = np.array((-0.5, -0.25, 0.0, 0.25, 0.5)), 0.3


def width_of(area):
    """Width [m] of a brook that drains an area [m2]: as discharge, by a power near one half (Leopold & Maddock 1953)."""
    return (np.asarray(area) / METRE_AREA) ** WIDTH_EXPONENT


class Water:
    """Water that runs over a terrain.

    wetness: ln(a / tan b) of each cell, a the drainage area by the width of a cell [m], b the slope, averaged beside
    brooks; cover: fraction of each cell under water; courses: of each brook the places [n, 2] and areas [n], downwards.
    """

    def __init__(self, image):
        drainage = vtkDrainageFilter()
        drainage.SetInputData(image)
        drainage.SetInputArrayToProcess(0, 0, 0, 0, "Elevation")
        drainage.CarveOff()
        spacing = image.GetSpacing()[:2]
        cell = spacing[0] * spacing[1]
        drainage.SetStreamThreshold(max(2, round(LEAST_AREA / cell)))
        drainage.Update()
        self.image = drainage.GetOutput()
        area = array_from_image(self.image, "DrainageArea")
        slope = np.tan(np.radians(steepness(array_from_image(image).astype(float), spacing)))
        self.wetness = blur(np.log(area / np.sqrt(cell) / np.maximum(slope, LEAST_SLOPE)), 2)
        is_brook = area >= LEAST_AREA
        self.cover = np.where(is_brook, np.minimum(width_of(area) / np.sqrt(cell), 1.0), 0.0)
        self.courses = [_smooth(*course) for course in _courses(drainage.GetOutputDataObject(1))]

    def distance_to(self, places):
        """Distance of places [n, 2] from the nearest bank [m]; negative in the water."""
        away = np.full(len(places), np.inf)
        for course, areas in self.courses:
            apart = np.hypot(places[:, :1] - course[:, 0], places[:, 1:2] - course[:, 1])
            away = np.minimum(away, (apart - 0.5 * width_of(areas)).min(axis=1))
        return away


def _courses(rivers):
    """Places and drainage areas along each river."""
    if rivers.GetNumberOfCells() == 0:
        return
    places = vtk_to_numpy(rivers.GetPoints().GetData())[:, :2].astype(float)
    areas = vtk_to_numpy(rivers.GetPointData().GetArray("DrainageArea"))
    ids = vtk_to_numpy(rivers.GetLines().GetConnectivityArray())
    starts = vtk_to_numpy(rivers.GetLines().GetOffsetsArray())
    for first, last in zip(starts, starts[1:]):
        if last - first > 2:
            yield places[ids[first:last]], areas[ids[first:last]]


def _smooth(places, areas, times=6, parts=3):
    """A course without the corners of cells, in so many parts of each step; its ends stay."""
    for _ in range(times):
        places = np.concatenate((places[:1], 0.25 * places[:-2] + 0.5 * places[1:-1] + 0.25 * places[2:], places[-1:]))
    at = np.linspace(0.0, len(places) - 1.0, parts * (len(places) - 1) + 1)
    steps = np.arange(len(places))
    return np.column_stack([np.interp(at, steps, axis) for axis in places.T]), np.interp(at, steps, areas)


def bands(courses, height, near, reach, above=0.25):
    """Brooks within a distance of a place as bands on the ground: points and triangles.

    height: of the ground at x, y; near: x and y [m]; above: of the bands over the ground [m].
    """
    random = np.random.default_rng(1)
    points, triangles, first = [np.zeros((0, 3))], [np.zeros((0, 3), int)], 0
    for places, areas in courses:
        if np.hypot(*(places - near).T).min() > reach:
            continue
        along = np.gradient(places, axis=0)
        along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
        across = np.column_stack((along[:, 1], -along[:, 0]))
        ragged = 1.0 + random.uniform(-RAGGED, RAGGED, (len(places), len(ACROSS)))
        at = places[:, None] + (width_of(areas)[:, None] * ACROSS * ragged)[..., None] * across[:, None]
        z = height(at[..., 0], at[..., 1]) + above
        points.append(np.concatenate((at, z[..., None]), axis=-1).reshape(-1, 3))
        k = first + np.arange(z.size).reshape(z.shape)
        a, b, c, d = k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]
        triangles.append(np.stack((a, b, c, a, c, d), axis=-1).reshape(-1, 3))
        first += k.size
    return np.concatenate(points), np.concatenate(triangles)
