# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of scene files and times to write them: 100 000 standing trees, and 1000 that sway.

    ./littoral run /usr/bin/python3 Testing/Benchmarks/bench_scene_files.py [NEAR [TOLERANCE...]]

NEAR: distance up to which trees sway in full [m], default 10; tolerances of the skins [m], default 0.001.
"""

import os
import resource
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from littoral import vtkBeamTreeDeformationFilter, vtkPlantScatterFilter, vtkReevesTreeSource, vtkWindFieldSource
from littoral.scene import write_glb


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


def report(what, source, **settings):
    source.Update()
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "forest.glb")
        begin = time.perf_counter()
        write_glb(name, {"Forest": source}, **settings)
        seconds, size = time.perf_counter() - begin, os.path.getsize(name)
    fields = source.GetOutput().GetFieldData()
    levels = [name for name in ("PlantsHigh", "PlantsMedium", "PlantsLow") if fields.HasArray(name)]
    what += "".join(f", {int(fields.GetArray(name).GetTuple1(0))} {name[6:]}" for name in levels)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"{what}: {size / 1e6:.1f} MB, {seconds:.1f} s, {memory:.2f} GB, load {os.getloadavg()[0]:.1f}")


def main(near=10.0, *tolerances):
    trees = species()
    standing = forest(100000, 3000.0, trees)
    standing.SetOutputFormToInstances()
    report("100 000 trees with all levels", standing)
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
    for tolerance in tolerances or (0.001,):
        report(f"1000 swaying trees, {tolerance} m", swaying, times=(0.0, 5.0, 24.0), JointTolerance=tolerance)


if __name__ == "__main__":
    main(*(float(word) for word in sys.argv[1:]))
