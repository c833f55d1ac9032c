# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An abort at any report of progress ends the request there, without a message, and leaves the object usable."""

import os
import sys
import unittest

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
sys.dont_write_bytecode = True

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

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


class Aborts(unittest.TestCase):
    """All classes."""

    def test_each(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
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


unittest.main(verbosity=2)
