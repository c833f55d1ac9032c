# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The fuzzer makes cases short that have faults made on purpose."""

import os
import sys
import unittest

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
sys.dont_write_bytecode = True

import cases  # noqa: E402
import minimise  # noqa: E402
import runner  # noqa: E402

NAME = "vtkTurningBandsTerrainSource"


class Minimise(unittest.TestCase):
    """Lines, and what spoils inputs in them."""

    def test_short_cases(self):
        lines = cases.opening(NAME) + ["made.SetRange(3.0)", "update()", "made.SetSeed(3)", "__import__('os').abort()",
                                       "made.SetSeed(4)", "update(time=1.0)", "finish()"]
        self.assertEqual(minimise.minimised(NAME, lines, runner.run(NAME, lines)),
                         [lines[0], "__import__('os').abort()", "finish()"])
        self.assertEqual(list(minimise.simpler("made.f(0, drop(move(data('a'), 1.0), 'b'))")),
                         ["made.f(0, move(data('a'), 1.0))", "made.f(0, drop(data('a'), 'b'))"])


if __name__ == "__main__":
    unittest.main()
