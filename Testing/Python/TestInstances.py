# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A forest as instances: prototypes placed by their points are the merged forest, in a small part of its memory."""

import resource

import numpy as np
from littoral import vtkBeamTreeDeformationFilter, vtkGardnerPlantSource, vtkPlantScatterFilter, vtkReevesTreeSource
from littoral import vtkLandscapePass, vtkSeaweedSource, vtkWindFieldSource
from littoral.plants import level_actors
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData

SAME = ("PlantsInAll", "PlantsShown", "PlantsHigh", "PlantsMedium", "PlantsLow", "CellsInAll", "CellsShown",
        "PolygonsShown", "PolygonsInAll")
PARTS = (("High", "Skin"), ("High", "Leaves"), ("Medium", "Trunk"), ("Medium", "Crown"), ("Low", "Low"))
WOOD = ("Skin", "Trunk")


def sites(count, side):
    """Random sites in a square before the eye, on a slope."""
    at = np.random.default_rng(5).uniform((-0.5 * side, 0.0), (0.5 * side, side), (count, 2))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack((at, 0.1 * at[:, 1])), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def prototypes():
    tree = vtkReevesTreeSource()
    tree.SetNumberOfLeaves(60)
    return tree, vtkGardnerPlantSource(), vtkSeaweedSource()


def scattered(points, form, *, culling=True, of=None):
    forest = vtkPlantScatterFilter()
    forest.SetInputData(0, points)
    for prototype in of or PROTOTYPES:
        forest.AddPrototypeConnection(prototype.GetOutputPort())
    forest.SetViewPoint(0.0, -5.0, 4.0)
    forest.SetViewDirection(0.0, 1.0, 0.0)
    forest.SetViewUp(0.0, 0.0, 1.0)
    forest.SetNearDistance(30.0)
    forest.SetFarDistance(60.0)
    forest.SetUseCulling(culling)
    forest.SetFaceCamera(False)
    forest.SetOutputForm(form)
    return forest


def block(blocks, *names):
    """The block of a path of names."""
    for name in names:
        found = [k for k in range(blocks.GetNumberOfBlocks())
                 if blocks.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) == name]
        blocks = blocks.GetBlock(found[0])
    return blocks


def arrays(data):
    given = data.GetPointData()
    return {given.GetArrayName(k): vtk_to_numpy(given.GetArray(k)) for k in range(given.GetNumberOfArrays())}


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def turned(quaternion, vectors):
    """v + 2 q x (q x v + w v) for a unit quaternion w, q."""
    w, q = quaternion[0], np.array(quaternion[1:])
    return vectors + 2.0 * np.cross(q, np.cross(q, vectors) + w * vectors)


def counters(data):
    fields = data.GetFieldData()
    return {name: fields.GetArray(name).GetValue(0) for name in SAME}


def compare(merged, forest):
    """Each merged plant with its prototype at its point."""
    whole = forest.GetOutputDataObject(0)
    assert whole.GetNumberOfBlocks() == 1 + 3 * len(PROTOTYPES), "other blocks than instances and prototypes"
    instances = block(whole, "Instances")
    of_plants, feet = arrays(instances), points_of(instances)
    assert instances.GetNumberOfVerts() == len(feet) == len(of_plants["Prototype"])
    assert (of_plants["Prototype"] == 1 + 3 * of_plants["Species"] + of_plants["Level"]).all()
    assert set(of_plants["Level"]) == {0, 1, 2} and set(of_plants["Species"]) == {0, 1, 2}, "too few kinds to compare"
    compared = 0
    for level, part in PARTS:
        of_forest = block(merged, level, part) if level != "Low" else block(merged, level)
        all_points, all_arrays = points_of(of_forest), arrays(of_forest)
        for k in np.flatnonzero(of_plants["Level"] == ("High", "Medium", "Low").index(level)):
            prototype = block(whole, f"{of_plants['Species'][k]} {level}", part)
            index = prototype.GetFieldData().GetArray("Prototype").GetValue(0)
            assert whole.GetBlock(index).GetBlock(0).IsA("vtkPolyData") and index == of_plants["Prototype"][k]
            own, mine = arrays(prototype), all_arrays["PlantId"] == of_plants["PlantId"][k]
            placed = feet[k] + of_plants["Scale"][k] * turned(of_plants["Rotation"][k], points_of(prototype))
            assert np.abs(placed - all_points[mine]).max() < 2e-4, f"{level} {part} of plant {k}"
            normals = turned(of_plants["Rotation"][k], own["Normals"].astype(float))
            assert np.abs(normals - all_arrays["Normals"][mine]).max() < 1e-5, f"normals of plant {k}"
            tint = 1.0 if part in WOOD else of_plants["Tint"][k].astype(float)
            colors = np.minimum(255.0, tint * own["RGB"])
            assert np.abs(colors - all_arrays["RGB"][mine]).max() <= 1.0, f"colors of {level} {part} of plant {k}"
            compared += 1
    return compared


