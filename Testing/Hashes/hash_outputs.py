# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Hashes of what each class puts out, with its defaults and with the variants of its row in Testing/classes.py.

    python3 hash_outputs.py >before      (change what should change no byte)      python3 hash_outputs.py >after
    diff before after

A line holds class, setting, port, block, array, and the start of a SHA-256. Settings are named by their methods, so
that a method that is renamed is renamed here too. It takes about half a minute.
"""

import hashlib
import os
import sys
import tempfile
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkPartitionedDataSetCollection, vtkPolyData, vtkTable,
    vtkUnstructuredGrid)
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter

import littoral

TESTING = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTING), str(TESTING / "Fuzz")]
import classes  # noqa: E402
import recipes  # noqa: E402

TIMES = 0.0, 1.5


def make(name, inputs=(), **settings):
    """An object of a class with inputs, by ports, and settings."""
    made = getattr(littoral, name)()
    for port, source in enumerate(inputs):
        if source is not None:
            made.SetInputConnection(port, source.GetOutputPort())
    for method, values in settings.items():
        getattr(made, method)(*values)
    return made


def terrain(size=40, **settings):
    return make("vtkTurningBandsTerrainSource", SetWholeExtent=(0, size, 0, size, 0, 0),
                SetAnisotropyRatio=(3.0,), **settings)


def survey():
    """Points with elevations of a rough terrain: those of a smooth one tell too much of each other."""
    ground = terrain(12, SetModel=(1,))
    points = vtkImageDataGeometryFilter()
    points.SetInputConnection(ground.GetOutputPort())
    return points


def tree(name="vtkReevesTreeSource"):
    return make(name, SetNumberOfLeaves=(300,))


def wind():
    return make("vtkWindFieldSource", SetDimensions=(64, 4, 4))


def sea(level=0.0):
    return make("vtkSeaStateSource", SetNumberOfTrains=(12,), SetSeaLevel=(level,))


def particles():
    return make("vtkSuspendedParticleSource", SetDensity=(0.2,))


def seaweed(**settings):
    return make("vtkSeaweedSource", SetSegmentsPerBranch=(4,), **settings)


def inventory():
    """A table of an inventory of two plots, most of it not measured."""
    lines = ["plot,x,y,species,dbh,height"]
    for k in range(30):
        lines.append(f"{'AB'[k % 2]},{7 * (k % 5)},{6 * (k // 5)},{('oak', 'Pinus taeda', '')[k % 3]},,{'' if k % 7 else 11}")
    reader = vtkDelimitedTextReader()
    reader.SetReadFromInputString(True)
    reader.SetInputString("\n".join(lines) + "\n")
    reader.SetHaveHeaders(True)
    return reader


def current():
    return make("vtkFlowPrimitiveSource")


CASES = [row for row in classes.ROWS if not row.is_of_files]


def inputs_of(row):
    """Inputs of a class, by port."""
    if row.inputs:
        return row.inputs(sys.modules[__name__])
    return [recipes.source(name) for name in row.fed_by]


def digest(array):
    """The start of the hash of an array's bytes; texts count too."""
    if isinstance(array, vtkDataArray):
        return hashlib.sha256(vtk_to_numpy(array).tobytes()).hexdigest()[:16]
    values = [str(array.GetVariantValue(i)) for i in range(array.GetNumberOfValues())]
    return hashlib.sha256("\0".join(values).encode()).hexdigest()[:16]


def arrays(leaf):
    """Names and arrays of a data set or a table without blocks."""
    if isinstance(leaf, (vtkPolyData, vtkUnstructuredGrid)) and leaf.GetPoints():
        yield "points", leaf.GetPoints().GetData()
    if isinstance(leaf, vtkPolyData):
        for kind in ("Verts", "Lines", "Polys", "Strips"):
            cells = getattr(leaf, "Get" + kind)()
            if cells.GetNumberOfCells() > 0:
                yield kind.lower(), cells.GetConnectivityArray()
                yield kind.lower() + " offsets", cells.GetOffsetsArray()
    attributes = [("field", leaf.GetFieldData())]
    if isinstance(leaf, vtkDataSet):
        attributes += [("point", leaf.GetPointData()), ("cell", leaf.GetCellData())]
    elif isinstance(leaf, vtkTable):
        attributes.append(("row", leaf.GetRowData()))
    for kind, data in attributes:
        for index in range(data.GetNumberOfArrays()):
            yield f"{kind} {data.GetAbstractArray(index).GetName()}", data.GetAbstractArray(index)


def leaves(data, path=""):
    """Paths and data sets below a data object."""
    if not isinstance(data, vtkCompositeDataSet):
        yield path or "/", data
        return
    if isinstance(data, vtkPartitionedDataSetCollection):
        for index in range(data.GetNumberOfPartitionedDataSets()):
            for part in range(data.GetNumberOfPartitions(index)):
                if data.GetPartitionAsDataObject(index, part):
                    yield f"{path}/{index}.{part}", data.GetPartitionAsDataObject(index, part)
        return
    for index in range(data.GetNumberOfBlocks()):
        block = data.GetBlock(index)
        name = str(index)
        if data.HasMetaData(index) and data.GetMetaData(index).Get(vtkCompositeDataSet.NAME()):
            name = data.GetMetaData(index).Get(vtkCompositeDataSet.NAME())
        if block:
            yield from leaves(block, f"{path}/{name}")


