# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Light under water: what the water absorbs and scatters, and what its moving surface focuses.

A path tracer does not find the way of sunlight through a surface that refracts it. So the sun is a lamp in the refracted
direction, the surface is clear to shadow rays, and it filters them by what the water absorbs on their way and by how much
the surface focuses light at the place where they start: rays through the surface's triangles are followed down to three
levels and counted there.

The water is homogeneous, so what it absorbs and scatters between a surface and the eye is in the surface's shader instead
of a volume, where chance would tell what is seen: absorption and scattering of a light that decays with depth in closed
form, its focus by a few looks at random places along the ray.
"""

import math

import bpy
import numpy as np

import seawater

from . import versions
from .light import SUN_PER_LUX
from .shading import Shading

INDEX = 1.333
#: Cells along a side of the caustics' picture, and the distance from the eye that it covers [m].
CELLS, REACH = 1024, 34.0
#: Looks for light along a ray, and the distance within which they are [m].
LOOKS, SIGHT = 4, 30.0
#: Asymmetry of the phase function, and light that was scattered more than once by that which was once.
FORWARD, OFTEN = 0.62, 0.5


class Water:
    """The light of a water level. about: `extras.water` of the file."""

    def __init__(self, about, towards, lux):
        self.level = float(about.get("level", 0.0))
        self.extinction = np.array(about.get("extinction", seawater.EXTINCTION), float)
        color = np.array(about.get("color", (0.5, 0.9, 1.0)), float)
        self.scattering = np.array(about.get("scattering", 0.45 * self.extinction.min() * color / color.max()), float)
        lost = self.extinction - 0.5 * self.scattering  # what is scattered forward is not
        self.downward = lost if "extinction" in about else np.array(seawater.DOWNWARD)
        self.towards = refracted(np.array([[0.0, 0.0, 1.0]]), np.asarray(towards, float)[None])[0]
        self.light = lux * SUN_PER_LUX
        self.caustics = None

    def focus(self, surfaces, eye, lowest):
        """Count the light below surfaces, triples of points [n, 3], normals and triangles, about a place."""
        self.low, self.side = np.array(eye[:2]) - REACH, 2.0 * REACH
        deepest = self.level - lowest
        self.depths = [0.18 * deepest, 0.5 * deepest, 0.93 * deepest]
        pixels = np.ones((CELLS, CELLS, 4), np.float32)
        heights = [self.level - depth for depth in self.depths]
        pixels[..., :3] = np.moveaxis(light_below(surfaces, self.towards, heights, self.low, self.side), 0, -1)
        image = bpy.data.images.new("Caustics", CELLS, CELLS, alpha=True, float_buffer=True)
        image.colorspace_settings.name = "Non-Color"
        image.pixels.foreach_set(pixels.ravel())
        image.pack()
        self.caustics = image

    # Shaders ------------------------------------------------------------------------------------

    def seen(self, s):
        """1 for rays of the camera and what mirrors and windows make of them, 0 for those that gather light."""
        return s.math("SUBTRACT", 1.0, s.math("MAXIMUM", s.ray("Is Shadow Ray"), s.ray("Is Diffuse Ray")))

    def filter(self, s):
        """Share of the light of a surface that the water leaves on its way to the eye, a color."""
        way = s.math("MULTIPLY", s.ray("Ray Length"), self.seen(s))
        return self.left(s, way, self.extinction)

    def left(self, s, way, rates):
        """exp(-rate way) for each color."""
        parts = [s.math("EXPONENT", s.math("MULTIPLY", way, -float(rate))) for rate in rates]
        return s.node("CombineXYZ", dict(enumerate(parts)))

    def before(self, s, make):
        """Shader of `make`, with the light that the water before it scatters to the eye; other rays do not compute it."""
        seen = s.node("AddShader", {0: make(), 1: self.veil(s)})
        return s.mix(self.seen(s), make(False), seen)

    def veil(self, s):
        """Sunlight, decaying with depth, scattered along the ray to the eye, as a glow."""
        back, way = s.geometry("Incoming"), s.ray("Ray Length")
        start = s.vector("ADD", s.geometry("Position"), s.scaled(back, way))
        depth = s.math("SUBTRACT", self.level, s.node("SeparateXYZ", {0: start}, "Z"))
        rise = s.math("MULTIPLY", s.node("SeparateXYZ", {0: back}, "Z"), -1.0)
        parts = []
        for extinction, downward, scattering in zip(self.extinction, self.downward, self.scattering):
            # Integral of exp(-downward (depth - rise s)) exp(-extinction s) over s from 0 to way.
            rate = s.math("MULTIPLY_ADD", rise, -float(downward), float(extinction) + 1.3e-4)
            gone = s.math("SUBTRACT", 1.0, s.math("EXPONENT", s.math("MULTIPLY", s.math("MULTIPLY", rate, way), -1.0)))
            above = s.math("EXPONENT", s.math("MULTIPLY", depth, -float(downward)))
            parts.append(s.math("MULTIPLY", s.math("DIVIDE", gone, rate), s.math("MULTIPLY", above, float(scattering))))
        color = s.node("CombineXYZ", dict(enumerate(parts)))
        # Henyey and Greenstein's phase function, by the mean over all directions.
        cosine = s.vector("DOT_PRODUCT", s.scaled(back, -1.0), tuple(self.towards), output=1)
        base = s.math("MULTIPLY_ADD", cosine, -2.0 * FORWARD, 1.0 + FORWARD**2)
        phase = s.math("DIVIDE", 1.0 - FORWARD**2, s.math("POWER", base, 1.5))
        once = s.math("MULTIPLY", phase, self.focus_along(s, start, back, way))
        strength = s.math("MULTIPLY", s.math("ADD", once, OFTEN), self.light / (4.0 * math.pi))
        return s.node("Emission", {"Color": color, "Strength": strength})

    def focus_along(self, s, start, back, way):
        """The mean focus of light along a ray, by looks at random places, more of them near its start."""
        if self.caustics is None:
            return 1.0
        rate = float(self.extinction.min()) + 0.02
        end = s.math("MINIMUM", way, SIGHT)
        most = s.math("SUBTRACT", 1.0, s.math("EXPONENT", s.math("MULTIPLY", end, -rate)))
        chance = s.node("TexWhiteNoise", {"Vector": s.geometry("Position")}, "Value", noise_dimensions="3D")
        total = 0.0
        for look in range(LOOKS):
            share = s.math("MULTIPLY", s.math("MULTIPLY_ADD", chance, 1.0 / LOOKS, look / LOOKS), most)
            along = s.math("DIVIDE", s.math("LOGARITHM", s.math("SUBTRACT", 1.0, share), math.e), -rate)
            place = s.vector("SUBTRACT", start, s.scaled(back, along))
            total = s.math("ADD", total, self.focus_at(s, place))
        return s.math("MULTIPLY", total, 1.0 / LOOKS)

    def focus_at(self, s, place):
        """Factor by which the surface focuses light at a place, 1 under a flat one."""
        node = s.tree.nodes.new("ShaderNodeTexImage")
        node.image, node.extension = self.caustics, "EXTEND"
        s.plug(node.inputs["Vector"], s.scaled(s.vector("SUBTRACT", place, (*self.low, 0.0)), 1.0 / self.side))
        split = s.tree.nodes.new("ShaderNodeSeparateXYZ")
        s.plug(split.inputs[0], node.outputs["Color"])
        depth = s.math("SUBTRACT", self.level, s.node("SeparateXYZ", {0: place}, "Z"))
        value, above = 1.0, 0.0
        for part, below in zip(split.outputs, self.depths):
            share = s.node("MapRange", {"Value": depth, "From Min": above, "From Max": below})
            kept = s.math("MULTIPLY", s.math("SUBTRACT", 1.0, share), value)
            value, above = s.math("MULTIPLY_ADD", share, part, kept), below
        return value

    def surface(self, s):
        """The surface: a mirror and a window to what the camera sees, a filter to light."""
        glass = s.node("BsdfGlass", {"Color": self.filter(s), "Roughness": 0.0, "IOR": INDEX})
        light = s.node("BsdfTransparent", {"Color": self._passed(s)})
        return s.mix(self.seen(s), light, glass)

    def _passed(self, s):
        """The light that a shadow ray finds: what passes the surface, focused, and the water."""
        way = s.ray("Ray Length")
        start = s.vector("ADD", s.geometry("Position"), s.scaled(s.geometry("Incoming"), way))
        value = self.focus_at(s, start) if self.caustics is not None else 1.0
        return s.scaled(self.left(s, way, self.downward), s.math("MULTIPLY", value, 0.97))

    def enclose(self, low, high):
        """Walls near the end of the surface, where only water is seen; they shine as it does."""
        (x, y), reach = 0.5 * (low[:2] + high[:2]), 0.47 * float(min(high[:2] - low[:2]))
        turn = np.linspace(0.0, 2.0 * np.pi, 65)[:-1]
        ring = np.column_stack((x + reach * np.cos(turn), y + reach * np.sin(turn)))
        points = np.concatenate([np.column_stack((ring, np.full(64, z))) for z in (low[2] - 1.0, self.level + 1.5)])
        points = np.concatenate((points, [[x, y, low[2] - 1.0]]))
        k, after = np.arange(64), (np.arange(64) + 1) % 64
        triangles = np.concatenate((np.column_stack((k, after, k + 64)), np.column_stack((after, after + 64, k + 64)),
                                    np.column_stack((k, after, np.full(64, 128)))))
        mesh = bpy.data.meshes.new("Far water")
        mesh.vertices.add(len(points))
        mesh.vertices.foreach_set("co", np.float32(points).ravel())
        versions.set_triangles(mesh, triangles.astype(np.int32))
        mesh.update()
        material = bpy.data.materials.new("far water")
        material.use_nodes = True
        versions.no_lamp(material)
        s = Shading(material.node_tree)
        s.end(s.mix(self.seen(s), None, self.veil(s)))
        mesh.materials.append(material)
        thing = bpy.data.objects.new("Far water", mesh)
        thing.visible_shadow = thing.visible_diffuse = False
        bpy.context.scene.collection.objects.link(thing)


def refracted(normals, towards):
    """Directions from under a surface to the sun, by Snell's law, for unit normals [n, 3] that point out of the water."""
    cosine = np.maximum((normals * towards).sum(axis=1, keepdims=True), 1e-3)
    inside = np.sqrt(1.0 - (1.0 - cosine**2) / INDEX**2)
    return (towards - cosine * normals) / INDEX + inside * normals


