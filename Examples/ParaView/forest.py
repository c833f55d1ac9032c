# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch args=. args=128 args=72 args=2 args=--quick
"""A walk through a forest in the wind, on measured terrain.

    ./littoral gui Examples/ParaView/forest.py      opens it in ParaView
    pvbatch forest.py FOLDER [WIDTH HEIGHT FRAMES] [--quick]
                                                    writes forest.png, the frames of the walk,
                                                    the film walk.ogv and the wind as wind.vdb
                                                    into FOLDER

The terrain is a refined part of the elevation model of the Jacksboro fault. Meadows, woods and rock follow its drainage
and its slopes, trees are in its woods, and brooks run where its water gathers.
Levels of detail of terrain and trees follow the camera. Trees near the camera sway in a turbulent
wind.
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import littoral
from littoral.gallery import country as countries
from littoral.gallery import landscape, sky, views
from littoral.gallery.arguments import folder_size_frames
from littoral.gallery.places import WOODS, jacksboro

#: Start, end and focal point of the walk [m].
FIRST, LAST, TARGET = (7000.0, 8250.0), (6968.0, 8218.0), (4200.0, 3200.0)
EYE_HEIGHT, VIEW_ANGLE = 7.0, 30.0
#: Frames per second, and wind speed [m/s].
RATE, WIND_SPEED = 12, 16.0
SPECIES = (("Pine", 3), ("Oak", 5), ("Birch", 2), ("Shrub", 4))  # and seed of the prototype
#: Radius of the crown of each species, and height of its center [m].
CROWNS = np.array(((2.0, 4.5), (4.8, 6.5), (2.2, 7.0), (1.3, 0.9)))
#: Trees along the walk: distance ahead and to the right [m], and species.
NEAR_TREES = (
    (52, -21, 1), (78, -27, 2), (86, -34, 2), (70, 24, 2), (95, 33, 1), (118, 22, 0), (135, 30, 0),
    (150, 41, 0), (47, 17, 3), (60, -8, 3), (160, -50, 1), (185, -36, 0), (200, -44, 0),
    (170, 10, 3), (210, 62, 1), (235, 48, 2), (140, -16, 2), (240, -10, 1), (260, 2, 1))
#: Distance of grass, of shadows and of brooks from the walk [m].
GRASS_REACH, SHADOW_REACH, BROOK_REACH = 70.0, 900.0, 2500.0
#: Camera motion [m] and rotation [degrees] after which levels of detail are updated.
STEADY = dict(MoveTolerance=10.0, TurnTolerance=2.0)
#: A tuft of grass, as a shrub without wood.
GRASS = dict(
    Preset="Custom", Height=0.40, CrownRadius=0.30, CrownBase=0.0, TrunkRadius=0.004,
    TrunkReach=0.3, Orders=1, MainBranches=2, BranchAngle=35.0, Lift=0.3, NumberOfLeaves=24,
    LeafSize=0.34, LeafWidth=0.06, LeafForm="Blade", LeafColor=[0.56, 0.60, 0.30],
    BarkColor=[0.55, 0.58, 0.30])


def eye_at(country, share):
    """Position of the camera at a fraction of the walk."""
    place = (1.0 - share) * np.array(FIRST) + share * np.array(LAST)
    return np.array((*place, country.height(*place) + EYE_HEIGHT))


def near_trees(country, count=None):
    """The first so many or all trees along the walk, but for those that would stand in a brook: positions and species."""
    ahead = np.array(TARGET) - FIRST
    ahead /= np.hypot(*ahead)
    right = np.array((ahead[1], -ahead[0]))
    distance, aside, species = np.array(NEAR_TREES[:count]).T
    places = FIRST + distance[:, None] * ahead + aside[:, None] * right
    dry = country.water.distance_to(places) > 1.5
    return places[dry], species[dry].astype(int)


def wind_center():
    """Center of the swaying trees, which are not far ahead."""
    ahead = np.array(TARGET) - FIRST
    return FIRST + 350.0 * ahead / np.hypot(*ahead)


def shadows_near(country, woods):
    """The shadows of the trees near the walk."""
    places = vtk_to_numpy(woods.GetPoints().GetData()).astype(float)
    species = vtk_to_numpy(woods.GetPointData().GetArray("Species"))
    near = np.hypot(*(places[:, :2] - eye_at(country, 0.5)[:2]).T) < SHADOW_REACH
    radius, height = CROWNS[species[near]].T
    return countries.shadows(country, places[near], radius, height)


def build(folder, view, quick=False):
    """Build the pipeline and show it in a view; quick: with coarse ground and few trees. Returns the country."""
    data = os.path.join(folder, "data")
    os.makedirs(data, exist_ok=True)
    country = jacksboro(1 if quick else 3)
    woods = countries.wood_sites(country, *WOODS, 80.0 if quick else 13.0, alone=near_trees(country, 4 if quick else None))
    clouds = os.path.join(data, "sky.png")
    sky.write_sky(clouds, *((384, 64) if quick else (6144, 1024)))

    terrain = views.reader("Country", country.image, data)
    sites = views.reader("Sites", woods, data)
    dome = views.reader("Sky", sky.sky_dome(eye_at(country, 0.5)), data)
    shadows = views.reader("Shadows", shadows_near(country, woods), data)
    brooks = views.reader("Brooks", countries.brook_bands(country, eye_at(country, 0.5), BROOK_REACH), data)
    trees = [simple.ReevesTree(registrationName=name, Preset=name, Seed=seed)
             for name, seed in SPECIES]
    ground = simple.TerrainLevelOfDetail(
        registrationName="Ground", Input=terrain, **STEADY)
    forest = simple.PlantScatter(
        registrationName="Forest", Sites=sites, Prototypes=trees, Terrain=terrain,
        NearDistance=260.0, FarDistance=700.0, **STEADY)
    wind = simple.WindField(
        registrationName="Wind", Dimensions=[60 if quick else 600, 128, 10], LateralSpacing=12.5,
        ReferenceSpeed=WIND_SPEED, RoughnessLength=0.1, Center=list(wind_center()))
    sway = simple.BeamTreeDeformation(
        registrationName="Forest in the wind", Input=forest, Wind=wind, Prototypes=trees)

    size = np.abs(np.subtract(FIRST, LAST)) + 2.0 * GRASS_REACH
    tufts = simple.QuadratPoints(
        registrationName="Tufts", Origin=list(np.minimum(FIRST, LAST) - GRASS_REACH),
        Size=list(size), Quadrats=[int(length / 2.0) for length in size], Law="Poisson Poisson",
        MeanPerQuadrat=0.5 if quick else 5.0, ClusterMean=3.0)
    # Of a near tuft only the blades, and of these what is seen: most of its memory is in wood and joints.
    blades = simple.PassArrays(
        registrationName="Blades", PointDataArrays=["Normals", "RGB", "TCoords"],
        FieldDataArrays=["Texture", "TextureSize", "TextureMean"],
        Input=simple.ExtractBlock(
            Input=simple.ReevesTree(registrationName="Tuft", **GRASS),
            Selectors=["/Root/High/Leaves", "/Root/Medium", "/Root/Low"]))
    grass = simple.PlantScatter(
        registrationName="Grass", Sites=tufts, Terrain=terrain, NearDistance=300.0,
        Prototypes=[blades], FarDistance=300.0,
        VisibleDistance=GRASS_REACH, ScaleVariation=0.35, TintVariation=0.04, **STEADY)

    landscape.prepare_view(view)
    look(country, view, 0.0)
    landscape.show_sky(dome, view, clouds)
    landscape.show_ground(ground, view)
    views.show_baked(brooks, view)
    views.show_baked(shadows, view)
    shown = landscape.show_plants(grass, view, ["/Root/High/Leaves"])
    shown.Ambient, shown.Diffuse = 0.75, 0.45  # translucency
    landscape.show_plants(sway, view, landscape.PLANT_PARTS[:-1])
    landscape.show_plants(forest, view, landscape.PLANT_PARTS[-1:])  # what does not move is not made again for each frame
    if hasattr(littoral, "vtkVDBVolumeWriter"):
        views.save_volume(os.path.join(folder, "wind.vdb"), wind)
    return country


def look(country, view, share):
    """Point the camera at a fraction of the walk."""
    target = np.array((*TARGET, country.height(*TARGET) - 60.0))
    views.look(view, eye_at(country, share), target, VIEW_ANGLE)


def plan_walk(country, view, frames):
    """Set the camera path of a view; Play in ParaView follows it."""
    scene = simple.GetAnimationScene()
    scene.PlayMode, scene.NumberOfFrames = "Sequence", frames
    scene.StartTime, scene.EndTime = 0.0, (frames - 1) / RATE
    stops = []
    for share in np.linspace(0.0, 1.0, 5):
        look(country, view, share)
        stops.append(simple.CameraKeyFrame(
            KeyTime=share, Position=view.CameraPosition, FocalPoint=view.CameraFocalPoint,
            ViewUp=view.CameraViewUp, ViewAngle=VIEW_ANGLE))
    track = simple.GetCameraTrack(view)
    track.Mode, track.KeyFrames = "Interpolate Camera", stops
    look(country, view, 0.0)


def film_walk(country, view, folder, frames, told):
    """Write the frames of the walk and the film; `told` is called before each frame."""
    def turn_to(frame):
        look(country, view, frame / max(1, frames - 1))
        view.ViewTime = frame / RATE

    views.film_view(os.path.join(folder, "walk.ogv"), view, frames, RATE, turn_to, told)


def main(folder, size, frames=0, quick=False, told=lambda frame, frames: None):
    """Build the scene, write its image and, with frames above 0, the walk; quick: a coarse one, as a test."""
    simple._DisableFirstRenderCameraReset()
    os.makedirs(folder, exist_ok=True)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(size)
    country = build(folder, view, quick)
    plan_walk(country, view, frames or 120)
    views.save_view(os.path.join(folder, "forest.png"), view)
    if frames:
        film_walk(country, view, folder, frames, told)


if __name__ != "forest":  # another script has run this one for its functions
    main(**folder_size_frames(sys.argv[1:]))
