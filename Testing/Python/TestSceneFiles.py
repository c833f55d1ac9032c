# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of glTF, read back by a reader that shares nothing with their writer: counts, bounds, colors, places, levels,
camera and sun, motion against VTK's own skins; and bad input, refused before anything is written. Khronos' validator has
to be content with each file, where it is installed: `npm install gltf-validator` beside this, LITTORAL_GLTF_VALIDATOR
names the folder of the package."""

import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkRenderingCore import vtkCamera

import littoral
from glb import Glb, matrix, smooth

if not hasattr(littoral, "vtkGLTFSceneWriter"):
    print("built without tinygltf")
    sys.exit(125)

from littoral.glb import write_glb  # noqa: E402

VALIDATOR = os.environ.get("LITTORAL_GLTF_VALIDATOR", "")
VALIDATE = """
const validator = require(process.argv[1]), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])))
  .then(report => console.log(JSON.stringify(report.issues)));
"""
ZUP = matrix((0, 0, 0), (-np.sqrt(0.5), 0, 0, np.sqrt(0.5)), (1, 1, 1))


def make(name, *inputs, **settings):
    """An object of a class with inputs, by ports, and properties."""
    made = getattr(littoral, name)()
    made.kept = inputs
    for port, source in enumerate(inputs):
        made.SetInputConnection(port, source.GetOutputPort())
    for name_, value in settings.items():
        setter = getattr(made, "Set" + name_)
        setter(*value) if isinstance(value, tuple) else setter(value)
    return made


def tree(**settings):
    """A small tree, or one of a preset."""
    small = {"Preset": 0, "NumberOfLeaves": 200, "MainBranches": 8, "SideBranches": 4}
    return make("vtkReevesTreeSource", **{**small, **settings})


def sites(count=40, side=60.0):
    at = np.random.default_rng(3).uniform(-0.5 * side, 0.5 * side, (count, 2))
    return points_of(np.column_stack((at, 0.05 * at[:, 0])))


def points_of(places, lines=False):
    """Points in double precision, on which a line may run."""
    points, data = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.asarray(places, np.float64), deep=True))
    data.SetPoints(points)
    if lines:
        data.Allocate(1)
        data.InsertNextCell(4, len(places), list(range(len(places))))
    return data


def forest(prototypes, count=40, **settings):
    made = littoral.vtkPlantScatterFilter()
    made.kept = prototypes
    made.SetInputData(0, sites(count))
    for prototype in prototypes:
        made.AddPrototypeConnection(prototype.GetOutputPort())
    for name, value in {"UseCulling": False, "FaceCamera": False, "OutputForm": 1, **settings}.items():
        getattr(made, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    made.Update()
    return made


def block(blocks, *names):
    for name in names:
        blocks, = [blocks.GetBlock(k) for k in range(blocks.GetNumberOfBlocks())
                   if blocks.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) == name]
    return blocks


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def places(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def linear(colors):
    """Linear light of sRGB from 0 to 1 (IEC 61966-2-1)."""
    return np.where(colors <= 0.04045, colors / 12.92, ((colors + 0.055) / 1.055) ** 2.4)


def texels_of(png):
    """The texels of an 8-bit RGBA PNG, rows from above: undoes its filters."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    columns, rows, depth, kind = struct.unpack_from(">IIBB", png, 16)
    assert (depth, kind) == (8, 6)
    at, packed = 8, b""
    while at < len(png):
        size, name = struct.unpack_from(">I4s", png, at)
        packed += png[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += 12 + size
    lines = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(rows, 1 + 4 * columns)
    image = np.zeros((rows + 1, columns + 1, 4), np.int64)  # with a border of zeros above and to the left
    for y, line in enumerate(lines, 1):
        values = line[1:].reshape(columns, 4).astype(np.int64)
        for x in range(1, columns + 1):
            left, up, corner = image[y, x - 1], image[y - 1, x], image[y - 1, x - 1]
            near = left + up - corner
            pa, pb, pc = abs(near - left), abs(near - up), abs(near - corner)
            paeth = np.where((pa <= pb) & (pa <= pc), left, np.where(pb <= pc, up, corner))
            guess = (0, left, up, (left + up) // 2, paeth)[line[0]]
            image[y, x] = (values[x - 1] + guess) % 256
    return image[1:, 1:].astype(np.uint8)


def complaint(data=None, **settings):
    """What write_glb says of something bad; nothing may be left in the folder."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            write_glb(settings.pop("filename", os.path.join(folder, "bad.glb")), data, **settings)
        except OSError as error:
            assert not os.listdir(folder), os.listdir(folder)
            assert str(error).lower().count("cannot write") == 1, error
            return str(error)
        raise AssertionError("nothing was refused")


class Written(unittest.TestCase):
    """Files in a folder of their own, each of which the validator has to accept."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.name = os.path.join(temporary.name, "scene.glb")

    def write(self, sources, **settings):
        write_glb(self.name, sources, **settings)
        self.validate()
        return Glb(self.name)

    def validate(self):
        if VALIDATOR and shutil.which("node"):
            ran = subprocess.run(["node", "-e", VALIDATE, VALIDATOR, self.name], capture_output=True, text=True, check=True)
            issues = json.loads(ran.stdout)
            bad = [m for m in issues["messages"] if m["severity"] < 2]
            self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), bad[:3])


