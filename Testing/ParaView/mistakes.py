# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes with each entry of the plugin's menus, the typical one of an entry first."""

import os
import sys
import tempfile

import quick
from paraview import simple

SMALL_WIND = dict(Dimensions=[100, 16, 8])
UNMOVED, EMPTY = "unmoved", "empty"


class Messages:
    """What is printed meanwhile: VTK, ParaView and its window write to file descriptor 2."""

    def __enter__(self):
        self.file = tempfile.TemporaryFile()
        self.before = os.dup(2)
        os.dup2(self.file.fileno(), 2)
        return self

    def __exit__(self, *_):
        sys.stderr.flush()
        os.dup2(self.before, 2)
        os.close(self.before)
        self.file.seek(0)
        lines = self.file.read().decode(errors="replace").splitlines()
        self.lines = [line for line in lines if any(word in line for word in ("ERR|", "WARN|", "ERROR:", "Warning:"))]


def tree():
    return simple.ReevesTree(NumberOfLeaves=100)


def sites():
    return simple.QuadratPoints(Size=[50.0, 50.0], Quadrats=[5, 5])


def particles():
    return simple.SuspendedParticles(Density=0.1)


def image():
    return simple.Wavelet()


def blocks():
    return simple.GroupDatasets(Input=simple.Sphere())


