# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times and memory of Blender's path tracer: two woods of over 2000 trees in full, and the two examples.

    ./littoral run /usr/bin/python3 Testing/Benchmarks/bench_renders.py [CASE...]

Cases: trees and hills (960 x 540, 48 samples), underwater (800 x 450, 64 samples), forest (960 x 540, 48 samples);
default: all but the last. Each in a process of its own, from the start of Blender to the whole picture, without the
writing of the scene file. On a machine with other work, processor time by the number of cores is what an idle machine
would need at least. LITTORAL_RENDERS names a folder that keeps the pictures.
"""

import os
import resource
import runpy
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import blender, vtkPlantScatterFilter, vtkReevesTreeSource, vtkTurningBandsTerrainSource
from littoral.gallery.meshes import vertices
from littoral.glb import write_glb

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Blender")
#: Size, samples, and the most seconds and gigabytes that are wanted.
CASES = {"trees": ((960, 540), 48, 60, 3), "hills": ((960, 540), 48, 60, 3), "underwater": ((800, 450), 64, 120, None),
         "forest": ((960, 540), 48, None, None)}


def wood(filename, count, side, above, extras):
    """Trees of four species in full on a random terrain, seen from its edge, from a height above the highest tree's foot."""
    land = vtkTurningBandsTerrainSource()
    land.SetWholeExtent(0, 200, 0, 200, 0, 0)
    land.SetSpacing(side / 200.0, side / 200.0, 1.0)
    land.SetRange(150.0)
    land.SetStandardDeviation(8.0)
    land.Update()
    heights = vtk_to_numpy(land.GetOutput().GetPointData().GetScalars()).reshape(201, 201)
    column, row = np.random.default_rng(5).integers(0, 201, (2, count))
    places = np.column_stack((column * side / 200.0, row * side / 200.0, heights[row, column]))
    forest = vtkPlantScatterFilter()
    forest.SetInputData(0, vertices(places, Species=np.arange(count, dtype=np.int32) % 4))
    for preset in (1, 2, 3, 4):
        tree = vtkReevesTreeSource()
        tree.SetPreset(preset)
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetOutputFormToInstances()
    forest.SetUseLevels(False)
    forest.SetUseCulling(False)
    middle = places.mean(axis=0)
    eye = (middle[0], places[:, 1].min() - 30.0, places[:, 2].max() + above)
    write_glb(filename, {"Ground": land, "Forest": forest}, camera=(eye, tuple(middle), (0, 0, 1), 40.0),
              sun=(150, 35, 100000.0), extras=extras, LevelForm=2)


def trees(filename):
    """2000 trees on 400 x 400 m, with haze: no sky is seen."""
    wood(filename, 2000, 400.0, 12.0, {"fog": {"sight": 2600.0, "height": 160.0}, "exposure": 1.0})


def hills(filename):
    """2265 trees that stand apart on hills, in clear air below the sky."""
    wood(filename, 2265, 1000.0, -6.0, {"exposure": 1.0})


#: Scenes that are made here.
MADE = {"trees": trees, "hills": hills}


def measure(case):
    size, samples, seconds, memory = CASES[case]
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "scene.glb")
        if case in MADE:
            MADE[case](name)
        else:
            runpy.run_path(os.path.join(EXAMPLES, f"{case}.py"))["write_scene"](name)
        kept = os.environ.get("LITTORAL_RENDERS", folder)
        begin = time.perf_counter()
        blender.render(name, os.path.join(kept, f"{case}.png"), size=size, samples=samples)
        wall = time.perf_counter() - begin
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = used.ru_utime + used.ru_stime
    goals = [f"{goal} {unit}" for goal, unit in ((seconds, "s"), (memory, "GB")) if goal]
    print(f"{case}, {size[0]} x {size[1]}, {samples} samples: {wall:.0f} s, {processor:.0f} s of processor time "
          f"({processor / os.cpu_count():.0f} s on each of {os.cpu_count()} cores), {used.ru_maxrss / 1e6:.2f} GB, "
          f"load {os.getloadavg()[0]:.1f}" + (f"; at most {' and '.join(goals)} wanted" if goals else ""), flush=True)


if __name__ == "__main__":
    if os.environ.get("LITTORAL_RENDER_CASE"):
        measure(os.environ["LITTORAL_RENDER_CASE"])
    else:
        for one in sys.argv[1:] or ("trees", "hills", "underwater"):
            subprocess.run([sys.executable, __file__], env={**os.environ, "LITTORAL_RENDER_CASE": one}, check=True)
