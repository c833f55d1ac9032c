# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The helpers that read elevation models and make blocks of them, against what is known of them."""

import os
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray

from littoral.elevation import (
    array_from_image, image_from_array, metres_per_degree, read_elevation, write_vti)
from littoral.gallery.heights import sampled, subdivide
from littoral.gallery.relief import BASE, beds, block, floor, row_camera, tints
from littoral.glb import direction
from littoral.tables import column, model_names, one_model, table_of


def raises(error, call, *arguments):
    try:
        call(*arguments)
    except error:
        return True
    return False


# A degree at 45 degrees of latitude, from tables of WGS 84.
east, north = metres_per_degree(45.0)
assert abs(east - 78847.0) < 1.0 and abs(north - 111132.0) < 1.0, (east, north)

# The elevation model has its first row in the south, and survives a file.
place = read_elevation()
heights = array_from_image(place)
assert heights.shape == (344, 403) and (heights.min(), heights.max()) == (236.0, 1076.0)
assert heights[:, :100].mean() > heights[:, -100:].mean()  # mountains in the west
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "place.vti")
    write_vti(place, file)
    again = read_elevation(file)
assert np.array_equal(array_from_image(again), heights)
assert again.GetSpacing() == place.GetSpacing()
assert raises(FileNotFoundError, read_elevation, "no such file.npz")

# Subdivision keeps a plane, and samples of it are exact.
y, x = np.mgrid[0:20, 0:30].astype(float)
plane = 2.0 * x - y
assert np.allclose(subdivide(plane)[::2, ::2], plane)
assert abs(sampled(image_from_array(plane, (10.0, 10.0)), 123.0, 57.0) - (2.0 * 12.3 - 5.7)) < 1e-5
assert np.allclose(direction(90.0, 0.0), (1.0, 0.0, 0.0))

# A block stands above z = 0 round its center, its sides reach down to there; terrains with a hole have one as well.
holed = np.where((x > 8.0) & (x < 12.0) & (y > 8.0) & (y < 12.0), np.nan, plane)
for terrain in (plane, plane[:2, :2], holed):
    image = image_from_array(terrain, (10.0, 10.0), (40.0, 70.0))
    ground, sides = block(image, 2.0, center=(100.0, 0.0))
    west, east, south, north, low, high = ground.GetBounds()
    assert abs(west + east - 200.0) < 1e-3 and abs(south + north) < 1e-3, ground.GetBounds()
    assert abs(high - low - 2.0 * np.nanmax(terrain) + 2.0 * np.nanmin(terrain)) < 1e-3
    assert abs(low - BASE * (east - west)) < 1e-3 and sides.GetBounds()[:4] == (west, east, south, north)
    assert sides.GetBounds()[5] == high
    depths = vtk_to_numpy(sides.GetMapper().GetInput().GetPoints().GetData())[:, 2]  # first of the edge, then of the feet
    assert abs(2.0 * depths[len(depths) // 2:].max() + sides.GetPosition()[2]) < 1e-3

# A bowl of 10 m in a plain is a lake as wide as it is, and a ridge beside it is none.
y, x = np.mgrid[0:60, 0:60].astype(float)
bowl = 20.0 - 10.0 * np.exp(-((x - 20.0)**2 + (y - 30.0)**2) / 36.0) + 10.0 * np.exp(-((x - 45.0) / 4.0)**2)
_, _, lakes, _ = block(image_from_array(bowl, (1.0, 1.0)), 2.0, water=True)
west, east, south, north, low, high = lakes.GetBounds()
assert abs(west + east + 59.0 - 40.0) < 1.0 and abs(south + north + 59.0 - 60.0) < 1.0, lakes.GetBounds()
assert 14.0 < east - west < 34.0 and high - low < 0.1

# Tints are those of deviations from the mean, beds fill the whole height of a side.
assert tints(np.array((0.0, 2.0)))[2] == (1.0, 0.71, 0.67, 0.50)
layers = np.array(beds())
assert layers[0, 0] == 0.0 and 0.99 < layers[-1, 0] < 1.0 and (np.diff(layers[:, 0]) > 0.0).all()

# The camera of a row sees all blocks from above, and nothing but the floor behind them.
eye, focus, angle = row_camera(1000.0, 2, 2.0)
assert eye[2] > 0.0 and np.linalg.norm(eye - focus) > 1000.0 and 0.0 < angle < 90.0
sight = (focus - eye) / np.linalg.norm(focus - eye)
right = np.cross(sight, (0.0, 0.0, 1.0))
right /= np.linalg.norm(right)
ground = vtk_to_numpy(floor(1000.0, 2).GetPoints().GetData()).astype(float)
for aside, up in ((-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0)):
    ray = sight + np.tan(np.radians(0.5 * angle)) * (aside * right + up * np.cross(right, sight))
    foot = eye - eye[2] / ray[2] * ray
    sides = np.roll(ground, -1, axis=0) - ground, foot - ground
    assert (sides[0][:, 0] * sides[1][:, 1] > sides[0][:, 1] * sides[1][:, 0]).all(), "a corner beyond the floor"

# One row of a table of fits.
fits, names = table_of({"Variance": [4.0, 9.0]}), vtkStringArray()
names.SetName("Model")
for name in ("Telis", "Fractal"):
    names.InsertNextValue(name)
fits.AddColumn(names)
assert model_names(one_model(fits, "Fractal")) == ["Fractal"]
assert column(one_model(fits, "Fractal"), "Variance")[0] == 9.0
