# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,3 tier=all
"""What TestRanks, TestTables and TestVolumes compare on one and two ranks, on one and three."""

import together

together.run("TestRanks", "TestTables", "TestVolumes")
