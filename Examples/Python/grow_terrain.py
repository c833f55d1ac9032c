# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""Grow a terrain of 1 km x 1 km and write it as terrain.vti and terrain.png.

    python3 grow_terrain.py [FOLDER] [--quick]     --quick, for a test: a fifth as long and wide, and a small picture
"""

import os
import sys
import tempfile

from littoral import vtkTurningBandsTerrainSource
from littoral.elevation import write_vti
from littoral.gallery.pictures import save_blocks

words = [word for word in sys.argv[1:] if word != "--quick"]
quick = "--quick" in sys.argv
folder = words[0] if words else tempfile.mkdtemp(prefix="littoral-")
os.makedirs(folder, exist_ok=True)

source = vtkTurningBandsTerrainSource()
source.SetSeed(7)
if quick:
    source.SetWholeExtent(0, 100, 0, 100, 0, 0)
source.Update()

write_vti(source.GetOutput(), os.path.join(folder, "terrain.vti"))
save_blocks(os.path.join(folder, "terrain.png"), [source.GetOutput()], size=(300, 200) if quick else (1200, 800))
print("terrain.vti and terrain.png are in", folder)
