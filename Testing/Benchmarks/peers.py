# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Other tools at the same work, timed in the same run on one thread: NumPy in this process, packages of R where they are
installed (Debian: r-cran-randomfields, r-cran-spatstat.random, r-cran-spatstat.explore)."""

import collections
import os
import shutil
import subprocess
import time

R_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "peers.R")


def least(work, runs):
    """The least time of some runs [ms]."""
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - begin))
    return min(times)


def variogram(side=1024, classes=40, directions=12):
    """Mean squared differences by class of distance and direction, by transforms of a padded grid."""
    import numpy as np

    heights = np.random.default_rng(1).standard_normal((side, side))
    padded, half = (2 * side, 2 * side), side // 2
    z, squares, mask = (np.fft.rfft2(grid, padded) for grid in (heights, heights**2, np.ones_like(heights)))
    sums = np.fft.irfft2(2.0 * (squares * mask.conj()).real - 2.0 * np.abs(z)**2, padded)
    pairs = np.fft.irfft2(np.abs(mask)**2, padded)
    rows, columns = np.arange(half + 1), np.r_[0:half + 1, -half:0]
    lags = np.ix_(rows, columns)
    x, y = np.meshgrid(columns, rows)
    ring = np.minimum((np.sqrt(np.hypot(x, y) / half) * classes).astype(int), classes)
    sector = (np.arctan2(y, x) * directions / np.pi).astype(int) % directions
    bins = (ring * directions + sector).ravel()
    return np.bincount(bins, sums[lags].ravel()) / np.maximum(np.bincount(bins, pairs[lags].ravel()), 1.0)


def wind(steps=12000, across=32, up=32, part=500):
    """A field of white spectra: two transforms across for each frequency, padded to twice the size, and one in time."""
    import numpy as np

    random = np.random.default_rng(1)
    field = np.empty((steps, across, up, 3), np.float32)
    for component in range(3):
        spectrum = np.empty((steps // 2 + 1, across, up), complex)
        for begin in range(0, len(spectrum), part):
            shape = len(spectrum[begin:begin + part]), 2 * across, 2 * up
            drawn = random.standard_normal(shape) + 1j * random.standard_normal(shape)
            spectrum[begin:begin + part] = np.fft.ifft2(drawn)[:, :across, :up]
        field[..., component] = np.fft.irfft(spectrum, steps, axis=0)
    return field


#: Work, the benchmark that does it here (program, name), the tool that does it there: a package of R, or a function.
Peer = collections.namedtuple("Peer", "work program name tool package by")
PEERS = (
    Peer("turning bands, 1024 x 1024, 64 lines", "bench_terrain", "GrowTerrain/1/64/real_time",
         "RandomFields, RPtbm of RMexp", "RandomFields", None),
    Peer("a million points in clusters", "vtkbench_quadrats",
         "ScatterPoints/mode:0/size:1000000/law:2/process_time/real_time", "spatstat, rMatClust", "spatstat", None),
    Peer("a million points of a Thomas process", "vtkbench_quadrats",
         "DrawProcess/process:1/size:1048576/process_time/real_time", "spatstat, rThomas", "spatstat Thomas", None),
    Peer("g of 10 000 points", "vtkbench_quadrats", "MeasurePairs/size:10000/process_time/real_time",
         "spatstat, pcf", "spatstat pcf", None),
    Peer("variogram, 1024 x 1024, lags to half the side", "bench_terrain",
         "MeasureVariogram/threads:1/size:1048576/real_time", "NumPy, five real transforms", None, variogram),
    Peer("wind, 12000 x 32 x 32 x 3", "bench_wind", "LargeField/iterations:3",
         "NumPy, normal numbers and transforms, without coherence", None, wind))


def in_r():
    """Times of R's packages by name [ms], and why there are none, if so."""
    if not shutil.which("Rscript"):
        return {}, "R is not installed."
    ran = subprocess.run(["Rscript", R_SCRIPT], capture_output=True, text=True, check=False)
    lines = [line.split(",") for line in ran.stdout.splitlines() if line.count(",") == 1]
    times = {name: float(value) for name, value in lines}
    missing = [name for name in ("RandomFields", "spatstat") if name not in times]
    return times, f"R has no {' and no '.join(missing)}." if missing else ""


def measure(results):
    """Peers of the benchmarks that were run with their times [ms], and a sentence about those that are not there."""
    ran = {(result.program, result.name) for result in results}
    wanted = [peer for peer in PEERS if (peer.program, peer.name) in ran]
    times, silence = in_r() if any(peer.package for peer in wanted) else ({}, "")
    measured = []
    for peer in wanted:
        if peer.package in times:
            measured.append((peer, times[peer.package]))
        elif peer.by:
            measured.append((peer, least(peer.by, 3)))
    return measured, silence
