# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""A drag of Underwater stays under water."""

import quick
import drags
from paraview import simple
from window import picture, small_view

view = small_view((150, 100))
simple.Show(simple.Underwater(), view)
picture(view)
drags.around("Underwater", view, lowest=-5.4, highest=-0.7, steps=2, directions=1, closers=(1.0,))
