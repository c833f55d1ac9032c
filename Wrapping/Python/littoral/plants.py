# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants in plain VTK: their blocks by name, and actors in daylight.

    source = vtkReevesTreeSource()
    source.Update()
    renderer.AddActor(plant_actor(block(source.GetOutput(), "High", "Leaves")))
"""

from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkTexture

from . import scene
from .versions import block_name


def block(data, *names):
    """The block of a multiblock by the names on its path; None if there is none."""
    for name in names:
        blocks = range(data.GetNumberOfBlocks()) if data else ()
        data = next((data.GetBlock(k) for k in blocks if block_name(data, k) == name), None)
    return data


#: Fragments with alpha below 0.5 are discarded; the others are opaque and need no sorting.
CUT_OUT = """//VTK::TCoord::Impl
  if (gl_FragData[0].a < 0.5) discard;
  gl_FragData[0].a = 1.0;
"""
#: Translucent leaves: their normal is the same on both sides, while VTK turns it to the camera.
BOTH_SIDES = """//VTK::Normal::Impl
  if (gl_FrontFacing == false) normalVCVSOutput = -normalVCVSOutput;
"""


def plant_actor(part, picture=None, tinted=False):
    """Actor of a part of a plant with its colors, or with a texture instead.

    tinted: multiply the texture with the colors.
    """
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(part)
    mapper.SetScalarVisibility(picture is None or tinted)
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    if picture is not None:
        texture = vtkTexture()
        texture.SetInputData(picture)
        texture.InterpolateOn()
        texture.MipmapOn()
        actor.SetTexture(texture)
    return actor


def cut_out(actor):
    """The actor, cut out where its texture is transparent, and with translucent leaves."""
    actor.ForceOpaqueOn()
    shader = actor.GetShaderProperty()
    shader.AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, CUT_OUT, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, BOTH_SIDES, False)
    return actor


def level_actors(source, level, cut_leaves=False):
    """Actors of a level, "High", "Medium" or "Low", of an updated plant source.

    cut_leaves: put the texture on the leaves of High and cut it out. Quadrics need this, kites do
    not.
    """
    data = source.GetOutput()
    if level == "High":
        skin, leaves = plant_actor(block(data, "High", "Skin")), block(data, "High", "Leaves")
        if not cut_leaves:
            return [skin, plant_actor(leaves)]
        return [skin, cut_out(plant_actor(leaves, source.GetOutputDataObject(2), tinted=True))]
    if level == "Medium":
        crown = plant_actor(block(data, "Medium", "Crown"), source.GetOutputDataObject(1))
        return [plant_actor(block(data, "Medium", "Trunk")), cut_out(crown) if cut_leaves else crown]
    return [plant_actor(block(data, "Low"))]


def add_daylight(renderer, sun=(215.0, 40.0)):
    """Sun, sky and light from the ground. sun: azimuth and elevation [degrees]."""
    renderer.AutomaticLightCreationOff()
    lamps = (
        (scene.direction(*sun), (1.0, 0.94, 0.82), 1.1), ((0.0, 0.0, 1.0), (0.65, 0.78, 1.0), 0.45),
        (scene.direction(sun[0] - 120.0, 5.0), (0.85, 0.88, 0.85), 0.35))
    for towards, color, intensity in lamps:
        light = vtkLight()
        light.SetPosition(*(1e5 * c for c in towards))
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetColor(*color)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
