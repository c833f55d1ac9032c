# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Living landscapes and seas for VTK.

Every VTK class of Littoral can be imported from this package:

    from littoral import vtkTurningBandsTerrainSource
"""

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

from . import versions
from ._version import __version__, _vtk_version


def _release(version):
    """Parts of a VTK version that must match: major and minor, and for ParaView's VTK also the date."""
    major, minor, patch = version.split(".")[:3]
    return (major, minor, patch if len(patch) == 8 else "")


if _release(_vtkVersion.GetVTKVersion()) != _release(_vtk_version):
    raise ImportError(
        f"Littoral {__version__} was built for VTK {_vtk_version}, and this Python has VTK {_vtkVersion.GetVTKVersion()}")

from .LittoralSources import *
from .LittoralFilters import *
from .LittoralRendering import *

versions.mend_calls(
    (vtkPointProcessSource, vtkQuadratPointSource, vtkSeaStateSource, vtkTurningBandsTerrainSource))

#: Readers and writers by the libraries that they need.
_files = {"vtkElevationReader": "GDAL", "vtkElevationWriter": "GDAL", "vtkVDBVolumeWriter": "OpenVDB",
          "vtkGLTFSceneWriter": "tinygltf", "vtkForestTilesWriter": "GDAL and tinygltf"}
#: Missing classes by name, and the reasons.
_absent = {name: f"this Littoral was built without {library}" for name, library in _files.items()}
try:
    from .LittoralIO import *
except ModuleNotFoundError:
    pass
except ImportError as error:
    _absent = {name: f"its library cannot be loaded: {error}" for name in _files}
_absent = {name: reason for name, reason in _absent.items() if name not in globals()}


def __getattr__(name):
    if name in _absent:
        raise ImportError(f"There is no {name}: {_absent[name]}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = sorted(name for name in globals() if name.startswith("vtk"))
