# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sun, sky and haze."""

import math

import bpy
import mathutils

from . import versions

#: Strength of the sun's light for each lux, and of the sky's texture: a clear noon of 100 000 lx is exposed well.
SUN_PER_LUX, SKY = 4.6e-5, 0.11
#: Sine of the lowest elevation at which haze has the color of the sky.
HORIZON = 0.06
#: Factor by which haze is brighter towards the sun.
GLOW = 1.2


class Air:
    """Sky and haze of a sun. towards: unit vector. sight: attenuation length [m] or None. height: scale height [m].
    clouds: share of the sky that they cover."""

    def __init__(self, towards, sight=None, height=260.0, dust=1.0, strength=1.0, clouds=0.0):
        self.towards, self.sight, self.height, self.dust = towards, sight, height, dust
        self.strength, self.clouds = SKY * strength, clouds

    def sky(self, s, direction=None):
        """The light of the sky from a direction; default: that of the ray."""
        node = s.tree.nodes.new("ShaderNodeTexSky")
        elevation = math.asin(max(-1.0, min(1.0, self.towards[2])))
        versions.set_sky(node, elevation, math.atan2(self.towards[0], self.towards[1]), self.dust)
        if direction is not None:
            s.plug(node.inputs["Vector"], direction)
        return node.outputs["Color"]

    def cloudy(self, s, is_seen):
        """The sky with thin clouds in a layer of a flat earth, brighter towards the sun, lost in the haze of the horizon.
        For light alone, which is not seen, clouds are smooth."""
        look = s.node("TexCoord", output="Generated")
        up = s.math("MAXIMUM", s.node("SeparateXYZ", {0: look}, "Z"), 0.0)
        place = s.scaled(s.vector("MULTIPLY", look, (1.0, 1.0, 0.0)), s.math("DIVIDE", 1.0, s.math("ADD", up, 0.06)))
        drawn = s.multiply(place, (1.0, 0.55, 1.0))  # by the wind
        banks = s.noise(drawn, 0.35, 2.0 if is_seen else 0.0)
        wisps = s.noise(drawn, 1.1, 8.0 if is_seen else 1.0, 0.62)
        most = s.math("MULTIPLY_ADD", banks, 0.6, s.math("MULTIPLY", wisps, 0.5))
        cover = s.ramp(most, 0.75 - 0.45 * self.clouds, 0.95 - 0.35 * self.clouds)
        cover = s.math("MULTIPLY", s.math("MULTIPLY", cover, s.ramp(up, 0.01, 0.16)), 0.85)
        towards = s.math("MAXIMUM", s.vector("DOT_PRODUCT", look, tuple(self.towards), output=1), 0.0)
        shine = s.math("MULTIPLY_ADD", s.math("POWER", towards, 4.0), 9.0, 7.0)
        return s.blend(cover, self.sky(s), s.scaled((1.0, 0.96, 0.92), shine))

    def before(self, s, make):
        """Shader of `make`, seen through haze, whose density falls with height: only what the camera sees directly. It is
        made twice, so that other rays need not compute the haze; make(False) is for those."""
        if not self.sight:
            return s.mix(s.ray("Is Diffuse Ray"), make(), make(False))
        away = s.node("CameraData", output="View Distance")
        look = s.scaled(s.geometry("Incoming"), -1.0)
        rise = s.math("DIVIDE", s.math("MULTIPLY", s.node("SeparateXYZ", {0: look}, "Z"), away), self.height)
        rise = s.math("ADD", rise, 1e-3)  # (1 - exp(-rise)) / rise has no pole
        # The mean along the ray of exp(-z / height), z from the eye.
        mean = s.math("DIVIDE", s.math("SUBTRACT", 1.0, s.math("EXPONENT", s.math("MULTIPLY", rise, -1.0))), rise)
        depth = s.math("MULTIPLY", s.math("DIVIDE", away, self.sight), mean)
        left = s.math("EXPONENT", s.math("MULTIPLY", depth, -1.0))
        flat = s.vector("MULTIPLY", look, (1.0, 1.0, 0.0))
        low = s.vector("ADD", s.vector("NORMALIZE", flat), (0.0, 0.0, HORIZON))
        # Haze scatters sunlight forward: it shines about the sun.
        towards = s.math("MAXIMUM", s.vector("DOT_PRODUCT", look, tuple(self.towards), output=1), 0.0)
        shine = s.math("MULTIPLY_ADD", s.math("POWER", towards, 3.0), self.strength * GLOW, self.strength)
        veil = s.node("Emission", {"Color": self.sky(s, low), "Strength": shine})
        return s.mix(s.ray("Is Camera Ray"), make(False), s.mix(s.math("SUBTRACT", 1.0, left), make(), veil))

    def light_world(self):
        """Let the sky light the scene."""
        from .shading import Shading

        world = bpy.data.worlds.new("Sky")
        bpy.context.scene.world = world
        world.use_nodes = True
        s = Shading(world.node_tree)
        if self.clouds:
            seen, light = (s.node("Background", {"Color": self.cloudy(s, is_seen), "Strength": self.strength})
                           for is_seen in (True, False))
            shine = s.mix(s.ray("Is Camera Ray"), light, seen)
        else:
            shine = s.node("Background", {"Color": self.sky(s), "Strength": self.strength})
        end = world.node_tree.nodes.new("ShaderNodeOutputWorld")
        world.node_tree.links.new(shine, end.inputs["Surface"])
        # Rays that leave a surface find the sky, which is soft; those that ask for a light all go to the sun.
        world.cycles.sampling_method = "NONE"


def add_sun(towards, lux, color, warmth=1.0, angle=0.0093):
    """A lamp as far as the sun, of an angular diameter [rad]; a low sun is redder."""
    lamp = bpy.data.lights.new("Sun", "SUN")
    lamp.energy, lamp.angle = lux * SUN_PER_LUX, angle
    versions.no_hits(lamp)
    path = 1.0 / max(0.12, towards[2])  # air masses
    lamp.color = [c * math.exp(-warmth * k * (path - 1.0)) for c, k in zip(color, (0.035, 0.085, 0.19))]
    thing = bpy.data.objects.new("Sun", lamp)
    thing.rotation_euler = mathutils.Vector(towards).to_track_quat("Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(thing)
