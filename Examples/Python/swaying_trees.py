# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""An oak, a pine and a birch in the wind, as an image sequence, with their amplitudes and frequencies.

    python3 swaying_trees.py [FOLDER] [FRAMES] [SPEED] [--quick]

writes swaying.0000.png ... into FOLDER, a frame each 1/12 s, in a wind of SPEED (default 10 m/s), and prints
amplitudes and frequencies of trunks and branches. --quick, for a test, measures an eighth as long and draws small.
"""

import os
import sys
import tempfile

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from littoral import vtkBeamTreeDeformationFilter, vtkLandscapePass, vtkReevesTreeSource, vtkWindFieldSource
from littoral.gallery.floor import light
from littoral.picture import write_png
from littoral.plants import block, plant_actor

SPECIES = (("Oak", 5, -10.5), ("Pine", 3, 0.0), ("Birch", 2, 8.0))  # preset, seed, lateral position [m]
PRESETS = {"Pine": 1, "Oak": 2, "Birch": 3}
FRAME = 1.0 / 12.0  # [s]
STEP, SAMPLES = 0.1, 512  # sampling of the measured motion [s]


def make_wind(speed):
    """A minute of wind over meadows."""
    wind = vtkWindFieldSource()
    wind.SetDimensions(600, 16, 10)
    wind.SetReferenceSpeed(speed)
    return wind


def make_trees(wind):
    """The filters, one per tree."""
    trees = []
    for preset, seed, _ in SPECIES:
        tree = vtkReevesTreeSource()
        tree.SetPreset(PRESETS[preset])
        tree.SetSeed(seed)
        sway = vtkBeamTreeDeformationFilter()
        sway.SetInputConnection(0, tree.GetOutputPort())
        sway.SetWindConnection(wind.GetOutputPort())
        sway.Update()
        trees.append(sway)
    return trees


def joints(sway, time):
    """Positions of the skeleton's nodes."""
    sway.UpdateTimeStep(time)
    bones = block(sway.GetOutput(), "High", "Skeleton")
    return vtk_to_numpy(bones.GetPoints().GetData()).copy()


def feet_and_tips(sway):
    """Nodes at the foot and at the tip of each branch; the trunk is the first."""
    lines = block(sway.GetOutput(), "High", "Skeleton").GetLines()
    nodes, offsets = (vtk_to_numpy(a) for a in (lines.GetConnectivityArray(), lines.GetOffsetsArray()))
    return nodes[offsets[:-1]], nodes[offsets[1:] - 1]


def frequency(series):
    """Mean frequency of motions [Hz]: rms speed over rms displacement, over 2 pi."""
    moving = series - series.mean(axis=0)
    speed = np.gradient(moving, STEP, axis=0)
    return np.sqrt((speed ** 2).sum() / (moving ** 2).sum()) / (2.0 * np.pi)


def measure(sway, samples):
    """Trunk, and branches relative to their feet: mean deflection, standard deviation [m], frequency [Hz]."""
    rest = vtk_to_numpy(block(sway.GetInputDataObject(0, 0), "High", "Skeleton").GetPoints().GetData())
    feet, tips = feet_and_tips(sway)
    moves = np.array([joints(sway, k * STEP) - rest for k in range(samples)])
    own = moves[:, tips] - moves[:, feet]
    numbers = []
    for series in (own[:, :1], own[:, 1:]):
        spread = np.sqrt(series.var(axis=0).sum(axis=-1).mean())
        numbers.append((np.linalg.norm(series.mean(axis=0), axis=-1).mean(), spread, frequency(series)))
    return numbers


def draw(trees, folder, frames, size):
    """Write the frames."""
    renderer, window = vtkRenderer(), vtkRenderWindow()
    light(renderer, ((0.42, 0.46, 0.25), (0.46, 0.52, 0.23)), SunAzimuth=248.0, SunElevation=26.0, Visibility=20000.0,
          ExposureCompensation=0.7, CoverRadius=90.0, CoverHeight=0.35)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1.0, -40.0, 2.0)
    camera.SetFocalPoint(-1.0, 0.0, 6.4)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(24.0)
    for frame in range(frames):
        actors = []
        for sway, (_, _, across) in zip(trees, SPECIES):
            sway.UpdateTimeStep(frame * FRAME)
            for name in ("Skin", "Leaves"):
                actors.append(plant_actor(block(sway.GetOutput(), "High", name)))
                actors[-1].SetPosition(across, 0.0, 0.0)
                vtkLandscapePass.SetTransmittance(actors[-1], 0.4 if name == "Leaves" else 0.0)
                renderer.AddActor(actors[-1])
        renderer.ResetCameraClippingRange()
        write_png(window, os.path.join(folder, f"swaying.{frame:04d}.png"), size)
        for actor in actors:
            renderer.RemoveActor(actor)


def main(folder, frames=2, speed=10.0, quick=False):
    """Measure and draw."""
    trees = make_trees(make_wind(speed))
    for sway, (preset, _, _) in zip(trees, SPECIES):
        trunk, branches = measure(sway, SAMPLES // 8 if quick else SAMPLES)
        own = sway.GetOutput().GetFieldData().GetArray("Frequency").GetTuple1(0)
        print(f"{preset:6} trunk: {own:.2f} Hz alone, leans {trunk[0]:.3f} m, sways by {trunk[1]:.3f} m at "
              f"{trunk[2]:.2f} Hz; branches besides: {branches[0]:.3f} m, {branches[1]:.3f} m, {branches[2]:.2f} Hz")
        assert 0.0 < trunk[1] < 2.0 and branches[1] > 0.0, "nothing sways, or trees fall"
    os.makedirs(folder, exist_ok=True)
    draw(trees, folder, frames, (160, 90) if quick else (640, 360))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), *map(int, words[1:2]), *map(float, words[2:3]),
         quick="--quick" in sys.argv)
