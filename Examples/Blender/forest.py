# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A walk through thick woods on measured terrain, for Blender's path tracer.

    ./littoral render Examples/Blender/forest.py [FOLDER]   the picture
    python3 forest.py FILE.glb [FRAME]                      the scene alone

Place, species and camera are those of Examples/ParaView/forest.py; all trees are in full, as instances.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from littoral import landscape, scene, vtkPlantScatterFilter, vtkReevesTreeSource
from littoral.glb import write_glb

#: Start, end and focal point of the walk [m], height of the eye [m] and vertical angle of view [degrees].
FIRST, LAST, TARGET = (7300.0, 8200.0), (7268.0, 8168.0), (4200.0, 3200.0)
EYE_HEIGHT, VIEW_ANGLE, FRAMES = 2.3, 36.0, 120
SUN = (150.0, 33.0)  # azimuth and elevation [degrees]
#: Farthest trees [m], and half the angle within which there are trees [degrees].
REACH, HALF_ANGLE = 4200.0, 34.0
#: Species with the seed of the prototype.
SPECIES = (("Pine", 3), ("Oak", 5), ("Birch", 2), ("Shrub", 4))
#: Trees that stand about the walk: distance ahead and to the right [m], and species.
NEAR_TREES = (
    (17, -9.5, 1), (22, 10.5, 2), (30, 12, 2), (29, -13, 2), (38, -17, 1), (37, 20, 1), (44, -9, 2), (52, 13, 0),
    (58, -19, 0), (47, 17, 3), (60, -8, 3), (66, 15, 1), (72, -14, 2), (80, 19, 2), (88, -16, 0))
#: The grove about the walk: reach [m], mean distance of trees [m], and half the width of the glade in it [m] at the
#: camera and at the reach.
GROVE, APART, GLADE = 620.0, 7.0, (12.0, 34.0)
GRASS_REACH = 75.0  # [m]
#: A tuft of grass, as a shrub without wood.
GRASS = dict(
    Height=0.40, CrownRadius=0.30, CrownBase=0.0, TrunkRadius=0.004, TrunkReach=0.3, Orders=1, MainBranches=2,
    BranchAngle=35.0, Lift=0.3, NumberOfLeaves=40, LeafSize=0.34, LeafWidth=0.035)


def ahead():
    """The direction of the walk's view, and that to its right."""
    along = np.subtract(TARGET, FIRST)
    along /= np.hypot(*along)
    return along, np.array((along[1], -along[0]))


def near_trees():
    """The trees along the walk: positions and species."""
    along, right = ahead()
    distance, aside, species = np.array(NEAR_TREES).T
    return FIRST + distance[:, None] * along + aside[:, None] * right, species.astype(int)


def grove(country, seed=6):
    """Sites and species of a grove with a glade along the view."""
    along, right = ahead()
    random = np.random.default_rng(seed)
    width = 2.0 * (GROVE * np.tan(np.radians(HALF_ANGLE)) + 45.0)
    count = int(GROVE * width / APART**2)
    far, aside = random.uniform(12.0, GROVE, count), random.uniform(-0.5, 0.5, count) * width
    at = FIRST + far[:, None] * along + aside[:, None] * right
    winding = 14.0 * np.sin(far / 55.0) * np.clip(far / 150.0, 0.0, 1.0)
    glade = GLADE[0] + (GLADE[1] - GLADE[0]) * far / GROVE
    patches = np.sin(at[:, 0] / 31.0 + 1.0) * np.sin(at[:, 1] / 43.0)
    stays = (np.abs(aside - winding) > glade * (1.0 + 0.5 * patches)) & (random.random(count) < 0.75 + 0.35 * patches)
    stays &= np.abs(aside) < 40.0 + np.tan(np.radians(HALF_ANGLE)) * far
    edge = np.exp(-(np.abs(aside - winding) - glade) / 18.0)
    chance = random.random(count)
    species = np.where(chance < 0.30 * edge, 2, np.where(chance < 0.62, 1, 0))
    return at[stays], species[stays]


def in_view(places, reach, half_angle):
    """Which places are before the camera, or close to it, so that their shadows fall into the picture."""
    along, right = ahead()
    away = places[:, :2] - FIRST
    far, aside = away @ along, away @ right
    return (far < reach) & (far > -40.0) & (np.abs(aside) < 45.0 + np.tan(np.radians(half_angle)) * np.abs(far))


def ground(country):
    """The terrain with its reflectance as RGB: the light comes from Blender."""
    color = scene.natural_color(country.z, country.spacing)
    array = numpy_to_vtk(np.round(255.0 * np.clip(color, 0, 1) ** (1 / 2.2)).astype(np.uint8).reshape(-1, 3), deep=True)
    array.SetName("RGB")
    country.image.GetPointData().AddArray(array)
    return country.image


