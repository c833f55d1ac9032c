# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Height fields: refinement, slopes, and how much of the sun and the sky each point sees.

A height field is an array z[row, column] [m], rows from south to north, with a spacing (dx, dy) [m]. Angles are in degrees.
"""

import numpy as np

from ..elevation import array_from_image
from ..glb import direction


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


def blur(z, radius):
    """Three box filters of 2 radius + 1 cells: nearly a Gaussian."""
    size = 2 * radius + 1
    for axis in (0, 1) * 3:
        z = np.moveaxis(z, axis, 0)
        padded = np.concatenate((z[:1].repeat(radius + 1, 0), z, z[-1:].repeat(radius, 0)))
        sums = padded.cumsum(axis=0, dtype=np.float64)
        z = np.moveaxis((sums[size:] - sums[:-size]) / size, 0, axis)
    return z


def normals(z, spacing):
    """Unit normals [row, column, 3]."""
    slope_y, slope_x = np.gradient(z, spacing[1], spacing[0])
    n = np.stack((-slope_x, -slope_y, np.ones_like(z)), axis=-1)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def sunlight(z, spacing, azimuth, elevation, softness=0.07):
    """Fraction [0..1] of the sun visible from each point; shadows fade over `softness` of slope."""
    rise = np.tan(np.radians(elevation))
    clear = np.ones(z.shape)
    for slope in _march(z, spacing, azimuth, np.ptp(z) / rise, growth=1.04):
        np.minimum(clear, np.subtract(rise, slope, out=slope), out=clear)
    return smoothstep(clear, -0.5 * softness, 0.5 * softness)


def openness(z, spacing, farthest=None, directions=12):
    """Fraction [0..1] of the sky visible from each point, by relief up to `farthest` [m]."""
    farthest = farthest or 40.0 * max(spacing)
    total = np.zeros(z.shape)
    for azimuth in np.arange(directions) * 360.0 / directions:
        horizon = np.zeros(z.shape)
        for slope in _march(z, spacing, azimuth, farthest, growth=1.6):
            np.maximum(horizon, slope, out=horizon)
        total += 1.0 / (1.0 + horizon**2)
    return total / directions


def _march(z, spacing, azimuth, farthest, growth):
    """March from every point along an azimuth: yields the slopes of the lines of sight, in an array that is used again.

    Beyond the border the ground is as high as there.
    """
    towards, last = direction(azimuth, 0.0), np.subtract(z.shape, 1)
    steps, distance = [], min(spacing)
    while distance < farthest:
        steps.append([round(towards[1] * distance / spacing[1]), round(towards[0] * distance / spacing[0])])
        distance = max(distance + min(spacing), distance * growth)
    if not steps:
        return
    shifts = np.clip(steps, -last, last)
    before, after = np.maximum(-shifts.min(axis=0), 0), np.maximum(shifts.max(axis=0), 0)
    around, slope = np.pad(z, np.column_stack((before, after)), mode="edge"), np.empty(z.shape)
    for (rows, columns), (row, column) in zip(steps, before + shifts):
        np.subtract(around[row:row + z.shape[0], column:column + z.shape[1]], z, out=slope)
        slope /= np.hypot(columns * spacing[0], rows * spacing[1])
        yield slope


def smoothstep(value, low, high):
    """0 below low, 1 above high, smooth between them."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def sampled(image, x, y, name="Elevation"):
    """Bilinear samples of a point array of an image that starts at (0, 0), at positions x, y [m]."""
    values, spacing = array_from_image(image, name).astype(float), image.GetSpacing()
    u, v = np.asarray(x) / spacing[0], np.asarray(y) / spacing[1]
    i = np.clip(u.astype(int), 0, values.shape[1] - 2)
    j = np.clip(v.astype(int), 0, values.shape[0] - 2)
    u, v = u - i, v - j
    low = values[j, i] * (1.0 - u) + values[j, i + 1] * u
    high = values[j + 1, i] * (1.0 - u) + values[j + 1, i + 1] * u
    return low * (1.0 - v) + high * v
