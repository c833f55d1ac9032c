# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""The surface of a wind sea: a plane displaced by wave trains, with foam where it nearly folds.

    python3 sea_surface.py [FOLDER] [--quick]     writes sea_surface.png into FOLDER; --quick, for a test, small and coarse
"""

import os
import sys
import tempfile

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

from littoral import vtkParticleOrbitFilter, vtkSeaStateSource
from littoral.picture import write_png

WIDTH = 240.0  # side of the rendered square of sea [m]


def sea_surface(time, quick=False):
    """The surface at a time [s], with Normals and Jacobian."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-0.5 * WIDTH, 0.0, 0.0)
    plane.SetPoint1(0.5 * WIDTH, 0.0, 0.0)
    plane.SetPoint2(-0.5 * WIDTH, 1.5 * WIDTH, 0.0)
    plane.SetResolution(*((200, 300) if quick else (800, 1200)))
    sea = vtkSeaStateSource()
    sea.SetWindSpeed(10.0)
    sea.SetMeanDirection(-65.0)
    sea.SetNumberOfTrains(150)
    sea.SetFrequencyRange(0.5, 6.0)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, plane.GetOutputPort())
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    orbits.SetChoppiness(1.0)
    orbits.UpdateTimeStep(time)
    return orbits.GetOutput()


def water_actor(surface):
    """Water: dark where the surface diverges, pale and white where it converges."""
    colors = vtkColorTransferFunction()
    for jacobian, color in ((0.15, (0.93, 0.96, 0.96)), (0.35, (0.45, 0.66, 0.68)),
                             (0.75, (0.10, 0.36, 0.42)), (1.5, (0.02, 0.19, 0.27))):
        colors.AddRGBPoint(jacobian, *color)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Jacobian")
    mapper.SetLookupTable(colors)
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetAmbient(0.55)
    look.SetDiffuse(0.7)
    look.SetSpecular(0.5)
    look.SetSpecularPower(60.0)
    return actor


def main(folder, quick=False):
    """Render the sea at 7.3 s."""
    surface = sea_surface(7.3, quick)
    low, high = surface.GetBounds()[4:6]
    jacobian = surface.GetPointData().GetArray("Jacobian").GetRange()
    print(f"Heights {low:.2f} to {high:.2f} m, Jacobian {jacobian[0]:.2f} to {jacobian[1]:.2f}")
    assert low < -0.5 and high > 0.5, "a calm sea"
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.88, 0.90, 0.89)
    renderer.SetBackground2(0.45, 0.62, 0.76)
    renderer.UseFXAAOn()
    renderer.AddActor(water_actor(surface))
    sun = vtkLight()
    sun.SetPosition(150.0, 900.0, 260.0)
    sun.SetFocalPoint(0.0, 60.0, 0.0)
    sun.SetColor(1.0, 0.95, 0.85)
    renderer.AddLight(sun)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, -10.0, 9.0)
    camera.SetFocalPoint(0.0, 90.0, -5.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(38.0)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "sea_surface.png"), (250, 140) if quick else (1000, 560))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), "--quick" in sys.argv)
