# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""A coastal sea from below: plankton, marine snow and minerals in currents and waves.

    python3 drifting_particles.py [FOLDER] [--quick]     writes drifting_particles.png into FOLDER; --quick, for a test,
                                                         small, with fewer particles
"""

import os
import sys
import tempfile

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture)

from littoral import (
    vtkCurrentDriftFilter, vtkFlowPrimitiveSource, vtkLandscapePass, vtkParticleOrbitFilter, vtkSeaStateSource,
    vtkSeaSurfaceFilter, vtkSuspendedParticleSource)
from littoral.picture import write_png
from littoral.properties import set_properties

DEPTH = 10.0  # water depth [m]
EYE = (0.0, -5.0, -5.0)
#: Light in clear water.
LIGHT = dict(SunElevation=52.0, SunAzimuth=8.0, CloudCover=0.2, ExposureCompensation=1.0, WaterSlopeVariance=0.02,
             WaterAbsorption=(0.31, 0.07, 0.04), WaterScattering=(0.03, 0.035, 0.035), WaterTime=7.3)


def flow(kind, strength, center, axis=(0.0, 0.0, 1.0)):
    """A flow primitive; strength in m/s, m3/s or m2/s."""
    source = vtkFlowPrimitiveSource()
    source.SetFlowType(kind)
    source.SetStrength(strength)
    source.SetCenter(*center)
    source.SetAxis(*axis)
    return source


def scene(quick):
    """The pipeline: particles as textured squares, drift, orbits and sea state."""
    particles = vtkSuspendedParticleSource()
    particles.SetMode(vtkSuspendedParticleSource.Quads)
    particles.SetBounds(-5.0, 3.0, -7.0, 1.0, -DEPTH, 0.0)
    particles.SetDensity(4.0 if quick else 22.0)
    particles.SetSizeSpread(0.6)
    drift = vtkCurrentDriftFilter()
    drift.SetInputConnection(0, particles.GetOutputPort())
    drift.SetWaterDepth(DEPTH)
    drift.currents = [flow(vtkFlowPrimitiveSource.Uniform, 0.15, (0.0, 0.0, 0.0), (1.0, 0.4, 0.0)),
                      flow(vtkFlowPrimitiveSource.Vortex, 2.5, (1.0, -1.0, -5.0), (0.2, 0.0, 1.0))]
    for current in drift.currents:
        drift.AddCurrentConnection(current.GetOutputPort())
    sea = vtkSeaStateSource()
    sea.SetWindSpeed(6.0)
    sea.SetWaterDepth(DEPTH)
    sea.SetMeanDirection(20.0)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, drift.GetOutputPort())
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    return particles, drift, orbits, sea


def actor_of(data):
    """An actor of a surface."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    return actor


def particle_actor(orbits, particles):
    """Squares with the textures of their kinds, tinted by RGB."""
    actor, texture = actor_of(orbits.GetOutput()), vtkTexture()
    texture.SetInputConnection(particles.GetOutputPort(1))
    texture.InterpolateOn()
    texture.MipmapOn()
    actor.SetTexture(texture)
    actor.ForceTranslucentOn()
    return actor


def surface_actor(sea, time, quick):
    """The surface, from below."""
    surface = vtkSeaSurfaceFilter()
    surface.SetInputConnection(sea.GetOutputPort())
    surface.SetCenter(*EYE[:2])
    surface.SetRadius(150.0)
    surface.SetSpacing(0.5 if quick else 0.1)
    surface.WaterColorsOff()
    surface.UpdateTimeStep(time)
    actor = actor_of(surface.GetOutput())
    vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Water)
    return actor


def main(folder, quick=False):
    """Render the water at 7.3 s."""
    particles, drift, orbits, sea = scene(quick)
    orbits.UpdateTimeStep(7.3)
    before = vtk_to_numpy(particles.GetOutput().GetPoints().GetData())
    after = vtk_to_numpy(drift.GetOutput().GetPoints().GetData())
    way = abs(after - before).max()
    print(f"{particles.GetOutput().GetNumberOfPolys()} particles; largest drift along an axis: {way:.2f} m")
    assert 0.5 < way < 10.0, "no drift"
    renderer = vtkRenderer()
    renderer.SetPass(set_properties(vtkLandscapePass(), LIGHT))
    renderer.AddActor(surface_actor(sea, 7.3, quick))
    renderer.AddActor(particle_actor(orbits, particles))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(0.0, 3.0, -1.6)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(52.0)
    camera.SetClippingRange(0.1, 400.0)
    window = vtkRenderWindow()
    window.SetAlphaBitPlanes(1)
    window.AddRenderer(renderer)
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "drifting_particles.png"), (250, 140) if quick else (1000, 560))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), "--quick" in sys.argv)
