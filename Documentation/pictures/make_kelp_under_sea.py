# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Kelp, and then the surface of a sea above it, as ParaView shows them first.

    pvpython Documentation/pictures/make_kelp_under_sea.py [FOLDER]    default: the folder of this file
"""

import os
import sys

from paraview import simple

FOLDER = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))

simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
view = simple.CreateView("RenderView")
view.ViewSize = [640, 400]
simple.SetActiveView(view)
simple.Show(simple.Seaweed(), view)
simple.ResetCamera(view)
simple.Render(view)
simple.Show(simple.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6), view)
simple.Render(view)
simple.SaveScreenshot(os.path.join(FOLDER, "kelp-under-sea.jpg"), view, Quality=82)
