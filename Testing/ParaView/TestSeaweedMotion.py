# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Seaweed Deformation and Plant Wake from ParaView: inputs, properties, times, and particles that feel the plants."""
import numpy as np
import quick
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def skeleton(plants, time):
    """A copy of the points of High/Skeleton at a time."""
    plants.UpdatePipeline(time)
    return vtk_to_numpy(servermanager.Fetch(plants).GetBlock(0).GetBlock(0).GetPoints().GetData()).copy()


weed = simple.Seaweed(Preset="Eelgrass")
swell = simple.SeaState(Spectrum="Regular", SeaBy="Height And Period", SignificantWaveHeight=1.6, PeakPeriod=8.0)
wave = servermanager.Fetch(swell)
assert wave.GetNumberOfRows() == 1 and abs(wave.GetColumnByName("Amplitude").GetValue(0) - 0.8) < 1e-12
assert abs(wave.GetColumnByName("AngularFrequency").GetValue(0) - np.pi / 4.0) < 1e-12
sea = simple.SeaState(SeaLevel=6.0)
tide = simple.FlowPrimitive(Strength=0.1)
motion = simple.SeaweedDeformation(Input=weed, SeaState=sea, Currents=[tide], FollowCamera=0)
assert motion.Method == "Physical" and motion.Joint == "Bending" and motion.Load == "Morison"
assert abs(motion.TimeStep - 1 / 48) < 1e-9 and motion.StartTime == -5.0
first = skeleton(motion, 3.0)
second = skeleton(motion, 8.0)
assert (skeleton(motion, 3.0) == first).all(), "another order of times gives other plants"
assert 0.01 < np.abs(first - second).max() < 3.0
rest = skeleton(weed, 0.0)
assert len(rest) == len(first) and (first[0] == rest[0]).all(), "the holdfast moves"
motion.Method = "Procedural"
assert 0.001 < np.abs(skeleton(motion, 3.0) - first).max() < 3.0
motion.Method = "Physical"
assert (skeleton(motion, 3.0) == first).all(), "coming back to a method gives other plants"

# Levels of detail: by the view, counted in field data, and gone when they are off.
motion.UseLevels = 1
motion.ViewPoint = [0.0, -80.0, 1.0]
motion.ViewDirection = [0.0, 1.0, 0.0]
assert not (skeleton(motion, 3.0) == first).all()
fields = servermanager.Fetch(motion).GetFieldData()
assert 0 < fields.GetArray("SegmentsMoved").GetValue(0) < fields.GetArray("SegmentsInAll").GetValue(0)
motion.UseLevels = 0
assert (skeleton(motion, 3.0) == first).all(), "the camera changes the state"

# The wake carries particles near the plants, and no others.
motion.GenerateMotion = 1
wake = simple.PlantWake(Input=motion)
wake.UpdatePipeline(3.0)
primitives = servermanager.Fetch(wake)
assert primitives.GetNumberOfPoints() == 1
assert wake.Margin == 0.5 and primitives.GetPointData().GetArray("InfluenceMargin").GetValue(0) == 0.5
bounds = np.array(primitives.GetPointData().GetArray("InfluenceBox").GetTuple(0))
motion.UpdatePipeline(3.0)
bones = vtk_to_numpy(servermanager.Fetch(motion).GetBlock(0).GetBlock(0).GetPoints().GetData())
assert (bounds[0::2] == bones.min(axis=0)).all() and (bounds[1::2] == bones.max(axis=0)).all(), bounds
wake.Margin = 0.8
wake.UpdatePipeline(3.0)
assert servermanager.Fetch(wake).GetPointData().GetArray("InfluenceMargin").GetValue(0) == 0.8
x, y, z = primitives.GetPoint(0)
particles = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=f"""
import vtk
points = vtk.vtkPoints()
points.SetDataTypeToDouble()
points.InsertNextPoint({x} + 0.2, {y}, {z})
points.InsertNextPoint({x} + 50.0, {y}, {z})
output.SetPoints(points)
""")
drift = simple.CurrentDrift(Input=particles, Currents=[wake], SeaLevel=6.0, TimeStep=0.25)
drift.UpdatePipeline(2.0)
moved = vtk_to_numpy(servermanager.Fetch(drift).GetPoints().GetData())
assert abs(moved[0, 0] - x - 0.2) > 1e-5 and moved[1, 0] == x + 50.0, moved
print("plants sway by", np.abs(first - second).max(), "m; a particle beside them by", abs(moved[0, 0] - x - 0.2), "m")

# A single seaweed shows the level that moves; a scattered bed all levels. Inputs come first in the panel, views last.
view = simple.CreateView("RenderView")
shown = simple.Show(motion, view)
assert list(shown.BlockSelectors) == ["/Root/High/Skin", "/Root/High/Leaves"], list(shown.BlockSelectors)
assert not shown.MapScalars, "not in natural colors"
sites = simple.PointSource(NumberOfPoints=5, Radius=3.0)
bed = simple.PlantScatter(Sites=sites, Prototypes=[weed], FollowCamera=0, UseLevels=0, UseCulling=0)
swaying = simple.SeaweedDeformation(Input=bed, SeaState=sea, FollowCamera=0)
selectors = list(simple.Show(swaying, view).BlockSelectors)
assert selectors == ["/Root/High/Skin", "/Root/High/Leaves", "/Root/Medium", "/Root/Low"], selectors
names, each = [], servermanager.vtkSMOrderedPropertyIterator()
each.SetProxy(motion.SMProxy)
each.Begin()
while not each.IsAtEnd():
    names.append(each.GetKey())
    each.Next()
assert names.index("SeaState") < names.index("Method") < names.index("UseLevels") < names.index("FollowCamera"), names
