# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""A script's OpenDataFile takes the right reader for each kind of netCDF file that is ours."""

import os
import sys

import quick  # noqa: F401
from paraview import simple

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
from TestNetcdfKinds import FILES, write_all  # noqa: E402

PROXIES = {"wind": "FileOfWind", "sea": "FileOfOceanCurrents", "raster": "ElevationReader"}

write_all(".")
for name, (_, kind) in FILES.items():
    if kind:  # of others ParaView's own readers claim each
        found = simple.OpenDataFile(os.path.abspath(name)).GetXMLName()
        print(f"{name}: {found}")
        assert found == PROXIES[kind], (name, found)
