# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the Forest entry in ParaView: while the camera is dragged, and at rest.

    build/bin/littoral-env xvfb-run -a pvpython Testing/Benchmarks/bench_dragging.py

For each place, one line: seconds of an interactive picture (median of 12 steps of the camera), of the same picture without
an update of the levels, of the still picture that follows, memory of what is shown [MB], and its polygons.
"""

import statistics
import time

from paraview import simple

SIZE = [960, 600]  # of the view [pixels]
STEP = 0.5  # of the camera between two pictures [m]

#: Camera and what it looks at [m].
PLACES = {
    "inside": ((200.0, 200.0, 6.0), (300.0, 260.0, 3.0)),
    "clearing": ((120.0, 80.0, 12.0), (180.0, 200.0, 6.0)),
    "edge": ((200.0, -30.0, 8.0), (200.0, 200.0, 0.0)),
    "hill": ((200.0, -100.0, 150.0), (200.0, 200.0, 0.0)),
    "above": ((200.0, 100.0, 400.0), (200.0, 200.0, 0.0)),
}


def seconds(render):
    begin = time.perf_counter()
    render()
    return time.perf_counter() - begin


def shown(trees, name):
    fields = trees.GetDataInformation(0).DataInformation.GetFieldDataInformation()
    return fields.GetArrayInformation(name).GetComponentRange(0)[0]


def look(view, place, step=0):
    eye, target = PLACES[place]
    view.CameraPosition = [eye[0] + STEP * step, *eye[1:]]
    view.CameraFocalPoint = [target[0] + STEP * step, *target[1:]]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def main():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    forest = simple.Forest()
    simple.Show(forest, view)
    simple.Render(view)
    trees, ground = simple.FindSource("Trees"), simple.FindSource("Ground")
    print("place      drag [s]  fixed [s]  still [s]  memory [MB]  polygons")
    for place in PLACES:
        look(view, place)
        simple.Render(view)
        drags = []
        for step in range(1, 13):
            look(view, place, step)
            drags.append(seconds(view.SMProxy.InteractiveRender))
        fixed = statistics.median(seconds(view.SMProxy.InteractiveRender) for _ in range(6))
        still = seconds(lambda: simple.Render(view))
        memory = sum(part.GetDataInformation(0).GetMemorySize() for part in (trees, ground)) / 1024.0
        print(f"{place:10} {statistics.median(drags):8.2f}  {fixed:9.2f}  {still:9.2f}  {memory:11.0f}  "
              f"{shown(trees, 'PolygonsShown'):8.0f}", flush=True)


main()
