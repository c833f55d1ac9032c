# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A walk through thick woods on measured terrain, for Blender's path tracer.

    ./littoral render Examples/Blender/forest.py [FOLDER]   the picture
    python3 forest.py FILE.glb [FRAME]                      the scene alone

The country is that of Examples/ParaView/forest.py, with a walk of its own; all trees are in full, as instances.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import vtkPlantScatterFilter, vtkReevesTreeSource
from littoral.gallery.country import jacksboro, wood_sites
from littoral.gallery.heights import sampled
from littoral.gallery.meshes import add_array, vertices
from littoral.glb import write_glb
from littoral.properties import set_properties

#: Start, end and focal point of the walk [m], height of the eye [m] and vertical angle of view [degrees].
FIRST, LAST, TARGET = (7300.0, 8200.0), (7268.0, 8168.0), (4200.0, 3200.0)
EYE_HEIGHT, VIEW_ANGLE, FRAMES = 2.3, 36.0, 120
SUN = (163.0, 31.0)  # azimuth and elevation [degrees]
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
GRASS_REACH = 95.0  # [m]
#: Color of the ground, hay, also where it is trodden.
HAY = (144, 138, 84)
#: Half the width of the path [m].
PATH = 0.55
#: A tuft of grass, as a shrub without wood.
GRASS = dict(
    Height=0.40, CrownRadius=0.30, CrownBase=0.0, TrunkRadius=0.004, TrunkReach=0.3, Orders=1, MainBranches=2,
    BranchAngle=35.0, Lift=0.3, NumberOfLeaves=40, LeafSize=0.34, LeafWidth=0.035)


#: A flower on its stalk, as a tree with few leaves at the top.
FLOWER = dict(
    Height=0.42, CrownRadius=0.05, CrownBase=0.35, TrunkRadius=0.003, TrunkReach=0.95, Orders=1, MainBranches=4,
    BranchAngle=70.0, Lift=0.0, NumberOfLeaves=9, LeafSize=0.065, LeafWidth=0.7)
#: A hazel, open and with shoots of unequal length.
HAZEL = dict(
    Height=3.4, CrownRadius=1.9, CrownBase=0.1, TrunkRadius=0.03, TrunkReach=0.3, Orders=3, MainBranches=9, SideBranches=6,
    BranchAngle=33.0, Lift=0.10, Variation=0.5, NumberOfLeaves=2600, LeafSize=0.15, LeafWidth=0.8)


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


def grove(seed=6):
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


def path(far):
    """Distance of the path to the right of the line of sight, at distances ahead [m]."""
    return 1.1 + 2.6 * np.sin(far / 13.0 - 0.35) * np.clip(far / 30.0, 0.15, 1.0) + 14.0 * np.sin(far / 55.0) * np.clip(
        (far - 60.0) / 150.0, 0.0, 1.0)


def off_path(places):
    """Distance of places from the middle of the path [m]."""
    along, right = ahead()
    away = places[:, :2] - FIRST
    return np.abs(away @ right - path(away @ along))


def in_view(places, reach, half_angle):
    """Mask of the places before the camera, or close to it, so that their shadows fall into the picture."""
    along, right = ahead()
    away = places[:, :2] - FIRST
    far, aside = away @ along, away @ right
    return (far < reach) & (far > -40.0) & (np.abs(aside) < 45.0 + np.tan(np.radians(half_angle)) * np.abs(far))


def trees(country):
    """Sites of all trees in the view."""
    places, species = (np.concatenate(pair) for pair in zip(near_trees(), grove()))
    sites = wood_sites(country)
    far = vtk_to_numpy(sites.GetPoints().GetData()).astype(float)
    along, _ = ahead()
    seen = in_view(far, REACH, HALF_ANGLE) & ((far[:, :2] - FIRST) @ along > GROVE)
    kinds = vtk_to_numpy(sites.GetPointData().GetArray("Species"))[seen]
    far, near = far[seen], np.column_stack((places, sampled(country, *places.T)))
    return vertices(np.concatenate((far, near)), Species=np.concatenate((kinds, species)).astype(np.int32))


def on_ground(country, count, reach, seed, nearest=3.0, power=1.5):
    """Random places before the camera, denser near it; and random numbers to go on with."""
    along, right = ahead()
    random = np.random.default_rng(seed)
    far = nearest + reach * random.random(count)**power
    aside = random.uniform(-1.0, 1.0, count) * (2.0 + 0.62 * far)
    at = FIRST + far[:, None] * along + aside[:, None] * right
    return np.column_stack((at, sampled(country, *at.T))), random


def tufts(country):
    """Sites of grass: in patches, and lower in the shade between."""
    places, random = on_ground(country, 90000, GRASS_REACH, 3)
    x, y = places[:, :2].T
    patches = 0.5 + 0.28 * (np.sin(x / 1.9 + 2.0 * np.sin(y / 3.1)) + np.sin(y / 2.3 + np.sin(x / 4.7)))
    beside = off_path(places) - PATH
    stays = random.random(len(places)) < np.minimum(0.25 + 0.75 * patches, 0.06 + beside / 0.5)
    scale = np.clip(0.35 + 0.75 * patches + random.normal(0.0, 0.18, len(places)), 0.25, 1.5)
    return vertices(places[stays], Scale=(scale * np.clip(0.4 + beside / 1.5, 0.4, 1.0))[stays])


