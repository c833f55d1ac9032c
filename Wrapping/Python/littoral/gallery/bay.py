# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A bay: bed with stones, sites of kelp, particles. Lengths are in metres, x is east, y north, z up, the sea level at 0."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from .meshes import polygons, quads, vertices


def mesh(points, normals=None, colors=None):
    """Quadrilaterals between rows of points [row, column, 3]; colors from 0 to 1."""
    flat = None if colors is None else colors.reshape(-1, 3)
    data = polygons(points.reshape(-1, 3), quads(*points.shape[:2]), flat)
    if normals is not None:
        array = numpy_to_vtk(normals.reshape(-1, 3).astype(np.float32), deep=True)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    return data


def bed(depth, eye, size=120.0, samples=900, seed=5):
    """A sandy bed with stones around a position, with the array RGB; and a function of its height [m].

    Of the samples some rows and columns away from the position are left out, so that a cell's sides are at most about
    1/75 of its distance, or as long as those of the samples.
    """
    heights = 0.45 * _field(size, samples, 30.0, 4.5, seed)
    stones = _field(size, samples, 7.0, 3.6, seed + 1)
    bumps = _field(size, samples, 2.2, 2.8, seed + 2)
    rock = np.clip((stones + 0.12 * bumps - 1.25) / 0.22, 0.0, 1.0)
    rock = rock * rock * (3.0 - 2.0 * rock)
    step = size / (samples - 1)
    along = np.arange(samples) * step - 0.5 * size
    x, y = np.meshgrid(along + eye[0], along + eye[1] + 0.35 * size)
    marks = np.sin(2.0 * np.pi * (0.45 * x + 1.25 * y + 0.9 * heights + 0.15 * bumps))  # ripple marks
    z = -depth + heights + (1.0 - rock) * 0.022 * marks + rock * (0.30 + 0.13 * bumps + 0.75 * (stones - 1.25))
    zy, zx = np.gradient(z, step)
    normals = np.stack((-zx, -zy, np.ones_like(z)), axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    sand = np.array((0.66, 0.60, 0.46)) * (1.0 + 0.07 * bumps[..., None] + 0.05 * marks[..., None])
    stone = np.array((0.22, 0.23, 0.19)) * (1.0 + 0.30 * bumps[..., None])
    crust = np.array((0.40, 0.26, 0.27))  # coralline algae
    stone = stone + (crust - stone) * np.clip(0.7 * stones - 0.75 + 0.4 * bumps, 0.0, 0.8)[..., None]
    color = sand + (stone - sand) * rock[..., None]

    def height(at_x, at_y):
        column = np.clip(np.rint((np.asarray(at_x) - x[0, 0]) / step).astype(int), 0, samples - 1)
        row = np.clip(np.rint((np.asarray(at_y) - y[0, 0]) / step).astype(int), 0, samples - 1)
        return z[row, column]

    seen = np.ix_(_spread(along, -0.35 * size), _spread(along, 0.0))
    return mesh(np.stack((x, y, z), axis=-1)[seen], normals[seen], color[seen]), height


def _spread(along, middle, fineness=75.0):
    """Numbers of even samples, with steps that grow with the distance from a middle."""
    step, chosen = along[1] - along[0], [0]
    while chosen[-1] < len(along) - 1:
        skip = max(1, int(abs(along[chosen[-1]] - middle) / (fineness * step)))
        chosen.append(min(chosen[-1] + skip, len(along) - 1))
    return np.array(chosen)


def _field(size, samples, reach, smoothness, seed):
    """A periodic random field of unit variance; wavelengths below reach [m] have less power."""
    frequency = np.hypot(np.fft.fftfreq(samples)[:, None], np.fft.rfftfreq(samples)[None]) * samples / size
    strength = (1.0 + (frequency * reach) ** 2) ** (-0.5 * smoothness)
    strength[0, 0] = 0.0
    white = np.random.default_rng(seed).standard_normal((samples, samples))
    field = np.fft.irfft2(np.fft.rfft2(white) * strength, s=white.shape)
    return field / field.std()


def kelp_sites(height, count=130, seed=4, top=-0.8):
    """Sites for Plant Scatter before the camera, in groves, with Species (0 sugar kelp, 1 giant kelp) and Scale.

    height: function of the bed's height [m]; top: largest height of giant kelp [m].
    """
    random = np.random.default_rng(seed)
    groves = ((-6.0, 10.5), (7.0, 12.0), (-12.5, 19.0), (14.0, 20.0), (1.5, 25.0))
    near = ((2.2, 4.7), (3.0, 5.4), (1.9, 6.1), (3.9, 5.9), (2.9, 6.8), (4.9, 7.0), (3.8, 7.9), (5.6, 8.3), (-2.6, 5.2),
            (-3.6, 5.9), (-2.4, 6.7), (-4.5, 7.2), (-3.4, 8.0), (-5.4, 8.6), (-1.3, 9.4), (0.9, 10.4))
    places, species = [(x, y, float(height(x, y))) for x, y in near], [0] * len(near)
    for number in range(count):
        giant = number % 4 == 0
        x, y = np.array(groves[number // 4 % len(groves)]) + random.normal(0.0, 1.7 if giant else 2.6, 2)
        if y < 5.0 or abs(x) < 0.12 * y or (giant and y < 8.0):
            continue  # keep the view free
        places.append((x, y, float(height(x, y))))
        species.append(int(giant))
    places = np.array(places)
    largest = (top - places[:, 2]) / 14.6  # height of giant kelp [m]
    scale = np.where(species, largest * random.uniform(0.75, 1.0, len(places)), random.uniform(0.7, 1.15, len(places)))
    return vertices(places, Species=np.array(species, dtype=np.int32), Scale=scale)


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
        near = centers[random.integers(len(centers), size=count)] + random.normal(0.0, 1.7, (count, 3)) * (1.5, 1.5, 0.6)
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
