# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""TestScenes.py for the sea, with its foam, and the length of its films beside others and after them."""

import quick
from paraview import simple
from TestScenes import check, new_film
from window import apart, picture, small_view


def check_foam(_):
    """There is some foam on the sea, but not much, where its light has it."""
    view = simple.GetActiveView()
    view.ViewSize = [300, 200]
    first = picture(view)
    simple.GetRepresentation(simple.FindSource("Light"), view).FoamThreshold = 0.0
    foam = apart(picture(view), first)
    assert 0.001 < foam < 0.1, f"Sea: foam on {foam:.2%}"


def check_rate(rate, frames=None, beside=None):
    """A film of a session in which the sea is shown has this rate."""
    if frames:
        simple.GetAnimationScene().NumberOfFrames = frames
    if beside:
        simple.UpdatePipeline(proxy=beside)
    simple.Show(simple.Sea(), small_view([30, 20]))
    found = new_film().FrameRate
    assert found == rate, f"Sea: a film of {found} frames a second, not {rate}"


def check_rates():
    """A film lasts 60 s with a chosen number of frames, and as long as a wind that has time steps."""
    check_rate(10, frames=601)
    check_rate(2, beside=simple.WindField(Dimensions=[20, 4, 4], TimeStep=0.5))
    simple.ResetSession()


if __name__ == "__main__":
    check_rates()
    check("Sea", then=check_foam)
