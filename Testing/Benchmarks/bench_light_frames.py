# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of entries with Landscape Light over those without it, 960 x 540.

    build/bin/littoral-env --display pvpython Testing/Benchmarks/bench_light_frames.py [ENTRY...]

ENTRY: of Sources > Littoral, default Forest, or moves, or foam: a sea surface at other times, with foam that is left
behind over one without, and its frame in that light. In each of five rounds a view is drawn without its light and
with it in each quality, after turns of the camera by 1 degree. Printed are medians of processor time [s] and their
ratios to those without the light. moves: frames of Forest from within, without light and with it in the quality Good,
at rest, after turns by 1 degree, after ways of the camera of 0.5, 2 and 10 m, while it is dragged (its first picture,
and the others), and the still picture that follows.
"""

import sys
import time

import numpy as np
from paraview import simple

ROUNDS = 5
SETTINGS = {"without": None, "fast": dict(Quality="Fast"), "good": dict(Quality="Good"), "best": dict(Quality="Best")}


def frame(view):
    """Processor time of a frame after a turn of the camera [s]."""
    view.GetActiveCamera().Yaw(1.0)
    begin = time.process_time()
    simple.Render(view)
    return time.process_time() - begin


def measure(entry):
    """Medians by setting."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [960, 540]
    simple.SetActiveView(view)
    simple.Show(getattr(simple, entry)(), view)
    simple.ResetCamera(view)
    own = [source for (name, _), source in simple.GetSources().items() if name.startswith("Light")]
    shown = simple.Show(own[-1] if own else simple.LandscapeLight(), view)  # a scene has its own
    times = {name: [] for name in SETTINGS}
    for _ in range(ROUNDS):
        for name, settings in SETTINGS.items():
            shown.Visibility = settings is not None
            for key, value in (settings or {}).items():
                setattr(shown, key, value)
            frame(view)  # what a setting changes is made anew
            times[name].append(frame(view))
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    simple.Delete(view)
    return {name: float(np.median(some)) for name, some in times.items()}


def measure_foam():
    """Medians of processor times of a sea surface at another time, and of its frame [s], by lifetime of foam [s]."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [960, 540]
    simple.Show(simple.LandscapeLight(), view)
    sea = simple.SeaSurface(Input=simple.SeaState(WindSpeed=12.0))
    simple.Show(sea, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -30, 8], [0, 0, 0], [0, 0, 1]
    times = {0.0: [], 4.0: []}
    for step in range(ROUNDS + 1):
        for lifetime, some in times.items():
            sea.FoamLifetime = lifetime
            begin = time.process_time()
            sea.UpdatePipeline(0.5 * step)
            surface = time.process_time() - begin
            simple.Render(view)  # what another lifetime changes is made anew
            some.append((surface, frame(view)))
    return {lifetime: np.median(some[1:], axis=0) for lifetime, some in times.items()}


def look(view, way):
    """Looks into a wood, some metres along the way through it."""
    view.CameraPosition, view.CameraFocalPoint = [200.0 + way, 200.0, 6.0], [300.0 + way, 260.0, 3.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def frames_along(view, step, draw, count=4):
    """Processor times of frames after steps of the camera [s]."""
    times = []
    for k in range(count):
        look(view, step * (k + 1))
        begin = time.process_time()
        draw()
        times.append(time.process_time() - begin)
    return times


def measure_moves(view):
    """Processor times of frames [s] by what moved before them."""
    def still():
        simple.Render(view)
    look(view, 0.0)
    still()
    times = {"rest": frames_along(view, 0.0, still), "turn": [frame(view) for _ in range(4)]}
    for step in (0.5, 2.0, 10.0):
        times[f"{step} m"] = frames_along(view, step, still)
    first, *others = frames_along(view, 0.5, view.SMProxy.InteractiveRender, 20)
    times.update({"drag, first": [first], "drag": others, "after drag": frames_along(view, 10.0, still, 1)})
    return {name: float(np.median(some)) for name, some in times.items()}


def print_moves():
    view = simple.CreateView("RenderView")
    view.ViewSize = [960, 540]
    simple.Show(simple.Forest(), view)
    simple.Render(view)
    shown = simple.GetDisplayProperties(simple.FindSource("Light"), view)
    for shown.Visibility in (0, 1):
        times = measure_moves(view)
        print("with" if shown.Visibility else "without", ", ".join(f"{name} {some:.2f} s" for name, some in times.items()))


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
for one in sys.argv[1:] or ["Forest"]:
    if one == "moves":
        print_moves()
        continue
    if one == "foam":
        seas = measure_foam()
        for what, k in (("surface", 0), ("frame", 1)):
            print(f"{what} without foam {seas[0.0][k]:.3f} s, with {seas[4.0][k]:.3f} s ({seas[4.0][k] / seas[0.0][k]:.2f})")
        continue
    medians = measure(one)
    print(one, ", ".join(f"{name} {some:.2f} s ({some / medians['without']:.2f})" for name, some in medians.items()))
