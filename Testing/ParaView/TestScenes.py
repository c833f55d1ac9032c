# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: each entry is created, shows a picture, plays where it should, and comes back from a state file; what is
inside can be changed. Underwater fades into its background; the sea has foam."""
import os
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SIZE = (300, 200)


def picture(view):
    """The view as an array of rows, columns and colors."""
    simple.Render(view)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "picture.png")
        simple.SaveScreenshot(file, view)
        reader = vtkPNGReader()
        reader.SetFileName(file)
        reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(float)


def empty_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    simple.SetActiveView(view)
    return view


def show_all(scene, view):
    for port in range(scene.SMProxy.GetNumberOfOutputPorts()):
        simple.Show(simple.OutputPort(scene, port), view)


def difference(first, second):
    """Part of the pixels that differ."""
    return (np.abs(first - second).max(axis=2) > 12.0).mean()


def check(name, outputs, last_time):
    view = empty_view()
    blank = picture(view)
    simple.Delete(view)
    view = empty_view()
    scene = getattr(simple, name)()
    assert [scene.SMProxy.GetOutputPortName(k) for k in range(len(outputs))] == outputs
    show_all(scene, view)
    simple.ResetCamera(view)  # as the window does when the first source is applied
    first = picture(view)
    covered = difference(first, blank)
    assert covered > 0.3, f"{name}: the picture shows {covered:.1%}"
    assert np.unique(first.reshape(-1, 3), axis=0).shape[0] > 200, f"{name}: a flat picture"
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0], f"{name}: no view from the side"

    # Play works at once: the animation has the scene's times.
    animation = simple.GetAnimationScene()
    animation.UpdateAnimationUsingDataTimeSteps()
    end = animation.EndTime
    assert abs(end - last_time) < 1e-9, f"{name}: the animation ends at {end}"
    if last_time > 1.0:
        view.ViewTime = 1.0
        moved = difference(picture(view), first)
        assert moved > 0.002, f"{name}: {moved:.2%} of the picture moves"
        view.ViewTime = 0.0
        again = difference(picture(view), first)
        assert again < 0.001, f"{name}: {again:.2%} of the picture is another at the same time"
    else:
        moved = 0.0

    # What is inside can be changed.
    seed = scene.Seed
    scene.Seed = seed + 3
    changed = difference(picture(view), first)
    assert changed > 0.01, f"{name}: another seed changes {changed:.2%}"
    scene.Seed = seed

    # A state brings back the same picture.
    first = picture(view)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "scene.pvsm")
        simple.SaveState(file)
        simple.ResetSession()
        simple.LoadState(file)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    back = difference(picture(view), first)
    assert back < 0.002, f"{name}: {back:.2%} of the picture is another after a state was loaded"
    print(f"{name}: {covered:.0%} covered, {moved:.1%} moves in a second, {changed:.0%} changes with another seed")
    simple.ResetSession()


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


def check_murk(port, extinction):
    """An output of Underwater fades into the background by exp(-k d), d from the z-buffer."""
    view = empty_view()
    scene = simple.Underwater()
    display = simple.Show(simple.OutputPort(scene, port), view)
    simple.ResetCamera(view)
    murky = picture(view)
    display.UseShaderReplacements = 0
    clear = picture(view)
    depth = depths(view)
    background = 255.0 * np.array(view.Background)
    expected = background + (clear - background) * np.exp(-extinction * depth)[..., None]
    # Edges are mixtures of what is near and far.
    steps = np.max([np.abs(depth - np.roll(depth, step, axis)) for step in (-1, 1) for axis in (0, 1)], axis=0)
    shown = (depth < 0.9 * depth.max()) & (steps < 0.05 * depth)
    shown[[0, -1], :] = shown[:, [0, -1]] = False
    error = np.abs(expected - murky).max(axis=2)[shown]
    assert shown.mean() > 0.005 and difference(murky, clear) > 0.01, f"Underwater: output {port} does not fade"
    print(f"Underwater: output {port} fades with an error of {np.quantile(error, 0.9):.1f} in {shown.mean():.1%}")
    assert np.quantile(error, 0.9) < 3.0, f"Underwater: output {port} fades with an error"
    simple.ResetSession()


def check_foam():
    """There is some foam on the sea, but not much."""
    view = empty_view()
    simple.Show(simple.Sea(), view)
    simple.ResetCamera(view)
    white = (picture(view)[: SIZE[1] // 2].min(axis=2) > 200.0).mean()  # the lower half; rows from below
    assert 0.001 < white < 0.1, f"Sea: foam on {white:.2%}"
    simple.ResetSession()


check("Forest", ["Trees", "Ground"], 1.0)
check("SwayingForest", ["Trees", "Ground"], 59.9)
check("Sea", ["Surface"], 60.0)
check("Underwater", ["Kelp", "Bed", "Particles", "Surface"], 60.0)
check("TwinOfAPlace", ["Ground"], 1.0)
check_murk(0, 0.085)
check_murk(1, 0.085)
check_foam()
