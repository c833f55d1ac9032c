# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Relief models: terrains as blocks in a row on a floor, for vtkLandscapePass.

Lengths are in metres, angles in degrees. x is east, y north, z up; an azimuth counts from north to the east.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkElevationFilter, vtkFeatureEdges
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper

from ..elevation import array_from_image, image_from_array
from ..glb import direction
from ..LittoralFilters import vtkDrainageFilter, vtkRiverSurfaceFilter, vtkTerrainLevelOfDetailFilter
from ..LittoralRendering import vtkLandscapePass
from ..properties import set_properties
from .meshes import add_array, polygons

#: Angle by which blocks are turned from facing the camera, and elevation of the camera above them [degrees].
TURN, LIFT = 32.0, 39.0
#: Height of a block below its terrain, over its width.
BASE = 0.07
#: Colors of the floor before and behind the blocks, of water, and of beds of rock.
FLOOR, WATER = ((0.97, 0.945, 0.935), (0.66, 0.73, 0.82)), (0.15, 0.40, 0.62)
BEDS = np.array(((0.71, 0.64, 0.54), (0.59, 0.54, 0.48), (0.65, 0.55, 0.45), (0.67, 0.64, 0.59)))
#: Colors of heights, by standard deviations from their mean.
TINTS = ((-2.3, 0.42, 0.53, 0.47), (-1.1, 0.56, 0.62, 0.48), (0.0, 0.71, 0.67, 0.50), (1.1, 0.69, 0.55, 0.41),
         (2.3, 0.76, 0.71, 0.67))


def block(image, exaggeration=1.0, center=(0.0, 0.0), water=False):
    """Actors of the terrain of an image as a block that stands on z = 0: ground, cut sides, and water where it gathers.

    exaggeration: of the heights, whose tints then color the ground; without it, 1, the ground is that of a landscape.
    """
    width, bounds = width_of(image), image.GetBounds()
    level, rivers = drained(image) if water else (image, None)
    ground = set_properties(vtkTerrainLevelOfDetailFilter(), dict(NumberOfLevels=1, UseCulling=False))
    ground.SetInputData(level)
    ground.Update()
    top = ground.GetOutput().GetBlock(0)
    low, high = top.GetBounds()[4:]
    actors = [_ground_actor(top, exaggeration), _walls(top, BASE * width / exaggeration + high - low)]
    actors += _water_actors(top, rivers, level, 1e-3 * width / exaggeration) if water else []
    for actor in actors:
        actor.SetScale(1.0, 1.0, exaggeration)
        actor.AddPosition(center[0] - 0.5 * (bounds[0] + bounds[1]), center[1] - 0.5 * (bounds[2] + bounds[3]),
                          BASE * width - low * exaggeration)
    return actors


def drained(image):
    """A terrain with its depressions full of water, and lines of its rivers."""
    drainage = set_properties(vtkDrainageFilter(), {"Carve": False})
    drainage.SetInputData(image)
    drainage.Update()
    depth = array_from_image(drainage.GetOutput(), "DepressionDepth")
    level = image_from_array(array_from_image(image) + depth, image.GetSpacing(), image.GetOrigin())
    add_array(level, "Depth", depth.ravel())
    return level, drainage.GetOutputDataObject(1)


def _ground_actor(top, exaggeration):
    """The ground with tints of heights or as that of a landscape, which steeper than nature would be rock."""
    if exaggeration == 1.0:
        actor = actor_of(top)
        vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Ground)
        return actor
    return actor_of(top, tints(vtk_to_numpy(top.GetPointData().GetArray("Elevation"))))


def tints(heights):
    """Rows of a value and its color for heights [m]."""
    return [(np.nanmean(heights) + deviations * np.nanstd(heights), *color) for deviations, *color in TINTS]


def beds(count=40, seed=5):
    """Rows of a value, from 0 to 1, and its color for beds of rock."""
    random = np.random.default_rng(seed)
    bounds = np.append(0.0, random.uniform(2.0, 12.0, count).cumsum())
    colors = BEDS[random.integers(len(BEDS), size=count)]
    return [(bound / bounds[-1], *color) for low, high, color in zip(bounds, bounds[1:], colors)
            for bound in (low, 0.999 * high)]


def _walls(top, depth):
    """Cuts from the edge of the ground downwards, in beds that bend with it; the floor hides their lower end."""
    edge = set_properties(vtkFeatureEdges(), dict(FeatureEdges=False, NonManifoldEdges=False, Coloring=False))
    sides = set_properties(vtkLinearExtrusionFilter(), dict(Vector=(0.0, 0.0, -depth), Capping=False))
    share = vtkElevationFilter()
    edge.SetInputData(top)
    sides.SetInputConnection(edge.GetOutputPort())
    sides.SetExtrusionTypeToVectorExtrusion()
    share.SetInputConnection(sides.GetOutputPort())
    share.SetLowPoint(0.0, 0.0, top.GetBounds()[5] - depth)
    share.SetHighPoint(0.0, 0.0, top.GetBounds()[5])
    share.Update()
    return actor_of(share.GetOutput(), beds())


def _water_actors(top, rivers, level, lift):
    """Lakes and rivers, a little above the ground [m]."""
    deep, lakes, bands = vtkPolyData(), vtkClipPolyData(), vtkRiverSurfaceFilter()
    deep.ShallowCopy(top)
    deep.GetPointData().SetActiveScalars("Depth")
    lakes.SetInputData(deep)
    lakes.SetValue(0.02 * np.std(array_from_image(level)))
    lakes.Update()
    bands.SetInputData(0, rivers)
    bands.SetInputData(1, level)
    bands.SetWidthOfUnitArea(1.5e-3 * width_of(level))
    bands.SetLift(lift)
    bands.Update()
    actors = [actor_of(source.GetOutput()) for source in (lakes, bands)]
    actors[0].AddPosition(0.0, 0.0, lift)
    for actor in actors:
        actor.GetMapper().ScalarVisibilityOff()
        actor.GetProperty().SetColor(*WATER)
    return actors


def actor_of(data, colors=()):
    """Actor of data with its colors `RGB`, or by rows of a value of the array `Elevation` and its color."""
    mapper, actor, table = vtkPolyDataMapper(), vtkActor(), vtkColorTransferFunction()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    if colors:
        for row in colors:
            table.AddRGBPoint(*row)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("Elevation")
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    return actor


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
    return polygons(corners, np.array(((0, 1, 2, 3),)), np.array(FLOOR)[[0, 0, 1, 1]])


def light_of(width, distance):
    """Properties of vtkLandscapePass for blocks of a width, seen from a distance [m]."""
    return dict(SunAzimuth=248.0, SunElevation=27.0, Turbidity=5.0, Visibility=1e4 * distance, CloudCover=0.0,
                WoodCover=0.5, FilmCurve=False, ExposureCompensation=0.42,
                ShadowDistance=2.0 * distance, OcclusionRadius=0.06 * width)
