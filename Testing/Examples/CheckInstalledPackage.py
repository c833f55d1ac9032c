# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package comes from the prefix given as argument, with type stubs where VTK can make them, its classes work,
and what the C++ example has written beside the prefix can be read."""
import importlib.util
import os
import sys

from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import littoral

assert littoral.__file__.startswith(sys.argv[1]), littoral.__file__
source = littoral.vtkTurningBandsTerrainSource()
source.Update()
image = source.GetOutput()
assert image.GetNumberOfPoints() > 0
assert image.GetPointData().GetArray("Elevation") is not None
littoral.vtkCovarianceFitFilter()
if importlib.util.find_spec("vtkmodules.generate_pyi"):
    files = os.listdir(os.path.dirname(littoral.__file__))
    assert {"LittoralSources.pyi", "LittoralFilters.pyi", "py.typed"} <= set(files), files

reader = vtkXMLImageDataReader()
reader.SetFileName(os.path.join(os.path.dirname(sys.argv[1]), "terrain.vti"))
reader.Update()
assert reader.GetOutput().GetPointData().GetArray("Elevation") is not None
