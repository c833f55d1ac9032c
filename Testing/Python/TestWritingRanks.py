# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=2
# run-with: python3 tier=all name=three args=3
# run-with: python3 tier=all name=memory args=3 args=memory
"""Ranks write one file together: the bytes of one rank. What one of them cannot do ends on all, with one message on the
first, and nothing is left: a part that fails, an input on one rank alone or on none, a full disk, parts that do not fit.
No rank takes the memory of the whole.

The file starts itself on one rank and on several; each writes what it has seen."""

import contextlib
import hashlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

import littoral
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

LIMIT = 240  # [s], after which ranks wait for each other
HAS_TILES = hasattr(littoral, "vtkForestTilesWriter")
HAS_VOLUMES = hasattr(littoral, "vtkVDBVolumeWriter")
HAS_NETCDF = hasattr(littoral, "vtkOceanCurrentReader")
HAS_RASTERS = hasattr(littoral, "vtkElevationWriter")
FOLDERS = contextlib.ExitStack()  # of inputs, until the end
TILE = ('<SimpleSource><SourceFilename relativeToVRT="1">{number}.tif</SourceFilename><SourceBand>1</SourceBand>'
        '<SourceProperties RasterXSize="20" RasterYSize="30"/><SrcRect xOff="0" yOff="0" xSize="20" ySize="30"/>'
        '<DstRect xOff="0" yOff="{row}" xSize="20" ySize="30"/></SimpleSource>')


class Messages:
    """Errors of an algorithm, and none on the standard streams."""

    def __init__(self, *algorithms):
        self.texts = []
        self.CallDataType = "string0"  # what VTK's observers ask for
        for algorithm in algorithms:
            algorithm.AddObserver("ErrorEvent", self)
            algorithm.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)

    def __call__(self, caller, event, text):
        self.texts.append(text.strip().splitlines()[-1].partition("): ")[2])


class Image(VTKPythonAlgorithmBase):
    """An image of any part that is asked for, whose values follow from their places."""

    def __init__(self, points, fill, fails=False, spacing=(2.0, 3.0, 4.0), fields=(), times=()):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self.whole = [bound for count in points for bound in (-2, count - 3)]
        self.fill, self.fails, self.spacing, self.fields, self.times = fill, fails, spacing, fields, times

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.WHOLE_EXTENT(), self.whole, 6)
        info.Set(self.CAN_PRODUCE_SUB_EXTENT(), 1)
        if self.times:
            info.Set(Pipeline.TIME_STEPS(), self.times, len(self.times))
            info.Set(Pipeline.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        if self.fails and not (self.times and info.Get(Pipeline.UPDATE_TIME_STEP()) == self.times[0]):
            self.GetOutputDataObject(0).Initialize()
            return 0
        image = vtkImageData.GetData(outputs)
        extent = [0] * 6
        info.Get(Pipeline.UPDATE_EXTENT(), extent)
        fill_image(image, extent, self.fill, self.spacing, self.fields)
        return 1


def fill_image(image, extent, fill, spacing=(2.0, 3.0, 4.0), fields=()):
    image.SetExtent(extent)
    image.SetOrigin(5.0, -7.0, 1.0)
    image.SetSpacing(spacing)
    for name, value in fields:
        field = numpy_to_vtk(np.array([value]), deep=True)
        field.SetName(name)
        image.GetFieldData().AddArray(field)
    if image.GetNumberOfPoints() > 0:
        axes = [np.arange(extent[2 * axis], extent[2 * axis + 1] + 1, dtype=np.float32) for axis in (2, 1, 0)]
        places = np.meshgrid(*axes, indexing="ij", sparse=True)
        fill(image, *places[::-1])
    return image


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float32), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def heights(image, i, j, k):
    add(image.GetPointData(), "Elevation", (100.0 * np.sin(0.01 * i) * np.cos(0.02 * j) + k).ravel())
    add(image.GetPointData(), "Other", (i + j + k).ravel())
    image.GetPointData().SetActiveScalars("Other")


def velocities(image, i, j, k):
    parts = np.broadcast_arrays(8.0 + np.sin(0.3 * i + j), np.cos(0.2 * i * k), 0.1 * np.sin(i + 0.5 * j * k))
    add(image.GetPointData(), "Velocity", np.stack(parts, axis=-1).reshape(-1, 3))


def smoke(image, i, j, k):
    density = np.maximum(0.0, 20.0 - np.abs(i - 50) - np.abs(j - 9)) * (1.0 + k % 7)
    add(image.GetPointData(), "density", density.ravel())


