# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Forests as 3D Tiles, walked by a reader of its own: each tree once in full, on its place by PROJ (behind OSR), in its
boxes; errors that fall; the same bytes; bad input."""
import glob
import json
import os
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

import littoral
import numpy as np
from littoral import errors
from littoral.elevation import image_from_array
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import reference, vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkKdTree, vtkPolyData

if not hasattr(littoral, "vtkForestTilesWriter"):
    print("built without GDAL or tinygltf")
    sys.exit(125)

TYPES = {5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
OFFSET = (480000.0, 5400000.0)


def forest(count=1200, side=900.0, **settings):
    """Trees of two kinds on a slope, denser in one corner; and their feet."""
    rng = np.random.default_rng(3)
    at = side * rng.uniform(0, 1, (count, 2)) ** 1.5
    feet = np.column_stack((at, 0.2 * at[:, 0])).astype(np.float32)
    sites = vtkPolyData()
    sites.SetPoints(vtkPoints())
    sites.GetPoints().SetData(numpy_to_vtk(feet, deep=True))
    scattered = littoral.vtkPlantScatterFilter()
    scattered.SetInputDataObject(0, sites)
    for preset in (1, 2):
        tree = littoral.vtkReevesTreeSource()
        tree.SetPreset(littoral.vtkReevesTreeSource.Custom)
        tree.SetOrders(2)
        tree.SetNumberOfLeaves(40)
        tree.SetTextureSize(16, 8)
        tree.SetSeed(preset)
        scattered.AddPrototypeConnection(tree.GetOutputPort())
    scattered.UseCullingOff()
    scattered.SetOutputFormToInstances()
    for name, value in settings.items():
        getattr(scattered, "Set" + name)(value)
    scattered.Update()
    return scattered, feet.astype(float)


def writer_of(scattered, name, **settings):
    writer = littoral.vtkForestTilesWriter()
    writer.SetInputConnection(scattered.GetOutputPort())
    writer.SetFileName(name)
    settings = {"CoordinateSystem": "EPSG:32632", "CoordinateOffset": OFFSET, "TreesPerTile": 40, **settings}
    for key, value in settings.items():
        getattr(writer, "Set" + key)(*value if isinstance(value, tuple) else (value,))
    return writer


class Gltf:
    """The JSON of a GLB file and arrays of its buffers, which are files."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        magic, version, length, size, kind = struct.unpack("<4sIII4s", data[:20])
        assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
        self.json = json.loads(data[20:20 + size])
        self.buffers = []
        for buffer in self.json["buffers"]:
            with open(os.path.join(os.path.dirname(path), buffer["uri"]), "rb") as file:
                self.buffers.append(file.read())
            assert len(self.buffers[-1]) == buffer["byteLength"]

    def array(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        components = COMPONENTS[accessor["type"]]
        values = np.frombuffer(self.buffers[view["buffer"]], TYPES[accessor["componentType"]],
                               accessor["count"] * components, view.get("byteOffset", 0) + accessor.get("byteOffset", 0))
        values = values.reshape(-1, components).astype(float)
        return values / 32767.0 if accessor.get("normalized") and accessor["componentType"] == 5122 else values

    def instances(self):
        """Mesh, and translations, scales and rotations, of each node."""
        for node in self.json["nodes"]:
            if "mesh" in node:
                places = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
                at, scales = self.array(places["TRANSLATION"]), self.array(places["SCALE"])
                turns = self.array(places["ROTATION"]) if "ROTATION" in places else np.tile((0.0, 0, 0, 1), (len(at), 1))
                yield node["mesh"], at, scales, turns

    def vertices(self, mesh):
        """Those that are drawn."""
        parts = self.json["meshes"][mesh]["primitives"]
        return np.concatenate([self.array(part["attributes"]["POSITION"])[self.array(part["indices"])[:, 0].astype(int)]
                               for part in parts])


def rotated(turns, points):
    """Points of instances, turned by their quaternions x, y, z, w."""
    axes, real = turns[:, None, :3], turns[:, None, 3:]
    return points + 2 * np.cross(axes, np.cross(axes, points) + real * points)


class Tile:
    def __init__(self, data, folder, above=np.eye(4), parent=None):
        own = np.array(data.get("transform", np.eye(4).ravel())).reshape(4, 4).T
        self.matrix, self.parent, self.error = above @ own, parent, data["geometricError"]
        self.box = np.array(data["boundingVolume"]["box"])
        self.gltf = Gltf(os.path.join(folder, urllib.parse.unquote(data["content"]["uri"]))) if "content" in data else None
        self.children = [Tile(child, folder, self.matrix, self) for child in data.get("children", [])]

    def all(self):
        return [self] + [tile for child in self.children for tile in child.all()]

    def on_earth(self, points):
        return points @ self.matrix[:3, :3].T + self.matrix[:3, 3]

    def feet(self):
        """Around the middle of the earth; of each tree once, though it has several parts."""
        found = {}
        for _, at, _, _ in self.gltf.instances():
            found[at.tobytes()] = at
        return self.on_earth(np.concatenate(list(found.values())))

    def holds(self, points, margin=1e-3):
        """Whether places around the middle of the earth are in the box."""
        local = (points - self.matrix[:3, 3]) @ self.matrix[:3, :3]
        half = self.box[[3, 7, 11]]
        return bool(np.all(np.abs(local - self.box[:3]) <= half + margin))


def read(path):
    with open(path, encoding="utf-8") as file:
        tileset = json.load(file)
    assert tileset["asset"]["version"] == "1.1" and tileset["root"]["refine"] == "REPLACE"
    return tileset, Tile(tileset["root"], os.path.dirname(path))


def by_proj(feet, code, height=0.0):
    """Places around the middle of the earth by OSR, which asks PROJ."""
    program = """
import json, sys
from osgeo import osr
osr.UseExceptions()
code, points = json.load(sys.stdin)
systems = [osr.SpatialReference(), osr.SpatialReference()]
systems[0].ImportFromEPSG(code)
systems[0].PromoteTo3D()
systems[1].ImportFromEPSG(4978)
for system in systems:
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
print(json.dumps(osr.CoordinateTransformation(*systems).TransformPoints(points)))
"""
    points = (feet + (*OFFSET, height)).tolist()
    done = subprocess.run(["/usr/bin/python3", "-c", program], input=json.dumps([code, points]), capture_output=True,
                          text=True, check=False, env={**os.environ, "PYTHONPATH": ""})
    return np.array(json.loads(done.stdout)) if done.returncode == 0 else None


class Tiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.scattered, cls.feet = forest()
        cls.path = os.path.join(cls.temporary.name, "a forest.json")
        assert writer_of(cls.scattered, cls.path, HeightOffset=48.0).Write() == 1
        cls.tileset, cls.root = read(cls.path)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def nearest(self, wanted, found):
        """The largest distance to the nearest place, and how many of the wanted ones are nearest to one [m]."""
        middle = wanted.mean(axis=0)
        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(wanted - middle), deep=True))
        tree = vtkKdTree()
        tree.BuildLocatorFromPoints(points)
        near = [tree.FindClosestPoint(*place, reference(0.0)) for place in found - middle]
        distances = np.linalg.norm(wanted[near] - found, axis=1)
        return distances.max(), len(set(near))

    def test_each_tree_is_once_in_full_on_its_place_by_proj(self):
        wanted = by_proj(self.feet, 32632, 48.0)
        if wanted is None:
            self.skipTest("there is no OSR")
        leaves = [tile for tile in self.root.all() if not tile.children]
        self.assertEqual(len(leaves), 64)
        found = np.concatenate([tile.feet() for tile in leaves])
        self.assertEqual(len(found), len(self.feet))
        off, trees = self.nearest(wanted, found)
        self.assertLess(off, 0.001)
        self.assertEqual(trees, len(self.feet))
        coarse = np.concatenate([self.root.feet()])
        self.assertLess(self.nearest(wanted, coarse)[0], 0.01)

    def test_levels_have_all_trees_or_each_fourth(self):
        level = [self.root]
        counts = []
        while level:
            counts.append(sum(len(tile.feet()) for tile in level))
            level = [child for tile in level for child in tile.children]
        self.assertEqual(counts[-3:], [1200, 1200, 1200])
        self.assertEqual(counts[:-3], [300])
        self.assertTrue(all(len(tile.feet()) <= 40 for tile in self.root.all() if not tile.children))

    def test_fewer_trees_cover_as_much_ground(self):
        def covered(tiles):
            scales = np.concatenate([scales for tile in tiles for _, _, scales, _ in tile.gltf.instances()])
            return (scales[:, 0] * scales[:, 1]).sum(), scales[:, 2].mean()

        few, high = covered([self.root])
        every, tall = covered([tile for tile in self.root.all() if not tile.children])
        self.assertAlmostEqual(few / every, 1.0, delta=0.05)  # of 300 trees of 1200
        self.assertAlmostEqual(high / tall, 1.0, delta=0.02)

    def test_boxes_hold_the_trees_and_the_tiles_below(self):
        corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        for tile in self.root.all():
            for mesh, at, scales, turns in tile.gltf.instances():
                vertices = tile.gltf.vertices(mesh)
                for axis in range(3):
                    few = vertices[[vertices[:, axis].argmin(), vertices[:, axis].argmax()]]
                    placed = at[:, None] + rotated(turns, few[None] * scales[:, None])
                    self.assertTrue(tile.holds(tile.on_earth(placed.reshape(-1, 3)), 1e-2))
            if tile.parent:
                self.assertTrue(tile.parent.holds(tile.on_earth(tile.box[:3] + corners * tile.box[[3, 7, 11]])))

    def test_errors_fall_by_the_formula(self):
        self.assertGreaterEqual(self.tileset["geometricError"], self.root.error)
        pixels = 2 * np.tan(np.pi / 6) * 16 / 1080
        for tile in self.root.all():
            if tile.parent:
                self.assertLess(tile.error, tile.parent.error)
            if not tile.children:
                self.assertEqual(tile.error, 0.0)
                self.assertAlmostEqual(tile.parent.error, 30.0 * pixels, 12)
                self.assertAlmostEqual(tile.parent.parent.error, 130.0 * pixels, 12)
        sides = np.ptp(self.feet[:, :2], axis=0)
        # The root shows each fourth tree.
        self.assertAlmostEqual(self.root.error, np.sqrt(4 * sides[0] * sides[1] / 1200), 6)

    def test_trees_are_upright_and_turned_as_on_the_map(self):
        up = np.array((0.0, 0, 1))
        tile = [tile for tile in self.root.all() if not tile.children][0]
        ahead = by_proj(np.array([(0.0, 0, 0), (100, 0, 0), (0, 0, 100)]), 32632)
        if ahead is None:
            self.skipTest("there is no OSR")
        for local, wanted in (((1.0, 0, 0), ahead[1] - ahead[0]), (up, ahead[2] - ahead[0])):
            way = tile.matrix[:3, :3] @ np.array(local)
            self.assertGreater(way @ wanted / np.linalg.norm(wanted), np.cos(3e-4))

    def test_same_input_gives_same_bytes_and_replaces(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "a forest.json")
            self.assertEqual(writer_of(self.scattered, name, TreesPerTile=1000).Write(), 1)
            self.assertEqual(writer_of(self.scattered, name, HeightOffset=48.0).Write(), 1)
            self.assertEqual(sorted(os.listdir(folder)), sorted(os.listdir(self.temporary.name)))
            for one in glob.glob(os.path.join(self.temporary.name, "**", "*.*"), recursive=True):
                with open(one, "rb") as a, open(os.path.join(folder, os.path.relpath(one, self.temporary.name)), "rb") as b:
                    self.assertEqual(a.read(), b.read())

    def test_few_trees_are_three_tiles(self):
        scattered, feet = forest(3)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "few.json")
            self.assertEqual(writer_of(scattered, name).Write(), 1)
            tiles = read(name)[1].all()
            self.assertEqual([len(tile.feet()) for tile in tiles], [3, 3, 3])

    def test_the_place_comes_from_the_input(self):
        land = image_from_array(np.zeros((10, 10)), (150.0, 150.0))
        for name, value in (("CoordinateSystem", "EPSG:32632"), ("CoordinateOffset", OFFSET)):
            array = vtkStringArray() if isinstance(value, str) else vtkDoubleArray()
            array.SetName(name)
            if isinstance(value, str):
                array.InsertNextValue(value)
            else:
                array.SetNumberOfComponents(2)
                array.InsertNextTuple(value)
            land.GetFieldData().AddArray(array)
        scattered, _ = forest(20)
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, f"{k}.json") for k in (1, 2)]
            scattered.SetInputDataObject(2, land)
            self.assertEqual(writer_of(scattered, names[0]).Write(), 1)
            self.assertEqual(writer_of(scattered, names[1], CoordinateSystem="").Write(), 1)
            np.testing.assert_array_equal(read(names[0])[1].matrix, read(names[1])[1].matrix)

    def refused(self, words, scattered=None, **settings):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "no.json")
            with open(name, "w", encoding="utf-8") as file:
                file.write("old")
            writer = writer_of(scattered or self.scattered, name, **settings)
            messages = errors.kept(writer)
            self.assertEqual(writer.Write(), 0)
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(words, messages[0])
            self.assertEqual(os.listdir(folder), ["no.json"])
            with open(name, encoding="utf-8") as file:
                self.assertEqual(file.read(), "old")

    def test_bad_input_is_said_once_and_leaves_nothing(self):
        self.refused("no coordinate system", CoordinateSystem="")
        self.refused("no coordinate system", CoordinateSystem="EPSG:99")
        self.refused("must be a projection", CoordinateSystem="EPSG:4326")
        self.refused("outside of WGS 84 / UTM zone 32N", CoordinateOffset=(1e9, 0.0))
        self.refused("TreesPerTile", TreesPerTile=0)
        self.refused("FarDistance", FarDistance=3.0)
        self.refused("has no instances", forest(5, OutputForm=0)[0])
        self.refused("has no trees", forest(5, HeightRange=(1e5, 1e6))[0])

    def test_a_full_disk_leaves_nothing(self):
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (20000, limits[1]))
        try:
            self.refused("File too large")
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)

    def test_an_abort_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            writer = writer_of(self.scattered, os.path.join(folder, "no.json"))
            writer.AddObserver("ProgressEvent", lambda *_: writer.GetProgress() > 0.6 and writer.SetAbortExecute(1))
            self.assertEqual(writer.Write(), 0)
            self.assertEqual(os.listdir(folder), [])

    def test_what_a_killed_writer_leaves_goes(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "killed.json")
            program = ("import os; import TestForestTiles as tests; "
                       f"writer = tests.writer_of(tests.forest()[0], {name!r}); "
                       "writer.AddObserver('ProgressEvent', lambda *_: writer.GetProgress() > 0.6 and os.kill(os.getpid(), 9)); "
                       "writer.Write()")
            path = os.pathsep.join((os.path.dirname(os.path.abspath(__file__)), os.environ.get("PYTHONPATH", "")))
            killed = subprocess.run([sys.executable, "-c", program], check=False, env={**os.environ, "PYTHONPATH": path})
            self.assertEqual(killed.returncode, -signal.SIGKILL)
            left = os.listdir(folder)
            self.assertTrue(left and all(one.startswith(".littoral-") for one in left), left)
            self.assertEqual(writer_of(self.scattered, name).Write(), 1)
            self.assertEqual(sorted(one.partition("-")[0] for one in os.listdir(folder)), ["killed", "killed.json"])


if __name__ == "__main__":
    unittest.main()
