# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Functions of five measured patterns against spatstat, which brings the patterns: within 1 %.

Skipped where R or spatstat is not installed. Where there are hardly any pairs a function is
nearly 0: the difference is taken relative to the larger of the value and a tenth of that of a
random pattern. F is measured by both from a grid of places.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from littoral import vtkPatternVerdictFilter
from littoral import vtkPointPatternStatisticsFilter as Statistics

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "TestPatternsAgainstSpatstat.R")
CORRECTIONS = {"border": Statistics.Border, "isotropic": Statistics.Isotropic, "translate": Statistics.Translation,
               "rs": Statistics.ReducedSample, "km": Statistics.KaplanMeier}
COLUMNS = {"K": "K", "L": "L", "g": "PairCorrelation", "exact": "PairCorrelation", "m": "MarkCorrelation",
           "G": "NearestNeighbor", "F": "EmptySpace", "J": "J", "crossK": "CrossK", "crossg": "CrossPairCorrelation"}
TOLERANCE = 0.01
EXACT = 1e-9


def read(filename):
    """A CSV file as a dictionary of columns, texts where they are no numbers."""
    table = np.genfromtxt(filename, delimiter=",", names=True, dtype=None, encoding="utf-8",
                          deletechars="", autostrip=True)
    return {name: table[name] for name in table.dtype.names}


