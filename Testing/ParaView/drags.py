# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drags of the mouse: what a first look shows stays in the picture, from there and from near, and the eye on its side."""

import math

import numpy as np
import quick
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from window import picture, small_view

SIZE = (180, 150)
SHARE = 0.25  # of the width of a view, that a drag goes: 200 pixels in a window of 800
simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale")


def drag(view, interactor, dx, dy, steps):
    """Drags with the left button, in the middle of the view."""
    x, y = (int(0.5 * (size - shift)) for size, shift in zip(view.ViewSize, (dx, dy)))

    def move(share, event):
        interactor.SetEventInformation(round(x + share * dx), round(y + share * dy), 0, 0, "\0", 0, None)
        interactor.InvokeEvent(event)

    move(0.0, "LeftButtonPressEvent")
    for step in range(1, steps + 1):
        move(step / steps, "MouseMoveEvent")
    move(1.0, "LeftButtonReleaseEvent")
    simple.Render(view)


def covered(view, nothing):
    """The share of the picture that shows something: by its color, as of fog, or its depth, as in the shade."""
    is_colored = np.abs(picture(view) - nothing).max(axis=2) > 8
    capture = vtkWindowToImageFilter()
    capture.SetInput(view.GetRenderWindow())
    capture.SetInputBufferTypeToZBuffer()
    capture.ShouldRerenderOff()
    capture.Update()
    depth = vtk_to_numpy(capture.GetOutput().GetPointData().GetScalars()).reshape(is_colored.shape)
    return float((is_colored | (depth < 1.0)).mean())


def without(view):
    """The picture of a view that shows nothing."""
    shown = [one for one in view.Representations if hasattr(one, "Input") and one.Visibility]
    for one in shown:
        one.Visibility = 0
    nothing = picture(view)
    for one in shown:
        one.Visibility = 1
    return nothing


def check(name, source, **how):
    """Drags from the first look of a source, in a view of its own; see around()."""
    view = small_view(SIZE)
    simple.Show(source, view)
    view.ResetCamera()
    picture(view)
    around(name, view, **how)
    simple.Delete(view)
    for one in simple.GetSources().values():
        simple.Delete(one)


def check_after_state(source, state):
    """A drag has a level horizon after a state, in which another view is the active one."""
    view, other = small_view(SIZE), small_view(SIZE)
    simple.SetActiveView(view)
    simple.Show(source, view)
    view.ResetCamera()
    picture(view)
    simple.SetActiveView(other)
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
    view = next(one for one in simple.GetViews(viewtype="RenderView") if len(one.Representations) > 0)
    simple.SetActiveView(next(one for one in simple.GetViews(viewtype="RenderView") if one != view))
    picture(view)
    interactor = vtkGenericRenderWindowInteractor()
    view.SMProxy.SetupInteractor(interactor)
    interactor.Initialize()
    before = np.array(view.CameraPosition)
    drag(view, interactor, 40, 25, 5)
    assert np.linalg.norm(np.array(view.CameraPosition) - before) > 1.0, "the camera was not dragged"
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0], f"the horizon is rolled: up is {list(view.CameraViewUp)}"


def around(name, view, lowest=-math.inf, highest=math.inf, steps=8, directions=8, least=0.5, closers=(1.0, 2.0),
           times=1):
    """Each drag, from the first look and from nearer, leaves a share of what is shown, and the eye between two heights [m]."""
    center, focus = np.array(view.CenterOfRotation), np.array(view.CameraFocalPoint)
    distance = np.linalg.norm(np.array(view.CameraPosition) - focus)
    assert np.linalg.norm(center - focus) <= 1e-6 * distance, f"{name}: turns about {center}, looks at {focus}"
    scale = distance * math.tan(math.radians(0.5 * view.CameraViewAngle))
    assert math.isclose(view.CameraParallelScale, scale, rel_tol=1e-6), f"{name}: parallel scale {view.CameraParallelScale}"
    looks_down = (focus - np.array(view.CameraPosition))[2] < -0.999 * distance
    least = 0.0 if looks_down else least  # a map covers nothing at its edge
    interactor = vtkGenericRenderWindowInteractor()
    view.SMProxy.SetupInteractor(interactor)
    interactor.Initialize()
    interactor.SetSize(*view.ViewSize)
    nothing = without(view)
    for closer in closers:
        view.GetActiveCamera().Dolly(closer)
        before = covered(view, nothing)
        within = lowest <= view.CameraPosition[2] <= highest  # else it came there by other means, and is left alone
        place = [list(getattr(view, one)) if one != CAMERA[-1] else view.CameraParallelScale for one in CAMERA]
        for k in range(directions):
            angle = math.pi * (1.5 + 2.0 * k / directions)
            length = SHARE * view.ViewSize[0]
            for _ in range(times):
                drag(view, interactor, length * math.cos(angle), length * math.sin(angle), steps)
            share, eye = covered(view, nothing), view.CameraPosition
            where = f"{name}, {closer} times closer, dragged to {math.degrees(angle):.0f} degrees"
            assert share >= least * before, f"{where}: {share:.2f} of the picture is covered, {before:.2f} before"
            assert not within or lowest - 1e-9 <= eye[2] <= highest + 1e-9, f"{where}: the eye is at {eye}"
            for one, value in zip(CAMERA, place):
                setattr(view, one, value)
    print(f"{name}: covers {before:.2f}", flush=True)
