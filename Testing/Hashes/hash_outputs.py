# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Hashes of what each class puts out, with its defaults and with three other settings.

    python3 hash_outputs.py >before      (change what should change no byte)      python3 hash_outputs.py >after
    diff before after

A line holds class, setting, port, block, array, and the start of a SHA-256. Settings are named by their methods, so
that a method that is renamed is renamed here too. It takes about half a minute.
"""

import hashlib
import os
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkPartitionedDataSetCollection, vtkPolyData, vtkTable,
    vtkUnstructuredGrid)
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter

import littoral

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


CASES = {
    # class: (a call that makes its inputs, settings beside the defaults)
    "vtkTurningBandsTerrainSource": (lambda: (), [
        {"SetWholeExtent": (0, 60, 0, 60, 0, 0)},
        {"SetWholeExtent": (0, 60, 0, 60, 0, 0), "SetModel": (1,), "SetSeed": (3,), "SetReflectance": (True,)},
        {"SetWholeExtent": (5, 60, 0, 40, 0, 0), "SetAnisotropyRatio": (2.0,), "SetAnisotropyAngle": (30.0,)}]),
    "vtkQuadratPointSource": (lambda: (), [
        {"SetLaw": (1,), "SetSeed": (4,)}, {"SetLaw": (2,)}, {"SetMode": (1,), "SetMeanPerQuadrat": (3.0,)}]),
    "vtkPointProcessSource": (lambda: (), [
        {"SetProcess": (3,)}, {"SetProcess": (4,), "SetSeed": (2,)},
        {"SetProcess": (5,), "SetSize": (100.0, 80.0), "SetNumberOfSpecies": (2,), "SetMarks": (True,)},
        {"SetProcess": (6,), "SetSize": (100.0, 80.0), "SetIntensity": (0.03,)}]),
    "vtkReevesTreeSource": (lambda: (), [
        {"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (3,)}, {"SetPreset": (0,), "SetOrders": (2,)}]),
    "vtkAonoKuniiTreeSource": (lambda: (), [
        {"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (9,)}, {"SetPreset": (0,), "SetIterations": (4,)}]),
    "vtkGardnerPlantSource": (lambda: (), [
        {"SetPreset": (2,)}, {"SetSeed": (5,)}, {"SetPreset": (0,), "SetTerms": (6,), "SetShells": (2,)}]),
    "vtkSeaweedSource": (lambda: (), [
        {"SetPreset": (3,)}, {"SetPreset": (2,), "SetSeed": (3,)}, {"SetSegmentsPerBranch": (4,)}]),
    "vtkSeaStateSource": (lambda: (), [
        {"SetSpectrum": (1,)}, {"SetSeed": (2,), "SetWaterDepth": (5.0,)}, {"SetSeaBy": (1,)}]),
    "vtkSuspendedParticleSource": (lambda: (), [
        {"SetPreset": (3,)}, {"SetSeed": (2,), "SetMode": (1,)}, {"SetDensity": (0.5,), "SetSizeSpread": (0.4,)}]),
    "vtkFlowPrimitiveSource": (lambda: (), [
        {"SetFlowType": (1,)}, {"SetFlowType": (2,)}, {"SetStrength": (3.0,)}]),
    "vtkWindFieldSource": (lambda: (), [
        {"SetDimensions": (32, 4, 4), "SetSpectrum": (1,)}, {"SetDimensions": (32, 4, 4), "SetSeed": (2,)},
        {"SetDimensions": (32, 4, 4), "SetCoherence": (1,), "SetNormalizeVariance": (True,)}]),
    "vtkCovarianceFitFilter": (lambda: (terrain(),), [
        {"SetNumberOfLags": (12,)}, {"SetRemoveTrend": (False,)}, {"SetFitAnisotropy": (False,)}]),
    "vtkDrainageFilter": (lambda: (terrain(60), terrain(50)), [
        {"SetMinimumDrainageCells": (8,)}, {"SetCarve": (False,), "SetMinimumDrainageCells": (12,)},
        {"SetOutlets": (1,), "SetSeaLevel": (180.0,), "SetNumberOfRounds": (2,)}]),
    "vtkGroundStatisticsFilter": (lambda: (terrain(60),), [
        {"SetMinimumDrainageCells": (8,)}, {"SetMinimumDrainageCells": (30,)},
        {"SetUseSeaLevel": (True,), "SetSeaLevel": (180.0,)}]),
    "vtkConditionalTerrainFilter": (lambda: (survey(),), [
        {"SetDimensions": (30, 20), "SetKrigingVariance": (True,), "SetCrossValidation": (True,)},
        {"SetDimensions": (30, 20), "SetModel": (1,), "SetKrigingType": (2,), "SetNumberOfNeighbors": (12,)},
        {"SetDimensions": (30, 20), "SetModel": (0,), "SetResult": (1,), "SetNormalScores": (True,)}]),
    "vtkNormalScoresFilter": (lambda: (terrain(), terrain(30)), [
        {"SetInverse": (True,)}]),
    "vtkWindStatisticsFilter": (lambda: (wind(),), [
        {"SetHeight": (3.0,)}, {"SetSeparation": (0.0, 2.0)}, {"SetNumberOfBands": (6,)}]),
    "vtkSeaStatisticsFilter": (lambda: (sea(),), [
        {"SetNumberOfSectors": (4,)}, {"SetNumberOfSectors": (36,)}, {"SetNumberOfSectors": (90,)}]),
    "vtkQuadratAnalysisFilter": (lambda: (make("vtkQuadratPointSource"),), [
        {"SetQuadrats": (5, 5)}, {"SetQuadrats": (8, 6)}, {"SetOrigin": (-5.0, -5.0), "SetSize": (300.0, 300.0)}]),
    "vtkPointPatternStatisticsFilter": (lambda: (make("vtkQuadratPointSource"),), [
        {"SetFunction": (2,), "SetEdgeCorrection": (3,)}, {"SetFunction": (5,), "SetNumberOfSimulations": (19,)},
        {"SetFunction": (0,), "SetEdgeCorrection": (1,), "SetSeed": (2,)}]),
    "vtkPatternVerdictFilter": (lambda: (make("vtkPointProcessSource", SetSize=(80.0, 60.0), SetIntensity=(0.02,)),), [
        {"SetNumberOfSimulations": (19,)}, {"SetNumberOfSimulations": (19,), "SetFunction": (1,)},
        {"SetNumberOfSimulations": (19,), "SetContrast": (1,), "SetSeed": (2,)}]),
    "vtkTerrainLevelOfDetailFilter": (lambda: (terrain(128),), [
        {"SetGroundColors": (False,)}, {"SetUseCulling": (False,)}, {"SetViewPoint": (0.0, 0.0, 90.0)}]),
    "vtkPlantScatterFilter": (lambda: (make("vtkQuadratPointSource"), tree()), [
        {"SetSeed": (2,)}, {"SetUseLevels": (False,), "SetUseCulling": (False,)}, {"SetViewPoint": (50.0, 50.0, 9.0)}]),
    "vtkStandInventoryFilter": (lambda: (inventory(),), [
        {"SetSeed": (2,)}, {"SetHeightVariation": (0.3,)}, {"SetPlot": ("B",), "SetMeanDiameter": (0.4,)}]),
    "vtkSitePreferenceFilter": (lambda: (make("vtkQuadratPointSource", SetSize=(40.0, 40.0)), terrain()), [
        {"SetSeed": (2,)}, {"SetThins": (True,)}, {"SetThins": (True,), "SetSeed": (3,)}]),
    "vtkBeamTreeDeformationFilter": (lambda: (tree(), wind()), [
        {"SetResponse": (1,)}, {"SetGravity": (True,)}, {"SetNumberOfModes": (1,), "SetWoodFromPlants": (False,)}]),
    "vtkParticleOrbitFilter": (lambda: (particles(), sea()), [
        {"SetStokesDrift": (True,)}, {"SetDopplerShift": (True,), "SetCurrent": (0.5, 0.1)}, {"SetGenerateAcceleration": (True,)}]),
    "vtkSeaSurfaceFilter": (lambda: (sea(),), [
        {"SetSpacing": (1.0,), "SetSectors": (90,)}, {"SetCenter": (70.0, -20.0), "SetRadius": (300.0,)},
        {"SetChoppiness": (0.5,), "SetWaterColors": (False,)}]),
    "vtkFlowArrowFilter": (lambda: (make("vtkFlowPrimitiveSource", SetFlowType=(3,)),), []),
    "vtkImageSectionFilter": (lambda: (wind(),), [{"SetCrossSections": (1,)}]),
    "vtkParticleLevelOfDetailFilter": (lambda: (particles(), sea()), [
        {"SetViewPoint": (5.0, 5.0, -3.0)},
        {"SetViewPoint": (5.0, 5.0, -3.0), "SetSlavesPerMaster": (2,)},
        {"SetViewPoint": (1.0, 1.0, -1.0), "SetUseLevels": (False,)}]),
    "vtkParticleFogFilter": (lambda: (particles(),), [
        {"SetGridBy": (0,), "SetDimensions": (8, 9, 10)}, {"SetGridBy": (1,), "SetUseBounds": (True,), "SetSpacing": (0.7,)}, {"SetWaterExtinction": (0.4,)}]),
    "vtkCurrentDriftFilter": (lambda: (particles(), current()), [
        {"SetStartTime": (0.5,)}, {"SetStartTime": (-2.0,), "SetTimeStep": (0.25,)}, {"SetGenerateCurrent": (True,)}]),
    "vtkSeaweedDeformationFilter": (lambda: (seaweed(), sea(4.0)), [
        {"SetMethod": (0,)}, {"SetIntegrator": (1,), "SetTimeStep": (0.0025,)}, {"SetGenerateMotion": (True,)}]),
    "vtkPlantWakeFilter": (
        lambda: (make("vtkSeaweedDeformationFilter", (seaweed(), sea(4.0)), SetGenerateMotion=(True,)),), [
            {"SetPrimitive": (1,)}, {"SetStrength": (2.0,)}, {"SetMargin": (1.0,)}]),
}


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


def main(wanted):
    """All classes, or those that are named."""
    for name, (inputs, variants) in CASES.items():
        if wanted and name not in wanted:
            continue
        default = print_outputs(make(name, inputs()), f"{name} default")
        for number, settings in enumerate(variants, 1):
            if print_outputs(make(name, inputs(), **settings), f"{name} {number}") == default:
                sys.exit(f"{name}: setting {number} changes nothing")
    if not wanted:
        print_volume()
        print_scene()
        print_raster()


if __name__ == "__main__":
    main(sys.argv[1:])
