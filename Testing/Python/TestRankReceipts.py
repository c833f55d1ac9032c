# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3
# run-with: python3 name=rest args=rest
"""No rank receives more than 1 % of the output of another, but for what its class says that it needs. The bytes are
counted between VTK and MPI, by mpi_received.c. With `rest`: classes that share no work receive nothing at all.

The file starts itself on three ranks; each writes what it has received of the others, and the bytes of its output."""

import ctypes
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TESTING = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTING), str(TESTING / "Benchmarks"), str(TESTING / "Fuzz")]
import classes  # noqa: E402
import ranks as benchmark  # noqa: E402

RANKS = 3
MOST = 0.01  # of the output of another
AGREEMENT = 4096  # bytes of whether another can go on, 256 an exchange, whatever the size of the data
VIEWS, BYTES_OF_VIEW = 25, 86016  # pictures of a prototype
TAG = 7
PLACE = {"CoordinateSystem": "EPSG:32632", "CoordinateOffset": (480000.0, 5400000.0)}
#: Classes of which ranks share the work by messages; TestWritingRanks has what the writers do.
SHARING = ("vtkWindFieldSource", "vtkPlantScatterFilter", "vtkForestDensityFilter", "vtkPointPatternStatisticsFilter",
           "vtkPatternVerdictFilter")


def received(ranks):
    """Bytes that came of each rank so far."""
    count = ctypes.CDLL(None).BytesReceived
    count.restype = ctypes.c_uint64
    return [count(rank) for rank in range(ranks)]


def bytes_of(algorithm):
    """Of all outputs."""
    ports = range(algorithm.GetNumberOfOutputPorts())
    return sum(1024 * algorithm.GetOutputDataObject(port).GetActualMemorySize() for port in ports)


def sites(pv, quadrats=100):
    return pv.QuadratPoints(Size=[1000.0, 1000.0], Quadrats=[quadrats, quadrats], MeanPerQuadrat=10.0)


def forest(pv, quadrats=80):
    shrub = pv.ReevesTree(Preset="Shrub", NumberOfLeaves=20)
    return pv.PlantScatter(Sites=sites(pv, quadrats), Prototypes=shrub, OutputForm="Instances", UseCulling=0)


def leaves(pv, quadrats=80):
    return pv.ForestDensity(Input=forest(pv, quadrats), CellSize=[40.0, 40.0, 2.0])


def wind(pv):
    return pv.WindField(Dimensions=[8192, 12, 4])


def particles(pv):
    return pv.SuspendedParticles(Bounds=[-50.0, 50.0, -50.0, 50.0, -20.0, 0.0], Density=0.1)


def terrain(pv, points=400):
    return pv.TurningBandsTerrain(WholeExtent=[0, points, 0, points, 0, 0])


def kriging(pv):
    heights = pv.SitePreference(Sites=pv.QuadratPoints(Size=[1000.0, 1000.0], Quadrats=[10, 10], MeanPerQuadrat=1.0),
                                Terrain=pv.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0], Spacing=[10.0] * 3))
    return pv.ConditionalTerrain(Input=heights, Dimensions=[100, 100])


def pattern(pv, quadrats=20):
    return pv.QuadratPoints(Size=[1000.0, 1000.0], Quadrats=[quadrats, quadrats], MeanPerQuadrat=5.0)


CASES = {
    "terrain": terrain,
    "wind": wind,
    "sections of a wind": lambda pv: pv.ImageSections(Input=wind(pv), CrossSections=20),
    "points of quadrats": sites,
    "a plant": lambda pv: pv.ReevesTree(Preset="Shrub"),
    "scatter to instances": forest,
    "leaf area in cells": leaves,
    "sea surface": lambda pv: pv.SeaSurface(Input=pv.SeaState(NumberOfTrains=20), Sectors=200),
    "suspended particles": particles,
    "orbits": lambda pv: pv.ParticleOrbits(Input=particles(pv), SeaState=pv.SeaState(NumberOfTrains=10)),
    "fog": lambda pv: pv.ParticleFog(Input=particles(pv), Dimensions=[50, 50, 20]),
    "kriging": kriging,
    "drainage": lambda pv: pv.Drainage(Input=terrain(pv, 200), Carve=0),
    "K and g": lambda pv: pv.PointPatternStatistics(Input=pattern(pv), NumberOfSimulations=99),
    "verdict": lambda pv: pv.PatternVerdict(Input=pattern(pv, 6), NumberOfSimulations=19),
}
#: What all ranks write: the class, and what makes its input.
WRITERS = {
    "terrain.tif": ("vtkElevationWriter", terrain),
    "wind.bts": ("vtkWindFieldWriter", wind),
    "wind.vdb": ("vtkVDBVolumeWriter", wind),
    "leaves.bdf": ("vtkForestDensityWriter", lambda pv: leaves(pv, 10)),
    "forest.json": ("vtkForestTilesWriter", lambda pv: forest(pv, 30)),
}


