# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Drainage areas against those of SAGA's deterministic 8, on carved and on regular ground: every cell.

Needs `saga_cmd` of Debian's package saga, in PATH or named by SAGA_CMD; skipped without it. GRASS's r.watershed is no
peer: its search fills and cuts by itself, and between 6 and 14 % of its cells drain another way.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

from littoral import vtkDrainageFilter, vtkTurningBandsTerrainSource
from littoral.elevation import array_from_image, image_from_array

SAGA = os.environ.get("SAGA_CMD") or shutil.which("saga_cmd")
if not SAGA:
    print("no saga_cmd")
    sys.exit(125)

HEADER = """NAME\t= {name}
DATAFORMAT\t= DOUBLE
BYTEORDER_BIG\t= FALSE
POSITION_XMIN\t= 0
POSITION_YMIN\t= 0
CELLCOUNT_X\t= {columns}
CELLCOUNT_Y\t= {rows}
CELLSIZE\t= {spacing}
Z_FACTOR\t= 1
NODATA_VALUE\t= -99999
TOPTOBOTTOM\t= FALSE
"""


def write_grid(folder, name, heights, spacing):
    rows, columns = heights.shape
    with open(os.path.join(folder, name + ".sgrd"), "w", encoding="ascii") as header:
        header.write(HEADER.format(name=name, rows=rows, columns=columns, spacing=spacing))
    np.ascontiguousarray(heights, "<f8").tofile(os.path.join(folder, name + ".sdat"))


def read_grid(folder, name, shape):
    kinds = {"DOUBLE": "<f8", "FLOAT": "<f4"}
    with open(os.path.join(folder, name + ".sgrd"), encoding="ascii") as header:
        entries = dict(line.rstrip("\n").split("\t= ") for line in header if "\t= " in line)
    assert entries["TOPTOBOTTOM"] == "FALSE", entries
    return np.fromfile(os.path.join(folder, name + ".sdat"), kinds[entries["DATAFORMAT"]]).reshape(shape)


def areas_of_saga(heights, spacing):
    with tempfile.TemporaryDirectory() as folder:
        write_grid(folder, "heights", heights, spacing)
        subprocess.run([SAGA, "ta_hydrology", "0", "-ELEVATION", "heights.sgrd", "-FLOW", "flow.sgrd",
                        "-METHOD", "0", "-FLOW_UNIT", "1"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        return read_grid(folder, "flow", heights.shape).astype(float)


def carved(seed, spacing):
    """A fractal that drains."""
    source, drainage = vtkTurningBandsTerrainSource(), vtkDrainageFilter()
    source.SetWholeExtent(0, 149, 0, 119, 0, 0)
    source.SetSpacing(spacing, spacing, 1.0)
    source.SetSeed(seed)
    drainage.SetInputConnection(source.GetOutputPort())
    drainage.SetMaximumNumberOfIterations(3)
    drainage.Update()
    return array_from_image(drainage.GetOutput()).copy()


def cone(spacing):
    """A hill whose top is at no cell, so that no two slopes of a cell are equal."""
    y, x = np.mgrid[0:120, 0:150] * spacing
    return 1000.0 - np.hypot(x - 71.37 * spacing, y - 58.71 * spacing)


def image_of(heights, spacing):
    """In double precision, so that no two heights become equal."""
    image = image_from_array(heights, (spacing, spacing))
    values = numpy_to_vtk(heights.ravel(), deep=True)
    values.SetName("Elevation")
    image.GetPointData().SetScalars(values)
    return image


def compare(name, heights, spacing):
    # At the border, from which all water leaves here, cells are low, so that none of SAGA's flows back.
    heights[[0, -1]] = heights[:, [0, -1]] = heights.min() - 100.0
    drainage = vtkDrainageFilter()
    drainage.SetInputData(image_of(heights, spacing))
    drainage.CarveOff()
    drainage.Update()
    own = array_from_image(drainage.GetOutput(), "DrainageArea")
    other = areas_of_saga(heights, spacing)
    inside = (slice(1, -1), slice(1, -1))
    differ = np.abs(own[inside] / other[inside] - 1.0) > 1e-6
    largest = own[inside].max() / spacing**2
    print(f"{name}: {differ.sum()} of {differ.size} cells differ; the largest drains {largest:.0f} cells")
    assert not differ.any()
    assert largest > 50
    # At the outlets areas sum to the grid's exactly.
    directions = array_from_image(drainage.GetOutput(), "FlowDirection")
    assert own[directions == -1].sum() == own.size * spacing**2


for seed in 1, 2, 3:
    compare(f"carved fractal {seed}", carved(seed, 20.0), 20.0)
compare("cone", cone(10.0), 10.0)
