# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A vtkPartitionedDataSetCollection is taken wherever a vtkMultiBlockDataSet is, and gives the same."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataAssembly, vtkPartitionedDataSet, vtkPartitionedDataSetCollection)
from vtkmodules.vtkFiltersCore import vtkConvertToPartitionedDataSetCollection

from littoral import (
    vtkBeamTreeDeformationFilter, vtkCurrentDriftFilter, vtkFlowPrimitiveSource, vtkParticleFogFilter,
    vtkParticleLevelOfDetailFilter, vtkParticleOrbitFilter, vtkPlantScatterFilter, vtkPlantWakeFilter,
    vtkQuadratPointSource, vtkReevesTreeSource, vtkSeaStateSource, vtkSeaweedDeformationFilter, vtkSeaweedSource,
    vtkSuspendedParticleSource, vtkWindFieldSource)
from littoral.plants import block


def collection(blocks):
    """Blocks as VTK converts them, with the field data, which it leaves out."""
    convert = vtkConvertToPartitionedDataSetCollection()
    convert.SetInputDataObject(blocks)
    convert.Update()
    data = convert.GetOutput()
    data.GetFieldData().ShallowCopy(blocks.GetFieldData())
    assert isinstance(data, vtkPartitionedDataSetCollection)
    return data


def parts(data, level, fields):
    """A collection with a group for a level, whose parts are data sets of that group, the first partition missing."""
    grouped, assembly = vtkPartitionedDataSetCollection(), vtkDataAssembly()
    group = assembly.AddNode(level)
    for index in range(data.GetNumberOfBlocks()):
        piece = vtkPartitionedDataSet()
        piece.SetPartition(1, data.GetBlock(index))
        grouped.SetPartitionedDataSet(index, piece)
        name = data.GetMetaData(index).Get(vtkCompositeDataSet.NAME())
        grouped.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
        assembly.AddDataSetIndex(group, index)
    grouped.SetDataAssembly(assembly)
    grouped.GetFieldData().ShallowCopy(fields)
    return grouped


def leaves(data):
    """All data sets of composite data."""
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def same(one, other):
    """Whether points and point arrays of all parts are equal to the bit; there are some."""
    ones, others = list(leaves(one)), list(leaves(other))
    assert len(ones) == len(others) > 0
    for a, b in zip(ones, others):
        assert a.GetNumberOfPoints() == b.GetNumberOfPoints()
        if a.GetNumberOfPoints():
            np.testing.assert_array_equal(*(vtk_to_numpy(c.GetPoints().GetData()) for c in (a, b)))
        for k in range(a.GetPointData().GetNumberOfArrays()):
            np.testing.assert_array_equal(*(vtk_to_numpy(c.GetPointData().GetArray(k)) for c in (a, b)))
    return sum(a.GetNumberOfPoints() for a in ones) > 0


def updated(algorithm, time=None):
    """The first output, at a time [s]."""
    algorithm.UpdateTimeStep(time) if time is not None else algorithm.Update()
    return algorithm.GetOutputDataObject(0)


def errors_of(algorithm):
    """Messages of an update that fails."""
    messages = []

    def take(_, __, message):
        messages.append(message)

    take.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", take)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    algorithm.Update()
    return messages


def make_tree(seed):
    """A small tree."""
    tree = vtkReevesTreeSource()
    tree.SetSeed(seed)
    tree.SetNumberOfLeaves(50)
    tree.SetTextureSize(32, 16)
    return updated(tree)


def sway_of(plants, prototypes=()):
    """Plants in the wind at 3.3 s."""
    wind = vtkWindFieldSource()
    wind.SetDimensions(100, 16, 8)
    sway = vtkBeamTreeDeformationFilter()
    sway.SetInputDataObject(0, plants)
    sway.SetWindConnection(wind.GetOutputPort())
    for prototype in prototypes:
        sway.AddInputDataObject(2, prototype)
    sway.SetTextureSize(16, 8)
    return updated(sway, 3.3)


