# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: client
"""The proxies in ParaView's own window: created, shown, saved to a state file, and loaded again."""

import os

import quick
from paraview import simple

terrain = simple.TurningBandsTerrain(registrationName="Hills", Seed=5, Model="Bessel 1", Range=80.0)
view = simple.GetActiveViewOrCreate("RenderView")
shown = simple.Show(terrain, view)
assert shown.Representation == "Relief", shown.Representation
fit = simple.CovarianceFit(registrationName="Fits", Input=terrain)
twin = simple.TurningBandsTerrainFromFits(registrationName="Twin", Input=fit, Seed=6)
simple.Show(simple.WarpByScalar(Input=twin), view)
simple.Render(view)
before = terrain.GetDataInformation().GetPointDataInformation().GetArrayInformation("Elevation")
wanted = before.GetComponentRange(0)

state = os.path.abspath("terrain.pvsm")
simple.SaveState(state)
simple.ResetSession()
assert not simple.GetSources()
simple.LoadState(state)
terrain = simple.FindSource("Hills")
assert terrain.Seed == 5 and terrain.Model == "Bessel 1" and terrain.Range == 80.0
assert simple.FindSource("Twin").Seed == 6
terrain.UpdatePipeline()
simple.FindSource("Twin").UpdatePipeline()
after = terrain.GetDataInformation().GetPointDataInformation().GetArrayInformation("Elevation")
assert after.GetComponentRange(0) == wanted, "the state gives another terrain"
simple.Render()
