# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch together=ParaView args=. args=128 args=72 args=2 args=--quick
"""A walk through a forest in the wind, on measured terrain.

    ./littoral gui Examples/ParaView/forest.py      opens it in ParaView
    pvbatch forest.py FOLDER [WIDTH HEIGHT FRAMES] [--quick]
                                                    writes forest.png, the frames of the walk,
                                                    the film walk.ogv and the wind as wind.vdb
                                                    into FOLDER

The terrain is a refined part of the elevation model of the Jacksboro fault. Meadows, woods and rock follow its drainage
and its slopes, trees are in its woods, and brooks run where its water gathers.
Levels of detail of terrain and trees follow the camera. Trees near the camera sway in a turbulent wind. Sun, sky, clouds,
shadows, grass and the water of the brooks are those of Landscape Light.
"""

import os
import sys

import numpy as np
from paraview import simple

import littoral
from littoral.gallery import views
from littoral.gallery.arguments import folder_size_frames
from littoral.gallery.country import jacksboro, wood_sites
from littoral.gallery.heights import sampled

#: Start, end and focal point of the walk [m].
FIRST, LAST, TARGET = (7000.0, 8250.0), (6968.0, 8218.0), (4200.0, 3200.0)
EYE_HEIGHT, VIEW_ANGLE = 7.0, 30.0
#: Frames per second, and wind speed [m/s].
RATE, WIND_SPEED = 12, 16.0
SPECIES = (("Pine", 3), ("Oak", 5), ("Birch", 2), ("Shrub", 4))  # and seed of the prototype
#: Trees along the walk: distance ahead and to the right [m], and species.
NEAR_TREES = (
    (52, -21, 1), (78, -27, 2), (86, -34, 2), (70, 24, 2), (95, 33, 1), (118, 22, 0), (135, 30, 0),
    (150, 41, 0), (47, 17, 3), (160, -50, 1), (185, -36, 0), (200, -44, 0),
    (170, 10, 3), (210, 62, 1), (235, 48, 2), (140, -16, 2), (240, -10, 1), (260, 2, 1))
#: Camera motion [m] and rotation [degrees] after which levels of detail are updated.
STEADY = dict(MoveTolerance=10.0, TurnTolerance=2.0)
#: A morning's sun from the side. The brooks are above the level of the water, at which an eye goes under.
LIGHT = dict(SunElevation=18.0, SunAzimuth=106.0, Turbidity=2.0, VisibilityDistance=22000.0, CloudCover=0.3,
             ExposureCompensation=0.65, ShadowDistance=400.0, CoverRadius=120.0, CoverHeight=0.6,
             CoverColor=[0.50, 0.52, 0.25], WaterLevel=-100.0, WaterSlopeVariance=0.04)


def eye_at(terrain, share):
    """Position of the camera at a fraction of the walk."""
    place = (1.0 - share) * np.array(FIRST) + share * np.array(LAST)
    return np.array((*place, sampled(terrain, *place) + EYE_HEIGHT))


def near_trees(count=None):
    """The first so many or all trees along the walk: positions and species."""
    ahead = np.array(TARGET) - FIRST
    ahead /= np.hypot(*ahead)
    right = np.array((ahead[1], -ahead[0]))
    distance, aside, species = np.array(NEAR_TREES[:count]).T
    return FIRST + distance[:, None] * ahead + aside[:, None] * right, species


def wind_center():
    """Center of the swaying trees, which are not far ahead."""
    ahead = np.array(TARGET) - FIRST
    return FIRST + 350.0 * ahead / np.hypot(*ahead)


