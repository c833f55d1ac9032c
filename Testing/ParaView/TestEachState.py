# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""TestStates.py for the other pipelines: a twin, a wood, merged and as instances, particles and kelp in waves."""

import quick
import TestStates
from paraview import simple


def twin():
    """The twin of a terrain, by its fits."""
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 60, 0, 0])
    fits = simple.CovarianceFit(Input=terrain)
    return simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 60, 0, 40, 0, 0], Seed=9)


def instances():
    """A wood that follows the camera, as instances."""
    sites = simple.QuadratPoints(Size=[60.0, 60.0], Quadrats=[8, 8])
    tree = simple.ReevesTree(Preset="Shrub")
    return simple.PlantScatter(Sites=sites, Prototypes=[tree], NearDistance=30.0, FarDistance=120.0,
                               OutputForm="Instances")


def forest():
    """A wood that follows the camera, whole."""
    made = instances()
    made.OutputForm = "Merged"
    return made


def particles():
    """Particles in waves, in levels of detail."""
    sea = simple.SeaState(NumberOfTrains=20)
    levels = simple.ParticleLevelOfDetail(Input=simple.SuspendedParticles(Density=0.2), SeaState=sea)
    return simple.ParticleOrbits(Input=levels, SeaState=sea)


def kelp():
    """Kelp in a sea."""
    sea = simple.SeaState(NumberOfTrains=20, SeaLevel=8.0)
    return simple.SeaweedDeformation(Input=simple.Seaweed(Seed=3), SeaState=sea, StartTime=0.0)


TestStates.check(twin, instances, forest, particles, kelp)
