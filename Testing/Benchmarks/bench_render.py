# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of pictures by Blender's path tracer: 2000 trees in full on hills, and the examples.

    ./littoral run /usr/bin/python3 Testing/Benchmarks/bench_render.py [FOLDER]
"""

import os
import resource
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import blender, landscape, vtkPlantScatterFilter, vtkReevesTreeSource, vtkTurningBandsTerrainSource
from littoral.glb import write_glb

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLES = os.path.join(TOP, "Examples", "Blender")
TREES, SIDE = 2000, 400  # and the side of the ground [m]


def write_trees(filename, frame=0):
    """Trees of four species in full, as instances, on hills; all of them before the camera."""
    ground = vtkTurningBandsTerrainSource()
    ground.SetWholeExtent(0, SIDE, 0, SIDE, 0, 0)
    ground.SetSpacing(1.0, 1.0, 1.0)
    ground.SetMean(0.0)
    ground.SetStandardDeviation(9.0)
    ground.SetRange(160.0)
    ground.SetShortestWavelength(12.0)
    ground.Update()
    image = ground.GetOutput()
    height = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(SIDE + 1, SIDE + 1)
    at = np.random.default_rng(4).uniform(0, SIDE, (TREES, 2))
    places = np.column_stack((at, height[tuple(at.astype(int).T[::-1])]))
    forest = vtkPlantScatterFilter()
    forest.SetInputData(0, landscape.points_with(places))
    trees = [vtkReevesTreeSource() for _ in range(4)]
    for preset, tree in enumerate(trees, 1):
        tree.SetPreset(preset)
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetOutputFormToInstances()
    forest.SetUseLevels(False)
    forest.SetUseCulling(False)
    forest.Update()
    count = forest.GetOutput().GetFieldData().GetArray("PlantsShown").GetTuple1(0)
    assert count == TREES, count
    eye = (0.5 * SIDE, -90.0, height.max() + 30.0)
    write_glb(filename, {"Forest": forest, "Ground": image}, camera=(eye, (0.5 * SIDE, 0.4 * SIDE, 0.0), (0, 0, 1), 45.0),
              sun=(150.0, 35.0), LevelForm=2)


def report(name, write, folder, **options):
    with tempfile.TemporaryDirectory() as scratch:
        scene = os.path.join(scratch, "scene.glb")
        write(scene)
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        blender.render(scene, os.path.join(folder or scratch, f"{name}.png"), **options)
        after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter() - begin
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    # Memory is the largest of all processes so far: the smallest scene comes first.
    print(f"{name}: {wall:.0f} s, {cpu:.0f} s of CPU time, {after.ru_maxrss / 1e6:.2f} GB, load {os.getloadavg()[0]:.1f}",
          flush=True)


def main(folder=None):
    report("trees", write_trees, folder)
    for name, options in (("underwater", dict(size=[800, 450], samples=64)), ("forest", {})):
        path = os.path.join(EXAMPLES, f"{name}.py")
        report(name, lambda file, path=path: blender.write_scene(path, file, 0), folder, **options)


if __name__ == "__main__":
    main(*sys.argv[1:])
