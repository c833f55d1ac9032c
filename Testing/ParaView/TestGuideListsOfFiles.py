# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's lists for one's own data, in the window: a sea with drift, an inflow, leaf area."""

import guide_drift
import guide_inflow
import guide_leaf_area
from guide import play

play(guide_drift, guide_inflow, guide_leaf_area)
