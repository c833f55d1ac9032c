# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2 tier=all
"""The same terrain, fit, twin, valleys, fields through data, points, processes, verdict, stand, sea, wood, drift,
levels of detail, fog and seaweeds on any number of ranks.

The run on one rank writes its result; the others compare with it.
"""

import hashlib
import os

import numpy as np
import quick
from mistakes import inventory
from paraview import servermanager, simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.util.numpy_support import vtk_to_numpy

ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def whole_image(proxy, name="Elevation", grid=None):
    """An array of all ranks as one [row, column]; neighbours' shared points must agree."""
    cloud = servermanager.Fetch(simple.ConvertToPointCloud(Input=proxy))
    extent = proxy.GetDataInformation().GetExtent()
    spacing = np.array((grid or proxy).Spacing[:2])
    column, row = np.rint(vtk_to_numpy(cloud.GetPoints().GetData())[:, :2] / spacing).astype(int).T
    values = vtk_to_numpy(cloud.GetPointData().GetArray(name)).astype(float)
    image = np.full((extent[3] + 1, extent[1] + 1), np.nan)
    image[row, column] = values
    assert (image[row, column] == values).all(), "ranks disagree where they meet"
    assert not np.isnan(image).any(), "some points are on no rank"
    return image


def digest(values):
    """Hash of an array of NumPy or VTK."""
    return hashlib.sha256((values if isinstance(values, np.ndarray) else vtk_to_numpy(values)).tobytes()).hexdigest()


def digest_by(identity, data, *names):
    """Hashes of the points of a data set, then of its point arrays of these names, all in the order of another array."""
    arrays = [data.GetPoints().GetData(), *(data.GetPointData().GetArray(name) for name in names)]
    order = np.argsort(vtk_to_numpy(data.GetPointData().GetArray(identity)), kind="stable")
    return [digest(vtk_to_numpy(array)[order]) for array in arrays]


def part_of(plants, part, time):
    """A part of all plants at a time, of several blocks as one."""
    merged = simple.ExtractSurface(Input=simple.MergeBlocks(
        Input=simple.ExtractBlock(Input=plants, Selectors=[f"/Root/{part}"]), MergePoints=0))
    merged.UpdatePipeline(time)
    data = servermanager.Fetch(merged)
    assert data.GetNumberOfPoints() > 100, f"{data.GetNumberOfPoints()} points of {part} on {ranks} ranks"
    return data