class Validator(unittest.TestCase):
    def test_is_there(self):
        if not VALIDATOR or not shutil.which("node"):
            self.skipTest("LITTORAL_GLTF_VALIDATOR does not name the package gltf-validator, or there is no node")
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "bad.glb")
            write_glb(name, {"A": points_of([(0, 0, 0), (1, 0, 0)])})
            with open(name, "rb") as file:
                text = file.read().replace(b'"mode":0', b'"mode":9')
            with open(name, "wb") as file:
                file.write(text)
            ran = subprocess.run(["node", "-e", VALIDATE, VALIDATOR, name], capture_output=True, text=True, check=True)
            self.assertGreater(json.loads(ran.stdout)["numErrors"], 0, "the validator accepts a mode 9")


class Meshes(Written):
    def test_a_plant(self):
        plant = tree()
        plant.Update()
        g = self.write({"Tree": plant})
        root = g.scenes[0]["nodes"][0]
        np.testing.assert_allclose(g.matrices()[root], ZUP, atol=1e-7)
        high = g.child(root, "Tree", "High")
        for name, kind in (("Skin", "bark"), ("Leaves", "leaf")):
            data, node = block(plant.GetOutput(), "High", name), g.child(high, name)
            np.testing.assert_array_equal(g.attribute(node, "POSITION"), places(data))
            accessor = g.accessors[g.primitive(node)["attributes"]["POSITION"]]
            np.testing.assert_array_equal(accessor["min"], places(data).min(axis=0))
            np.testing.assert_array_equal(accessor["max"], places(data).max(axis=0))
            np.testing.assert_allclose(g.attribute(node, "NORMAL"), array(data, "Normals"), atol=1e-5)
            np.testing.assert_allclose(g.attribute(node, "COLOR_0"), linear(array(data, "RGB") / 255.0), atol=1e-5)
            uv = array(data, "TCoords")
            np.testing.assert_allclose(g.attribute(node, "TEXCOORD_0"), np.column_stack((uv[:, 0], 1 - uv[:, 1])), atol=1e-6)
            corners = g.array(g.primitive(node)["indices"])
            polygons = data.GetPolys()
            self.assertEqual(len(corners), 3 * (polygons.GetNumberOfConnectivityIds() - 2 * data.GetNumberOfCells()))
            material = g.materials[g.primitive(node)["material"]]
            self.assertEqual(material["extras"], {"kind": kind})
            self.assertEqual(material.get("alphaMode"), "MASK" if name == "Leaves" else None)
            self.assertEqual(material.get("doubleSided"), True if name == "Leaves" else None)

    def test_faces_look_outwards(self):
        """The normals of triangles, by the order of corners, are those of the vertices."""
        plant = tree()
        g = self.write({"Tree": plant, "Land": make("vtkTurningBandsTerrainSource", WholeExtent=(0, 30, 0, 20, 0, 0))})
        for node in (g.child(g.named("High")[0], "Skin"), g.named("Land")[0]):
            corners = g.attribute(node, "POSITION")[g.array(g.primitive(node)["indices"]).reshape(-1, 3)]
            of_faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            of_vertices = g.attribute(node, "NORMAL")[g.array(g.primitive(node)["indices"]).reshape(-1, 3)].mean(axis=1)
            some = np.linalg.norm(of_faces, axis=1) > 1e-9
            self.assertGreater(np.mean(np.einsum("ij,ij->i", of_faces, of_vertices)[some] > 0), 0.99)

    def test_a_picture(self):
        plant = tree(TextureSize=(32, 16))
        plant.Update()
        g = self.write({"Tree": plant})
        crown = block(plant.GetOutput(), "Medium", "Crown")
        fields = crown.GetFieldData()
        columns, rows = vtk_to_numpy(fields.GetArray("TextureSize")).ravel()
        texels = vtk_to_numpy(fields.GetArray("Texture")).reshape(rows, columns, 4)
        node = g.child(g.named("Medium")[0], "Crown")
        material = g.materials[g.primitive(node)["material"]]
        texture = g.textures[material["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
        png = g.view(g.images[texture["source"]]["bufferView"])
        np.testing.assert_array_equal(texels_of(png), texels[::-1])
        mean = vtk_to_numpy(fields.GetArray("TextureMean")).ravel()
        colors = np.minimum(1.0, array(crown, "RGB") / 255.0 / mean)
        np.testing.assert_allclose(g.attribute(node, "COLOR_0"), linear(colors), atol=1e-5)

    def test_levels_of_a_plant(self):
        plant = tree()
        g = self.write({"Tree": plant})
        high = g.child(g.named("Tree")[0], "High")
        ids = g.nodes[high]["extensions"]["MSFT_lod"]["ids"]
        self.assertEqual([g.nodes[k]["name"] for k in ids], ["Medium", "Low"])
        self.assertTrue(all(k < 0 for k in np.array(g.parents())[ids]), "a coarser level is drawn as well")
        for form, name in ((2, "High"), (3, "Medium"), (4, "Low"), (1, "High")):
            g = self.write({"Tree": plant}, LevelForm=form)
            below = g.nodes[g.named("Tree")[0]]["children"]
            self.assertEqual([g.nodes[k]["name"] for k in below], [name])
            self.assertNotIn("extensionsUsed", g.json)

    def test_terrain_sea_and_particles(self):
        land = make("vtkTurningBandsTerrainSource", WholeExtent=(0, 30, 0, 20, 0, 0))
        tiles = make("vtkTerrainLevelOfDetailFilter", land, UseCulling=False)
        state = make("vtkSeaStateSource", NumberOfTrains=8)
        sea = make("vtkSeaSurfaceFilter", state, Radius=40.0)
        dust = make("vtkSuspendedParticleSource", Density=0.05)
        sources = {"Land": land, "Tiles": tiles, "Sea": sea, "Dust": dust}
        g = self.write(sources, kinds={"Dust": "plain"})
        kinds = {name: g.materials[g.primitive(g.named(name)[0])["material"]]["extras"]["kind"] for name in ("Land", "Sea", "Dust")}
        self.assertEqual(kinds, {"Land": "ground", "Sea": "water", "Dust": "plain"})
        heights = array(land.GetOutput(), "Elevation")
        node, = g.named("Land")
        world = g.attribute(node, "POSITION")
        at = np.array([land.GetOutput().GetPoint(k) for k in range(len(heights))])
        np.testing.assert_allclose(world[:, :2], at[:, :2], atol=1e-5)
        np.testing.assert_allclose(world[:, 2], heights, atol=1e-5)
        self.assertEqual(len(g.array(g.primitive(node)["indices"])), 6 * 30 * 20)
        np.testing.assert_array_equal(g.attribute(g.named("Sea")[0], "POSITION"), places(sea.GetOutput()))
        dust_node, = g.named("Dust")
        self.assertEqual(g.primitive(dust_node)["mode"], 0)
        np.testing.assert_array_equal(g.attribute(dust_node, "_RADIUS")[:, 0], array(dust.GetOutput(), "Radius"))
        levels = [g.nodes[k]["name"] for k in g.nodes[g.named("Tiles")[0]]["children"]]
        shown = [name for name in ("Level0", "Level1", "Level2", "Level3", "Level4", "Seams")
                 if block(tiles.GetOutput(), name) and block(tiles.GetOutput(), name).GetNumberOfCells() > 0]
        self.assertEqual(levels, shown)

    def land(self, heights, spacing=(2.0, 5.0)):
        """Positions, normals and colors of a terrain in its own order, NaN where it has a hole."""
        image = vtkImageData()
        image.SetDimensions(heights.shape[1], heights.shape[0], 1)
        image.SetSpacing(*spacing, 1.0)
        values = numpy_to_vtk(heights.ravel().astype(float), deep=True)
        values.SetName("Elevation")
        image.GetPointData().SetScalars(values)
        g = self.write({"Land": image})
        node, = g.named("Land")
        at = g.attribute(node, "POSITION") + g.nodes[node].get("translation", (0.0, 0.0, 0.0))
        rows = np.rint(at[:, 1] / spacing[1]).astype(int), np.rint(at[:, 0] / spacing[0]).astype(int)
        found = []
        for name in ("NORMAL", "COLOR_0"):
            whole = np.full((*heights.shape, 3), np.nan)
            whole[rows] = g.attribute(node, name)[:, :3]
            found.append(whole)
        return found

    def test_normals_of_a_plane(self):
        """A plane has one normal, also at its border and beside a hole, and whatever the spacing."""
        x, y = np.meshgrid(2.0 * np.arange(9), 5.0 * np.arange(7))
        plane = 0.3 * x - 0.2 * y
        plane[3, 4] = np.nan
        normals, _ = self.land(plane)
        there = np.isfinite(normals[..., 0])
        self.assertEqual(there.sum(), plane.size - 1)
        wanted = np.array((-0.3, 0.2, 1.0)) / np.sqrt(1.13)
        np.testing.assert_allclose(normals[there], np.broadcast_to(wanted, normals[there].shape), atol=1e-6)

    def test_colors_of_the_ground(self):
        """Meadows are green, what is steeper than 45 degrees is grey rock; a land on a plateau has the colors of the same
        land by the sea, and its upland is not green."""
        x = np.broadcast_to(2.0 * np.arange(40), (12, 40))
        land = np.where(x < 30.0, 0.0, 1.5 * (x - 30.0))
        _, colors = self.land(land)
        flat, steep = colors[:, 5], colors[:, 30]
        self.assertGreater((flat[:, 1] - flat[:, [0, 2]].max(axis=1)).min(), 0.02)
        self.assertGreater((steep[:, 0] - steep[:, 1]).min(), 0.0)
        np.testing.assert_allclose(steep, np.broadcast_to(linear(np.array((128.0, 122.0, 112.0)) / 255.0), steep.shape),
                                   atol=1e-4)
        hills = np.broadcast_to(0.4 * 2.0 * np.arange(40), (12, 40))
        np.testing.assert_allclose(self.land(hills + 1000.0)[1], self.land(hills)[1], atol=1e-5)
        ends = self.land(hills)[1]
        self.assertGreater(np.abs(ends[:, 1] - ends[:, -2]).max(), 0.02)

    def test_opacity_and_points_without_a_normal(self):
        """Opacity is linear, unlike colors; a normal of no length points up; vertices may be as many as a type has."""
        data = points_of([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
        data.Allocate(1)
        data.InsertNextCell(5, 3, [0, 1, 2])
        shades = np.array([(200, 100, 50, 128), (200, 100, 50, 255), (200, 100, 50, 0)], np.uint8)
        colors = numpy_to_vtk(shades, deep=True)
        colors.SetName("RGB")
        data.GetPointData().AddArray(colors)
        normals = numpy_to_vtk(np.array([(0, 0, 0), (0, 3, 0), (-2, 0, 0)], np.float32), deep=True)
        normals.SetName("Normals")
        data.GetPointData().SetNormals(normals)
        g = self.write({"A": data})
        node, = g.named("A")
        np.testing.assert_allclose(g.attribute(node, "COLOR_0")[:, 3], shades[:, 3] / 255.0, atol=1e-5)
        np.testing.assert_allclose(g.attribute(node, "COLOR_0")[:, :3], linear(shades[:, :3] / 255.0), atol=1e-5)
        np.testing.assert_array_equal(g.attribute(node, "NORMAL"), [(0, 0, 1), (0, 1, 0), (-1, 0, 0)])
        # 65535 says that a strip ends, and so is no index of 16 bits.
        for count, kind in ((65535, 5123), (65536, 5125)):
            g = self.write({"A": points_of(np.zeros((count, 3)))})
            self.assertEqual(g.accessors[g.primitive(g.named("A")[0])["indices"]]["componentType"], kind)

    def test_wet_ground(self):
        """Where water gathers, the color of the ground is another one; on ridges it is as on dry ground."""
        x, y = np.meshgrid(np.arange(-20, 21), np.arange(41))
        valley = vtkImageData()
        valley.SetDimensions(41, 41, 1)
        valley.SetSpacing(10.0, 10.0, 1.0)
        heights = numpy_to_vtk((3.0 * np.abs(x) + 0.5 * y).ravel().astype(float), deep=True)
        heights.SetName("Elevation")
        valley.GetPointData().SetScalars(heights)
        drainage = littoral.vtkDrainageFilter()
        drainage.SetInputData(valley)
        drainage.CarveOff()
        found = {}
        for name, source in (("dry", valley), ("wet", drainage)):
            g = self.write({"Land": source})
            found[name] = g.attribute(g.named("Land")[0], "COLOR_0").reshape(41, 41, -1)
        away = np.abs(found["wet"] - found["dry"]).max(axis=2)
        self.assertGreater(away[:30, 20].min(), 0.02)
        self.assertEqual(away[:, np.abs(x[0]) > 10].max(), 0.0)

    def test_plain_data(self):
        far = points_of(np.array([(0, 0, 0), (0.25, 0, 0), (0.25, 0.125, 0), (1, 1, 1)]) + (4.5e5, 5.4e6, 100.0), lines=True)
        velocity = numpy_to_vtk(np.arange(12, dtype=np.float32).reshape(4, 3), deep=True)
        velocity.SetName("Velocity")
        far.GetPointData().AddArray(velocity)
        pentagon = points_of([(np.cos(a), np.sin(a), 0.0) for a in np.arange(5) * 0.4 * np.pi])
        pentagon.Allocate(1)
        pentagon.InsertNextCell(7, 5, [0, 1, 2, 3, 4])
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, pentagon)
        blocks.SetBlock(2, vtkPolyData())
        g = self.write({"Café": far, "Blocks": blocks}, WriteVelocity=True)
        node, = g.named("Café")
        world = g.attribute(node, "POSITION").astype(np.float64) + g.nodes[node]["translation"]
        np.testing.assert_allclose(world, places(far), atol=1e-6)  # though single precision has 0.5 m there
        self.assertEqual(g.array(g.primitive(node)["indices"]).ravel().tolist(), [0, 1, 1, 2, 2, 3])
        self.assertEqual(g.primitive(node)["mode"], 1)
        np.testing.assert_array_equal(g.attribute(node, "_VELOCITY"), np.arange(12).reshape(4, 3))
        below = g.nodes[g.named("Blocks")[0]]["children"]
        self.assertEqual([g.nodes[k]["name"] for k in below], ["Block 0"])
        corners = g.attribute(below[0], "POSITION")[g.array(g.primitive(below[0])["indices"]).reshape(-1, 3)]
        area = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2].sum()
        self.assertAlmostEqual(area, 2.5 * np.sin(0.4 * np.pi), places=5)
        self.assertNotIn("_VELOCITY", self.write({"Far": far}).primitive(0)["attributes"])

    def test_a_list_of_sources(self):
        g = self.write([sites(), tree()])
        below = [g.nodes[k]["name"] for k in g.nodes[g.scenes[0]["nodes"][0]]["children"]]
        self.assertEqual(below, ["Source 0", "Source 1"])

    def test_same_bytes(self):
        wood = forest([tree()])
        for _ in range(2):
            self.write({"Forest": wood})
            with open(self.name, "rb") as file:
                first, self.bytes = getattr(self, "bytes", None), file.read()
        self.assertEqual(first, self.bytes)


class Views(Written):
    def test_camera_and_sun(self):
        camera = vtkCamera()
        camera.SetPosition(3.0, -20.0, 7.0)
        camera.SetFocalPoint(1.0, 2.0, 3.0)
        camera.SetViewUp(0.1, 0.2, 1.0)
        camera.SetViewAngle(40.0)
        extras = {"water": {"level": 0.5, "extinction": [0.4, 0.1, 0.05]}, "volumes": [{"file": "fog.vdb", "kind": "fog"}]}
        g = self.write({"A": sites()}, camera=camera, sun=(140.0, 35.0, 80000.0), extras=extras)
        self.assertEqual(g.scenes[0]["extras"], extras)
        self.assertNotIn("extras", self.write({"A": sites()}, extras={"volumes": []}).scenes[0])
        node, = g.named("Camera")
        world = g.matrices()[node]
        view = camera.GetViewTransformMatrix()
        wanted = ZUP @ np.linalg.inv([[view.GetElement(i, j) for j in range(4)] for i in range(4)])
        np.testing.assert_allclose(world, wanted, atol=1e-9)
        self.assertAlmostEqual(g.cameras[0]["perspective"]["yfov"], np.radians(40.0), places=12)
        sun, = g.named("Sun")
        light = g.extensions["KHR_lights_punctual"]["lights"][g.nodes[sun]["extensions"]["KHR_lights_punctual"]["light"]]
        self.assertEqual((light["type"], light["intensity"]), ("directional", 80000.0))
        a, e = np.radians((140.0, 35.0))  # from north to the east, and up
        towards = ZUP[:3, :3] @ (np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e))
        np.testing.assert_allclose(-g.matrices()[sun][:3, 2], -towards, atol=1e-9)


class Instances(Written):
    def setUp(self):
        super().setUp()
        self.forest = forest([tree(), make("vtkSeaweedSource", SegmentsPerBranch=4)], ViewPoint=(0.0, 0.0, 2.0),
                             NearDistance=10.0, FarDistance=25.0)
        self.points = block(self.forest.GetOutput(), "Instances")

    def placed(self, g, node, row):
        """The places of a part at an instance."""
        names = g.nodes[node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
        at = {name: g.array(index)[row] for name, index in names.items()}
        own = matrix(at["TRANSLATION"], at["ROTATION"], at["SCALE"])
        points = g.attribute(node, "POSITION").astype(np.float64)
        return points @ own[:3, :3].T + own[:3, 3]

    def merged(self, plant, level, part):
        """The same by vtkPlantScatterFilter, for a plant by its PlantId, as it merges plants."""
        self.forest.SetOutputForm(0)
        self.forest.Update()
        data = block(self.forest.GetOutput(), level, part)
        mine = places(data)[array(data, "PlantId") == plant]
        self.forest.SetOutputForm(1)
        self.forest.Update()
        return mine

    def test_as_shown(self):
        g = self.write({"Forest": self.forest}, LevelForm=1)
        prototypes, plants = array(self.points, "Prototype"), array(self.points, "PlantId")
        for number, level in ((1, "0 High"), (2, "0 Medium"), (4, "1 High"), (5, "1 Medium")):
            rows = np.flatnonzero(prototypes == number)
            if not len(rows):
                continue
            for part in g.nodes[g.child(g.named("Forest")[0], level)]["children"]:
                attributes = g.nodes[part]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
                np.testing.assert_array_equal(g.array(attributes["TRANSLATION"]), places(self.points)[rows])
                name = g.nodes[part]["name"]
                wanted = self.merged(plants[rows[0]], level.split()[1], name)
                np.testing.assert_allclose(self.placed(g, part, 0), wanted, atol=1e-5)
                self.assertEqual("_TINT" in attributes, name in ("Leaves", "Crown"))
                if "_TINT" in attributes:
                    np.testing.assert_allclose(
                        g.array(attributes["_TINT"]), array(self.points, "Tint")[rows] ** 2.2, rtol=1e-5)
        kinds = {m["extras"]["kind"] for m in g.materials}
        self.assertEqual(kinds, {"bark", "leaf", "blade"})
        self.assertGreater(len(np.unique(prototypes)), 3, "the forest has too few levels to tell")

    def test_switched(self):
        g = self.write({"Forest": self.forest})
        species = array(self.points, "Species")
        for k in (0, 1):
            high = g.child(g.named("Forest")[0], f"{k} High")
            self.assertEqual([g.nodes[j]["name"] for j in g.nodes[high]["extensions"]["MSFT_lod"]["ids"]],
                             [f"{k} Medium", f"{k} Low"])
            for level in (high, *g.nodes[high]["extensions"]["MSFT_lod"]["ids"]):
                for part in g.nodes[level]["children"]:
                    index = g.nodes[part]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"]
                    np.testing.assert_array_equal(g.array(index), places(self.points)[species == k])

    def test_grass(self):
        """A kind that is told is that of all parts of a source's instances."""
        g = self.write({"Trees": self.forest, "Grass": forest([tree(Seed=4)])}, LevelForm=2, kinds={"Grass": "grass"})
        found = {}
        for name in ("Trees", "Grass"):
            parts = [part for level in g.nodes[g.named(name)[0]]["children"] for part in g.nodes[level]["children"]]
            found[name] = {g.materials[g.primitive(part)["material"]]["extras"]["kind"] for part in parts}
            self.assertTrue(all("EXT_mesh_gpu_instancing" in g.nodes[part]["extensions"] for part in parts))
        self.assertEqual(found, {"Trees": {"bark", "leaf", "blade"}, "Grass": {"grass"}})

    def test_a_scale_for_each_axis(self):
        """Plants of an inventory are as wide as their trunks and as high as they are."""
        blocks = vtkMultiBlockDataSet()
        blocks.ShallowCopy(self.forest.GetOutput())
        points = block(blocks, "Instances")
        wide = array(points, "Scale")
        scales = numpy_to_vtk(np.column_stack((0.5 * wide, 0.7 * wide, 2.0 * wide)).astype(np.float32), deep=True)
        scales.SetName("Scale")
        points.GetPointData().AddArray(scales)
        g = self.write({"Forest": blocks}, LevelForm=2)
        high = g.child(g.named("Forest")[0], "0 High")
        index = g.nodes[g.nodes[high]["children"][0]]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"]
        np.testing.assert_array_equal(g.array(index), vtk_to_numpy(scales)[array(points, "Species") == 0])

    def test_nodes(self):
        tints = array(self.points, "Tint") ** 2.2
        g = self.write({"Forest": self.forest}, InstanceForm=1, LevelForm=2)
        below = g.nodes[g.named("Forest")[0]]["children"]
        self.assertEqual(len(below), self.points.GetNumberOfPoints())
        h = self.write({"Forest": self.forest}, LevelForm=2)
        worlds, row = g.matrices(), 0
        for group in h.nodes[h.named("Forest")[0]]["children"]:
            part = h.nodes[group]["children"][1]
            self.assertEqual(h.nodes[part]["name"], "Leaves")
            count = h.accessors[h.nodes[part]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"]]["count"]
            for k in range(count):
                node = g.child(below[row], "Leaves")
                points = np.column_stack((g.attribute(node, "POSITION"), np.ones(len(g.attribute(node, "POSITION")))))
                world = points @ worlds[node].T @ np.linalg.inv(ZUP).T
                np.testing.assert_allclose(world[:, :3], self.placed(h, part, k), atol=1e-5)
                plant = np.argmin(np.linalg.norm(places(self.points) - g.nodes[below[row]]["translation"], axis=1))
                np.testing.assert_allclose(g.nodes[node]["extras"]["tint"], tints[plant], rtol=1e-5)
                row += 1
        self.assertEqual(row, len(below))


class Refused(unittest.TestCase):
    def test_values(self):
        nan = sites()
        places(nan)[3, 1] = np.nan
        for data, words in (
                ({"A": nan}, "A"), ({"A": vtkPolyData()}, "A has no points"), ({}, "there is no input"),
                ({"A": vtkTable()}, "A is a vtkTable"), ({"A": vtkUnstructuredGrid()}, "A is a vtkUnstructuredGrid")):
            self.assertIn(words, complaint(data))
        self.assertIn("not in UTF-8", complaint_of_name(b"Caf\xe9"))
        for settings, words in (
                ({"CameraViewAngle": 180.0, "WriteCamera": True}, "CameraViewAngle is 180 degrees"),
                ({"CameraFocalPoint": (0.0, 0.0, 1.0), "WriteCamera": True}, "CameraFocalPoint must not be CameraPosition"),
                ({"SunDirection": (0.0, 0.0, 0.0), "WriteSun": True}, "SunDirection must not be zero"),
                ({"Extras": "[1]"}, "Extras must be an object"), ({"Extras": "{"}, "Extras must be an object"),
                ({"times": (2.0, 1.0)}, "EndTime is 1 s"), ({"LevelForm": 7}, "LevelForm is 7")):
            self.assertIn(words, complaint({"A": sites()}, **settings))
        with self.assertRaises(ValueError):
            write_glb("a.glb", {"A": sites()}, kinds={"B": "leaf"})
        with self.assertRaises(ValueError):
            write_glb("a.glb", {"A": sites()}, kinds={"A": "stone"})

    def test_textures(self):
        for spoil, words in (
                (lambda d: d.GetFieldData().RemoveArray("TextureSize"), "TextureSize"),
                (lambda d: d.GetFieldData().RemoveArray("Texture"), "has a TextureSize and no Texture"),
                (lambda d: d.GetPointData().RemoveArray("TCoords"), "no texture coordinates")):
            plant = tree()
            plant.Update()
            leaves = vtkPolyData()
            leaves.DeepCopy(block(plant.GetOutput(), "High", "Leaves"))
            spoil(leaves)
            self.assertIn(words, complaint({"Leaves": leaves}))

    def test_size(self):
        """Beyond 32 bits: one large block with colors, 28 bytes a point, again and again."""
        count = 500000
        large, colors = points_of(np.zeros((count, 3))), vtkUnsignedCharArray()
        colors.SetName("RGB")
        colors.SetNumberOfComponents(4)
        colors.SetNumberOfTuples(count)
        colors.Fill(255)
        large.GetPointData().AddArray(colors)
        self.assertIn("a GLB file holds at most 4.29 GB",
                      complaint({f"Part {k}": large for k in range((1 << 32) // (28 * count) + 1)}))

    def test_files(self):
        self.assertIn("FileName is empty", complaint({"A": sites()}, filename=""))
        self.assertIn("there is no folder nowhere.", complaint({"A": sites()}, filename="nowhere/a.glb"))
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("it is a folder", complaint({"A": sites()}, filename=folder))

    def test_a_source_that_fails(self):
        writer = littoral.vtkGLTFSceneWriter()
        bad = make("vtkQuadratPointSource", MeanPerQuadrat=-1.0)
        for thing in (bad, bad.GetExecutive()):
            thing.AddObserver("ErrorEvent", lambda *_: None)
        writer.SetInputConnection(bad.GetOutputPort())
        writer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        with tempfile.TemporaryDirectory() as folder:
            writer.SetFileName(os.path.join(folder, "a.glb"))
            said = []
            writer.AddObserver("ErrorEvent", lambda *_: said.append(1))
            self.assertEqual(writer.Write(), 0)
            self.assertEqual(os.listdir(folder), [])


def complaint_of_name(name):
    """What the writer says of a block's name that Python could not hand over as a string."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, sites())
    blocks.GetMetaData(0).Set(vtkCompositeDataSet.NAME(), name)
    return complaint({"A": blocks})


if __name__ == "__main__":
    unittest.main()
