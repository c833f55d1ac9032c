# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client tier=all
"""TestChangesInFilm.py for the other pipelines."""

from TestChangesInFilm import check, check_reset

for name in ("Forest", "Swaying Forest", "Sea", "Orbits"):
    check(name)
check_reset("Orbits")
