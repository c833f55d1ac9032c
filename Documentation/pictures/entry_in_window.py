# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What make_entries.py does inside ParaView's window: the inputs of the entry LITTORAL_ENTRY, or a mistake with it."""

import math
import os
import sys
import tempfile

from paraview import servermanager, simple

def measured_spectrum():
    """A table as of a buoy, S = 1e-4 f^-5 exp(-(0.1 / f)^4) [m^2 / Hz]."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write("Frequency,Density\n")
        for k in range(5, 60):
            f = 0.01 * k
            file.write(f"{f:.2f},{1e-4 * f ** -5 * math.exp(-((0.1 / f) ** 4)):.6g}\n")
    return simple.CSVReader(FileName=[file.name])


def inventory():
    """A table of 400 oaks, maples and pines."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
        file.write("x,y,species,dbh\n")
        for k in range(400):
            x, y = 5.0 * (k % 20) + 2.0 * math.sin(9.1 * k), 5.0 * (k // 20) + 2.0 * math.cos(7.7 * k)
            file.write(f"{x:.1f},{y:.1f},{('oak', 'sugar maple', 'loblolly pine')[k % 3]},{25 + 15 * math.sin(k):.1f}\n")
    return simple.CSVReader(FileName=[file.name])


def usual_inputs(name):
    """Makes and applies what an entry is usually applied to, shown as a user's view has it: (input, other inputs)."""
    make = {
        "CurrentDrift": lambda: (
            simple.SuspendedParticles(Bounds=[-4, 4, -2, 2, -5, 0], Density=30),
            {"Currents": simple.FlowPrimitive(FlowType="Vortex", Center=[0, 0, -2.5], Axis=[0, 1, 0], Strength=0.5)}),
        "FlowArrows": lambda: (simple.FlowPrimitive(FlowType="Vortex"), {}),
        "ParticleOrbits": lambda: (simple.SuspendedParticles(), {"SeaState": simple.SeaState()}),
        "ParticleLevelOfDetail": lambda: (simple.SuspendedParticles(), {"SeaState": simple.SeaState()}),
        "ParticleFog": lambda: (simple.SuspendedParticles(), {}),
        "QuadratAnalysis": lambda: (simple.QuadratPoints(), {}),
        "PointPatternStatistics": lambda: (simple.QuadratPoints(), {}),
        "QuadratPointsFromFits": lambda: (simple.QuadratAnalysis(Input=simple.QuadratPoints()), {}),
        "StandInventory": lambda: (inventory(), {}),
        "SitePreference": lambda: (simple.QuadratPoints(), {"Terrain": simple.TurningBandsTerrain()}),
        "PatternVerdict": lambda: (simple.PointProcess(Size=[150, 150]), {}),
        "PointProcessOnImage": lambda: (
            simple.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0], Spacing=[5, 5, 1], Mean=100.0), {}),
        "ProcessPointsFromVerdict": lambda: (simple.PatternVerdict(Input=simple.PointProcess(Size=[150, 150])), {}),
        "PlantScatter": lambda: (simple.QuadratPoints(Size=[200, 200]), {"Prototypes": simple.ReevesTree()}),
        "MeasuredSeaState": lambda: (measured_spectrum(), {}),
        "SeaStatistics": lambda: (simple.SeaState(), {}),
        "SeaSurface": lambda: (simple.SeaState(), {}),
        "SeaweedDeformation": lambda: (simple.Seaweed(),
                                       {"SeaState": simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6)}),
        "PlantWake": lambda: (simple.SeaweedDeformation(
            Input=simple.Seaweed(), SeaState=simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6),
            GenerateMotion=1), {}),
        "BeamTreeDeformation": lambda: (simple.ReevesTree(), {"Wind": simple.WindField()}),
        "CovarianceFit": lambda: (simple.TurningBandsTerrain(), {}),
        "Drainage": lambda: (simple.TurningBandsTerrain(), {}),
        "GroundStatistics": lambda: (simple.TurningBandsTerrain(), {}),
        "TurningBandsTerrainFromFits": lambda: (simple.CovarianceFit(Input=simple.TurningBandsTerrain()), {}),
        "ConditionalTerrain": lambda: (simple.MaskPoints(
            Input=simple.TurningBandsTerrain(Model="Bessel 1", Range=120, StandardDeviation=45), OnRatio=400,
            RandomSampling=1, RandomSamplingMode="Spatially Stratified Random Sampling", MaximumNumberofPoints=400,
            GenerateVertices=1, SingleVertexPerCell=1), {}),
        "NormalScores": lambda: (simple.TurningBandsTerrain(), {}),
        "TerrainLevelOfDetail": lambda: (simple.TurningBandsTerrain(), {}),
        "WindStatistics": lambda: (simple.WindField(), {}),
        "ImageSections": lambda: (simple.WindField(), {}),
    }
    return make[name]() if name in make else (None, {})


def say_ready(word="ready"):
    with open(os.environ["LITTORAL_READY"], "w", encoding="utf-8") as file:
        file.write(word + "\n")


def stays(proxy):
    """Whether the inputs of a filter stay when it is shown."""
    hints = proxy.SMProxy.GetHints()
    visibility = hints.FindNestedElementByName("Visibility") if hints else None
    return visibility is not None and visibility.GetAttribute("replace_input") == "0"


def show(proxy, inputs=()):
    """As Apply does: each output in the view that it prefers, there in the place of the inputs."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    active = simple.GetActiveView()
    for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
        view = controller.ShowInPreferredView(proxy.SMProxy, port, active.SMProxy)
        if not view:
            continue
        controller.AssignViewToLayout(view)
        visible = [one for one in active.Representations if hasattr(one, "Input") and one.Visibility]
        if view != active.SMProxy or len(visible) == 1:
            simple.ResetCamera(servermanager._getPyProxy(view))  # pylint: disable=protected-access
        for one in inputs if view == active.SMProxy and not stays(proxy) else ():
            simple.Hide(one, active)
    simple.SetActiveSource(proxy)


def prepare(name):
    """A filter with its usual inputs, shown after them, in whose place it is; a source is made in the window."""
    simple.SetActiveView(simple.GetActiveViewOrCreate("RenderView"))
    first, others = usual_inputs(name)
    if first is None:
        say_ready()
        return
    inputs = [first, *others.values()]
    for one in [] if name.endswith("FromFits") else inputs:
        show(one)
        simple.RenderAllViews()
    port = {"PlantScatter": "Sites", "SitePreference": "Sites", "StandInventory": "Inventory"}.get(name, "Input")
    show(getattr(simple, name)(**{port: first}, **others), inputs)
    simple.RenderAllViews()
    say_ready("made")


def make_mistake(name):
    """The first mistake with an entry that TestMistakes.py lists, shown as the window does it."""
    sys.path.insert(0, os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Testing", "ParaView"))
    from mistakes import MISTAKES

    given = {"Forest": {"MeanPerQuadrat": -1.0}, "SwayingForest": {"ReferenceSpeed": -1.0},
             "Sea": {"SignificantWaveHeight": -1.0}, "Underwater": {"WindSpeed": -1.0},
             "TwinOfAPlace": {"Range": -1.0}}
    arguments = given.get(name) or next(mistake[1] for mistake in MISTAKES if mistake[0] == name)()
    simple.SetActiveView(simple.GetActiveViewOrCreate("RenderView"))
    show(getattr(simple, name)(**arguments))
    say_ready()


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
{"first look": prepare, "mistake": make_mistake}[os.environ["LITTORAL_ROLE"]](os.environ["LITTORAL_ENTRY"])
