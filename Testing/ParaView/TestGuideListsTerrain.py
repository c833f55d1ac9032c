# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's lists from a raster of heights to a terrain like it, and from a survey to a field, in the window."""

import guide_first_steps
import guide_kriging
from guide import play

play(guide_first_steps, guide_kriging)
