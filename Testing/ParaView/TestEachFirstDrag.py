# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The first drags of each scene, and of each entry that shows something in three dimensions."""

import quick
from drags import check
from paraview import simple
import classes
import mistakes

# Heights of the eye [m]
SIDES = {"Forest": (25.0, 1e9), "SwayingForest": (3.0, 1e9), "Sea": (3.0, 1e9), "Underwater": (-5.4, -0.7),
         "TwinOfAPlace": (900.0, 1e9), "SeaState": (2.0, 1e9), "SeaSurface": (2.0, 1e9), "MeasuredSeaState": (2.0, 1e9)}




for cls, entry in classes.all_entries():
    if entry.menu not in ("Sources", "Filters"):
        continue
    if not entry.kind.startswith(("NaturalDisplay", "FollowCamera", "Preset")):
        continue
    given = mistakes.pv.shown_inputs(entry.proxy)
    check(entry.proxy, getattr(simple, entry.proxy)(**given), *SIDES.get(entry.proxy, ()))
