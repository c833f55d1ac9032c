# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3
"""The check of the tiers: a test beyond its budget, without a tier or without a time is named; others are not."""

import json
import os
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
TIERS = os.path.join(HERE, "..", "Tiers")

#: check.py on a machine whose loops are as fast as those of the budgets, however busy it is.
AS_FAST = """
import sys
sys.path.insert(0, sys.argv.pop(1))
import check
check.loop = lambda: check.LOOP
sys.exit(check.main(*sys.argv[1:]))
"""


def check(*cases, whole=()):
    """The end and the text of a check of tests by name, labels, output and status, as ctest writes them."""
    rows = "".join(f'<testcase name="{name}" status="{status}"><system-out>{output}</system-out></testcase>'
                   for name, _, output, status in cases)
    with open("record.xml", "w", encoding="utf-8") as file:
        file.write(f'<?xml version="1.0" encoding="UTF-8"?><testsuite>{rows}</testsuite>')
    with open("tests.json", "w", encoding="utf-8") as file:
        json.dump({"tests": [{"name": name, "properties": [{"name": "LABELS", "value": labels.split(";")}]}
                             for name, labels, _, _ in cases]}, file)
    run = subprocess.run([sys.executable, "-B", "-c", AS_FAST, TIERS, "record.xml", "tests.json", "names.txt", *whole],
                         capture_output=True, text=True, check=False)
    return run.returncode, run.stdout + run.stderr


def time(user, system=0.0):
    return f"words\nCPU time: {user} user, {system} system"


class Tiers(unittest.TestCase):
    """Each rule, with a test that breaks it beside tests that do not."""

    def test_within(self):
        end, text = check(("a", "common;quick", time(0.6, 0.3), "run"), ("b", "cxx;standard", time(9.0), "run"),
                          ("c", "soak;all", time(500.0), "run"), ("d", "python;standard", "", "notrun"))
        self.assertEqual(end, 0, text)
        self.assertIn("509.9 s", text)

    def test_beyond(self):
        for labels, user, system in ("common;quick", 0.6, 0.5), ("cxx;standard", 5.5, 5.0):
            end, text = check(("good", labels, time(0.1), "run"), ("dear", labels, time(8 * user, system), "run"))
            self.assertEqual(end, 1)
            self.assertIn("dear takes", text)
            with open("names.txt", encoding="utf-8") as file:
                self.assertEqual(file.read(), "dear\n")
            self.assertNotIn("good takes", text)

    def test_slower_machine(self):
        """Where all tests take longer, a test may; if it alone does, or they are too dear, it may not."""
        def tier(seconds, dear):
            return *((f"t{k}", "python;standard", time(seconds), "run") for k in range(300)), \
                   ("dear", "cxx;standard", time(dear), "run")
        for seconds, dear, end in ((1.0, 11.9, 1), (2.61, 14.0, 0), (2.61, 15.9, 1), (9.0, 19.0, 0), (9.0, 21.0, 1)):
            self.assertEqual(check(*tier(seconds, dear))[0], end, (seconds, dear))
        check(*tier(2.61, 15.9))
        os.rename("record.xml", "whole.xml")
        for dear, end in ((14.0, 0), (15.9, 1)):
            self.assertEqual(check(("dear", "cxx;standard", time(dear), "run"), whole=["whole.xml"])[0], end)
        self.assertEqual(check(("dear", "cxx;standard", time(14.0), "run"))[0], 1)

    def test_scripts_of_one_test(self):
        """Each has the budget, and so has the rest; named is the test that they share."""
        scripts = "a 1\nCPU time of first: 7.0 user, 1.0 system\na 2\nCPU time of second: {} user, 1.0 system\n"
        for second, whole, said in ((8.0, 300.0, "shared takes 283.0 s"), (280.0, 290.0, "shared second takes 281.0 s")):
            end, text = check(("shared", "paraview;standard", scripts.format(second) + time(whole), "run"))
            self.assertEqual(end, 1, text)
            self.assertIn(said, text)
            with open("names.txt", encoding="utf-8") as file:
                self.assertEqual(file.read(), "shared\n")
        end, text = check(("shared", "paraview;standard", scripts.format(8.0) + time(20.0), "run"))
        self.assertEqual(end, 0, text)
        self.assertIn("20.0 s", text)

    def test_the_last_time_counts(self):
        self.assertEqual(check(("a", "common;quick", time(7.0) + "\n" + time(0.5), "run"))[0], 0)

    def test_no_tier_no_time(self):
        end, text = check(("lost", "common", time(0.1), "run"))
        self.assertEqual(end, 1)
        self.assertIn("lost has the tiers []", text)
        end, text = check(("both", "common;quick;all", time(0.1), "run"))
        self.assertEqual(end, 1)
        end, text = check(("silent", "common;quick", "words", "run"))
        self.assertEqual(end, 1)
        self.assertIn("silent has no processor time", text)

    def test_the_launcher(self):
        for command, end in (("exit 3", 3), ("kill -9 $$", 137), ("true", 0)):
            run = subprocess.run([os.path.join(TIERS, "measured"), "bash", "-c", command], capture_output=True, text=True,
                                 check=False)
            self.assertEqual(run.returncode, end)
            self.assertRegex(run.stderr, r"CPU time: \d+\.\d+ user, \d+\.\d+ system\n$")
        run = subprocess.run([os.path.join(TIERS, "measured"), sys.executable, "-c",
                              "import time\nwhile time.process_time() < 0.3: pass"], capture_output=True, text=True, check=True)
        user, system = (float(word) for word in run.stderr.split()[2::2])
        self.assertGreater(user + system, 0.3)


if __name__ == "__main__":
    unittest.main()
