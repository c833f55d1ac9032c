# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Under the waves: the surface from below, a sandy bed with stones, particles that fade into fog.

    ./littoral gui Examples/ParaView/underwater.py      opens it in ParaView
    pvbatch underwater.py FOLDER [WIDTH HEIGHT FRAMES]  writes underwater.png, or a film, into FOLDER

The same wave trains move the surface and the particles.
"""

import os
import sys
import tempfile

from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from littoral import underwater
from littoral.film import save_film

DEPTH = 9.5  # of the water [m]
EYE, FOCUS, VIEW_ANGLE = (0.0, 0.0, -6.3), (0.0, 10.0, -5.2), 66.0
TIME, FRAMES_A_SECOND = 7.3, 24


def reader(name, data, folder):
    """A reader of polydata, by way of a file."""
    filename = os.path.join(folder, f"{name}.vtp")
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    writer.SetFileName(filename)
    writer.Write()
    return simple.XMLPolyDataReader(registrationName=name, FileName=[filename], TimeArray="None")


def build(folder, view):
    """The pipeline, shown in a view; gives the representations with the water's shaders."""
    sea = simple.SeaState(registrationName="Sea", SeaBy="Height And Period", SignificantWaveHeight=0.55,
                          PeakPeriod=3.6, WaterDepth=DEPTH, MeanDirection=-70.0, NumberOfTrains=60)
    level = reader("Level", underwater.mesh(underwater.fan()), folder)
    surface = simple.ParticleOrbits(registrationName="Surface", Input=level, SeaState=sea)
    sand, _ = underwater.bed(DEPTH, EYE)
    floor = reader("Bed", sand, folder)
    drifting = reader("Drifting", underwater.particles(
        (-17.0, -1.0, -DEPTH + 0.4, 17.0, 29.0, -0.5), 480000, 0.0042, (0.84, 0.93, 0.84), clumps=0.93), folder)
    levels = simple.ParticleLevelOfDetail(registrationName="Levels", Input=drifting, SeaState=sea, Visibility=30.0)
    moving = simple.ParticleOrbits(registrationName="Particles", Input=levels, SeaState=sea)
    fog = simple.ParticleFog(registrationName="Fog", Input=levels, GridBy="Spacing", Spacing=0.5, UseBounds=1,
                             Bounds=[-17.0, 17.0, -1.0, 29.0, -DEPTH, 0.0])
    near = simple.ExtractBlock(Input=moving, Selectors=["/Root/Near", "/Root/MasterSlave"])

    underwater.prepare_view(view)
    view.CameraPosition, view.CameraFocalPoint = list(EYE), list(FOCUS)
    view.CameraViewUp, view.CameraViewAngle = [0.0, 0.0, 1.0], VIEW_ANGLE
    for animated in (surface, moving):
        simple.UpdatePipeline(TIME, animated)
    view.ViewTime = TIME
    underwater.show_fog(fog, view)
    underwater.show_particles(near, view, EYE)
    return [underwater.show_beyond(view, TIME, EYE), underwater.show_bed(floor, view, TIME),
            underwater.show_surface(surface, view, TIME)]


def main(folder, size=(960, 540), frames=0):
    """Build the scene; in batch, write the picture or the film as well."""
    simple._DisableFirstRenderCameraReset()
    os.makedirs(folder, exist_ok=True)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(size)
    shaded = build(folder, view)
    simple.Render(view)
    pictures = [os.path.join(folder, f"underwater.{frame:04d}.png") for frame in range(frames)]
    for frame, picture in enumerate(pictures):
        time = TIME + frame / FRAMES_A_SECOND
        for shown in shaded:
            underwater.set_time(shown, time)
        view.ViewTime = time
        simple.SaveScreenshot(picture, view)
    if frames > 0:
        save_film(os.path.join(folder, "underwater.ogv"), pictures, FRAMES_A_SECOND)
    if frames == 0 and len(sys.argv) > 1:
        simple.SaveScreenshot(os.path.join(folder, "underwater.png"), view)


if len(sys.argv) > 1:
    main(sys.argv[1], tuple(map(int, sys.argv[2:4])) or (960, 540), int(sys.argv[4]) if len(sys.argv) > 4 else 0)
else:
    main(tempfile.mkdtemp(prefix="littoral-"))
