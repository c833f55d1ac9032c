# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""The surface of a wind sea out to the horizon, by the light of sun and sky, with foam where it nearly folds.

    python3 sea_surface.py [FOLDER] [--quick]     writes sea_surface.png into FOLDER; --quick, for a test, small and coarse
"""

import os
import sys
import tempfile

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from littoral import vtkLandscapePass, vtkSeaStateSource, vtkSeaSurfaceFilter
from littoral.picture import write_png

EYE = (0.0, -10.0, 4.5)  # [m]


def sea_surface(time, quick=False):
    """The surface at a time [s], with Normals and Jacobian."""
    sea = vtkSeaStateSource()
    sea.SetWindSpeed(10.0)
    sea.SetMeanDirection(-65.0)
    sea.SetNumberOfTrains(150)
    sea.SetFrequencyRange(0.5, 6.0)
    surface = vtkSeaSurfaceFilter()
    surface.SetInputConnection(sea.GetOutputPort())
    surface.SetCenter(*EYE[:2])
    surface.SetSpacing(1.0 if quick else 0.2)
    surface.UpdateTimeStep(time)
    return surface.GetOutput()


def water_actor(surface):
    """Water, of which vtkLandscapePass makes the color."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Water)
    return actor


def sun_and_sky():
    """A low sun ahead, and the slopes of waves that the mesh does not have."""
    light = vtkLandscapePass()
    light.SetSunElevation(17.0)
    light.SetSunAzimuth(12.0)
    light.SetCloudCover(0.35)
    light.SetExposureCompensation(-1.4)
    light.SetWaterAbsorption(0.31, 0.065, 0.025)
    light.SetWaterScattering(0.10, 0.12, 0.14)
    light.SetWaterSlopeVariance(0.02)
    light.SetFoamThreshold(0.72)
    return light


def main(folder, quick=False):
    """Render the sea at 7.3 s."""
    surface = sea_surface(7.3, quick)
    low, high = surface.GetBounds()[4:6]
    jacobian = surface.GetPointData().GetArray("Jacobian").GetRange()
    print(f"Heights {low:.2f} to {high:.2f} m, Jacobian {jacobian[0]:.2f} to {jacobian[1]:.2f}")
    assert low < -0.5 and high > 0.5, "a calm sea"
    renderer = vtkRenderer()
    renderer.SetPass(sun_and_sky())
    renderer.AddActor(water_actor(surface))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(0.0, 90.0, -5.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(38.0)
    camera.SetClippingRange(0.5, 8000.0)
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "sea_surface.png"), (250, 140) if quick else (1000, 560))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), "--quick" in sys.argv)
