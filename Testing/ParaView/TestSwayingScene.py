# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""TestScenes.py for a forest in the wind; defaults come back."""

from TestScenes import check, check_defaults

check("SwayingForest")
check_defaults("SwayingForest", "Dimensions", [200, 16, 8])
