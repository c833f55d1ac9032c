# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""A forest stays in the view while the camera is dragged, above ParaView's threshold for levels of detail of its own.

Each interactive picture is compared with the still picture of the same camera, with and without FollowCamera; in TestServer
rendered by a server. With a lower InteractiveDetail, levels only become coarser while dragging, and are full at rest.
"""

import numpy as np
import quick
from paraview import simple
from window import colors, small_view

STEP = 12.0  # of the camera [m]


def apart(one, other):
    """Share of the pixels of two pictures that differ."""
    return float((np.abs(one - other).sum(axis=1) > 12).mean())


def scene():
    """A view of a forest, whose nearest trees have few leaves, and the forest."""
    view = small_view([160, 100])
    view.ImageReductionFactor = 1  # a server of several ranks sends smaller interactive pictures
    sites = simple.QuadratPoints(Size=[400.0, 400.0], Quadrats=[20, 20])
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=200, MainBranches=8, Orders=1)
    forest = simple.PlantScatter(Sites=sites, Prototypes=[tree], NearDistance=30.0, FarDistance=150.0)
    shown = simple.Show(forest, view)
    assert shown.Representation == "Full Surface", shown.Representation
    assert forest.InteractiveDetail < 1.0
    forest.InteractiveDetail = 1.0
    simple.Render(view)
    return view, forest


def stand(view, step):
    """Put the camera in front of the forest."""
    view.CameraPosition = [200.0 + STEP * step, -40.0, 12.0]
    view.CameraFocalPoint = [200.0, 200.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def check_drag(view, where):
    """The same pictures while dragging and at rest."""
    empty = colors(view)[-1]
    view.LODThreshold = 0.0
    stand(view, 0)
    simple.Render(view)  # who stands lower than a first drag goes stays there
    moving = []
    for step in range(3):
        stand(view, step)
        view.SMProxy.InteractiveRender()
        moving.append(colors(view))
    for step, seen in enumerate(moving):
        stand(view, step)
        simple.Render(view)
        still = colors(view)
        covered = float((np.abs(still - empty).sum(axis=1) > 12).mean())
        assert covered > 0.1, f"{where}: the forest covers {covered:.3f} of the still picture"
        assert apart(seen, still) < 0.01, f"{where}, step {step}: {apart(seen, still):.3f} of the pixels differ"


def level_counts(forest):
    """Plants shown at each level."""
    fields = forest.GetDataInformation().DataInformation.GetFieldDataInformation()
    return [int(fields.GetArrayInformation(f"Plants{level}").GetComponentRange(0)[0])
            for level in ("High", "Medium", "Low")]


def check_coarser(view, forest, where, ranks):
    """Fewer plants in the first levels while dragging, the same in all; the forest covers as much of the view."""
    forest.InteractiveDetail = 0.4
    empty = colors(view)[-1]
    for step in range(2):
        stand(view, step)
        simple.Render(view)
        full, still = level_counts(forest), colors(view)
        stand(view, step + 0.5)
        view.SMProxy.InteractiveRender()
        coarse, moving = level_counts(forest), colors(view)
        stand(view, step)
        simple.Render(view)
        assert level_counts(forest) == full, f"{where}: {level_counts(forest)} at rest, {full} before"
        shares = [float((np.abs(seen - empty).sum(axis=1) > 12).mean()) for seen in (moving, still)]
        assert shares[0] > 0.7 * shares[1], f"{where}: {shares[0]:.3f} covered while dragging, {shares[1]:.3f} at rest"
        if ranks > 1:
            continue  # each rank has the counts of its own plants
        assert coarse[0] <= full[0] and coarse[0] + coarse[1] < full[0] + full[1], f"{where}: {coarse} of {full}"
        assert abs(sum(coarse) - sum(full)) <= 5, f"{where}: {sum(coarse)} plants of {sum(full)}"


def check_here(where, threshold=None, ranks=1):
    """Following and not."""
    view, forest = scene()
    if threshold is not None:
        view.RemoteRenderThreshold = threshold
    check_drag(view, f"{where}, following")
    check_coarser(view, forest, where, ranks)
    forest.FollowCamera = 0
    check_drag(view, f"{where}, not following")


if __name__ == "__main__":
    check_here("batch")
