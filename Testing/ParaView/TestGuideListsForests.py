# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's list from sites and a tree to a forest, in the window."""

import guide_forests
from guide import play

play(guide_forests)
