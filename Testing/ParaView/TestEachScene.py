# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""What TestScenes.py and its like leave out: the states and defaults of all scenes."""

import quick
import states
from TestScenes import SCENES, check, check_again, check_defaults


def check_states(name):
    """In a view of its own, and not shown anew in another one."""
    states.check((300, 200), 0.0, name)
    check_again(name)


for scene in SCENES:
    check(scene, then=check_states)
check_defaults("Sea", "PeakPeriod", 10.0)
check_defaults("TwinOfAPlace", "Spacing", [50.0, 50.0, 1.0])
