# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2,3
"""The same terrain, the same fit and the same twin on any number of ranks.

The run on one rank writes its result; the others compare with it.
"""

import hashlib
import os

import numpy as np
from paraview import servermanager, simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.util.numpy_support import vtk_to_numpy

ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def whole_image(proxy):
    """The image of all ranks as one array [row, column], by a probe of a plane at each point."""
    data = servermanager.Fetch(proxy)
    blocks = [data] if data.IsA("vtkImageData") else [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]
    extent = proxy.GetDataInformation().GetExtent()
    image = np.full((extent[3] - extent[2] + 1, extent[1] - extent[0] + 1), np.nan, np.float32)
    for block in blocks:
        part = block.GetExtent()
        values = vtk_to_numpy(block.GetPointData().GetArray("Elevation"))
        rows, columns = part[3] - part[2] + 1, part[1] - part[0] + 1
        y, x = part[2] - extent[2], part[0] - extent[0]
        image[y : y + rows, x : x + columns] = values.reshape(rows, columns)
    return image


terrain = simple.TurningBandsTerrain(WholeExtent=[0, 200, 0, 150, 0, 0], Model="Spherical", Range=120.0)
fit = simple.CovarianceFit(Input=terrain)
twin = simple.TurningBandsTerrainFromFits(Input=fit, WholeExtent=[0, 120, 0, 99, 0, 0], Seed=9)
terrain.UpdatePipeline()
twin.UpdatePipeline()
fits = servermanager.Fetch(simple.OutputPort(fit, 0))
assert fits.GetNumberOfRows() == 7, f"{fits.GetNumberOfRows()} rows on {ranks} ranks"

result = [hashlib.sha256(whole_image(proxy).tobytes()).hexdigest() for proxy in (terrain, twin)]
for name in ("ModelId", "Variance", "Range", "AICc"):
    result.append(vtk_to_numpy(fits.GetColumnByName(name)).tobytes().hex())
text = "\n".join(result)
assert not np.isnan(whole_image(terrain)).any()
if ranks == 1:
    with open("result.txt", "w") as file:
        file.write(text)
else:
    assert os.path.exists("result.txt"), "the run on one rank comes first"
    with open("result.txt") as file:
        assert file.read() == text, f"{ranks} ranks give another result than one"
print(f"{ranks} ranks: {result[0][:16]} {result[1][:16]}")
