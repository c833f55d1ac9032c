# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Node trees of shaders, written as nested calls."""


class Shading:
    """A tree of shader nodes. Inputs of its functions are outputs of others, or values."""

    def __init__(self, tree):
        self.tree, self.left = tree, None
        tree.nodes.clear()

    def node(self, kind, inputs=None, output=0, **settings):
        """The output of a new node. inputs: outputs or values by the name or index of an input."""
        node = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for name, value in (inputs or {}).items():
            self.plug(node.inputs[name], value)
        return node.outputs[output]

    def plug(self, socket, value):
        if hasattr(value, "is_output"):
            self.tree.links.new(value, socket)
        elif hasattr(socket.default_value, "__len__"):
            socket.default_value = (*value, 1.0)[:len(socket.default_value)]
        else:
            socket.default_value = value

    def math(self, operation, *values):
        return self.node("Math", dict(enumerate(values)), operation=operation)

    def vector(self, operation, a, b=(0.0, 0.0, 0.0), output=0):
        return self.node("VectorMath", {0: a, 1: b}, output, operation=operation)

    def scaled(self, a, factor):
        return self.node("VectorMath", {0: a, "Scale": factor}, operation="SCALE")

    def multiply(self, a, b):
        """The product of two colors."""
        return self.vector("MULTIPLY", a, b)

    def bsdf(self, kind, color, **inputs):
        """A shader that reflects or passes light; of its color is left what the water before it leaves."""
        color = color if self.left is None else self.multiply(color, self.left)
        return self.node("Bsdf" + kind, {"Color": color, **inputs})

    def blend(self, factor, a, b):
        """A color from a to b as the factor goes from 0 to 1."""
        return self.node("MixRGB", {"Fac": factor, "Color1": a, "Color2": b})

    def mix(self, factor, a, b):
        """A shader from a to b as the factor goes from 0 to 1; one that is None reflects nothing."""
        given = {index: shader for index, shader in ((1, a), (2, b)) if shader is not None}
        return self.node("MixShader", {"Fac": factor, **given})

    def attribute(self, name, output="Color", kind="GEOMETRY"):
        return self.node("Attribute", output=output, attribute_type=kind, attribute_name=name)

    def geometry(self, output):
        return self.node("NewGeometry", output=output)

    def ray(self, output):
        return self.node("LightPath", output=output)

    def noise(self, place, scale, detail=3.0, rough=0.55):
        """Noise about a half, from 0 to 1, of a scale [1/m]."""
        return self.node("TexNoise", {"Vector": place, "Scale": scale, "Detail": detail, "Roughness": rough}, "Fac")

    def ramp(self, value, low, high, to_low=0.0, to_high=1.0):
        """A value from low to high becomes one from to_low to to_high, smooth at both."""
        return self.node("MapRange", {"Value": value, "From Min": low, "From Max": high, "To Min": to_low,
                                      "To Max": to_high}, interpolation_type="SMOOTHSTEP")

    def end(self, shader=None, volume=None):
        """Give the tree its output."""
        node = self.tree.nodes.new("ShaderNodeOutputMaterial")
        for name, value in (("Surface", shader), ("Volume", volume)):
            if value is not None:
                self.tree.links.new(value, node.inputs[name])
