# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""TestFindData.py, TestFilteredSurfaces.py and TestRasters.py."""

import together

together.run("TestFindData", "TestFilteredSurfaces", "TestRasters")
