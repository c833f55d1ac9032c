# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""Landscape Light has the same picture drawn by a server of one and of two ranks, by the client before them, and by a
client alone; what is selected is the same, and what is hidden leaves the view as it was. TestLightOnRanks has shadows
that cross ranks."""

import shutil

import numpy as np
import quick
import TestLandscapeLight
from paraview import simple
from server import connected
from window import picture

PORT = 21547
BY_SERVER, BY_CLIENT = 0.0, 1e5  # thresholds [MB]


def pictures(threshold):
    """The scene without the light, with it, from another place, while the camera moves, and without it again."""
    simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = threshold
    view, ground, _ = TestLandscapeLight.scene()
    light = simple.LandscapeLight()
    found = {"plain": picture(view)}
    simple.Show(light, view, **TestLandscapeLight.SUN)
    found["lit"] = picture(view)
    TestLandscapeLight.look(view, (2.0, -9.0, 2.0))
    found["level"] = picture(view)
    view.SMProxy.InteractiveRender()
    TestLandscapeLight.look(view)
    TestLandscapeLight.check_selection(view, ground, light)
    found["after a selection"] = picture(view)
    simple.Hide(light, view)
    found["hidden"] = picture(view)
    simple.Delete(view)
    return found


def compare(seen, wanted, where):
    for name, one in seen.items():
        apart = np.abs(one - wanted[name]).max(axis=-1)
        print(f"{name}, {where}: {(apart > 1).mean():.2%} of the picture are another, by {apart.max()}", flush=True)
        assert (apart > 1).mean() < 0.0005, f"{name}: another picture {where}"


def main():
    alone = pictures(BY_CLIENT)
    assert np.array_equal(alone["plain"], alone["hidden"])
    simple.ResetSession()
    for ranks in (1, 2) if shutil.which("mpirun") else (1,):
        with connected(PORT, ranks):
            for threshold, by in ((BY_SERVER, "the server"), (BY_CLIENT, "the client")):
                compare(pictures(threshold), alone, f"by {by}, {ranks} ranks")


if __name__ == "__main__":
    main()
