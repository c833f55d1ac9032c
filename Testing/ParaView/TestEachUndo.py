# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""TestUndo.py for a source, a preset, a deletion, and a scene: the parts that Apply adds, then the scene itself."""

from TestUndo import Undo

session = Undo(__file__)
at = session.record("empty")
session.source("Seaweed")
session.apply()
at = session.there_and_back("plant", at, 2, with_picture=True)
session.select(0)
session.choose("Preset", "Eelgrass")
session.apply()
at = session.there_and_back("preset", at, 1, with_picture=True)
session.source("SeaState")
session.apply()
with_sea = session.record("sea")
session.delete()
session.there_and_back("deletion", with_sea, 1)
session.source("Forest")
before = session.record("unapplied")
session.apply()
session.there_and_back("parts", before, 1, with_picture=True)
session.play()
session.check()
