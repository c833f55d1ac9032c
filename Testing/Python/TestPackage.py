# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package gives the classes; properties have the defaults that the documentation says; names with an underscore stay
in their module."""

import ast
import glob
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
        search = os.pathsep.join((folder, os.environ.get("PYTHONPATH", "")))
        ran = subprocess.run([sys.executable, "-c", script], env=dict(os.environ, PYTHONPATH=search),
                             capture_output=True, text=True, check=True)
        assert ran.stdout.startswith("There is no vtkVDBVolumeWriter: its library cannot be loaded: "), ran.stdout


def borrowed(tree):
    """Names with an underscore that a module takes from another one of the package."""
    modules, taken = set(), []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.level or node.module.partition(".")[0] == "littoral"):
            modules |= {alias.asname or alias.name for alias in node.names}
            taken += [] if node.module == "_version" else [alias.name for alias in node.names]
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
            taken.append(node.attr)
    return [name for name in taken if name.startswith("_") and not name.endswith("__")]


assert borrowed(ast.parse("from . import colors\ncolors._mix(1)")) == ["_mix"]
assert borrowed(ast.parse("from littoral.gallery.colors import _mix")) == ["_mix"]
SOURCE = os.environ["LITTORAL_SOURCE_DIR"]
for folder in ("Wrapping", "Examples", "Testing", "Documentation"):
    for path in glob.glob(os.path.join(SOURCE, folder, "**", "*.py"), recursive=True):
        with open(path, encoding="utf-8") as file:
            found = borrowed(ast.parse(file.read()))
        assert not found, f"{path} takes {found[0]} from another module"
