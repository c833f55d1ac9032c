# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Scenes of glTF as three.js has them: counts, places, colors, joints and motion are those of VTK; and the page of the
examples in Chromium, where there is one. Needs node and the package three: `npm install three` somewhere; LITTORAL_THREE
names its folder, node_modules/three."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import in_chromium
import littoral
from TestSceneFiles import array, block, forest, linear, make, places, points_of, tree
from littoral.glb import write_glb

THREE = os.environ.get("LITTORAL_THREE", "")
HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "three_scene.mjs")
PAGE = os.path.join(HERE, "..", "..", "Examples", "Web", "scene.html")
if not THREE or not shutil.which("node"):
    print("LITTORAL_THREE does not name the package three, or there is no node")
    sys.exit(125)


def z_up(numbers):
    """Places of three.js in the coordinates of Littoral."""
    x, y, z = np.array(numbers, np.float64).reshape(-1, 3).T
    return np.column_stack((x, -z, y))


def loaded(sources, at=(), **settings):
    """What three.js has of sources, at once and at times after the start."""
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "scene.glb")
        write_glb(name, sources, **settings)
        ran = subprocess.run(["node", SCRIPT, os.path.abspath(THREE), name, *map(str, at)], capture_output=True, text=True,
                             check=False)
    if ran.returncode or "error" in ran.stderr.lower():
        raise AssertionError(ran.stderr[-2000:])
    return json.loads(ran.stdout)


def corners(data):
    """Corners of the triangles of polygons."""
    return 3 * (data.GetPolys().GetNumberOfConnectivityIds() - 2 * data.GetPolys().GetNumberOfCells())


def named(meshes, *words):
    found = [mesh for mesh in meshes if all(word in mesh["path"] for word in words)]
    assert len(found) == 1, [mesh["path"] for mesh in meshes]
    return found[0]


