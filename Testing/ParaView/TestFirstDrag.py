# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""The first drags of a sea and a tree; TestDragUnderWater.py has one under water, TestEachFirstDrag.py all entries."""

import os

import quick
from drags import check, check_after_state
from paraview import simple

check("Sea", simple.Sea(NumberOfTrains=10), lowest=3.0, steps=3, directions=2, closers=(1.0,), times=3)
tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=200, MainBranches=8, Orders=1)
check("Reeves Tree", tree, steps=3, directions=4)
check_after_state(simple.Sea(NumberOfTrains=10), os.path.abspath("drag.pvsm"))