def flowers(country):
    """Sites of flowers in drifts on the glade, white and yellow."""
    places, random = on_ground(country, 16000, 60.0, 11, 2.0)
    x, y = places[:, :2].T
    drifts = np.sin(x / 3.7 + 1.3 * np.sin(y / 5.3)) * np.sin(y / 4.1 + 0.7)
    stays = (random.random(len(places)) < np.clip(1.4 * drifts - 0.25, 0.0, 0.8)) & (off_path(places) > PATH + 0.2)
    kind = (np.sin(x / 9.0) * np.sin(y / 11.0) + random.normal(0.0, 0.3, len(places)) > 0.25).astype(np.int32)
    return vertices(places[stays], Scale=random.uniform(0.6, 1.1, len(places))[stays], Species=kind[stays])


def bushes(country):
    """Sites of undergrowth, in thickets, hardly any in the glade: hazels, shrubs, young birches and oaks."""
    places, random = on_ground(country, 2600, 180.0, 5, 7.0, 1.2)
    along, right = ahead()
    away = places[:, :2] - FIRST
    aside = np.abs(away @ right)
    x, y = places[:, :2].T
    thickets = np.sin(x / 7.0 + np.sin(y / 9.0)) * np.sin(y / 6.0 + 1.0)
    stays = random.random(len(places)) < np.clip((aside - 4.0 - 0.05 * (away @ along)) / 9.0, 0.0, 1.0) * np.clip(
        0.45 + 0.9 * thickets, 0.05, 1.0)
    species = random.choice(4, len(places), p=(0.38, 0.22, 0.25, 0.15)).astype(np.int32)
    scale = np.choose(species, (0.3 + 0.8 * random.random(len(places)), 0.2 + 0.45 * random.random(len(places))**2,
                                0.08 + 0.22 * random.random(len(places))**2, 0.06 + 0.12 * random.random(len(places))))
    return vertices(places[stays], Scale=scale[stays], Species=species[stays])


def scattered(sites, prototypes, **settings):
    """Plants as instances on sites."""
    plants = vtkPlantScatterFilter()
    plants.SetInputData(0, sites)
    for prototype in prototypes:
        plants.AddPrototypeConnection(prototype.GetOutputPort())
    plants.SetOutputFormToInstances()
    plants.SetUseLevels(False)
    plants.SetUseCulling(False)
    return set_properties(plants, settings)


def tree(preset, seed):
    source = vtkReevesTreeSource()
    source.SetPreset(getattr(source, preset))
    source.SetSeed(seed)
    return source


def plant(settings, leaf, bark):
    """A plant of a species of our own, with the colors of its leaves and its wood."""
    source = vtkReevesTreeSource()
    source.SetPresetToCustom()
    set_properties(source, settings)
    source.SetLeafFormToBlade()
    source.SetLeafColor(*leaf)
    source.SetBarkColor(*bark)
    return source


def write_scene(filename, frame=0):
    """Write the scene at a frame of the walk."""
    country = jacksboro().GetOutput()
    add_array(country, "RGB", np.full((country.GetNumberOfPoints(), 3), HAY, np.uint8))
    share = frame / FRAMES
    place = (1.0 - share) * np.array(FIRST) + share * np.array(LAST)
    eye = (*place, sampled(country, *place) + EYE_HEIGHT)
    focus = (*TARGET, sampled(country, *TARGET) - 60.0)
    sources = {
        "Ground": country,
        "Forest": scattered(trees(country), [tree(*species) for species in SPECIES]),
        "Undergrowth": scattered(
            bushes(country), [plant(HAZEL, (0.50, 0.60, 0.28), (0.42, 0.36, 0.28)), tree("Shrub", 4), tree("Birch", 7),
                              tree("Oak", 8)], TintVariation=0.12),
        "Grass": scattered(
            tufts(country), [plant(GRASS, (0.50, 0.56, 0.26), (0.55, 0.58, 0.30))], TintVariation=0.12),
        "Flowers": scattered(
            flowers(country), [plant(FLOWER, color, (0.45, 0.55, 0.25)) for color in ((0.97, 0.96, 0.93), (0.98, 0.85, 0.2))])}
    write_glb(
        filename, sources, camera=(eye, focus, (0.0, 0.0, 1.0), VIEW_ANGLE), sun=(*SUN, 100000.0),
        kinds={"Grass": "grass", "Flowers": "grass"},
        extras={"fog": {"sight": 3000.0, "height": 160.0}, "sky": {"clouds": 0.6}, "exposure": 1.9}, LevelForm=2)


if __name__ == "__main__":
    write_scene(sys.argv[1], *map(int, sys.argv[2:3]))