def inventory(head="x,y,species,dbh"):
    """An opened table of twenty oaks."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write(head + "\n" + "".join(f"{5 * (k % 5)},{6 * (k // 5)},oak,{20 + k}\n" for k in range(20)))
    return simple.CSVReader(FileName=[file.name])


# The proxy, its inputs and properties, what the one message names, and what comes out.
MISTAKES = [
    ("BeamTreeDeformation", lambda: dict(Input=tree()), "There is no wind", UNMOVED),
    ("BeamTreeDeformation", lambda: dict(Input=tree(), Wind=image()), "no point array Velocity", EMPTY),
    ("BeamTreeDeformation", lambda: dict(Input=blocks(), Wind=simple.WindField(**SMALL_WIND)), "High/Skeleton", EMPTY),
    ("BeamTreeDeformation", lambda: dict(Input=simple.PlantScatter(Sites=sites(), Prototypes=[tree()]),
                                         Wind=simple.WindField(**SMALL_WIND), Prototypes=[blocks()]),
     "Skeleton", EMPTY),
    ("BeamTreeDeformation", lambda: dict(Input=tree(), Wind=simple.WindField(**SMALL_WIND), NumberOfModes=0),
     "NumberOfModes", EMPTY),
    ("BeamTreeDeformation", lambda: dict(Input=tree(), Wind=simple.WindField(ReferenceSpeed=-1.0)),
     "ReferenceSpeed", EMPTY),
    ("ParticleOrbits", lambda: dict(Input=particles()), "There is no sea state", UNMOVED),
    ("ParticleOrbits", lambda: dict(Input=particles(), SeaState=simple.QuadratAnalysis(Input=sites())),
     "Amplitude", EMPTY),
    ("ParticleLevelOfDetail", lambda: dict(Input=particles()), "there is no sea state", EMPTY),
    ("ParticleLevelOfDetail", lambda: dict(Input=particles(), SeaState=simple.QuadratAnalysis(Input=sites())),
     "Amplitude", EMPTY),
    ("PlantScatter", lambda: dict(Sites=sites()), "There are no prototypes", EMPTY),
    ("PlantScatter", lambda: dict(Sites=tree()), "The sites are blocks", EMPTY),
    ("PlantScatter", lambda: dict(Sites=tree(), Prototypes=[tree()]), "The sites are blocks", EMPTY),
    ("PlantScatter", lambda: dict(Sites=sites(), Prototypes=[blocks()]), "Prototype 0", EMPTY),
    ("PlantScatter", lambda: dict(Sites=sites(), Prototypes=[tree()], Terrain=image()), "errain", EMPTY),
    ("PlantScatter", lambda: dict(Sites=sites(), Prototypes=[tree()], SlopeLimit=-1.0), "SlopeLimit", EMPTY),
    ("SeaweedDeformation", lambda: dict(Input=simple.Seaweed()), "There is no sea state and no current", UNMOVED),
    ("SeaweedDeformation", lambda: dict(Input=tree(), SeaState=simple.SeaState()), "Width", EMPTY),
    ("SeaweedDeformation", lambda: dict(Input=simple.Seaweed(), Currents=[simple.FlowPrimitive()]), "above the sea", EMPTY),
    ("SeaweedDeformation", lambda: dict(Input=simple.Seaweed(), SeaState=simple.QuadratAnalysis(Input=sites())),
     "Amplitude", EMPTY),
    ("PlantWake", lambda: dict(Input=tree()), "GenerateMotion", EMPTY),
    ("PlantWake", lambda: dict(Input=blocks()), "High/Skeleton", EMPTY),
    ("CurrentDrift", lambda: dict(Input=particles(), Currents=[image()]), "velocities", EMPTY),
    ("CurrentDrift", lambda: dict(Input=particles(), Currents=[simple.FlowPrimitive()], TimeStep=-1.0),
     "TimeStep", EMPTY),
    ("ParticleFog", lambda: dict(Input=particles(), ParticleRadius=-1.0), "ParticleRadius", EMPTY),
    ("CovarianceFit", lambda: dict(Input=image()), "one layer", EMPTY),
    ("Drainage", lambda: dict(Input=image()), "one layer", EMPTY),
    ("Drainage", lambda: dict(Input=simple.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Concavity=-1.0),
     "Concavity", EMPTY),
    ("GroundStatistics", lambda: dict(Input=image()), "one layer", EMPTY),
    ("ConditionalTerrain", lambda: dict(Input=image()), "one layer", EMPTY),
    ("NormalScores", lambda: dict(Input=image(), Inverse=1), "Reference", EMPTY),
    ("TerrainLevelOfDetail", lambda: dict(Input=image()), "one layer", EMPTY),
    ("QuadratAnalysis", lambda: dict(Input=simple.PointSource()), "at least 5", EMPTY),
    ("PointPatternStatistics", lambda: dict(Input=simple.PointSource()), "at least 5", EMPTY),
    ("PointPatternStatistics", lambda: dict(Input=sites(), Function="Mark Correlation"), "MarkArray", EMPTY),
    ("StandInventory", lambda: dict(Inventory=inventory("east,north,species,dbh")), "no columns x and y", EMPTY),
    ("StandInventory", lambda: dict(Inventory=inventory(), DiameterUnit="Metre"), "set DiameterUnit", EMPTY),
    ("SitePreference", lambda: dict(Sites=sites()), "there is no terrain", EMPTY),
    ("SitePreference", lambda: dict(Sites=sites(), Terrain=image()), "one layer", EMPTY),
    ("TurningBandsTerrainFromFits", lambda: dict(Input=simple.SeaState()), "covariance fit", EMPTY),
    ("QuadratPointsFromFits", lambda: dict(Input=simple.SeaState()), "quadrat analysis", EMPTY),
    ("MeasuredSeaState", lambda: dict(Input=simple.QuadratAnalysis(Input=sites())), "Frequency and Density", EMPTY),
    ("WindField", lambda: dict(ReferenceSpeed=-1.0), "ReferenceSpeed", EMPTY),
    ("TurningBandsTerrain", lambda: dict(WholeExtent=[5, 0, 0, 10, 0, 0]), "WholeExtent", EMPTY),
    ("TurningBandsTerrain", lambda: dict(Range=-1.0), "Range", EMPTY),
    ("ReevesTree", lambda: dict(Preset="Custom", Height=-1.0), "Height", EMPTY),
    ("AonoKuniiTree", lambda: dict(Variation=2.0), "Variation", EMPTY),
    ("GardnerPlant", lambda: dict(Preset="Custom", CrownRadius=-1.0), "CrownRadius", EMPTY),
    ("Seaweed", lambda: dict(SegmentsPerBranch=0), "SegmentsPerBranch", EMPTY),
    ("SeaState", lambda: dict(WindSpeed=-1.0), "WindSpeed", EMPTY),
    ("SuspendedParticles", lambda: dict(SizeSpread=-1.0), "SizeSpread", EMPTY),
    ("QuadratPoints", lambda: dict(MeanPerQuadrat=-1.0), "Mean", EMPTY),
    ("PointProcess", lambda: dict(Intensity=-1.0), "Intensity", EMPTY),
    ("PointProcessOnImage", lambda: dict(Input=image()), "one layer", EMPTY),
    ("PatternVerdict", lambda: dict(Input=simple.PointSource()), "at least 5", EMPTY),
    ("ProcessPointsFromVerdict", lambda: dict(Input=simple.SeaState()), "pattern verdict", EMPTY),
    ("FlowPrimitive", lambda: dict(FlowType="Vortex", CoreRadius=-1.0), "CoreRadius", EMPTY),
    ("FlowArrows", lambda: dict(Input=simple.Sphere()), "FlowType", EMPTY),
    ("SeaSurface", lambda: dict(Input=simple.QuadratAnalysis(Input=sites())), "Amplitude", EMPTY),
    ("SeaSurface", lambda: dict(Input=simple.SeaState(), Spacing=-1.0), "Spacing", EMPTY),
    ("SeaStatistics", lambda: dict(Input=simple.QuadratAnalysis(Input=sites())), "Amplitude", EMPTY),
    ("WindStatistics", lambda: dict(Input=image()), "Velocity", EMPTY),
    ("ImageSections", lambda: dict(Input=image(), CrossSections=-1), "CrossSections", EMPTY),
]
