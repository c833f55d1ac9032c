# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw figure10.jpg: over a thousand trees of two species on a smooth terrain, in a strong wind.

    ./littoral run pvbatch Documentation/pictures/make_figure10.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGReader

from littoral import vtkQuadratPointSource, vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image
from littoral.gallery import views
from littoral.gallery.heights import sampled
from littoral.gallery.meshes import polygons, vertices

SIDE, SPACING = 1200.0, 3.0  # of the terrain [m]
EYE, FOCUS = np.array((600.0, 70.0)), np.array((600.0, 640.0))
EYE_HEIGHT, VIEW_ANGLE = 9.0, 25.0  # [m], [degrees]
SIZE = (960, 520)
SPEED, TIME = 14.0, 7.3  # of the wind [m/s]; of the picture [s]
#: Houses: place [m], turn [degrees].
HOUSES = ((572.0, 300.0, 20.0), (612.0, 322.0, -35.0), (540.0, 352.0, 75.0), (660.0, 372.0, 10.0),
          (498.0, 450.0, -20.0))
WALLS, ROOF = (232, 222, 200), (150, 78, 56)


def smooth_terrain():
    """An image of the Gaussian model, without detail of its own."""
    source = vtkTurningBandsTerrainSource()
    source.SetModelToDoubleExponential()
    source.SetRange(170.0)
    source.SetStandardDeviation(11.0)
    source.SetMean(60.0)
    cells = int(SIDE / SPACING)
    source.SetWholeExtent(0, cells, 0, cells, 0, 0)
    source.SetSpacing(SPACING, SPACING, 1.0)
    source.SetSeed(23)
    source.Update()
    return source.GetOutput()


def tree_sites(terrain):
    """Clusters of trees, off the houses and the meadow before the eye."""
    source = vtkQuadratPointSource()
    source.SetOrigin(60.0, 60.0)
    source.SetSize(SIDE - 120.0, SIDE - 120.0)
    source.SetQuadrats(24, 24)
    source.SetLaw(source.PoissonPoisson)
    source.SetMeanPerQuadrat(5.0)
    source.SetClusterMean(5.0)
    source.SetMode(source.Sampling)
    source.SetSeed(7)
    source.Update()
    places = vtk_to_numpy(source.GetOutput().GetPoints().GetData())[:, :2].astype(float)
    random = np.random.default_rng(3)
    away = places - EYE
    near = np.hypot(*away.T)
    stays = near > 30.0
    for x, y, _ in HOUSES:
        stays &= np.hypot(places[:, 0] - x, places[:, 1] - y) > 16.0
        # The view of the houses stays open.
        along = np.clip(away @ (np.array((x, y)) - EYE) / np.sum((np.array((x, y)) - EYE) ** 2), 0.0, 1.0)
        stays &= np.hypot(*(away - along[:, None] * (np.array((x, y)) - EYE)).T) > 5.0
    places = places[stays]
    apart = np.ones(len(places), bool)
    for k in range(1, len(places)):
        apart[k] = np.hypot(*(places[:k][apart[:k]] - places[k]).T).min(initial=9.0) > 2.6
    places = places[apart]
    heights = sampled(terrain, *places.T)
    pines = random.random(len(places)) < np.clip((heights - array_from_image(terrain).mean()) / 18.0 + 0.45, 0.1, 0.9)
    species = np.where(pines, 0, 1).astype(np.int32)
    return vertices(np.column_stack((places, heights)), Species=species)


