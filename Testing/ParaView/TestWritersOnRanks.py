# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2 tier=all
# run-with: pvbatch mpi=1,3 tier=all name=three
"""Save Data writes rasters, winds, forests and tiles once, with the same bytes on any number of ranks. A rank whose part
is missing, or a full disk of the first rank, ends it on all with one message. The script runs on the first rank.

TestWritingRanks has each writer without ParaView, TestVolumes the volumes."""

import hashlib
import os
import resource
import signal
from glob import glob

import quick
from messages import complaints
from paraview import servermanager, simple

RANKS = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()

#: A rank makes no part of an image, as if it could not, which was announced.
MISSING = """
from paraview.servermanager import vtkProcessModule
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
extent = [0] * 6
self.GetExecutive().GetOutputInformation(0).Get(Pipeline.UPDATE_EXTENT(), extent)
if vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
    image = self.GetOutput()
    image.SetExtent(extent)
    image.AllocateScalars(11, 1)
    image.GetPointData().GetScalars().SetName("Elevation")
    image.GetPointData().GetScalars().Fill(1.0)
"""
ANNOUNCED = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
info = self.GetExecutive().GetOutputInformation(0)
info.Set(Pipeline.WHOLE_EXTENT(), [0, 30, 0, 20, 0, 0], 6)
info.Set(self.CAN_PRODUCE_SUB_EXTENT(), 1)
"""


def digests(pattern):
    found = {}
    for path in sorted(glob(pattern) + glob(pattern + "/*")):
        if os.path.isfile(path):
            with open(path, "rb") as file:
                found[path.partition("/")[2]] = hashlib.sha256(file.read()).hexdigest()
    return found


def written(path, proxy, **options):
    simple.SaveData(f"{RANKS}/{path}", proxy=proxy, **options)


def left():
    return [path for path in glob(f"{RANKS}/.*") if ".littoral" in path]


os.makedirs(str(RANKS), exist_ok=True)
for old in glob(f"{RANKS}/*"):
    if os.path.isfile(old):
        os.remove(old)
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 120, 0, 90, 0, 0])
written("terrain.tif", terrain)
wind = simple.WindField(Dimensions=[60, 9, 5])
for name in ("wind.bts", "wind.hawc", "wind.wnd", "wind.nc"):
    written(name, wind)
sites = simple.QuadratPoints(Quadrats=[8, 6], Size=[80.0, 60.0], MeanPerQuadrat=1.5)
tree = simple.ReevesTree(Preset="Shrub")
wood = simple.PlantScatter(Sites=sites, Prototypes=[tree], FollowCamera=0, UseCulling=0, OutputForm="Instances")
written("wood.json", wood, CoordinateSystem="EPSG:32632", CoordinateOffset=[480000.0, 5400000.0], TreesPerTile=16)
density = simple.ForestDensity(Input=wood)
for name in ("fire.bdf", "fire.dat", "palm.nc"):
    written(name, simple.OutputPort(density, 0))
written("rows.amrwind", simple.OutputPort(density, 3))
seen, wanted = digests(f"{RANKS}/*"), digests("1/*")
assert len(wanted) >= 14, sorted(wanted)
assert seen == wanted, f"differ on {RANKS} ranks: {[name for name in wanted if seen.get(name) != wanted[name]]}"

if RANKS > 1:
    torn = simple.ProgrammableSource(OutputDataSetType="vtkImageData", Script=MISSING, ScriptRequestInformation=ANNOUNCED)
    torn.UpdatePipeline()
    for name in ("torn.tif", "torn.vdb"):
        said = complaints(lambda: written(name, torn))
        assert "a rank has not its part of the image" in said and said.count("Cannot write") == 1, f"{name}: {said}"

limits = resource.getrlimit(resource.RLIMIT_FSIZE)
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
for name, proxy in (("full.tif", terrain), ("full.bts", wind), ("full.json", wood)):
    options = {"CoordinateSystem": "EPSG:32632"} if name == "full.json" else {}
    resource.setrlimit(resource.RLIMIT_FSIZE, (400, limits[1]))
    said = complaints(lambda: written(name, proxy, **options))
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert said.count("Cannot write") == 1 and "File too large" in said, f"{name}: {said}"
assert not glob(f"{RANKS}/full*") and not glob(f"{RANKS}/torn*") and not left(), sorted(os.listdir(str(RANKS)))