def light_below(surfaces, flat, heights, low, side, splits=2):
    """Light on horizontal squares at heights, by that under a flat surface: rays through the surface, counted. A picture
    [row, column] for each height.

    flat: direction to the sun under a flat surface; the mean of a picture where the surface covers it is 1.
    """
    towards = flat * (1.0, 1.0, 0.0) * INDEX
    towards[2] = np.sqrt(max(0.0, 1.0 - (towards**2).sum()))
    width, scale = CELLS + 2, CELLS / side  # with a border for the rays that pass by
    totals = np.zeros((len(heights), width * width))
    shares = [((i + 1 / 3) / splits, (j + 1 / 3) / splits) for i in range(splits) for j in range(splits - i)]
    shares += [((i + 2 / 3) / splits, (j + 2 / 3) / splits) for i in range(splits - 1) for j in range(splits - 1 - i)]
    for points, normals, triangles in surfaces:
        a, b, c = (points[triangles[:, k]] for k in range(3))
        m, n, o = (normals[triangles[:, k]] for k in range(3))
        area = 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / len(shares)
        for u, v in shares:
            place = a + u * (b - a) + v * (c - a)
            normal = m + u * (n - m) + v * (o - m)
            normal /= np.linalg.norm(normal, axis=1, keepdims=True)
            ray = refracted(normal, np.broadcast_to(towards, normal.shape))
            x, y = (scale * (place[:, k] - low[k]) + 1.0 for k in (0, 1))
            along, across = (scale * ray[:, k] / ray[:, 2] for k in (0, 1))
            for total, height in zip(totals, heights):
                way = place[:, 2] - height
                column, row = (np.clip(at, 0.0, width - 0.5).astype(int) for at in (x - along * way, y - across * way))
                total += np.bincount(row * width + column, area, width * width)
    light = totals.reshape(-1, width, width)[:, 1:-1, 1:-1] * scale**2
    for axis in (1, 2) * 2:  # the sun is no point
        light = 0.25 * (np.roll(light, 1, axis) + 2.0 * light + np.roll(light, -1, axis))
    light[:, [0, -1]] = 1.0  # beyond the picture
    light[..., [0, -1]] = 1.0
    return np.where(light < 0.02, 1.0, np.minimum(light, 8.0))  # where no surface is, it is flat
