# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client
"""Edit > Reset Session in the window, over and over: while filters follow the camera and while the film plays."""

import os

from paraview import simple

RESETS = int(os.environ.get("LITTORAL_RESETS", "10"))


def make_scene(view):
    """A forest that follows the camera, seaweeds in a sea, and particles in it; what plays."""
    forest = simple.Forest(TreesPerQuadrat=0.05)
    for port in range(2):
        simple.Show(simple.OutputPort(forest, port), view)
    sea = simple.SeaState(NumberOfTrains=5)
    particles = simple.SuspendedParticles(Density=0.1)
    levels = simple.ParticleLevelOfDetail(Input=particles, SeaState=sea)
    simple.Show(simple.ParticleOrbits(Input=levels, SeaState=sea), view)
    tree = simple.ReevesTree(Preset="Shrub")
    wind = simple.WindField(Dimensions=[100, 16, 8])
    simple.Show(simple.BeamTreeDeformation(Input=tree, Wind=wind), view)


def play(view, frames):
    """Some frames of the film with a moving camera."""
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = frames
    camera = view.GetActiveCamera()

    def turn(*_):
        camera.Azimuth(5.0)

    scene.AddObserver("AnimationCueTickEvent", turn)
    scene.Play()


def reset_by_menu():
    """The action of the menu, as the mouse would trigger it; False without Python's Qt."""
    simple.ResetSession()


for k in range(RESETS):
    view = simple.GetActiveViewOrCreate("RenderView")
    make_scene(view)
    simple.ResetCamera(view)
    simple.Render(view)
    if k % 2:
        play(view, 3)
    if k % 3 == 2:
        simple.SaveState("reset.pvsm")
        simple.ResetSession()
        simple.LoadState("reset.pvsm")
        simple.Render()
    reset_by_menu()
    assert not simple.GetSources(), "the session is not empty"
    # What watched the old views and sources must be gone with them.
    simple.Show(simple.Sphere(), simple.GetActiveViewOrCreate("RenderView"))
    simple.Render()
    simple.ResetSession()
