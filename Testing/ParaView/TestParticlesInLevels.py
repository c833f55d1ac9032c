# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Particles in waves that follow the camera in levels of detail, and their fog, by the proxies."""

import numpy as np
import quick
from paraview import simple

view = simple.CreateView("RenderView")
view.ViewSize = [400, 300]
simple.SetActiveView(view)
particles = simple.PointSource(NumberOfPoints=6000, Radius=12.0, Center=[0.0, 12.0, -12.0])
sea = simple.SeaState()
levels = simple.ParticleLevelOfDetail(Input=particles, SeaState=sea, OffsetRange=[0.0, 2.0])
assert levels.MiddleDistance == 2.0 and levels.FarDistance == 12.0, "other distances than the paper's"
orbits = simple.ParticleOrbits(Input=levels, SeaState=sea)
fog = simple.ParticleFog(Input=levels, Dimensions=[20, 20, 20])
simple.Show(orbits, view)
simple.Render(view)  # the first picture sets the camera


def counter(name):
    """A number of the field data of the levels, as they are for the last picture."""
    simple.UpdatePipeline(proxy=levels)
    return levels.GetDataInformation().GetFieldDataInformation().GetArrayInformation(name).GetComponentRange(0)[0]


def look(eye, focus):
    """Draw from a point towards another."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = eye, focus, [0.0, 0.0, 1.0]
    simple.Render(view)


look([0.0, 5.0, -12.0], [0.0, 12.0, -12.0])
assert counter("ParticlesInAll") == 6000.0
inside = [counter(name) for name in ("ParticlesShown", "Slaves", "ParticlesFar", "TrainSums")]
assert inside[0] > 100 and inside[1] > 50 and inside[2] > 100, inside
look([0.0, -8.0, -12.0], [0.0, 12.0, -12.0])
outside = [counter(name) for name in ("ParticlesShown", "Slaves", "ParticlesFar", "TrainSums")]
assert outside[2] > inside[2] and outside[3] < inside[3], "levels do not follow the camera"
look([0.0, -8.0, -12.0], [0.0, -12.0, -12.0])
assert counter("ParticlesShown") == 0.0, "particles behind the eye"

look([0.0, -8.0, -12.0], [0.0, 12.0, -12.0])
simple.UpdatePipeline(proxy=fog)
extinction = fog.GetDataInformation().GetPointDataInformation().GetArrayInformation("Extinction").GetComponentRange(0)
assert extinction[0] >= 0.0 and 1e-5 < extinction[1] < 1e-2, extinction
assert fog.GetDataInformation().GetExtent() == (0, 19, 0, 19, 0, 19)
simple.Hide(orbits, view)
shown = simple.Show(fog, view, "UniformGridRepresentation")
shown.Representation = "Volume"
simple.ColorBy(shown, ("POINTS", "Extinction"))
simple.Render(view)

levels.FollowCamera = 0
assert levels.TrainSelection == "Tail Sum"
levels.UseLevels, levels.UseCulling, levels.TrainSelection, levels.VisibleDistance = 0, 0, "All Trains", 0.0
simple.UpdatePipeline(proxy=levels)
assert counter("TrainSums") == counter("TrainSumsInAll") == 6000.0 * 30.0
assert np.isfinite(counter("MaximumSlaveError"))
