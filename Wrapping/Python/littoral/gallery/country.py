# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Countries of the pictures: ground with small relief, light, brooks and woods, and the trees on it.

Lengths are in metres, x is east, y north, z up; azimuths are measured from north to east.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..elevation import array_from_image, image_from_array
from ..glb import direction
from ..LittoralFilters import vtkSitePreferenceFilter
from ..LittoralSources import vtkQuadratPointSource, vtkTurningBandsTerrainSource
from ..stand import table_of_words
from . import brooks
from .colors import colored, lit, natural_color, site_factors, to_bytes, wooded
from .heights import normals, openness, sampled, steepness, subdivide, sunlight
from .meshes import add_array, polygons, vertices

#: Azimuth and elevation of the sun [degrees].
SUN = (120.0, 34.0)
#: Fraction of a cell under water from which no tree grows there.
WET_CELL = 0.12
#: Preferences of the species of woods, as vtkSitePreferenceFilter reads them: pines on ridges and warm slopes, oaks on
#: low ground, birches where it is moist, shrubs on what is steep.
PREFERENCES = {
    "species": ("pine", "oak", "birch", "shrub"), "abundance": (1.0, 1.4, 0.8, 0.3),
    "relative_elevation": (0.75, 0.3, "", ""), "relative_elevation_tolerance": (0.3, 0.3, "", ""),
    "slope": (18.0, 8.0, 0.0, 30.0), "slope_tolerance": (12.0, 12.0, 16.0, 8.0),
    "aspect": (200.0, "", "", ""), "aspect_tolerance": (90.0, "", "", ""),
    "wetness": ("", "", 8.5, ""), "wetness_tolerance": ("", "", 2.5, "")}


class Country:
    """A refined part of an elevation model, with synthetic small relief, lit colors and woods.

    image: the terrain, with the point arrays Elevation [m] and RGB; wood: fraction of the ground
    covered by trees, by row and column; water: where it runs, a `brooks.Water`. Meadows are along it, woods on
    what is drier and steeper, rock where it is too steep for both.
    """

    def __init__(self, model, corner, size, refinements=3, seed=1):
        """A square of an elevation model. corner: x and y [m]; size [m]; refinements: times that cells are halved."""
        spacing = model.GetSpacing()[:2]
        column, row = (int(corner[k] / spacing[k]) for k in (0, 1))
        columns, rows = (int(size / spacing[k]) for k in (0, 1))
        z = array_from_image(model).astype(float)[row:row + rows, column:column + columns]
        for _ in range(refinements):
            z, spacing = subdivide(z), (0.5 * spacing[0], 0.5 * spacing[1])
        relief, reflectance = _small_relief(z.shape, spacing, seed)
        self.z = z + relief * np.clip(steepness(z, spacing) / 12.0, 0.15, 1.5)
        self.spacing = spacing
        self.image = image_from_array(self.z.astype(np.float32), (*spacing, 1.0))
        self.water = brooks.Water(self.image)
        cover = site_factors(self.z, spacing, reflectance, self.water.wetness)
        self.wood = wooded(*cover) * (self.water.cover < WET_CELL)
        self._paint(colored(*cover))

    @classmethod
    def from_heights(cls, z, spacing, reflectance=None, wood=None):
        """A country from given heights [m], by row and column; wood: as the attribute, default none."""
        country = cls.__new__(cls)
        country.z, country.spacing = z, spacing
        country.wood = np.zeros(z.shape) if wood is None else wood
        country.water = None
        country.image = image_from_array(z.astype(np.float32), (*spacing, 1.0))
        country._paint(natural_color(z, spacing, reflectance))
        return country

    def height(self, x, y):
        """Height of the ground at positions x, y [m]."""
        return sampled(self.z, self.spacing, x, y)

    def _paint(self, color):
        """Lit colors of the ground as the array RGB."""
        seen = (sunlight(self.z, self.spacing, *SUN), openness(self.z, self.spacing))
        color = color * (1.0 - 0.35 * self.wood[..., None])  # little light passes the canopy
        light = lit(color, normals(self.z, self.spacing), direction(*SUN), *seen)
        add_array(self.image, "RGB", to_bytes(light).reshape(-1, 3))


def _small_relief(shape, spacing, seed):
    """Heights and reflectance that the elevation model does not resolve."""
    source = vtkTurningBandsTerrainSource()
    source.SetModelToFractal()
    source.SetFractalDimension(2.25)
    source.SetRange(400.0)
    source.SetStandardDeviation(3.0)
    source.SetMean(0.0)
    source.SetWholeExtent(0, shape[1] - 1, 0, shape[0] - 1, 0, 0)
    source.SetSpacing(*spacing, 1.0)
    source.SetSeed(seed)
    source.ReflectanceOn()
    source.Update()
    image = source.GetOutput()
    return array_from_image(image), array_from_image(image, "Reflectance")