def leaves(data):
    """The point sets of a data object that are not empty."""
    if not data.IsA("vtkDataObjectTree"):
        return [data] if data.GetNumberOfPoints() else []
    iterator = data.NewTreeIterator()
    found = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found += leaves(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


terrain = simple.TurningBandsTerrain(WholeExtent=[0, 200, 0, 150, 0, 0], Model="Spherical", Range=120.0)
fit = simple.CovarianceFit(Input=terrain)
twin = simple.TurningBandsTerrainFromFits(Input=fit, WholeExtent=[0, 120, 0, 99, 0, 0], Seed=9)
terrain.UpdatePipeline()
twin.UpdatePipeline()
fits = servermanager.Fetch(simple.OutputPort(fit, 0))
assert fits.GetNumberOfRows() == 7, f"{fits.GetNumberOfRows()} rows on {ranks} ranks"

result = [digest(whole_image(proxy)) for proxy in (terrain, twin)]
for name in ("ModelId", "Variance", "Range", "AICc"):
    result.append(vtk_to_numpy(fits.GetColumnByName(name)).tobytes().hex())
# Valleys and rivers, statistics of ground, normal scores, and a field through points that lie on different ranks.
valleys = simple.Drainage(Input=twin, Target=terrain, MaximumNumberOfIterations=2)
numbers = simple.GroundStatistics(Input=valleys)
scores = simple.NormalScores(Input=terrain)
survey = simple.Calculator(Input=simple.QuadratPoints(Quadrats=[8, 5], Size=[120.0, 90.0], MeanPerQuadrat=1.5),
                           ResultArrayName="Elevation", Function="sin(coordsX/17)*cos(coordsY/23)")
through = simple.ConditionalTerrain(Input=survey, Grid=twin, Model="Simple Exponential", StandardDeviation=1.0,
                                    Range=30.0, KrigingVariance=1, CrossValidation=1)
for proxy in (valleys, numbers, scores, through):
    proxy.UpdatePipeline()
for proxy, name, grid in ((valleys, "Elevation", twin), (valleys, "DrainageArea", twin),
                          (valleys, "StreamOrder", twin), (scores, "NormalScores", terrain),
                          (through, "Elevation", twin), (through, "KrigingVariance", twin)):
    result.append(digest(whole_image(proxy, name, grid)))
# Rivers and tables are on the first rank, and on no other.
rivers = valleys.GetClientSideObject().GetOutputDataObject(1)
assert rivers.GetNumberOfLines() > 20, f"{rivers.GetNumberOfLines()} rivers on {ranks} ranks"
assert valleys.GetDataInformation(1).GetNumberOfCells() == rivers.GetNumberOfLines()
result.append(digest(rivers.GetPoints().GetData()))
for proxy, port, rows in ((numbers, 0, {1}), (through, 1, range(20, 200))):
    table = proxy.GetClientSideObject().GetOutputDataObject(port)
    assert table.GetNumberOfRows() in rows, f"{table.GetNumberOfRows()} rows on {ranks} ranks"
    assert proxy.GetDataInformation(port).GetNumberOfRows() == table.GetNumberOfRows()
    for k in range(table.GetNumberOfColumns()):
        result.append(digest(table.GetColumn(k)))
scored = simple.NormalScores(Input=survey)
scored.UpdatePipeline()
cloud = servermanager.Fetch(scored)
count = cloud.GetNumberOfPoints()
assert count == servermanager.Fetch(survey).GetNumberOfPoints(), f"{count} scores on {ranks} ranks"
result += digest_by("SiteId", cloud, "NormalScores")

points = simple.QuadratPoints(Quadrats=[30, 20], Law="Negative Binomial", MeanPerQuadrat=2.0)
cloud = servermanager.Fetch(points)
sites = vtk_to_numpy(cloud.GetPointData().GetArray("SiteId"))
xyz = vtk_to_numpy(cloud.GetPoints().GetData())[np.argsort(sites)]
assert len(sites) == 1200, f"{len(sites)} points on {ranks} ranks"
result.append(digest(xyz))

# Point processes, their statistics and verdict, and an inventory as a stand.
for process in ("Thomas", "Matern II", "Log Gaussian Cox", "Strauss"):
    cloud = simple.PointProcess(Process=process, Size=[40.0, 30.0], Intensity=0.2, ClusterScale=1.5, Range=4.0,
                                Variance=0.5, Distance=0.8, Activity=0.4)
    found = servermanager.Fetch(cloud)
    count = found.GetNumberOfPoints()
    assert 100 < count < 500, f"{count} points of {process} on {ranks} ranks"
    result += digest_by("SiteId", found)
statistics = simple.PointPatternStatistics(Input=cloud, Size=[40.0, 30.0], NumberOfSimulations=19)
verdict = simple.PatternVerdict(Input=cloud, Size=[40.0, 30.0], NumberOfSimulations=19)
for table, columns in ((statistics, ("L(r) - r", "GlobalHigh")), (verdict, ("PValue", "ClusterScale"))):
    found = servermanager.Fetch(simple.OutputPort(table, 0))
    result += [vtk_to_numpy(found.GetColumnByName(name)).tobytes().hex() for name in columns]
stand = servermanager.Fetch(simple.StandInventory(Inventory=inventory()))
assert stand.GetNumberOfPoints() == 20, f"{stand.GetNumberOfPoints()} trees on {ranks} ranks"
result += digest_by("SiteId", stand, "DBH", "Height", "Species")

orbits = simple.ParticleOrbits(Input=points, SeaState=simple.SeaState(WaterDepth=12.0))
orbits.UpdatePipeline(7.3)
moved = servermanager.Fetch(orbits)
order = np.argsort(vtk_to_numpy(moved.GetPointData().GetArray("SiteId")))
places = vtk_to_numpy(moved.GetPoints().GetData())[order]
assert 0.1 < np.abs(places - xyz).max() < 10.0, "particles do not ride on the waves"
result.append(digest(places))

# A wood in the wind: places of all joints and crowns, by plant.
tree = simple.ReevesTree(Preset="Shrub")
wood = simple.PlantScatter(Sites=simple.QuadratPoints(Quadrats=[4, 3], Size=[24.0, 18.0]), Prototypes=[tree],
                           FollowCamera=0, UseCulling=0, NearDistance=12.0, FarDistance=900.0,
                           ViewPoint=[0.0, 0.0, 2.0])
wind = simple.WindField(Dimensions=[240, 24, 6], ReferenceSpeed=14.0)
sway = simple.BeamTreeDeformation(Input=wood, Wind=wind, Prototypes=[tree])
for part in ("High/Skeleton", "High/Leaves", "Medium/Crown"):
    result += digest_by("PlantId", part_of(sway, part, 2.3))

particles = simple.SuspendedParticles(Density=0.3)
tide = simple.WindField(Dimensions=[60, 16, 8], TimeStep=0.5)
drift = simple.CurrentDrift(Input=particles, KeepInWater=0, Currents=[
    tide, simple.FlowPrimitive(FlowType="Vortex", Strength=6.0, Axis=[0.0, 0.2, 1.0], Center=[1.0, 0.0, 0.0]),
    simple.FlowPrimitive(FlowType="Sink", Strength=9.0, Center=[2.0, -3.0, -4.0])])
drift.UpdatePipeline(4.25)
cloud = servermanager.Fetch(drift)
assert cloud.GetNumberOfPoints() > 6000, f"{cloud.GetNumberOfPoints()} particles on {ranks} ranks"
result += digest_by("ParticleId", cloud, "ParticleId", "Radius", "RGB", "Captured")
assert 10 < vtk_to_numpy(cloud.GetPointData().GetArray("Captured")).sum() < 1000

levels = simple.ParticleLevelOfDetail(
    Input=points, SeaState=orbits.SeaState, FollowCamera=0, ViewPoint=[500.0, -1.0, 0.5], MiddleDistance=300.0,
    FarDistance=700.0, BlendDistance=20.0, VisibleDistance=0.0, OffsetRange=[0.0, 100.0])
drifting = simple.ParticleOrbits(Input=levels, SeaState=orbits.SeaState)
drifting.UpdatePipeline(7.3)
for name in ("Near", "MasterSlave", "Far"):
    one = servermanager.Fetch(simple.ExtractBlock(Input=drifting, Selectors=[f"/Root/{name}"]))
    pieces = leaves(one)
    arrays = [np.concatenate([vtk_to_numpy(piece.GetPointData().GetArray(name)) for piece in pieces])
              for name in ("ParticleId", "Alpha", "TrainCount")]
    order = np.argsort(arrays[0])
    assert len(order) > 0, "a level is empty"
    arrays.append(np.concatenate([vtk_to_numpy(piece.GetPoints().GetData()) for piece in pieces]))
    result.append(hashlib.sha256(b"".join(array[order].tobytes() for array in arrays)).hexdigest())
fog = simple.ParticleFog(Input=levels, Dimensions=[9, 8, 2], ParticleRadius=0.05)
fog.UpdatePipeline()
cloud = servermanager.Fetch(simple.ConvertToPointCloud(Input=fog))
xyz = vtk_to_numpy(cloud.GetPoints().GetData())
values = vtk_to_numpy(cloud.GetPointData().GetArray("Extinction"))
cells, first = np.unique(np.rint(xyz * 1e3).astype(int), axis=0, return_index=True)
assert len(cells) == 9 * 8 * 2, f"{len(cells)} samples of fog on {ranks} ranks"
result.append(digest(values[first]))

# Seaweeds in a swell with a current: all segments, blades and stipes, by plant; in full, and in levels of detail.
weeds = [simple.Seaweed(Preset="Eelgrass"), simple.Seaweed(Preset="Sugar Kelp")]
meadow = simple.PlantScatter(Sites=simple.QuadratPoints(Quadrats=[3, 3], Size=[6.0, 6.0]), Prototypes=weeds,
                             FollowCamera=0, UseCulling=0, UseLevels=0)
kelp = simple.SeaweedDeformation(Input=meadow, SeaState=simple.SeaState(SeaLevel=8.0), StartTime=0.0,
                                 Currents=[simple.FlowPrimitive(Strength=0.1)], FollowCamera=0, GenerateMotion=1,
                                 ViewPoint=[-2.0, 3.0, 1.0], ViewDirection=[1.0, 0.0, 0.0], ViewAngle=70.0,
                                 NearDistance=3.0, FarDistance=5.0, BlendDistance=1.0)
counts = set()
for kelp.Method, kelp.UseLevels in (("Physical", 1), ("Procedural", 0)):
    for part, names in (("High/Skeleton", ("Velocity", "Acceleration")), ("High/Leaves", ()), ("High/Skin", ())):
        hashes = digest_by("PlantId", part_of(kelp, part, 1.31), *names)
        result += hashes
        counts.add((part, hashes[0]))
assert len(counts) == 6, "methods or levels of detail are of no effect"
text = "\n".join(result)
if ranks == 1:
    with open("result.txt", "w") as file:
        file.write(text)
else:
    assert os.path.exists("result.txt"), "the run on one rank comes first"
    with open("result.txt") as file:
        wanted = file.read().split("\n")
    differing = [line for line, (a, b) in enumerate(zip(result, wanted)) if a != b]
    assert not differing, f"{ranks} ranks give another result than one in lines {differing}"
print(f"{ranks} ranks: {result[0][:16]} {result[1][:16]}")