def outputs_of(algorithm):
    """All arrays of all ports at all times, a line each."""
    lines = []
    algorithm.UpdateInformation()
    timed = algorithm.GetOutputInformation(0).Has(vtkStreamingDemandDrivenPipeline.TIME_RANGE())
    for time in TIMES if timed else (None,):
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
        for port in range(algorithm.GetNumberOfOutputPorts()):
            for path, leaf in leaves(algorithm.GetOutputDataObject(port)):
                if isinstance(leaf, vtkImageData):
                    lines.append(f"{path} grid {leaf.GetExtent()} {leaf.GetOrigin()} {leaf.GetSpacing()}")
                for name, array in sorted(arrays(leaf), key=lambda pair: pair[0]):
                    lines.append(f"{time} {port} {path} {name} {digest(array)}")
    return lines


def print_outputs(algorithm, label):
    """All arrays of all ports at all times, one a line; returns them."""
    lines = outputs_of(algorithm)
    for line in lines:
        print(label, line)
    return lines


def print_volume():
    """Sizes of volumes that the writer writes: each file holds an identifier of its own."""
    for half in (False, True):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "wind.vdb")
            writer = make("vtkVDBVolumeWriter", (wind(),), SetFileName=(name,), SetHalfFloat=(half,))
            writer.Write()
            print("vtkVDBVolumeWriter", half, os.path.getsize(name))


def print_scene():
    """Hashes of scenes that the writer writes."""
    for form in (0, 1):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "scene.glb")
            sites, prototype = make("vtkQuadratPointSource"), tree()
            forest = make("vtkPlantScatterFilter", (sites, prototype), SetOutputForm=(1,), SetUseCulling=(False,))
            writer = make("vtkGLTFSceneWriter", (forest,), SetFileName=(name,), SetInstanceForm=(form,))
            writer.Write()
            with open(name, "rb") as file:
                print("vtkGLTFSceneWriter", form, hashlib.sha256(file.read()).hexdigest()[:16])


def print_tiles():
    """A hash of a forest as 3D Tiles: the name of the folder tells its content."""
    with tempfile.TemporaryDirectory() as folder:
        sites, prototype = make("vtkQuadratPointSource"), tree()
        forest = make("vtkPlantScatterFilter", (sites, prototype), SetOutputForm=(1,), SetUseCulling=(False,))
        name = os.path.join(folder, "forest.json")
        make("vtkForestTilesWriter", (forest,), SetFileName=(name,), SetCoordinateSystem=("EPSG:32632",),
             SetCoordinateOffset=(500000.0, 5400000.0), SetTreesPerTile=(10,)).Write()
        with open(name, "rb") as file:
            print("vtkForestTilesWriter", hashlib.sha256(file.read()).hexdigest()[:16])


def print_raster():
    """Hashes of a raster that the writer writes, and of what the reader reads of it."""
    for compression in (0, 1):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "terrain.tif")
            writer = make("vtkElevationWriter", (terrain(),), SetFileName=(name,), SetCompression=(compression,))
            writer.Write()
            with open(name, "rb") as file:
                print("vtkElevationWriter", compression, hashlib.sha256(file.read()).hexdigest()[:16])
            print_outputs(make("vtkElevationReader", SetFileName=(name,)), f"vtkElevationReader {compression}")


def print_wind():
    """Hashes of a wind that the writer writes, and of what the reader reads of it."""
    with tempfile.TemporaryDirectory() as folder:
        netcdf = ["nc"] if hasattr(littoral, "vtkOceanCurrentReader") else []
        for extension in ("bts", "hawc", "wnd", *netcdf):
            name = os.path.join(folder, "wind." + extension)
            make("vtkWindFieldWriter", (wind(),), SetFileName=(name,)).Write()
            print_outputs(make("vtkWindFieldReader", SetFileName=(name,)), f"vtkWindFieldReader {extension}")
        for name in sorted(os.listdir(folder)):
            with open(os.path.join(folder, name), "rb") as file:
                print("vtkWindFieldWriter", name, hashlib.sha256(file.read()).hexdigest()[:16])


def print_forest():
    """Hashes of a forest in files."""
    density = make("vtkForestDensityFilter", (tree(),), SetBounds=(-8.0, 8.0, -8.0, 8.0, 0.0, 16.0))
    with tempfile.TemporaryDirectory() as folder:
        palm = [("nc", 0)] if hasattr(littoral, "vtkOceanCurrentReader") else []
        for extension, port in (("bdf", 0), ("dat", 0), *palm, ("amrwind", 3)):
            name = os.path.join(folder, "forest." + extension)
            writer = make("vtkForestDensityWriter", SetFileName=(name,))
            writer.SetInputConnection(density.GetOutputPort(port))
            writer.Write()
            with open(name, "rb") as file:
                print("vtkForestDensityWriter", extension, hashlib.sha256(file.read()).hexdigest()[:16])


def print_currents():
    """Hashes of what the reader reads of a file of an ocean model."""
    print_outputs(make("vtkOceanCurrentReader", **classes.BY_NAME["vtkOceanCurrentReader"].small), "vtkOceanCurrentReader")


def print_table():
    """Hashes of a table that the reader reads."""
    for reader in ("vtkTextTableReader", "vtkWaveSpectrumReader"):
        print_outputs(make(reader, **classes.BY_NAME[reader].small), reader)


def main(wanted):
    """All classes, or those that are named."""
    for row in CASES:
        if wanted and row.name not in wanted:
            continue
        inputs = inputs_of(row)
        default = print_outputs(make(row.name, inputs), f"{row.name} default")
        for number, settings in enumerate(row.variants, 1):
            if print_outputs(make(row.name, inputs, **settings), f"{row.name} {number}") == default:
                sys.exit(f"{row.name}: setting {number} changes nothing")
    if not wanted:
        print_volume()
        print_scene()
        print_tiles()
        print_wind()
        print_forest()
        print_currents()
        print_raster()
        print_table()


if __name__ == "__main__":
    main(sys.argv[1:])
