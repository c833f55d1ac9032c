# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks share the simulations and the pairs of statistics, the planes of a wind and the sites of plants: the bytes of one
rank, a fraction of its work; where ranks have other input the first works alone, or each of them, and what one cannot do
ends on all of them with one message.

The file starts itself on three ranks; each writes what it has seen."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

import littoral
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

RANKS = 3


class Messages:
    """Errors of an algorithm."""

    def __init__(self, algorithm):
        self.texts = []
        self.CallDataType = "string0"  # what VTK's observers ask for
        algorithm.AddObserver("ErrorEvent", self)

    def __call__(self, caller, event, text):
        self.texts.append(text.strip().splitlines()[-1].partition("): ")[2])




def points(seed=3, count=None):
    source = littoral.vtkQuadratPointSource()
    source.SetQuadrats(20, 20)
    source.SetMeanPerQuadrat(2.0)
    source.SetSeed(seed)
    source.Update()
    whole = source.GetOutput()
    if count is None:
        return whole
    part = vtkPolyData()
    part.SetPoints(vtkPoints())
    for n in range(count):
        part.GetPoints().InsertNextPoint(whole.GetPoint(n))
    return part


def digest(algorithm):
    """Of all columns of all tables."""
    found = hashlib.sha256()
    rows = 0
    for port in range(algorithm.GetNumberOfOutputPorts()):
        table = algorithm.GetOutputDataObject(port)
        rows += table.GetNumberOfRows()
        for n in range(table.GetNumberOfColumns()):
            column = table.GetColumn(n)
            found.update(vtk_to_numpy(column).tobytes() if hasattr(column, "GetRange") else
                         repr([column.GetValue(k) for k in range(column.GetNumberOfValues())]).encode())
    return f"{rows} {found.hexdigest()[:12]}"


def statistics(pattern, simulations=39):
    filter = littoral.vtkPointPatternStatisticsFilter()
    filter.SetInputData(pattern)
    filter.SetNumberOfSimulations(simulations)
    return filter


def verdict(pattern):
    filter = littoral.vtkPatternVerdictFilter()
    filter.SetInputData(pattern)
    filter.SetNumberOfSimulations(19)
    return filter


def cases(rank):
    """Names and filters of what each rank is asked for."""
    yield "statistics", statistics(points(), 99)
    yield "verdict", verdict(points(count=200))
    yield "other input", statistics(points(seed=3 if rank != 1 else 4))
    yield "other simulations", statistics(points(count=60), 99 if rank != 1 else 39)
    unlike = verdict(points(count=20))
    unlike.SetSeed(5 if rank != 1 else 6)
    yield "verdict of another seed", unlike
    yield "input on one rank", statistics(points() if rank == 0 else vtkPolyData())
    yield "bad input", statistics(points(count=3))
    aborted = statistics(points())
    if rank == 1:
        aborted.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
    yield "aborted", aborted


def wind(seed=1, across=9, along=600):
    source = littoral.vtkWindFieldSource()
    source.SetDimensions(along, across, 4)
    source.SetSeed(seed)
    return source


def images(rank):
    """Names and sources of images of which each rank is asked for its piece."""
    yield "wind", wind()
    yield "wind of two columns, cut along", wind(across=2)
    veering = wind()
    veering.SetVeer(0.2)
    yield "veering wind", veering
    yield "other wind", wind(seed=1 + rank)
    yield "wind too large", wind(across=1 << 24)
    aborted = wind()
    if rank == 1:
        aborted.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
    yield "aborted wind", aborted


def values_of(image, extent):
    """What an image has in an extent: the bytes of its first array, and what its fields say."""
    array = image.GetPointData().GetArray(0) or image.GetCellData().GetArray(0)
    if array is None:
        return ""
    first, shape = image.GetExtent()[::2], image.GetDimensions()[::-1]
    values = vtk_to_numpy(array).reshape(*shape, -1)
    i, j, k = (slice(extent[2 * axis] - first[axis], extent[2 * axis + 1] + 1 - first[axis]) for axis in range(3))
    fields = image.GetFieldData()
    said = [fields.GetArray(n).GetTuple(0) for n in range(fields.GetNumberOfArrays()) if fields.GetArray(n)]
    return hashlib.sha256(values[k, j, i].tobytes() + repr(said).encode()).hexdigest()[:12]


