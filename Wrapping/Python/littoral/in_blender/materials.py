# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials by the kind that the scene file gives them: bark, leaf, grass, blade, ground, water, particle, plain."""

import os
import tempfile

import bpy
import numpy as np

from . import versions
from .shading import Shading

#: Shares of light that thin tissue passes, of what it does not mirror.
PASSED = {"leaf": 0.42, "grass": 0.40, "blade": 0.45}
#: Shares that it mirrors, and the roughness.
GLOSS = {"leaf": (0.05, 0.42), "grass": (0.03, 0.5), "blade": (0.06, 0.35)}
#: Light that went through a leaf has another color than what it reflects.
THROUGH = {"leaf": (1.35, 1.45, 0.55), "grass": (1.3, 1.4, 0.6), "blade": (1.25, 1.05, 0.55)}

#: The share of a leaf that its mask may cut away without being a hole.
HEM = 0.03
#: Even places in a triangle, by their shares of its corners.
WITHIN = np.array([(i + 1 / 3, j + 1 / 3, 20 - 2 / 3 - i - j) for i in range(20) for j in range(20 - i)]) / 20.0


class Materials:
    """The materials of a file, made when they are first asked for. air: haze or None. water: its light or None."""

    def __init__(self, file, air=None, water=None):
        self.file, self.air, self.water = file, air, water
        self.made, self.pictures = {}, {}

    def get(self, index):
        if index not in self.made:
            self.made[index] = self._make(index)
        return self.made[index]

    def _make(self, index):
        about = self.file.list("materials")[index] if index is not None else {}
        kind = self.file.kind(index)
        material = bpy.data.materials.new(about.get("name", kind))
        material["kind"] = kind
        material.use_nodes = True
        versions.no_lamp(material)
        s = Shading(material.node_tree)
        s.left = self.water.filter(s) if self.water else None
        base, alpha = self._base(s, index, about, kind)

        def make(is_seen=True):
            return self._surface(s, kind, base, is_seen)

        medium = self.water or self.air
        shader = medium.before(s, make) if medium and kind != "sky" else make()
        if alpha is not None:
            clear = s.node("BsdfTransparent", {"Color": (1.0, 1.0, 1.0)})
            # A shadow ray asks for holes alone: it need not compute what a leaf looks like.
            shader = s.mix(s.math("GREATER_THAN", alpha, 0.5), clear, s.mix(s.ray("Is Shadow Ray"), shader, None))
        s.end(shader)
        return material

    def _surface(self, s, kind, base, is_seen):
        """The shader of a kind with a base color. What is not seen, but scatters light to what is, needs neither gloss nor
        bumps."""
        if kind in PASSED:
            return thin(s, kind, base, is_seen)
        if kind == "water":
            return self.water.surface(s) if self.water else sea(s)
        if kind == "ground":
            return ground(s, base, self.water is not None, is_seen)
        return {"bark": bark, "particle": particle}.get(kind, plain)(s, base)

    def _base(self, s, index, about, kind):
        """The base color (vertices, picture, tint), and the picture's alpha or None."""
        color = s.attribute("Color")
        surface = about.get("pbrMetallicRoughness", {})
        if "baseColorFactor" in surface:
            color = s.multiply(color, surface["baseColorFactor"][:3])
        alpha, picture = None, surface.get("baseColorTexture", {}).get("index")
        if picture is not None:
            node = s.tree.nodes.new("ShaderNodeTexImage")
            node.image, node.extension = self._picture(picture), "EXTEND"
            color, alpha = s.multiply(color, node.outputs["Color"]), node.outputs["Alpha"]
        if kind in ("leaf", "grass", "blade"):
            tint = s.attribute("tint", "Vector", "INSTANCER")
            tinted = s.math("GREATER_THAN", s.vector("LENGTH", tint, output=1), 1e-6)
            color = s.multiply(color, s.blend(tinted, (1.0, 1.0, 1.0), tint))
        elif kind == "particle":
            color = s.attribute("tint", "Vector")
        if about.get("alphaMode") == "MASK" and picture is not None and not self._has_holes(index, self._picture(picture)):
            alpha = None
        return color, alpha if about.get("alphaMode") in ("MASK", "BLEND") else None

    def _has_holes(self, index, image):
        """Whether a mask cuts away more than a hem of what the meshes of a material have of the picture. Rays end at what
        has no holes: a kelp is cheap to draw then."""
        width, height = image.size
        texels = np.empty(width * height * 4, np.float32)
        image.pixels.foreach_get(texels)
        alpha = texels.reshape(height, width, 4)[..., 3]
        if alpha.min() > 0.5:
            return False
        parts = [part for mesh in self.file.list("meshes") for part in mesh["primitives"] if part.get("material") == index]
        for part in parts:
            at = self.file.array(part["attributes"]["TEXCOORD_0"])
            corners = np.unique(np.round(at[self.file.array(part["indices"]).reshape(-1, 3)].reshape(-1, 6), 3), axis=0)
            u, v = np.einsum("cp,kpi->ick", WITHIN, corners.reshape(-1, 3, 2))
            column, row = np.int32(np.clip(u, 0.0, 0.999) * width), np.int32(np.clip(1.0 - v, 0.0, 0.999) * height)
            if (alpha[row, column] > 0.5).mean() < 1.0 - HEM:
                return True
        return False

    def _picture(self, texture):
        """The picture of a texture, packed into the scene."""
        if texture not in self.pictures:
            with tempfile.TemporaryDirectory() as folder:
                name = os.path.join(folder, f"picture-{texture}.png")
                with open(name, "wb") as file:
                    file.write(self.file.picture(texture))
                image = bpy.data.images.load(name)
                image.pack()
            self.pictures[texture] = image
        return self.pictures[texture]


