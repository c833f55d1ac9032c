# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""The edge of a wood by the light of sun and sky, in plain VTK, with a hut of the user's own.

    python3 landscape_light.py [FOLDER] [ELEVATION] [AZIMUTH] [--quick]

writes landscape.png into FOLDER, under a sun of ELEVATION and AZIMUTH (default 16 and 60 degrees). --quick, for a test,
draws few trees in a small picture.
"""

import os
import sys
import tempfile

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import vtkLandscapePass, vtkReevesTreeSource, vtkTerrainLevelOfDetailFilter, vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image
from littoral.gallery.meshes import add_array, polygons
from littoral.picture import write_png
from littoral.plants import block

SIZE = 240.0  # of the land [m]
EYE, TARGET = (118.0, 40.0), (126.0, 110.0)  # on the ground [m]
HUT = (134.0, 78.0)
#: Colors of bark and leaves by the preset of trees.
COLORS = {1: ((0.42, 0.33, 0.26), (0.24, 0.36, 0.20)), 2: ((0.38, 0.32, 0.25), (0.33, 0.44, 0.16)),
          3: ((0.80, 0.78, 0.74), (0.45, 0.52, 0.20))}


def make_land():
    """Gentle ground, and its heights by row and column."""
    source = vtkTurningBandsTerrainSource()
    source.SetWholeExtent(0, int(SIZE), 0, int(SIZE), 0, 0)
    source.SetStandardDeviation(2.0)
    source.SetRange(150.0)
    source.SetMean(0.0)
    source.SetSeed(4)
    land = vtkTerrainLevelOfDetailFilter()
    land.SetInputConnection(source.GetOutputPort())
    land.SetNumberOfLevels(1)
    land.UseCullingOff()
    land.Update()
    return land.GetOutput().GetBlock(0), array_from_image(source.GetOutput())


def actor_of(data, color=None):
    """Actor of a surface in a color, or in its own ones."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(color is None)
    actor.SetMapper(mapper)
    if color:
        actor.GetProperty().SetColor(*color)
    return actor


def grown(part, color, places, scales, turns):
    """Actor of a part of a tree in a color at many places [m], of scales and turns about z [degrees]."""
    data, points = vtkPolyData(), vtkPoints()
    for place in places:
        points.InsertNextPoint(*place)
    data.SetPoints(points)
    add_array(data, "Scale", scales)
    add_array(data, "Turn", np.column_stack((0.0 * turns, 0.0 * turns, turns)))
    mapper, actor = vtkGlyph3DMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.SetSourceData(part)
    mapper.SetScaleArray("Scale")
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.SetOrientationArray("Turn")
    mapper.SetOrientationModeToRotation()
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    return actor


def add_trees(renderer, heights, number):
    """Oaks, pines and birches on both sides of a clearing."""
    random = np.random.default_rng(3)
    x, y = random.uniform(60.0, 190.0, number), random.uniform(50.0, 200.0, number)
    clear = np.abs(x - 122.0 - 0.1 * (y - 50.0)) < 9.0 + 0.05 * (y - 50.0)
    x, y = x[~clear], y[~clear]
    places = np.column_stack((x, y, heights[y.astype(int), x.astype(int)] - 0.15))
    kinds = random.integers(1, 4, len(x))
    for kind, colors in COLORS.items():
        tree = vtkReevesTreeSource()
        tree.SetPreset(kind)
        tree.SetSeed(kind)
        tree.Update()
        own = places[kinds == kind]
        scales, turns = random.uniform(0.75, 1.2, len(own)), random.uniform(0.0, 360.0, len(own))
        for name, color in zip(("Skin", "Leaves"), colors):
            actor = grown(block(tree.GetOutput(), "High", name), color, own, scales, turns)
            if name == "Skin":
                vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Bark)
            else:
                vtkLandscapePass.SetTransmittance(actor, 0.4)
            renderer.AddActor(actor)


def add_hut(renderer, heights):
    """Walls and a roof, which know nothing of the light."""
    x, y, z = *HUT, heights[int(HUT[1]), int(HUT[0])]
    walls = vtkCubeSource()
    walls.SetBounds(x - 2.5, x + 2.5, y - 2.0, y + 2.0, z - 0.5, z + 2.4)
    walls.Update()
    renderer.AddActor(actor_of(walls.GetOutput(), (0.55, 0.42, 0.32)))
    ridge, eaves = ((x - 2.9, y, z + 3.9), (x + 2.9, y, z + 3.9)), []
    for side in (-2.5, 2.5):
        eaves += [(x - 2.9, y + side, z + 2.2), (x + 2.9, y + side, z + 2.2)]
    roof = polygons(np.array((*eaves, *ridge)), np.array(((0, 1, 5), (0, 5, 4), (2, 4, 5), (2, 5, 3), (0, 4, 2), (1, 3, 5))))
    renderer.AddActor(actor_of(roof, (0.42, 0.23, 0.18)))


def main(folder, elevation=16.0, azimuth=60.0, quick=False):
    """Draw."""
    surface, heights = make_land()
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.AddRenderer(renderer)
    light = vtkLandscapePass()
    light.SetSunElevation(elevation)
    light.SetSunAzimuth(azimuth)
    light.SetVisibility(6000.0)
    light.SetQuality(vtkLandscapePass.Good if quick else vtkLandscapePass.Best)
    renderer.SetPass(light)
    ground = actor_of(surface, (0.46, 0.47, 0.28))
    vtkLandscapePass.SetMaterial(ground, vtkLandscapePass.Ground)
    renderer.AddActor(ground)
    add_trees(renderer, heights, 12 if quick else 170)
    add_hut(renderer, heights)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE, heights[int(EYE[1]), int(EYE[0])] + 1.7)
    camera.SetFocalPoint(*TARGET, heights[int(TARGET[1]), int(TARGET[0])] + 5.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(45.0)
    renderer.ResetCameraClippingRange()
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "landscape.png"), (160, 90) if quick else (960, 540))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), *map(float, words[1:3]), quick="--quick" in sys.argv)
