# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""A property is changed while a film plays in the window: the last picture is that of a new pipeline with that value.

ParaView's window handles clicks between two frames; so the change is made there. The session is reset there, too.
TestWavesInFilm has waves, TestEachChangeInFilm the other pipelines.
"""

import sys

import quick
from paraview import simple
from player import difference

SIZE = [200, 150]
FRAMES = 3
END = 2.0  # [s]
CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp")


def orbits(height=None):
    """Particles in waves, in levels of detail, and their sea."""
    sea = simple.SeaState(NumberOfTrains=10, SeaBy="Height And Period")
    if height:
        sea.SignificantWaveHeight = height
    levels = simple.ParticleLevelOfDetail(Input=simple.SuspendedParticles(Density=0.1), SeaState=sea)
    return sea, simple.ParticleOrbits(Input=levels, SeaState=sea)


def waves(height=None):
    """A small surface of a sea."""
    sea = simple.SeaState(NumberOfTrains=10, SeaBy="Height And Period")
    if height:
        sea.SignificantWaveHeight = height
    return sea, simple.SeaSurface(Input=sea, Radius=100.0, Sectors=60)


def scene(make, name):
    """A ready scene, whose first source has the property."""

    def build(value=None):
        entry = make(**({name: value} if value else {}))
        return entry, entry

    return build


# What is shown, the property that changes, its new value.
CHANGES = {
    "Forest": (scene(simple.Forest, "MeanPerQuadrat"), "MeanPerQuadrat", 0.2),
    "Swaying Forest": (scene(simple.SwayingForest, "ReferenceSpeed"), "ReferenceSpeed", 18.0),
    "Sea": (scene(simple.Sea, "SignificantWaveHeight"), "SignificantWaveHeight", 1.0),
    "Waves": (waves, "SignificantWaveHeight", 3.0),
    "Orbits": (orbits, "SignificantWaveHeight", 3.0),
}


def show(output, place=None):
    """Show all outputs in a small view, from a place that is there before them, or from the first camera."""
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.GetLayout(view).PreviewMode = SIZE
    view.OrientationAxesVisibility = 0
    for item, numbers in zip(CAMERA, place or ()):
        setattr(view, item, numbers)
    for port in range(output.SMProxy.GetNumberOfOutputPorts()):
        simple.Show(simple.OutputPort(output, port), view)
    if not place:
        simple.ResetCamera(view)
    simple.Render(view)
    for display in view.Representations:
        if getattr(display, "Representation", None) == "Point Gaussian":
            display.GaussianRadius = 10.0  # by default it follows the first data
            simple.Render(view)
    return view


simple._DisableFirstRenderCameraReset()


def film():
    """Frames from 0 to END."""
    player = simple.GetAnimationScene()
    player.PlayMode = "Sequence"
    player.StartTime, player.EndTime = 0.0, END
    player.NumberOfFrames = FRAMES
    return player


def play(change):
    """Plays the film with a change between the second and the third frame."""
    player, frames = film(), []

    def on_tick(*_):
        frames.append(ticks.GetAnimationTime())
        if len(frames) == 2:
            change()

    ticks = player.GetClientSideObject()
    tick = ticks.AddObserver("AnimationCueTickEvent", on_tick)
    player.Play()
    ticks.RemoveObserver(tick)
    return frames


def camera(view):
    return [list(view.GetProperty(name)) for name in CAMERA]


def keep_picture(view, file):
    simple.SaveScreenshot(file, view, ImageResolution=SIZE)
    return file


def check(name):
    build, key, value = CHANGES[name]
    source, output = build()
    view = show(output)
    before = keep_picture(view, "before.png")
    frames = play(lambda: setattr(source, key, value))
    assert frames[-1] == END, f"{name}: the film has the frames {frames}"
    seen, place = keep_picture(view, "seen.png"), camera(view)
    simple.ResetSession()
    view = show(build(value)[1], place)
    film().AnimationTime = END
    simple.Render(view)
    other = difference(seen, keep_picture(view, "wanted.png"))
    changed = difference(seen, before)
    print(f"{name}: {changed:.1%} of the picture changed, {other:.2%} is not that of a new pipeline", file=sys.__stdout__)
    assert changed > 0.01, f"{name}: the change of {key} does not show"
    assert other < 0.002, f"{name}: {other:.2%} of the picture is not that of a new pipeline"
    simple.ResetSession()


def check_reset(name):
    """The film ends with its session, and a new one draws."""
    show(CHANGES[name][0]()[1])
    play(simple.ResetSession)
    assert not simple.GetSources(), f"{name}: the session is not empty"
    simple.Render(show(simple.Sphere()))
    simple.ResetSession()
