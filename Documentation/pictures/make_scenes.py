# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The ready scenes as ParaView shows them first, but at a time: pictures scene-NAME.jpg.

    pvpython Documentation/pictures/make_scenes.py [FOLDER]    default: the folder of this file
"""

import os
import sys

from paraview import simple

SIZE = [840, 480]
FOLDER = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
#: Names of pictures, entries, and times [s].
SCENES = (("forest", "Forest", 0.0), ("swaying-forest", "SwayingForest", 5.0), ("sea", "Sea", 5.0),
          ("underwater", "Underwater", 5.0), ("twin", "TwinOfAPlace", 0.0))


def take(name, entry, time):
    """Shows a scene in a view of its own and saves the picture."""
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    simple.SetActiveView(view)
    simple.Show(getattr(simple, entry)(), view)
    simple.ResetCamera(view)  # to the scene's own
    view.ViewTime = time
    simple.Render(view)
    simple.SaveScreenshot(os.path.join(FOLDER, f"scene-{name}.jpg"), view, Quality=80)
    simple.Delete(view)


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
for scene in SCENES:
    take(*scene)
