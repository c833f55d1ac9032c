# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Grow a terrain of 1 km x 1 km and write it as terrain.vti and terrain.png.

    python3 grow_terrain.py [FOLDER]
"""

import os
import sys
import tempfile

from littoral import vtkTurningBandsTerrainSource
from littoral.elevation import write_vti
from littoral.gallery.pictures import save_block

folder = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-")
os.makedirs(folder, exist_ok=True)

source = vtkTurningBandsTerrainSource()
source.SetSeed(7)
source.Update()

write_vti(source.GetOutput(), os.path.join(folder, "terrain.vti"))
save_block(os.path.join(folder, "terrain.png"), source.GetOutput())
print("terrain.vti and terrain.png are in", folder)
