# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""TestTwoRanks.py for the other pipelines and charts."""

import quick
import TestTwoRanks
from paraview import simple
from TestTwoRanks import tree


def forest():
    sites = simple.QuadratPoints(Quadrats=[5, 5], Size=[30.0, 30.0])
    return simple.PlantScatter(Sites=sites, Prototypes=[tree()], NearDistance=10.0, FarDistance=40.0)


def swaying_tree():
    return simple.BeamTreeDeformation(Input=tree(), Wind=simple.WindField(Dimensions=[100, 16, 8]))


def swaying_forest():
    one = tree()
    sites = simple.QuadratPoints(Quadrats=[3, 3], Size=[20.0, 20.0])
    return simple.BeamTreeDeformation(Input=simple.PlantScatter(Sites=sites, Prototypes=[one]), Prototypes=[one],
                                      Wind=simple.WindField(Dimensions=[100, 16, 8]))


def seaweed():
    return simple.Seaweed()


def terrain_levels():
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0])
    return simple.TerrainLevelOfDetail(Input=terrain, UseCulling=0)


def particle_levels():
    sea = simple.SeaState(NumberOfTrains=5)
    particles = simple.SuspendedParticles(Density=0.05)
    levels = simple.ParticleLevelOfDetail(Input=particles, SeaState=sea, UseCulling=0, VisibleDistance=0.0)
    return simple.ParticleOrbits(Input=levels, SeaState=sea)


def fit_chart():
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 60, 0, 0], Seed=4)
    simple.SetActiveSource(terrain)  # ParaView takes the default of an array from the active source
    return simple.CovarianceFit(Input=terrain), 1, "XYChartView"


def pattern_chart():
    return simple.QuadratAnalysis(Input=simple.QuadratPoints(Quadrats=[30, 20])), 1, "XYBarChartView"


def wind_chart():
    return simple.WindStatistics(Input=simple.WindField(Dimensions=[60, 8, 5])), 0, "XYChartView"


TestTwoRanks.TRANSLUCENT += [seaweed, terrain_levels]
TestTwoRanks.check([forest, seaweed, swaying_tree, swaying_forest, terrain_levels, particle_levels],
                   [fit_chart, pattern_chart, wind_chart])
