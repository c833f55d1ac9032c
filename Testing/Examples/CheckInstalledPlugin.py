# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin found through PV_PLUGIN_PATH brings the proxies, with the prefix's own libraries."""
import sys

from paraview import servermanager, simple

assert hasattr(servermanager.sources, "TurningBandsTerrain"), "the terrain source is missing"
terrain = simple.TurningBandsTerrain()
terrain.UpdatePipeline()
assert terrain.PointData["Elevation"] is not None

with open("/proc/self/maps") as maps:
    files = {line.split()[-1] for line in maps if "Littoral" in line}
assert files and all(file.startswith(sys.argv[1]) for file in files), files
