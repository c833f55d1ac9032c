# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Particles, currents and drift in ParaView: tables of boxes, repeatable currents, times, a state file."""

import os

import numpy as np
import quick
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def places(proxy, time):
    """A copy of the points at a time."""
    proxy.UpdatePipeline(time)
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPoints().GetData()).copy()


# The table of boxes starts as the preset Coastal Sea.
particles = simple.SuspendedParticles()
coast = places(particles, 0.0)
particles.Preset = "Custom"
assert (places(particles, 0.0) == coast).all(), "the default boxes are not those of the first preset"
particles.Boxes = [0, 5, 0, 5, -5, 0, 1, 0.01, 200, 1, 1, 1, 0, 5, 0, 5, -5, -4, 2, 0.01, 100, 1, 0.5, 0]
particles.AmountIs = "Count"
particles.BoxNames = ["Snow", "Sand"]
rest = places(particles, 0.0)
assert len(rest) == 300 and (rest[200:, 2] < -4.0).all(), "the table of boxes has no effect"
names = servermanager.Fetch(particles).GetFieldData().GetAbstractArray("BoxNames")
assert [names.GetValue(i) for i in range(2)] == ["Snow", "Sand"]
# Names stay when boxes change.
particles.Boxes = list(particles.Boxes)[:12] + [0, 5, 0, 5, -5, -4, 2, 0.01, 120, 1, 0.5, 0]
assert len(places(particles, 0.0)) == 320
names = servermanager.Fetch(particles).GetFieldData().GetAbstractArray("BoxNames")
assert names.GetValue(1) == "Sand"
rest = places(particles, 0.0)

# Particles show their own colors.
shown = simple.Show(particles)
assert shown.Representation == "Point Gaussian" and shown.MapScalars == 0, "colors are mapped"

# Currents: none, one, two.
drift = simple.CurrentDrift(Input=particles)
assert (places(drift, 3.0) == rest).all(), "points move without a current"
along = simple.FlowPrimitive(Strength=0.5)
drift.Currents = [along]
assert np.abs(places(drift, 3.0) - rest - [1.5, 0.0, 0.0]).max() < 1e-6
across = simple.FlowPrimitive(Strength=0.25, Axis=[0.0, 2.0, 0.0])
drift.Currents = [along, across]
assert np.abs(places(drift, 4.0) - rest - [2.0, 1.0, 0.0]).max() < 1e-6

# A turbulent wind, with time steps, serves as an ocean model. Its box must hold the particles.
wind = simple.WindField(Dimensions=[60, 16, 8], TimeStep=0.5)
bounds = wind.GetDataInformation().GetBounds()
particles.Preset = "Coastal Sea"
particles.Density = 0.1
middle = [0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3])]
low = bounds[4] + 1.0
particles.Bounds = [middle[0] - 5, middle[0] + 5, middle[1] - 5, middle[1] + 5, low, low + 5.0]
model = simple.CurrentDrift(Input=particles, Currents=[wind, across], VelocityArray="Velocity", KeepInWater=0)
assert model.VelocityInterpolation == "Cubic Spline"
model.VelocityInterpolation = "Linear"
straight = places(model, 3.3)
model.VelocityInterpolation = "Cubic Spline"
assert (places(model, 3.3) != straight).any(), "splines are straight"
rest = places(particles, 0.0)
direct = places(model, 3.3)
assert np.abs(direct - rest).max() > 1.0, "the wind does not carry"
for time in (0.0, 1.0, 2.0, 3.0, 6.0, 3.3):
    last = places(model, time)
assert (last == direct).all(), "the order of times matters"
assert (places(model, 0.0) == rest).all(), "points do not start where they are"

# Players know of the times, and waves go on from there.
orbits = simple.ParticleOrbits(Input=drift, SeaState=simple.SeaState())
assert np.abs(places(orbits, 3.0) - places(drift, 3.0)).max() > 0.01
simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
assert simple.GetTimeKeeper().TimestepValues is not None

simple.SaveState("currents.pvsm")
simple.ResetSession()
simple.LoadState("currents.pvsm")
loaded = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == "CurrentDrift"]
again = [proxy for proxy in loaded if len(proxy.Currents) == 2 and proxy.VelocityArray]
assert len(again) == 1 and (places(again[0], 3.3) == direct).all(), "the state file gives another drift"
os.remove("currents.pvsm")
print("currents: boxes, primitives, a model with time steps, a state file")
