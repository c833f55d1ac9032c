# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client
"""TestMistakes.py in ParaView's own window, with one mistake of each source and filter."""

import os
import runpy
import sys

here = os.path.dirname(os.path.abspath(os.environ["LITTORAL_CLIENT_SCRIPT"]))
sys.path.insert(0, here)
runpy.run_path(os.path.join(here, "TestMistakes.py"))
