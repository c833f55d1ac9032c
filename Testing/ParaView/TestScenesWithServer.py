# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""A scene in front of a server: the same parts as without one, shown, and a change of a part changes the picture."""

import numpy as np
from paraview import simple

import server
import window

PORT = 11517
#: Parts, and what changes a picture.
SCENES = {"Sea": (["Sea1", "Surface"], ("Sea1", "PeakPeriod", 10.0))}


def picture(view):
    simple.Render(view)
    return window.colors(view)


def check(name):
    parts, (part, prop, value) = SCENES[name]
    view = simple.CreateView("RenderView")
    view.ViewSize = [300, 200]
    simple.SetActiveView(view)
    blank = picture(view)
    simple.Show(getattr(simple, name)(), view)
    names = sorted(key[0] for key in simple.GetSources())
    assert names == parts, f"{name}: consists of {names}"
    first = picture(view)
    covered = (np.abs(first - blank).max(axis=1) > 12).mean()
    colors = np.unique(first, axis=0).shape[0]
    assert covered > 0.3 and colors > 200, f"{name}: the picture shows {covered:.0%} in {colors} colors"
    simple.FindSource(part).SetPropertyWithName(prop, value)
    changed = (np.abs(picture(view) - first).max(axis=1) > 12).mean()
    assert changed > 0.01, f"{name}: {prop} of {part} changes {changed:.2%}"
    print(f"{name}: {colors} colors, {changed:.0%} change with {prop} of {part}")
    simple.ResetSession()


with server.connected(PORT, ranks=1):
    for scene in SCENES:
        check(scene)
