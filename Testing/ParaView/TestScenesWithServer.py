# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""Scenes before servers of one and two ranks: the same parts as without one, shown in the same picture, and a change of a
part changes the picture in the same way. TestServer has one of them."""

import numpy as np
import quick
from paraview import simple

import server
from window import apart, picture, small_view

PORT = 11517
#: Parts, and what changes a picture.
SCENES = {
    "Sea": (["Light", "Sea1", "Surface"], ("Sea1", "PeakPeriod", 10.0)),
    "Forest": (["Birch", "Brooks", "Forest1", "Ground", "Hills", "Light", "Oak", "Pine", "Shrub", "Sites", "Trees", "Valleys"],
               ("Hills", "StandardDeviation", 30.0)),
}


def pictures(name):
    """A scene before and after a change, in a view that was drawn while it was empty."""
    parts, (part, prop, value) = SCENES[name]
    view = small_view([150, 100])
    blank = picture(view)
    simple.Show(getattr(simple, name)(), view)
    names = sorted(key[0] for key in simple.GetSources())
    assert names == parts, f"{name}: consists of {names}"
    first = picture(view)
    covered = apart(first, blank)
    colors = np.unique(first.reshape(-1, 3), axis=0).shape[0]
    assert covered > 0.3 and colors > 200, f"{name}: the picture shows {covered:.0%} in {colors} colors"
    simple.FindSource(part).SetPropertyWithName(prop, value)
    second = picture(view)
    changed = apart(second, first)
    assert changed > 0.01, f"{name}: {prop} of {part} changes {changed:.2%}"
    print(f"{name}: {colors} colors, {changed:.0%} change with {prop} of {part}", flush=True)
    simple.ResetSession()
    return first, second


def compare(name, where, alone):
    """The pictures before a server are those of the client alone."""
    for before, after, when in zip(alone, pictures(name), ("at first", "after a change")):
        other = apart(before, after)
        print(f"{name}: {other:.2%} of the picture is another {when}, {where}", flush=True)
        assert other < 0.005, f"{name}: {other:.2%} of the picture is another {when}, {where}"


def main():
    alone = {name: pictures(name) for name in SCENES}
    for ranks in (1, 2):
        with server.connected(PORT + ranks, ranks):
            for name in SCENES:
                compare(name, f"{ranks} ranks", alone[name])


if __name__ == "__main__":
    main()
