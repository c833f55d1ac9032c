# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Living landscapes and seas for VTK.

Every VTK class of Littoral can be imported from this package:

    from littoral import vtkTurningBandsTerrainSource
"""

from .LittoralSources import *
from .LittoralFilters import *

try:
    from .LittoralIO import *
except ModuleNotFoundError:
    pass  # built without OpenVDB

__all__ = sorted(name for name in globals() if name.startswith("vtk"))
