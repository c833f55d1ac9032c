# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""After a refusal, valid settings give what they give to a new source or filter: for each mistake of a property or of an
input that has a valid one here, and for a scene whose plants did not fit into the sea."""

import hashlib

import numpy as np
import quick
import window
from blocks import leaves
from mistakes import MISTAKES, SMALL_WIND, Messages, inventory, particles, sites, tree
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: The valid inputs in place of those of a mistake.
VALID = {
    "BeamTreeDeformation": lambda: dict(Input=tree(), Wind=simple.WindField(**SMALL_WIND)),
    "CurrentDrift": lambda: dict(Input=particles(), Currents=[simple.FlowPrimitive()]),
    "FlowArrows": lambda: dict(Input=simple.FlowPrimitive()),
    "ImageSections": lambda: dict(Input=simple.WindField(**SMALL_WIND)),
    "ParticleFog": lambda: dict(Input=particles()),
    "ParticleOrbits": lambda: dict(Input=particles(), SeaState=simple.SeaState()),
    "PlantScatter": lambda: dict(Sites=sites(), Prototypes=[tree()]),
    "QuadratAnalysis": lambda: dict(Input=sites()),
    "PointPatternStatistics": lambda: dict(Input=sites()),
    "StandInventory": lambda: dict(Inventory=inventory()),
    "SitePreference": lambda: dict(Sites=sites(), Terrain=simple.TurningBandsTerrain()),
    "SeaStatistics": lambda: dict(Input=simple.SeaState()),
    "SeaSurface": lambda: dict(Input=simple.SeaState(), Radius=50.0),
    "SeaweedDeformation": lambda: dict(Input=simple.Seaweed(), SeaState=simple.SeaState(SeaLevel=8.0)),
    "WindStatistics": lambda: dict(Input=simple.WindField(**SMALL_WIND)),
}
LARGE = {"WindField": SMALL_WIND, "SuspendedParticles": dict(Density=0.1)}


def digest(proxy):
    """Number of elements and a checksum of points and arrays of the first output."""
    proxy.UpdatePipeline()
    elements, total = 0, hashlib.sha1()
    for leaf in leaves(servermanager.Fetch(proxy)):
        elements += sum(leaf.GetNumberOfElements(kind) for kind in (0, 1, 6))  # points, cells, rows
        arrays = [leaf.GetPoints().GetData()] if leaf.IsA("vtkPointSet") and leaf.GetPoints() else []
        for fields in (leaf.GetAttributes(0), leaf.GetAttributes(1), leaf.GetAttributes(6)):
            arrays += [fields.GetArray(k) for k in range(fields.GetNumberOfArrays())] if fields else []
        for array in arrays:
            if array:  # not one of text
                total.update(np.ascontiguousarray(vtk_to_numpy(array)).tobytes())
    return elements, total.hexdigest()


def is_input(value):
    return isinstance(value if not isinstance(value, list) else value[0], servermanager.Proxy)


def check(name, arguments, word):
    """Whether a mistake has a way back here; the proxy has taken it."""
    wrong = arguments()
    valid = VALID[name]() if name in VALID else LARGE.get(name, {})
    if any(is_input(value) and key not in valid for key, value in wrong.items()):
        return False
    make = getattr(simple, name)
    fresh = digest(make(**valid))
    assert fresh[0] > 0, f"{name}: a new one gives nothing"
    former = make()
    values = {key: former.GetProperty(key).GetData() for key in wrong if not is_input(wrong[key])}
    proxy = make(**wrong)
    refused = digest(proxy)
    assert refused != fresh, f"{name}, {word}: nothing is wrong"
    for key, value in {**values, **valid}.items():
        proxy.SetPropertyWithName(key, value)
    assert digest(proxy) == fresh, f"{name}, {word}: {digest(proxy)} after {refused}, not {fresh}"
    return True


def check_removal(name, key, source):
    """An input that is taken away leaves nothing of it."""
    valid = {other: value for other, value in VALID[name]().items() if other != key}
    proxy = getattr(simple, name)(**valid)
    fresh = digest(proxy)
    assert fresh[0] > 0, f"{name}: nothing without {key}"
    proxy.SetPropertyWithName(key, source)
    assert digest(proxy) != fresh, f"{name}: {key} changes nothing"
    proxy.SetPropertyWithName(key, None)
    assert digest(proxy) == fresh, f"{name}: {key} stays connected"


def check_scene():
    """Giant kelp, which is higher than the sea is deep, and sugar kelp again."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [300, 200]
    simple.SetActiveView(view)
    simple.Show(simple.Underwater(), view)
    plant, kelp = simple.FindSource("Sugar Kelp"), simple.FindSource("Kelp")
    pictures, points = [], []
    for preset in ("Sugar Kelp", "Giant Kelp", "Sugar Kelp"):
        plant.Preset = preset
        with Messages():
            simple.Render(view)
        pictures.append(window.colors(view))
        points.append(kelp.GetDataInformation().GetNumberOfPoints())
    assert points[1] == 0 and points[2] == points[0] > 0, f"Underwater: kelp has {points} points"
    missing, other = [(np.abs(one - pictures[0]).max(axis=1) > 12).mean() for one in pictures[1:]]
    assert missing > 0.02, f"Underwater: {missing:.2%} of the picture is another without kelp"
    assert other < 0.001, f"Underwater: {other:.2%} of the picture is another after a refusal"
    print(f"Underwater: {missing:.0%} of the picture is another without kelp, {other:.2%} after it")


for name, arguments, word, _ in MISTAKES:
    with Messages():  # which TestMistakes looks at
        recovers = check(name, arguments, word)
    if recovers:
        print(f"{name} recovers from {word}", flush=True)
    simple.ResetSession()
check_removal("PlantScatter", "Terrain", simple.TurningBandsTerrain())
simple.ResetSession()
check_scene()
