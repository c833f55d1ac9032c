# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Plants by their proxies: of quadrics, scattered on the ground, and in the wind."""

import together

together.run("scatter", "gardner", "wind", "sway")
