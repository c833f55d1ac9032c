# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What each entry of ParaView's menus shows first, with its defaults: pictures of an empty view after Apply.

    pvpython Documentation/pictures/make_first_looks.py [FOLDER]    default: the folder first-look beside this file
"""

import os
import sys

from paraview import simple

SIZE = [640, 400]
FOLDER = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "first-look")


def take(name, source, time=0.0, then=None):
    """Shows a source in a view of its own, and then another one, and saves the picture."""
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.ViewTime = time
    simple.SetActiveView(view)
    simple.Show(source, view)
    simple.ResetCamera(view)
    if then:
        simple.Render(view)
        simple.Show(then, view)
    simple.Render(view)
    simple.SaveScreenshot(os.path.join(FOLDER, name + ".jpg"), view, Quality=82)
    simple.Delete(view)


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
os.makedirs(FOLDER, exist_ok=True)
terrain, sea = simple.TurningBandsTerrain(), simple.SeaState()
particles, flow = simple.SuspendedParticles(), simple.FlowPrimitive(FlowType="Vortex", Axis=[0, 0, 1])
take("turning-bands-terrain", terrain)
take("terrain-level-of-detail", simple.TerrainLevelOfDetail(Input=terrain))
take("quadrat-points", simple.QuadratPoints())
take("aono-kunii-tree", simple.AonoKuniiTree())
take("reeves-tree", simple.ReevesTree())
take("gardner-plant", simple.GardnerPlant())
take("wind-field", simple.WindField())
take("sea-state", sea)
take("flow-primitive", flow)
take("suspended-particles", particles)
take("particle-orbits", simple.ParticleOrbits(Input=particles, SeaState=sea))
take("particle-fog", simple.ParticleFog(Input=particles))
take("seaweed", simple.Seaweed())
take("kelp-under-sea", simple.Seaweed(), then=simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6))
take("sea-surface", simple.SeaSurface(Input=sea))
take("current-drift", simple.CurrentDrift(Input=particles, Currents=[flow]), time=10.0, then=flow)
take("particle-level-of-detail", simple.ParticleLevelOfDetail(Input=particles, SeaState=sea))
take("plant-scatter", simple.PlantScatter(Sites=simple.QuadratPoints(Size=[200, 200]), Prototypes=[simple.ReevesTree()]))
take("forest", simple.Forest())
