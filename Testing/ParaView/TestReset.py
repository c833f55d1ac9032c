# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client tier=all
"""The session is reset over and over in the window: while filters follow the camera, after a film, after a state file.

What watched the views and sources of a session must be gone with it. LITTORAL_RESETS is how often; default 6.
"""

import os

import quick
from paraview import simple


def show_forest(view):
    """Trees and ground that follow the camera."""
    simple.Show(simple.Forest(MeanPerQuadrat=0.05), view)
    assert simple.FindSource("Trees").FollowCamera == 1


def show_particles(view):
    """Particles in waves that follow the camera, in a film."""
    sea = simple.SeaState(NumberOfTrains=5)
    levels = simple.ParticleLevelOfDetail(Input=simple.SuspendedParticles(Density=0.1), SeaState=sea)
    simple.Show(simple.ParticleOrbits(Input=levels, SeaState=sea), view)


def show_tree(view):
    """A tree in the wind, in a film, and one without."""
    tree = simple.ReevesTree(Preset="Shrub")
    simple.Show(simple.BeamTreeDeformation(Input=tree, Wind=simple.WindField(Dimensions=[100, 16, 8])), view)
    simple.Show(tree, view)


def play(view):
    """Three frames, each from another place."""
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = 3
    frames = []

    def on_tick(*_):
        frames.append(view.GetActiveCamera().Azimuth(5.0))

    ticks = scene.GetClientSideObject()
    tick = ticks.AddObserver("AnimationCueTickEvent", on_tick)
    scene.Play()
    ticks.RemoveObserver(tick)
    assert len(frames) == 3, f"the film had {len(frames)} frames"


SHOWN = (show_forest, show_particles, show_tree)

for k in range(int(os.environ.get("LITTORAL_RESETS", "6"))):
    view = simple.GetActiveViewOrCreate("RenderView")
    SHOWN[k % len(SHOWN)](view)
    simple.ResetCamera(view)
    simple.Render(view)
    if k % 2 == 0:
        play(view)
    if k % 4 == 3:
        simple.SaveState("reset.pvsm")
        simple.ResetSession()
        simple.LoadState("reset.pvsm")
        simple.Render()
    simple.ResetSession()
    assert not simple.GetSources(), "the session is not empty"
    # The next picture, of another view, has nothing of the old ones.
    simple.Show(simple.Sphere(), simple.GetActiveViewOrCreate("RenderView"))
    simple.Render()
    simple.ResetSession()
