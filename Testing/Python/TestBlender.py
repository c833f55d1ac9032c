# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Scenes in Blender: counts, places and materials of what VTK has; films that go on after an interruption, full disks, motion
blur, EEVEE. Skipped without Blender. Materials and volumes are in TestBlenderLight."""

import json
import os
import shutil
import subprocess
import sys
import tempfile

import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

import littoral
from littoral import blender
from TestFiles import full_disk

if not hasattr(littoral, "vtkGLTFSceneWriter"):
    print("built without tinygltf")
    sys.exit(125)
from littoral.glb import write_glb  # noqa: E402

TINY = dict(size=[24, 16], samples=1)
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "guide", "blender.md")


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


#: What a saved scene holds when it is opened again.
OPENED = """
import bpy, json, sys
instances = sum(one.is_instance for one in bpy.context.evaluated_depsgraph_get().object_instances)
kinds = sorted({material.get("kind", "") for material in bpy.data.materials} - {""})
camera = bpy.context.scene.camera
with open("opened.json", "w") as out:
    json.dump({"instances": instances, "kinds": kinds, "camera": list(camera.matrix_world.translation),
               "engine": bpy.context.scene.render.engine,
               "pictures": [i.packed_file is not None for i in bpy.data.images if i.type == "IMAGE"]}, out)
"""


def check_page():
    """The lines of the guide's page make a picture, and a .blend that is whole when it is opened."""
    with open(PAGE, encoding="utf-8") as page:
        lines = page.read().split("```python\n")[1].split("```")[0]
    assert lines.count("samples=16") == 1
    names = {}
    exec(lines.replace("samples=16", "samples=1, size=[32, 18]"), names)  # pylint: disable=exec-used
    assert blender.is_whole("wood.png")
    with open("opened.py", "w", encoding="utf-8") as script:
        script.write(OPENED)
    returned, said = blender.run([
        "blender", "-b", os.path.abspath("wood.blend"), "--python-exit-code", "1", "-P", os.path.abspath("opened.py")])
    assert returned == 0, said[-2000:]
    with open("opened.json", encoding="utf-8") as text:
        found = json.load(text)
    names["forest"].Update()
    shown = int(names["forest"].GetOutput().GetFieldData().GetArray("PlantsShown").GetTuple1(0))
    assert found["instances"] == shown > 20, (found, shown)
    assert found["kinds"] == ["bark", "leaf"] and found["engine"] == "CYCLES" and all(found["pictures"]), found
    np.testing.assert_allclose(found["camera"], (100, -150, 40), atol=1e-4)


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


def processes_with(word):
    """Ids of the processes whose command names a word, apart from this one."""
    found = []
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{process}/cmdline", "rb") as line:
                words = line.read()
        except OSError:
            continue
        if word.encode() in words and int(process) != os.getpid():
            found.append(int(process))
    return found


def check_orphan(file):
    """A Blender whose starter is killed, while it draws, ends too and leaves nothing behind."""
    folder = os.path.abspath("orphan")
    os.makedirs(folder)
    script = "orphan.py"
    with open(script, "w", encoding="utf-8") as text:
        text.write(f"import shutil\ndef write_scene(name, frame=0):\n    shutil.copyfile({os.path.abspath(file)!r}, name)\n")
    environment = {**os.environ, "TMPDIR": folder}
    with subprocess.Popen([*command(script, "out"), "--size", "1920", "1080", "--samples", "4000"], env=environment) as starter:
        until = time.monotonic() + 60.0
        while not processes_with(f"{folder}/littoral-") and time.monotonic() < until:
            time.sleep(0.05)
        time.sleep(4.0)  # at work
        assert starter.poll() is None and len(processes_with(f"{folder}/littoral-")) == 1
        starter.kill()
    until = time.monotonic() + 20.0
    while processes_with(f"{folder}/littoral-") and time.monotonic() < until:
        time.sleep(0.05)
    assert not processes_with(f"{folder}/littoral-"), "Blender lives on without its starter"
    assert not os.listdir(folder), os.listdir(folder)


def command(*words):
    return [sys.executable, "-B", "-m", "littoral.blender", *words, "--size", "24", "16", "--samples", "1"]


