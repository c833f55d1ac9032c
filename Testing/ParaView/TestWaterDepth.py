# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""The depth of Underwater moves its bed, its particles and its eyes along, also by undo and redo."""

import numpy as np
import quick
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMUndoStack, vtkSMUndoStackBuilder
from window import picture, small_view


def sight(view=None):
    """Heights of the eye and of what it looks at [m]."""
    camera = (view or simple.GetActiveView()).GetActiveCamera()
    return np.array([camera.GetPosition()[2], camera.GetFocalPoint()[2]])


def another_view(eye, focus):
    """Another view of the water at those heights [m], which does not become the active one."""
    active, view = simple.GetActiveView(), small_view((60, 40))
    simple.Show(simple.FindSource("Particles"), view)
    view.CameraPosition, view.CameraFocalPoint = [0.0, -5.0, eye], [0.0, 0.0, focus]
    simple.SetActiveView(active)
    return view


def check_depth(depth, seen, under, over):
    """The bed, the particles and the sight, in depths of the water, are those of a depth; so is that of another view under
    water, and not that of one over it."""
    water = simple.FindSource("Water")
    simple.FindSource("Relief").UpdatePipeline()
    low, high = simple.FindSource("Relief").PointData["Elevation"].GetRange()
    assert low < -depth < high < 0.0 and np.isclose(water.Bounds[4], -depth), f"a bed from {low} to {high} m"
    for what, here, there in (("a", sight(), depth * seen), ("another", sight(under), depth * np.array([-0.5, -0.75])),
                              ("an upper", sight(over), np.array([2.0, -3.0]))):
        assert np.allclose(here, there), f"{what} sight from {here} m at {depth} m"


def check_depths():
    """Parts and camera go along with the depth of the water, also by undo and redo."""
    seen = sight() / 6.0
    others = another_view(-3.0, -4.5), another_view(2.0, -3.0)
    builder = vtkSMProxyManager.GetProxyManager().GetUndoStackBuilder()
    stack = builder.GetUndoStack()
    builder.Begin("Apply")
    simple.FindSource("Underwater1").WaterDepth = 12.0
    builder.End()
    builder.PushToStack()
    check_depth(12.0, seen, *others)
    for act, depth in ((stack.Undo, 6.0), (stack.Redo, 12.0)):
        act()
        servermanager.ProxyManager().SMProxyManager.UpdateRegisteredProxiesInOrder(False)
        check_depth(depth, seen, *others)
    simple.FindSource("Underwater1").WaterDepth = 6.0
    check_depth(6.0, seen, *others)
    for view in others:
        simple.Delete(view)


if __name__ == "__main__":
    undo = vtkSMUndoStackBuilder()  # from before the proxies: it tells what is another
    undo.SetUndoStack(vtkSMUndoStack())
    vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(undo)
    small = small_view((60, 40))
    simple.Show(simple.Underwater(), small)
    picture(small)
    check_depths()
    vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(None)
