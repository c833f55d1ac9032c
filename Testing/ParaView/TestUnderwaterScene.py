# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""TestScenes.py for Underwater, and its first look: wide, and up to where Snell's window is."""

import math

import quick
from paraview import simple
from TestScenes import check
from window import picture


def check_look(_):
    """The upper edge of the picture is beyond the rim of the window, at 90 degrees less asin(1 / 1.333), and brighter than
    rows below it, of water and plants."""
    view = simple.GetActiveView()
    eye, target = view.CameraPosition, view.CameraFocalPoint
    pitch = math.degrees(math.atan2(target[2] - eye[2], math.dist(eye[:2], target[:2])))
    rim = 90.0 - math.degrees(math.asin(1.0 / 1.333))
    assert pitch + 0.5 * view.CameraViewAngle > rim, f"Underwater: looks up to {pitch + 0.5 * view.CameraViewAngle} degrees"
    lit = picture(view)
    rows, columns = lit.shape[:2]
    top = lit[-rows // 20:, columns // 3:-columns // 3].mean()
    water = lit[rows // 2:2 * rows // 3].mean()
    assert top > 1.3 * water, f"Underwater: Snell's window has {top}, water {water}"


check("Underwater", change=False, then=check_look)
