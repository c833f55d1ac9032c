# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""The depth of Underwater moves its bed, its particles and its eyes along, also by undo and redo; particles fade into the
color of their murk."""

import numpy as np
import quick
from littoral.seawater import GREY_EXTINCTION
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMUndoStack, vtkSMUndoStackBuilder
from states import visible
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkPointGaussianMapper, vtkWindowToImageFilter
from window import apart, picture, small_view

#: A VTK that can draw points as ellipses hands on no depth to their fragments, which then fade as at 1 m: from ParaView
#: 5.13 and VTK 9.4 on.
POINTS_FADE = not hasattr(vtkPointGaussianMapper, "SetAnisotropic")


def depths(view):
    """The depth of each pixel in the view [m], from the z-buffer."""
    capture = vtkWindowToImageFilter()
    capture.SetInput(view.GetRenderWindow())
    capture.SetInputBufferTypeToZBuffer()
    capture.ShouldRerenderOff()
    capture.Update()
    image = capture.GetOutput()
    width, height, _ = image.GetDimensions()
    z = 2.0 * vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width).astype(float) - 1.0
    near, far = view.GetActiveCamera().GetClippingRange()
    return 2.0 * near * far / (far + near - z * (far - near))


def check_murk(part):
    """Particles, the only part that is shown, fade into the color of their murk by exp(-k d), d from the z-buffer."""
    view = simple.GetActiveView()
    view.UseColorPaletteForBackground = 0
    view.Background = [0.09, 0.38, 0.44]
    view.ViewSize = [300, 200]
    for name in visible(view):
        simple.Hide(simple.FindSource(name), view)
    display = simple.Show(simple.FindSource(part), view)
    if part == "Particles":
        # Few, so that they do not touch, and large enough to be measured.
        simple.FindSource("Water").Density = 0.04
        display.GaussianRadius = 40.0 * display.GaussianRadius
    murky = picture(view)
    display.UseShaderReplacements = 0
    display.ShaderPreset = "Sphere"
    clear = picture(view)
    depth = depths(view)
    background = 255.0 * np.array(view.Background)
    expected = background + (clear - background) * np.exp(-GREY_EXTINCTION * depth)[..., None]
    # Edges are mixtures of what is near and far.
    steps = np.max([np.abs(depth - np.roll(depth, step, axis)) for step in (-2, -1, 1, 2) for axis in (0, 1)], axis=0)
    shown = (depth < 0.9 * depth.max()) & (steps < 0.05 * depth)
    shown &= clear.max(axis=2) < 250.0  # what is brighter than white is cut off in the clear picture alone
    shown[[0, 1, -2, -1], :] = shown[:, [0, 1, -2, -1]] = False
    error = np.abs(expected - murky).max(axis=2)[shown]
    assert shown.mean() > 0.005 and apart(murky, clear) > 0.01, f"Underwater: {part} does not fade"
    print(f"Underwater: {part} fades with an error of {np.quantile(error, 0.9):.1f} in {shown.mean():.1%}")
    assert np.quantile(error, 0.9) < 3.0, f"Underwater: {part} fades with an error"


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
    if POINTS_FADE:
        check_murk("Particles")
    vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(None)
