# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""Save Animation of a swaying tree and of a sea: its frames differ, and are those that are drawn one by one."""

import os
import tempfile

import numpy as np
import quick
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
    simple.Delete(view)


with tempfile.TemporaryDirectory() as films:
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=400, MainBranches=8, Orders=1)
    wind = simple.WindField(ReferenceSpeed=14.0)
    check("tree", simple.BeamTreeDeformation(Input=tree, Wind=wind), films)
    check("sea", simple.SeaSurface(Input=simple.SeaState(), Radius=200.0, Sectors=90), films)
