# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""The guide's list from a measured pattern of points to one like it, in the window."""

import guide_patterns
from guide import play

play(guide_patterns)
