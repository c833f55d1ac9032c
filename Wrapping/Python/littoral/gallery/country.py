# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Countries of the pictures: ground with small relief, brooks and woods, and the trees on it.

Lengths are in metres, x is east, y north, z up.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..elevation import array_from_image, image_from_array, read_elevation
from ..LittoralFilters import vtkSitePreferenceFilter
from ..LittoralSources import vtkQuadratPointSource, vtkTurningBandsTerrainSource
from ..stand import table_of_words
from . import brooks
from .colors import site_factors, wooded
from .heights import sampled, steepness, subdivide
from .meshes import add_array, polygons, vertices

#: Lower left corner and size of the part of `jacksboro` with trees [m].
WOODS = (2500.0, 2500.0), (5600.0, 6200.0)
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
    """A refined part of an elevation model, with synthetic small relief, brooks and woods.

    image: the terrain, with the point arrays Elevation [m], Reflectance and DrainageArea [m2], which color it; wood:
    fraction of the ground covered by trees, by row and column; water: where it runs, a `brooks.Water`. Meadows are along
    it, woods on what is drier and steeper.
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
        self.water = brooks.Water(image_from_array(self.z.astype(np.float32), (*spacing, 1.0)))
        self.image = self.water.image
        add_array(self.image, "Reflectance", reflectance.ravel())
        cover = site_factors(self.z, spacing, reflectance, self.water.wetness)
        self.wood = wooded(*cover) * (self.water.cover < WET_CELL)

    def height(self, x, y):
        """Height of the ground at positions x, y [m]."""
        return sampled(self.z, self.spacing, x, y)


def jacksboro(refinements=3):
    """The country of the forests: a part of the Jacksboro fault, Tennessee, in which brooks gather."""
    return Country(read_elevation(), (10500.0, 6500.0), 10000.0, refinements)


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


def brook_bands(country, near, reach):
    """Brooks within a distance [m] of a place as bands of water on the ground, with a Jacobian of 1: without foam."""
    places, triangles = brooks.bands(country.water.courses, country.height, np.asarray(near)[:2], reach)
    data = polygons(places, triangles)
    add_array(data, "Jacobian", np.ones(len(places), np.float32))
    return data