def points_of(table):
    """The points of a table, with its other columns as arrays."""
    points = vtkPoints()
    positions = np.column_stack([table["x"], table["y"], np.zeros(len(table["x"]))])
    points.SetData(numpy_to_vtk(positions, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    if "DBH" in table:
        array = numpy_to_vtk(table["DBH"].astype(float), deep=True)
        array.SetName("DBH")
        data.GetPointData().AddArray(array)
    if "Species" in table:
        array = vtkStringArray()
        array.SetName("Species")
        for text in table["Species"]:
            array.InsertNextValue(str(text))
        data.GetPointData().AddArray(array)
    return data


def make(table, box, largest):
    """A filter without simulations."""
    statistics = Statistics()
    statistics.SetInputData(points_of(table))
    statistics.SetOrigin(box[0], box[2])
    statistics.SetSize(box[1] - box[0], box[3] - box[2])
    statistics.SetNumberOfSimulations(0)
    statistics.SetNumberOfSteps(512)
    statistics.SetMaximumDistance(largest)
    if "DBH" in table:
        statistics.SetMarkArray("DBH")
    if "Species" in table:
        statistics.AllowCoincidentPointsOn()  # two of Lansing Woods' trees
        statistics.SetSpeciesArray("Species")
        statistics.SetFirstSpecies("maple")
        statistics.SetSecondSpecies("hickory")
    return statistics


def column(statistics, name):
    return vtk_to_numpy(statistics.GetOutput(2).GetColumnByName(name))


def verdict_of(table, box, degree=0):
    """The table of verdicts on the points of a table."""
    verdict = vtkPatternVerdictFilter()
    verdict.SetInputData(points_of(table))
    verdict.SetOrigin(box[0], box[2])
    verdict.SetSize(box[1] - box[0], box[3] - box[2])
    verdict.SetNumberOfSimulations(19)
    verdict.SetTrendDegree(degree)
    verdict.Update()
    return verdict.GetOutput()


def fitted(laws, process, names):
    """Parameters of a process of a table of verdicts."""
    rows = [row for row in range(laws.GetNumberOfRows()) if laws.GetValueByName(row, "Law").ToString() == process]
    return np.array([laws.GetValueByName(rows[0], name).ToDouble() for name in names])


def compare(pattern, found, statistics):
    """The largest differences of all columns."""
    r = found["r"]
    half_width = 0.15 / np.sqrt(statistics.GetOutput(0).GetFieldData().GetArray("Intensity").GetValue(0))
    for name in found:
        if name == "r":
            continue
        function, correction = name.split(".")
        if correction in ("rs", "km"):
            statistics.SetDistanceCorrection(CORRECTIONS[correction])
        else:
            statistics.SetEdgeCorrection(CORRECTIONS[correction])
        statistics.Update()
        theirs = found[name].astype(float)
        ours = column(statistics, COLUMNS[function])
        chance = {"K": np.pi * r ** 2, "crossK": np.pi * r ** 2, "L": r}.get(function, np.ones(len(r)))
        scale = np.maximum(np.abs(theirs), 0.1 * chance)
        # g of small distances: the estimate divides by r a kernel that is cut off at 0.
        least = half_width if function in ("g", "exact", "crossg") else r[-1] / 50
        good = np.isfinite(theirs) & (r > least)
        if function == "J":
            good &= column(statistics, "EmptySpace") < 0.9
        assert np.all(np.isfinite(ours[good])), f"{pattern} {name}: no value"
        differences = np.abs(ours - theirs)[good] / scale[good]
        tolerance = EXACT if function == "exact" else TOLERANCE
        print(f"{pattern} {name}: {differences.max():.2e} of {np.count_nonzero(good)} values", flush=True)
        worst = r[good][differences.argmax()]
        assert differences.max() < tolerance, f"{pattern} {name}: off at r = {worst}"


if not shutil.which("Rscript") or subprocess.run(
        ["Rscript", "-e", "quit(status = !requireNamespace('spatstat', quietly = TRUE))"], check=False).returncode:
    print("skipped: R with spatstat is not installed")
    sys.exit(125)

trends = []
with tempfile.TemporaryDirectory() as folder:
    lines = subprocess.run(["Rscript", SCRIPT, folder], check=True, stdout=subprocess.PIPE,
                           encoding="utf-8").stdout
    for line in lines.splitlines():
        words = line.split()
        name, numbers = words[0], [float(word) for word in words[1:] if words[0] != "trend"]
        if name == "published":
            # The mark correlation of the pines' diameters, as spatstat's users know it.
            table = read(os.path.join(folder, "longleaf.csv"))
            statistics = make(table, (0.0, 200.0, 0.0, 200.0), numbers[-1])
            statistics.SetEdgeCorrection(Statistics.Translation)
            statistics.Update()
            values = np.interp([2.0, 5.0, 10.0, 20.0], column(statistics, "Distance"),
                               column(statistics, "MarkCorrelation"))
            print("longleaf, mark correlation of DBH at 2, 5, 10, 20 m:", values.round(4))
            assert np.allclose(values, [0.452, 0.627, 0.814, 0.949], rtol=TOLERANCE)
            assert np.allclose(values, numbers[:4], rtol=TOLERANCE)
            continue
        if name == "redwood-as-thomas":
            laws = verdict_of(read(os.path.join(folder, "redwood.csv")), (0.0, 1.0, -1.0, 0.0))
            intensity, scale, size = fitted(laws, "Thomas", ("Intensity", "ClusterScale", "ClusterSize"))
            ours = [intensity / size, scale, size]
            print("redwood as Thomas: kappa, sigma, mu:", np.round(ours, 4), "spatstat:", numbers)
            assert np.allclose(ours, numbers, rtol=0.02)
            assert np.allclose(ours, [23.55, 0.0470, 2.633], rtol=0.02)
            continue
        if name == "trend":
            trends.append(words[1])
            table = read(os.path.join(folder, f"{words[1]}-trend.csv"))
            box, degree = [float(word) for word in words[2:6]], trends.count(words[1])
            trended = verdict_of(table, box, degree)
            per_area = len(table["x"]) / ((box[1] - box[0]) * (box[3] - box[2]))
            thomas, discs = (fitted(trended, process, ("ClusterSize", "ClusterScale"))
                             for process in ("Thomas", "MaternCluster"))
            cox = fitted(trended, "LogGaussianCox", ("Variance", "Range"))
            ours = np.array([per_area / thomas[0], thomas[1], per_area / discs[0], discs[1], *cox])
            numbers = np.array(words[6:], dtype=float)
            there = np.isfinite(ours)  # no Cox process whose range is far below the mean distance
            assert there[:4].all(), ours
            differences = np.abs(ours / numbers[:6] - 1.0)[there]
            print(f"{words[1]}, trend of degree {degree}: parameters within {differences.max():.1e}, kappa by spatstat's "
                  f"own normalisation {numbers[6] / ours[0] - 1.0:.3f} more")
            assert differences.max() < 1e-3
            assert abs(numbers[6] / ours[0] - 1.0) < 0.07
            continue
        if name == "longleaf-trend":
            trended = verdict_of(read(os.path.join(folder, "longleaf.csv")), (0.0, 200.0, 0.0, 200.0), 2)
            trend = vtk_to_numpy(trended.GetFieldData().GetArray("Trend"))
            y, x = np.meshgrid([-0.9, -0.3, 0.3, 0.9], [-0.9, -0.3, 0.3, 0.9], indexing="ij")
            ours = np.exp(trend @ [np.ones(16), x.ravel(), y.ravel(), x.ravel() ** 2, (x * y).ravel(), y.ravel() ** 2])
            print(f"longleaf, trend: within {np.abs(ours / numbers - 1.0).max():.2e}")
            assert np.allclose(ours, numbers, rtol=TOLERANCE)
            continue
        table = read(os.path.join(folder, f"{name}.csv"))
        for kind in ("pairs", "nearest"):
            found = read(os.path.join(folder, f"{name}-{kind}.csv"))
            statistics = make(table, numbers, found["r"][-1])
            statistics.Update()
            compare(name, found, statistics)