def preferred_species(water, x, y, seed=1):
    """Indices of the species of PREFERENCES that grow at positions x, y [m], by the heights and the drainage of the ground."""
    sites = vtkSitePreferenceFilter()
    sites.SetInputData(vertices(np.column_stack((x, y, np.zeros(len(x))))))
    sites.SetInputData(1, water.image)
    sites.SetInputData(2, table_of_words(PREFERENCES, PREFERENCES.values()))
    sites.SetSeed(seed)
    sites.Update()
    arrays = sites.GetOutput().GetPointData()
    species = np.ones(len(x), int)  # oaks where nothing feels at home
    species[vtk_to_numpy(arrays.GetArray("SiteId"))] = vtk_to_numpy(arrays.GetArray("Species"))
    return species


def wood_sites(country, origin, size, mean_distance=13.0, seed=1, alone=None):
    """Sites of trees on a rectangle, with the point array Species: 0 pine, 1 oak, 2 birch, 3 shrub.

    Candidates are clustered by the Neyman type A law; they are kept in woods, a few also on meadows. Which species
    they are is decided by the ground (PREFERENCES); half of those on meadows are shrubs.

    alone: further trees, positions [n, 2] and species [n]; no other tree stands within 25 m.
    """
    source = vtkQuadratPointSource()
    source.SetOrigin(*origin)
    source.SetSize(*size)
    source.SetQuadrats(*(max(1, int(s / mean_distance)) for s in size))
    source.SetLaw(source.PoissonPoisson)
    source.SetClusterMean(1.5)
    source.SetMode(source.Sampling)
    source.SetSeed(seed)
    source.Update()
    points = vtk_to_numpy(source.GetOutput().GetPoints().GetData())
    x, y = points[:, 0].astype(float), points[:, 1].astype(float)
    chance = np.random.default_rng(seed).random((2, len(x)))
    wood = sampled(country.wood, country.spacing, x, y)
    z = country.height(x, y)
    stays = chance[0] < np.clip(1.25 * wood - 0.2, 0.03, 1.0)
    species = preferred_species(country.water, x, y, seed)
    species[(wood < 0.35) & (chance[1] < 0.5)] = 3
    if alone is not None:
        places, kinds = alone
        apart = np.hypot(x[:, None] - places[:, 0], y[:, None] - places[:, 1]).min(axis=1)
        stays &= apart > 25.0
        x, y = (np.concatenate((v[stays], places[:, k])) for k, v in enumerate((x, y)))
        z, species = country.height(x, y), np.concatenate((species[stays], kinds))
        stays = np.ones(len(x), bool)
    return vertices(np.column_stack((x, y, z))[stays], Species=species[stays].astype(np.int32))


def shadows(country, places, radius, height, sun=SUN):
    """Soft shadows of crowns on the ground: translucent disks with four components in `RGB`.

    places: feet of the plants [n, 3]; radius: of the crowns, height: of their centers [m].
    """
    towards = direction(*sun)
    steep = towards[2] / np.hypot(*towards[:2])
    angles = np.arange(12) * 2.0 * np.pi / 12.0
    ring = np.concatenate(([[0.0, 0.0]], *(
        share * np.column_stack((np.cos(angles), np.sin(angles))) for share in (0.75, 1.15))))
    along = -towards[:2] / np.hypot(*towards[:2])
    across = np.array((-along[1], along[0]))
    offset = ring[:, :1] * along * (0.5 + 0.5 / steep) + ring[:, 1:] * across
    center = places[:, None, :2] + (along / steep) * height[:, None, None]
    ground = center + radius[:, None, None] * offset
    z = country.height(ground[..., 0], ground[..., 1]) + 0.12
    points = np.concatenate((ground, z[..., None]), axis=-1).reshape(-1, 3)
    k, after = np.arange(12), (np.arange(12) + 1) % 12
    one = np.concatenate((
        np.column_stack((np.zeros(12, int), 1 + k, 1 + after)),
        np.column_stack((1 + k, 13 + k, 13 + after)),
        np.column_stack((1 + k, 13 + after, 1 + after))))
    triangles = one[None] + len(ring) * np.arange(len(places))[:, None, None]
    rgba = np.zeros((len(ring), 4), np.uint8)
    rgba[:, :3] = (30, 38, 34)
    rgba[:, 3] = np.repeat((135, 120, 0), (1, 12, 12))
    return polygons(points, triangles.reshape(-1, 3), np.tile(rgba, (len(places), 1)))


def brook_bands(country, near, reach):
    """Brooks within a distance [m] of a place as translucent bands on the ground, as `shadows`."""
    return polygons(*brooks.bands(country.water.courses, country.height, np.asarray(near)[:2], reach))
