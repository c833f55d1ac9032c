# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""The representation Fog absorbs by Beer's law, whatever its sample distance, from outside and from within.

White fog before blue has the red 255 (1 - exp(-tau)) with tau the integral of the extinction along the ray.
"""

import math
import os
import tempfile

import numpy as np
import quick
from paraview import simple
from window import colors

SIZE = 100  # of the window [pixels]
EXTINCTIONS = np.linspace(0.0, 0.3, 31)
PEAK, WIDTH = 0.2, 30.0  # of the round cloud s = PEAK exp(-r^2 / WIDTH) [1/m, m2]


def red(tau):
    return 255.0 * -math.expm1(-tau)


def image(function):
    """An image of 20 m a side with an extinction."""
    grid = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    return simple.Calculator(Input=grid, ResultArrayName="Extinction", Function=function)


def fog(source, view):
    """The fog of an image, of one color."""
    shown = simple.Show(source, view, "UniformGridRepresentation")
    shown.SetRepresentationType("Fog")
    simple.ColorBy(shown, ("POINTS", "Extinction"))
    shown.LookupTable = simple.CreateLookupTable(
        ColorSpace="RGB", RGBPoints=[0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0], AutomaticRescaleRangeMode="Never")
    shown.ScalarOpacityFunction = simple.CreatePiecewiseFunction(
        Points=[number for s in EXTINCTIONS for number in (s, -math.expm1(-s), 0.5, 0.0)])
    shown.ScalarOpacityUnitDistance = 1.0
    shown.Shade = 0
    return shown


def middle(view, size=10):
    """The mean red around the middle of the window; rays begin at random parts of a step."""
    simple.Render(view)
    seen = colors(view).reshape(SIZE, SIZE, 3)[:, :, 0]
    low, high = (SIZE - size) // 2, (SIZE + size) // 2
    return seen[low:high, low:high].mean()


def expect(seen, tau, what, most=2.0):
    assert abs(seen - red(tau)) <= most, f"{what}: red is {seen}, not {red(tau)}"


def look_along(view, direction, distance):
    """Parallel rays of a pixel of 0.02 m, or from a place within where the distance is 0."""
    view.CameraPosition = [-distance * x for x in direction] if distance else [0.0, 0.0, 0.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0] if distance else list(direction)
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = int(distance > 0.0)
    view.CameraParallelScale = 1.0
    view.CameraViewAngle = 5.0


view = simple.CreateView("RenderView")
view.ViewSize, view.OrientationAxesVisibility = [SIZE, SIZE], 0
view.UseColorPaletteForBackground, view.Background = 0, [0.0, 0.0, 1.0]
even, cloud = image("0.05"), image(f"{PEAK} * exp(-(coordsX^2 + coordsY^2 + coordsZ^2) / {WIDTH})")
shown = fog(even, view)
assert shown.SampleDistance == 1.0, "another default"
simple.Render(view)  # resets the camera
diagonal = [1.0 / math.sqrt(3.0)] * 3
for distance in (0.25, 1.0, 3.0):
    shown.SampleDistance = distance
    look_along(view, [0.0, 0.0, -1.0], 50.0)
    expect(middle(view), 0.05 * 20.0, f"even fog, a sample every {distance} voxels")
    look_along(view, [1.0, 0.0, 0.0], 0.0)
    expect(middle(view), 0.05 * 10.0, f"within even fog, a sample every {distance} voxels")
simple.Hide(even, view)
shown = fog(cloud, view)
for distance in (0.25, 1.0):
    shown.SampleDistance = distance
    for direction in ([0.0, 0.0, -1.0], diagonal):
        reach = 10.0 / max(np.abs(direction))
        look_along(view, direction, 50.0)
        tau = PEAK * math.sqrt(math.pi * WIDTH) * math.erf(reach / math.sqrt(WIDTH))
        expect(middle(view), tau, f"a cloud along {direction}, a sample every {distance} voxels")

# Few samples miss the cloud in some pixels: the distance is the one that is drawn with.
look_along(view, [0.0, 0.0, -1.0], 50.0)
spread = []
for distance in (0.25, 10.0):
    shown.SampleDistance = distance
    middle(view)
    spread.append(colors(view)[:, 0].std())
assert spread[0] < 2.0 and spread[1] > 3.0 * spread[0], f"deviations {spread} between pixels"

# A state keeps both, and the picture.
shown.SampleDistance = 2.0
before = middle(view)
with tempfile.TemporaryDirectory() as folder:
    state = os.path.join(folder, "fog.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
view = simple.GetActiveViewOrCreate("RenderView")
shown = next(each for each in view.Representations if getattr(each, "Visibility", 0) and hasattr(each, "SampleDistance"))
assert (str(shown.Representation).strip("'"), shown.SampleDistance) == ("Fog", 2.0)
assert abs(middle(view) - before) < 1.0, "another picture after the state"
