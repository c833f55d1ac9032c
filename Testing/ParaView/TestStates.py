# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""States as .pvsm and as .py, and a trace, bring back the picture that was there, of each main pipeline, at its time.

A script of a state and a trace are run by a new process.
"""

import os
import subprocess
import sys

import numpy as np
import quick
from paraview import simple, smstate, smtrace
from server import OWN_RANK
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = [240, 160]


def twin():
    """The twin of a terrain, by its fits."""
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 80, 0, 80, 0, 0])
    fits = simple.CovarianceFit(Input=terrain)
    return [simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 80, 0, 60, 0, 0], Seed=9)]


def forest():
    """A forest that follows the camera."""
    sites = simple.QuadratPoints(Size=[60.0, 60.0], Quadrats=[8, 8])
    tree = simple.ReevesTree(Preset="Shrub")
    return [simple.PlantScatter(Sites=sites, Prototypes=[tree], NearDistance=30.0, FarDistance=120.0)]


def instances():
    """The same forest as instances."""
    made = forest()
    made[0].OutputForm = "Instances"
    return made


def swaying_tree():
    """A tree in the wind at a time."""
    wind = simple.WindField(Dimensions=[100, 16, 8], ReferenceSpeed=14.0)
    return [simple.BeamTreeDeformation(Input=simple.ReevesTree(Preset="Shrub"), Wind=wind)]


def particles():
    """Particles in waves, in levels of detail."""
    sea = simple.SeaState(NumberOfTrains=20)
    levels = simple.ParticleLevelOfDetail(Input=simple.SuspendedParticles(Density=0.2), SeaState=sea)
    return [simple.ParticleOrbits(Input=levels, SeaState=sea)]


def kelp():
    """Kelp in a sea, at a time."""
    sea = simple.SeaState(NumberOfTrains=20, SeaLevel=8.0)
    return [simple.SeaweedDeformation(Input=simple.Seaweed(Seed=3), SeaState=sea, StartTime=0.0)]


PIPELINES = {"twin": twin, "forest": forest, "instances": instances, "tree": swaying_tree, "particles": particles,
             "kelp": kelp}
TIMES = {"twin": 0.0, "forest": 0.0, "instances": 0.0, "tree": 2.5, "particles": 3.0, "kelp": 1.5}  # [s]


def build(name):
    """Show a pipeline at its time, from a place that is no default."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    for output in PIPELINES[name]():
        simple.UpdatePipeline(proxy=output)
        simple.Show(output, view)
    simple.ResetCamera(view)
    simple.Render(view)
    towards = np.subtract(view.CameraPosition, view.CameraFocalPoint)
    view.CameraPosition = list(np.add(view.CameraFocalPoint, 0.8 * towards))
    simple.GetAnimationScene().AnimationTime = TIMES[name]
    view.ViewTime = TIMES[name]
    simple.Render(view)
    return view


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def picture(file, time):
    """The active view as it is drawn at a time."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    view.ViewTime = time
    simple.Render(view)
    simple.SaveScreenshot(file, view, ImageResolution=SIZE)
    return read(file)


def run_script(file, picture_file, time):
    """What another process shows after a script."""
    if os.path.exists(picture_file):
        os.remove(picture_file)
    run(file, picture_file, str(time))
    return read(picture_file)


def compare(what, seen, wanted):
    differing = (np.abs(seen - wanted).max(axis=2) > 8).mean()
    print(f"{what}: {differing:.2%} of the picture is another", flush=True)
    assert differing < 0.002, f"{what}: {differing:.2%} of the picture is another"


def check(name):
    time = TIMES[name]
    trace = trace_of(lambda: build(name)) if name in ("twin", "tree") else None
    if trace is None:
        build(name)
    wanted = picture(f"{name}.png", time)
    corner = wanted[0, 0]
    shown = (np.abs(wanted - np.median(wanted, axis=(0, 1))).max(axis=2) > 12).mean()
    assert shown > 0.01, f"{name}: nothing is shown"
    simple.SaveState(f"{name}.pvsm")
    with open(f"{name}.py", "w") as file:
        file.write(smstate.get_state())
    simple.ResetSession()
    simple.LoadState(f"{name}.pvsm")
    view = simple.GetActiveViewOrCreate("RenderView")
    assert view.ViewTime == time, f"{name}, .pvsm: the time is {view.ViewTime}, not {time}"
    compare(f"{name}, .pvsm", picture(f"{name}-pvsm.png", time), wanted)
    simple.ResetSession()
    compare(f"{name}, .py", run_script(f"{name}.py", f"{name}-py.png", time), wanted)
    if trace:
        with open(f"{name}-trace.py", "w") as file:
            file.write(trace)
        compare(f"{name}, trace", run_script(f"{name}-trace.py", f"{name}-trace.png", time), wanted)


def trace_of(action):
    """The trace of what an action does."""
    config = smtrace.start_trace()
    config.SetFullyTraceSupplementalProxies(True)
    action()
    return smtrace.stop_trace()


def run(*arguments):
    """Run this script in a new process."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(OWN_RANK)}
    subprocess.run(["pvbatch", os.path.abspath(__file__), *arguments], check=True, env=environment)


if len(sys.argv) == 4:
    with open(sys.argv[1]) as script:
        exec(compile(script.read(), sys.argv[1], "exec"), {"__name__": "__main__"})
    picture(sys.argv[2], float(sys.argv[3]))  # ParaView's Python states have no time
elif len(sys.argv) == 2:
    check(sys.argv[1])
else:
    # ParaView's Python states lack the views of a session that was reset.
    for name in PIPELINES:
        run(name)
