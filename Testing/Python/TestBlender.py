# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in Blender: counts, places and materials of what VTK has; pictures that go on after an interruption. Skipped
without Blender."""

import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

import littoral
from littoral import blender

if not hasattr(littoral, "vtkGLTFSceneWriter"):
    print("built without tinygltf")
    sys.exit(125)
from littoral.glb import write_glb  # noqa: E402

TINY = dict(size=[24, 16], samples=1)


def scene(filename):
    """Five shrubs as instances on a plane that rises to the east; returns the sites and the terrain."""
    points = vtkPoints()
    for x, y in ((5, 5), (15, 6), (9, 14), (17, 17), (3, 16)):
        points.InsertNextPoint(x, y, 0.1 * x)
    sites = vtkPolyData()
    sites.SetPoints(points)
    shrub = littoral.vtkReevesTreeSource()
    shrub.SetPreset(shrub.Shrub)
    shrub.SetNumberOfLeaves(40)
    forest = littoral.vtkPlantScatterFilter()
    forest.SetInputData(0, sites)
    forest.AddPrototypeConnection(shrub.GetOutputPort())
    forest.SetOutputFormToInstances()
    forest.SetUseLevels(False)
    forest.SetUseCulling(False)
    terrain = littoral.vtkTurningBandsTerrainSource()
    terrain.SetWholeExtent(0, 20, 0, 20, 0, 0)
    terrain.Update()
    write_glb(filename, {"Forest": forest, "Ground": terrain}, camera=((10, -30, 12), (10, 10, 2), (0, 0, 1), 40.0),
              sun=(150.0, 40.0), LevelForm=2)
    shrub.Update()
    return sites, shrub.GetOutput(), terrain.GetOutput()


def check_without_blender(file):
    """One sentence with the name of the package, and nothing is written."""
    path, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
    try:
        ran = subprocess.run([sys.executable, "-B", "-m", "littoral.blender", file, "out"], capture_output=True, text=True,
                             check=False)
    finally:
        os.environ["PATH"] = path
    assert ran.returncode == 1 and ran.stderr.count("\n") == 1 and "package is blender" in ran.stderr, ran.stderr
    assert not os.listdir("out")


def polygons(block):
    """The triangles of a block's polygons and strips."""
    return sum(block.GetCell(k).GetNumberOfPoints() - 2 for k in range(block.GetNumberOfCells()))


def check_contents(file):
    """What Blender has is what VTK has."""
    import json

    sites, shrub, terrain = scene(file)
    blender.render(file, "scene.png", "scene.blend", "report.json", **TINY)
    with open("report.json", encoding="utf-8") as text:
        meshes = json.load(text)["meshes"]
    assert sorted(mesh["kinds"] for mesh in meshes.values()) == [["bark", "leaf"], ["ground"]], meshes
    shrubs, ground = sorted(meshes.values(), key=lambda mesh: mesh["kinds"])
    high = shrub.GetBlock(0)
    parts = {high.GetMetaData(k).Get(high.NAME()): high.GetBlock(k) for k in range(high.GetNumberOfBlocks())}
    assert shrubs["instances"] == 5
    assert shrubs["triangles"] == polygons(parts["Skin"]) + polygons(parts["Leaves"]), meshes
    bounds = terrain.GetBounds()
    heights = np.array(terrain.GetPointData().GetScalars().GetRange())
    assert ground["triangles"] == 2 * 20 * 20 and ground["instances"] == 1
    np.testing.assert_allclose([*ground["low"], *ground["high"]],
                               [bounds[0], bounds[2], heights[0], bounds[1], bounds[3], heights[1]], atol=1e-5)
    # Each instance stands on its site: the box of all reaches beyond the sites by less than a shrub.
    at = np.array([sites.GetPoint(k) for k in range(5)])
    size = np.abs(np.array(parts["Skin"].GetBounds())).max() * 1.6
    low, high = np.array(shrubs["low"]), np.array(shrubs["high"])
    assert (low > at.min(axis=0) - size).all() and (low < at.min(axis=0) + size).all(), (low, size)
    assert (high > at.max(axis=0) - 1e-3).all() and (high < at.max(axis=0) + size).all(), (high, size)
    assert os.path.getsize("scene.blend") > 10000
    reader = vtkPNGReader()
    reader.SetFileName("scene.png")
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (24, 16, 1)
    low, high = reader.GetOutput().GetPointData().GetScalars().GetRange()
    assert high > low + 20, "the picture is empty"


def check_interruption(file):
    """Whole pictures stay, others are made; a render that is killed leaves none in part."""
    shutil.copyfile("scene.png", "one.png")
    os.utime("one.png", (1e9, 1e9))
    with open("scene.png", "rb") as whole, open("two.png", "wb") as cut:
        cut.write(whole.read()[:-20])
    blender.render_frames(file, {1: "one.png", 2: "two.png"}, **TINY)
    assert os.path.getmtime("one.png") == 1e9 and blender.is_whole("two.png")
    killed = subprocess.Popen([sys.executable, "-B", "-m", "littoral.blender", file, "out", "--size", "24", "16"])
    try:
        killed.wait(0.7)
    except subprocess.TimeoutExpired:
        killed.kill()
        killed.wait()
    assert all(blender.is_whole(os.path.join("out", name)) for name in os.listdir("out"))


def check_mistakes():
    """Wrong files are refused in one sentence each."""
    for scene_file, text in (("none.glb", "no scene none.glb"), ("broken.glb", "Blender has failed")):
        with open("broken.glb", "wb") as broken:
            broken.write(b"glTF and no more")
        try:
            blender.render(scene_file, "not.png", **TINY)
            raise AssertionError("a wrong file was rendered")
        except blender.RenderError as error:
            assert text in str(error), error
    assert not os.path.exists("not.png")
    with open("no_scene.py", "w", encoding="utf-8") as script:
        script.write("pass\n")
    try:
        blender.write_scene("no_scene.py", "x.glb", 0)
        raise AssertionError("a script without a scene was taken")
    except blender.RenderError as error:
        assert "write_scene" in str(error), error


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    scene("scene.glb")
    check_without_blender("scene.glb")
    if not shutil.which("blender"):
        print("no Blender")
        sys.exit(125)
    check_contents("scene.glb")
    check_interruption("scene.glb")
    check_mistakes()