def check_trees():
    """A tree alone, and a scattered forest with its prototypes."""
    trees = [make_tree(seed) for seed in (1, 2)]
    moved = sway_of(trees[0])
    assert same(moved, sway_of(collection(trees[0])))
    rest, swayed = (vtk_to_numpy(block(data, "High", "Skin").GetPoints().GetData()) for data in (trees[0], moved))
    assert abs(rest - swayed).max() > 1e-3, "nothing sways"
    alone = parts(block(trees[0], "High"), "High", trees[0].GetFieldData())
    assert same(block(moved, "High"), block(sway_of(alone), "High"))

    sites = vtkQuadratPointSource()
    sites.SetOrigin(-8.0, -8.0)
    sites.SetSize(16.0, 16.0)
    sites.SetQuadrats(2, 2)
    sites.SetMeanPerQuadrat(1.0)
    forests = []
    for prototypes in (trees, [collection(tree) for tree in trees]):
        scatter = vtkPlantScatterFilter()
        scatter.SetInputConnection(0, sites.GetOutputPort())
        for prototype in prototypes:
            scatter.AddInputDataObject(1, prototype)
        scatter.SetUseLevels(False)
        scatter.SetUseCulling(False)
        forests.append(updated(scatter))
    assert same(*forests)
    assert same(sway_of(forests[0], trees), sway_of(collection(forests[0]), [collection(tree) for tree in trees]))


def check_seaweeds():
    """A kelp in a swell, and its wake."""
    kelp = updated(vtkSeaweedSource())
    results = []
    for plants in (kelp, collection(kelp)):
        sea, motion, wake = vtkSeaStateSource(), vtkSeaweedDeformationFilter(), vtkPlantWakeFilter()
        sea.SetWaterDepth(10.0)
        sea.SetSeaLevel(10.0)
        motion.SetInputDataObject(0, plants)
        motion.SetSeaStateConnection(sea.GetOutputPort())
        motion.SetTimeStep(0.05)
        motion.GenerateMotionOn()
        moved = updated(motion, 0.5)
        wake.SetInputDataObject(collection(moved) if plants is not kelp else moved)
        results.append((moved, updated(wake)))
    assert same(results[0][0], results[1][0])
    primitives = [wake for _, wake in results]
    assert primitives[0].GetNumberOfPoints() == primitives[1].GetNumberOfPoints() > 0
    np.testing.assert_array_equal(*(vtk_to_numpy(wake.GetPointData().GetArray("Strength")) for wake in primitives))


def check_particles():
    """Particles in levels of detail drift, ride on waves and become fog."""
    source, sea, levels = vtkSuspendedParticleSource(), vtkSeaStateSource(), vtkParticleLevelOfDetailFilter()
    source.SetBounds(-20.0, 20.0, -20.0, 20.0, -8.0, -1.0)
    source.SetDensity(0.1)
    sea.SetNumberOfTrains(10)
    levels.SetInputConnection(0, source.GetOutputPort())
    levels.SetSeaStateConnection(sea.GetOutputPort())
    levels.SetNearDistance(5.0)
    levels.SetFarDistance(15.0)
    levels.SetViewPoint(0.0, -10.0, -4.0)
    blocks = updated(levels)
    apart = collection(blocks)
    moved, fogs = [], []
    for data in (blocks, apart):
        current, drift, orbits, fog = (
            vtkFlowPrimitiveSource(), vtkCurrentDriftFilter(), vtkParticleOrbitFilter(), vtkParticleFogFilter())
        drift.SetInputDataObject(0, data)
        drift.AddCurrentConnection(current.GetOutputPort())
        orbits.SetInputConnection(0, drift.GetOutputPort())
        orbits.SetSeaStateConnection(sea.GetOutputPort())
        moved.append(updated(orbits, 2.0))
        assert moved[-1].IsA(data.GetClassName()), moved[-1].GetClassName()
        fog.SetInputDataObject(data)
        fogs.append(updated(fog))
    assert same(*moved)
    names = [moved[1].GetMetaData(k).Get(vtkCompositeDataSet.NAME()) for k in range(3)]
    assert names == [apart.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) for k in range(3)] and "Far" in names
    counted = [fog.GetFieldData().GetArray("ParticlesInFog").GetTuple1(0) for fog in fogs]
    far = block(blocks, "Far").GetNumberOfPoints()
    assert counted == [far, far] and 0 < far < source.GetOutput().GetNumberOfPoints(), (counted, far)


def check_refusal():
    """A part in two partitions is refused in one sentence."""
    tree = collection(make_tree(1))
    skin = tree.GetPartitionedDataSet(1)
    skin.SetPartition(1, skin.GetPartition(0))
    sites, scatter, wake = vtkQuadratPointSource(), vtkPlantScatterFilter(), vtkPlantWakeFilter()
    scatter.SetInputConnection(0, sites.GetOutputPort())
    scatter.AddInputDataObject(1, tree)
    wake.SetInputDataObject(tree)
    for algorithm in (scatter, wake):
        messages = errors_of(algorithm)
        assert len(messages) == 1 and "'Skin' of the collection is in several partitions" in messages[0], messages


check_trees()
check_seaweeds()
check_particles()
check_refusal()