def run_images(folder, rank, ranks):
    """Writes what a rank has of each image, beside what it has of a copy that it is asked for as a whole."""
    lines = []
    for name, source in images(rank):
        messages = Messages(source)
        source.UpdatePiece(rank, ranks, 0)
        extent = source.GetOutput().GetExtent()
        found = values_of(source.GetOutput(), extent)
        alone = next(other for own, other in images(-1 if "aborted" in name else rank) if own == name)
        Messages(alone)
        alone.Update()
        lines.append([name, extent, found, values_of(alone.GetOutput(), extent), " ".join(messages.texts)])
    with open(os.path.join(folder, f"images {rank}"), "w") as file:
        json.dump(lines, file)


def check_images(folder, ranks):
    """Each rank has its part with the bytes of the whole; the first alone says what is wrong."""
    covered = {}
    for rank in range(ranks):
        with open(os.path.join(folder, f"images {rank}")) as file:
            for name, extent, found, wanted, said in json.load(file):
                print(f"{name}, rank {rank}: {extent} {found} {said}")
                if "aborted" in name:
                    assert found == "" and not said, f"{name}: {found} {said}"
                    continue
                assert found == wanted, f"{name}: rank {rank} has {found}, one alone {wanted}"
                assert ("the bound" in said) == ("large" in name and rank == 0), f"{name}: {said}"
                covered[name] = covered.get(name, 0) + (extent[3] - extent[2] if found else 0)
    assert covered["wind"] == covered["veering wind"] == 8, covered


def sites(quadrats=40, seed=1):
    source = littoral.vtkQuadratPointSource()
    source.SetQuadrats(quadrats, quadrats)
    source.SetMeanPerQuadrat(3.0)
    source.SetSize(25.0 * quadrats, 20.0 * quadrats)
    source.SetSeed(seed)
    return source


def ground(columns=300):
    terrain = littoral.vtkTurningBandsTerrainSource()
    terrain.SetWholeExtent(0, columns, 0, 300, 0, 0)
    terrain.SetSpacing(4.0, 4.0, 1.0)
    return terrain


def forests():
    """Names of forests, and scatters of which each rank is asked for its piece."""
    plant = littoral.vtkReevesTreeSource()
    plant.SetPresetToShrub()

    def forest(sites, terrain=None):
        scatter = littoral.vtkPlantScatterFilter()
        scatter.SetInputConnection(0, sites.GetOutputPort())
        scatter.AddPrototypeConnection(plant.GetOutputPort())
        scatter.SetOutputFormToInstances()
        scatter.UseCullingOff()
        if terrain:
            scatter.SetTerrainConnection(terrain.GetOutputPort())
        return scatter

    yield "many sites", forest(sites())
    yield "sites on a terrain", forest(sites(), ground())
    yield "one quadrat", forest(sites(1))
    numbered = sites(12, 11)
    numbered.SetModeToSampling()
    measured = forest(numbered)
    measured.SetHeightArray("QuadratId")  # [m], the first quadrat being empty
    measured.SetNearDistance(20.0)
    measured.SetFarDistance(100.0)
    yield "measured trees", measured
    seen = forest(sites())
    seen.UseCullingOn()
    seen.SetPlantsPerCell(7.0)
    seen.SetViewPoint(300.0, 300.0, 2.0)
    seen.SetViewDirection(1.0, 0.4, 0.0)
    yield "in view", seen
    through = littoral.vtkConditionalTerrainFilter()  # which needs all sites
    survey = sites(10)
    through.SetInputConnection(0, survey.GetOutputPort())
    through.SetInputArrayToProcess(0, 0, 0, 0, "QuadratId")
    through.SetDimensions(60, 60)
    yield "a terrain through the sites", forest(survey, through)
    process = littoral.vtkPointProcessSource()
    yield "sites of a process", forest(process)
    yield "sites beyond the terrain", forest(sites(), ground(200))


