# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""The first drags of a sea, of what is under water, and of a terrain; TestEachFirstDrag.py has all entries."""

import quick
from drags import check
from paraview import simple

check("Sea", simple.Sea(NumberOfTrains=20), lowest=3.0, steps=4, directions=4)
check("Underwater", simple.Underwater(NumberOfTrains=10, WaterDepth=5.0), lowest=-4.5, highest=-0.7, steps=2, directions=2)
check("Terrain", simple.TurningBandsTerrain(WholeExtent=[0, 64, 0, 64, 0, 0]), steps=4, directions=4)
