# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A pole that moves across a picture while the shutter is open has edges as a trapezoid of light: a pole of the width w
that goes by d hides the share |[x - d, x] with [0, w]| / d of the light at x.
"""

import numpy as np
from littoral.film import exposed, exposure_times
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

WIDTH, START = 400, 100.0  # of the picture, and the left edge of the pole at first [pixels]
SPEED, RATE, EXPOSURES = 2400.0, 24.0, 40  # [pixels/s], [frames/s]


def picture_at(time, width):
    """A black pole before white, at whole pixels."""
    columns = np.arange(WIDTH) + 0.5 - START - SPEED * time
    row = np.where((columns > 0.0) & (columns < width), 0, 255).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(WIDTH, 1, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.repeat(row, 3).reshape(WIDTH, 3), deep=True))
    return image


def light_of(image):
    codes = vtk_to_numpy(image.GetPointData().GetScalars())[:, 0] / 255.0
    return np.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)


def expected(way, width):
    x = np.arange(WIDTH) + 0.5 - START
    return 1.0 - np.clip(np.minimum(x, width) - np.maximum(x - way, 0.0), 0.0, None) / way


for blur in (0.5, 1.0):
    for pole in (20.0, 120.0):  # narrower than the way, and wider
        times = exposure_times(0.0, 1.0 / RATE, blur, EXPOSURES)
        found = light_of(exposed(picture_at(time, pole) for time in times))
        apart = np.abs(found - expected(blur * SPEED / RATE, pole))
        assert apart.max() <= 0.5 / EXPOSURES + 0.006, (blur, pole, apart.max())
        assert apart.mean() <= 0.004, (blur, pole, apart.mean())
still = picture_at(0.3 / RATE, 20.0)
same = exposed([still] * 3)
assert (vtk_to_numpy(same.GetPointData().GetScalars()) == vtk_to_numpy(still.GetPointData().GetScalars())).all()
