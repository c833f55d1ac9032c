# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package gives the classes; properties have the defaults that the documentation says."""

import os
import shutil
import subprocess
import sys
import tempfile

import littoral
from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource

source = vtkTurningBandsTerrainSource()
assert source.GetModel() == vtkTurningBandsTerrainSource.Fractal
assert source.GetWholeExtent() == (0, 500, 0, 500, 0, 0)
assert source.GetSpacing() == (2.0, 2.0, 1.0)
source.Update()
elevation = source.GetOutput().GetPointData().GetScalars()
low, high = elevation.GetRange()
assert elevation.GetName() == "Elevation"
assert high - low > 50.0, "the default terrain has no relief"
assert "FractalDimension" in str(source)
assert vtkCovarianceFitFilter().GetNumberOfOutputPorts() == 2
assert hasattr(littoral, "vtkTurningBandsTerrainSource")

# Without the library of the volume writer, all other classes are there.
with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(os.path.dirname(littoral.__file__), os.path.join(folder, "littoral"))
    module = os.path.join(folder, "littoral", "LittoralIO.so")
    if os.path.exists(module):
        with open(module, "wb"):
            pass
        script = ("import littoral; littoral.vtkReevesTreeSource()\n"
                  "try: littoral.vtkVDBVolumeWriter\nexcept ImportError as error: print(error)")
        search = os.pathsep.join((folder, os.environ["PYTHONPATH"]))
        ran = subprocess.run([sys.executable, "-c", script], env=dict(os.environ, PYTHONPATH=search), capture_output=True,
                             text=True, check=True)
        assert ran.stdout.startswith("There is no vtkVDBVolumeWriter: its library cannot be loaded: "), ran.stdout
