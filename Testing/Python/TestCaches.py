# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Point caches: the bytes of a sea and of particles as VTK has them; bad motions are refused with the old file as it was;
Blender's modifier moves vertices to where VTK has its points. The last is skipped without Blender or tinygltf."""

import os
import shutil
import struct
import subprocess
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

import littoral
from littoral.caches import read_pc2, write_pc2
from TestFiles import full_disk

#: Prints the places of vertices of all objects with the modifier, evaluated at frames 1, 3 and 5.
DUMP = """
import bpy, sys
import numpy as np
things = [thing for thing in bpy.data.objects if any(m.type == "MESH_CACHE" for m in thing.modifiers)]
for thing in things:
    for m in list(thing.modifiers):
        if m.type != "MESH_CACHE":
            thing.modifiers.remove(m)
    for frame in (1, 3, 5):
        bpy.context.scene.frame_set(frame)
        mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
        at = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", at)
        at.tofile(f"{thing.name.split()[0]}_{frame}.raw")
assert bpy.context.scene.frame_end >= 5
"""


def sea(radius=30.0):
    state, surface = littoral.vtkSeaStateSource(), littoral.vtkSeaSurfaceFilter()
    state.SetNumberOfTrains(12)
    surface.kept = state
    surface.SetInputConnection(state.GetOutputPort())
    surface.SetRadius(radius)
    return surface


def particles():
    dust, state, orbits = (littoral.vtkSuspendedParticleSource(), littoral.vtkSeaStateSource(),
                           littoral.vtkParticleOrbitFilter())
    dust.SetDensity(0.02)
    orbits.kept = dust, state
    orbits.SetInputConnection(0, dust.GetOutputPort())
    orbits.SetSeaStateConnection(state.GetOutputPort())
    return orbits


def places(source, time):
    source.UpdateTimeStep(time)
    return vtk_to_numpy(source.GetOutput().GetPoints().GetData()).copy()


