# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a scene file (.glb) holds."""

import json
import struct


def scene_of(file):
    """The JSON of a scene file."""
    with open(file, "rb") as opened:
        data = opened.read()
    assert struct.unpack_from("<I", data, 8)[0] == len(data), "the file is not whole"
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


def below_root(scene):
    """The names below the root node."""
    root, = scene["scenes"][0]["nodes"]
    return sorted(scene["nodes"][k]["name"] for k in scene["nodes"][root]["children"])
