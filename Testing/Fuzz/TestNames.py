# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=--few
# run-with: python3 tier=all
"""A property that is refused is named: each number of each class at odd values, alone and with each switch turned. One
that refuses anything refuses magnitudes below 1e-30 and above 1e15.

    python3 TestNames.py [--few]     --few: fewer odd values
"""

import os
import re
import sys
import tempfile
import unittest

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
sys.dont_write_bytecode = True

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

import introspection  # noqa: E402
import littoral  # noqa: E402
import oracle  # noqa: E402
import recipes  # noqa: E402

INF, NAN = float("inf"), float("nan")
BEYOND = [1e-320, 1e-31, 1e16]  # not 5e-324, which is 0 rad in degrees
ODD = {"double": [0.0, -1.0, *BEYOND, 5e-324, 1e-300, -1e-300, -1e16, 1e300, -1e300, INF, -INF, NAN],
       "int": [0, -1, 2147483647, -2147483648]}
FEW = {"double": [-1.0, *BEYOND, 1e300, NAN], "int": [-1]}
# Parts of a vector vanish beside the others; heights and the value of what is missing are only compared.
ANY_MAGNITUDE = {"SetViewPoint", "SetViewDirection", "SetViewUp", "SetHeightRange", "SetNoDataValue"}
QUICK = "--few" in sys.argv
SWITCHED = {"double": [NAN], "int": [-1]} if QUICK else FEW


def working(name):
    """A working object of its own, whose accepted updates end at once."""
    made = getattr(littoral, name)()
    for port, other in enumerate(recipes.inputs(name)):
        made.SetInputConnection(port, recipes.source(other).GetOutputPort())
    for method, values in recipes.settings(name).items():
        getattr(made, method)(*values)
    made.AddObserver("ProgressEvent", lambda algorithm, _: algorithm.SetAbortExecute(1))
    return made


def give(made, setter, values):
    """Calls a setter; whether Python takes the values."""
    try:
        getattr(made, setter.name)(*([list(values)] if setter.packed else values))
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def refusals(made):
    """What an object of ours says to an update."""
    oracle.messages()
    made.SetAbortExecute(0)
    made.Write() if hasattr(made, "Write") else made.Update()
    return [message.said for message in oracle.messages() if message.kind == type(made).__name__]


class Names(unittest.TestCase):
    """Messages of all classes."""

    @classmethod
    def setUpClass(cls):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.refused = 0

    def test_what_is_refused_is_named(self):
        for name in introspection.all_classes():
            with self.subTest(name):
                made = working(name)
                setters = [setter for setter in introspection.setters(name) if introspection.present(made, setter) is not None]
                self.vary(made, setters, FEW if QUICK else ODD)
                for setter in setters:
                    if setter.types == ("bool",):
                        now = introspection.present(made, setter)
                        give(made, setter, [not now[0]])
                        if not refusals(made):  # as where what is switched on wants another input
                            self.vary(made, setters, SWITCHED)
                        give(made, setter, now)
        self.assertGreater(self.refused, 500 if QUICK else 1500)  # of 1527 and 4707

    def vary(self, made, setters, odd):
        """Gives each number odd values, one at a time."""
        before = {setter.name: introspection.present(made, setter) for setter in setters}
        for setter in setters:
            now = before[setter.name]
            taken = {}  # whether a value of a number is
            for index, value in [(i, value) for i, kind in enumerate(setter.types) for value in odd.get(kind, [])]:
                if give(made, setter, [*now[:index], value, *now[index + 1:]]):
                    # A property may have two names.
                    changed = {other.name[3:] for other in setters
                               if repr(introspection.present(made, other)) != repr(before[other.name])}
                    said_all = refusals(made)
                    taken[index, value] = not said_all
                    for said in said_all:
                        self.refused += 1
                        self.assertTrue(changed & set(re.findall(r"\w+", said)), f"{setter.name}: {value!r}: {said}")
            give(made, setter, now)
            refused = {index for (index, _), isTaken in taken.items() if not isTaken}
            beyond = [key for key, isTaken in taken.items() if isTaken and key[0] in refused and key[1] in BEYOND]
            self.assertTrue(setter.name in ANY_MAGNITUDE or not beyond, f"{setter.name} takes {beyond}")


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "--few"])
