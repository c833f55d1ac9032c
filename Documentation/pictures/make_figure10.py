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
from littoral.gallery import country as countries
from littoral.gallery import landscape, views
from littoral.gallery.meshes import polygons, vertices
from littoral.gallery.sky import sky_dome, write_sky
from littoral.glb import direction

SIDE, SPACING = 1200.0, 3.0  # of the terrain [m]
EYE, FOCUS = np.array((600.0, 70.0)), np.array((600.0, 640.0))
EYE_HEIGHT, VIEW_ANGLE = 9.0, 25.0  # [m], [degrees]
SIZE = (960, 520)
SPEED, TIME = 14.0, 7.3  # of the wind [m/s]; of the picture [s]
#: Radius of the crown, height of its middle [m]: pine and birch.
CROWNS = np.array(((2.0, 4.5), (2.2, 7.0)))
#: Houses: place [m], turn [degrees].
HOUSES = ((572.0, 300.0, 20.0), (612.0, 322.0, -35.0), (540.0, 352.0, 75.0), (660.0, 372.0, 10.0),
          (498.0, 450.0, -20.0))
WALLS, ROOF = (232, 222, 200), (150, 78, 56)


def smooth_country():
    """A terrain of the Gaussian model, without detail of its own."""
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
    z = array_from_image(source.GetOutput()).astype(float)
    return countries.Country.from_heights(z, (SPACING, SPACING))


def tree_sites(country):
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
    heights = country.height(*places.T)
    pines = random.random(len(places)) < np.clip((heights - country.z.mean()) / 18.0 + 0.45, 0.1, 0.9)
    species = np.where(pines, 0, 1).astype(np.int32)
    return vertices(np.column_stack((places, heights)), Species=species)


def houses(country):
    """Walls and gable roofs, lit by hand: they have no normals of their own."""
    points, triangles, colors = [], [], []

    def face(corners, color):
        corners = np.asarray(corners)
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal = -normal if normal[2] < 0.0 else normal  # a roof's outside is above
        shine = max(0.0, float(normal @ direction(*countries.SUN)) / np.linalg.norm(normal))
        first = len(points)
        points.extend(corners)
        triangles.extend((first, first + k, first + k + 1) for k in range(1, len(corners) - 1))
        colors.extend([np.array(color) * (0.5 + 0.5 * shine)] * len(corners))

    for x, y, turn in HOUSES:
        c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
        ground = float(country.height(x, y)) - 1.0

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
    return polygons(
        np.array(points), np.array(triangles), np.clip(np.array(colors), 0.0, 255.0).astype(np.uint8))


def draw(folder):
    """Write figure10.png into a folder."""
    country = smooth_country()
    trees = tree_sites(country)
    eye = np.array((*EYE, country.height(*EYE) + EYE_HEIGHT))
    places = vtk_to_numpy(trees.GetPoints().GetData()).astype(float)
    crowns = CROWNS[vtk_to_numpy(trees.GetPointData().GetArray("Species"))]
    shades = countries.shadows(country, places, *crowns.T)
    terrain = views.reader("country", country.image, folder)
    sites, sky, dark, homes = (
        views.reader(name, data, folder)
        for name, data in (("sites", trees), ("sky", sky_dome(eye)),
                           ("shadows", shades), ("houses", houses(country))))
    write_sky(os.path.join(folder, "sky.png"))

    prototypes = [simple.ReevesTree(Preset="Pine", Seed=3), simple.ReevesTree(Preset="Birch", Seed=2)]
    forest = simple.PlantScatter(
        Sites=sites, Prototypes=prototypes, Terrain=terrain, NearDistance=420.0, FarDistance=3000.0)
    wind = simple.WindField(
        Dimensions=[600, 100, 12], LateralSpacing=12.5, ReferenceSpeed=SPEED, Center=[0.5 * SIDE] * 2,
        RoughnessLength=0.1)
    sway = simple.BeamTreeDeformation(Input=forest, Wind=wind, Prototypes=prototypes)

    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [2 * n for n in SIZE]
    landscape.prepare_view(view)
    views.look(view, eye, (*FOCUS, country.height(*FOCUS) + 2.0), VIEW_ANGLE)
    view.ViewTime = TIME
    landscape.show_sky(sky, view, os.path.join(folder, "sky.png"))
    landscape.show_ground(
        simple.TerrainLevelOfDetail(Input=terrain), view)
    views.show_baked(dark, view)
    views.show_baked(homes, view)
    landscape.show_plants(sway, view)
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
