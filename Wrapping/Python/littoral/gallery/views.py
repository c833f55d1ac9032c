# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Views of ParaView: what is shown in them, and pictures, films and volumes of it."""

import errno
import math
import os

from paraview import simple
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter

from .. import display, files
from ..film import save_film


def save_view(filename, view):
    """Write a view as a PNG. Raises OSError, with an old file as it was, or RuntimeError without a display."""
    display.require(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetInputData(view.SMProxy.CaptureWindow(1))  # which draws it
    files.write(writer, filename)


def film_view(filename, view, frames, rate, turn_to, told):
    """Write a film of a view, of so many frames with a rate [1/s], and these beside it, as `walk.0000.png`.

    turn_to: sets up the frame of a number; told: called before, with that number and `frames`.
    """
    pictures = [f"{os.path.splitext(filename)[0]}.{frame:04d}.png" for frame in range(frames)]
    for frame, picture in enumerate(pictures):
        told(frame, frames)
        turn_to(frame)
        save_view(picture, view)
    save_film(filename, pictures, rate)


def save_volume(filename, source):
    """Write the images of a source as an OpenVDB volume, by a server on this machine.

    Raises OSError, with an old file as it was.
    """
    def state():
        return os.path.exists(filename) and (os.stat(filename).st_ino, os.stat(filename).st_mtime_ns)

    before = state()
    simple.SaveData(filename, source)
    if state() == before:
        raise OSError(errno.EIO, "The volume cannot be written", filename)


def look(view, eye, focus, angle):
    """Point the camera of a view; the angle is vertical [degrees]."""
    view.CameraPosition = list(eye)
    view.CameraFocalPoint = list(focus)
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = angle


def show_colored(source, view):
    """Show data with the colors of the array `RGB`."""
    shown = simple.Show(source, view)
    shown.ColorArrayName = ["POINTS", "RGB"]
    shown.MapScalars = 0
    return shown


def show_particles(source, view):
    """Show particles as spheres of their Radius."""
    shown = show_colored(source, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.ShaderPreset, shown.GaussianRadius = "Sphere", 1.0
    shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "Radius"], 0


def show_fog(source, view, color=(0.28, 0.62, 0.70)):
    """Show the image of Particle Fog as a volume of one color."""
    extinctions = (0.0, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1.2, 2.5, 5.0)
    shown = simple.Show(source, view, "UniformGridRepresentation")
    shown.SetRepresentationType("Fog")
    shown.SampleDistance = 2.0
    shown.ColorArrayName = ["POINTS", "Extinction"]
    shown.LookupTable = simple.CreateLookupTable(
        ColorSpace="RGB", RGBPoints=[0.0, *color, extinctions[-1], *color], AutomaticRescaleRangeMode="Never")
    shown.ScalarOpacityFunction = simple.CreatePiecewiseFunction(
        Points=[number for each in extinctions for number in (each, 1.0 - math.exp(-each), 0.5, 0.0)])
    shown.ScalarOpacityUnitDistance = 1.0
    shown.Shade = 0


def light(view, **settings):
    """Light a view by sun and sky, without widgets; settings: properties of the display of Landscape Light."""
    view.OrientationAxesVisibility = 0
    return simple.Show(simple.LandscapeLight(registrationName="Light"), view, **settings)


def reader(name, data, folder):
    """A reader of an image or polygons, which are written into a folder as a file that every version can read."""
    writer = vtkXMLDataSetWriter()
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    filename = os.path.join(folder, f"{name}.{'vti' if data.IsA('vtkImageData') else 'vtp'}")
    files.write(writer, filename)
    return simple.OpenDataFile(filename, registrationName=name, TimeArray="None")
