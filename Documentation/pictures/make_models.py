# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw models.jpg: a shaded map of each covariance model, from the same random numbers.

    ./littoral run pvpython Documentation/pictures/make_models.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

import numpy as np
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from littoral import vtkLandscapePass, vtkTerrainLevelOfDetailFilter, vtkTurningBandsTerrainSource
from littoral.gallery.relief import actor_of
from littoral.picture import FAINT, INK, label, write_jpg
from littoral.properties import set_properties

POINTS, SEED = 256, 4
SPACING, DEVIATION = 4.0, 40.0  # [m]
RELIEF = 0.55  # of the heights that are shaded
#: Title, note and properties of each map, in the order of the enumeration.
MODELS = (
    ("Fractal", "D = 2.30, largest wavelength 1 km", dict(Range=1000.0, FractalDimension=2.3)),
    ("Simple Exponential", "range 100 m", dict(Range=100.0)),
    ("Double Exponential", "range 100 m", dict(Range=100.0)),
    ("Bessel 1", "range 60 m", dict(Range=60.0)),
    ("Bessel 2", "range 60 m", dict(Range=60.0)),
    ("Telis", "ranges 300 m and 30 m", dict(Range=300.0, SecondRange=30.0)),
    ("Spherical", "range 300 m", dict(Range=300.0)))

#: Colors of heights from -2.5 to 2.5 standard deviations.
TINTS = ((0.26, 0.41, 0.44), (0.34, 0.51, 0.47), (0.51, 0.62, 0.47), (0.73, 0.72, 0.54),
         (0.84, 0.75, 0.58), (0.86, 0.72, 0.62), (0.88, 0.81, 0.76), (0.91, 0.89, 0.87))

PICTURE = (1600, 968)  # pixels, as all places and sizes below
MAP, GAP, MARGIN, TOP, ROW = 362, 28, 34, 34, 466


def table():
    """Rows of a height [m] and its color."""
    return [(height, *color) for height, color in zip(np.linspace(-2.5, 2.5, len(TINTS)) * DEVIATION, TINTS)]


def grown(model, properties, left, top):
    """A field of mean zero as a map with its upper left corner at a place of the picture."""
    source = set_properties(vtkTurningBandsTerrainSource(), dict(
        Model=model, WholeExtent=(0, POINTS - 1, 0, POINTS - 1, 0, 0), Spacing=(SPACING, SPACING, 1.0),
        StandardDeviation=DEVIATION, Mean=0.0, Seed=SEED, **properties))
    ground = set_properties(vtkTerrainLevelOfDetailFilter(), dict(NumberOfLevels=1, UseCulling=False))
    ground.SetInputConnection(source.GetOutputPort())
    ground.Update()
    actor, scale = actor_of(ground.GetOutput().GetBlock(0), table()), MAP / (SPACING * (POINTS - 1))
    actor.SetScale(scale, scale, RELIEF * scale)
    actor.SetPosition(left, PICTURE[1] - top - MAP, 0.0)
    return actor


def ramp(left, top, width, height):
    """The colors of heights from low to high, at a place of the picture."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-2.5 * DEVIATION, 0.0, 0.0)
    plane.SetPoint1(2.5 * DEVIATION, 0.0, 0.0)
    plane.SetPoint2(-2.5 * DEVIATION, height, 0.0)
    heights = vtkElevationFilter()
    heights.SetInputConnection(plane.GetOutputPort())
    heights.SetLowPoint(-2.5 * DEVIATION, 0.0, 0.0)
    heights.SetHighPoint(2.5 * DEVIATION, 0.0, 0.0)
    heights.SetScalarRange(-2.5 * DEVIATION, 2.5 * DEVIATION)
    heights.Update()
    actor = actor_of(heights.GetOutput(), table())
    actor.GetProperty().LightingOff()
    actor.SetScale(width / (5.0 * DEVIATION), 1.0, 1.0)
    actor.SetPosition(left + 0.5 * width, PICTURE[1] - top - height, 0.0)
    return actor


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
    yield ramp(middle - 150, top + 118, 300, 20)
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
        renderer.AddViewProp(grown(k, properties, left, top))
        renderer.AddViewProp(written(title, left + 0.5 * MAP, top + MAP + 14, 23, INK))
        renderer.AddViewProp(written(note, left + 0.5 * MAP, top + MAP + 48, 16, FAINT))
    for prop in key():
        renderer.AddViewProp(prop)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * PICTURE[1])
    camera.SetFocalPoint(0.5 * PICTURE[0], 0.5 * PICTURE[1], 0.0)
    camera.SetPosition(0.5 * PICTURE[0], 0.5 * PICTURE[1], 1000.0)
    renderer.ResetCameraClippingRange()
    renderer.SetPass(set_properties(vtkLandscapePass(), dict(
        SunAzimuth=315.0, SunElevation=38.0, CloudCover=0.0, Visibility=1e7, FilmCurve=False, ExposureCompensation=0.0,
        ShadowDistance=2000.0, OcclusionRadius=20.0, Background=False)))
    window.AddRenderer(renderer)
    write_jpg(window, os.path.join(folder, "models.jpg"), PICTURE)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