def bytes_of(data):
    """Digest of all arrays of all leaves, and the number of instances."""
    found = hashlib.sha256()
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        for arrays in leaf.GetPointData(), leaf.GetCellData(), leaf.GetFieldData():
            for n in range(arrays.GetNumberOfArrays()):
                found.update(arrays.GetAbstractArray(n).GetName().encode())
                found.update(vtk_to_numpy(arrays.GetArray(n)).tobytes())
        if leaf.GetNumberOfPoints():
            found.update(vtk_to_numpy(leaf.GetPoints().GetData()).tobytes())
        iterator.GoToNextItem()
    fields = data.GetFieldData()
    for array in filter(None, map(fields.GetArray, range(fields.GetNumberOfArrays()))):
        found.update(vtk_to_numpy(array).tobytes())
    return [data.GetBlock(0).GetNumberOfPoints() if data.GetNumberOfBlocks() else 0, found.hexdigest()[:12]]


def run_forests(folder, rank, ranks, controllers):
    """Writes what a rank has of its piece of each forest, before and after a turn of the view, alone and with others."""
    lines = []
    for (name, shared), (_, alone) in zip(forests(), forests()):
        said = [Messages(shared), Messages(alone)]
        sums = []
        for turn in range(2):
            for scatter, controller in (shared, controllers[0]), (alone, controllers[1]):
                type(controllers[0]).SetGlobalController(controller)
                scatter.SetViewDirection(1.0, 0.4 - turn, 0.0)
                scatter.UpdatePiece(rank, ranks, 0)
                sums.append(bytes_of(scatter.GetOutputDataObject(0)))
        type(controllers[0]).SetGlobalController(controllers[0])
        read, made = shared.GetInputDataObject(0, 0), shared.GetOutputDataObject(0)
        identities = [set(vtk_to_numpy(points.GetPointData().GetArray("SiteId"))) if points.GetNumberOfPoints() else set()
                      for points in (read, made.GetBlock(0) if made.GetNumberOfBlocks() else read)]
        lines.append([name, sums, [len(identities[0]), len(identities[1] - identities[0])],
                      [" ".join(messages.texts) for messages in said]])
    with open(os.path.join(folder, f"forests {rank}"), "w") as file:
        json.dump(lines, file)


def check_forests(folder, ranks):
    """Each rank has the bytes of its piece, and has read a part of the sites; the first alone says what is wrong."""
    plants, reads = {}, {}
    for rank in range(ranks):
        with open(os.path.join(folder, f"forests {rank}")) as file:
            for name, (shared, alone, *turned), (read, dealt), (said, said_alone) in json.load(file):
                print(f"{name}, rank {rank}: {shared} of {read} sites and {dealt} of another, turned {turned[0]}; {said}")
                assert dealt <= 3 * 40, f"{name}: more than a row of quadrats is of another rank"
                assert shared == alone and turned[0] == turned[1], f"{name}: {alone}, {turned} alone"
                assert said == (said_alone if rank == 0 else ""), f"{name}: {said}; alone {said_alone}"
                assert ("lie outside" in said) == ("beyond" in name and rank == 0), f"{name}: {said}"
                plants[name] = plants.get(name, 0) + shared[0]
                reads.setdefault(name, []).append(read)
                if name == "in view":
                    assert shared != turned[0], "the view is not turned"
    assert plants["many sites"] == 4800 and plants["one quadrat"] == 3 and 0 < plants["in view"] < 4800, plants
    assert sum(reads["many sites"]) == 4800 and max(reads["many sites"]) < 2500, reads
    assert 0 in reads["one quadrat"], reads
    for name in "a terrain through the sites", "sites of a process":
        assert reads[name] == [plants[name]] * ranks, f"{name}: {reads}"
    assert sum(reads["measured trees"]) == plants["measured trees"] > 300, f"{reads}, {plants}"


