# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Underwater scenes in ParaView: the surface from below, the bed with its caustics, shafts of light, haze, particles.

Everything works with the rasterizer of any ParaView, without ray tracing, by the shaders of `water`.
"""

import math

from paraview import simple

from . import views, water
from .. import seawater


def set_time(shown, time):
    """Move the ripples of a representation to a time [s]. No shader is compiled for it."""
    shown.SpecularColor = [time, 0.0, 0.0]


def prepare_view(view):
    """Set up a view without widgets and lights: the shaders compute the light."""
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.0, 0.25, 0.33]
    view.UseFXAA = 1
    view.DepthPeeling = 0  # it would draw the fog again for each layer of particles, which hide little of each other


def show_surface(source, view, time):
    """Show the surface of the water, moved by Particle Orbits, from below."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType("Full Surface")  # whose bounds are those of the points, at each time
    shown.ColorArrayName = [None, ""]
    _shade(shown, water.PLACES + water.NORMALS, water.SURFACE, time)
    return shown


def show_bed(source, view, time):
    """Show a bed or other ground with the arrays RGB and Normals."""
    return _show_lit(source, view, water.BED, time)


def show_seaweeds(source, view, time):
    """Show the level High of seaweeds, from Seaweed or Plant Scatter."""
    parts = simple.ExtractBlock(Input=source, Selectors=["/Root/High/Skin", "/Root/High/Leaves"])
    shown = _show_lit(parts, view, water.SEAWEED, time, fine=True)
    shown.SetRepresentationType("Full Surface")
    return shown


def show_beyond(view, time, eye, radius=150.0):
    """Show the water behind all objects."""
    sphere = simple.Sphere(Center=list(eye), Radius=radius, ThetaResolution=64, PhiResolution=64)
    shown = simple.Show(sphere, view)
    shown.ColorArrayName = [None, ""]
    _shade(shown, water.PLACES, water.BEYOND, time)
    return shown


def show_particles(source, view, eye):
    """Show particles as soft spots with Radius, RGB and Alpha, faded by their distance in water from the camera."""
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.SetRepresentationType("Particles")
    shown.Extinction, shown.Strength, shown.Eye = seawater.GREY_EXTINCTION, 0.75, list(eye)
    shown.ColorArrayName = ["POINTS", "RGB"]
    shown.MapScalars = 0
    shown.ShaderPreset = "Gaussian Blur"
    shown.GaussianRadius = 1.0
    shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "Radius"], 0
    shown.OpacityTransferFunction = simple.CreatePiecewiseFunction(Points=[0.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0])
    shown.Emissive = 0
    shown.Opacity = 0.99  # drawn as translucent, so that it does not hide the fog behind it
    return shown


def show_fog(source, view, color=(0.50, 0.78, 0.76)):
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
    return shown


def _show_lit(source, view, fragment, time, fine=False):
    """Show a data set with the arrays RGB and Normals."""
    shown = views.show_colored(source, view)
    _shade(shown, water.PLACES + water.NORMALS, fragment, time, fine)
    return shown


def _shade(shown, changes, fragment, time, fine=False):
    """Set the shaders of a representation; fine: look up shafts of light at its vertices, not fragments."""
    views.bake(shown)
    views.shade(shown, water.with_functions(changes, fine), fragment)
    set_time(shown, time)
