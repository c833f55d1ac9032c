# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of presets in guide/seaweed.md has the numbers of what Seaweed grows, by the digits that it prints."""

import re
from pathlib import Path

import numpy as np
from littoral import vtkSeaweedSource
from littoral.plants import block
from vtkmodules.util.numpy_support import vtk_to_numpy

GUIDE = Path(__file__).resolve().parents[2] / "Documentation" / "guide" / "seaweed.md"
PRESETS = {"Sugar Kelp": vtkSeaweedSource.SugarKelp, "Giant Kelp": vtkSeaweedSource.GiantKelp,
           "Eelgrass": vtkSeaweedSource.Eelgrass}
WATER, GRAVITY, HOLDFAST = 1025.0, 9.80665, 3


def polygons(output, *names):
    return sum(block(output, *name.split("/")).GetNumberOfPolys() for name in names)


def segments(bones):
    """Lengths, sections and densities of the segments of all branches but the holdfast."""
    points, arrays = vtk_to_numpy(bones.GetPoints().GetData()), bones.GetPointData()
    width, thickness, density, tissue = (
        vtk_to_numpy(arrays.GetArray(name)) for name in ("Width", "Thickness", "Density", "Tissue"))
    ends = vtk_to_numpy(bones.GetLines().GetConnectivityArray())
    offsets = vtk_to_numpy(bones.GetLines().GetOffsetsArray())
    first = np.delete(np.arange(len(ends)), offsets[1:] - 1)
    low, high = ends[first], ends[first + 1]
    lengths = np.linalg.norm(points[high] - points[low], axis=1)
    moves = tissue[low] != HOLDFAST
    return lengths[moves], (np.pi / 4.0 * width * thickness)[low][moves], density[low][moves]


rows = re.findall(r"^\| ([A-Z][\w ]+) \| (\d[^\n]*) \|$", GUIDE.read_text(encoding="utf-8"), re.MULTILINE)
assert [name for name, _ in rows] == list(PRESETS), rows
for name, numbers in rows:
    plant = vtkSeaweedSource()
    plant.SetPreset(PRESETS[name])
    plant.Update()
    output = plant.GetOutputDataObject(0)
    bones = block(output, "High", "Skeleton")
    lengths, areas, densities = segments(bones)
    volumes = lengths * areas
    found = (bones.GetNumberOfLines(), len(lengths), (densities * volumes).sum(),
             ((WATER - densities) * GRAVITY * volumes).sum(), polygons(output, "High/Skin", "High/Leaves"),
             polygons(output, "Medium/Trunk", "Medium/Crown"), block(output, "Low").GetNumberOfPolys())
    print(name, found)
    for number, value in zip(numbers.split(" | "), found):
        digits = len(number.lstrip("0.").replace(".", ""))
        assert float(f"{value:.{digits}g}") == float(number), (name, number, value)
