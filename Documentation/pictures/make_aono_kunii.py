# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture aono-kunii of the user guide: trees by repeated forks, one of each form.

    ./littoral run pvpython Documentation/pictures/make_aono_kunii.py [FOLDER]
"""

import os
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from littoral import vtkAonoKuniiTreeSource
from littoral.gallery.pictures import look, pale_renderer
from littoral.picture import INK, label, write_jpg
from littoral.plants import add_daylight, level_actors, plant_actor

SIZE = (900, 500)
TREES = (("MonopodialC", "Monopodial", -12.5), ("SympodialC", "Sympodial", -0.2), ("TernaryB", "Ternary", 12.5))


def ground():
    """A meadow."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(0.0)
    disk.SetOuterRadius(400.0)
    disk.SetCircumferentialResolution(80)
    disk.Update()
    actor = plant_actor(disk.GetOutput())
    actor.SetPosition(0.0, 0.0, -0.02)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0.52, 0.61, 0.40)
    return actor


def shadow(x, radius):
    """A soft dark patch below a crown."""
    actors = []
    for k in range(8):
        disk = vtkDiskSource()
        disk.SetInnerRadius(0.0)
        disk.SetOuterRadius(radius * (1.0 - 0.1 * k))
        disk.SetCircumferentialResolution(60)
        disk.Update()
        actor = plant_actor(disk.GetOutput())
        actor.SetPosition(x + 0.3 * radius, 0.3 * radius, 0.002 * k)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(0.3, 0.38, 0.26)
        actor.GetProperty().SetOpacity(0.09)
        actors.append(actor)
    return actors


def main(folder):
    """Draw it into a folder."""
    renderer = pale_renderer()
    add_daylight(renderer)
    renderer.AddActor(ground())
    for preset, name, x in TREES:
        source = vtkAonoKuniiTreeSource()
        source.SetPreset(getattr(source, preset))
        source.Update()
        for actor in shadow(x, 5.0):
            renderer.AddActor(actor)
        for actor in level_actors(source, "High"):
            actor.SetPosition(x, 0.0, 0.0)
            renderer.AddActor(actor)
        renderer.AddActor(label(name, (0.5 + x / 39.5, 0.06), 24, INK))
    look(renderer, (0.0, -80.0, 5.0), (0.0, 0.0, 4.9), 15.6)
    window = vtkRenderWindow()
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "aono-kunii.jpg"), SIZE)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
