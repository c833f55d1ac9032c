# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Relief models: a terrain as a block on a floor, in natural colors, for vtkLandscapePass.

Lengths are in metres, angles in degrees. x is east, y north, z up; an azimuth counts from north to the east. Height
fields and colors are as in `heights` and `colors`.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..elevation import array_from_image, image_from_array
from ..glb import direction
from .colors import LAKE, mix, natural_color, section_color, to_bytes
from .heights import normals, refined, smoothstep
from .meshes import grids, polygons

#: Albedo of a model over that of the land.
PAINT = 1.55
#: Cells along the longer side of a block, at least.
CELLS = 600
#: Angle by which blocks are turned from facing the camera, and elevation of the camera above them [degrees].
TURN, LIFT = 32.0, 39.0
#: Albedos of the floor, sRGB, before and behind the blocks.
FLOOR = (0.97, 0.945, 0.935), (0.66, 0.73, 0.82)


def relief_block(image, exaggeration=1.0, coloring=natural_color, center=(0.0, 0.0)):
    """The terrain of an image as a block with cut sides that stands on z = 0, with albedos in `RGB`.

    exaggeration: of the heights; center: of the block [m].
    An optional array `Reflectance` controls the colors. Missing heights become the lowest.
    """
    ground = array_from_image(image)
    if ground is None:
        raise ValueError("the image has no point array Elevation")
    ground = np.nan_to_num(ground.astype(np.float64), nan=np.nanmin(ground))
    reflectance = array_from_image(image, "Reflectance")
    if reflectance is not None:
        reflectance, _ = refined(reflectance, image.GetSpacing(), CELLS)
    ground, spacing = refined(ground, image.GetSpacing(), CELLS)
    rows, columns = ground.shape
    x = (np.arange(columns) - 0.5 * (columns - 1)) * spacing[0] + center[0]
    y = (np.arange(rows) - 0.5 * (rows - 1)) * spacing[1] + center[1]
    thickness = 0.07 * np.ptp(x)
    z = thickness + (ground - ground.min()) * exaggeration
    top = np.stack(np.broadcast_arrays(x, y[:, None], z), axis=-1)
    sides = (
        (top[0, ::-1], (0.0, -1.0, 0.0)), (top[::-1, -1], (1.0, 0.0, 0.0)),
        (top[-1], (0.0, 1.0, 0.0)), (top[:, 0], (-1.0, 0.0, 0.0)))
    walls = [_wall(*side, thickness) for side in sides]
    return grids((top, to_bytes(PAINT * coloring(ground, spacing, reflectance)), normals(z, spacing)), *walls)


def lake_block(ground, exaggeration=1.0, center=(0.0, 0.0)):
    """The block of a terrain whose depressions are full of water: output of `vtkDrainageFilter`, not carved."""
    depth = array_from_image(ground, "DepressionDepth")
    level = image_from_array(array_from_image(ground) + depth, ground.GetSpacing())
    deep, _ = refined(depth, ground.GetSpacing(), CELLS)

    def coloring(z, spacing, reflectance):
        water = smoothstep(deep, 0.0, 0.02 * np.std(z))
        return mix(natural_color(z, spacing, reflectance), LAKE, 0.92 * water)

    return relief_block(level, exaggeration, coloring=coloring, center=center)


def river_lines(rivers, ground, exaggeration=1.0, center=(0.0, 0.0)):
    """Rivers on the block of a terrain: pairs of a `vtkPolyData` with `RGB` and its stream order, low orders first.

    What runs through lakes is left out, but for shallow pools.
    """
    bounds, depth = ground.GetBounds(), array_from_image(ground, "DepressionDepth")
    level = array_from_image(ground) + depth
    middle = 0.5 * np.array((bounds[0] + bounds[1], bounds[2] + bounds[3]))
    width = bounds[1] - bounds[0]
    places = vtk_to_numpy(rivers.GetPoints().GetData()).astype(np.float64)
    columns = np.round((places[:, 0] - bounds[0]) / ground.GetSpacing()[0]).astype(int)
    rows = np.round((places[:, 1] - bounds[2]) / ground.GetSpacing()[1]).astype(int)
    places[:, :2] += np.array(center)[:2] - middle
    places[:, 2] = 0.07 * width + (level[rows, columns] - level.min()) * exaggeration + 0.0025 * width
    dry = depth[rows, columns] <= 0.05 * np.std(level)  # shallow pools are part of a river
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    orders = vtk_to_numpy(rivers.GetCellData().GetArray("StreamOrder"))
    for order in np.unique(orders):
        lines, cells = vtkPolyData(), vtkCellArray()
        for cell in np.flatnonzero(orders == order):
            ids = rivers.GetCell(int(cell)).GetPointIds()
            path = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
            for upper, lower in zip(path, path[1:]):
                if dry[upper] or dry[lower]:
                    cells.InsertNextCell(2, (upper, lower))
        lines.SetPoints(points)
        lines.SetLines(cells)
        lines.GetPointData().SetScalars(rivers.GetPointData().GetArray("RGB"))
        yield lines, int(order)


def _wall(edge, normal, thickness):
    """A cut from an edge [n, 3] of the terrain down to z = 0."""
    points = np.repeat(edge[None], 120, axis=0)
    points[..., 2] *= np.linspace(1.0, 0.0, 120)[:, None]
    height = points[..., 2]
    along = np.hypot(*(points - edge[0])[..., :2].transpose(2, 0, 1))
    color = section_color(along, height, edge[:, 2] - height, thickness)
    return points, to_bytes(PAINT * color), np.broadcast_to(normal, points.shape)


# Blocks in a row ----------------------------------------------------------------------------------


def width_of(image):
    """Longer side of an image [m]."""
    bounds = image.GetBounds()
    return max(bounds[1] - bounds[0], bounds[3] - bounds[2])


def row_centers(width, count):
    """Centers [m] of `count` blocks of a width [m], side by side in the view of `row_camera`."""
    places = 1.44 * width * (np.arange(count) - 0.5 * (count - 1))
    return places[:, None] * direction(90.0 - TURN, 0.0)


def row_camera(width, count, aspect):
    """Camera position [m], focal point [m] and vertical view angle [degrees] for a row of blocks.

    aspect: width over height of the image.
    """
    angle, reach = 7.0, (0.25 + 0.65 * count) * width
    focus = 0.05 * width * direction(90.0 - TURN, 0.0) - (0.0, 0.0, 0.01 * width)
    distance = reach / min(aspect, 0.2 + 1.2 * count) / np.tan(np.radians(0.5 * angle))
    return focus + distance * direction(180.0 - TURN, LIFT), focus, angle


def floor(width, count):
    """The floor under a row of blocks, pale before them and bluish behind."""
    ahead, aside = direction(-TURN, 0.0), direction(90.0 - TURN, 0.0)
    reach = 3.0 * width * (1.0 + count)
    corners = np.array([v * reach * ahead + u * reach * aside for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    shade = np.array(FLOOR)[[0, 0, 1, 1]]
    return polygons(corners, np.array(((0, 1, 2, 3),)), shade)


def light_of(width, distance):
    """Properties of vtkLandscapePass for blocks of a width, seen from a distance [m]."""
    return dict(SunAzimuth=248.0, SunElevation=27.0, Turbidity=5.0, Visibility=1e4 * distance, CloudCover=0.0,
                FilmCurve=False, ExposureCompensation=0.42, ShadowDistance=2.0 * distance, OcclusionRadius=0.06 * width)
