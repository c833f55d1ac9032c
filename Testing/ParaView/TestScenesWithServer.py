# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""A scene in front of servers of one and two ranks: the same parts as without one, shown in the same picture, and a
change of a part changes the picture in the same way."""

import numpy as np
import quick
from paraview import simple

import server
import window

PORT = 11517
#: Parts, and what changes a picture.
SCENES = {
    "Sea": (["Sea1", "Surface"], ("Sea1", "PeakPeriod", 10.0)),
    "Forest": (["Birch", "Forest1", "Ground", "Hills", "Oak", "Pine", "Shrub", "Sites", "Trees", "Valleys"],
               ("Hills", "StandardDeviation", 30.0)),
}


def picture(view):
    simple.Render(view)
    return window.colors(view)


def difference(first, second):
    """Part of the pixels that differ."""
    return (np.abs(first - second).max(axis=1) > 12).mean()


def pictures(name):
    """A scene before and after a change, in a view that was drawn while it was empty."""
    parts, (part, prop, value) = SCENES[name]
    view = simple.CreateView("RenderView")
    view.ViewSize = [300, 200]
    simple.SetActiveView(view)
    blank = picture(view)
    simple.Show(getattr(simple, name)(), view)
    names = sorted(key[0] for key in simple.GetSources())
    assert names == parts, f"{name}: consists of {names}"
    first = picture(view)
    covered = difference(first, blank)
    colors = np.unique(first, axis=0).shape[0]
    assert covered > 0.3 and colors > 200, f"{name}: the picture shows {covered:.0%} in {colors} colors"
    simple.FindSource(part).SetPropertyWithName(prop, value)
    second = picture(view)
    changed = difference(second, first)
    assert changed > 0.01, f"{name}: {prop} of {part} changes {changed:.2%}"
    print(f"{name}: {colors} colors, {changed:.0%} change with {prop} of {part}", flush=True)
    simple.ResetSession()
    return first, second


def check(ranks):
    for name, alone in ALONE.items():
        for before, after, when in zip(alone, pictures(name), ("at first", "after a change")):
            other = difference(before, after)
            print(f"{name}: {other:.2%} of the picture is another {when} with {ranks} ranks", flush=True)
            assert other < 0.005, f"{name}: {other:.2%} of the picture is another {when} with {ranks} ranks"


ALONE = {name: pictures(name) for name in SCENES}
for number in (1, 2):
    with server.connected(PORT + number, ranks=number):
        check(number)
