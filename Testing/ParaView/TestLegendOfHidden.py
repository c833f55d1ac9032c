# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""The hidden source of a scene has no legend beside something else, though a window shows one after the first pictures;
once it is shown, it may have one.
"""

import quick
from first_looks import SIZE
from paraview import simple
from window import small_view

view = small_view(SIZE)
simple.Show(simple.TurningBandsTerrain(WholeExtent=[0, 32, 0, 32, 0, 0], Spacing=[4.0, 4.0, 1.0]), view)
simple.Render(view)
wind = simple.SwayingForest()
display = simple.Show(wind, view)
simple.Render(view)
simple.ColorBy(display, ("POINTS", "Velocity"))
for visible in 0, 0, 1:
    assert display.Visibility == 0
    display.Visibility = visible
    display.SetScalarBarVisibility(view, True)
    simple.Render(view)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("Velocity"), view)
    assert bar.Visibility == visible, f"a legend of what is {'shown' if visible else 'hidden'}: {bar.Visibility}"
simple.Delete(view)
