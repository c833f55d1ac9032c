# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""The wind in ParaView: its times, its period, its direction."""

import quick
from paraview import servermanager
from paraview.simple import GetAnimationScene, GetTimeKeeper, WindField
from vtkmodules.util.numpy_support import vtk_to_numpy


def velocities(proxy, time):
    """A copy of the velocities at a time."""
    proxy.UpdatePipeline(time)
    image = servermanager.Fetch(proxy)
    return vtk_to_numpy(image.GetPointData().GetArray("Velocity")).copy()


wind = WindField(Dimensions=[200, 8, 6], TimeStep=0.25)
start = velocities(wind, 0.0)
assert len(wind.TimestepValues) == 200 and wind.TimestepValues[1] == 0.25
assert (velocities(wind, 50.0) == start).all(), "the period is not 50 s"
assert (velocities(wind, 25.0) != start).any(), "the field stands still"
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
assert len(GetTimeKeeper().TimestepValues) == 200, "the animation does not know the times"

steps = [velocities(wind, 0.25 * (11.0 + part / 8.0)).reshape(48, 200, 3).var(axis=1) for part in range(8)]
pulse = max(abs(variance / steps[0] - 1.0).max() for variance in steps)
assert pulse < 1e-4, "the variance pulses between steps"

wind.Coherence = "IEC"
other = velocities(wind, 0.0)
assert (other[:, 0] != start[:, 0]).any() and (other[:, 1:] == start[:, 1:]).all(), "IEC is not of the first alone"
wind.Coherence = "Exponential"
assert (velocities(wind, 0.0) == start).all(), "the coherence does not come back"

wind.WindDirection = 90.0
turned = velocities(wind, 0.0)
assert abs(turned[:, 1] - start[:, 0]).max() < 1e-5, "the wind does not blow along y"
x = wind.GetDataInformation().GetBounds()
assert x[3] - x[2] > 400.0 > 50.0 > x[1] - x[0], "the box is not turned"
print("wind: 200 times, period 50 s, turned by 90 degrees; variance between steps within", pulse)
