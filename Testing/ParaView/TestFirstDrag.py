# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""The first drags of a sea, of what is under water, and a tree; TestEachFirstDrag.py has all entries."""

import quick
from drags import check
from paraview import simple

check("Sea", simple.Sea(NumberOfTrains=20), lowest=3.0, steps=4, directions=4)
check("Underwater", simple.Underwater(NumberOfTrains=10, WaterDepth=5.0), lowest=-4.5, highest=-0.7, steps=2, directions=2)
tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=200, MainBranches=8, Orders=1)
check("Reeves Tree", tree, steps=4, directions=4)
