# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What make_entries.py does inside ParaView's window: the inputs of the entry LITTORAL_ENTRY, or a mistake with it."""

import os
import sys

from paraview import servermanager, simple

def usual_inputs(name):
    """Makes and applies what an entry is usually applied to, shown as a user's view has it: (input, other inputs)."""
    make = {
        "CurrentDrift": lambda: (
            simple.SuspendedParticles(Bounds=[-3, 3, -3, 3, -6, 0], Density=30),
            {"Currents": simple.FlowPrimitive(FlowType="Vortex", Center=[0, 0, -3], Axis=[0, 1, 0], Strength=0.5)}),
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


def say_ready(word="ready"):
    with open(os.environ["LITTORAL_READY"], "w", encoding="utf-8") as file:
        file.write(word + "\n")


def show(proxy):
    """As Apply does."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    controller.ShowInPreferredView(proxy.SMProxy, 0, simple.GetActiveViewOrCreate("RenderView").SMProxy)
    simple.SetActiveSource(proxy)


def connect_when_made(name, others):
    """Connects the other inputs of an entry when that is made."""
    manager = servermanager.ProxyManager()

    def connect(*_):
        made = [proxy for proxy in manager.GetProxiesInGroup("sources").values() if proxy.GetXMLName() == name]
        for proxy in made:
            for property_name, other in others.items():
                if not len(proxy.GetProperty(property_name)):
                    proxy.GetProperty(property_name).SetData(other)

    manager.SMProxyManager.AddObserver("RegisterEvent", connect)


def prepare(name):
    """The inputs of an entry, as a user has them; an entry that asks for two inputs in a dialog is made here, too."""
    first, others = usual_inputs(name)
    for one in others.values():
        one.UpdatePipeline()
    if first:
        show(first)
        simple.ResetCamera(simple.GetActiveViewOrCreate("RenderView"))
        simple.Render()
    if name == "CurrentDrift":  # after half a minute of its film, in which the vortex shows
        simple.Show(others["Currents"])
        simple.GetAnimationScene().AnimationTime = 30.0
        simple.SetActiveSource(first)
    if name == "PlantScatter":
        show(simple.PlantScatter(Sites=first, **others))
        simple.Hide(first)
        simple.Render()
        say_ready("made")
        return
    if others:
        connect_when_made(name, others)
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
    show(proxy)
    say_ready()


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
{"first look": prepare, "mistake": make_mistake}[os.environ["LITTORAL_ROLE"]](os.environ["LITTORAL_ENTRY"])
