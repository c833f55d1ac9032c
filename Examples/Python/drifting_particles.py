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

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture)

from littoral import (
    vtkCurrentDriftFilter, vtkFlowPrimitiveSource, vtkParticleOrbitFilter, vtkSeaStateSource,
    vtkSuspendedParticleSource)
from littoral.picture import write_png

DEPTH = 10.0  # water depth [m]
WATER = (0.035, 0.23, 0.30)
EYE = (0.0, -5.0, -5.0)
HORIZON = 0.4  # height in the image, as a fraction


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


def faded(data, colors, sight):
    """Set colors of points (0 to 1), attenuated to the water color; sight: attenuation length [m]."""
    places = vtk_to_numpy(data.GetPoints().GetData())
    share = np.exp(-np.linalg.norm(places - EYE, axis=1) / sight)[:, None]
    colors = 255.0 * (share * colors + (1.0 - share) * np.array(WATER))
    array = numpy_to_vtk(np.clip(colors, 0, 255).astype(np.uint8), deep=True,
                         array_type=vtkUnsignedCharArray().GetDataType())
    data.GetPointData().SetScalars(array)


def unlit(data):
    """An actor without lighting."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def particle_actor(orbits, particles):
    """Squares with the textures of their kinds, tinted by RGB."""
    data = orbits.GetOutput()
    faded(data, vtk_to_numpy(data.GetPointData().GetArray("RGB")) / 255.0, 6.0)
    texture = vtkTexture()
    texture.SetInputConnection(particles.GetOutputPort(1))
    texture.InterpolateOn()
    texture.MipmapOn()
    actor = unlit(data)
    actor.SetTexture(texture)
    actor.ForceTranslucentOn()
    return actor


def surface_actor(sea, time, quick):
    """The surface from below: bright where it converges and focuses light."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-60.0, -12.0, 0.0)
    plane.SetPoint1(60.0, -12.0, 0.0)
    plane.SetPoint2(-60.0, 90.0, 0.0)
    plane.SetResolution(*((150, 125) if quick else (600, 500)))
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, plane.GetOutputPort())
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    orbits.UpdateTimeStep(time)
    data = orbits.GetOutput()
    jacobian = vtk_to_numpy(data.GetPointData().GetArray("Jacobian"))
    colors = np.column_stack([np.interp(jacobian, (0.75, 1.0, 1.25), shades) for shades in (
        (0.80, 0.20, 0.08), (0.98, 0.58, 0.38), (0.94, 0.64, 0.46))])
    faded(data, colors, 18.0)
    return unlit(data)


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
    renderer.GradientBackgroundOn()
    below = 0.5 * np.array(WATER)
    renderer.SetBackground(*below)
    renderer.SetBackground2(*(below + (WATER - below) / HORIZON))
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)
    renderer.AddActor(surface_actor(sea, 7.3, quick))
    renderer.AddActor(particle_actor(orbits, particles))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(0.0, 3.0, -3.9)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(42.0)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetAlphaBitPlanes(1)
    window.AddRenderer(renderer)
    os.makedirs(folder, exist_ok=True)
    write_png(window, os.path.join(folder, "drifting_particles.png"), (250, 140) if quick else (1000, 560))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), "--quick" in sys.argv)
