# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in VTK without ParaView: a failed update, and one message until the filter is modified."""

import math
import sys
from pathlib import Path

from littoral import vtkBeamTreeDeformationFilter, vtkCurrentDriftFilter, vtkParticleOrbitFilter, vtkPlantScatterFilter
from littoral import vtkPlantWakeFilter, vtkQuadratPointSource, vtkReevesTreeSource, vtkSeaStateSource
from littoral import vtkSeaSurfaceFilter, vtkSeaweedDeformationFilter, vtkSeaweedSource, vtkSuspendedParticleSource
from littoral import vtkWindFieldSource
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import classes
from examples import Examples
from vtk_proxies import VtkProxies

MESSAGES = []


def watched(algorithm):
    """The algorithm, whose messages are kept; the executive's echo of a failed request is silenced."""

    def take(_, __, message):
        MESSAGES.append(message)

    take.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", take)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    return algorithm


def messages_of(update):
    """The messages of an update that fails."""
    MESSAGES.clear()
    assert update() == 0, "the update has not failed"
    return len(MESSAGES)


def bounds_of(data):
    bounds = [0.0] * 6
    data.GetBounds(bounds)
    return bounds


tree = vtkReevesTreeSource()
tree.SetPresetToCustom()
tree.SetMainBranches(8)
tree.SetNumberOfLeaves(50)
tree.Update()
sway = watched(vtkBeamTreeDeformationFilter())
sway.SetInputConnection(0, tree.GetOutputPort())
assert messages_of(sway.GetExecutive().Update) == 1 and "There is no wind" in MESSAGES[0], MESSAGES
assert bounds_of(sway.GetOutputDataObject(0)) == bounds_of(tree.GetOutputDataObject(0)), "the plants have moved"
# Another time is another execution, but the same mistake.
for time in (1.0, 2.0):
    MESSAGES.clear()
    sway.UpdateTimeStep(time)
    assert not MESSAGES, MESSAGES
sway.SetDragCoefficient(1.0)
assert messages_of(sway.GetExecutive().Update) == 1, "a mistake that stays is not reported after a change"

# Pictures of a wind that is taken away do not stay.
wind = vtkWindFieldSource()
wind.SetDimensions(16, 4, 4)
sway.SetInputConnection(1, wind.GetOutputPort())
sway.Update()
assert sway.GetOutputDataObject(1).GetPointData().GetScalars(), "there are no pictures"
sway.RemoveAllInputConnections(1)
pictures = sway.GetOutputDataObject(1).GetPointData()
assert messages_of(sway.GetExecutive().Update) == 1 and not pictures.GetScalars(), "pictures stay"

# A trunk of which one segment hides the others has no modes: no plants that are not a number.
sway.SetInputConnection(1, wind.GetOutputPort())
for radius in 1e3, 1e5, 2e9, 1e14:
    spoiled = vtkMultiBlockDataSet()
    spoiled.DeepCopy(tree.GetOutputDataObject(0))
    spoiled.GetBlock(0).GetBlock(0).GetPointData().GetArray("Radius").SetValue(3, radius)
    sway.SetInputDataObject(0, spoiled)
    if radius > 1e4:
        assert messages_of(sway.GetExecutive().Update) == 1 and "Radius" in MESSAGES[0], MESSAGES
    else:
        sway.Update()
    assert all(map(math.isfinite, bounds_of(sway.GetOutputDataObject(0)))), radius

particles = vtkSuspendedParticleSource()
particles.SetDensity(0.1)
particles.Update()
orbits = watched(vtkParticleOrbitFilter())
orbits.SetInputConnection(0, particles.GetOutputPort())
assert messages_of(orbits.GetExecutive().Update) == 1 and "There is no sea state" in MESSAGES[0], MESSAGES
assert orbits.GetOutputDataObject(0).GetBounds() == particles.GetOutputDataObject(0).GetBounds()

# What follows from a mistake upstream is not reported.
trees = watched(vtkPlantScatterFilter())
trees.SetInputConnection(0, particles.GetOutputPort())
behind = watched(vtkBeamTreeDeformationFilter())
behind.SetInputConnection(0, trees.GetOutputPort())
assert messages_of(trees.GetExecutive().Update) == 1 and "There are no prototypes" in MESSAGES[0], MESSAGES
MESSAGES.clear()
behind.Update()
assert not MESSAGES, MESSAGES

# Sites are points, not the blocks of a plant.
trees.SetInputConnection(0, tree.GetOutputPort())
assert messages_of(trees.GetExecutive().Update) == 1 and "The sites are blocks" in MESSAGES[0], MESSAGES

