# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Particles, currents and seaweeds by their proxies."""

import together

together.run("particle_levels", "currents", "seaweed", "seaweed_motion")