def trees(country):
    """Sites of all trees in the view."""
    alone = [np.concatenate(pair) for pair in zip(near_trees(), grove(country))]
    sites = landscape.wood_sites(country, (2500.0, 2500.0), (5600.0, 6200.0), 16.0)
    places = vtk_to_numpy(sites.GetPoints().GetData()).astype(float)
    along, _ = ahead()
    seen = in_view(places, REACH, HALF_ANGLE) & ((places[:, :2] - FIRST) @ along > GROVE)
    species = vtk_to_numpy(sites.GetPointData().GetArray("Species"))[seen]
    places = np.concatenate((places[seen], np.column_stack((alone[0], country.height(*alone[0].T)))))
    return landscape.points_with(places, Species=np.concatenate((species, alone[1])).astype(np.int32))


def on_ground(country, count, reach, seed, nearest=3.0, power=1.5):
    """Random places before the camera, denser near it; and random numbers to go on with."""
    along, right = ahead()
    random = np.random.default_rng(seed)
    far = nearest + reach * random.random(count)**power
    aside = random.uniform(-1.0, 1.0, count) * (2.0 + 0.62 * far)
    at = FIRST + far[:, None] * along + aside[:, None] * right
    return np.column_stack((at, country.height(*at.T))), random


def tufts(country):
    """Sites of grass: in patches, and lower in the shade between."""
    places, random = on_ground(country, 60000, GRASS_REACH, 3)
    x, y = places[:, :2].T
    patches = 0.5 + 0.28 * (np.sin(x / 1.9 + 2.0 * np.sin(y / 3.1)) + np.sin(y / 2.3 + np.sin(x / 4.7)))
    stays = random.random(len(places)) < 0.25 + 0.75 * patches
    scale = np.clip(0.35 + 0.75 * patches + random.normal(0.0, 0.18, len(places)), 0.25, 1.5)
    return landscape.points_with(places[stays], Scale=scale[stays])


def bushes(country):
    """Sites of undergrowth: seedlings and shrubs, few in the glade."""
    places, random = on_ground(country, 2600, 180.0, 5, 6.0, 1.2)
    along, right = ahead()
    aside = np.abs((places[:, :2] - FIRST) @ right)
    stays = random.random(len(places)) < np.clip((aside - 2.0) / 9.0, 0.04, 1.0)
    scale = 0.18 + 0.65 * random.random(len(places))**2.5
    return landscape.points_with(places[stays], Scale=scale[stays])


def scattered(sites, prototypes, **settings):
    """Plants as instances on sites."""
    plants = vtkPlantScatterFilter()
    plants.SetInputData(0, sites)
    for prototype in prototypes:
        plants.AddPrototypeConnection(prototype.GetOutputPort())
    plants.SetOutputFormToInstances()
    plants.SetUseLevels(False)
    plants.SetUseCulling(False)
    for name, value in settings.items():
        getattr(plants, "Set" + name)(value)
    return plants


def tree(preset, seed):
    source = vtkReevesTreeSource()
    source.SetPreset(getattr(source, preset))
    source.SetSeed(seed)
    return source


def tuft():
    source = vtkReevesTreeSource()
    source.SetPresetToCustom()
    for name, value in GRASS.items():
        getattr(source, "Set" + name)(value)
    source.SetLeafFormToBlade()
    source.SetLeafColor(0.50, 0.56, 0.26)
    source.SetBarkColor(0.55, 0.58, 0.30)
    return source


def write_scene(filename, frame=0):
    """Write the scene at a frame of the walk."""
    country = landscape.Country()
    share = frame / FRAMES
    place = (1.0 - share) * np.array(FIRST) + share * np.array(LAST)
    eye = (*place, country.height(*place) + EYE_HEIGHT)
    focus = (*TARGET, country.height(*TARGET) - 60.0)
    sources = {
        "Ground": ground(country),
        "Forest": scattered(trees(country), [tree(*species) for species in SPECIES]),
        "Undergrowth": scattered(bushes(country), [tree("Shrub", 4)], TintVariation=0.10),
        "Grass": scattered(tufts(country), [tuft()], TintVariation=0.10)}
    write_glb(
        filename, sources, camera=(eye, focus, (0.0, 0.0, 1.0), VIEW_ANGLE), sun=(*SUN, 100000.0), kinds={"Grass": "grass"},
        extras={"fog": {"sight": 2600.0, "height": 160.0}, "exposure": 1.5}, LevelForm=2)


if __name__ == "__main__":
    write_scene(sys.argv[1], *map(int, sys.argv[2:3]))
