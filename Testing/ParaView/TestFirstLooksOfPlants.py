# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""TestFirstLooks.py for plants and particles."""

import quick
from first_looks import SIZE, check
from mistakes import classes
from paraview import simple
from window import small_view


def in_full(shown):
    """Without a skeleton."""
    assert list(shown.BlockSelectors) == ["/Root/High/Skin", "/Root/High/Leaves"], list(shown.BlockSelectors)


def check_plants():
    """The lowest level is two crossed squares."""
    check("Seaweed", simple.Seaweed(), "Surface", "RGB", "water", 0.02)
    for name in [row.entries[0].proxy for row in classes.ROWS if row.field == "Plants" and row.name.endswith("Source")]:
        plant = getattr(simple, name)()
        check(name, plant, "Full Surface", "RGB", "land", 0.03, display=in_full)
        low = simple.ExtractBlock(Input=plant, Selectors=["/Root/Low"])
        low.UpdatePipeline()
        assert low.GetDataInformation().GetNumberOfCells() == 4, name


def as_spheres(shown):
    """Lit spheres, with radii from their array."""
    assert shown.Representation == "Point Gaussian" and shown.ShaderPreset == "Sphere"
    assert shown.ScaleByArray == 1 and list(shown.SetScaleArray) == ["POINTS", "Radius"]
    assert 1.0 <= shown.GaussianRadius < 50.0, shown.GaussianRadius


def check_particles():
    """Particles keep their look through every filter; a surface on the orbits of the sea is no cloud of particles."""
    particles, sea_state = simple.SuspendedParticles(Density=0.3), simple.SeaState()
    drift = simple.CurrentDrift(Input=particles, Currents=[simple.FlowPrimitive()])
    orbits = simple.ParticleOrbits(Input=particles, SeaState=sea_state)
    for name, source in (("Suspended Particles", particles), ("Current Drift", drift), ("Particle Orbits", orbits)):
        check(name, source, "Point Gaussian", "RGB", "water", 0.01, display=as_spheres)
    view = small_view(SIZE)
    as_spheres(simple.Show(simple.ParticleLevelOfDetail(Input=particles, SeaState=sea_state), view))
    shown = simple.Show(simple.ParticleOrbits(Input=simple.Plane(), SeaState=sea_state), view)
    assert shown.Representation == "Surface", shown.Representation


def check_drift_beside_currents():
    """Points that drift take the place of the points where they start, and the currents stay."""
    view = small_view(SIZE)
    particles = simple.SuspendedParticles(Density=0.1)
    currents = simple.FlowPrimitive(FlowType="Vortex")
    start, arrows = simple.Show(particles, view), simple.Show(currents, view)
    drift = simple.CurrentDrift(Input=particles, Currents=[currents])
    drifting = simple.Show(drift, view)
    simple.Render(view)
    assert (start.Visibility, arrows.Visibility, drifting.Visibility) == (0, 1, 1)
    # Else the window's Apply hides all inputs.
    assert drift.GetHints().FindNestedElementByName("Visibility").GetAttribute("replace_input") == "0"
    start.Visibility = 1
    simple.Show(drift, view)
    assert start.Visibility == 1, "a choice of the user is undone"
    simple.Delete(view)


check_plants()
check_particles()
check_drift_beside_currents()