def thin(s, kind, base, is_seen):
    """Thin tissue: it reflects, passes and, where it is seen, mirrors light."""
    passed = s.bsdf("Translucent", s.multiply(base, THROUGH[kind]))
    matt = s.mix(PASSED[kind], s.bsdf("Diffuse", base), passed)
    if not is_seen:
        return matt
    share, roughness = GLOSS[kind]
    gloss = s.bsdf("Glossy", (0.9, 0.95, 1.0), Roughness=roughness)
    edge = s.node("LayerWeight", {"Blend": 0.25}, "Fresnel")
    return s.mix(s.math("MULTIPLY", edge, 2.0 * share), matt, gloss)


def bark(s, base):
    """Wood with furrows along the trunk."""
    place = s.node("TexCoord", output="Object")
    furrow = s.noise(s.multiply(place, (1.0, 1.0, 0.22)), 22.0, 3.0)
    color = s.multiply(base, s.blend(s.ramp(furrow, 0.35, 0.65), (0.45, 0.43, 0.40), (1.25, 1.22, 1.18)))
    return s.bsdf("Diffuse", color)


def ground(s, base, under_water, is_seen):
    """Ground of the base color, with patches, litter and, where it is steep, rock; under water, sand as it is."""
    place = s.geometry("Position")
    fine, coarse = s.noise(place, 7.0, 6.0, 0.62), s.noise(place, 0.55, 4.0)
    if under_water:
        color = s.multiply(base, s.blend(s.ramp(fine, 0.3, 0.7), (0.80, 0.79, 0.77), (1.12, 1.12, 1.10)))
        depth, distance = 0.5, 0.02
    else:
        patches = s.noise(place, 0.06, 3.0)
        # Moss and litter on what is flat, by large patches and fine grain together.
        grain = s.math("MULTIPLY_ADD", fine, 0.8, s.math("MULTIPLY", coarse, 0.7))
        dark = s.multiply(base, (0.50, 0.46, 0.40))
        dry = s.multiply(base, (1.50, 1.28, 0.85))
        color = s.blend(s.ramp(grain, 0.55, 1.0), dark, base)
        color = s.blend(s.math("MULTIPLY", s.ramp(patches, 0.45, 0.65), s.ramp(fine, 0.4, 0.7)), color, dry)
        up = s.node("SeparateXYZ", {0: s.geometry("True Normal")}, "Z")
        bare = s.ramp(s.math("MULTIPLY_ADD", coarse, 0.25, up), 0.98, 0.86)
        rock = s.blend(s.ramp(fine, 0.3, 0.7), (0.10, 0.095, 0.085), (0.30, 0.28, 0.25))
        color = s.blend(bare, color, rock)
        depth, distance = 0.9, 0.25
    if not is_seen:
        return s.bsdf("Diffuse", color)
    height = s.math("MULTIPLY_ADD", fine, 0.35, s.math("MULTIPLY", coarse, 1.0))
    bump = s.node("Bump", {"Strength": depth, "Distance": distance, "Height": height}, "Normal")
    return s.bsdf("Diffuse", color, Normal=bump)


def particle(s, base):
    """Specks that scatter light to all sides."""
    return s.mix(0.5, s.bsdf("Diffuse", base), s.bsdf("Translucent", base))


def sea(s):
    """The sea from above: what it mirrors, and the light of the water below."""
    mirror = s.bsdf("Glossy", (1.0, 1.0, 1.0), Roughness=0.06)
    below = s.bsdf("Diffuse", (0.004, 0.030, 0.045))
    return s.mix(s.node("Fresnel", {"IOR": 1.333}), below, mirror)


def plain(s, base):
    node = s.tree.nodes.new("ShaderNodeBsdfPrincipled")
    versions.roughness_specular(node, 0.7, 0.2)
    s.plug(node.inputs["Base Color"], base)
    return node.outputs[0]