def spoiled_smoke(image, i, j, k):
    smoke(image, i, j, k)
    values = image.GetPointData().GetArray("density")
    values.SetValue(values.GetNumberOfValues() - 1, float("nan"))


def leaves(image, i, j, k):
    density = np.abs(np.sin(0.7 * i + 0.3 * j + 0.9 * k)) * ((i + j + k) % 3 > 0)
    density = density[tuple(slice(0, max(1, count - 1)) for count in density.shape)]
    add(image.GetCellData(), "BulkDensity", density.ravel())
    add(image.GetCellData(), "LeafAreaDensity", 2.0 * density.ravel())


def trees(count, first=0):
    """Feet and sizes of some trees."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    at = np.arange(first, first + count, dtype=float)
    for n in at:
        data.GetPoints().InsertNextPoint(7.0 * n, 11.0 * (n % 5), 0.1 * n)
    for name, values in (("Height", 5.0 + at % 9), ("CrownDiameter", 2.0 + at % 4), ("LeafAreaIndex", 1.0 + at % 3)):
        add(data.GetPointData(), name, values)
    return data


def forest(feet):
    scattered = littoral.vtkPlantScatterFilter()
    scattered.SetInputDataObject(0, feet)
    tree = littoral.vtkReevesTreeSource()
    tree.SetPreset(littoral.vtkReevesTreeSource.Custom)
    tree.SetOrders(2)
    tree.SetNumberOfLeaves(20)
    tree.SetTextureSize(16, 8)
    scattered.AddPrototypeConnection(tree.GetOutputPort())
    scattered.UseCullingOff()
    scattered.SetPlantsPerCell(4.0)
    scattered.SetOutputFormToInstances()
    return scattered


def writer(kind, source, **settings):
    made = getattr(littoral, kind)()
    if isinstance(source, (vtkPolyData, vtkImageData)):
        made.SetInputDataObject(0, source)
    elif source is not None:
        made.SetInputConnection(source.GetOutputPort())
    for name, value in settings.items():
        getattr(made, "Set" + name)(*value if isinstance(value, tuple) else (value,))
    return made


WIND = (("ConvectionSpeed", 8.0),)
PLACE = {"CoordinateSystem": "EPSG:32632", "CoordinateOffset": (480000.0, 5400000.0), "TreesPerTile": 16}


def own_trees(rank, ranks, count=60):
    """The trees of a rank; those of all are 0, 1, ..."""
    bounds = [count * n // ranks for n in range(ranks + 1)]
    return trees(bounds[rank + 1] - bounds[rank], bounds[rank])


def files(rank, ranks):
    """Names of files that are written, and their writers."""
    if HAS_RASTERS:
        # of more than one part of 32 MiB; and of a source of terrain
        yield "heights.tif", writer("vtkElevationWriter", Image((600, 7500, 1), heights), Compression=0)
        yield "few.tif", writer("vtkElevationWriter", Image((2, 2, 1), heights))  # of fewer cells than three ranks
        terrain = littoral.vtkTurningBandsTerrainSource()
        terrain.SetWholeExtent(0, 90, 0, 70, 0, 0)
        yield "terrain.tif", writer("vtkElevationWriter", terrain)
    for name in ("wind.bts", "wind.wnd", "wind.hawc") + (("wind.nc",) if HAS_NETCDF else ()):
        yield name, writer("vtkWindFieldWriter", Image((40, 7, 6), velocities, fields=WIND))
    turbulent = littoral.vtkWindFieldSource()
    turbulent.SetDimensions(60, 9, 4)
    yield "turbulent.bts", writer("vtkWindFieldWriter", turbulent)
    for name in ("fire.bdf", "fire.dat") + (("palm.nc",) if HAS_NETCDF else ()):
        yield name, writer("vtkForestDensityWriter", Image((9, 12, 7), leaves))
    yield "rows.amrwind", writer("vtkForestDensityWriter", own_trees(rank, ranks))
    if HAS_TILES:
        yield "forest.json", writer("vtkForestTilesWriter", forest(trees(60)), **PLACE)
    if HAS_VOLUMES:
        yield "smoke.vdb", writer("vtkVDBVolumeWriter", Image((128, 230, 256), smoke))
        yield "wind.vdb", writer("vtkVDBVolumeWriter", Image((40, 7, 6), velocities, fields=WIND))
        series = Image((40, 7, 6), velocities, times=(0.0, 1.0, 2.0))
        yield "series.vdb", writer("vtkVDBVolumeWriter", series, WriteAllTimeSteps=True)
        yield "cells.vdb", writer("vtkVDBVolumeWriter", Image((20, 17, 30), leaves))


def on_one(rank, owner, data, empty):
    return data if rank == owner else empty


def sole_files(rank, ranks):
    """Files of an input that lives on the last rank alone; of one rank, that of the others is not there at all."""
    here = rank == ranks - 1
    extent = [0, 29, 0, 19, 0, 0]
    box = [0, 29, 0, 6, 0, 5]
    if HAS_RASTERS:
        yield "sole.tif", writer("vtkElevationWriter", fill_image(vtkImageData(), extent, heights) if here else vtkImageData())
        yield "absent.tif", writer("vtkElevationWriter", fill_image(vtkImageData(), extent, heights) if here else None)
    wind = fill_image(vtkImageData(), box, velocities, fields=WIND) if here else vtkImageData()
    yield "sole.bts", writer("vtkWindFieldWriter", wind)
    yield "sole.bdf", writer("vtkForestDensityWriter", fill_image(vtkImageData(), box, leaves) if here else None)
    yield "sole.amrwind", writer("vtkForestDensityWriter", trees(9) if here else vtkPolyData())
    if HAS_TILES:
        yield "sole.json", writer("vtkForestTilesWriter", forest(trees(9)) if here else None, **PLACE)
    if HAS_VOLUMES:
        yield "sole.vdb", writer("vtkVDBVolumeWriter", wind)
        yield "absent.vdb", writer("vtkVDBVolumeWriter", wind if here else None)


def bad_files(rank, ranks):
    """Files that cannot be written, their writers, and words of the message; none where an input tells why."""
    last = rank == ranks - 1
    first = rank == 0
    failed = f"the input has failed on rank {ranks - 1}"
    if HAS_RASTERS:
        yield "failed.tif", writer("vtkElevationWriter", Image((30, 40, 1), heights, fails=last)), failed
        yield "mute.tif", writer("vtkElevationWriter", Image((30, 40, 1), heights, fails=first)), ""
        spacing = (2.0, 3.0 + rank, 4.0)
        yield "torn.tif", writer("vtkElevationWriter", Image((30, 40, 1), heights, spacing=spacing)), "parts of the ranks"
        rows = [0, 9, 20 * rank, 20 * rank + 10, 0, 0]
        yield "gap.tif", writer("vtkElevationWriter", fill_image(vtkImageData(), rows, heights)), "points of the image are on no rank"
        unnamed = writer("vtkElevationWriter", Image((30, 40, 1), heights))
        unnamed.SetInputArrayToProcess(0, 0, 0, 0, "Absent")
        yield "array.tif", unnamed, "no point array 'Absent'"
        yield "none.tif", writer("vtkElevationWriter", None), "there is no input"
        yield "empty.tif", writer("vtkElevationWriter", vtkImageData()), "the image has no points"
        yield "tiles.tif", writer("vtkElevationWriter", mosaic()), failed
        yield "nowhere/heights.tif", writer("vtkElevationWriter", Image((30, 40, 1), heights)), "there is no folder"
    yield "failed.bts", writer("vtkWindFieldWriter", Image((40, 7, 6), velocities, fails=last, fields=WIND)), failed
    yield "failed.bdf", writer("vtkForestDensityWriter", Image((9, 12, 7), leaves, fails=last)), failed
    yield "empty.amrwind", writer("vtkForestDensityWriter", vtkPolyData()), "Height"
    if HAS_TILES:
        wood = forest(trees(30))
        if last:
            wood.SetSlopeLimit(-1.0)
        yield "failed.json", writer("vtkForestTilesWriter", wood, **PLACE), failed
        yield "empty.json", writer("vtkForestTilesWriter", forest(trees(30)), **{**PLACE, "CoordinateSystem": "EPSG:0"}), "EPSG:0"
    if HAS_VOLUMES:
        yield "failed.vdb", writer("vtkVDBVolumeWriter", Image((40, 7, 6), velocities, fails=last)), failed
        yield "late.vdb", late(fails=last), failed
        yield "mute.vdb", writer("vtkVDBVolumeWriter", Image((40, 7, 6), velocities, fails=first)), ""
        fill = spoiled_smoke if last else smoke
        yield "spoiled.vdb", writer("vtkVDBVolumeWriter", Image((40, 20, 16), fill)), "not a finite"
        yield "none.vdb", writer("vtkVDBVolumeWriter", None), "input"


def mosaic():
    """The reader of three tiles, of which the northernmost, in the part of the last rank, has another size."""
    folder = FOLDERS.enter_context(tempfile.TemporaryDirectory())
    tiles = ""
    for number, rows in enumerate((29, 30, 30)):
        image = fill_image(vtkImageData(), [0, 19, 0, rows - 1, 0, 0], heights)
        tile = writer("vtkElevationWriter", image, FileName=os.path.join(folder, f"{number}.tif"), Controller=None)
        assert tile.Write() == 1
        tiles += TILE.format(number=number, row=30 * number)
    with open(os.path.join(folder, "mosaic.vrt"), "w") as file:
        file.write(f'<VRTDataset rasterXSize="20" rasterYSize="90"><GeoTransform>0,2,0,0,0,-3</GeoTransform>'
                   f'<VRTRasterBand dataType="Float32" band="1">{tiles}</VRTRasterBand></VRTDataset>')
    reader = littoral.vtkElevationReader()
    reader.SetFileName(file.name)
    return reader


def late(fails):
    """The writer of a series whose input fails after the first time."""
    source = Image((40, 7, 6), velocities, fails=fails, times=(0.0, 1.0, 2.0))
    return writer("vtkVDBVolumeWriter", source, WriteAllTimeSteps=True)


def full_disks(rank, ranks):
    """Writers of files that are larger than what the first rank may write."""
    for name, made in files(rank, ranks):
        if name.startswith(("terrain", "wind.", "forest")):
            yield name, made, "File too large"
    rows = writer("vtkForestDensityWriter", own_trees(rank, ranks, 4000))
    yield "rows.amrwind", rows, "File too large"


def short_of_memory(rank, ranks):
    """Writers whose last rank has its part, and no memory to hand it over."""
    sources = [("short.tif", "vtkElevationWriter", Image((600, 7500, 1), heights), "has no memory to hand over")]
    sources += [("short.vdb", "vtkVDBVolumeWriter", Image((128, 230, 256), smoke), "A part of the volumes needs")]
    for name, kind, source, words in sources[0 if HAS_RASTERS else 1:2 if HAS_VOLUMES else 1]:
        source.UpdatePiece(rank, ranks, 0)
        limits = resource.getrlimit(resource.RLIMIT_AS)
        with open("/proc/self/statm", encoding="ascii") as statm:
            used = int(statm.read().split()[0]) * resource.getpagesize()
        if rank == ranks - 1:
            resource.setrlimit(resource.RLIMIT_AS, (used + (6 << 20), limits[1]))
        yield name, writer(kind, source), words
        resource.setrlimit(resource.RLIMIT_AS, limits)


def write(made, folder, name):
    """The answer of a writer, its messages and those of its source."""
    said = Messages(made)
    if made.GetNumberOfInputConnections(0):
        Messages(made.GetInputAlgorithm(0, 0))
    made.SetFileName(os.path.join(folder, name))
    return made.Write(), said.texts


def run(folder, rank, ranks):
    """Writes what a rank has seen: names, answers, messages, and words that are wanted."""
    seen = []
    for name, made in [*files(rank, ranks), *sole_files(rank, ranks)]:
        seen.append([name, *write(made, folder, name), None])
    bad = os.path.join(folder, "bad")
    if ranks == 1 and hasattr(littoral, "vtkGLTFSceneWriter"):
        ground = Image((40, 30, 1), heights, fails=True, times=(0.0, 1.0, 2.0))
        motion = writer("vtkGLTFSceneWriter", ground, WriteMotion=True, EndTime=2.0, FramesPerSecond=1.0)
        seen.append(["late.glb", *write(motion, bad, "late.glb"), ""])
    if ranks == 1 and HAS_VOLUMES:
        seen.append(["late.vdb", *write(late(fails=True), bad, "late.vdb"), ""])
    if ranks > 1:
        for name, made, words in [*bad_files(rank, ranks)]:
            seen.append([name, *write(made, bad, name), words])
        for name, made, words in short_of_memory(rank, ranks):
            seen.append([name, *write(made, bad, name), words])
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        if rank == 0:
            resource.setrlimit(resource.RLIMIT_FSIZE, (300, limits[1]))
        for name, made, words in full_disks(rank, ranks):
            seen.append([name, *write(made, bad, name), words])
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    if HAS_VOLUMES and rank == 0:
        os.remove(os.path.join(bad, "late_0000.vdb"))  # the first of the series was whole
    with open(os.path.join(folder, f"seen {rank}"), "w") as file:
        json.dump(seen, file)


def peak():
    """The most memory that this process had [bytes]."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmHWM")) * 1024


