# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The guide's lists to moving kelp, and from particles to a volume, in the window."""

import guide_seaweed
import guide_volumes
from guide import play

play(guide_seaweed, guide_volumes)
