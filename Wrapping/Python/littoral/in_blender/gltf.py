# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Binary files of glTF 2.0, by Python's standard library and NumPy alone.

It reads what vtkGLTFSceneWriter writes: nodes, instances, meshes, materials, pictures, camera and sun.
"""

import json
import struct

import numpy as np

TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
INSTANCING, LIGHTS = "EXT_mesh_gpu_instancing", "KHR_lights_punctual"
#: Rotation from y up, as in glTF, to z up.
Z_UP = np.array(((1.0, 0, 0, 0), (0, 0, -1.0, 0), (0, 1.0, 0, 0), (0, 0, 0, 1.0)))


class File:
    """A .glb file: `json`, its description, and the arrays of its accessors. Raises ValueError if it is none."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        if len(data) < 20 or data[:4] != b"glTF" or struct.unpack_from("<I", data, 8)[0] != len(data):
            raise ValueError(f"{path}: no whole file of glTF binary")
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.bytes = memoryview(data)[28 + length:]

    def list(self, name):
        return self.json.get(name, [])

    @property
    def scene(self):
        return self.json["scenes"][self.json.get("scene", 0)]

    @property
    def extras(self):
        return self.scene.get("extras", {})

    def array(self, accessor):
        """The values of an accessor [element, component]; normalized integers as numbers up to 1."""
        about = self.json["accessors"][accessor]
        parts, kind = PARTS[about["type"]], np.dtype(TYPES[about["componentType"]])
        if "bufferView" not in about:
            return np.zeros((about["count"], parts), kind)
        view = self.json["bufferViews"][about["bufferView"]]
        first = view.get("byteOffset", 0) + about.get("byteOffset", 0)
        stride = view.get("byteStride", parts * kind.itemsize)
        values = np.ndarray(
            (about["count"], parts), kind, self.bytes, first, (stride, kind.itemsize))
        return values / np.float32(np.iinfo(kind).max) if about.get("normalized") else values

    def picture(self, texture):
        """The bytes of a texture's picture, a PNG."""
        image = self.json["images"][self.json["textures"][texture]["source"]]
        view = self.json["bufferViews"][image["bufferView"]]
        first = view.get("byteOffset", 0)
        return bytes(self.bytes[first:first + view["byteLength"]])

    def kind(self, material):
        """The kind of a material by its index; that of none is plain."""
        if material is None:
            return "plain"
        return self.json["materials"][material].get("extras", {}).get("kind", "plain")

    def nodes(self):
        """All nodes of the scene, each with its matrix in a world where z is up."""
        left = [(index, Z_UP) for index in reversed(self.scene["nodes"])]
        while left:
            index, above = left.pop()
            node = self.json["nodes"][index]
            matrix = above @ local_matrix(node)
            left += [(child, matrix) for child in reversed(node.get("children", []))]
            yield node, matrix

    def instances(self, node):
        """Translations, rotations (x, y, z, w), scales and tints of a node's instances; None if it has none."""
        attributes = node.get("extensions", {}).get(INSTANCING, {}).get("attributes")
        if attributes is None:
            return None
        found = {name: self.array(index).astype(np.float64) for name, index in attributes.items()}
        count = len(next(iter(found.values())))
        absent = {"TRANSLATION": (0, 0, 0), "ROTATION": (0, 0, 0, 1), "SCALE": (1, 1, 1), "_TINT": (1, 1, 1)}
        return [found.get(name, np.tile(np.float64(value), (count, 1))) for name, value in absent.items()]

    def sun(self):
        """The direction towards the sun, its illuminance [lx] and its color; None if there is none."""
        for node, matrix in self.nodes():
            light = node.get("extensions", {}).get(LIGHTS, {}).get("light")
            if light is not None:
                about = self.json["extensions"][LIGHTS]["lights"][light]
                if about["type"] == "directional":
                    towards = matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])
                    return towards, about.get("intensity", 1.0), about.get("color", [1.0, 1.0, 1.0])
        return None


def local_matrix(node):
    """The matrix of a node against the one above it."""
    if "matrix" in node:
        return np.reshape(node["matrix"], (4, 4)).T
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(np.array([node.get("rotation", (0, 0, 0, 1))], float))[0] * node.get("scale", (1, 1, 1))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def rotation(quaternions):
    """Matrices [n, 3, 3] of quaternions [n, 4] (x, y, z, w)."""
    x, y, z, w = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    return np.moveaxis(np.array((
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))), -1, 0)


def euler(quaternions):
    """Angles [n, 3] of the turns about x, then y, then z, of quaternions (x, y, z, w)."""
    m = rotation(quaternions)
    return np.column_stack((
        np.arctan2(m[:, 2, 1], m[:, 2, 2]), np.arcsin(np.clip(-m[:, 2, 0], -1.0, 1.0)),
        np.arctan2(m[:, 1, 0], m[:, 0, 0])))
