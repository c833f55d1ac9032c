# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Levels of particles that are chosen before a uniform current moves them, as in the example underwater.py: after its 6 s,
0.5 m, the picture is nearly that of levels chosen where the particles are, whose fog goes by steps of 5 mm, and the water as
turbid. After 5 m it is not."""

import tempfile

import numpy as np
import quick
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from window import colors

from littoral.gallery import bay, views

DEPTH, EYE, SPEED = 9.5, (0.0, 0.0, -6.3), 0.08


def drifting(particles, current):
    return simple.CurrentDrift(Input=particles, Currents=current, WaterDepth=DEPTH, StartTime=0.0)


def levels(particles, sea):
    return simple.ParticleLevelOfDetail(Input=particles, SeaState=sea, VisibleDistance=30.0, UseCulling=0, FollowCamera=0,
                                        ViewPoint=list(EYE), ViewDirection=[0.0, 1.0, 0.11], ViewUp=[0.0, 0.0, 1.0])


def show(view, carried, sea):
    """The particles, and those far away as fog."""
    seen = simple.ExtractBlock(Input=carried, Selectors=["/Root/Near", "/Root/MasterSlave"])
    riding = simple.ExtractBlock(
        Input=simple.ParticleOrbits(Input=seen, SeaState=sea), Selectors=["/Root/Near", "/Root/MasterSlave"])
    fog = simple.ParticleFog(Input=carried, GridBy="Spacing", Spacing=0.5, UseBounds=1,
                             Bounds=[-17.0, 17.0, -7.0, 29.0, -DEPTH, 0.0])
    views.show_fog(fog, view)
    views.show_particles(riding, view)
    return fog


def picture(view, time):
    view.ViewTime = time
    simple.Render(view)
    return colors(view).copy()


def main(folder):
    simple._DisableFirstRenderCameraReset()
    points = bay.particles(
        (-17.0, 1.2, -DEPTH + 0.1, 17.0, 29.0, -0.5), 60000, 0.012, (0.84, 0.93, 0.84), clumps=0.9)
    reader = views.reader("points", points, folder)
    sea = simple.SeaState(SeaBy="Height And Period", SignificantWaveHeight=0.6, PeakPeriod=6.2, WaterDepth=DEPTH,
                          NumberOfTrains=8)
    current = simple.FlowPrimitive(Strength=SPEED, Axis=[1.0, 0.25, 0.0])
    pictures, extinction = {}, {}
    for name, make in (("before", lambda: drifting(levels(reader, sea), [current])),
                       ("after", lambda: levels(drifting(reader, [current]), sea))):
        view = simple.CreateView("RenderView")
        view.ViewSize = [320, 180]
        simple.SetActiveView(view)
        views.light(view, ExposureCompensation=1.7, WaterRipples=0)
        views.look(view, EYE, (0.0, 10.0, -5.2), 66.0)
        fog = show(view, make(), sea)
        simple.Render(view)
        for time in (6.0, 60.0):
            pictures[name, time] = picture(view, time)
            image = fog.SMProxy.GetClientSideObject().GetOutputDataObject(0)
            extinction[name, time] = vtk_to_numpy(image.GetPointData().GetArray("Extinction")).astype(float)
    assert np.ptp(pictures["after", 6.0]) > 30, "nothing is seen"
    for time in (6.0, 60.0):
        difference = np.abs(pictures["before", time] - pictures["after", time])
        turbid = [extinction[name, time].sum() for name in ("before", "after")]
        changed = (difference > 1).mean()
        assert abs(turbid[0] / turbid[1] - 1.0) < (0.001 if time == 6.0 else 0.02), (time, turbid)
        if time == 6.0:
            assert difference.mean() < 0.05 and changed < 0.022, (difference.max(), difference.mean(), changed)
        else:
            assert difference.mean() > 0.2 and changed > 0.1, (difference.max(), difference.mean(), changed)


with tempfile.TemporaryDirectory() as data:
    main(data)