class Spoiled(VTKPythonAlgorithmBase):
    """Two triangles that `spoil(data, time)` changes."""

    def __init__(self, spoil):
        super().__init__(nInputPorts=0, outputType="vtkPolyData")
        self.spoil = spoil

    def RequestInformation(self, request, inputs, outputs):
        outputs.GetInformationObject(0).Set(Pipeline.TIME_RANGE(), (0.0, 1.0), 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        time = outputs.GetInformationObject(0).Get(Pipeline.UPDATE_TIME_STEP())
        data = vtkPolyData.GetData(outputs)
        set_places(data, [(0, 0, time), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
        data.Allocate(2)
        data.InsertNextCell(5, 3, [0, 1, 2])
        data.InsertNextCell(5, 3, [0, 2, 3])
        self.spoil(data, time)
        return 1


def set_places(data, rows):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.asarray(rows, np.float64).reshape(-1, 3), deep=True))
    data.SetPoints(points)


def more_points(data, time):
    if time > 0.4:
        set_places(data, np.zeros((5, 3)))


def other_cells(data, time):
    if time > 0.4:
        data.DeleteCells()
        data.Allocate(2)
        data.InsertNextCell(5, 3, [0, 1, 3])
        data.InsertNextCell(5, 3, [1, 2, 3])


def not_a_number(data, time):
    if time > 0.4:
        set_places(data, [(0, 0, 0), (1, 0, np.nan), (1, 1, 0), (0, 1, 0)])


def nothing(data, time):
    data.Initialize()


class Caches(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.name = os.path.join(self.folder, "motion.pc2")

    def test_bytes(self):
        for source in (sea(), particles()):
            write_pc2(self.name, source, (2.0, 3.0, 8.0))
            with open(self.name, "rb") as file:
                data = file.read()
            signature, version, points, start, step, samples = struct.unpack_from("<12siiffi", data)
            self.assertEqual((signature, version, start, step, samples), (b"POINTCACHE2\0", 1, 0.0, 1.0, 9))
            self.assertEqual(points, source.GetOutput().GetNumberOfPoints())
            self.assertGreater(points, 100)
            self.assertEqual(len(data), 32 + 12 * points * samples)
            for sample in (0, 5, 8):
                at = np.array(struct.unpack_from(f"<{3 * points}f", data, 32 + 12 * points * sample)).reshape(-1, 3)
                np.testing.assert_array_equal(at, places(source, 2.0 + sample / 8.0).astype(np.float32))
            self.assertGreater(np.abs(read_pc2(self.name)[8] - read_pc2(self.name)[0]).max(), 0.1)

    def test_blocks_and_places(self):
        tree = littoral.vtkReevesTreeSource()
        tree.SetNumberOfLeaves(40)
        write_pc2(self.name, tree, (0.0, 1.0, 2.0), block="High/Leaves", origin=(5e5, 0.0, 10.0))
        leaves = tree.GetOutput().GetBlock(0)
        leaves = next(leaves.GetBlock(k) for k in range(leaves.GetNumberOfBlocks())
                      if leaves.GetMetaData(k).Get(leaves.NAME()) == "Leaves")
        at = vtk_to_numpy(leaves.GetPoints().GetData()) - (5e5, 0.0, 10.0)
        np.testing.assert_allclose(read_pc2(self.name)[1], at, rtol=1e-7)

    def test_refused(self):
        write_pc2(self.name, sea(), (0.0, 1.0, 4.0))
        with open(self.name, "rb") as file:
            old = file.read()
        tree = littoral.vtkReevesTreeSource()
        for source, times, block, words in (
                (Spoiled(more_points), (0.0, 1.0, 4.0), "", "at 0.5 s there are 5 points, and 4 at 0 s"),
                (Spoiled(other_cells), (0.0, 1.0, 4.0), "", "at 0.5 s the cells are other ones than at 0 s"),
                (Spoiled(not_a_number), (0.0, 1.0, 4.0), "", "at 0.5 s point 1 is not finite"),
                (Spoiled(nothing), (0.0, 1.0, 4.0), "", "at 0 s there are no points"),
                (sea(), (1.0, 1.0), "", "a later end"), (sea(), (0.0, np.inf), "", "a later end"),
                (sea(), (0.0, 1.0, 0.0), "", "a positive rate"), (sea(radius=-1.0), (0.0, 1.0), "", "Radius"),
                (tree, (0.0, 1.0), "", "vtkMultiBlockDataSet, and no vtkPolyData"),
                (tree, (0.0, 1.0), "High/Wood", "there is no block Wood")):
            with self.assertRaisesRegex(ValueError, words):
                write_pc2(self.name, source, times, block)
            with open(self.name, "rb") as file:
                self.assertEqual(file.read(), old, words)
        self.assertEqual(os.listdir(self.folder), ["motion.pc2"])
        for data in (b"", old[:-1], old + b"0", b"X" + old[1:]):
            with open(self.name, "wb") as file:
                file.write(data)
            with self.assertRaises(ValueError):
                read_pc2(self.name)
        with self.assertRaises(OSError):
            write_pc2(os.path.join(self.folder, "none", "a.pc2"), sea(), (0.0, 1.0, 4.0))

    def test_full_disk(self):
        with full_disk(1 << 16) as folder:
            name = os.path.join(folder, "motion.pc2")
            write_pc2(name, Spoiled(lambda *_: None), (0.0, 1.0, 4.0))
            old = read_pc2(name)
            with self.assertRaisesRegex(OSError, "No space left on device: '.*motion.pc2'"):
                write_pc2(name, sea(), (0.0, 3.0, 24.0))
            np.testing.assert_array_equal(read_pc2(name), old)
            self.assertEqual(os.listdir(folder), ["motion.pc2"])

    def test_blender(self):
        if not shutil.which("blender") or not hasattr(littoral, "vtkGLTFSceneWriter"):
            self.skipTest("without Blender (package blender) or tinygltf")
        from littoral import blender
        from littoral.glb import write_glb

        os.chdir(self.folder)
        sources = {"Sea": sea(), "Dust": particles()}
        for name, source in sources.items():
            write_pc2(name + ".pc2", source, (1.0, 2.0, 4.0))
            source.UpdateTimeStep(1.0)
        write_glb("sea.glb", sources, camera=((0, -60, 20), (0, 0, 0), (0, 0, 1), 40.0),
                  extras={"caches": {"Sea": "Sea.pc2", "Dust": "Dust.pc2"}})
        blender.render("sea.glb", blend="sea.blend")
        with open("dump.py", "w", encoding="utf-8") as script:
            script.write(DUMP)
        environment = {name: value for name, value in os.environ.items() if name not in blender.OTHERS}
        ran = subprocess.run(["blender", "-b", os.path.abspath("sea.blend"), "--python-exit-code", "1", "-P", "dump.py"],
                             env=dict(environment, PWD=self.folder), capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        for name, source in sources.items():
            for frame in (1, 3, 5):
                at = np.fromfile(f"{name}_{frame}.raw", np.float32).reshape(-1, 3)
                np.testing.assert_allclose(at, places(source, 1.0 + 0.25 * (frame - 1)), atol=1e-5, err_msg=name)
        shutil.copyfile("Sea.pc2", "Dust.pc2")
        with self.assertRaisesRegex(blender.RenderError, "Dust.pc2 has [0-9]+ points, and Dust"):
            blender.render("sea.glb", blend="sea.blend")


if __name__ == "__main__":
    unittest.main()
