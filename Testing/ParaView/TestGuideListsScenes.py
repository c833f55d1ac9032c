# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's lists of the macros, in the window."""

import guide_stands
import guide_twin_from_raster
from guide import play

play(guide_stands, guide_twin_from_raster)
