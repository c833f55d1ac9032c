# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""ExportView writes what a view shows as one scene of glTF; TestLegends exports one in the window, TestServer a wood where
the data are."""
import os
import sys

import numpy as np
import quick  # noqa: F401
from paraview import servermanager, simple
from scene_files import below_root, scene_of

if not hasattr(servermanager.writers, "GLTFSceneWriter"):
    print("built without tinygltf")
    sys.exit(125)


def exported(name, view, **options):
    if os.path.exists(name):
        os.remove(name)
    simple.ExportView(name, view=view, **options)
    return scene_of(name)


def triangles(scene):
    return sum(scene["accessors"][part["indices"]]["count"] // 3 for mesh in scene["meshes"] for part in mesh["primitives"]
               if part.get("mode", 4) == 4)


def sun_of(scene):
    """Direction towards the sun of a scene, in its own axes as ParaView has them."""
    sun, = [node for node in scene["nodes"] if node.get("name") == "Sun"]
    x, y, z, w = sun["rotation"]
    return np.array((2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)))


def camera_of(scene):
    """Where the camera is, where it looks to, and its angle, below the root node, where z is up."""
    node, = [node for node in scene["nodes"] if "camera" in node]
    x, y, z, w = node["rotation"]
    ahead = -np.array((2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)))
    return np.array(node["translation"]), ahead, scene["cameras"][node["camera"]]["perspective"]["yfov"]


def check_script():
    view = simple.CreateRenderView()
    land = simple.TurningBandsTerrain(WholeExtent=[0, 20, 0, 10, 0, 0])
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)
    simple.RenameSource("Café", tree)
    text = simple.Text(Text="no surface")
    for source in (tree, land, text):  # a terrain alone would bring a Landscape Light
        simple.Show(source, view)
    simple.Render(view)  # the first look places the camera
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [10, -30, 12], [10, 5, 2], [0, 0, 1]
    view.CameraViewAngle = 40
    simple.Render(view)
    scene = exported("all.glb", view, SceneName="Place", LevelForm="High")
    assert below_root(scene) == ["Café", "Camera", "Sun", "TurningBandsTerrain1"], below_root(scene)
    assert scene["scenes"][0]["name"] == "Place"
    place, ahead, angle = camera_of(scene)
    np.testing.assert_allclose(place, (10, -30, 12), atol=1e-5)
    np.testing.assert_allclose(ahead, np.array((0, 35, -10)) / np.hypot(10, 35), atol=1e-6)
    assert abs(angle - np.radians(40.0)) < 1e-6
    towards = sun_of(scene)
    light = simple.GetLight(0, view)
    place, focus = (np.array(light.GetProperty(name).GetData()) for name in ("LightPosition", "FocalPoint"))
    wanted = place - focus
    np.testing.assert_allclose(towards, wanted / np.linalg.norm(wanted), atol=1e-6)
    whole = triangles(scene)

    # That of Landscape Light is where it is in the sky, by its angles and by the clock, and none is there at night.
    landscape = simple.Show(simple.LandscapeLight(), view, SunElevation=30.0, SunAzimuth=120.0)
    towards = sun_of(exported("lit.glb", view))
    np.testing.assert_allclose(towards, (np.sin(np.pi / 3) * np.cos(np.pi / 6), -np.cos(np.pi / 3) * np.cos(np.pi / 6), 0.5),
                               atol=1e-6)
    landscape.SunPlacement, landscape.Date, landscape.Hours = "Clock", [2003, 10, 17], 19.508333
    landscape.Latitude, landscape.Longitude = 39.742476, -105.1786
    towards = sun_of(exported("clock.glb", view))
    assert abs(np.degrees(np.arccos(towards[2])) - 50.111) < 0.02  # Reda and Andreas (2004)
    landscape.SunPlacement, landscape.SunElevation = "Angles", -20.0
    assert "Sun" not in below_root(exported("night.glb", view))
    landscape.Visibility = 0

    # What is hidden is left out, what is shown twice is there once; the options of the dialog.
    simple.Hide(tree, view)
    simple.Hide(text, view)
    second = simple.CreateRenderView()
    simple.Show(tree, second)
    scene = exported("land.glb", view, WriteCamera=0, WriteSun=0)
    assert below_root(scene) == ["TurningBandsTerrain1"] and triangles(scene) == 2 * 20 * 10 < whole
    view.CameraParallelProjection = 1
    assert below_root(exported("flat.glb", view)) == ["Sun", "TurningBandsTerrain1"]
    view.CameraParallelProjection = 0
    assert below_root(exported("again.glb", view)) == ["Camera", "Sun", "TurningBandsTerrain1"]
    scene = exported("second.glb", second, LevelForm="High", WriteSun=0)
    assert below_root(scene) == ["Café", "Camera"] and triangles(scene) == whole - 2 * 20 * 10

    # The time is that of the view, and the file has the motion that is asked for.
    simple.Delete(tree)
    sea = simple.SeaSurface(Input=simple.SeaState(NumberOfTrains=6), Radius=20)
    simple.Show(sea, second)
    second.ViewTime = 3.0
    simple.Render(second)
    now = exported("now.glb", second)
    second.ViewTime = 4.0
    later = exported("later.glb", second)
    bounds = [scene["accessors"][scene["meshes"][0]["primitives"][0]["attributes"]["POSITION"]] for scene in (now, later)]
    points = servermanager.Fetch(sea)
    assert bounds[0]["count"] == points.GetNumberOfPoints() and bounds[0]["max"] != bounds[1]["max"]
    scene = exported("motion.glb", second, WriteMotion=1, EndTime=0.5, FramesPerSecond=4.0)
    assert len(scene["meshes"][0]["primitives"][0]["targets"]) == 2 and len(scene["animations"]) == 1


def wood(name):
    """A view of a terrain with trees as instances, exported."""
    simple.ResetSession()
    view = simple.CreateRenderView()
    land = simple.TurningBandsTerrain(WholeExtent=[0, 20, 0, 10, 0, 0])
    trees = simple.PlantScatter(
        Sites=simple.QuadratPoints(Quadrats=[4, 4]),
        Prototypes=[simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)],
        OutputForm="Instances", UseCulling=0, FollowCamera=0)
    for source, text in ((land, "Land"), (trees, "Wood")):
        simple.RenameSource(text, source)
        simple.Show(source, view)
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [10, -30, 12], [10, 5, 2], [0, 0, 1]
    simple.Render(view)
    scene = exported(name, view)
    assert {"Land", "Wood", "Camera", "Sun"} <= set(below_root(scene)), below_root(scene)
    with open(name, "rb") as file:
        return file.read()


if __name__ == "__main__":
    check_script()
    print("done")
