# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client tier=all
"""Tests that run without a window, in ParaView's own: charts, levels that follow the camera, one mistake of each entry."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ["LITTORAL_CLIENT_SCRIPT"])))
import together  # noqa: E402

together.run("TestCharts", "TestFollowCamera", "TestMistakes")
