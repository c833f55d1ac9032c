# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw models.jpg: a shaded map of each covariance model, from the same random numbers.

    ./littoral run pvpython Documentation/pictures/make_models.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import (
    vtkImageSlice, vtkImageSliceMapper, vtkRenderer, vtkRenderWindow)

from littoral import vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.gallery.heights import normals, openness, subdivide, sunlight
from littoral.glb import direction

POINTS, SEED = 256, 4
SPACING, DEVIATION = 4.0, 40.0  # [m]
SUN = (315.0, 38.0)
WARM, COOL = np.array((1.00, 0.93, 0.82)), np.array((0.66, 0.80, 1.00))

#: Title, note and properties of each map, in the order of the enumeration.
MODELS = (
    ("Fractal", "D = 2.30, largest wavelength 1 km", dict(Range=1000.0, FractalDimension=2.3)),
    ("Simple Exponential", "range 100 m", dict(Range=100.0)),
    ("Double Exponential", "range 100 m", dict(Range=100.0)),
    ("Bessel 1", "range 60 m", dict(Range=60.0)),
    ("Bessel 2", "range 60 m", dict(Range=60.0)),
    ("Telis", "ranges 300 m and 30 m", dict(Range=300.0, SecondRange=30.0)),
    ("Spherical", "range 300 m", dict(Range=300.0)))

#: Colors of heights from -2.5 to 2.5 standard deviations, linear.
TINTS = np.array((
    (0.050, 0.130, 0.150), (0.085, 0.205, 0.170), (0.200, 0.310, 0.170), (0.440, 0.430, 0.230),
    (0.610, 0.470, 0.270), (0.640, 0.430, 0.310), (0.680, 0.560, 0.480), (0.740, 0.700, 0.660)))

PICTURE = (1600, 968)  # pixels, as all places and sizes below
MAP, GAP, MARGIN, TOP, ROW = 362, 28, 34, 34, 466


def grow(model, properties):
    """Heights [row, column] of a field of mean zero."""
    source = vtkTurningBandsTerrainSource()
    source.SetModel(model)
    for name, value in properties.items():
        getattr(source, f"Set{name}")(value)
    source.SetWholeExtent(0, POINTS - 1, 0, POINTS - 1, 0, 0)
    source.SetSpacing(SPACING, SPACING, 1.0)
    source.SetStandardDeviation(DEVIATION)
    source.SetMean(0.0)
    source.SetSeed(SEED)
    source.Update()
    return array_from_image(source.GetOutput()).astype(np.float64)


def tint(height):
    """Color of heights [standard deviations]."""
    places = np.linspace(-2.5, 2.5, len(TINTS))
    return np.stack([np.interp(height, places, channel) for channel in TINTS.T], axis=-1)


def shaded(z):
    """A map in light from the north-west, as bytes [row, column, 3]."""
    height = z / DEVIATION
    z = subdivide(z)
    spacing = (0.5 * SPACING, 0.5 * SPACING)
    facing = np.maximum(normals(0.55 * z, spacing) @ direction(*SUN), 0.0)
    sun = facing * (0.35 + 0.65 * sunlight(z, spacing, *SUN, softness=0.25))
    sky = openness(z, spacing) ** 1.5
    light = 1.2 * sun[..., None] * WARM + 0.40 * sky[..., None] * COOL
    return encoded(tint(subdivide(height)) * light)


def encoded(light):
    """Linear light to bytes."""
    return np.round(255.0 * np.clip(light, 0.0, 1.0) ** (1.0 / 2.2)).astype(np.uint8)


def placed(rgb, left, top, width, height):
    """An image with its upper left corner at a place of the picture."""
    rows, columns, _ = rgb.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(width / (columns - 1), height / (rows - 1), 1.0)
    image.SetOrigin(left, PICTURE[1] - top - height, 0.0)
    image.GetPointData().SetScalars(numpy_to_vtk(rgb.reshape(-1, 3), deep=True))
    mapper, shown = vtkImageSliceMapper(), vtkImageSlice()
    mapper.SetInputData(image)
    shown.SetMapper(mapper)
    shown.GetProperty().SetInterpolationTypeToLinear()
    return shown


def written(text, x, top, size, color):
    """Text centered on x."""
    return label(text, (x / PICTURE[0], 1.0 - top / PICTURE[1]), 2 * size, color)


def cell(k):
    """Upper left corner of cell k, four a row."""
    return MARGIN + k % 4 * (MAP + GAP), TOP + k // 4 * ROW


def key():
    """Labels of the eighth cell: the scale of heights, and what the maps share."""
    left, top = cell(len(MODELS))
    middle = left + 0.5 * MAP
    ramp = encoded(np.broadcast_to(1.1 * tint(np.linspace(-2.5, 2.5, 200)), (2, 200, 3)))
    yield placed(ramp, middle - 150, top + 118, 300, 20)
    for height in (-100, -50, 0, 50, 100):
        place = middle + 300.0 * height / (5.0 * DEVIATION)
        yield written(f"{height:+d}".replace("-", "\u2212") if height else "0", place, top + 146, 15, FAINT)
    yield written("height (m)", middle, top + 82, 18, INK)
    for line, text in enumerate((
            "the same seed in all", f"standard deviation {DEVIATION:.0f} m",
            f"{POINTS} \u00d7 {POINTS} points, {SPACING:.0f} m apart")):
        yield written(text, middle, top + 204 + 30 * line, 17, FAINT)


def main(folder):
    """Draw the picture into a folder."""
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(0.975, 0.972, 0.965)
    for k, (title, note, properties) in enumerate(MODELS):
        left, top = cell(k)
        renderer.AddViewProp(placed(shaded(grow(k, properties)), left, top, MAP, MAP))
        renderer.AddViewProp(written(title, left + 0.5 * MAP, top + MAP + 14, 23, INK))
        renderer.AddViewProp(written(note, left + 0.5 * MAP, top + MAP + 48, 16, FAINT))
    for prop in key():
        renderer.AddViewProp(prop)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * PICTURE[1])
    camera.SetFocalPoint(0.5 * PICTURE[0], 0.5 * PICTURE[1], 0.0)
    camera.SetPosition(0.5 * PICTURE[0], 0.5 * PICTURE[1], 100.0)
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "models.jpg"), PICTURE)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
