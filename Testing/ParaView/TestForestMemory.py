# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The Forest entry stays below 200 MB wherever the camera is, textures included."""

import math

import quick
from paraview import simple

LIMIT = 200.0  # [MB]

view = simple.CreateView("RenderView")
view.ViewSize = [160, 100]
simple.Show(simple.Forest(), view)
trees = simple.FindSource("Trees")
simple.Render(view)
largest = 0.0
for k in range(40):
    # Places and headings that fill the square evenly.
    x, y, turn = (400.0 * math.modf(k * share)[0] for share in (0.7548777, 0.5698403, 0.4142136))
    heading = 2.0 * math.pi * turn / 400.0
    view.CameraPosition = [x, y, 4.0 + (k % 4) * 12.0]
    view.CameraFocalPoint = [x + 50.0 * math.cos(heading), y + 50.0 * math.sin(heading), 4.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 90.0 if k % 2 else 30.0
    simple.Render(view)
    largest = max(largest, trees.GetDataInformation(0).GetMemorySize() / 1024.0)
assert 5.0 < largest < LIMIT, f"up to {largest:.0f} MB"
print(f"up to {largest:.0f} MB")
