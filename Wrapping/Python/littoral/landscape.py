# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Open-air scenes in ParaView: a country to stand in, sky, sun, haze and leaves that let light through.

Works with the rasterizer that every ParaView has; no ray tracing. Lengths are in metres, z is up. The sun stands
where `littoral.scene.SUN` says unless told otherwise.
"""

import json
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

from . import scene
from .elevation import array_from_image, image_from_array

#: Colour of the air far away.
HAZE = (0.71, 0.79, 0.87)
#: Share of light that the air takes, per metre.
THICKNESS = 1.0 / 9000.0
#: What a cloudless sky looks like at the horizon and above.
HORIZON, ZENITH = (0.76, 0.84, 0.91), (0.22, 0.42, 0.74)

WORLD = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nout vec3 placeMC;"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  placeMC = vertexMC.xyz;"},
    {"type": "fragment", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nin vec3 placeMC;"}]

AIR = """
  float away = length(vertexVC.xyz);
  float clear = exp(-{thickness} * away);
  gl_FragData[0].rgb = mix(vec3({haze}), gl_FragData[0].rgb, clear);
"""