# No input at all, and blocks at an input that is not the first.
for kind in vtkCurrentDriftFilter, vtkParticleOrbitFilter:
    assert messages_of(watched(kind()).GetExecutive().Update) == 1 and "There is no input." in MESSAGES[0], MESSAGES
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(1, vtkImageData())
sites = vtkQuadratPointSource()
trees = watched(vtkPlantScatterFilter())
trees.SetInputConnection(0, sites.GetOutputPort())
trees.SetInputConnection(1, tree.GetOutputPort())
trees.SetInputDataObject(2, blocks)
assert messages_of(trees.GetExecutive().Update) == 1 and "Terrain is a vtkMultiBlockDataSet" in MESSAGES[0], MESSAGES
orbits = watched(vtkParticleOrbitFilter())
orbits.SetInputConnection(0, particles.GetOutputPort())
orbits.SetInputDataObject(1, blocks)
assert messages_of(orbits.GetExecutive().Update) == 1 and "Sea State is a vtkMultiBlockDataSet" in MESSAGES[0], MESSAGES

# Textures lie at the origin, wherever an image lay that was connected before.
image = vtkImageData()
image.SetDimensions(3, 3, 1)
image.SetOrigin(7.0, 8.0, 9.0)
moved = vtkTrivialProducer()
moved.SetOutput(image)
trees = vtkPlantScatterFilter()
trees.AddObserver("ErrorEvent", lambda *_: None)
trees.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
trees.SetInputConnection(0, moved.GetOutputPort())
trees.Update()
trees.SetInputConnection(0, sites.GetOutputPort())
trees.SetInputConnection(1, tree.GetOutputPort())
trees.Update()
assert trees.GetOutputDataObject(1).GetOrigin() == (0.0, 0.0, 0.0), trees.GetOutputDataObject(1).GetOrigin()

# A current is at rest where its numbers are as large as those that ocean models write on land.
flow = vtkImageData()
flow.SetDimensions(2, 2, 2)
flow.SetOrigin(-20.0, -20.0, -20.0)
flow.SetSpacing(40.0, 40.0, 40.0)
land = vtkDoubleArray()
land.SetName("Velocity")
land.SetNumberOfComponents(3)
land.SetNumberOfTuples(8)
land.Fill(9.96921e36)
flow.GetPointData().AddArray(land)
drift = watched(vtkCurrentDriftFilter())
drift.SetInputConnection(0, particles.GetOutputPort())
drift.SetInputDataObject(1, flow)
MESSAGES.clear()
drift.UpdateTimeStep(1.0)
assert not MESSAGES and drift.GetOutputDataObject(0).GetBounds() == particles.GetOutputDataObject(0).GetBounds(), MESSAGES

# A wake needs finite radii.
weed = vtkSeaweedSource()
sea = vtkSeaStateSource()
sea.SetSeaLevel(4.0)
moving = vtkSeaweedDeformationFilter()
moving.SetGenerateMotion(True)
moving.SetInputConnection(0, weed.GetOutputPort())
moving.SetInputConnection(1, sea.GetOutputPort())
moving.Update()
spoilt = vtkMultiBlockDataSet()
spoilt.DeepCopy(moving.GetOutputDataObject(0))
leaves = spoilt.NewIterator()
while not leaves.IsDoneWithTraversal():
    radii = leaves.GetCurrentDataObject().GetPointData().GetArray("Radius")
    if radii:
        radii.SetComponent(1, 0, float("inf"))
    leaves.GoToNextItem()
wake = watched(vtkPlantWakeFilter())
wake.SetInputDataObject(0, spoilt)
assert messages_of(wake.GetExecutive().Update) == 1 and "Radius" in MESSAGES[0], MESSAGES

# VTK hands blocks to the filter one by one; the first bad one is reported, and again after a change.
blocks = vtkMultiBlockDataSet()
for index, block in enumerate((vtkPolyData(), vtkTable(), vtkImageData())):
    blocks.SetBlock(index, block)
surface = watched(vtkSeaSurfaceFilter())
surface.SetInputDataObject(blocks)
for _ in range(2):
    MESSAGES.clear()
    surface.Update()
    assert len(MESSAGES) == 1 and "Input is a vtkPolyData" in MESSAGES[0], MESSAGES
    MESSAGES.clear()
    surface.UpdateTimeStep(1.0)
    assert not MESSAGES, MESSAGES
    surface.Modified()
surface.SetInputDataObject(vtkTable())
for _ in range(2):
    assert messages_of(surface.GetExecutive().Update) == 1 and "has no wave trains" in MESSAGES[0], MESSAGES
    surface.Modified()

# The mistakes of the rows.
def size_of(data):
    """Number of points or rows, and bounds."""
    count = data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()
    return count, bounds_of(data) if count and not data.IsA("vtkTable") else None


pv = Examples(VtkProxies(watched))
for mistake in (made for row in classes.ROWS for made in row.mistakes):
    given = mistake.given(pv)
    made = getattr(pv, mistake.entry)(**given)
    MESSAGES.clear()
    made.Update()
    assert len(MESSAGES) == 1 and mistake.words in MESSAGES[0], (mistake, MESSAGES)
    wanted = given["Input"].GetOutputDataObject(0) if mistake.result == classes.UNMOVED else None
    has = size_of(made.GetOutputDataObject(0))
    assert has == (size_of(wanted) if wanted else (0, None)), (mistake, has)
    made.Modified()
    MESSAGES.clear()
    made.Update()
    assert len(MESSAGES) <= 1, (mistake, MESSAGES)