def sparse(image, i, j, k):
    density = np.zeros(np.broadcast_shapes(i.shape, j.shape, k.shape), np.float32)
    density[::16, :64, :64] = 1.5
    add(image.GetPointData(), "density", density.ravel())


def run_memory(folder, rank, ranks):
    """Writes what memory the writers of large files take of a rank, over that of the whole, besides its part."""
    seen = []
    cases = [("large.bts", "vtkWindFieldWriter", Image((27000, 40, 40), velocities, fields=WIND), 3)]
    cases += [("large.vdb", "vtkVDBVolumeWriter", Image((384, 384, 384), sparse), 1)] if HAS_VOLUMES else []
    for name, kind, source, components in cases:
        source.UpdatePiece(rank, ranks, 0)
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
        before = peak()
        answer, said = write(writer(kind, source), folder, name)
        assert answer == 1, said
        counts = [source.whole[2 * axis + 1] - source.whole[2 * axis] + 1 for axis in range(3)]
        seen.append([name, (peak() - before) / (4.0 * components * np.prod(counts))])
    with open(os.path.join(folder, f"seen {rank}"), "w") as file:
        json.dump(seen, file)


def on_ranks(folder, task):
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    task(folder, controller.GetLocalProcessId(), controller.GetNumberOfProcesses())