def check_film(file):
    """A film of 12 frames that is killed in the middle and begun again: whole pictures, those that are there stay."""
    pictures = [f"film/scene_{frame:04d}.png" for frame in range(12)]
    killed = subprocess.Popen(command(file, "film", "--frames", "0", "11"), stdout=subprocess.PIPE)
    until = time.monotonic() + 600.0
    while not os.path.exists(pictures[4]) and time.monotonic() < until:
        time.sleep(0.01)
    killed.kill()
    killed.wait()
    killed.stdout.close()
    made = [picture for picture in pictures if os.path.exists(picture)]
    assert 5 <= len(made) < 12 and all(blender.is_whole(picture) for picture in made), made
    for picture in made:
        os.utime(picture, (1e9, 1e9))
    ran = subprocess.run(command(file, "film", "--frames", "0", "11"), capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    lines = ran.stdout.splitlines()
    assert lines[0] == f"{len(made)} of 12 pictures are there" and len(lines) == 13 - len(made), lines
    assert "s left" in lines[1] and "s left" not in lines[-1], lines
    assert all(blender.is_whole(picture) for picture in pictures) and os.path.getsize("film/scene.ogv") > 100
    assert {picture for picture in pictures if os.path.getmtime(picture) == 1e9} == set(made)
    assert sorted(os.listdir("film")) == sorted([os.path.basename(p) for p in pictures] + ["scene.ogv"])


def check_full_disk(file):
    """One sentence, and the old picture stays, where the disk is full."""
    with full_disk(8192) as folder:
        picture = os.path.join(folder, "scene.png")
        with open(picture, "wb") as old:
            old.write(b"old")
        with open(os.path.join(folder, "filler"), "wb") as filler:
            filler.write(bytes(4096))
        ran = subprocess.run(command(file, folder), capture_output=True, text=True, check=False)
        assert ran.returncode == 1 and ran.stderr.count("\n") == 1 and "No space left on device" in ran.stderr, ran.stderr
        with open(picture, "rb") as old:
            assert old.read() == b"old"
        assert sorted(os.listdir(folder)) == ["filler", "scene.png"]


def pixels(name):
    """The picture as numbers [row, column, part], the lowest row first."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, -1).astype(float)


def square(velocity=None):
    """A white square of 1 m about the origin."""
    points, data = vtkPoints(), vtkPolyData()
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        points.InsertNextPoint(x, y, 0.0)
    data.SetPoints(points)
    data.Allocate(1)
    data.InsertNextCell(9, 4, [0, 1, 2, 3])
    if velocity:
        array = numpy_to_vtk(np.tile(np.float32(velocity), (4, 1)), deep=True)
        array.SetName("Velocity")
        data.GetPointData().AddArray(array)
    return data


ABOVE = dict(camera=((0.0, 0.0, 6.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 40.0), sun=(0.0, 80.0))


def check_motion_blur():
    """What moves by its own width while the shutter is open is twice as wide."""
    wide = {}
    write_glb("moving.glb", {"Square": square((float(blender.RATE), 0.0, 0.0))}, WriteVelocity=True, **ABOVE)
    for blur in (0.0, 1.0):
        blender.render("moving.glb", "moving.png", size=[96, 64], samples=64, blur=blur)
        row = pixels("moving.png")[32].sum(axis=1)
        wide[blur] = int((row > 0.15 * row.max()).sum())
    assert 1.6 * wide[0.0] < wide[1.0] < 2.1 * wide[0.0], wide
    write_glb("moving.glb", {"Square": square()}, **ABOVE)
    blender.render("moving.glb", "moving.png", size=[96, 64], samples=64, blur=1.0)
    row = pixels("moving.png")[32].sum(axis=1)
    assert abs(int((row > 0.15 * row.max()).sum()) - wide[0.0]) <= 1, wide


def check_noise(file):
    """A pixel whose noise is low gets no more samples: the picture is another one than with all of them, by little."""
    found = {}
    for noise in (0.0, 0.01, 1.0):
        blender.render(file, "noise.png", size=[48, 32], samples=96, noise=noise)
        found[noise] = pixels("noise.png")
    away = [np.abs(found[noise] - found[0.0]).mean() for noise in (0.01, 1.0)]
    assert away[0] < away[1] and 0.02 < away[1] < 1.0, away


def check_eevee():
    """The other engine draws what the path tracer draws."""
    write_glb("square.glb", {"Square": square()}, **ABOVE)
    found = {}
    for engine in ("cycles", "eevee"):
        blender.render("square.glb", f"{engine}.png", size=[48, 32], samples=16, engine=engine)
        found[engine] = pixels(f"{engine}.png").mean(axis=2)
    away = np.abs(found["cycles"] - found["eevee"])
    assert found["cycles"].max() > 40 and np.median(away) < 3 and away.mean() < 2, (away.mean(), found["cycles"].max())


def check_mistakes():
    """Wrong files are refused in one sentence each; nothing is left behind."""
    for scene_file, text in (("none.glb", "no scene none.glb"), ("broken.glb", "Blender has failed")):
        with open("broken.glb", "wb") as broken:
            broken.write(b"glTF and no more")
        try:
            blender.render(scene_file, "not.png", **TINY)
            raise AssertionError("a wrong file was rendered")
        except blender.RenderError as error:
            assert text in str(error), error
    assert not os.path.exists("not.png")
    os.makedirs("left")
    ran = subprocess.run(command("broken.glb", "not"), env={**os.environ, "TMPDIR": os.path.abspath("left")},
                         capture_output=True, text=True, check=False)
    assert "Blender has failed" in ran.stderr and not os.listdir("left"), (ran.stderr, os.listdir("left"))
    with open("no_scene.py", "w", encoding="utf-8") as script:
        script.write("pass\n")
    try:
        blender.write_scene("no_scene.py", "x.glb", 0)
        raise AssertionError("a script without a scene was taken")
    except blender.RenderError as error:
        assert "write_scene" in str(error), error


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        scene("scene.glb")
        check_without_blender("scene.glb")
        if not shutil.which("blender"):
            print("no Blender")
            sys.exit(125)
        check_contents("scene.glb")
        check_page()
        check_interruption("scene.glb")
        check_film("scene.glb")
        check_orphan("scene.glb")
        check_full_disk("scene.glb")
        check_motion_blur()
        check_noise("scene.glb")
        check_eevee()
        check_mistakes()
