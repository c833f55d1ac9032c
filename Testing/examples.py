# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources and filters of which rows of classes make inputs, in ParaView or in VTK alone."""

import math
import tempfile

import classes


class Examples:
    """Functions of `proxies`, which are paraview.simple or those of vtk_proxies.py, and some inputs made by them."""

    SMALL_WIND = dict(Dimensions=[100, 16, 8])

    def __init__(self, proxies):
        self.proxies = proxies

    def __getattr__(self, name):
        return getattr(self.proxies, name)

    def tree(self):
        return self.ReevesTree(Preset="Custom", NumberOfLeaves=100, MainBranches=8, SideBranches=4)

    def sites(self):
        return self.QuadratPoints(Size=[50.0, 50.0], Quadrats=[5, 5])

    def particles(self):
        return self.SuspendedParticles(Density=0.1)

    def image(self):
        return self.Wavelet()

    def blocks(self):
        return self.GroupDatasets(Input=self.Sphere())

    def table(self, lines):
        """An opened table of these lines."""
        with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
            file.write("\n".join(lines) + "\n")
        return self.CSVReader(FileName=[file.name])

    def inventory(self, head="x,y,species,dbh"):
        """Twenty oaks."""
        return self.table([head, *(f"{5 * (k % 5)},{6 * (k // 5)},oak,{20 + k}" for k in range(20))])

    def many_trees(self):
        """400 oaks, maples and pines."""
        lines = ["x,y,species,dbh"]
        for k in range(400):
            x, y = 5.0 * (k % 20) + 2.0 * math.sin(9.1 * k), 5.0 * (k // 20) + 2.0 * math.cos(7.7 * k)
            species = ("oak", "sugar maple", "loblolly pine")[k % 3]
            lines.append(f"{x:.1f},{y:.1f},{species},{25 + 15 * math.sin(k):.1f}")
        return self.table(lines)

    def measured_spectrum(self):
        """A spectrum as of a buoy, S = 1e-4 f^-5 exp(-(0.1 / f)^4) [m^2 / Hz]."""
        lines = ["Frequency,Density"]
        for k in range(5, 60):
            f = 0.01 * k
            lines.append(f"{f:.2f},{1e-4 * f ** -5 * math.exp(-((0.1 / f) ** 4)):.6g}")
        return self.table(lines)

    def output(self, name, make):
        """What feeds a class: an object that is made by a row, or another output of it."""
        other, port, settings = classes.OTHER_OUTPUTS.get(name, (name, 0, {}))
        made = make(classes.BY_NAME[other])
        for method, given in settings.items():
            setattr(made, method[3:], given[0])
        return self.OutputPort(made, port) if port else made

    def shown_inputs(self, entry):
        """Usual inputs of an entry, by the names of their properties. A source has none."""
        for row in classes.ROWS:
            for own in row.entries:
                if own.proxy == entry:
                    if entry in row.shown:
                        return row.shown[entry](self)
                    return {own.ports[port]: self.output(name, lambda other: getattr(self, other.entries[0].proxy)())
                            for port, name in enumerate(row.fed_by) if port in own.ports}
        return {}

    def small_example(self, name):
        """The small example of a class, by its row."""
        row = classes.BY_NAME[name]
        entry = row.entries[0]
        feeders = {entry.ports[port]: self.output(other, lambda row: self.small_example(row.name))
                   for port, other in enumerate(row.fed_by)}
        values = {method[3:]: given[0] if len(given) == 1 else list(given) for method, given in row.small.items()}
        return getattr(self, entry.proxy)(**feeders, **values)
