# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenVDB volumes beside a scene file: fog, and wind, which a thin haze makes visible."""

import os

import bpy

from . import versions
from .shading import Shading

#: Speeds of the wind [m/s] between which the air goes from clear to as dense as it gets.
SPEEDS = 5.0, 15.0
#: Colors of slow and fast wind, and how much of the light goes on ahead.
SLOW, FAST, FORWARD = (0.20, 0.45, 1.0), (1.0, 0.42, 0.12), 0.3
#: Steps of Cycles through wind, in sides of its cells: gusts are larger than those.
STEP = 3.0


def add(about, folder):
    """A volume of `extras.volumes`; wind without a density is there for the modifiers and simulations of Blender alone."""
    kind, path = about.get("kind"), os.path.join(folder, about["file"])
    if kind not in ("fog", "wind") or not os.path.exists(path):
        print(f"littoral: the volume {path} of kind {kind} is left out", flush=True)
        return
    volume = bpy.data.volumes.new(kind.capitalize())
    volume.filepath = path
    thing = bpy.data.objects.new(volume.name, volume)
    bpy.context.scene.collection.objects.link(thing)
    volume.grids.load()
    density = float(about.get("density", 0.0))
    thing.hide_render = kind == "wind" and density <= 0.0
    if not thing.hide_render:
        volume.materials.append(fog_of(volume) if kind == "fog" else wind_of(volume, density, about.get("speeds", SPEEDS)))


def _material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    return material, Shading(material.node_tree)


def fog_of(volume):
    """The material of fog, by the first grid of its volume."""
    material, s = _material("fog")
    scatter = s.tree.nodes.new("ShaderNodeVolumePrincipled")
    scatter.inputs["Density Attribute"].default_value = volume.grids[0].name if len(volume.grids) else "density"
    s.end(volume=scatter.outputs[0])
    return material


def wind_of(volume, density, speeds):
    """The material of wind: a haze that scatters light where the air is fast, from none at the first of two speeds [m/s]
    to a density [1/m] at the second, and whose color follows the speed."""
    material, s = _material("wind")
    versions.long_steps(material, STEP)
    name = next((grid.name for grid in volume.grids if grid.channels == 3), "Velocity")
    speed = s.vector("LENGTH", s.attribute(name, "Vector"), output=1)
    share = s.ramp(speed, *speeds)
    dense = s.math("MULTIPLY", share, density)
    of_fast = s.math("MULTIPLY", share, dense)
    # Two hazes, as Debian's Blender 5.2 crashes where the color of one is not the same everywhere.
    slow, fast = (s.node("VolumeScatter", {"Color": color, "Density": thick, "Anisotropy": FORWARD}) for color, thick in (
        (SLOW, s.math("SUBTRACT", dense, of_fast)), (FAST, of_fast)))
    s.end(volume=s.node("AddShader", {0: slow, 1: fast}))
    return material
