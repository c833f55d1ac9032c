# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of scene files and times to write them: 100 000 standing trees, and 1000 that sway; or a million as 3D Tiles.

    ./littoral run /usr/bin/python3 Testing/Benchmarks/bench_scene_files.py [tiles | NEAR [TOLERANCE...]]

NEAR: distance up to which trees sway in full [m], default 30, that of the filter; tolerances of the skins [m], default
0.001. It fails where a file is larger than wanted, or where the skins of a sample of trees of both moving levels, as an
independent reader plays them, are further than the tolerance from VTK's.
"""

import os
import resource
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
from glb import Glb  # noqa: E402
from littoral import (  # noqa: E402
    vtkBeamTreeDeformationFilter, vtkForestTilesWriter, vtkPlantScatterFilter, vtkReevesTreeSource, vtkWindFieldSource)
from littoral.glb import write_glb  # noqa: E402

#: The largest files that are wanted [bytes], times at which skins are compared [s], and trees of a level.
STANDING, SWAYING, COMPARED, SAMPLE = 50e6, 100e6, (0.5, 2.5, 4.25), 12
#: The largest tileset of a million trees [bytes], and the longest time to write it [s].
TILES, WRITTEN = 60e6, 30.0
#: Parts of a plant in the order of its mesh.
PARTS = {"High": ("Skin", "Leaves"), "Medium": ("Trunk", "Crown")}


def species():
    trees = [vtkReevesTreeSource() for _ in range(4)]
    for preset, tree in enumerate(trees, 1):
        tree.SetPreset(preset)
    return trees


def forest(count, side, trees):
    """Trees at random on level ground, a square with its middle at the origin [m]."""
    at = np.random.default_rng(5).uniform(-0.5 * side, 0.5 * side, (count, 2))
    points, sites, scattered = vtkPoints(), vtkPolyData(), vtkPlantScatterFilter()
    points.SetData(numpy_to_vtk(np.column_stack((at, np.zeros(count))), deep=True))
    sites.SetPoints(points)
    scattered.SetInputData(0, sites)
    for tree in trees:
        scattered.AddPrototypeConnection(tree.GetOutputPort())
    scattered.UseCullingOff()
    scattered.FaceCameraOff()
    return scattered


def block(blocks, name):
    """The block of a name."""
    return next(blocks.GetBlock(k) for k in range(blocks.GetNumberOfBlocks())
                if blocks.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) == name)


def largest_errors(file, source):
    """By how much skins of a file are off at most [m], and by how much they move [m], by levels."""
    g, found = Glb(file), {}
    for level, parts in PARTS.items():
        nodes = [k for k, node in enumerate(g.nodes) if "skin" in node and node["name"].split()[-2] == level]
        errors, moved = [], []
        for time in COMPARED:
            source.UpdateTimeStep(time)
            for node in nodes[::max(1, len(nodes) // SAMPLE)]:
                for index, part in enumerate(parts):
                    data = block(block(source.GetOutput(), level), part)
                    own = vtk_to_numpy(data.GetPointData().GetArray("PlantId")) == int(g.nodes[node]["name"].split()[-1])
                    at = g.skinned(node, time, index)
                    errors.append(np.linalg.norm(at - vtk_to_numpy(data.GetPoints().GetData())[own], axis=1).max())
                    moved.append(np.linalg.norm(at - g.skinned(node, 0.0, index), axis=1).max())
        found[level] = max(errors), max(moved), len(errors)
    return found


def report(what, source, most, **settings):
    source.Update()
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "forest.glb")
        begin = time.perf_counter()
        write_glb(name, {"Forest": source}, **settings)
        seconds, size = time.perf_counter() - begin, os.path.getsize(name)
        skins = largest_errors(name, source) if "times" in settings else {}
    fields = source.GetOutput().GetFieldData()
    levels = [name for name in ("PlantsHigh", "PlantsMedium", "PlantsLow") if fields.HasArray(name)]
    what += "".join(f", {int(fields.GetArray(name).GetTuple1(0))} {name[6:]}" for name in levels)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"{what}: {size / 1e6:.1f} MB, {seconds:.1f} s, {memory:.2f} GB, load {os.getloadavg()[0]:.1f}", flush=True)
    assert size <= most, f"the file is larger than {most / 1e6:.0f} MB"
    for level, (error, moved, count) in skins.items():
        print(f"  {level}: {count} skins move by up to {moved:.2f} m and are off by at most {1e3 * error:.2f} mm", flush=True)
        assert error <= settings["JointTolerance"] < 0.1 * moved, "skins are off"


def tiles():
    """A million trees on their place on earth, 10 km x 10 km."""
    scattered = forest(1000000, 10000.0, species())
    scattered.SetOutputFormToInstances()
    writer = vtkForestTilesWriter()
    writer.SetInputConnection(scattered.GetOutputPort())
    writer.SetCoordinateSystem("EPSG:32632")
    writer.SetCoordinateOffset(520000.0, 5400000.0)
    scattered.Update()
    with tempfile.TemporaryDirectory() as folder:
        writer.SetFileName(os.path.join(folder, "forest.json"))
        begin, work = time.perf_counter(), time.process_time()
        assert writer.Write() == 1
        seconds, work = time.perf_counter() - begin, time.process_time() - work
        sizes = [os.path.getsize(os.path.join(place, name)) for place, _, names in os.walk(folder) for name in names]
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"1 000 000 trees as 3D Tiles: {len(sizes)} files, {sum(sizes) / 1e6:.1f} MB, {seconds:.1f} s, {work:.1f} s of "
          f"processor time, {memory:.2f} GB, load {os.getloadavg()[0]:.1f}", flush=True)
    assert sum(sizes) <= TILES, f"the tileset is larger than {TILES / 1e6:.0f} MB"
    assert seconds <= WRITTEN, f"it took longer than {WRITTEN:.0f} s"


def main(near=30.0, *tolerances):
    trees = species()
    standing = forest(100000, 3000.0, trees)
    standing.SetOutputFormToInstances()
    report("100 000 trees with all levels", standing, STANDING)
    scattered, wind, swaying = forest(1000, 300.0, trees), vtkWindFieldSource(), vtkBeamTreeDeformationFilter()
    scattered.SetViewPoint(0.0, 0.0, 2.0)
    scattered.SetNearDistance(near)
    scattered.SetFarDistance(near + 110.0)
    wind.SetDimensions(256, 82, 16)
    wind.SetLateralSpacing(4.0)
    wind.SetVerticalSpacing(2.5)
    swaying.SetInputConnection(0, scattered.GetOutputPort())
    swaying.SetInputConnection(1, wind.GetOutputPort())
    for tree in trees:
        swaying.AddPrototypeConnection(tree.GetOutputPort())
    swaying.GenerateJointsOn()
    swaying.SetLeafFlutter(0.0)  # files hold none
    for tolerance in tolerances or (0.001,):
        report(f"1000 swaying trees, {tolerance} m", swaying, SWAYING, times=(0.0, 5.0, 24.0), JointTolerance=tolerance)


if __name__ == "__main__":
    if sys.argv[1:] == ["tiles"]:
        tiles()
    else:
        main(*(float(word) for word in sys.argv[1:]))
