# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client
"""Scripts in ParaView's own window; TestInWindow has others there."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import together  # noqa: E402

together.run_all("TestChartsInWindow", "TestWavesInFilm")
