# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""A file of 3 GB, most of which is no place on the disk: only the times that are asked for are in memory."""
import os
import resource
import sys
import tempfile

import littoral
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

if not hasattr(littoral, "vtkOceanCurrentReader"):
    print("built without the reader of ocean models")
    sys.exit(125)

from classic_netcdf import Variable, write  # noqa: E402
from ocean_files import EAST, NORTH, axis, times  # noqa: E402

SHAPE = (80, 20, 500, 500)  # times, levels, rows, columns
HOUR = 3600.0

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "sea.nc")
    names = "time depth lat lon"
    begins, record = write(path, dict(zip(names.split(), SHAPE)), {
        "time": times(HOUR * np.arange(SHAPE[0])),
        "depth": axis("depth", np.arange(1.0, 21.0), units="m", positive="down"),
        "lat": axis("lat", np.linspace(50.0, 51.0, SHAPE[2]), **NORTH),
        "lon": axis("lon", np.linspace(1.0, 2.0, SHAPE[3]), **EAST),
        "u": Variable(names, None, "f4", units="m/s"), "v": Variable(names, None, "f4", units="m/s")})
    level = np.full(SHAPE[2:], 0.5, ">f4").tobytes()
    with open(path, "r+b") as file:
        for time in (40, 41, 42):  # these flow northwards, the others are at rest
            for k in range(SHAPE[1]):
                file.seek(begins["v"] + time * record + k * len(level))
                file.write(level)
    size = os.path.getsize(path)
    assert size > 3e9, size
    reader = littoral.vtkOceanCurrentReader()
    reader.SetFileName(path)
    for time, speed in ((5, 0.0), (41, 0.5)):
        reader.UpdateTimeStep(time * HOUR)
        velocity = vtk_to_numpy(reader.GetOutputDataObject(0).GetPointData().GetArray("Velocity"))
        assert len(velocity) == np.prod(SHAPE[1:]) and abs(np.abs(velocity[:, 1]).max() - speed) < 1e-3, time
        del velocity
    cloud, points = vtkPolyData(), vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.array([[1000.0, 2000.0, -5.5]]), deep=1))
    cloud.SetPoints(points)
    drift = littoral.vtkCurrentDriftFilter()
    drift.SetInputData(0, cloud)
    drift.AddCurrentConnection(reader.GetOutputPort())
    drift.SetStartTime(39 * HOUR)
    drift.SetTimeStep(600.0)
    drift.UpdateTimeStep(43 * HOUR)
    # half an hour's worth while the current begins, two hours of it, half an hour's worth while it ends
    way = vtk_to_numpy(drift.GetOutputDataObject(0).GetPoints().GetData())[0] - (1000.0, 2000.0, -5.5)
    assert abs(way[1] - 0.5 * 3 * HOUR) < 1.0, way
    most = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"file {size / 1e9:.2f} GB, memory at most {most / 1e9:.3f} GB")
    assert most < 1e9, most
