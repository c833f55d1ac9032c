# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws gardner.jpg of the user guide: plants of textured quadrics on a meadow.

    ./littoral run pvpython Documentation/pictures/make_gardner.py [FOLDER]
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkDiskSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from littoral import vtkGardnerPlantSource
from littoral.picture import write_jpg
from littoral.plants import add_daylight, level_actors, plant_actor

SIZE = (900, 500)
PLANTS = (  # kind, seed, place [m]
    ("Tree", 3, (-8.0, 2.0)), ("Bush", 2, (-2.2, -2.5)), ("Cypress", 1, (0.2, 3.0)),
    ("StonePine", 2, (8.0, 1.5)), ("Bush", 5, (11.6, -4.0)),
    ("Tree", 7, (-34.0, 90.0)), ("Tree", 8, (-26.0, 95.0)), ("Cypress", 4, (-14.0, 100.0)),
    ("Tree", 9, (10.0, 110.0)), ("Cypress", 5, (16.0, 80.0)), ("Tree", 6, (31.0, 85.0)))
SPREAD = {"Tree": 4.6, "Bush": 1.6, "Cypress": 1.3, "StonePine": 5.2}  # [m]
SKY = ((0.93, 0.92, 0.86), (0.55, 0.72, 0.90))  # at the horizon and above
EYE, FOCUS, VIEW_ANGLE = (1.0, -47.0, 3.4), (1.0, 0.0, 5.6), 18.0


def meadow(samples=400, reach=400.0, seed=1):
    """The ground, fading into the sky far away."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-0.6 * reach, -40.0, 0.0)
    plane.SetPoint1(0.6 * reach, -40.0, 0.0)
    plane.SetPoint2(-0.6 * reach, reach, 0.0)
    plane.SetResolution(samples, 2 * samples)
    plane.Update()
    ground = plane.GetOutput()
    places = np.array([ground.GetPoint(k) for k in range(ground.GetNumberOfPoints())])
    noise = np.random.default_rng(seed).standard_normal(len(places))
    green = np.array((0.47, 0.55, 0.25)) * (1.0 + 0.10 * noise[:, None])
    far = np.clip(places[:, 1:2] / reach, 0.0, 1.0) ** 0.5
    colors = green * (1.0 - far) + np.array(SKY[0]) * far
    rgb = numpy_to_vtk((255.0 * np.clip(colors, 0.0, 1.0)).astype(np.uint8), deep=True)
    rgb.SetName("RGB")
    ground.GetPointData().SetScalars(rgb)
    actor = plant_actor(ground)
    actor.GetProperty().LightingOff()
    return actor


def shadow(place, radius):
    """Soft dark disks on the ground."""
    for size in (0.6, 0.8, 1.0, 1.2):
        disk = vtkDiskSource()
        disk.SetInnerRadius(0.0)
        disk.SetOuterRadius(size * radius)
        disk.SetCircumferentialResolution(60)
        disk.Update()
        actor = plant_actor(disk.GetOutput())
        actor.SetPosition(place[0] + 0.4 * radius, place[1] + 0.3 * radius, 0.02 + 0.01 * size)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(0.16, 0.24, 0.16)
        actor.GetProperty().SetOpacity(0.22)
        yield actor


def main(folder):
    """Draw it into a folder."""
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*SKY[0])
    renderer.SetBackground2(*SKY[1])
    add_daylight(renderer)
    renderer.AddActor(meadow())
    for kind, seed, place in PLANTS:
        source = vtkGardnerPlantSource()
        source.SetPreset(getattr(source, kind))
        source.SetSeed(seed)
        source.Update()
        for actor in shadow(place, SPREAD[kind]):
            renderer.AddActor(actor)
        for actor in level_actors(source, "High", cut_leaves=True):
            actor.SetPosition(*place, 0.0)
            renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(*FOCUS)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(VIEW_ANGLE)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "gardner.jpg"), SIZE, oversampling=3)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
