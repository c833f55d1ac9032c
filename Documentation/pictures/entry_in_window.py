# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What make_entries.py does inside ParaView's window: the inputs of the entry LITTORAL_ENTRY, or a mistake with it."""

import os
import sys

from paraview import servermanager, simple

def usual_inputs(name):
    """Makes and applies what an entry is usually applied to, shown as a user's view has it: (input, other inputs)."""
    make = {
        "CurrentDrift": lambda: (simple.SuspendedParticles(), {"Currents": simple.FlowPrimitive(FlowType="Vortex")}),
        "FlowArrows": lambda: (simple.FlowPrimitive(FlowType="Vortex"), {}),
        "ParticleOrbits": lambda: (simple.SuspendedParticles(), {"SeaState": simple.SeaState()}),
        "ParticleLevelOfDetail": lambda: (simple.SuspendedParticles(), {"SeaState": simple.SeaState()}),
        "ParticleFog": lambda: (simple.SuspendedParticles(), {}),
        "QuadratAnalysis": lambda: (simple.QuadratPoints(), {}),
        "QuadratPointsFromFits": lambda: (simple.QuadratAnalysis(Input=simple.QuadratPoints()), {}),
        "PlantScatter": lambda: (simple.QuadratPoints(Size=[200, 200]), {"Prototypes": simple.ReevesTree()}),
        "MeasuredSeaState": lambda: (simple.SeaStatistics(Input=simple.SeaState()), {}),
        "SeaStatistics": lambda: (simple.SeaState(), {}),
        "SeaSurface": lambda: (simple.SeaState(), {}),
        "SeaweedDeformation": lambda: (simple.Seaweed(),
                                       {"SeaState": simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6)}),
        "PlantWake": lambda: (simple.SeaweedDeformation(
            Input=simple.Seaweed(), SeaState=simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6),
            GenerateMotion=1), {}),
        "BeamTreeDeformation": lambda: (simple.ReevesTree(), {"Wind": simple.WindField()}),
        "CovarianceFit": lambda: (simple.TurningBandsTerrain(), {}),
        "TurningBandsTerrainFromFits": lambda: (simple.CovarianceFit(Input=simple.TurningBandsTerrain()), {}),
        "TerrainLevelOfDetail": lambda: (simple.TurningBandsTerrain(), {}),
        "WindStatistics": lambda: (simple.WindField(), {}),
        "ImageSections": lambda: (simple.WindField(), {}),
    }
    return make[name]() if name in make else (None, {})


def say_ready():
    with open(os.environ["LITTORAL_READY"], "w", encoding="utf-8") as file:
        file.write("ready\n")


def prepare(name):
    """The inputs of an entry; the other inputs get connected when the entry is made."""
    first, others = usual_inputs(name)
    for one in others.values():
        one.UpdatePipeline()
    if first:
        simple.Show(first)
        simple.ResetCamera()
        simple.Render()
        simple.SetActiveSource(first)
    manager = servermanager.ProxyManager()

    def connect(*_):
        made = [proxy for (label, _), proxy in manager.GetProxiesInGroup("sources").items()
                if proxy.GetXMLName() == name]
        for proxy in made:
            for property_name, other in others.items():
                if not len(proxy.GetProperty(property_name)):
                    proxy.GetProperty(property_name).SetData(other)

    if others:
        manager.SMProxyManager.AddObserver("RegisterEvent", connect)
    say_ready()


def make_mistake(name):
    """The first mistake with an entry that TestMistakes.py lists, shown as the window does it."""
    sys.path.insert(0, os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Testing", "ParaView"))
    from mistakes import MISTAKES

    given = {"Forest": {"TreesPerQuadrat": -1.0}, "SwayingForest": {"WindSpeed": -1.0},
             "Sea": {"SignificantWaveHeight": -1.0}, "Underwater": {"WindSpeed": -1.0},
             "TwinOfAPlace": {"Range": -1.0}}
    arguments = given.get(name) or next(mistake[1] for mistake in MISTAKES if mistake[0] == name)()
    proxy = getattr(simple, name)(**arguments)
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    controller.ShowInPreferredView(proxy.SMProxy, 0, simple.GetActiveViewOrCreate("RenderView").SMProxy)
    simple.SetActiveSource(proxy)
    say_ready()


{"first look": prepare, "mistake": make_mistake}[os.environ["LITTORAL_ROLE"]](os.environ["LITTORAL_ENTRY"])
