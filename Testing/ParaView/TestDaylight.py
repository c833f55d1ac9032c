# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
# run-with: pvpython tier=all args=each
"""The sky and the sun of a first look: never over a user's choice, never twice, not while a state is loaded; and what a
state file keeps of first looks. With the argument `each`, all choices of a user."""

import sys

import numpy as np
import quick
from paraview import simple

CHOICES = {
    "a background": {"UseColorPaletteForBackground": 0, "Background": [0.2, 0.1, 0.3]},
    "no light kit": {"UseLight": 0},
    "a bright light kit": {"KeyLightIntensity": 1.0},
    "a light from below": {"KeyLightElevation": -60.0},
}


def new_view():
    """A view as ParaView makes it."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [100, 80]
    simple.SetActiveView(view)
    return view


def lights_of(view):
    """All that daylight sets."""
    names = ("UseColorPaletteForBackground", "BackgroundColorMode", "Background", "Background2", "UseLight",
             "KeyLightIntensity", "KeyLightElevation")
    values = [getattr(view, name) for name in names]
    return [list(value) if hasattr(value, "__len__") and not isinstance(value, str) else value for value in values] + [
        len(view.AdditionalLights)]


tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)
for what in CHOICES if "each" in sys.argv else ("a background", "a light from below"):
    choice, view = CHOICES[what], new_view()
    for name, value in choice.items():
        setattr(view, name, value)
    before = lights_of(view)
    simple.Show(tree, view)
    assert lights_of(view) == before, f"{what} was changed: {before} to {lights_of(view)}"
view = new_view()
simple.AddLight(view)
before = lights_of(view)
simple.Show(tree, view)
assert lights_of(view) == before, "a view with a light was changed"

# Something else is there already.
view = new_view()
simple.Show(simple.Wavelet(), view)
before = lights_of(view)
simple.Show(tree, view)
assert lights_of(view) == before, "a view of something else was changed"

# Once, and never again: the user goes back to ParaView's own.
view = new_view()
bare = lights_of(view)
simple.Show(tree, view)
simple.Render(view)
assert lights_of(view) != bare
simple.HideAll(view)
for name in ("UseColorPaletteForBackground", "BackgroundColorMode", "Background", "Background2", "KeyLightIntensity"):
    view.GetProperty(name).SMProperty.ResetToDefault()
view.AdditionalLights = []
view.UpdateVTKObjects()
undone = lights_of(view)
simple.Show(simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1), view)
assert lights_of(view) == undone, "lit twice"

# State: what a user has changed comes back, and what not, too.
for view in simple.GetRenderViews():
    simple.Delete(view)
view = new_view()
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 64, 0, 64, 0, 0])
relief = simple.Show(terrain, view)
simple.Render(view)
other = new_view()
fog = simple.Show(simple.ParticleFog(Input=simple.SuspendedParticles(Density=0.1), Dimensions=[8, 8, 8]), other)
wanted = lights_of(view)
sun = list(view.AdditionalLights[0].Position)
unit, opacities = fog.ScalarOpacityUnitDistance, list(fog.ScalarOpacityFunction.Points)
third = new_view()
simple.Show(terrain, third).Representation = "Slice"
third.Background2 = [0.9, 0.1, 0.1]
changed = lights_of(third)
camera = list(view.CameraPosition)
simple.SaveState("looks.pvsm")
simple.ResetSession()
simple.LoadState("looks.pvsm")
views = simple.GetRenderViews()
reliefs = [v for v in views if lights_of(v) == wanted and np.allclose(v.CameraPosition, camera)]
assert len(reliefs) == 1, [lights_of(v) for v in views]
assert list(reliefs[0].AdditionalLights[0].Position) == sun
assert any(lights_of(v) == changed for v in views), "a state was lit anew"
shown = simple.GetRepresentation(simple.FindSource("TurningBandsTerrain1"), reliefs[0])
assert shown.Representation == "Relief" and list(shown.ColorArrayName) == ["POINTS", "RGB"] and shown.MapScalars == 0
fogs = [simple.GetRepresentation(simple.FindSource("ParticleFog1"), v) for v in views
        if v.AdditionalLights and any(r.GetProperty("ScalarOpacityUnitDistance") and
                                      abs(r.ScalarOpacityUnitDistance - unit) < 1e-12 for r in v.Representations)]
assert fogs and list(fogs[0].ScalarOpacityFunction.Points) == opacities, "another fog"
simple.ResetSession()
