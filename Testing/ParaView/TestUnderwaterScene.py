# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""TestScenes.py for Underwater."""

import quick
from TestScenes import check

check("Underwater", change=False)
