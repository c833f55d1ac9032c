# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a buoy and a model to a sea with drift, in the window, with the files that are shipped."""

import os
import shutil

import quick
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from guide import TOP, WINDOW
from guide_drainage import close_tables
from player import difference, drawn

PAGE = "currents"

DATA = os.path.join(TOP, "Examples", "Data", "sea")
FILES = ("41010.data_spec", "41010.swdir", "41010.swr1", "current.nc")
#: Way of what drifts for 24 h in the current of the file, linear between its hours [m]: as python.TestGuidePrograms has it.
WAY = (-574.193, 8763.871)


def places(source):
    return vtk_to_numpy(source.GetClientSideObject().GetOutputDataObject(0).GetPoints().GetData()).astype(float)


def check_drift():
    """In the client: the particles are where the current has carried them, and up and down with the waves."""
    drift, orbits = simple.FindSource("CurrentDrift1"), simple.FindSource("ParticleOrbits1")
    start = places(simple.FindSource("SuspendedParticles1"))
    way = places(drift) - start
    print(f"{len(way)} particles drift by {way.mean(axis=0)} m, {abs(way[:, :2] - WAY).max():.2f} m from the way that is known")
    assert len(way) > 50 and abs(way[:, :2] - WAY).max() < 1.0
    assert 0.1 < abs(places(orbits) - places(drift)).max() < 2.0
    buoy, sea = (simple.FindSource(name) for name in ("41010.data_spec", "MeasuredSeaState1"))
    heights = [one.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("SignificantWaveHeight").GetValue(0)
               for one in (buoy, sea)]
    assert abs(heights[1] / heights[0] - 1.0) < 0.02, heights


def prepare():
    for file in FILES:
        shutil.copy(os.path.join(DATA, file), ".")


def walk(walk):
    walk.next("Wave spectra (Littoral)")
    walk.say("41010.data_spec")
    walk.open("41010.data_spec")
    walk.apply()
    walk.call(close_tables)
    walk.next("Water Depth")
    walk.entry("Filters > Littoral > Measured Sea State")
    walk.apply()
    walk.next("Currents of ocean models (Littoral)")
    walk.say("current.nc")
    walk.open("current.nc", "NetCDFReader")
    walk.apply()
    walk.next()
    walk.entry("Sources > Littoral > Suspended Particles")
    walk.set("Bounds", [-2000, 2000, -2000, 2000, -2, 0], said="Bounds -2000 2000 -2000 2000 -2 0 [m]")
    walk.slide("Density", 1e-5, "Density 1e-5 [1/m³]")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Current Drift")
    walk.say("current.nc")
    walk.say("Currents")
    walk.connect("Currents", "current.nc")
    walk.slide("Time Step", 300, "Time Step to 300 s")
    walk.set("Time Range", [0, 86400], said="Time Range to 0 and 86400 s")
    walk.apply()
    walk.eye(1)
    walk.next()
    walk.say("CurrentDrift1")
    walk.select(2, 0, 0)
    walk.entry("Filters > Littoral > Particle Orbits")
    walk.take_input("Sea State", "MeasuredSeaState1", "/0/0/0|0")
    walk.apply()
    walk.eye(0, 0)
    walk.look("first")
    walk.next()
    walk.say("Last Frame")
    walk.event(f"{WINDOW}/VCRToolbar/actionVCRLastFrame")
    walk.look("last")
    walk.call(check_drift)


def check():
    assert drawn("first.png") > 0.02 and difference("first.png", "last.png") > 0.01
