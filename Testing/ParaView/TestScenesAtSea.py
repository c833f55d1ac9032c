# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""TestScenes.py for the sea, with its foam."""

import quick
from paraview import simple
from TestScenes import check
from window import apart, picture


def check_foam(_):
    """There is some foam on the sea, but not much, where its light has it."""
    view = simple.GetActiveView()
    view.ViewSize = [300, 200]
    first = picture(view)
    simple.GetRepresentation(simple.FindSource("Light"), view).FoamThreshold = 0.0
    foam = apart(picture(view), first)
    assert 0.001 < foam < 0.1, f"Sea: foam on {foam:.2%}"


if __name__ == "__main__":
    check("Sea", then=check_foam)
