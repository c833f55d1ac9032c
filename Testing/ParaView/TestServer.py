# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
# run-with: pvpython tier=all args=export
"""Before a server that renders, textured blocks, a view that is dragged and a scene are what they are without one; with
`export`, an exported scene has the bytes of TestExportScene.

TestServers has more ranks, and pictures that the client renders, TestScenesWithServer more scenes.
"""

import sys

import quick
import TestDragging
import TestScenesWithServer
import TestTextures
from paraview import servermanager, simple
from server import connected

PORT = 21533


def check_textures(where):
    view, squares, shown, _ = TestTextures.scene()
    TestTextures.check_colors(view, squares, shown, where)


def check_drag(where):
    view, _ = TestDragging.scene()
    TestDragging.check_drag(view, where)


def check(where, threshold):
    """Views stay: VTK 9.6 warns of textures when a view of blocks ends before its server, textured or not."""
    simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = threshold
    for one in (check_textures, check_drag):
        one(where)


def main():
    exports = "export" in sys.argv[1:] and hasattr(servermanager.writers, "GLTFSceneWriter")
    if exports:
        import TestExportScene

        scene = TestExportScene.wood("alone.glb")
    sea = TestScenesWithServer.pictures("Sea")
    with connected(PORT):
        TestScenesWithServer.compare("Sea", "by the server", sea)
        if exports:
            assert TestExportScene.wood("remote.glb") == scene, "the server writes another scene"
            simple.ResetSession()
        check("rendered by the server", 0.0)


if __name__ == "__main__":
    main()