def planes(rank, other, seen):
    """The own lines of the planes that the other makes, of every third block of them."""
    return seen[rank]["output"] / RANKS


def views(rank, other, seen):
    """Views of the prototype that the other draws."""
    return len(range(other, VIEWS, RANKS)) * BYTES_OF_VIEW


def curves(rank, other, seen):
    """On the first rank: of the other, a number for each step of each simulation, and nine for those of 256 points."""
    steps, simulated, points = (seen[0][key] for key in ("steps", "simulated", "points"))
    return 8 * (steps + 2) * (-(-simulated // RANKS) + 9 * -(-points // 256 // RANKS)) if rank == 0 else 0


def parts(rank, other, seen):
    """On the first rank, the part of the other, once."""
    return seen[other]["output"] if rank == 0 else 0


def parts_twice(rank, other, seen):
    """For the ranges, then to write."""
    return 2 * parts(rank, other, seen)


#: Bytes that a rank needs of another one, as their classes say.
NEEDS = {"wind": planes, "scatter to instances": views, "K and g": curves, "verdict": curves,
         **dict.fromkeys(WRITERS, parts), "wind.bts": parts_twice}


def exchanges(controller, rank):
    """Ways to send numbers, and how many of them a rank receives of each other one."""
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray

    def numbers(count):
        made = vtkDoubleArray()
        made.SetNumberOfValues(count)
        made.Fill(1.0)
        return made

    send = controller.Send if rank == 0 else controller.Receive
    yield lambda: rank > 1 or send(numbers(1000), 1 - rank, TAG), [1000 if rank == 1 else 0, 0, 0]
    yield lambda: controller.AllGather(numbers(500), numbers(500 * RANKS)), [500] * RANKS
    yield lambda: controller.Gather(numbers(70), numbers(70 * RANKS), 2), [70 if rank == 2 else 0] * RANKS
    yield lambda: controller.Broadcast(numbers(300), 1), [0, 300, 0]
    yield lambda: controller.Scatter(numbers(40 * RANKS), numbers(40), 0), [40, 0, 0]


def check_counts(controller, rank):
    """What is sent is counted."""
    for exchange, wanted in exchanges(controller, rank):
        before = received(RANKS)
        exchange()
        counted = [after - one for after, one in zip(received(RANKS), before)]
        for other in set(range(RANKS)) - {rank}:
            # VTK tells the type and the size of an array besides
            assert 8 * wanted[other] <= counted[other] <= 8 * wanted[other] + 200, f"{rank}: {counted}, {wanted}"
        assert counted[rank] == 0


def gathering(controller):
    """A source that brings all parts of its output to each rank."""
    from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from vtkmodules.vtkCommonDataModel import vtkTable

    class Gathering(VTKPythonAlgorithmBase):
        def __init__(self):
            super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkTable")

        def RequestInformation(self, request, inputs, outputs):
            outputs.GetInformationObject(0).Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
            return 1

        def RequestData(self, request, inputs, outputs):
            own, whole = vtkDoubleArray(), vtkDoubleArray()
            own.SetName("Own")
            for array, parts in (own, 1), (whole, RANKS):
                array.SetNumberOfValues(10000 * parts)
                array.Fill(1.0)
            controller.AllGather(own, whole)
            vtkTable.GetData(outputs).AddColumn(own)
            return 1

    return Gathering()


def update_input(algorithm, rank, port=0):
    """Makes the part of an input before what comes of it: the bytes of an algorithm are its own."""
    if port < algorithm.GetNumberOfInputPorts() and algorithm.GetNumberOfInputConnections(port):
        algorithm.GetInputAlgorithm(port, 0).UpdatePiece(rank, RANKS, 0)


def counted(controller, task):
    """Bytes that a task receives of each rank."""
    controller.Barrier()
    before = received(RANKS)
    task()
    return [after - one for after, one in zip(received(RANKS), before)]


def shared_cases(controller, rank):
    """Names, and what a rank receives of the others and puts out, or has to write [bytes]."""
    import littoral
    from vtk_proxies import VtkProxies

    pv = VtkProxies()
    for name, make in {**CASES, "gathered": lambda pv: gathering(controller)}.items():
        algorithm = make(pv)
        update_input(algorithm, rank)
        got = counted(controller, lambda: algorithm.UpdatePiece(rank, RANKS, 0))
        assert not algorithm.GetErrorCode(), name
        seen = {"received": got, "output": bytes_of(algorithm)}
        if NEEDS.get(name) is curves:
            laws = algorithm.GetOutput(0).GetNumberOfRows() if name == "verdict" else 1
            seen.update(steps=algorithm.GetOutput(1 if name == "verdict" else 0).GetNumberOfRows(),
                        simulated=laws * algorithm.GetNumberOfSimulations(),
                        points=algorithm.GetInputDataObject(0, 0).GetNumberOfPoints() if name == "K and g" else 0)
        yield name, seen
    for name, (kind, make) in WRITERS.items():
        if hasattr(littoral, kind):
            source = make(pv)
            source.UpdatePiece(rank, RANKS, 0)
            writer = getattr(littoral, kind)()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(name)
            for key, value in PLACE.items() if name == "forest.json" else ():
                getattr(writer, "Set" + key)(*value if isinstance(value, tuple) else (value,))
            answers = []
            got = counted(controller, lambda: answers.append(writer.Write()))
            assert answers == [1], name
            yield name, {"received": got, "output": 1024 * source.GetOutputDataObject(0).GetActualMemorySize()}


def other_cases(controller, rank):
    """The same of a small example of each class whose ranks share no work."""
    import recipes
    from vtkmodules.vtkCommonCore import vtkLogger

    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # small examples have columns that none uses
    for row in classes.ROWS:
        if not row.is_of_files and row.name not in SHARING:
            algorithm = recipes.source(row.name)
            for port in range(algorithm.GetNumberOfInputPorts()):
                update_input(algorithm, rank, port)
            got = counted(controller, lambda: algorithm.UpdatePiece(rank, RANKS, 0))
            yield row.name, {"received": got, "output": bytes_of(algorithm)}


def run(folder, kind):
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    rank = controller.GetLocalProcessId()
    os.chdir(folder)
    check_counts(controller, rank)
    cases = (other_cases if kind == "rest" else shared_cases)(controller, rank)
    Path(f"seen {rank}").write_text(json.dumps(dict(cases)))


def beyond(name, seen):
    """Ranks, those of which they receive more than they may, and how much."""
    return [(rank, other, one["received"][other]) for rank, one in enumerate(seen) for other in {0, 1, 2} - {rank}
            if one["received"][other] > AGREEMENT + MOST * seen[other]["output"] +
            NEEDS.get(name, lambda *_: 0)(rank, other, seen)]


def check(folder, kind):
    all_seen = [json.loads(Path(folder, f"seen {rank}").read_text()) for rank in range(RANKS)]
    for name in all_seen[0]:
        seen = [one[name] for one in all_seen]
        print(f"{name}: {[one['received'] for one in seen]} of {[one['output'] for one in seen]} bytes", flush=True)
        if kind == "rest":
            assert not any(sum(one["received"]) for one in seen), name
        else:
            assert bool(beyond(name, seen)) == (name == "gathered"), f"{name}: {beyond(name, seen)}"
    assert len(all_seen[0]) > (30 if kind == "rest" else len(CASES)), sorted(all_seen[0])


def main(kind):
    try:
        import mpi4py  # noqa: F401
        import vtkmodules.vtkParallelMPI  # noqa: F401
    except ImportError:
        print("there is no MPI in this VTK or Python")
        sys.exit(125)
    with tempfile.TemporaryDirectory() as folder:
        counting = benchmark.build_preloaded(folder, "mpi_received")
        if not counting or not shutil.which("mpirun"):
            print("there is no mpirun or no compiler for MPI")
            sys.exit(125)
        command = benchmark.on_ranks(RANKS, counting, sys.executable, os.path.abspath(__file__), folder, kind)
        subprocess.run(command, check=True, timeout=300, env={**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"})
        check(folder, kind)


if __name__ == "__main__":
    run(*sys.argv[1:]) if len(sys.argv) > 2 else main(*sys.argv[1:] or ["shared"])