def build(folder, view, quick=False):
    """Build the pipeline and show it in a view; quick: with coarse ground and few trees. Returns the terrain."""
    data = os.path.join(folder, "data")
    os.makedirs(data, exist_ok=True)
    drainage = jacksboro(1 if quick else 3)
    woods = wood_sites(drainage.GetOutput(), *(80.0, near_trees(4)) if quick else (9.0, near_trees()))

    terrain = views.reader("Country", drainage.GetOutput(), data)
    terrain.PointArrayStatus = [name for name in terrain.PointArrayStatus if name != "DepressionDepth"]  # of no use here
    sites = views.reader("Sites", woods, data)
    brooks = simple.RiverSurface(registrationName="Brooks", Input=views.reader(
        "Courses", drainage.GetOutputDataObject(1), data), Terrain=terrain)
    trees = [simple.ReevesTree(registrationName=name, Preset=name, Seed=seed)
             for name, seed in SPECIES]
    ground = simple.TerrainLevelOfDetail(
        registrationName="Ground", Input=terrain, **STEADY)
    forest = simple.PlantScatter(
        registrationName="Forest", Sites=sites, Prototypes=trees, Terrain=terrain,
        NearDistance=260.0, FarDistance=700.0, PassJoints=False, PassSurfaces=False, **STEADY)
    wind = simple.WindField(
        registrationName="Wind", Dimensions=[60 if quick else 600, 128, 10], LateralSpacing=12.5,
        ReferenceSpeed=WIND_SPEED, RoughnessLength=0.1, Center=list(wind_center()))
    sway = simple.BeamTreeDeformation(
        registrationName="Forest in the wind", Input=forest, Wind=wind, Prototypes=trees,
        OverwriteFrames=True)

    views.light(view, Quality="Good" if quick else "Best", **LIGHT)
    look(drainage.GetOutput(), view, 0.0)
    for each in (ground, brooks):
        simple.Show(each, view)
    simple.Show(sway, view).BlockSelectors = ["/Root/High/Skin", "/Root/High/Leaves", "/Root/Medium"]
    simple.Show(forest, view).BlockSelectors = ["/Root/Low"]  # what does not move is not made again for each frame
    for each in (ground, sway, forest):  # the same pictures at each run: VTK shifts all blocks by one that lies anywhere
        simple.GetRepresentation(each, view).CoordinateShiftScaleMethod = "Disable"
    if hasattr(littoral, "vtkVDBVolumeWriter"):
        views.save_volume(os.path.join(folder, "wind.vdb"), wind)
    heights_alone(drainage.GetOutput())
    return drainage.GetOutput()


def heights_alone(terrain):
    """Drop all arrays but the heights, which the camera follows: the files have them."""
    arrays = terrain.GetPointData()
    for name in [arrays.GetArrayName(index) for index in range(arrays.GetNumberOfArrays())]:
        if name != "Elevation":
            arrays.RemoveArray(name)


def look(terrain, view, share):
    """Point the camera at a fraction of the walk."""
    target = np.array((*TARGET, sampled(terrain, *TARGET) - 60.0))
    views.look(view, eye_at(terrain, share), target, VIEW_ANGLE)


def plan_walk(terrain, view, frames):
    """Set the camera path of a view; Play in ParaView follows it."""
    scene = simple.GetAnimationScene()
    scene.PlayMode, scene.NumberOfFrames = "Sequence", frames
    scene.StartTime, scene.EndTime = 0.0, (frames - 1) / RATE
    stops = []
    for share in np.linspace(0.0, 1.0, 5):
        look(terrain, view, share)
        stops.append(simple.CameraKeyFrame(
            KeyTime=share, Position=view.CameraPosition, FocalPoint=view.CameraFocalPoint,
            ViewUp=view.CameraViewUp, ViewAngle=VIEW_ANGLE))
    track = simple.GetCameraTrack(view)
    track.Mode, track.KeyFrames = "Interpolate Camera", stops
    look(terrain, view, 0.0)


def film_walk(terrain, view, folder, frames, told):
    """Write the frames of the walk and the film; `told` is called before each frame."""
    def turn_to(frame):
        look(terrain, view, frame / max(1, frames - 1))
        view.ViewTime = frame / RATE

    views.film_view(os.path.join(folder, "walk.ogv"), view, frames, RATE, turn_to, told)


def main(folder, size, frames=0, quick=False, told=lambda frame, frames: None):
    """Build the scene, write its image and, with frames above 0, the walk; quick: a coarse one, as a test."""
    simple._DisableFirstRenderCameraReset()
    os.makedirs(folder, exist_ok=True)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(size)
    terrain = build(folder, view, quick)
    plan_walk(terrain, view, frames or 120)
    views.save_view(os.path.join(folder, "forest.png"), view)
    if frames:
        film_walk(terrain, view, folder, frames, told)


if __name__ != "forest":  # another script has run this one for its functions
    main(**folder_size_frames(sys.argv[1:]))
