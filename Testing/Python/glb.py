# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A reader of GLB files that shares nothing with the library that writes them: struct, json and numpy."""

import json
import struct

import numpy as np

TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Glb:
    """The JSON of a file as attributes, and its arrays."""

    def __init__(self, filename):
        with open(filename, "rb") as file:
            data = file.read()
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON"
        self.json = json.loads(data[20:20 + size])
        _, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0"
        self.binary = data[28 + size:]
        self.worlds = {}

    def __getattr__(self, name):
        return self.json.get(name, [])

    def view(self, index):
        view = self.bufferViews[index]
        first = view.get("byteOffset", 0)
        return memoryview(self.binary)[first:first + view["byteLength"]]

    def array(self, index):
        """The array of an accessor [tuples, parts]; normalized integers as numbers from -1 to 1."""
        accessor = self.accessors[index]
        kind, parts = TYPES[accessor["componentType"]], PARTS[accessor["type"]]
        step = self.bufferViews[accessor["bufferView"]].get("byteStride", parts * np.dtype(kind).itemsize)
        array = np.ndarray((accessor["count"], parts), kind, self.view(accessor["bufferView"]), accessor.get("byteOffset", 0),
                           (step, np.dtype(kind).itemsize))
        return array / np.iinfo(kind).max if accessor.get("normalized") else array

    def named(self, name):
        """Indices of the nodes with a name."""
        return [k for k, node in enumerate(self.nodes) if node.get("name") == name]

    def child(self, node, *names):
        """The index of the node at a path of names below another one."""
        for name in names:
            node, = [k for k in self.nodes[node].get("children", []) if self.nodes[k].get("name") == name]
        return node

    def parents(self):
        """The parent of each node; -1 for those that have none."""
        parents = [-1] * len(self.nodes)
        for index, node in enumerate(self.nodes):
            for child in node.get("children", []):
                parents[child] = index
        return parents

    def primitive(self, node, index=0):
        return self.meshes[self.nodes[node]["mesh"]]["primitives"][index]

    def attribute(self, node, name, index=0):
        return self.array(self.primitive(node, index)["attributes"][name])

    def matrices(self, time=None):
        """The place of each node in the world, as it is without the animation or at a time of it."""
        if time in self.worlds:
            return self.worlds[time]
        moved = {}
        if time is not None:
            for animation in self.animations:
                frames = {s["input"]: self.array(s["input"])[:, 0] for s in animation["samplers"]}
                for channel in animation["channels"]:
                    sampler = animation["samplers"][channel["sampler"]]
                    target, at = channel["target"], frames[sampler["input"]]
                    play = smooth if sampler["interpolation"] == "CUBICSPLINE" else between
                    moved[target["node"], target["path"]] = play(at, self.array(sampler["output"]), time, target["path"])
        parents, found = self.parents(), {}

        def own(index):
            node = self.nodes[index]
            turn = moved.get((index, "rotation"), node.get("rotation", (0, 0, 0, 1)))
            shift = moved.get((index, "translation"), node.get("translation", (0, 0, 0)))
            return matrix(shift, turn, node.get("scale", (1, 1, 1)))

        for first in range(len(self.nodes)):
            chain = [first]
            while chain[-1] not in found and parents[chain[-1]] >= 0:
                chain.append(parents[chain[-1]])
            for index in reversed(chain):
                if index not in found:
                    above = found[parents[index]] if parents[index] >= 0 else np.eye(4)
                    found[index] = above @ own(index)
        self.worlds[time] = [found[k] for k in range(len(self.nodes))]
        return self.worlds[time]

    def skinned(self, node, time, index=0):
        """Where a skin has its vertices at a time, in the coordinates of Littoral: z up."""
        skin, worlds = self.skins[self.nodes[node]["skin"]], self.matrices(time)
        inverses = self.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
        joints = np.array([worlds[k] for k in skin["joints"]]) @ inverses
        points = self.attribute(node, "POSITION", index).astype(np.float64)
        points = np.column_stack((points, np.ones(len(points))))
        ids, weights = self.attribute(node, "JOINTS_0", index), self.attribute(node, "WEIGHTS_0", index)
        at = sum(weights[:, k, None] * np.einsum("nij,nj->ni", joints[ids[:, k]], points) for k in range(4))
        return np.column_stack((at[:, 0], -at[:, 2], at[:, 1]))  # y up


def matrix(shift, turn, scale):
    """Translation, rotation (quaternion x, y, z, w) and scale, in this order from the left."""
    x, y, z, w = np.asarray(turn, np.float64) / np.linalg.norm(turn)
    made = np.eye(4)
    made[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    made[:3, :3] *= np.asarray(scale)
    made[:3, 3] = shift
    return made


def between(times, values, time, path):
    """The value at a time: the straight way between two samples, or the shortest turn, at a constant rate."""
    after = int(np.clip(np.searchsorted(times, time, side="left"), 1, len(times) - 1)) if len(times) > 1 else 0
    before = max(0, after - 1)
    share = np.clip((time - times[before]) / (times[after] - times[before]), 0.0, 1.0) if after else 0.0
    a, b = values[before], values[after]
    if path != "rotation":
        return (1.0 - share) * a + share * b
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    b = -b if a @ b < 0.0 else b
    angle = 2.0 * np.arctan2(np.linalg.norm(a - b), np.linalg.norm(a + b))
    return a if angle < 1e-9 else (np.sin((1.0 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


def smooth(times, values, time, path):
    """The value at a time of a cubic curve through samples (slope before, value, slope after), by its four points."""
    after = int(np.clip(np.searchsorted(times, time, side="left"), 1, len(times) - 1))
    length = times[after] - times[after - 1]
    share = np.clip((time - times[after - 1]) / length, 0.0, 1.0)
    (_, a, leaving), (arriving, b, _) = values.reshape(len(times), 3, -1)[after - 1:after + 1].astype(np.float64)
    points = [a, a + leaving * length / 3.0, b - arriving * length / 3.0, b]
    while len(points) > 1:
        points = [(1.0 - share) * p + share * q for p, q in zip(points, points[1:])]
    return points[0] / np.linalg.norm(points[0]) if path == "rotation" else points[0]
