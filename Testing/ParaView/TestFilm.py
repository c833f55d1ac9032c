# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Save Animation of a swaying tree and of a sea: its frames differ, and are those that are drawn one by one. Frames
with motion blur are the means of the light of pictures at their times."""

import os
import tempfile

import numpy as np
import quick
from littoral.film import blurred_frames, exposed, save_animation
from paraview import simple
from paraview.servermanager import Fetch
from paraview.vtk.util.numpy_support import vtk_to_numpy

SIZE = [160, 100]
TIMES = [2.0, 2.7, 3.4]


def pixels(file):
    return vtk_to_numpy(Fetch(simple.PNGSeriesReader(FileNames=[file])).GetPointData().GetScalars()).astype(int)


def apart(one, other):
    """Share of the pixels that differ."""
    return float((np.abs(one - other)[:, :3].sum(axis=1) > 12).mean())


def check_blur(view, folder, name, film):
    """A shutter that is never open long shows the frames; one that is shows what passes, here two pictures a frame."""
    view.ViewSize = SIZE
    sharp = [vtk_to_numpy(one.GetPointData().GetScalars()).astype(int) for one in blurred_frames(view, 0.0, 1)]
    assert len(sharp) == len(TIMES)
    for frame, one in enumerate(sharp):
        assert apart(one, film[frame]) == 0.0, f"{name}: frame {frame} without blur"
    blurred = [vtk_to_numpy(one.GetPointData().GetScalars()).astype(int) for one in blurred_frames(view, 1.0, 2)]
    scene = simple.GetAnimationScene()
    scene.AnimationTime = TIMES[0] + 0.25 * (TIMES[1] - TIMES[0])
    first = view.SMProxy.CaptureWindow(1)
    scene.AnimationTime = TIMES[0] + 0.75 * (TIMES[1] - TIMES[0])
    both = exposed([first, view.SMProxy.CaptureWindow(1)])
    assert (vtk_to_numpy(both.GetPointData().GetScalars()) == blurred[0]).all(), f"{name}: the blurred frame"
    assert apart(blurred[0], sharp[0]) > 0.002, f"{name}: nothing is blurred"
    save_animation(os.path.join(folder, f"{name}.ogv"), view, 0.5, 1)
    assert os.path.getsize(os.path.join(folder, f"{name}.ogv")) > 1000


def check(name, source, folder):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    simple.Show(source, view)
    simple.Render(view)
    simple.ResetCamera(view)
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.StartTime, scene.EndTime, scene.NumberOfFrames = TIMES[0], TIMES[-1], len(TIMES)
    simple.SaveAnimation(os.path.join(folder, f"{name}.png"), view, ImageResolution=SIZE)
    film = [pixels(os.path.join(folder, f"{name}.{frame:04d}.png")) for frame in range(len(TIMES))]
    for frame in (2, 0, 1):  # in another order
        scene.AnimationTime = TIMES[frame]
        simple.Render(view)
        still = os.path.join(folder, "still.png")
        simple.SaveScreenshot(still, view, ImageResolution=SIZE)
        assert apart(pixels(still), film[frame]) == 0.0, f"{name}: frame {frame} is not that of its time"
        os.remove(still)
    for frame in (1, 2):
        moved = apart(film[frame - 1], film[frame])
        assert moved > 0.002, f"{name}: {moved:.4f} of the pixels change to frame {frame}"
    if name == "tree":
        check_blur(view, folder, name, film)
    simple.Delete(view)


with tempfile.TemporaryDirectory() as films:
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=400, MainBranches=8, Orders=1)
    wind = simple.WindField(ReferenceSpeed=14.0)
    check("tree", simple.BeamTreeDeformation(Input=tree, Wind=wind), films)
    check("sea", simple.SeaSurface(Input=simple.SeaState(), Radius=200.0, Sectors=90), films)
