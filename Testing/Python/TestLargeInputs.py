# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes whose inputs take more memory than the limits leave say so, with how much; splines of currents take as much."""

import ctypes
import re
import resource
import unittest

import littoral
import numpy
from littoral import errors
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLogger, vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkStructuredGrid

LEFT = 18  # of address space [MiB]


def on_points(data, values):
    """Data with values as scalars."""
    array = numpy_to_vtk(values, deep=True)
    array.SetName("Velocity")
    data.GetPointData().SetScalars(array)
    return data


def placed(data, places):
    """Data at places."""
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    return data


def image(x, y, z, components, kind, land=0.0):
    """An image, a share of whose points is land."""
    data, values = vtkImageData(), numpy.ones((x * y * z, components), kind)
    data.SetDimensions(x, y, z)
    if land:
        values[:int(land * len(values))] = numpy.nan
    return on_points(data, values)


def scattered(count):
    """Points without cells."""
    return placed(vtkPolyData(), numpy.random.default_rng(1).uniform(0.0, 99.0, (count, 3)))


def curved(x, y, z):
    """A current on a grid of any form."""
    data = vtkStructuredGrid()
    data.SetDimensions(x, y, z)
    places = numpy.indices((z, y, x), "f4").reshape(3, -1)[::-1].T
    return on_points(placed(data, numpy.ascontiguousarray(places)), numpy.ones((x * y * z, 3)))


def made(name, *inputs, **settings):
    """An algorithm with inputs and settings."""
    algorithm = getattr(littoral, name)()
    for port, data in enumerate(inputs):
        if data:
            algorithm.SetInputData(port, data)
    for setter, value in settings.items():
        getattr(algorithm, "Set" + setter)(value)
    return algorithm


def drift(current, interpolation=1):
    """One point in a current."""
    return made("vtkCurrentDriftFilter", scattered(1), current, VelocityInterpolation=interpolation)


def act(algorithm, left=None):
    """Updates an algorithm or writes its file, with so much memory left [MiB], and returns what it says."""
    said, before = errors.kept(algorithm), resource.getrlimit(resource.RLIMIT_AS)
    algorithm.Modified()
    if left:
        with open("/proc/self/statm", encoding="ascii") as file:
            used = int(file.read().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (used + (left << 20), before[1]))
    (algorithm.Write if hasattr(algorithm, "Write") else algorithm.Update)()
    resource.setrlimit(resource.RLIMIT_AS, before)
    return " ".join(said)


def memory(line):
    """Memory of the process by a line of its status [MiB]."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(float(text.split()[1]) for text in file if text.startswith(line)) / 1024


def growth(algorithm):
    """What an update takes at most [MiB]."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")  # the peak begins anew
    begin = memory("VmRSS")
    act(algorithm)
    return memory("VmHWM") - begin


class LargeInputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        vtkSMPTools.SetBackend("Sequential")  # a thread has a stack
        ctypes.CDLL(None).mallopt(-3, 100000)  # M_MMAP_THRESHOLD: what is freed is gone, and each peak its own
        act(drift(image(9, 9, 9, 3, "f8")))

    def refused(self, algorithm):
        """The message of an algorithm that has too little memory."""
        said = act(algorithm, LEFT)
        self.assertRegex(said, "needs [0-9.]+ [MG]iB of memory, and [0-9.]+ MiB are free: ")
        return said

    def test_splines(self):
        """Coefficients, what continues the water on land, and the solvers of a long axis."""
        for form in (100, 100, 100, 3, "f8"), (100, 100, 100, 3, "f8", 0.3), (100, 100, 100, 3, "f4", 0.95), \
                (50000, 2, 1, 3, "f8"):
            with self.subTest(form):
                algorithm = drift(image(*form))
                asked = float(re.search("spline of a current needs ([0-9.]+) MiB", self.refused(algorithm))[1])
                grown = growth(algorithm)
                self.assertLess(grown, 1.05 * asked + 3.0)
                self.assertGreater(grown, 0.7 * asked)  # lists of land double

    def test_inputs(self):
        """Copies and lists as long as an input, and what finds cells."""
        for make in (lambda: drift(curved(70, 70, 70)),
                     lambda: drift(image(100, 100, 100, 3, "i4"), 0),
                     lambda: made("vtkPointProcessSource", None, image(1600, 1500, 1, 1, "f4")),
                     lambda: made("vtkConditionalTerrainFilter", on_points(scattered(20), numpy.arange(20.0)),
                                  image(1600, 1500, 1, 1, "f4"), KrigingType=4, Model=0),
                     lambda: made("vtkPatternVerdictFilter", scattered(1200000)),
                     lambda: made("vtkPointPatternStatisticsFilter", scattered(1200000)),
                     lambda: made("vtkSitePreferenceFilter", scattered(100000), image(100, 100, 1, 1, "f4"))):
            self.refused(make())

    @unittest.skipUnless(hasattr(littoral, "vtkVDBVolumeWriter"), "there is no OpenVDB")
    def test_volume(self):
        """A copy in single precision."""
        self.refused(made("vtkVDBVolumeWriter", image(170, 170, 170, 1, "f8"), FileName="/dev/null"))


if __name__ == "__main__":
    unittest.main()
