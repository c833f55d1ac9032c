# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""A drag of Underwater stays under water."""

import quick
import drags
from paraview import simple
from window import picture, small_view

view = small_view((120, 80))
simple.Show(simple.Underwater(), view)
picture(view)
simple.Hide(simple.FindSource("Kelp"), view)  # for a cheaper picture
drags.around("Underwater", view, lowest=-5.4, highest=-0.7, steps=1, directions=1, closers=(1.0,))
