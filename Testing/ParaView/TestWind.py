# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wind in ParaView: its times, its period, its direction."""

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

wind.WindDirection = 90.0
turned = velocities(wind, 0.0)
assert abs(turned[:, 1] - start[:, 0]).max() < 1e-5, "the wind does not blow along y"
x = wind.GetDataInformation().GetBounds()
assert x[3] - x[2] > 400.0 > 50.0 > x[1] - x[0], "the box is not turned"
print("wind: 200 times, period 50 s, turned by 90 degrees")
