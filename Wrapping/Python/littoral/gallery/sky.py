# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A sky with fair-weather clouds, as a picture on a dome."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from .. import files
from .colors import mix
from .heights import sampled, smoothstep
from .meshes import grids

#: Radius of the sky [m]. It is drawn behind everything at any distance: a dome beyond the land
#: would move the near plane of the view away from the camera.
SKY = 4000.0


def write_sky(filename, columns=6144, rows=1024, seed=4):
    """A sky with fair-weather clouds as a PNG: azimuth along rows, elevation upwards."""
    clouds = np.pad(_cloud_field(columns // 3, seed), (0, 1), mode="wrap")
    elevation = np.linspace(0.0, 0.5 * np.pi, rows)[:, None]
    azimuth = np.linspace(0.0, 2.0 * np.pi, columns)[None]
    # A few rows at a time: in double precision all of them would take 0.8 GB.
    parts = [_sky_colors(clouds, some, azimuth) for some in np.array_split(elevation, max(1, rows // 32))]
    _write_png(filename, np.concatenate(parts))


def _sky_colors(clouds, elevation, azimuth):
    """Bytes of the sky in some directions."""
    cells = len(clouds) - 1
    reach = 200.0 * np.cos(elevation) / (np.sin(elevation) + 0.06)  # on the layer of clouds
    density = sampled(
        clouds, (1.0, 1.0), (reach * np.sin(azimuth)) % cells, (reach * np.cos(azimuth)) % cells)
    cover = smoothstep(density, 0.45, 2.1) * np.clip((elevation - 0.03) / 0.25, 0.0, 0.92)
    low = np.exp(-3.4 * np.sin(elevation)) * np.ones_like(azimuth)
    blue = mix(np.array((0.26, 0.46, 0.76)), np.array((0.76, 0.85, 0.92)), low)
    shade = 1.0 - 0.22 * np.clip((density - 1.2) / 1.6, 0.0, 1.0)
    color = mix(blue, np.array((1.0, 0.99, 0.97)) * shade[..., None], cover)
    return np.round(255.0 * np.clip(color, 0.0, 1.0)).astype(np.uint8)


def _cloud_field(cells, seed):
    """Periodic noise of unit variance, with clouds of about 150 cells."""
    frequency = np.hypot(np.fft.fftfreq(cells)[:, None], np.fft.rfftfreq(cells)[None])
    frequency[0, 0] = np.inf
    strength = frequency ** -1.6 / np.sqrt(1.0 + (0.006 / frequency) ** 4)
    white = np.random.default_rng(seed).standard_normal((cells, cells))
    field = np.fft.irfft2(np.fft.rfft2(white) * strength, s=white.shape)
    return field / field.std()


def sky_dome(center):
    """The inside of a sphere around a center, with texture coordinates for `write_sky`."""
    elevation = np.linspace(-0.05, 0.5 * np.pi, 40)[:, None]
    azimuth = np.linspace(0.0, 2.0 * np.pi, 121)[None]
    away = np.stack(np.broadcast_arrays(
        np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth),
        np.sin(elevation)), axis=-1)
    dome = grids((SKY * away + np.asarray(center), np.zeros(away.shape, np.uint8)))
    upwards = 0.998 * np.clip(elevation / (0.5 * np.pi), 0.001, 1.0)
    places = np.stack(np.broadcast_arrays(azimuth / (2.0 * np.pi), upwards), axis=-1)
    array = numpy_to_vtk(places.reshape(-1, 2).astype(np.float32), deep=True)
    array.SetName("TCoords")
    dome.GetPointData().SetTCoords(array)
    return dome


def _write_png(filename, pixels):
    """Bytes [row, column, channel], the lowest row first, as a PNG."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    files.write(writer, filename)
