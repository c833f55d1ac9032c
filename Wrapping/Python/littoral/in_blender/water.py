# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Light under water: what the water absorbs and scatters, and what its moving surface focuses.

A path tracer does not find the way of sunlight through a surface that refracts it. So the sun is a lamp in the refracted
direction, the surface is clear to shadow rays, and it filters them by how much it focuses light at the place where a ray
starts: rays through the surface's triangles are followed down to three levels and counted there.
"""

import bpy
import numpy as np

from . import versions
from .shading import Shading

INDEX = 1.333
#: Cells along a side of the caustics' picture.
CELLS = 768


class Water:
    """The light of a water level. about: `extras.water` of the file."""

    def __init__(self, about, towards):
        self.level = float(about.get("level", 0.0))
        self.extinction = np.array(about.get("extinction", (0.15, 0.056, 0.046)), float)
        color = np.array(about.get("color", (0.3, 0.6, 0.7)), float)
        self.scattering = np.array(about.get("scattering", 0.6 * self.extinction * color), float)
        self.glow = np.array(about.get("glow", 0.12 * self.scattering), float)
        self.towards = refracted(np.array([[0.0, 0.0, 1.0]]), np.asarray(towards, float)[None])[0]
        self.caustics = None

    def focus(self, surfaces, low, high):
        """Count the light below surfaces, pairs of points [n, 3] and triangles [m, 3], in a box."""
        self.low, self.side = np.array(low[:2]), float(max(high[0] - low[0], high[1] - low[1]))
        deepest = self.level - low[2]
        self.depths = [0.22 * deepest, 0.55 * deepest, 0.97 * deepest]
        pixels = np.ones((CELLS, CELLS, 4), np.float32)
        for channel, depth in enumerate(self.depths):
            pixels[..., channel] = light_below(surfaces, self.towards, self.level - depth, self.low, self.side)
        image = bpy.data.images.new("Caustics", CELLS, CELLS, alpha=True, float_buffer=True)
        image.colorspace_settings.name = "Non-Color"
        image.pixels.foreach_set(pixels.ravel())
        image.pack()
        self.caustics = image

    def surface(self, s):
        """The surface: a mirror and a window to what the camera sees, a filter to light."""
        glass = s.node("BsdfGlass", {"Color": (1.0, 1.0, 1.0), "Roughness": 0.0, "IOR": INDEX})
        light = s.node("BsdfTransparent", {"Color": self._filter(s)})
        is_light = s.math("MAXIMUM", s.ray("Is Shadow Ray"), s.ray("Is Diffuse Ray"))
        is_light = s.math("MAXIMUM", is_light, s.ray("Is Volume Scatter Ray"))
        return s.mix(is_light, glass, light)

    def _filter(self, s):
        """How much light is focused where a shadow ray starts."""
        if self.caustics is None:
            return (0.97, 0.97, 0.97)
        back = s.scaled(s.geometry("Incoming"), s.ray("Ray Length"))
        start = s.vector("ADD", s.geometry("Position"), back)
        node = s.tree.nodes.new("ShaderNodeTexImage")
        node.image, node.extension = self.caustics, "EXTEND"
        shifted = s.vector("SUBTRACT", start, (*self.low, 0.0))
        s.plug(node.inputs["Vector"], s.scaled(shifted, 1.0 / self.side))
        parts = s.node("SeparateXYZ", {0: node.outputs["Color"]}).node.outputs
        depth = s.math("SUBTRACT", self.level, s.node("SeparateXYZ", {0: start}, "Z"))
        value, above = 1.0, 0.0
        for part, below in zip(parts, self.depths):
            share = s.node("MapRange", {"Value": depth, "From Min": above, "From Max": below})
            kept = s.math("MULTIPLY", s.math("SUBTRACT", 1.0, share), value)
            value, above = s.math("MULTIPLY_ADD", share, part, kept), below
        value = s.math("MULTIPLY", value, 0.97)  # what the surface mirrors is gone
        only = s.ray("Is Shadow Ray")
        return s.blend(only, (1.0, 1.0, 1.0), s.node("CombineXYZ", {0: value, 1: value, 2: value}))

    def fill(self, low, high):
        """A box of water: it absorbs, scatters forward, and glows by the light that was scattered often."""
        corners = np.array([[x, y, z] for z in (low[2], self.level) for y in (low[1], high[1]) for x in (low[0], high[0])])
        faces = np.array(((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7),
                          (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)), np.int32)
        mesh = bpy.data.meshes.new("Water")
        mesh.vertices.add(8)
        mesh.vertices.foreach_set("co", np.float32(corners).ravel())
        versions.set_triangles(mesh, faces)
        mesh.update()
        material = bpy.data.materials.new("water volume")
        material.use_nodes = True
        material.cycles.homogeneous_volume = True
        s = Shading(material.node_tree)
        most = float(self.scattering.max())
        scatter = s.node("VolumeScatter", {"Color": self.scattering / most, "Density": most, "Anisotropy": 0.55})
        taken = self.extinction - self.scattering
        absorb = s.node("VolumeAbsorption", {"Color": 1.0 - taken / taken.max(), "Density": float(taken.max())})
        strongest = float(self.glow.max())
        glow = s.node("Emission", {"Color": self.glow / strongest, "Strength": strongest})
        s.end(volume=s.node("AddShader", {0: s.node("AddShader", {0: scatter, 1: absorb}), 1: glow}))
        mesh.materials.append(material)
        thing = bpy.data.objects.new("Water", mesh)
        bpy.context.scene.collection.objects.link(thing)


def refracted(normals, towards):
    """Directions from under a surface to the sun, by Snell's law, for unit normals [n, 3] that point out of the water."""
    cosine = np.maximum((normals * towards).sum(axis=1, keepdims=True), 1e-3)
    inside = np.sqrt(1.0 - (1.0 - cosine**2) / INDEX**2)
    return (towards - cosine * normals) / INDEX + inside * normals


def light_below(surfaces, flat, height, low, side, splits=3):
    """Light on a horizontal square at a height, by that under a flat surface: rays through the surface, counted.

    flat: direction to the sun under a flat surface; the mean of the picture where the surface covers it is 1.
    """
    towards = flat * (1.0, 1.0, 0.0) * INDEX
    towards[2] = np.sqrt(max(0.0, 1.0 - (towards**2).sum()))
    total = np.zeros((CELLS, CELLS))
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
            at = place[:, :2] - ray[:, :2] * ((place[:, 2:] - height) / ray[:, 2:])
            cell = np.floor((at - low) * (CELLS / side)).astype(int)
            inside = ((cell >= 0) & (cell < CELLS)).all(axis=1)
            total += np.bincount(
                cell[inside, 1] * CELLS + cell[inside, 0], area[inside], CELLS * CELLS).reshape(CELLS, CELLS)
    light = total * (CELLS / side)**2
    for axis in (0, 1) * 2:  # the sun is no point
        light = 0.25 * (np.roll(light, 1, axis) + 2.0 * light + np.roll(light, -1, axis))
    light[[0, -1]] = 1.0  # beyond the picture
    light[:, [0, -1]] = 1.0
    return np.where(light < 0.02, 1.0, np.minimum(light, 8.0))  # where no surface is, it is flat
