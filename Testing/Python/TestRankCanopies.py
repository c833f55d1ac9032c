# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks share the plants whose leaves they count in cells: the bytes of one rank, a part of the plants each; what one
cannot do ends on all of them with one message.

The file starts itself on three ranks; each writes what it has seen."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile

import littoral
from TestRankTeam import RANKS, Messages, ground, sites
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

SIZE = 9  # quadrats along a side


def canopies(prototypes):
    """Names and grids of leaf area of which each rank is asked for its piece."""

    def canopy(scatter, bounds=(-10, 235, -10, 190, 0, 4), **settings):
        grid = littoral.vtkForestDensityFilter()
        grid.SetInputConnection(0, scatter.GetOutputPort())
        grid.SetBounds(bounds)
        grid.SetCellSize(30.0, 41.0, 0.8)
        grid.SetDetailToParcels()
        for name, value in settings.items():
            getattr(grid, "Set" + name)(value)
        return grid

    def forest(places, form=1, terrain=None, **settings):
        scatter = littoral.vtkPlantScatterFilter()
        scatter.SetInputConnection(0, places.GetOutputPort())
        for plant in prototypes:
            scatter.AddPrototypeConnection(plant.GetOutputPort())
        scatter.SetOutputForm(form)
        scatter.UseCullingOff()
        if terrain:
            scatter.SetTerrainConnection(terrain.GetOutputPort())
        for name, value in settings.items():
            getattr(scatter, "Set" + name)(*value)
        return scatter

    yield "parcels", canopy(forest(sites(SIZE)), BySpecies=True, SpeciesNames="Alder; Pine")
    yield "leaves", canopy(forest(sites(2)), (-10, 60, -10, 50, 0, 4), Detail=1)
    yield "heights", canopy(forest(sites(SIZE), terrain=ground(60)), HeightsAboveGround=True)
    yield "one quadrat", canopy(forest(sites(1)), (-10, 40, -10, 40, 0, 4), Detail=0)
    yield "one cell", canopy(forest(sites(SIZE)), (0, 20, 0, 20, 0, 0.8))
    view = dict(UseCulling=(True,), ViewPoint=(90.0, 90.0, 2.0), ViewDirection=(1.0, 0.4, 0.0))
    yield "culled", canopy(forest(sites(SIZE), **view))
    yield "merged", canopy(forest(sites(1), form=0, UseLevels=(False,)), (-10, 40, -10, 40, 0, 4))


def of_grid(grid):
    """Digests of the image and of the tables, and the rows of the trees by their numbers."""
    image, trees = grid.GetOutput(), grid.GetOutputDataObject(3)
    cells = hashlib.sha256(repr(image.GetExtent()).encode())
    for arrays in image.GetCellData(), image.GetFieldData():
        for array in filter(None, map(arrays.GetArray, range(arrays.GetNumberOfArrays()))):
            cells.update(array.GetName().encode() + vtk_to_numpy(array).tobytes())
    tables = hashlib.sha256()
    for port in 1, 2:
        table = grid.GetOutputDataObject(port)
        for n in range(table.GetNumberOfColumns()):
            tables.update(vtk_to_numpy(table.GetColumn(n)).tobytes())
    for fields in (data.GetFieldData() for data in map(grid.GetOutputDataObject, range(4))):
        tables.update(repr([fields.GetArrayName(n) for n in range(fields.GetNumberOfArrays())]).encode())
    arrays = trees.GetPointData()
    columns = [vtk_to_numpy(arrays.GetArray(n)).tolist() for n in range(arrays.GetNumberOfArrays())]
    columns.insert(0, vtk_to_numpy(trees.GetPoints().GetData()).tolist() if trees.GetNumberOfPoints() else [])
    numbers = vtk_to_numpy(arrays.GetArray("PlantId")).tolist() if columns[0] else []
    rows = {number: hashlib.sha256(repr(row).encode()).hexdigest()[:12] for number, row in zip(numbers, zip(*columns))}
    return [cells.hexdigest()[:12], tables.hexdigest()[:12], image.GetNumberOfCells(), rows]


