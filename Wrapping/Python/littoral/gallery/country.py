# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The country of the forests: ground with small relief and brooks, and the trees on it.

Lengths are in metres, x is east, y north, z up.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..elevation import array_from_image, image_from_array, read_elevation
from ..LittoralFilters import vtkDrainageFilter, vtkSitePreferenceFilter
from ..LittoralSources import vtkQuadratPointSource, vtkTurningBandsTerrainSource
from ..properties import set_properties
from ..stand import table_of_words
from .heights import sampled, subdivide
from .meshes import add_array, vertices

#: Lower left corner and size of the country in the elevation model of the Jacksboro fault, Tennessee [m].
COUNTRY = (10500.0, 6500.0), 10000.0
#: Lower left corner and size of its part with trees [m].
WOODS = (2500.0, 2500.0), (5600.0, 6200.0)
#: Drainage area from which there is a brook [m2].
BROOK = 4e4
#: Preferences of the species of woods, as vtkSitePreferenceFilter reads them: pines on ridges and warm slopes, oaks on
#: low slopes, birches where it is moist, shrubs on what is steep.
PREFERENCES = {
    "species": ("pine", "oak", "birch", "shrub"), "abundance": (1.0, 1.4, 0.8, 0.3),
    "relative_elevation": (0.75, 0.3, "", ""), "relative_elevation_tolerance": (0.3, 0.3, "", ""),
    "slope": (22.0, 20.0, 14.0, 30.0), "slope_tolerance": (9.0, 8.0, 7.0, 8.0),
    "aspect": (200.0, "", "", ""), "aspect_tolerance": (90.0, "", "", ""),
    "wetness": ("", "", 8.5, ""), "wetness_tolerance": ("", "", 2.5, "")}


def jacksboro(refinements=3, seed=1):
    """An updated vtkDrainageFilter of the country, without carving: its ground, with Reflectance, and its rivers.

    refinements: times that the cells of the elevation model are halved; relief that it does not resolve is added.
    """
    model = read_elevation()
    spacing = np.array(model.GetSpacing()[:2])
    column, row = (np.array(COUNTRY[0]) / spacing).astype(int)
    columns, rows = (COUNTRY[1] / spacing).astype(int)
    z = array_from_image(model).astype(float)[row:row + rows, column:column + columns]
    for _ in range(refinements):
        z, spacing = subdivide(z), 0.5 * spacing
    small = set_properties(vtkTurningBandsTerrainSource(), dict(
        FractalDimension=2.25, Range=400.0, StandardDeviation=3.0, Mean=0.0, Spacing=(*spacing, 1.0), Seed=seed,
        WholeExtent=(0, z.shape[1] - 1, 0, z.shape[0] - 1, 0, 0), Reflectance=True))
    small.Update()
    slope = np.hypot(*np.gradient(z, *spacing[::-1]))
    terrain = image_from_array(z + array_from_image(small.GetOutput()) * np.clip(5.0 * slope, 0.15, 1.5), spacing)
    terrain.GetPointData().AddArray(small.GetOutput().GetPointData().GetArray("Reflectance"))
    cells = max(2, round(BROOK / spacing.prod()))
    drainage = set_properties(vtkDrainageFilter(), dict(Carve=False, StreamThreshold=cells))
    drainage.SetInputData(terrain)
    drainage.Update()
    return drainage


def wood_sites(terrain, mean_distance=9.0, alone=((), ()), seed=1):
    """Sites of trees in WOODS, with the point array Species: 0 pine, 1 oak, 2 birch, 3 shrub.

    Candidates are clustered by the Neyman type A law; the ground decides which of them stay, and as which species.

    terrain: of `jacksboro`; alone: further trees, positions [n, 2] and species [n]; no other tree stands within 25 m.
    """
    candidates = set_properties(vtkQuadratPointSource(), dict(
        Origin=WOODS[0], Size=WOODS[1], Quadrats=[int(side / mean_distance) for side in WOODS[1]],
        Law=vtkQuadratPointSource.PoissonPoisson, ClusterMean=1.5, Mode=vtkQuadratPointSource.Sampling, Seed=seed))
    sites = set_properties(vtkSitePreferenceFilter(), dict(Thinning=True, Seed=seed))
    sites.SetInputConnection(candidates.GetOutputPort())
    sites.SetInputData(1, terrain)
    sites.SetInputData(2, table_of_words(PREFERENCES, PREFERENCES.values()))
    sites.Update()
    places = vtk_to_numpy(sites.GetOutput().GetPoints().GetData())[:, :2].astype(float)
    species = vtk_to_numpy(sites.GetOutput().GetPointData().GetArray("Species"))
    stays = sampled(terrain, *places.T, "DrainageArea") < BROOK
    for place in alone[0]:
        stays &= np.hypot(*(places - place).T) > 25.0
    places = np.concatenate((places[stays], np.reshape(alone[0], (-1, 2))))
    species = np.concatenate((species[stays], alone[1])).astype(np.int32)
    return vertices(np.column_stack((places, sampled(terrain, *places.T))), Species=species)
