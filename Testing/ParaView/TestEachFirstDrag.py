# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""The first drags of each scene, and of each entry that shows something in three dimensions."""

import quick
from drags import check
from paraview import simple
import mistakes
from mistakes import classes

# Heights of the eye [m]
SIDES = {"Forest": (-5.4, 1e9), "SwayingForest": (4.4, 1e9), "Sea": (3.0, 1e9), "Underwater": (-5.4, -0.7),
         "TwinOfAPlace": (900.0, 1e9), "SeaState": (2.0, 1e9), "SeaSurface": (2.0, 1e9), "MeasuredSeaState": (2.0, 1e9)}
# What is solid, and a scene, keeps half of what it covers; what is flat, as a sea alone, can be seen from its edge.
SCENES = {"Forest", "SwayingForest", "Sea", "Underwater", "TwinOfAPlace"}
SOLID = {"AonoKuniiTree", "GardnerPlant", "ReevesTree", "BeamTreeDeformation", "Seaweed", "SuspendedParticles", "ParticleOrbits",
         "CurrentDrift", "ParticleLevelOfDetail", "ParticleFog", *SCENES}

for _, entry in classes.all_entries():
    if entry.menu in ("Sources", "Filters") and entry.kind.startswith(("NaturalDisplay", "FollowCamera", "Preset")):
        given = mistakes.pv.shown_inputs(entry.proxy)
        lowest, highest = SIDES.get(entry.proxy, (-1e9, 1e9))
        check(entry.proxy, getattr(simple, entry.proxy)(**given), lowest=lowest, highest=highest,
              least=0.5 if entry.proxy in SOLID else 0.1)