def run(folder, rank, ranks, controllers):
    """Writes what a rank has of its piece of each grid, alone and with others, and of the whole that one asks for."""
    prototypes = [littoral.vtkReevesTreeSource(), littoral.vtkReevesTreeSource()]
    for seed, plant in enumerate(prototypes):
        plant.SetPresetToShrub()
        plant.SetSeed(1 + seed)
        plant.SetNumberOfLeaves(60)
    lines = []
    for (name, shared), (_, alone) in zip(canopies(prototypes), canopies(prototypes)):
        said = [Messages(shared), Messages(alone)]
        found = []
        for grid, controller in (shared, controllers[0]), (alone, controllers[1]):
            type(controllers[0]).SetGlobalController(controller)
            grid.UpdatePiece(rank, ranks, 0)
            found.append(of_grid(grid))
        type(controllers[0]).SetGlobalController(controllers[0])
        plants = shared.GetInputDataObject(0, 0).GetBlock(0)
        read = plants.GetNumberOfPoints() if plants and plants.IsA("vtkPolyData") else 0
        later = []
        if rank == ranks - 1 and not said[0].texts and found[0][2]:
            for grid in shared, alone:
                grid.UpdatePiece(0, 1, 0)
                later.append(of_grid(grid)[:3])
                asked = grid.GetOutputInformation(3)
                asked.Set(Pipeline.UPDATE_PIECE_NUMBER(), 0)
                asked.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
                grid.Update(3)
                later[-1].append(len(of_grid(grid)[3]))
        shared.UpdatePiece(rank, ranks, 0)
        lines.append([name, found, read, later, of_grid(shared)[0], [" ".join(messages.texts) for messages in said]])
    with open(os.path.join(folder, str(rank)), "w") as file:
        json.dump(lines, file)


def check(folder, ranks):
    """Each rank has the bytes of its piece and has read its own plants; trees are there once; the first says what is
    wrong."""
    trees, wanted, reads = {}, {}, {}
    for rank in range(ranks):
        with open(os.path.join(folder, str(rank))) as file:
            for name, (shared, alone), read, later, again, (said, said_alone) in json.load(file):
                print(f"{name}, rank {rank}: {shared[:3]} of {read} plants, later {later}; {said}")
                assert shared[:3] == alone[:3], f"{name}: {shared[:3]}, {alone[:3]} alone"
                assert again == shared[0], f"{name}: {again} later"
                assert later[:1] == later[1:], f"{name}: {later}"
                assert said == (said_alone if rank == 0 else ""), f"{name}: {said}; alone {said_alone}"
                assert not set(trees.setdefault(name, {})) & set(shared[3]), f"{name}: trees are there twice"
                trees[name].update(shared[3])
                wanted.setdefault(name, alone[3])
                reads.setdefault(name, []).append(read)
                assert ("in view" in said) == (name == "culled" and rank == 0), said
    assert trees == wanted, {name: (len(rows), len(wanted[name])) for name, rows in trees.items()}
    every = 3 * SIZE * SIZE
    for name in "parcels", "heights":
        assert len(trees[name]) == sum(reads[name]) == every, f"{name}: {len(trees[name])} of {reads[name]}"
        assert max(reads[name]) < 0.4 * every, f"{name}: {reads[name]}"
    assert [len(trees[name]) for name in ("leaves", "one quadrat", "merged")] == [12, 3, 3]


def of_rank():
    """Number of this rank, that of all, and the global controller with others and alone."""
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    return controller.GetLocalProcessId(), controller.GetNumberOfProcesses(), (controller, None)


def start(script, check):
    """Runs a script on all ranks with a folder, and checks what they leave there."""
    try:
        import mpi4py  # noqa: F401
        import vtkmodules.vtkParallelMPI  # noqa: F401
    except ImportError:
        print("there is no MPI in this VTK or Python")
        sys.exit(125)
    if not shutil.which("mpirun"):
        print("there is no mpirun")
        sys.exit(125)
    with tempfile.TemporaryDirectory() as folder:
        command = ["mpirun", "-np", str(RANKS), sys.executable, os.path.abspath(script), folder]
        subprocess.run(command, check=True, timeout=300, capture_output=True)
        check(folder, RANKS)


if __name__ == "__main__":
    run(sys.argv[1], *of_rank()) if len(sys.argv) > 1 else start(__file__, check)
