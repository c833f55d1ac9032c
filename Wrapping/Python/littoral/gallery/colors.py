# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Colors of land: linear until `to_bytes` encodes them.

Height fields are as in `heights`.
"""

import numpy as np

from .heights import blur, smoothstep, steepness

MEADOW = np.array((0.150, 0.168, 0.060))
PASTURE = np.array((0.238, 0.215, 0.104))
FOREST = np.array((0.050, 0.080, 0.034))
UPLAND = np.array((0.095, 0.105, 0.042))
ROCK = np.array((0.260, 0.225, 0.185))
#: Colors from low to high land.
ATLAS = np.array((
    (0.095, 0.160, 0.120), (0.175, 0.220, 0.125), (0.300, 0.265, 0.140), (0.275, 0.170, 0.088),
    (0.350, 0.300, 0.260)))
LAKE = np.array((0.024, 0.085, 0.180))
SOIL = np.array((0.075, 0.052, 0.034))
BEDS = np.array(
    ((0.300, 0.235, 0.165), (0.200, 0.165, 0.130), (0.245, 0.170, 0.110), (0.260, 0.235, 0.200)))


def natural_color(z, spacing, reflectance=None):
    """Color of temperate terrain: meadows in hollows, woods on slopes, rock where steep.

    `reflectance` [0..1] decides between wood and meadow; default: random.
    """
    slope, height, hollow, patches, grain, wet = site_factors(z, spacing, reflectance)
    dry = smoothstep(patches + 0.4 * grain - 0.3 * hollow, -0.5, 1.8)
    high = smoothstep(height + 0.4 * patches, 0.2, 2.2)
    steep = slope + 4.0 * np.maximum(height - 1.0, 0.0) + 2.0 * patches + grain
    wood = mix(FOREST, UPLAND, high) * (1.0 + 0.14 * grain[..., None])
    color = mix(mix(MEADOW, PASTURE, dry), wood, wooded(slope, height, hollow, patches, grain, wet))
    return mix(color, ROCK * (1.0 + 0.08 * grain[..., None]), 0.9 * smoothstep(steep, 24.0, 36.0))


def wooded(slope, height, hollow, patches, grain, wet):
    """The fraction covered by trees, by the factors of plant cover."""
    favor = 0.10 * (slope - 7.0) + 0.45 * hollow + 0.35 * height - 0.6 * patches + 0.25 * grain - 0.4 * wet
    return smoothstep(favor, -0.9, 0.7)


def site_factors(z, spacing, reflectance, wetness=None):
    """Factors of plant cover: slope [degrees], height, hollows, patches, grain, and wet ground, 0 unless it is known."""
    slope = steepness(z, spacing)
    slope *= 25.0 / max(25.0, np.percentile(slope, 95.0))  # rock stays rare in steep terrain
    patches = _noise(z.shape, 10, seed=1) if reflectance is None else 4.0 * (reflectance - 0.5)
    wet = np.zeros(z.shape) if wetness is None else _standard(wetness)
    return slope, _standard(z), _standard(z - blur(z, 28)), patches, _noise(z.shape, 0, seed=2), wet


def height_color(z, spacing, reflectance=None):
    """Color by height alone, as in an atlas."""
    share = np.clip(0.5 + 0.22 * _standard(z), 0.0, 1.0)
    steps = np.linspace(0.0, 1.0, len(ATLAS))
    return np.stack([np.interp(share, steps, channel) for channel in ATLAS.T], axis=-1)


def section_color(along, height, depth, thickness):
    """Color of soil and rock beds in a cut.

    All in metres: position along the cut, height above the base, depth below the ground, and
    thickness of the block.
    """
    u = along / thickness
    folds = 0.9 * np.sin(0.23 * u + 0.5) + 0.25 * np.sin(0.9 * u) + 0.05 * np.sin(4.3 * u)
    bed = 9.0 * height / thickness + folds
    random = np.random.default_rng(5)
    tops = random.exponential(1.0, 60).cumsum() - 6.0
    rock = BEDS[random.integers(len(BEDS), size=61)][np.searchsorted(tops, bed)]
    rock = rock * (1.0 + 0.05 * np.sin(5.0 * bed) + 0.04 * np.sin(12.0 * bed))[..., None]
    return mix(SOIL, rock, smoothstep(depth / thickness, 0.03, 0.08))


def _standard(z):
    return (z - z.mean()) / max(z.std(), 1e-9)


def _noise(shape, radius, seed):
    """Noise of unit standard deviation, blurred by a radius [cells]."""
    return _standard(blur(np.random.default_rng(seed).standard_normal(shape), radius))


def mix(a, b, share):
    """Mixture of colors a and b, by a share of b at each place."""
    return a + (b - a) * share[..., None]


def to_bytes(color):
    """Linear colors as bytes in the code of sRGB."""
    x = np.clip(color, 0.0, 1.0)
    return np.round(255.0 * np.where(x < 0.0031308, 12.92 * x, 1.055 * x ** (1.0 / 2.4) - 0.055)).astype(np.uint8)
