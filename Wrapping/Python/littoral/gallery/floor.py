# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The surroundings of a stand of trees in plain VTK: ground, woods beyond, and light by vtkLandscapePass."""

from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from .. import stand
from ..LittoralRendering import vtkLandscapePass
from ..plants import block, level_actors
from ..properties import set_properties

#: Colors of the ground and of its grass.
BROADLEAVED, SAVANNA = ((0.40, 0.36, 0.22), (0.36, 0.42, 0.18)), ((0.56, 0.50, 0.30), (0.66, 0.60, 0.34))


def plant_actors(forest):
    """Actors of all levels of an updated vtkPlantScatterFilter; leaves let light through."""
    actors = []
    for level, *part in (("High", "Leaves"), ("Medium", "Crown"), ("Low",)):
        if block(forest.GetOutput(), level, *part):
            actors += level_actors(forest, level)
            vtkLandscapePass.SetTransmittance(actors[-1], 0.3)
    return actors


def woods_beyond(trees, side, rings=2):
    """Actors of the trees of a stand, seen from its southern edge, again in squares around it, at their lowest level."""
    forest = stand.plant(trees, UseLevels=True, NearDistance=0.0, FarDistance=1e-3)
    forest.Update()
    actors = []
    for row in range(rings + 1):
        for column in range(-rings, rings + 1):
            for actor in level_actors(forest, "Low") if row or column else ():
                actor.SetPosition(column * side, row * side, 0.0)
                actors.append(actor)
    return actors


def land(color, reach=6000.0, cells=60):
    """Actor of level ground around the origin."""
    plane, mapper, actor = vtkPlaneSource(), vtkPolyDataMapper(), vtkActor()
    plane.SetOrigin(-reach, -reach, 0.0)
    plane.SetPoint1(reach, -reach, 0.0)
    plane.SetPoint2(-reach, reach, 0.0)
    plane.SetResolution(cells, cells)
    mapper.SetInputConnection(plane.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Ground)
    return actor


def light(renderer, colors, **settings):
    """Light a renderer, with a ground of two colors, that of the ground and that of the grass."""
    renderer.AddActor(land(colors[0]))
    renderer.SetPass(set_properties(vtkLandscapePass(), dict(CoverColor=colors[1], **settings)))