class Three(unittest.TestCase):
    def check_mesh(self, mesh, data, kind):
        np.testing.assert_allclose(z_up(mesh["places"]), places(data), atol=1e-5)
        self.assertEqual(mesh["corners"], corners(data))
        self.assertEqual(mesh["kind"], kind)
        colors = np.array(mesh["colors"]).reshape(len(places(data)), -1)
        np.testing.assert_allclose(colors, linear(array(data, "RGB") / 255.0), atol=1e-5)

    def test_a_plant_and_ground(self):
        plant = tree(Preset=2, TextureSize=(32, 16))
        land = make("vtkTurningBandsTerrainSource", WholeExtent=(0, 30, 0, 20, 0, 0))
        dust = points_of([(1, 2, 3), (4, 5, 6)])
        found = loaded({"Tree": plant, "Land": land, "Dust": dust}, LevelForm=2, camera=((0, -9, 2), (0, 0, 2), (0, 0, 1), 40.0),
                       sun=(200, 35))
        for name, kind in (("Skin", "bark"), ("Leaves", "leaf")):
            self.check_mesh(named(found["meshes"], "Tree/High", name), block(plant.GetOutput(), "High", name), kind)
        leaves = named(found["meshes"], "Leaves")
        self.assertEqual((leaves["alphaTest"], leaves["double"]), (0.5, True))
        size = block(plant.GetOutput(), "High", "Leaves").GetFieldData().GetArray("TextureSize")
        self.assertEqual(leaves["picture"], vtk_to_numpy(size).ravel().tolist())
        ground = named(found["meshes"], "Land")
        heights = z_up(ground["places"])
        np.testing.assert_allclose(heights[:, 2], array(land.GetOutput(), "Elevation"), atol=1e-5)
        self.assertEqual(ground["corners"], 6 * 30 * 20)
        self.assertEqual(named(found["meshes"], "Dust")["places"], [1, 2, 3, 4, 5, 6])
        np.testing.assert_allclose(found["cameras"], [40.0], atol=1e-5)
        self.assertEqual(found["lights"], [["DirectionalLight", 100000]])

    def test_instances(self):
        prototype = tree(Preset=2)
        wood = forest([prototype])
        found = loaded({"Forest": wood}, LevelForm=2)
        merged = forest([prototype], OutputForm=0, UseLevels=False)
        for name in ("Skin", "Leaves"):
            mesh, data = named(found["meshes"], name), block(merged.GetOutput(), "High", name)
            self.assertEqual(mesh["instances"], 40)
            at = z_up(mesh["places"])
            self.assertEqual(len(at), data.GetNumberOfPoints())
            np.testing.assert_allclose(at.min(axis=0), places(data).min(axis=0), atol=1e-5)
            np.testing.assert_allclose(at.max(axis=0), places(data).max(axis=0), atol=1e-5)
            np.testing.assert_allclose(at.mean(axis=0), places(data).astype(float).mean(axis=0), atol=1e-5)

    def test_joints(self):
        wind = make("vtkWindFieldSource", Dimensions=(64, 32, 16), LateralSpacing=4.0, VerticalSpacing=2.5)
        sway = make("vtkBeamTreeDeformationFilter", tree(Preset=2), wind, GenerateJoints=True, LeafFlutter=0.0)
        at = (0.0, 0.375, 1.0)
        for tolerance, limit in ((0.0, 0.0003), (0.001, 0.001)):
            found = loaded({"P": sway}, at, times=(0.5, 1.5, 8.0), JointTolerance=tolerance)
            for time, meshes in zip(at, found["times"]):
                sway.UpdateTimeStep(0.5 + time)
                for part, name in enumerate(("Skin", "Leaves")):
                    data = block(sway.GetOutput(), "High", name)
                    mesh, = [m for m in meshes if len(m["places"]) == 3 * data.GetNumberOfPoints()]
                    away = np.linalg.norm(z_up(mesh["places"]) - places(data), axis=1).max()
                    self.assertLess(away, limit, (tolerance, time, name))
            if tolerance == 0.0:
                # Those of the level Medium follow in the block.
                joints = array(block(sway.GetOutput(), "Joints"), "RestPosition")
                rests = -np.array(found["meshes"][0]["rests"]).reshape(-1, 3)
                self.assertEqual(len(rests), block(sway.GetOutput(), "High", "Skeleton").GetNumberOfPoints())
                np.testing.assert_allclose(rests, joints[:len(rests)], atol=1e-5)
        still = z_up(found["times"][0][0]["places"])
        self.assertGreater(np.linalg.norm(still - z_up(found["times"][2][0]["places"]), axis=1).max(), 0.01)

    def test_a_sea(self):
        sea = make("vtkSeaSurfaceFilter", make("vtkSeaStateSource", NumberOfTrains=12), Radius=30.0)
        found = loaded({"Sea": sea}, (0.0, 0.5, 1.0), times=(0.0, 1.0, 4.0))
        for time, meshes in zip((0.0, 0.5, 1.0), found["times"]):
            sea.UpdateTimeStep(time)
            np.testing.assert_allclose(z_up(meshes[0]["places"]), places(sea.GetOutput()), atol=1e-5)


class Page(unittest.TestCase):
    def test_in_chromium(self):
        if not shutil.which("chromium"):
            self.skipTest("there is no chromium")
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            shutil.copyfile(PAGE, os.path.join(folder, "scene.html"))
            os.mkdir(os.path.join(folder, "node_modules"))
            os.symlink(os.path.abspath(THREE), os.path.join(folder, "node_modules", "three"))
            write_glb(os.path.join(folder, "scene.glb"), {"Forest": forest([tree(Preset=2)])}, LevelForm=3, sun=(200, 35),
                      camera=((0, -60, 30), (0, 0, 5), (0, 0, 1), 50))
            red, green, blue = np.moveaxis(in_chromium.picture(folder, "scene.html?scene.glb", 500)[..., :3], -1, 0)
        leaves = (green > 1.2 * blue) & (green > red)
        self.assertGreater(leaves.mean(), 0.02, "the page shows no trees")
        self.assertLess(leaves.mean(), 0.5)
        sky = np.abs(np.stack((red, green, blue), -1) - (0xb9, 0xcb, 0xd8)).max(axis=-1) < 3
        self.assertGreater(sky.mean(), 0.3)


if __name__ == "__main__":
    unittest.main()
