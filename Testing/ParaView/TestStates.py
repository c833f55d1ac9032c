# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""States as .pvsm and as .py bring back a tree in the wind as it was at its time.

TestEachState has other pipelines, each in a view of its own; TestStatesInWindow the menus and a trace.
"""

import numpy as np
import quick
import states
from paraview import simple
from window import small_view

SIZE, TIME = [120, 80], 2.5  # [s]


def tree():
    """A tree in the wind."""
    wind = simple.WindField(Dimensions=[100, 16, 8], ReferenceSpeed=14.0)
    return simple.BeamTreeDeformation(Input=simple.ReevesTree(Preset="Shrub"), Wind=wind)


def show(pipeline):
    """A pipeline in a view of its own, from a place that is no default."""
    view = small_view(SIZE)
    output = pipeline()
    simple.UpdatePipeline(proxy=output)
    simple.Show(output, view)
    simple.ResetCamera(view)
    simple.Render(view)
    towards = np.subtract(view.CameraPosition, view.CameraFocalPoint)
    view.CameraPosition = list(np.add(view.CameraFocalPoint, 0.8 * towards))


def check(*pipelines):
    """A session of several pipelines at a time; none of their pictures is empty."""
    for pipeline in pipelines:
        show(pipeline)
    simple.GetAnimationScene().AnimationTime = TIME
    for pipeline, seen in zip(pipelines, states.snapshot(SIZE, TIME)["pictures"]):
        drawn = (np.abs(seen - np.median(seen, axis=(0, 1))).max(axis=2) > 12).mean()
        assert drawn > 0.01, f"{pipeline.__name__}: nothing is shown"
    states.check(SIZE, TIME, ", ".join(pipeline.__name__ for pipeline in pipelines))


if __name__ == "__main__":
    check(tree)
