# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants in plain VTK: their blocks by name, and actors in daylight.

    source = vtkReevesTreeSource()
    source.Update()
    renderer.AddActor(plant_actor(block(source.GetOutput(), "High", "Leaves")))
"""

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkTexture

from .glb import direction
from .LittoralRendering import vtkLandscapePass
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


def plant_actor(part, picture=None, tinted=False, mipmap=True):
    """Actor of a part of a plant with its colors, or with a texture instead.

    tinted: multiply the texture with the colors. mipmap: not for what is cut out in fine detail,
    since means of its transparency are below a half.
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
        texture.SetMipmap(mipmap)
        actor.SetTexture(texture)
    return actor


def cut_out(actor):
    """The actor, cut out where its texture is transparent, and with translucent leaves."""
    actor.ForceOpaqueOn()
    shader = actor.GetShaderProperty()
    shader.AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, CUT_OUT, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, BOTH_SIDES, False)
    return actor


#: Colors divided by the mean of the texture, before the texture multiplies them.
BY_MEAN = """//VTK::Light::Impl
  gl_FragData[0].rgb /= textureMean;
"""
#: Normals from a texture, in the frame of the texture coordinates.
TEXEL_NORMALS = """//VTK::Normal::Impl
  vec2 s = dFdx(tcoordVCVSOutput.st), t = dFdy(tcoordVCVSOutput.st);
  vec3 p = dFdx(vertexVC.xyz), q = dFdy(vertexVC.xyz);
  float turn = sign(s.x * t.y - s.y * t.x);
  vec3 n = texture(normalTex, tcoordVCVSOutput.st).xyz * 2.0 - 1.0;
  normalVCVSOutput = normalize(n.x * normalize(turn * (p * t.y - q * s.y))
    + n.y * normalize(turn * (q * s.x - p * t.x)) + n.z * normalize(cross(p, q)));
"""


def carried_picture(part, name="Texture"):
    """The texture that a part carries as field data, as an image; None if it has none."""
    texels = part.GetFieldData().GetArray(name)
    size = part.GetFieldData().GetArray("TextureSize")
    if texels is None or size is None:
        return None
    image = vtkImageData()
    image.SetDimensions(int(size.GetTuple1(0)), int(size.GetTuple1(1)), 1)
    image.GetPointData().SetScalars(texels)
    return image


def show_carried(actor, part):
    """Let an actor with the carried picture of a part divide by its mean and use its normals."""
    mean = part.GetFieldData().GetArray("TextureMean")
    shader = actor.GetShaderProperty()
    if mean is not None:
        shader.GetFragmentCustomUniforms().SetUniform3f("textureMean", mean.GetTuple3(0))
        shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, BY_MEAN, False)
    normals = carried_picture(part, "NormalTexture")
    if normals is not None:
        texture = vtkTexture()
        texture.SetInputData(normals)
        texture.InterpolateOn()
        actor.GetProperty().SetTexture("normalTex", texture)
        shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, TEXEL_NORMALS, False)
    return actor


def carried_actor(part):
    """Actor of a part with its colors and the texture that it carries, cut out."""
    picture = carried_picture(part)
    if picture is None:
        return plant_actor(part)
    return show_carried(cut_out(plant_actor(part, picture, tinted=True, mipmap=False)), part)


def level_actors(source, level, cut_leaves=False, transmittance=0.3):
    """Actors of a level, "High", "Medium" or "Low", of an updated plant source or scattered plants.

    cut_leaves: put the texture on the leaves of High and cut it out. Quadrics need this, kites do
    not. In vtkLandscapePass the skin is bark, and leaves let that part of their light through.
    """
    data = source.GetOutputDataObject(0)
    if level == "High":
        skin, leaves = plant_actor(block(data, "High", "Skin")), block(data, "High", "Leaves")
        vtkLandscapePass.SetMaterial(skin, vtkLandscapePass.Bark)
        actors = [skin, carried_actor(leaves) if cut_leaves else plant_actor(leaves)]
    else:
        names = [("Medium", "Trunk"), ("Medium", "Crown")] if level == "Medium" else [("Low",)]
        actors = [carried_actor(block(data, *name)) for name in names]
    vtkLandscapePass.SetTransmittance(actors[-1], transmittance)
    return actors


def add_daylight(renderer, sun=(215.0, 40.0)):
    """Sun, sky and light from the ground. sun: azimuth and elevation [degrees]."""
    renderer.AutomaticLightCreationOff()
    lamps = (
        (direction(*sun), (1.0, 0.94, 0.82), 1.1), ((0.0, 0.0, 1.0), (0.65, 0.78, 1.0), 0.45),
        (direction(sun[0] - 120.0, 5.0), (0.85, 0.88, 0.85), 0.35))
    for towards, color, intensity in lamps:
        light = vtkLight()
        light.SetPosition(*(1e5 * c for c in towards))
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetColor(*color)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
