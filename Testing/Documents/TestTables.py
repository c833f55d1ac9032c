# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the guide that are closed forms: the numbers of the pages against the formulas, by another quadrature."""

import re
import unittest
from pathlib import Path

import numpy as np

GUIDE = Path(__file__).resolve().parents[2] / "Documentation" / "guide"


def rows_of(page, head):
    """Rows of the table whose first line begins with the head: the first cell, and the numbers of the others."""
    text = (GUIDE / page).read_text(encoding="utf-8")
    lines = text[text.index("\n| " + head):].splitlines()[3:]
    rows = [line.strip("| ").split(" | ") for line in lines[:[not line.startswith("|") for line in lines].index(True)]]
    return [(cells[0], [[float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", cell)] for cell in cells[1:]])
            for cells in rows]


def integral(values, x):
    return np.sum(0.5 * (values[..., 1:] + values[..., :-1]) * np.diff(x), axis=-1)


def bessel_k(order, x):
    """K_n(x), the integral of exp(-x cosh t) cosh(n t)."""
    t = np.linspace(0.0, 12.0, 1201)
    return integral(np.exp(-np.outer(x, np.cosh(t))) * np.cosh(order * t), t)


class Terrain(unittest.TestCase):
    def test_lines(self):
        # C(x) of a line of the exponential model: the cosine transform of w / (1 + w^2)^(3/2).
        angles = np.linspace(0.0, 0.5 * np.pi, 1001)
        x = np.concatenate([np.linspace(0.0, 4.0, 401), np.linspace(4.05, 40.0, 720)])
        line = 1.0 - x * integral(np.exp(-np.outer(x, np.cos(angles))), angles)
        distances = np.linspace(0.0, 40.0, 401)
        for name, cells in rows_of("terrain.md", "lines |"):
            turns = np.pi / int(name) * (np.arange(int(name)) + np.linspace(0.0, 0.5, 9)[:, None])
            sums = [np.interp(np.abs(np.multiply.outer(distances, np.cos(turn))), x, line).mean(axis=1) for turn in turns]
            worst = np.abs(np.array(sums) - np.exp(-distances)).max(axis=0)
            for (error,), reach in zip(cells, (5.0, 20.0, 40.0)):
                self.assertAlmostEqual(worst[distances <= reach].max(), error, delta=1e-4 if error < 5e-4 else 6e-4)

    def test_distances_of_small_correlation(self):
        r = np.linspace(0.001, 4.5, 4500)
        correlations = {
            "Simple Exponential": np.exp(-r), "Double Exponential": np.exp(-r * r), "Bessel 1": r * bessel_k(1, r),
            "Bessel 2": r * bessel_k(1, r) - 0.5 * r * r * bessel_k(0, r),
            "Telis": (bessel_k(0, r) - bessel_k(0, 10.0 * r)) / np.log(10.0),
            "Spherical": np.where(r < 1.0, 1.0 - 1.5 * r + 0.5 * r ** 3, 0.0)}
        found = {name: cells[-1] for name, cells in rows_of("terrain.md", "model | near zero")}
        for name, correlation in correlations.items():
            self.assertAlmostEqual(r[np.argmax(correlation < 0.05)], found[name][0], delta=0.05, msg=name)
        least = correlations["Bessel 2"].argmin()
        self.assertAlmostEqual(correlations["Bessel 2"][least], found["Bessel 2"][1], delta=0.005)
        self.assertAlmostEqual(r[least], found["Bessel 2"][2], delta=0.05)

    def test_truncated_spectrum(self):
        # Semivariance between neighbours of an exponential field of 10 cells that ends at a wavelength, over the model's.
        x = np.linspace(0.0, np.pi, 401)
        for wavelength, part in ((2.0, 0.65), (4.0, 0.37)):
            w = np.linspace(0.0, 2.0 * np.pi / wavelength, 4001)
            power = 100.0 * w * (1.0 + 100.0 * w * w) ** -1.5
            bessel_j0 = integral(np.cos(np.outer(w, np.sin(x))), x) / np.pi
            semivariance = integral(power * (1.0 - bessel_j0), w) / integral(power, w)
            self.assertAlmostEqual(semivariance / (1.0 - np.exp(-0.1)), part, delta=0.005)

    def test_images_of_the_spline(self):
        # The transform of the B-spline of order 4 at waves of four nodes: power at the images, of the whole.
        x = 0.25 * np.pi + np.pi * np.arange(-50, 51)
        power = np.sinc(x / np.pi) ** 8
        self.assertAlmostEqual(1.0 - power[50] / power.sum(), 1.55e-4, delta=1e-6)


class Wind(unittest.TestCase):
    def test_variance_between_grid_points(self):
        # Parts of the spectra up to the Nyquist frequency that the mean of two neighbours keeps.
        speed = [10.0 * np.log(z / 0.03) / np.log(10.0 / 0.03) for z in (2.0, 10.0, 40.0)]
        for name, cells in rows_of("wind.md", "spacing |"):
            spacing = float(name.split()[0])
            step = spacing / 10.0 if "along" in name else 0.1
            frequency = np.geomspace(1e-7, 0.5 / step, 4001)
            for values, z, mean in zip(cells, (2.0, 10.0, 40.0), speed):
                n = frequency * z / mean
                spectra = ((1.0 + 50.0 * n) ** (-5.0 / 3.0), (1.0 + 9.5 * n) ** (-5.0 / 3.0),
                           1.0 / (1.0 + 10.0 * n ** (5.0 / 3.0)))
                for value, spectrum, decay in zip(values, spectra, (10.0, 10.0, 8.0)):
                    kept = (np.cos(np.pi * frequency * step) ** 2 if "along" in name
                            else 0.5 + 0.5 * np.exp(-frequency * decay * spacing / 10.0))
                    part = integral(spectrum * kept, frequency) / integral(spectrum, frequency)
                    self.assertAlmostEqual(part, value, delta=0.0051, msg=f"{name}, {z} m")


if __name__ == "__main__":
    unittest.main()
