# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""One window of ParaView, played with the mouse: legends, a mistake put right, undone and redone, a list of the guide.
The macros are in the menu without import."""

import guide
import guide_patterns
import TestLegends
import TestMistakeInWindow
import TestUndo
from player import Session

session = Session(TestLegends.__file__)
TestLegends.steps(session)
TestLegends.macros(session)
undo = TestUndo.Undo(TestUndo.__file__)
TestUndo.steps(undo)
session.join(undo)
walk = guide.walk(guide_patterns)
session.join(walk)
session.lap()
session.play(TestMistakeInWindow.MESSAGE)
TestUndo.check_steps()
guide_patterns.check()
