# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The fuzzer finds faults that are made on purpose, makes them short, and repeats a case by its number alone."""

import os
import subprocess
import sys
import unittest
import unittest.mock

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
sys.dont_write_bytecode = True

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

import cases  # noqa: E402
import fuzz  # noqa: E402
import introspection  # noqa: E402
import littoral  # noqa: E402
import minimise  # noqa: E402
import oracle  # noqa: E402
import recipes  # noqa: E402
import runner  # noqa: E402

NAME = "vtkTurningBandsTerrainSource"
ARRAY = "made.GetOutput().GetPointData().GetArray('Elevation')"


def fault(*lines, name=NAME):
    """The kind of fault of a case with these lines between opening and end."""
    return runner.run_batch(name, [cases.opening(name) + [*lines, "finish()"]])[-1][0]


def heard(text, kind=NAME):
    """The kind of fault of messages of the terrain's, or of another class's."""
    player = oracle.Player(NAME)
    player.play(cases.opening(NAME))
    oracle.messages()
    for part in text.split("|"):
        vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: In x.cxx, line 1\n{kind} (0x1): {part}\n\n")
    try:
        player.listen()
    except oracle.Fault as found:
        return found.args[0]
    return ""


class Fuzzer(unittest.TestCase):
    """Each rule of the oracle, with a case that breaks it and one that does not."""

    @classmethod
    def setUpClass(cls):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)

    def test_a_good_case(self):
        self.assertEqual(fault("update()", "made.SetRange(30.0)", "keep()", "made.SetRange(0.0)", "update()",
                               "made.SetRange(30.0)"), "")
        self.assertEqual(runner.run(NAME, cases.opening(NAME) + ["made.SetRange(0.0)", "finish()"]), ("", "refused"))

    def test_crash_and_hang(self):
        self.assertEqual(fault("__import__('os').abort()"), "crash")
        runner.PROCESSOR = 0.5
        self.assertEqual(fault("while True: pass"), "hang")
        runner.PROCESSOR = 20.0
        self.assertEqual(fault("bytearray(4 << 30)"), "exception")

    def test_numbers(self):
        for number in "nan", "inf":
            self.assertEqual(fault("update()", f"{ARRAY}.SetValue(3, {number})", "update()"), "not a number")

    def test_bytes_of_a_fresh_object(self):
        self.assertEqual(fault("update()", f"{ARRAY} and {ARRAY}.SetValue(3, 7.0)"), "other bytes")
        self.assertEqual(fault("keep()", f"{ARRAY}.SetValue(3, 7.0)", "made.Modified()"), "kept output")
        # Settings that differ from the working object's are compared with a fresh object that has them too.
        self.assertEqual(fault("update()", "made.SetRange(7.0)"), "")
        self.assertEqual(fault("update()", "made.SetRange(7.0)", "update()", f"{ARRAY} and {ARRAY}.SetValue(3, 7.0)"),
                         "other bytes")

    def test_messages(self):
        self.assertEqual(heard("Range is 0; it must be positive."), "")
        self.assertEqual(heard("Range is 0; it must be positive"), "unclear message")
        self.assertEqual(heard("Something is wrong."), "unclear message")
        self.assertEqual(heard("Range is 0.|Range is still 0."), "messages")
        self.assertEqual(heard("It is not ours.", "vtkImageData"), "foreign message")
        self.assertEqual(heard(f"Algorithm {NAME} (0x1) returned failure for request: it", "vtkDemandDrivenPipeline"),
                         "silence")
        self.assertEqual(heard("This data object does not contain the requested extent.", "vtkTrivialProducer"), "")

    def test_short_cases(self):
        """Played by a stand-in, which fails where a line aborts."""
        lines = cases.opening(NAME) + ["made.SetRange(3.0)", "update()", "made.SetSeed(3)", "os.abort()",
                                       "made.SetSeed(4)", "update(time=1.0)", "finish()"]

        def run(_, played):
            return ("crash", "SIGABRT in os.abort()") if "os.abort()" in played else ("", "good")

        with unittest.mock.patch.object(runner, "run", run):
            self.assertEqual(minimise.minimised(NAME, lines, run(NAME, lines)), [lines[0], "os.abort()", "finish()"])
        self.assertEqual(list(minimise.simpler("made.f(0, drop(move(data('a'), 1.0), 'b'))")),
                         ["made.f(0, move(data('a'), 1.0))", "made.f(0, drop(data('a'), 'b'))"])

    def test_cases_in_one_process(self):
        good = cases.opening(NAME) + ["update()", "finish()"]
        late = cases.opening(NAME) + ["inputs.nap = getattr(inputs, 'nap', 0) + 1", "inputs.nap == 3 and os.abort()", "finish()"]
        bad = cases.opening(NAME) + ["os.abort()", "finish()"]
        late[0] = bad[0] = "import os, inputs, littoral; " + good[0]
        self.assertEqual(runner.run_batch(NAME, [good] * 3), [("", "good")] * 3)
        self.assertEqual([kind for kind, _ in runner.run_batch(NAME, [good, bad, good])], ["", "crash"])
        ends = runner.run_batch(NAME, [late] * 4)
        self.assertEqual([kind for kind, _ in ends], ["", "", "crash"])
        fault, played = fuzz.confirmed(NAME, [late] * 3, ends[-1])
        self.assertIn("after other cases", fault[1])
        self.assertEqual(played, [late] * 3)
        self.assertEqual(fuzz.confirmed(NAME, [good, bad], ("crash", "SIGABRT in "))[1], [bad])
        self.assertEqual(fuzz.confirmed(NAME, [good], ("silence", "it")), (("", "good"), [good]))

    def test_all_cases_are_counted(self):
        ends = list(fuzz.ends_of(NAME, fuzz.BATCH + 3, 1, 2))
        self.assertEqual(len(ends), fuzz.BATCH + 3)
        self.assertEqual([played[-1] for played, _, _ in ends],
                         [cases.lines_of(NAME, 1, number) for number in range(2, fuzz.BATCH + 5)])

    def test_a_case_follows_from_its_number(self):
        script = f"import cases; print(cases.lines_of({NAME!r}, 5, 17))"
        output = subprocess.run([sys.executable, "-B", "-c", script], check=True, capture_output=True, text=True,
                                cwd=os.path.dirname(os.path.abspath(__file__)), env={**os.environ, "PYTHONHASHSEED": "7"})
        self.assertEqual(output.stdout.strip(), str(cases.lines_of(NAME, 5, 17)))
        self.assertNotEqual(cases.lines_of(NAME, 5, 17), cases.lines_of(NAME, 5, 18))

    def test_classes_and_setters(self):
        names = introspection.all_classes()
        self.assertEqual(sorted(names), sorted(recipes.NAMES))
        self.assertNotIn("vtkPlantSource", names)
        setters = {setter.name: setter for setter in introspection.setters(NAME)}
        self.assertEqual(setters["SetWholeExtent"].types, ("int",) * 6)
        self.assertEqual(setters["SetModel"].choices, 7)
        self.assertEqual(introspection.present(littoral.vtkTurningBandsTerrainSource(), setters["SetSlope"]), (0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