def run_uneven(folder, rank, ranks):
    """Writes what a rank has of a forest whose sites come in parts on all ranks but one, which needs them all, and says."""
    name, scatter = next(one for one in forests() if one[0] == ("a terrain through the sites" if rank == 1 else "many sites"))
    messages = Messages(scatter)
    scatter.UpdatePiece(rank, ranks, 0)
    with open(os.path.join(folder, f"uneven {rank}"), "w") as file:
        json.dump([name, bytes_of(scatter.GetOutputDataObject(0))[0], " ".join(messages.texts)], file)


def check_uneven(folder, ranks):
    """The first rank says what to do, and those with a part have no plants."""
    for rank in range(ranks):
        with open(os.path.join(folder, f"uneven {rank}")) as file:
            name, plants, said = json.load(file)
        print(f"uneven, rank {rank}: {name}, {plants} plants; {said}")
        assert ("Not all ranks have a part of the sites" in said) == (rank == 0), said
        assert (plants > 0) == (rank == 1), f"rank {rank} has {plants} plants"


def run(folder, rank, ranks):
    """Writes what a rank has of each case, its processor time and its messages."""
    if ranks > 1:
        run_images(folder, rank, ranks)
        run_uneven(folder, rank, ranks)
    lines = []
    for name, filter in cases(rank):
        messages = Messages(filter)
        begin = time.process_time()
        filter.UpdatePiece(rank, ranks, 0)
        lines.append([name, digest(filter), time.process_time() - begin, " ".join(messages.texts)])
    with open(os.path.join(folder, str(rank)), "w") as file:
        json.dump(lines, file)


def on_ranks(folder):
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    run_forests(folder, controller.GetLocalProcessId(), controller.GetNumberOfProcesses(), (controller, None))
    run(folder, controller.GetLocalProcessId(), controller.GetNumberOfProcesses())


def seen(ranks, launcher=()):
    """What each of some ranks has, by cases."""
    with tempfile.TemporaryDirectory() as folder:
        command = [*launcher, sys.executable, os.path.abspath(__file__), folder, str(ranks)]
        subprocess.run(command, check=True, timeout=300, capture_output=True)
        found = {}
        if ranks > 1:
            check_images(folder, ranks)
            check_forests(folder, ranks)
            check_uneven(folder, ranks)
        for rank in range(ranks):
            with open(os.path.join(folder, str(rank))) as file:
                for name, *rest in json.load(file):
                    found.setdefault(name, []).append(rest)
    return found


def main():
    try:
        import mpi4py  # noqa: F401
        import vtkmodules.vtkParallelMPI  # noqa: F401
    except ImportError:
        print("there is no MPI in this VTK or Python")
        sys.exit(125)
    if not shutil.which("mpirun"):
        print("there is no mpirun")
        sys.exit(125)
    shared, alone = seen(RANKS, ("mpirun", "-np", str(RANKS))), seen(1)
    for name, ((found, time_of_first, said), *later) in shared.items():
        print(f"{name}: {time_of_first:.2f} s of {alone[name][0][1]:.2f} s; {said}")
        for other, _, words in later:
            assert other.startswith("0 ") and not words, f"{name}: a later rank has {other}, and says {words}"
        wanted = [later[0][0], ""] if name == "aborted" else alone[name][0][::2]
        assert [found, said] == wanted, f"{name}: {found}, {said} on ranks, {wanted} alone"
    assert "at least 5" in shared["bad input"][0][2], shared["bad input"]


if __name__ == "__main__":
    if len(sys.argv) < 2:
        main()
    elif sys.argv[2] == "1":
        run(sys.argv[1], 0, 1)
    else:
        on_ranks(sys.argv[1])
