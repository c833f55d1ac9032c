# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights of terrains: refined, and at places. Rows of arrays are from south to north."""

import numpy as np

from ..elevation import array_from_image


def subdivide(z):
    """Double the resolution by one step of cubic B-spline subdivision; the border stays fixed."""
    for axis in (0, 1):
        z = np.moveaxis(z, axis, 0)
        fine = np.empty((2 * len(z) - 1,) + z.shape[1:])
        fine[1::2] = 0.5 * (z[:-1] + z[1:])
        fine[2:-1:2] = 0.75 * z[1:-1] + 0.125 * (z[:-2] + z[2:])
        fine[0], fine[-1] = z[0], z[-1]
        z = np.moveaxis(fine, 0, axis)
    return z


def sampled(image, x, y, name="Elevation"):
    """Bilinear samples of a point array of an image at positions x, y [m]."""
    values = array_from_image(image, name).astype(float)
    u, v = ((np.asarray(at) - image.GetOrigin()[k]) / image.GetSpacing()[k] for k, at in enumerate((x, y)))
    i = np.clip(u.astype(int), 0, values.shape[1] - 2)
    j = np.clip(v.astype(int), 0, values.shape[0] - 2)
    u, v = u - i, v - j
    low = values[j, i] * (1.0 - u) + values[j, i + 1] * u
    high = values[j + 1, i] * (1.0 - u) + values[j + 1, i + 1] * u
    return low * (1.0 - v) + high * v
