# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the window of a view shows, for tests that run in pvpython."""

import numpy as np
import quick
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def small_view(size, kind="RenderView"):
    """An active view of some pixels without the cross of the axes."""
    view = simple.CreateView(kind)
    view.ViewSize, view.OrientationAxesVisibility = list(size), 0
    simple.SetActiveView(view)
    return view


def colors(view):
    """The colors of the pixels, by row from the bottom, without another rendering."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(int)


def picture(view):
    """The view as it is drawn now: rows from the bottom, columns, colors."""
    simple.Render(view)
    width, height = view.ViewSize
    return colors(view).reshape(height, width, -1)


def apart(one, other, by=12):
    """The share of the pixels that differ by more than that in one of their colors."""
    return float((np.abs(one - other).max(axis=-1) > by).mean())
