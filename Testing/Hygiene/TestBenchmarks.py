# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The report of benchmarks: the times of programs as a table, and what became slower."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

REPORT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks", "report.py")
#: A program that writes what Google Benchmark writes, its arguments among it.
PROGRAM = """#!{python}
import json, sys
words = dict(word.split("=", 1) for word in sys.argv[1:])
results = json.load(open(__file__ + ".json"))
with open(words["--benchmark_out"], "w") as out:
    if results["benchmarks"]:
        results["benchmarks"][0]["label"] = words.get("--benchmark_min_time", "usual")
        json.dump(results, out)
sys.exit(results.get("exit", 0))
"""


def result(name, time, unit="ms", **more):
    return {"name": name, "run_type": "iteration", "real_time": 2.0 * time, "cpu_time": time, "time_unit": unit, **more}


class Benchmarks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = os.path.join(self.folder, "bench_waves")
        with open(self.program, "w") as file:
            file.write(PROGRAM.format(python=sys.executable))
        os.chmod(self.program, 0o755)

    def report(self, results, *words, **more):
        with open(self.program + ".json", "w") as file:
            json.dump({"benchmarks": results, **more}, file)
        return subprocess.run([sys.executable, "-B", REPORT, self.program, *words], cwd=self.folder, text=True,
                              capture_output=True, check=False)

    def table(self, name="benchmarks.csv"):
        with open(os.path.join(self.folder, name), newline="") as file:
            return list(csv.reader(file))[1:]

    def test_times_are_milliseconds(self):
        done = self.report([result("Swell/1", 0.5, "s", items_per_second=2e6), result("Ripple", 123456.0, "ns"),
                            result("Ripple_mean", 1.0) | {"run_type": "aggregate"}])
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.table(), [["bench_waves", "Swell/1", "1000", "500", "2e+06", "usual"],
                                        ["bench_waves", "Ripple", "0.2469", "0.1235", "", ""]])

    def test_quick_takes_a_tenth(self):
        self.report([result("Swell", 1.0)], "--quick", "--csv", "quick.csv")
        self.assertEqual(self.table("quick.csv")[0][-1], "--benchmark_min_time=0.05".split("=")[1])

    def test_what_is_slower_is_listed(self):
        self.report([result("Swell", 10.0), result("Ripple", 10.0), result("Surf", 10.0)], "--csv", "old.csv")
        done = self.report([result("Swell", 11.1), result("Ripple", 10.9), result("Tide", 99.0)], "--against", "old.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 of 2 benchmarks take over 10 % longer than in old.csv\n"
                      "bench_waves, Swell: 11.1 ms, 1.11 times 10 ms\n", done.stdout)
        done = self.report([result("Ripple", 10.9)], "--against", "old.csv")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue(done.stdout.endswith("0 of 1 benchmarks take over 10 % longer than in old.csv\n"), done.stdout)

    def test_threads_are_judged_by_real_time(self):
        def both(real, processor):
            return [result(name, processor) | {"real_time": real} for name in ("Swell/real_time", "Surf/1/manual_time",
                                                                              "Tide")]
        self.report(both(10.0, 10.0), "--csv", "old.csv")
        done = self.report(both(20.0, 10.0), "--against", "old.csv")
        self.assertIn("Swell/real_time: 20 ms, 2.00 times 10 ms\n", done.stdout)
        self.assertIn("Surf/1/manual_time: 20 ms, 2.00 times 10 ms\n", done.stdout)
        self.assertNotIn("Tide:", done.stdout)
        done = self.report(both(10.0, 20.0), "--against", "old.csv")
        self.assertIn("1 of 3 benchmarks", done.stdout)
        self.assertIn("Tide: 20 ms", done.stdout)

    def test_a_failure_leaves_the_old_table(self):
        self.report([result("Swell", 1.0)])
        failed = [result("Swell", 2.0), result("Surf", 0.0, error_occurred=True, error_message="no sea")]
        for results, more, words in ((failed, {}, "bench: bench_waves, Surf: no sea\n"),
                                     ([result("Swell", 2.0)], {"exit": 3}, "bench: bench_waves: ended with 3\n")):
            done = self.report(results, **more)
            self.assertEqual((done.returncode, done.stderr), (1, words))
            self.assertEqual(self.table()[0][3], "1")

    def test_what_is_no_table_is_refused_before_anything_runs(self):
        for text, words in (("", "old.csv: no table of benchmarks"), ("a,b\n", "old.csv: no table of benchmarks"),
                            ("program,benchmark,real time [ms],CPU time [ms],items per second,note\np,b,1,x,,\n",
                             "old.csv, line 2: no time")):
            with open(os.path.join(self.folder, "old.csv"), "w") as file:
                file.write(text)
            done = self.report([result("Swell", 1.0)], "--against", "old.csv")
            self.assertEqual((done.returncode, done.stderr, done.stdout), (1, f"bench: {words}\n", ""))
        self.assertIn("No such file", self.report([], "--against", "none.csv").stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "benchmarks.csv")))

    def test_a_filter_that_nothing_fits_leaves_the_old_table(self):
        self.report([result("Swell", 1.0)])
        done = self.report([], "--benchmark_filter=Surf")
        self.assertEqual((done.returncode, done.stderr), (1, "bench: no benchmark fits\n"))
        self.assertEqual(self.table()[0][3], "1")

    def test_an_unknown_option_is_refused(self):
        done = self.report([result("Swell", 1.0)], "--fast")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no option --fast", done.stderr)


if __name__ == "__main__":
    unittest.main()