def houses(terrain):
    """Walls and gable roofs."""
    points, triangles, colors = [], [], []

    def face(corners, color):
        first = len(points)
        points.extend(corners)
        triangles.extend((first, first + k, first + k + 1) for k in range(1, len(corners) - 1))
        colors.extend([color] * len(corners))

    for x, y, turn in HOUSES:
        c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
        ground = float(sampled(terrain, x, y)) - 1.0

        def at(u, v, w, x=x, y=y, c=c, s=s, ground=ground):
            return (x + c * u - s * v, y + s * u + c * v, ground + w)

        a, b, eaves, ridge = 6.0, 4.0, 4.2, 7.6
        for u, v, p, q in ((-a, -b, a, -b), (a, b, -a, b)):
            face((at(u, v, 0.0), at(p, q, 0.0), at(p, q, eaves), at(u, v, eaves)), WALLS)
        for u, sign in ((-a, -1.0), (a, 1.0)):
            face((at(u, -sign * b, 0.0), at(u, sign * b, 0.0), at(u, sign * b, eaves), at(u, 0.0, ridge),
                  at(u, -sign * b, eaves)), WALLS)
        over, low = a + 0.5, eaves - 0.4
        for sign in (-1.0, 1.0):
            v = sign * (b + 0.5)
            face((at(sign * -over, v, low), at(sign * over, v, low), at(sign * over, 0.0, ridge + 0.1),
                  at(sign * -over, 0.0, ridge + 0.1)) if sign < 0 else
                 (at(over, v, low), at(-over, v, low), at(-over, 0.0, ridge + 0.1), at(over, 0.0, ridge + 0.1)), ROOF)
    return polygons(np.array(points), np.array(triangles), np.array(colors, np.uint8))


def draw(folder):
    """Write figure10.png into a folder."""
    terrain = smooth_terrain()
    trees = tree_sites(terrain)
    eye = np.array((*EYE, sampled(terrain, *EYE) + EYE_HEIGHT))
    country, sites, homes = (views.reader(name, data, folder) for name, data in (
        ("country", terrain), ("sites", trees), ("houses", houses(terrain))))

    prototypes = [simple.ReevesTree(Preset="Pine", Seed=3), simple.ReevesTree(Preset="Birch", Seed=2)]
    forest = simple.PlantScatter(
        Sites=sites, Prototypes=prototypes, Terrain=country, NearDistance=420.0, FarDistance=3000.0)
    wind = simple.WindField(
        Dimensions=[600, 100, 12], LateralSpacing=12.5, ReferenceSpeed=SPEED, Center=[0.5 * SIDE] * 2,
        RoughnessLength=0.1)
    sway = simple.BeamTreeDeformation(Input=forest, Wind=wind, Prototypes=prototypes)

    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(SIZE)
    views.light(view, SunElevation=17.0, SunAzimuth=262.0, VisibilityDistance=15000.0, CloudCover=0.2, Turbidity=2.0,
                ExposureCompensation=0.4, ShadowDistance=400.0, CoverRadius=120.0, CoverHeight=0.5, Quality="Best")
    views.look(view, eye, (*FOCUS, sampled(terrain, *FOCUS) + 6.0), VIEW_ANGLE)
    view.ViewTime = TIME
    simple.Show(simple.TerrainLevelOfDetail(Input=country), view)
    views.show_colored(homes, view)
    simple.Show(sway, view).BlockSelectors = [f"/Root/{part}" for part in ("High/Skin", "High/Leaves", "Medium", "Low")]
    sway.UpdatePipeline(TIME)
    simple.Render(view)
    table = forest.GetFieldDataInformation()
    print(trees.GetNumberOfPoints(), "trees;", *(
        f"{name} {table.GetArray(name).GetRange()[0]:.0f}" for name in ("PlantsShown", "PlantsHigh", "PlantsMedium")))
    simple.SaveScreenshot(os.path.join(folder, "figure10.png"), view, ImageResolution=list(SIZE))


def main(folder):
    """Draw and write."""
    simple._DisableFirstRenderCameraReset()
    with tempfile.TemporaryDirectory() as scratch:
        draw(scratch)
        picture, writer = vtkPNGReader(), vtkJPEGWriter()
        picture.SetFileName(os.path.join(scratch, "figure10.png"))
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(os.path.join(folder, "figure10.jpg"))
        writer.SetQuality(80)
        writer.Write()


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
