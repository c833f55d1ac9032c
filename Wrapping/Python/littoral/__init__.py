# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Living landscapes and seas for VTK.

Every VTK class of Littoral can be imported from this package:

    from littoral import vtkTurningBandsTerrainSource
"""

from . import versions
from ._version import __version__
from .LittoralSources import *
from .LittoralFilters import *

versions.mend_calls((vtkQuadratPointSource, vtkSeaStateSource, vtkTurningBandsTerrainSource))

#: What is not in this build, by the name under which it is asked for.
_absent = {}
try:
    from .LittoralIO import *
except ModuleNotFoundError:
    _absent["vtkVDBVolumeWriter"] = "OpenVDB"


def __getattr__(name):
    if name in _absent:
        raise ImportError(f"This Littoral was built without {_absent[name]}, which {name} needs")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = sorted(name for name in globals() if name.startswith("vtk"))
