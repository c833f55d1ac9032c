# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the charts of the user guide as ParaView shows them.

    ./littoral run pvbatch Documentation/pictures/make_charts.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

from littoral.elevation import read_elevation, write_vti
from paraview import simple

SIZE = [640, 420]  # pixels


def draw(folder, name, source, port, kind="XYChartView"):
    """Write a chart of an output, as it comes up."""
    view = simple.CreateView(kind)
    view.ViewSize = SIZE
    simple.Show(simple.OutputPort(source, port), view)
    simple.Render(view)
    simple.SaveScreenshot(os.path.join(folder, f"chart-{name}.jpg"), view, ImageResolution=SIZE, Quality=85)


def main(folder):
    """Draw the charts of Covariance Fit, Quadrat Analysis, Wind Statistics and Sea Statistics."""
    path = os.path.join(folder, "place.vti")
    write_vti(read_elevation(), path)
    place = simple.OpenDataFile(path)
    draw(folder, "variogram", simple.CovarianceFit(Input=place), 1)
    os.remove(path)
    points = simple.QuadratPoints(Quadrats=[30, 20], Law="Negative Binomial", MeanPerQuadrat=2.0)
    draw(folder, "quadrats", simple.QuadratAnalysis(Input=points), 1, "XYBarChartView")
    wind = simple.WindStatistics(Input=simple.WindField())
    for port, name in enumerate(("spectrum", "coherence", "profile")):
        draw(folder, f"wind-{name}", wind, port)
    sea = simple.SeaStatistics(Input=simple.SeaState(NumberOfTrains=60))
    for port, name in enumerate(("spectrum", "directions")):
        draw(folder, f"sea-{name}", sea, port)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