def contents(folder):
    """Hashes of the files of a folder and of those below it."""
    found = {}
    for path, _, names in os.walk(folder):
        for name in names:
            if not name.startswith("seen ") and "bad" not in path:
                with open(os.path.join(path, name), "rb") as file:
                    found[os.path.relpath(os.path.join(path, name), folder)] = hashlib.sha256(file.read()).hexdigest()
    return found


def started(task, folder, ranks):
    """What each rank has seen."""
    launcher = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command = [*launcher, sys.executable, os.path.abspath(__file__), "on", folder, str(ranks), task]
    environment = {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"}
    ran = subprocess.run(command, check=False, timeout=LIMIT, capture_output=True, text=True, env=environment)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    seen = []
    for rank in range(ranks):
        with open(os.path.join(folder, f"seen {rank}")) as file:
            seen.append(json.load(file))
    return seen


def check_memory(ranks):
    with tempfile.TemporaryDirectory() as folder:
        for case in zip(*started("memory", folder, ranks)):
            print(f"{case[0][0]}: {[round(share, 2) for _, share in case]} of the whole", flush=True)
            assert all(share < 0.4 for _, share in case), case


def start(folder, ranks):
    os.makedirs(os.path.join(folder, "bad"))
    kept = os.path.join(folder, "bad", "wind.bts")
    with open(kept, "w") as file:
        file.write("as it was")
    seen = started("files", folder, ranks)
    assert os.listdir(os.path.join(folder, "bad")) == ["wind.bts"], f"left: {os.listdir(os.path.join(folder, 'bad'))}"
    with open(kept) as file:
        assert file.read() == "as it was"
    return contents(folder), seen


def check_seen(seen):
    """Files that were written were so on all ranks; of the others the first alone says why."""
    for case in zip(*seen):
        name, _, said, words = case[0]
        print(f"{name}: {[answer for _, answer, _, _ in case]} {said}", flush=True)
        for rank, (own, answer, texts, _) in enumerate(case):
            assert own == name and answer == (1 if words is None else 0), f"{name}: rank {rank} answers {answer}: {texts}"
            wanted = 1 if words and rank == 0 else 0
            assert len(texts) == wanted, f"{name}: rank {rank} says {texts}, wanted is {words}"
        assert not words or words in said[0], f"{name}: {said}, wanted is {words}"


def main(ranks, task="files"):
    try:
        import mpi4py  # noqa: F401
        import vtkmodules.vtkParallelMPI  # noqa: F401
    except ImportError:
        print("there is no MPI in this VTK or Python")
        sys.exit(125)
    if not shutil.which("mpirun"):
        print("there is no mpirun")
        sys.exit(125)
    if task == "memory":
        check_memory(ranks)
        return
    with tempfile.TemporaryDirectory() as folder:
        alone, of_one = start(os.path.join(folder, "1"), 1)
        shared, of_all = start(os.path.join(folder, str(ranks)), ranks)
        check_seen(of_one)
        check_seen(of_all)
        assert len(alone) > 25, sorted(alone)
        assert sorted(shared) == sorted(alone), sorted(set(shared) ^ set(alone))
        differing = [name for name in alone if alone[name] != shared[name]]
        assert not differing, f"{differing} differ on {ranks} ranks"


if __name__ == "__main__":
    if sys.argv[1] != "on":
        main(int(sys.argv[1]), *sys.argv[2:])
    elif sys.argv[3] == "1":
        run(sys.argv[2], 0, 1)
    else:
        on_ranks(sys.argv[2], run_memory if sys.argv[4] == "memory" else run)
