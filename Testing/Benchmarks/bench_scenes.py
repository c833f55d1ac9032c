# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the scenes in ParaView.

    build/bin/littoral-env xvfb-run -a pvpython Testing/Benchmarks/bench_scenes.py

For each scene, one line: seconds from the entry to its first picture, and pictures a second, by the median of twelve: of
steps of 1/12 s, or, where nothing moves, of turns of the camera by 1 degree.
"""

import statistics
import time

from paraview import simple

SIZE = [640, 400]  # of the view [pixels]
SCENES = {"Forest": False, "SwayingForest": True, "Sea": True, "Underwater": True, "TwinOfAPlace": False}  # moves?


def seconds(render):
    begin = time.perf_counter()
    render()
    return time.perf_counter() - begin


def show(name):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    simple.SetActiveView(view)
    simple.Show(getattr(simple, name)(), view)
    simple.Render(view)


def step(moves, number):
    view = simple.GetActiveView()
    if moves:
        view.ViewTime = number / 12.0
    else:
        view.GetActiveCamera().Azimuth(1.0)
    simple.Render(view)


for name, moves in SCENES.items():
    first = seconds(lambda: show(name))
    frame = statistics.median(seconds(lambda: step(moves, number)) for number in range(1, 13))
    print(f"{name:14s} first picture {first:4.1f} s, {1.0 / frame:4.1f} pictures a second", flush=True)
    simple.ResetSession()
