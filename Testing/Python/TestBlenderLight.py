# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""What light does in pictures by Blender, by their pixels: on ground, through leaves, in the sky, under water, in fog and
in wind. Skipped without Blender."""

import json
import os
import shutil
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import littoral
from littoral import blender
from littoral.gallery.meshes import add_array, polygons
from TestBlender import ABOVE, pixels, square, write_glb


def drawn(sources, size=(48, 32), samples=48, blend=None, **settings):
    """The picture of sources, [row, column, part], the lowest row first."""
    write_glb("light.glb", sources, **settings)
    blender.render("light.glb", "light.png", blend, size=list(size), samples=samples)
    return pixels("light.png")


def grid(x, y, height, color=None):
    """A surface of heights [m] over a lattice, with its normals."""
    x, y = np.meshgrid(x, y)
    z = height(x, y)
    across, along = np.gradient(z, x[0], axis=1), np.gradient(z, y[:, 0], axis=0)
    normals = np.stack((-across, -along, np.ones_like(z)), axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    rows, columns = z.shape
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    corners = np.column_stack((corner, corner + 1, corner + columns + 1, corner + columns))
    colors = None if color is None else np.broadcast_to(color, (z.size, 3))
    data = polygons(np.column_stack((x.ravel(), y.ravel(), z.ravel())), corners, colors)
    data.GetPointData().SetNormals(add_array(data, "Normals", normals.reshape(-1, 3).astype(np.float32)))
    return data


def write_volume(name, array, values, grid_name=""):
    """A box of 4 x 4 x 2 m above the square, 17 x 9 x 9 samples [z, y, x, part]."""
    image = vtkImageData()
    image.SetDimensions(17, 9, 9)
    image.SetOrigin(-2.0, -2.0, 1.0)
    image.SetSpacing(0.25, 0.5, 0.25)
    numbers = numpy_to_vtk(np.float32(values).reshape(17 * 81, -1), deep=True)
    numbers.SetName(array)
    image.GetPointData().AddArray(numbers)
    writer = littoral.vtkVDBVolumeWriter()
    writer.SetInputData(image)
    writer.SetGridName(grid_name)
    writer.SetFileName(name)
    assert writer.Write()


def write_wind(name):
    """Wind of 2 m/s in the west, 10 m/s in the middle and 20 m/s in the east of that box."""
    speed = np.broadcast_to(np.repeat((2.0, 10.0, 20.0), (7, 3, 7)), (9, 9, 17))
    write_volume(name, "Velocity", np.stack((0.6 * speed, -0.8 * speed, 0.0 * speed), axis=-1))


#: How that wind is drawn.
GUSTS = {"kind": "wind", "density": 0.06, "speeds": [5.0, 15.0]}


class Materials(unittest.TestCase):
    def test_ground(self):
        """Flat ground has its own color, steep ground that of rock; what faces the sun is brighter than what does not."""
        slopes = {-6.0: -60.0, -2.0: 0.0, 2.0: 20.0, 6.0: -20.0}  # upwards to the east [degrees], by where they are
        sources = {f"At {at:g}": grid(np.linspace(at - 1.5, at + 1.5, 4), np.linspace(-4.0, 4.0, 9),
                                      lambda x, y, at=at, slope=slope: np.tan(np.radians(slope)) * (x - at), (0.27, 0.59, 0.2))
                   for at, slope in slopes.items()}
        picture = drawn(sources, kinds=dict.fromkeys(sources, "ground"), sun=(90.0, 40.0),
                        camera=((0.0, 0.0, 30.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 20.0))
        half = 30.0 * np.tan(np.radians(10.0)) * 1.5
        steep, flat, away, towards = (
            picture[8:24, int(24 + 24 * (at - 1.0) / half):int(24 + 24 * (at + 1.0) / half)].mean(axis=(0, 1)) for at in slopes)
        self.assertGreater(flat[1], 1.4 * flat[2], "flat ground is not green")
        self.assertLess(steep[1], 1.2 * steep[2], "steep ground is no rock")
        self.assertGreater(towards.sum(), 1.05 * flat.sum())
        self.assertGreater(flat.sum(), 1.1 * away.sum())

    def test_leaves(self):
        """From below, where the sun is above, a leaf is bright and more yellow than what it reflects; bark is dark."""
        above = grid((-3.0, 3.0), (-3.0, 3.0), lambda x, y: 3.0 + 0.0 * x)
        found = {kind: drawn({"A": above}, kinds={"A": kind}, sun=(0.0, 80.0),
                             camera=((0.0, 0.0, 0.0), (0.0, 0.0, 3.0), (0.0, 1.0, 0.0), 40.0)).mean(axis=(0, 1))
                 for kind in ("leaf", "bark")}
        self.assertGreater(found["leaf"].sum(), 3.0 * found["bark"].sum(), found)
        self.assertGreater(found["leaf"][1], 1.2 * found["leaf"][2], found)


class Sky(unittest.TestCase):
    def test_the_sun_is_where_the_scene_has_it(self):
        """The sky is blue above, and brightest about the sun, which stands low in the east or in the north."""
        found = {}
        for azimuth in (90.0, 0.0):
            for side, focus in {"east": (10.0, 0.0, 3.0), "north": (0.0, 10.0, 3.0), "above": (0.0, -1.0, 10.0)}.items():
                picture = drawn({"Square": square()}, (24, 16), 8, sun=(azimuth, 16.0),
                                camera=((0.0, 0.0, 50.0), tuple(np.add(focus, (0.0, 0.0, 50.0))), (0.0, 0.0, 1.0), 40.0))
                found[azimuth, side] = picture.mean(axis=(0, 1))
        self.assertGreater(found[90.0, "east"].sum(), 1.1 * found[90.0, "north"].sum(), found)
        self.assertGreater(found[0.0, "north"].sum(), 1.1 * found[0.0, "east"].sum(), found)
        for azimuth in (90.0, 0.0):
            self.assertGreater(found[azimuth, "above"][2], 1.3 * found[azimuth, "above"][0], found)


class Water(unittest.TestCase):
    LOOK = dict(camera=((0.0, 0.0, -1.0), (0.0, 0.0, -8.0), (0.0, 1.0, 0.0), 60.0), sun=(0.0, 60.0),
                kinds={"Surface": "water"})

    def below(self, wave, bed, extinction):
        """The bed, seen from below the surface."""
        even, coarse = np.linspace(-30.0, 30.0, 301), np.linspace(-28.0, 28.0, 113)
        return drawn({"Surface": grid(even, even, wave), "Bed": grid(coarse, coarse, bed)},
                     extras={"water": {"level": 0.0, "extinction": extinction}}, **self.LOOK)

    def test_absorption(self):
        """Red is lost first, and more of it the farther what is seen is away."""
        picture = self.below(lambda x, y: 0.0 * x, lambda x, y: np.where(x < 0.0, -3.0, -9.0), [0.45, 0.07, 0.05])
        near, far = picture[:, 4:16].mean(axis=(0, 1)), picture[:, 36:].mean(axis=(0, 1))
        self.assertLess(near[0], 0.9 * near[2], (near, far))
        self.assertLess(far[0] / far[2], 0.6 * near[0] / near[2], (near, far))
        self.assertLess(far.sum(), near.sum())

    def test_caustics(self):
        """Waves gather sunlight on the bed in lines; below a flat surface it is even."""
        contrast = {}
        for height in (0.0, 0.05):
            picture = self.below(lambda x, y, a=height: a * np.cos(np.pi * y), lambda x, y: -4.0 + 0.0 * x, [0.05, 0.05, 0.05])
            rows = picture.mean(axis=(1, 2))
            contrast[height] = np.abs(np.diff(rows)).mean() / rows.mean()
        self.assertGreater(contrast[0.05], 3.0 * contrast[0.0], contrast)


@unittest.skipUnless(hasattr(littoral, "vtkVDBVolumeWriter"), "built without OpenVDB")
class Volumes(unittest.TestCase):
    ASIDE = 8, 7  # row and column of a pixel with nothing behind it

    @staticmethod
    def draw(volumes=(), blend=None, samples=32):
        return drawn({"Square": square()}, (24, 16), samples, blend, extras={"volumes": list(volumes)}, **ABOVE)

    def test_fog(self):
        """A volume with its grid named density veils what is behind it."""
        write_volume("fog.vdb", "Fog", np.full((9, 9, 17), 0.8), "density")
        found = {"clear": self.draw().mean(axis=2), "fog": self.draw([{"file": "fog.vdb", "kind": "fog"}]).mean(axis=2)}
        self.assertLess(found["clear"][self.ASIDE], 5)
        self.assertGreater(found["fog"][self.ASIDE], 20)
        contrast = {name: 1.0 - picture[self.ASIDE] / picture[8, 12] for name, picture in found.items()}
        self.assertTrue(contrast["clear"] > 0.9 and contrast["fog"] < 0.8, contrast)

    def test_wind(self):
        """Wind is seen where it is fast, in the color of its speed, if it is given a density; else it is there, not drawn. A
        volume without a file is left out."""
        write_wind("wind.vdb")
        clear = self.draw()
        hidden = self.draw([{"file": "wind.vdb", "kind": "wind"}, {"file": "none.vdb", "kind": "fog"}], "hidden.blend")
        np.testing.assert_array_equal(hidden, clear)
        self.assertEqual(self.volumes_of("hidden.blend"), [["Wind", True, "Velocity"]])
        seen = self.draw([{"file": "wind.vdb", **GUSTS}], "seen.blend", 600)
        self.assertEqual(self.volumes_of("seen.blend"), [["Wind", False, "Velocity"]])
        slow, middle, fast = (seen[1:5, columns].mean(axis=(0, 1)) for columns in (slice(1, 6), slice(11, 13), slice(18, 23)))
        self.assertLess(np.abs(seen[1:5, 1:6] - clear[1:5, 1:6]).max(), 3.0)
        self.assertGreater(middle.mean(), clear[1:5, 11:13].mean() + 10.0)
        self.assertGreater(fast[0], 1.2 * middle[0], (middle, fast))
        self.assertGreater(fast[0] / fast[2], 1.2 * middle[0] / middle[2])

    @staticmethod
    def volumes_of(name):
        """Volumes of a saved scene: name, whether it is not drawn, and grid."""
        with open("volumes.py", "w", encoding="utf-8") as script:
            script.write("import bpy, json\nwith open('volumes.json', 'w') as out:\n    json.dump([(v.name, v.hide_render, "
                         "v.data.grids.load() and v.data.grids[0].name) for v in bpy.data.objects if v.type == 'VOLUME'], out)")
        returned, said = blender.run([
            "blender", "-b", os.path.abspath(name), "--python-exit-code", "1", "-P", os.path.abspath("volumes.py")])
        assert returned == 0, said[-2000:]
        with open("volumes.json", encoding="utf-8") as text:
            return json.load(text)


if __name__ == "__main__":
    if not shutil.which("blender"):
        print("no Blender")
        sys.exit(125)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        unittest.main()
