# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Landscapes in ParaView: terrain, woods, sky, sun and haze.

Everything works with the rasterizer of any ParaView, without ray tracing. Lengths are in metres.
"""

import json

from paraview import simple

from ..glb import direction
from ..versions import create_texture
from . import views
from .country import SUN

#: Color of the haze, and its attenuation length [m].
HAZE, SIGHT = (0.70, 0.79, 0.88), 9000.0
#: Fragments behind everything.
BEHIND = [
    {"type": "fragment", "original": "//VTK::Depth::Impl",
     "replacement": "gl_FragDepth = 0.999999;"}]
#: Positions in fragments.
PLACE = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nout vec3 placeMC;"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  placeMC = vertexMC.xyz;"},
    {"type": "fragment", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nin vec3 placeMC;"}]

#: The color as VTK has computed it.
VTK_COLORS = "//VTK::TCoord::Impl\n"
#: Haze by the distance from the camera.
AIR = f"""
  gl_FragData[0].rgb = mix(vec3{HAZE}, gl_FragData[0].rgb, exp(-length(vertexVC.xyz) / {SIGHT}));
"""

#: Grass and stones: noise in five octaves from half a metre upwards.
GRAIN = """
  vec2 at = 2.0 * placeMC.xy;
  float grain = 0.0, weight = 0.5;
  for (int octave = 0; octave < 5; ++octave)
  {
    vec2 cell = floor(at), part = fract(at);
    part = part * part * (3.0 - 2.0 * part);
    vec4 corners = vec4(dot(cell, vec2(127.1, 311.7)));
    corners += vec4(0.0, 127.1, 311.7, 438.8);
    corners = fract(sin(corners) * 43758.5453);
    grain += weight *
      mix(mix(corners.x, corners.y, part.x), mix(corners.z, corners.w, part.x), part.y);
    at *= 0.41;
    weight *= 0.8;
  }
  gl_FragData[0].rgb *= mix(vec3(0.50, 0.56, 0.46), vec3(0.96, 0.95, 0.88), 0.6 * grain);
"""


def prepare_view(view):
    """Set up sun, sky light and light from the ground; no widgets; antialiasing."""
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = HAZE
    view.UseFXAA = 1
    view.UseLight = 0
    view.AdditionalLights = []
    for towards, color, intensity in (
            (direction(*SUN), (1.0, 0.93, 0.80), 1.15),
            ((0.0, 0.0, 1.0), (0.62, 0.76, 1.0), 0.5),
            (direction(SUN[0] - 110.0, 10.0), (0.85, 0.88, 0.85), 0.4)):
        light = simple.AddLight(view=view)
        light.Coords = "Scene"
        light.Type = "Directional"
        light.Position = [1e5 * c for c in towards]
        light.FocalPoint = [0.0, 0.0, 0.0]
        light.DiffuseColor = list(color)
        light.Intensity = intensity


def show_ground(source, view):
    """Show a terrain with lit colors, grain and haze."""
    shown = views.show_baked(source, view)
    views.shade(shown, PLACE, VTK_COLORS + GRAIN + AIR)
    return shown


#: Visible blocks of scattered plants: the skeletons are lines, which have no normals for the shader.
PLANT_PARTS = ("/Root/High/Skin", "/Root/High/Leaves", "/Root/Medium/Trunk", "/Root/Medium/Crown", "/Root/Low")


def show_plants(source, view, parts=PLANT_PARTS):
    """Show parts of scattered or swaying plants, with the textures that they carry."""
    parts = simple.ExtractBlock(Input=source, Selectors=list(parts))
    shown = views.show_colored(parts, view)
    shown.SetRepresentationType("Full Surface")
    shown.Ambient = 0.35
    shown.Specular = 0.0
    views.shade(shown, [], VTK_COLORS + AIR)
    return shown


def show_sky(source, view, picture):
    """Show a dome with its texture, a PNG file."""
    shown = simple.Show(source, view)
    simple.ColorBy(shown, None)
    shown.Texture = create_texture(picture)
    shown.SelectTCoordArray = "TCoords"
    shown.RepeatTextures = 0
    shown.AmbientColor = shown.DiffuseColor = [1.0, 1.0, 1.0]
    views.bake(shown)
    shown.UseShaderReplacements = 1
    shown.ShaderReplacements = json.dumps(BEHIND)
    return shown
