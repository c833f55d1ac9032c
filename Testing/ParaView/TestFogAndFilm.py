# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""TestFog.py and TestFilm.py."""

import together

together.run("TestFog", "TestFilm")
