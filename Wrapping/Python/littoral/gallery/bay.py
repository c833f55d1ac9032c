# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A bay: bed with stones, sites of kelp, particles. Lengths are in metres, y is north, the sea level at 0."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..elevation import image_from_array
from .heights import sampled
from .meshes import add_array, vertices


def bed(depth, eye, size=120.0, samples=900, seed=5):
    """The image of a sandy bed with stones around a position, with its Elevation and RGB."""
    heights = 0.45 * _field(size, samples, 30.0, 4.5, seed)
    stones = _field(size, samples, 7.0, 3.6, seed + 1)
    bumps = _field(size, samples, 2.2, 2.8, seed + 2)
    rock = np.clip((stones + 0.12 * bumps - 1.25) / 0.22, 0.0, 1.0)
    rock = rock * rock * (3.0 - 2.0 * rock)
    step, corner = size / (samples - 1), (eye[0] - 0.5 * size, eye[1] - 0.15 * size)
    y, x = np.mgrid[0:samples, 0:samples] * step
    marks = np.sin(2.0 * np.pi * (0.45 * (x + corner[0]) + 1.25 * (y + corner[1]) + 0.9 * heights + 0.15 * bumps))
    z = -depth + heights + (1.0 - rock) * 0.022 * marks + rock * (0.30 + 0.13 * bumps + 0.75 * (stones - 1.25))
    sand = np.array((0.66, 0.60, 0.46)) * (1.0 + 0.07 * bumps[..., None] + 0.05 * marks[..., None])
    stone = np.array((0.22, 0.23, 0.19)) * (1.0 + 0.30 * bumps[..., None])
    crust = np.array((0.40, 0.26, 0.27))  # coralline algae
    stone = stone + (crust - stone) * np.clip(0.7 * stones - 0.75 + 0.4 * bumps, 0.0, 0.8)[..., None]
    color = sand + (stone - sand) * rock[..., None]
    image = image_from_array(z, (step, step), corner)
    add_array(image, "RGB", np.round(255.0 * np.clip(color, 0.0, 1.0)).astype(np.uint8).reshape(-1, 3))
    return image


def _field(size, samples, reach, smoothness, seed):
    """A periodic random field of unit variance; wavelengths below reach [m] have less power."""
    frequency = np.hypot(np.fft.fftfreq(samples)[:, None], np.fft.rfftfreq(samples)[None]) * samples / size
    strength = (1.0 + (frequency * reach) ** 2) ** (-0.5 * smoothness)
    strength[0, 0] = 0.0
    white = np.random.default_rng(seed).standard_normal((samples, samples))
    field = np.fft.irfft2(np.fft.rfft2(white) * strength, s=white.shape)
    return field / field.std()


def kelp_sites(bed, count=130, seed=4, top=-0.8):
    """Sites for Plant Scatter before the camera, in groves, with Species (0 sugar kelp, 1 giant kelp) and Scale.

    top: largest height of giant kelp [m].
    """
    random = np.random.default_rng(seed)
    groves = np.array(((-6.0, 10.5), (7.0, 12.0), (-12.5, 19.0), (14.0, 20.0), (1.5, 25.0)))
    near = ((2.2, 4.7), (3.0, 5.4), (1.9, 6.1), (3.9, 5.9), (2.9, 6.8), (4.9, 7.0), (3.8, 7.9), (5.6, 8.3), (-2.6, 5.2),
            (-3.6, 5.9), (-2.4, 6.7), (-4.5, 7.2), (-3.4, 8.0), (-5.4, 8.6), (-1.3, 9.4), (0.9, 10.4))
    number = np.arange(count)
    giant = number % 4 == 0
    apart = random.normal(0.0, 1.0, (count, 2)) * np.where(giant, 1.7, 2.6)[:, None]
    x, y = (groves[number // 4 % len(groves)] + apart).T
    free = (y < 5.0) | (np.abs(x) < 0.12 * y) | (giant & (y < 8.0))  # of plants, for the view
    places = np.concatenate((near, np.column_stack((x, y))[~free]))
    species = np.concatenate((np.zeros(len(near), np.int32), giant[~free])).astype(np.int32)
    foot = sampled(bed, *places.T)
    largest = (top - foot) / 14.6  # height of giant kelp [m]
    scale = np.where(species, largest * random.uniform(0.75, 1.0, len(places)), random.uniform(0.7, 1.15, len(places)))
    return vertices(np.column_stack((places, foot)), Species=species, Scale=scale)


def particles(box, count, radius, color, seed=1, clumps=0.0, plants=None, share=0.03):
    """Particles in a box (smallest, then largest x, y, z) with the arrays Radius [m] and RGB.

    radius: median [m]; clumps: 0 uniform to 1 gathered in clouds; plants: sites around which a fraction share gathers.
    """
    random = np.random.default_rng(seed)
    low, high = np.reshape(box, (2, 3))
    places = low + random.random((count, 3)) * (high - low)
    if clumps > 0.0:
        centers = low + (0.12, 0.35, 0.12) * (high - low) + random.random((max(1, count // 30000), 3)) * (
            0.76, 0.55, 0.6) * (high - low)
        near = centers[random.integers(len(centers), size=count)]
        near = near + random.normal(0.0, 1.7, (count, 3)) * (1.5, 1.5, 0.6)
        inside = ((near > low) & (near < high)).all(axis=1, keepdims=True)
        places = np.where((random.random((count, 1)) < clumps) & inside, near, places)
    if plants is not None:
        feet = vtk_to_numpy(plants.GetPoints().GetData())
        gathered = feet[random.integers(len(feet), size=int(share * count))]
        gathered = gathered + random.normal(0.0, 0.5, gathered.shape) * (1.0, 1.0, 0.0)
        gathered[:, 2] += 2.2 * random.random(len(gathered))
        places[:len(gathered)] = np.clip(gathered, low, high)
    sizes = radius * np.exp(np.clip(0.5 * random.standard_normal(count), -1.5, 1.0))
    shade = np.clip(np.array(color) * random.uniform(0.75, 1.1, (count, 1)), 0.0, 1.0)
    return vertices(places, Radius=sizes.astype(np.float32), RGB=np.round(255.0 * shade).astype(np.uint8))
