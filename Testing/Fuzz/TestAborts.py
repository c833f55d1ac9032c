# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An abort at any report of progress ends the request there, without a message, and leaves the object usable. Reports
come at least five times a second."""

import os
import sys
import time
import unittest

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
sys.dont_write_bytecode = True

from vtkmodules.vtkCommonCore import (  # noqa: E402
    vtkLogger, vtkMinimalStandardRandomSequence, vtkOutputWindow, vtkPoints, vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkPolyData  # noqa: E402

import introspection  # noqa: E402
import littoral  # noqa: E402
import oracle  # noqa: E402
import recipes  # noqa: E402

TIME = 1.5  # [s]
#: What makes the work of a class long enough for reports in the middle of it.
LONGER = {
    "vtkQuadratPointSource": {"SetQuadrats": (300, 300)},
    "vtkTurningBandsTerrainSource": {"SetWholeExtent": (0, 200, 0, 200, 0, 0)},
    "vtkSuspendedParticleSource": {"SetDensity": (0.5,)},
    "vtkParticleFogFilter": {"SetDimensions": (20, 20, 40)},
    "vtkWindFieldSource": {"SetDimensions": (64, 8, 8)},
    "vtkSeaSurfaceFilter": {"SetSectors": (200,), "SetRadius": (200.0,)},
}


LONGEST = 0.2  # from a report to the next [s of the thread]
ENOUGH = 0.5  # of work that goes on, after which it is aborted [s]


class Reports:
    """Counts the reports of progress of an object, and asks for an abort at one of them."""

    def __init__(self, made, at=None):
        self.number = 0
        self.later = 0  # reports after the abort
        self.at = at
        self.observer = made.AddObserver("ProgressEvent", self.hear)

    def hear(self, made, _):
        at_work = 0.0 < made.GetProgress() < 1.0  # VTK's pipeline reports the end of what was ended, too
        self.later += self.at is not None and self.number > self.at and at_work
        if self.number == self.at:
            made.SetAbortExecute(1)
        self.number += 1


def working(name):
    """A working object of its own."""
    made = getattr(littoral, name)()
    for port, other in enumerate(recipes.inputs(name)):
        made.SetInputConnection(port, recipes.source(other).GetOutputPort())
    for method, values in {**recipes.settings(name), **LONGER.get(name, {})}.items():
        getattr(made, method)(*values)
    return made


def ask(made, at=None):
    """Asks for the outputs anew, and aborts at a report; the reports."""
    made.Modified()
    reports = Reports(made, at)
    made.Write() if hasattr(made, "Write") else made.UpdateTimeStep(TIME)
    made.RemoveObserver(reports.observer)
    made.SetAbortExecute(0)
    return reports


def pattern(count, side):
    """Random points in a square."""
    random = vtkMinimalStandardRandomSequence()
    random.Initialize(7)
    points = vtkPoints()
    for _ in range(count):
        points.InsertNextPoint(random.GetNextRangeValue(0.0, side), random.GetNextRangeValue(0.0, side), 0.0)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def verdict_by_g():
    """Fits of g to random points tend to the shortest ranges."""
    made = littoral.vtkPatternVerdictFilter()
    made.SetInputData(pattern(40, 32.0))
    made.SetContrastToFitPairCorrelation()
    made.SetNumberOfSimulations(19)
    return made


def law_of_another():
    """A pattern beside clusters of a thousand times as many points."""
    clusters = littoral.vtkPointProcessSource()
    clusters.SetSize(10.0, 10.0)
    clusters.SetIntensity(1.0)
    clusters.SetClusterScale(0.3)
    law = littoral.vtkPatternVerdictFilter()
    law.SetInputConnection(clusters.GetOutputPort())
    law.SetNumberOfSimulations(19)
    made = littoral.vtkPointPatternStatisticsFilter()
    made.SetInputData(pattern(64, 300.0))
    made.SetInputConnection(2, law.GetOutputPort())
    made.SetNumberOfSimulations(19)
    return made


def many_sites():
    """Sites for which the ground decides."""
    ground = littoral.vtkTurningBandsTerrainSource()
    made = littoral.vtkSitePreferenceFilter()
    made.SetInputData(pattern(100000, 99.0))
    made.SetInputConnection(1, ground.GetOutputPort())
    return made


def longest_silence(made):
    """The longest time between two reports of a request that is aborted when it has taken long enough."""
    for port in range(made.GetNumberOfInputPorts()):
        for index in range(made.GetNumberOfInputConnections(port)):
            made.GetInputAlgorithm(port, index).Update()
    times = [time.thread_time()]

    def hear(algorithm, _):
        times.append(time.thread_time())
        if times[-1] - times[0] > ENOUGH:
            algorithm.SetAbortExecute(1)

    observer = made.AddObserver("ProgressEvent", hear)
    made.Modified()
    made.Write() if hasattr(made, "Write") else made.UpdateTimeStep(TIME)
    made.RemoveObserver(observer)
    times.append(time.thread_time())
    return max(b - a for a, b in zip(times, times[1:]))


class Aborts(unittest.TestCase):
    """All classes."""

    def test_each(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        with_reports = 0
        for name in introspection.all_classes():
            with self.subTest(name):
                fresh = working(name)
                count = ask(fresh).number
                whole = oracle.bytes_of(fresh)
                made = working(name)
                oracle.messages()
                for at in sorted({0, 1, count // 4, count // 2, count - 2} & set(range(count))):
                    reports = ask(made, at)
                    self.assertLessEqual(reports.later, 2, f"reports after an abort at {at} of {count}")
                    self.assertEqual(oracle.messages(), [], f"an abort at {at} of {count}")
                    if at == count // 2:
                        ask(made)
                        self.assertEqual(oracle.bytes_of(made), whole)
                ask(made)
                self.assertEqual(oracle.bytes_of(made), whole)
                with_reports += count > 1
        self.assertGreater(with_reports, 12)

    def test_silence(self):
        silences = {name: longest_silence(working(name)) for name in introspection.all_classes()}
        silences.update({make.__name__: longest_silence(make()) for make in (verdict_by_g, law_of_another, many_sites)})
        print({name: round(silence, 3) for name, silence in silences.items() if silence > 0.05})
        self.assertEqual({}, {name: silence for name, silence in silences.items() if silence > LONGEST})


unittest.main(verbosity=2)
