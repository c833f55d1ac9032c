# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of scripts that draw pictures and films."""

import tempfile


def folder_size_frames(arguments):
    """Read `[FOLDER [WIDTH HEIGHT [FRAMES]]] [--quick]` as keywords; default: a new temporary folder, 960 x 540, 0."""
    plain = [word for word in arguments if word != "--quick"]
    return {"folder": plain[0] if plain else tempfile.mkdtemp(prefix="littoral-"),
            "size": tuple(map(int, plain[1:3])) or (960, 540),
            "frames": int(plain[3]) if len(plain) > 3 else 0,
            "quick": "--quick" in arguments}
