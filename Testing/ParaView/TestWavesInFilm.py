# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""TestChangesInFilm.py for waves, in the window."""

from TestChangesInFilm import check, check_reset

check("Waves")
check_reset("Waves")
