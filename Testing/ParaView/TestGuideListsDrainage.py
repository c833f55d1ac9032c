# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's list from a raster of heights to its twin with valleys, in the window."""

import guide_drainage
from guide import play

play(guide_drainage)
