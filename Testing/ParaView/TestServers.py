# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""TestServer.py with two ranks, and rendered by the client of one and two; instances, and levels that follow the camera."""

import shutil

import quick
import TestFollowCamera
import TestInstances
import TestServer
import TestTextures
from paraview import simple
from server import connected

PORT = 21535
BY_SERVER, BY_CLIENT = 0.0, 1e5  # thresholds [MB]


def check_instances(where):
    view, forest, _ = TestInstances.scene()
    TestInstances.check_forms(view, forest, where)


def check_levels(where):
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 150]
    simple.SetActiveView(view)
    forest = TestFollowCamera.forest_in(view)
    simple.Render(view)
    TestFollowCamera.check_follows(forest, view, where)


for ranks, threshold in ((1, BY_CLIENT), (2, BY_SERVER), (2, BY_CLIENT)):
    if ranks == 1 or shutil.which("mpirun"):
        with connected(PORT, ranks):
            where = f"{ranks} ranks, threshold {threshold} MB"
            TestServer.check(where, threshold)
            check_instances(where)
            view, _, shown, light = TestTextures.scene()
            TestTextures.check_light(view, shown, light, where)
            if ranks == 1:
                check_levels(where)  # of two, each rank has the counts of its own plants
