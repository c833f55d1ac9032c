# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""A scene on land brings a light into a view that has none, and leaves others alone."""

import quick
from paraview import simple
from TestScenes import SIZE, lights
from window import small_view

#: What is in the view before, and the elevations of the suns in it after.
VIEWS = (("nothing", lambda view: None, [14.0]),
         ("data", lambda view: simple.Show(simple.Sphere(), view), []),
         ("a light", lambda view: simple.Show(simple.LandscapeLight(), view), [35.0]),
         ("a background", lambda view: setattr(view, "BackgroundColorMode", "Gradient"), []))

for what, prepare, suns in VIEWS:
    view = small_view(SIZE)
    prepare(view)
    simple.Show(simple.TwinOfAPlace(WholeExtent=[0, 40, 0, 40, 0, 0]), view)
    shown = [one.SunElevation for one in lights(view)]
    assert shown == suns, f"lights of a view with {what}: {shown}"
    for source in simple.GetSources().values():
        simple.Delete(source)
    assert not lights(view), "a light of what was deleted"
    simple.Delete(view)
