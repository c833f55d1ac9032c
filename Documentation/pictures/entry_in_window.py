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


def prepare(name):
    """A filter with its usual inputs, shown after them, in whose place it is; a source is made in the window."""
    first, others = usual_inputs(name)
    if first is None:
        say_ready()
        return
    first.UpdatePipeline()
    is_table = "Table" in first.GetDataInformation().GetDataSetTypeAsString()
    view = simple.GetActiveViewOrCreate("RenderView")
    if not is_table or name == "SeaStatistics":
        show(first)
        simple.ResetCamera(view)
        simple.Render(view)
    show(getattr(simple, name)(**{"Sites" if name == "PlantScatter" else "Input": first}, **others))
    if is_table:
        simple.ResetCamera(view)
    else:
        simple.Hide(first, view)
    simple.RenderAllViews()
    say_ready("made")


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
