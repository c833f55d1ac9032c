# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand of trees in plain VTK: its plants, and ground and light by vtkLandscapePass."""

from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from ..LittoralRendering import vtkLandscapePass
from ..plants import block, level_actors
from ..properties import set_properties

#: Colors of the ground and of its grass; reach of the ground around the origin [m].
BROADLEAVED, SAVANNA = ((0.40, 0.36, 0.22), (0.36, 0.42, 0.18)), ((0.56, 0.50, 0.30), (0.66, 0.60, 0.34))
REACH = 6000.0


def plant_actors(forest):
    """Actors of all levels of an updated vtkPlantScatterFilter."""
    actors = []
    for level, *part in (("High", "Leaves"), ("Medium", "Crown"), ("Low",)):
        if block(forest.GetOutput(), level, *part):
            actors += level_actors(forest, level)
    return actors


def light(renderer, colors, **settings):
    """Light a renderer, with level ground of two colors, that of the ground and that of the grass."""
    plane = set_properties(vtkPlaneSource(), dict(
        Origin=(-REACH, -REACH, 0.0), Point1=(REACH, -REACH, 0.0), Point2=(-REACH, REACH, 0.0), Resolution=(60, 60)))
    mapper, ground = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(plane.GetOutputPort())
    ground.SetMapper(mapper)
    ground.GetProperty().SetColor(*colors[0])
    vtkLandscapePass.SetMaterial(ground, vtkLandscapePass.Ground)
    renderer.AddActor(ground)
    renderer.SetPass(set_properties(vtkLandscapePass(), dict(CoverColor=colors[1], **settings)))
