# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=underwater
# run-with: python3 tier=all
"""The frames of the examples for Blender: a walk at the height of an eye above the ground, and a sea that moves on.

    python3 TestRenderExamples.py [EXAMPLE...]

Only what a frame changes is looked at: the trees are left out, and no file is written.
"""

import importlib.util
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral.gallery.country import jacksboro

EXAMPLES = os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Examples", "Blender")


def example(name):
    """An example as a module, whose scenes are told here in place of being written."""
    spec = importlib.util.spec_from_file_location(name, os.path.join(EXAMPLES, f"{name}.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    told = {}
    module.write_glb = lambda filename, sources, **options: told.update(sources=sources, **options)
    return module, told


def height_at(image, x, y):
    """The height of an elevation image at a place, between its four points."""
    width, depth = image.GetDimensions()[:2]
    z = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(depth, width)
    origin, spacing = image.GetOrigin(), image.GetSpacing()
    column, row = (x - origin[0]) / spacing[0], (y - origin[1]) / spacing[1]
    i, j = int(column), int(row)
    a, b = column - i, row - j
    return (1 - a) * ((1 - b) * z[j, i] + b * z[j + 1, i]) + a * ((1 - b) * z[j, i + 1] + b * z[j + 1, i + 1])


def check_forest():
    """The walk."""
    forest, told = example("forest")
    forest.scattered = lambda *sites, **options: None
    country = jacksboro()
    forest.jacksboro = lambda: country  # made once for all frames
    image = country.GetOutput()
    eyes = []
    for frame in (0, 30, 120):
        forest.write_scene("none.glb", frame)
        eye, focus, up, angle = told["camera"]
        eyes.append(np.array(eye))
        above = eye[2] - height_at(image, eye[0], eye[1])
        print(f"frame {frame}: eye at {np.round(eye, 2)}, {above:.2f} m above the ground")
        assert abs(above - 2.3) < 0.01, above
        assert focus[2] < 2000.0 and tuple(up) == (0.0, 0.0, 1.0) and angle == 36.0
    # A straight walk, a quarter of the way after a quarter of the frames.
    walk = eyes[2] - eyes[0]
    assert np.hypot(*walk[:2]) > 30.0
    assert np.allclose((eyes[1] - eyes[0])[:2], 0.25 * walk[:2], atol=1e-9)


def check_underwater():
    """The sea, and kelp and specks of the same times."""
    underwater, told = example("underwater")
    times = []
    underwater.surface = underwater.kelp = underwater.specks = lambda *arguments: times.append(
        next(value for value in arguments if isinstance(value, float)))
    cameras = set()
    for frame in (0, 24):
        underwater.write_scene("none.glb", frame)
        cameras.add(told["camera"][0])
    assert len(cameras) == 1, "the eye under water stays"
    assert times[:3] == [times[0]] * 3 and times[3:] == [times[0] + 2.0] * 3, times  # 12 frames a second


CHECKS = {"forest": check_forest, "underwater": check_underwater}
for name in sys.argv[1:] or CHECKS:
    CHECKS[name]()
