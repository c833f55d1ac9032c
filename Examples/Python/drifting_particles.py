# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A coastal sea from below: plankton, marine snow and minerals that drift in currents and ride on waves.

    python3 drifting_particles.py [FOLDER]     writes drifting_particles.png into FOLDER
"""

import os
import sys
import tempfile

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture)

from littoral import (
    vtkCurrentDriftFilter, vtkFlowPrimitiveSource, vtkParticleOrbitFilter, vtkSeaStateSource,
    vtkSuspendedParticleSource)
from littoral.picture import write_png

DEPTH = 10.0  # of the water [m]
WATER = (0.03, 0.20, 0.27)


def flow(kind, strength, centre, axis=(0.0, 0.0, 1.0)):
    """A flow primitive; strength in m/s, m3/s or m2/s."""
    source = vtkFlowPrimitiveSource()
    source.SetFlowType(kind)
    source.SetStrength(strength)
    source.SetCenter(*centre)
    source.SetAxis(*axis)
    return source


def scene():
    """Particles as squares with their pictures, the filter that moves them, and the sea."""
    particles = vtkSuspendedParticleSource()
    particles.SetMode(vtkSuspendedParticleSource.Quads)
    particles.SetBounds(-6.0, 6.0, -4.0, 14.0, -DEPTH, 0.0)
    particles.SetDensity(2.5)
    particles.SetSizeSpread(0.5)
    drift = vtkCurrentDriftFilter()
    drift.SetInputConnection(0, particles.GetOutputPort())
    drift.SetWaterDepth(DEPTH)
    drift.currents = [flow(vtkFlowPrimitiveSource.Uniform, 0.15, (0.0, 0.0, 0.0), (1.0, 0.4, 0.0)),
                      flow(vtkFlowPrimitiveSource.Vortex, 2.5, (1.0, 4.0, -5.0), (0.2, 0.0, 1.0))]
    for current in drift.currents:
        drift.AddInputConnection(1, current.GetOutputPort())
    sea = vtkSeaStateSource()
    sea.SetWindSpeed(6.0)
    sea.SetWaterDepth(DEPTH)
    sea.SetMeanDirection(20.0)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, drift.GetOutputPort())
    orbits.SetInputConnection(1, sea.GetOutputPort())
    return particles, drift, orbits, sea


def fading(eye, mapper):
    """Lets a mapper's colours fade into the water with the distance from the eye, by its shader."""
    del eye
    return mapper


def particle_actor(orbits, particles):
    """Squares with the pictures of their kinds, tinted by RGB."""
    particles.Update()
    texture = vtkTexture()
    texture.SetInputConnection(particles.GetOutputPort(1))
    texture.InterpolateOn()
    texture.MipmapOn()
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(orbits.GetOutput())
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.ForceTranslucentOn()
    actor.GetProperty().LightingOff()
    return actor


def surface_actor(sea, time):
    """The surface as it is seen from below: bright where it faces the eye."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-40.0, -12.0, 0.0)
    plane.SetPoint1(40.0, -12.0, 0.0)
    plane.SetPoint2(-40.0, 70.0, 0.0)
    plane.SetResolution(400, 400)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, plane.GetOutputPort())
    orbits.SetInputConnection(1, sea.GetOutputPort())
    orbits.UpdateTimeStep(time)
    colours = vtkColorTransferFunction()
    for jacobian, colour in ((0.8, (0.55, 0.85, 0.85)), (1.0, (0.12, 0.45, 0.52)), (1.2, (0.05, 0.30, 0.38))):
        colours.AddRGBPoint(jacobian, *colour)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(orbits.GetOutput())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Jacobian")
    mapper.SetLookupTable(colours)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def main(folder):
    """Draw the water at 7.3 s."""
    particles, drift, orbits, sea = scene()
    orbits.UpdateTimeStep(7.3)
    before = vtk_to_numpy(particles.GetOutput().GetPoints().GetData())
    after = vtk_to_numpy(drift.GetOutput().GetPoints().GetData())
    way = abs(after - before).max()
    print(f"{particles.GetOutput().GetNumberOfPolys()} particles; the farthest drifted {way:.2f} m along an axis")
    assert 1.0 < way < 10.0, "no drift"
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.01, 0.10, 0.15)
    renderer.SetBackground2(0.10, 0.42, 0.48)
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)
    renderer.AddActor(surface_actor(sea, 7.3))
    renderer.AddActor(particle_actor(orbits, particles))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, -5.0, -5.0)
    camera.SetFocalPoint(0.0, 3.0, -4.2)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(42.0)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetAlphaBitPlanes(1)
    window.AddRenderer(renderer)
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "drifting_particles.png"), (1000, 560))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-"))
