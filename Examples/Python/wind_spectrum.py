# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measured spectra of a wind field against those of its model.

    python3 wind_spectrum.py [FOLDER]     writes wind_spectrum.png into FOLDER
"""

import os
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import vtkWindFieldSource
from littoral.chart import save_spectrum_chart
from littoral.tables import table_of

COMPONENTS = ("along", "across", "up")


def model_spectra(frequency, height, friction, roughness):
    """Densities of the three components [m2/s2/Hz] in the neutral surface layer."""
    mean = friction / 0.4 * np.log(height / roughness)
    nu = frequency * height / mean
    unit = friction**2 * height / mean
    return {"along": unit * 200.0 / (1.0 + 50.0 * nu)**(5.0 / 3.0),
            "across": unit * 15.0 / (1.0 + 9.5 * nu)**(5.0 / 3.0),
            "up": unit * 3.36 / (1.0 + 10.0 * nu**(5.0 / 3.0))}


def main(folder):
    """Make a wind of five minutes, and compare its spectra with the model."""
    source = vtkWindFieldSource()
    source.SetDimensions(6000, 16, 16)
    source.SetTimeStep(0.05)
    source.SetLateralSpacing(2.0)
    source.Update()
    image = source.GetOutput()
    period = image.GetFieldData().GetArray("Period").GetValue(0)
    friction = image.GetFieldData().GetArray("FrictionVelocity").GetValue(0)
    size = image.GetDimensions()
    velocity = vtk_to_numpy(image.GetPointData().GetArray("Velocity"))
    velocity = velocity.reshape(size[2], size[1], size[0], 3)
    heights = image.GetOrigin()[2] + image.GetSpacing()[2] * np.arange(size[2])

    # Taylor's hypothesis: along x the field is a time series, reversed.
    waves = np.fft.rfft(velocity, axis=2)[:, :, 1:-1]
    density = (2.0 * period / size[0]**2 * np.abs(waves)**2).mean(axis=(0, 1))
    frequency = np.arange(1, density.shape[0] + 1) / period
    models = [model_spectra(frequency, z, friction, source.GetRoughnessLength()) for z in heights]

    edges = np.geomspace(frequency[0], frequency[-1], 31)
    bands = np.digitize(frequency, edges)

    def in_bands(values):
        return np.array([values[bands == band].mean() for band in np.unique(bands)])

    columns = {"Frequency": in_bands(frequency)}
    for k, name in enumerate(COMPONENTS):
        columns[name] = in_bands(density[:, k])
        columns[f"{name} model"] = in_bands(np.mean([model[name] for model in models], axis=0))
        error = 10.0 * np.log10(columns[name] / columns[f"{name} model"])
        fast = np.abs(error[columns["Frequency"] > 0.2]).max()
        print(f"{name}: above 0.2 Hz within {fast:.2f} dB of the model")
        assert fast < 0.5
    os.makedirs(folder, exist_ok=True)
    save_spectrum_chart(os.path.join(folder, "wind_spectrum.png"), table_of(columns), COMPONENTS)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-"))