PROTOTYPES = prototypes()
points = sites(150, 120.0)
merged = scattered(points, vtkPlantScatterFilter.Merged)
merged.Update()
assert merged.GetOutputForm() == vtkPlantScatterFilter.Merged
forest = scattered(points, vtkPlantScatterFilter.Instances)
forest.Update()
assert compare(merged.GetOutputDataObject(0), forest) > 100, "few plants"
assert counters(merged.GetOutputDataObject(0)) == counters(forest.GetOutputDataObject(0))

leaves = block(PROTOTYPES[0].GetOutputDataObject(0), "High", "Leaves")
assert not leaves.GetFieldData().HasArray("Prototype"), "the prototype itself has changed"

# From one form to the other and back: as fresh objects.
forest.SetOutputForm(vtkPlantScatterFilter.Merged)
forest.Update()
assert forest.GetOutputDataObject(0).GetNumberOfBlocks() == 3
forest.SetOutputFormToInstances()
forest.Update()
compare(merged.GetOutputDataObject(0), forest)

# Phases of sway: the same tree in winds of other seeds as prototypes, which alone change in time.
sways = []
for seed in (1, 2):
    wind = vtkWindFieldSource()
    wind.SetDimensions(64, 8, 8)
    wind.SetSeed(seed)
    sways.append(vtkBeamTreeDeformationFilter())
    sways[-1].SetInputConnection(0, PROTOTYPES[0].GetOutputPort())
    sways[-1].SetInputConnection(1, wind.GetOutputPort())
swaying = scattered(points, vtkPlantScatterFilter.Instances, of=sways)
shapes = []
for time in (0.5, 1.5):
    swaying.UpdateTimeStep(time)
    now = swaying.GetOutputDataObject(0)
    shapes.append([points_of(block(now, f"{species} High", "Leaves")) for species in (0, 1)]
                  + [points_of(block(now, "Instances"))])
assert all(np.abs(shapes[0][k] - shapes[1][k]).max() > 1e-4 for k in (0, 1)), "the prototypes stand still"
assert np.abs(shapes[0][0] - shapes[0][1]).max() > 1e-3, "one phase"
assert (shapes[0][2] == shapes[1][2]).all(), "the instances have moved"

# Pieces share the plants out, and each has all prototypes.
whole = arrays(block(forest.GetOutputDataObject(0), "Instances"))["PlantId"]
pieces = []
for piece in range(3):
    forest.UpdatePiece(piece, 3, 0)
    pieces.append(arrays(block(forest.GetOutputDataObject(0), "Instances"))["PlantId"].copy())
    assert forest.GetOutputDataObject(0).GetNumberOfBlocks() == 10
assert min(len(piece) for piece in pieces) > 0 and (np.sort(np.concatenate(pieces)) == np.sort(whole)).all()

# A site of the last piece that can have no plant is said by the first one, too.
sizes = np.ones(points.GetNumberOfPoints())
sizes[vtk_to_numpy(points.GetPoints().GetData())[:, 1].argmax()] = -1.0
bad = vtkPolyData()
bad.ShallowCopy(points)
bad.GetPointData().AddArray(numpy_to_vtk(sizes, deep=True))
bad.GetPointData().GetArray(bad.GetPointData().GetNumberOfArrays() - 1).SetName("Scale")
for piece, fails in ((0, True), (1, False), (2, True)):
    messages = []
    part = scattered(bad, vtkPlantScatterFilter.Instances)
    for said in (part, part.GetExecutive()):
        said.AddObserver("ErrorEvent", lambda *given, to=messages: to.append("error"))
    part.UpdatePiece(piece, 3, 0)
    assert bool(messages) == fails, f"piece {piece} of sites, of which the last is bad"

# No plant in sight: the block is there, without points.
forest.SetViewDirection(0.0, -1.0, 0.0)
forest.UpdatePiece(0, 1, 0)
assert block(forest.GetOutputDataObject(0), "Instances").GetNumberOfPoints() == 0

# A hundred thousand trees in less than 200 MB in all: sites, prototypes, places and output.
with open("/proc/self/statm", encoding="ascii") as pages:  # now, and not the most until now
    before = int(pages.read().split()[1]) * resource.getpagesize() / 1024.0
many = scattered(sites(100000, 5000.0), vtkPlantScatterFilter.Instances, culling=False)
many.Update()
grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024.0  # the most, of all of the test
instances = block(many.GetOutputDataObject(0), "Instances")
assert instances.GetNumberOfPoints() == 100000
told = many.GetOutputDataObject(0).GetFieldData().GetArray("OutputBytes").GetValue(0)
assert told == 84.0 * 100000
assert abs(1024.0 * instances.GetActualMemorySize() - told) < 0.02 * told, f"{instances.GetActualMemorySize()} KiB"
assert grown < 200.0, f"{grown:.0f} MB for 100 000 instances"
print(f"100 000 instances: {told / 1e6:.1f} MB, {grown:.0f} MB in all")

# What the landscape pass is told of the actors of a plant.
tree = prototypes()[0]
tree.Update()
for level, material in (("High", vtkLandscapePass.Bark), ("Medium", vtkLandscapePass.Surface)):
    wood, leaves = level_actors(tree, level)
    assert vtkLandscapePass.GetMaterial(wood) == material and vtkLandscapePass.GetTransmittance(wood) == 0.0
    assert vtkLandscapePass.GetTransmittance(leaves) == 0.3
