# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the files of Examples/Data for the lists of the guide hold, and how those that are made are made."""
import os

import numpy as np
from ocean_files import regular

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Data")

#: Place of the buoy [degrees]; hours of the current.
BUOY = (-78.485, 28.878)
HOURS = np.arange(25)
SET, TIDE, PERIOD = 0.1, 0.2, 12.42 * 3600.0  # m/s, m/s, s


def current(t):
    """Velocity eastwards and northwards [m/s] on the map about the buoy at a time [s]."""
    return TIDE * np.cos(2.0 * np.pi * t / PERIOD), SET + TIDE * np.sin(2.0 * np.pi * t / PERIOD)


def write_current(path):
    """The current on axes of longitude and latitude about the buoy."""
    def flow(x, y, z, t):
        u, v = current(t)
        return u + 0.0 * x, v + 0.0 * y

    lons, lats = (np.round(middle + 0.1 * np.arange(-2, 3), 3) for middle in BUOY)
    regular(path, flow, BUOY, lons, lats, 3600.0 * HOURS, kind="f4")


def drift(hours):
    """Way eastwards and northwards [m] of what drifts for some hours in the current, which is linear between hours."""
    velocities = np.array([current(3600.0 * hour) for hour in HOURS[:hours + 1]])
    return 3600.0 * (velocities[:-1] + velocities[1:]).sum(axis=0) / 2.0


def write_plot(path):
    """A made-up plot of 50 m by 50 m: oaks and birches on a loose grid, as many and as thick as in a grown wood."""
    random = np.random.default_rng(41010)
    with open(path, "w", encoding="utf-8") as table:
        table.write("x,y,species,dbh\n")
        for x in range(10):
            for y in range(10):
                place = 5.0 * np.array([x, y]) + random.uniform(0.5, 4.5, 2)
                oak = random.random() < 0.7
                dbh = random.normal(31.0, 6.0) if oak else random.normal(22.0, 4.0)
                table.write(f"{place[0]:.1f},{place[1]:.1f},{'oak' if oak else 'birch'},{dbh:.1f}\n")


if __name__ == "__main__":
    write_current(os.path.join(DATA, "sea", "current.nc"))
    write_plot(os.path.join(DATA, "stand", "plot.csv"))
