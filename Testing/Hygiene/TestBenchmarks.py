# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The report of benchmarks: times of programs as a table, shares of limits, cost over size, frames, what is slower."""

import contextlib
import csv
import io
import json
import os
import runpy
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from types import SimpleNamespace
from unittest import mock

BENCHMARKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks")
sys.path.insert(0, BENCHMARKS)
#: A program that writes what Google Benchmark writes, its arguments among it.
PROGRAM = """#!{python} -IS
import json, sys
words = dict(word.split("=", 1) for word in sys.argv[1:])
results = json.load(open(__file__ + ".json"))
with open(words["--benchmark_out"], "w") as out:
    if results["benchmarks"]:
        results["benchmarks"][0].setdefault("label", words.get("--benchmark_min_time", "usual"))
        json.dump(results, out)
sys.exit(results.get("exit", 0))
"""
#: A ParaView that measures a scene.
PVPYTHON = """#!{python} -IS
import json, sys
script, scene, frames, out = sys.argv[1:]
parts = {{"update": [0.2, 0.3], "in Littoral": [0.05, 0.06], "render": [float(frames), 7.0]}}
json.dump({{"scene": scene, "first picture": 1.5, "frame": parts, "memory": 1234.0}}, open(out, "w"))
sys.exit({code})
"""


def result(name, time, unit="ms", **more):
    return {"name": name, "run_type": "iteration", "real_time": 2.0 * time, "cpu_time": time, "time_unit": unit, **more}


class Benchmarks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = self.make("bench_waves", PROGRAM.format(python=sys.executable))
        self.environment = {"PATH": self.folder, "VTK_SMP_MAX_THREADS": "2"}

    def make(self, name, script):
        """A program; returns its path."""
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(script)
        os.chmod(path, 0o755)
        return path

    def run_report(self, *words):
        """Runs report.py as a program, in this process, whose start takes longer."""
        report, out, err = os.path.join(BENCHMARKS, "report.py"), io.StringIO(), io.StringIO()
        with contextlib.chdir(self.folder), mock.patch.dict(os.environ, self.environment, clear=True), \
                mock.patch.object(sys, "argv", [report, *words]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), self.assertRaises(SystemExit) as end:
            runpy.run_path(report, run_name="__main__")
        code = end.exception.code
        if isinstance(code, str):  # sys.exit writes it
            err.write(f"{code}\n")
            code = 1
        return SimpleNamespace(returncode=code, stdout=out.getvalue(), stderr=err.getvalue())

    def report(self, results, *words, **more):
        with open(self.program + ".json", "w") as file:
            json.dump({"benchmarks": results, **more}, file)
        return self.run_report(self.program, *words)

    def report_all(self, programs, *words):
        """Runs several programs with their results; returns the report."""
        paths = []
        for name, results in programs.items():
            paths.append(self.make(name, PROGRAM.format(python=sys.executable)))
            with open(paths[-1] + ".json", "w") as file:
                json.dump({"benchmarks": results}, file)
        done = self.run_report(*paths, *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return self.text()

    def text(self, name="benchmarks.md"):
        with open(os.path.join(self.folder, name)) as file:
            return file.read()

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

    def test_what_has_no_counterpart_is_told(self):
        self.report([result("Swell", 10.0), result("Surf", 10.0)], "--csv", "old.csv")
        renamed = [result("Swell", 10.0), result("Breaker", 99.0)]
        done = self.report(renamed, "--against", "old.csv")
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.endswith(
            "1 benchmarks are new, or have another name than in old.csv:\nbench_waves, Breaker\n"
            "1 benchmarks of old.csv were not run:\nbench_waves, Surf\n"
            "0 of 1 benchmarks take over 10 % longer than in old.csv\n"), done.stdout)
        for words in ("--quick", "--benchmark_filter=Swell"):  # not all is meant to be run
            done = self.report(renamed, words, "--against", "old.csv")
            self.assertIn("1 benchmarks of old.csv were not run\n0 of 1", done.stdout)
        done = self.report([result("Swell", 10.0), result("Surf", 10.0)], "--against", "old.csv")
        self.assertTrue(done.stdout.endswith(
            "there is no pvpython.\n0 of 2 benchmarks take over 10 % longer than in old.csv\n"), done.stdout)

    def test_papers_stand_beside_their_scenes(self):
        def particles(distance, levels, selection, size, trains, told):
            # 100, 125, 250 and 500 updates a second; of many particles 10, 8, 25 and 50.
            time = (10.0, 8.0, 4.0, 2.0)[levels + 2 * selection] if size < 400000 else \
                (100.0, 125.0, 40.0, 20.0)[levels + 2 * selection]
            name = f"Particles/distance:{distance}/levels:{levels}/selection:{selection}/size:{size}/trains:{trains}" \
                f"/told:{told}"
            return result(f"{name}/process_time", time,
                          **{"train sums": 120000 / (1 + 3 * levels) / (1 + selection)})

        table_1 = [particles(distance, levels, selection, *size) for distance in (0, 3, 6, 9, 12)
                   for levels in (0, 1) for selection in (0, 1)
                   for size in ((1000, 30, 0), (4000, 30, 0), (400000, 30, 0), (400000, 30, 1), (400000, 300, 0))]
        table_1.append(result("Particles/distance:0/levels:0/selection:0/size:400000/trains:1/told:0/process_time", 25.0))
        table_2 = [result(f"Seaweeds/plants:{plants}/levels:{levels}/process_time", 0.02 * plants / (1 + levels),
                          segments=6 * plants / (1 + levels)) for plants in (25, 50, 100, 200, 300, 30000)
                   for levels in (0, 1)]
        figure_9 = [result(f"Trees/cells:{cells}/trees:{number}/iterations:90/process_time", 20.0 - 10.0 * cells,
                           **{"polygons": 4e5 / (1 + 3 * cells), "polygons in full": number * 3e4 / (1 + 5 * cells)})
                    for cells in (0, 1) for number in (1000, 100000)]
        million = [result("FrameWithout/size:1000000/real_time", 1.0),
                   *(result(f"FrameWithLevels/distance:{distance}/size:1000000/real_time", time)
                     for distance, time in ((0, 2.0), (12, 0.5)))]
        text = self.report_all({"vtkbench_papers": [*table_1, *table_2, *figure_9], "vtkbench_particles": million})
        for row in ("| levels of detail, paper [1/s] | 20 | 23 | 29 | 45 | 97 |",
                    "| levels of detail, here, 4000 in 30 trains [1/s] | 125 | 125 | 125 | 125 | 125 |",
                    "| here in time, 400000 in 30 trains |" + " 0.8 (slower) |" * 5,
                    "| gain by both, paper | 2 | 2.55 | 3.45 | 5.64 | 11.1 |\n"
                    "| here in time, 1000 in 30 trains | 5 | 5 | 5 | 5 | 5 |\n"
                    "| here in time, 4000 in 30 trains | 5 | 5 | 5 | 5 | 5 |\n"
                    "| here in time, 400000 in 30 trains | 5 | 5 | 5 | 5 | 5 |\n"
                    "| here in time, 400000 in 30 trains, whose way is told | 5 | 5 | 5 | 5 | 5 |\n"
                    "| here in time, 400000 in 300 trains | 5 | 5 | 5 | 5 | 5 |\n"
                    "| here, in trains times particles | 8 | 8 | 8 | 8 | 8 |",
                    "| no levels, here [1/s] | 2000 | 1000 | 500 | 250 | 167 | 1.67 |",
                    "| gain, paper | 1.3 | 1.44 | 1.58 | 1.69 | 1.78 |  |",
                    "| here, in segments moved | 2 | 2 | 2 | 2 | 2 | 2 |",
                    "| 1000 | neither | 0.9 | 1 | 30000 | 1 |  |",
                    "| 1000 | levels of detail | 3.7 | 4.11 | 400 | 75 | 50 |",
                    "| 1000 | cells | 5.2 | 5.78 | 5000 | 6 |  |",
                    "| 1000 | both | 12.2 | 13.6 | 100 | 300 | 100 |",
                    "| 100000 | both | 12.2 | 13.6 | 100 | 30000 | 100 |",
                    "| 1 | 0 | 2 | 4 | 0.5 (slower) |",
                    "| 1 | 12 | 2 | 1 | 2 |",
                    "In one train, without levels, 400000 particles take 4 times less than in 30 and 4 times less than in "
                    "300: as long as all are shown, no choice of trains gains more."):
            self.assertIn(row + "\n", text)
        text = self.report_all({"vtkbench_papers": table_1[1:] + table_2})
        self.assertNotIn("Table 1 of Coulais", text)
        self.assertIn("Table 2 of Coulais", text)
        text = self.report_all({"bench_waves": [result("Swell", 1.0)]})
        self.assertIn("The scenes of the papers were not measured.", text)

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

    def test_other_tools_stand_beside_their_work(self):
        terrain = {"bench_terrain": [result("GrowTerrain/1/64/real_time", 10.0)]}
        self.assertIn("R is not installed.", self.report_all(terrain))
        self.make("Rscript", "#!/bin/sh\necho RandomFields,80.0\n")
        report = self.report_all(terrain)
        self.assertIn("| turning bands, 1024 x 1024, 64 lines | 20 | 10 | RandomFields, RPtbm of RMexp | 80 | 0.25 | 0.12 |",
                      report)
        self.assertIn("R has no spatstat.", report)
        self.assertIn("Other tools were not timed: add --peers.", self.report_all(terrain, "--quick"))
        self.assertIn("RandomFields, RPtbm", self.report_all(terrain, "--quick", "--peers"))
        self.assertIn("No peers were measured.", self.report_all({"bench_waves": [result("Swell", 1.0)]}))

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
        self.assertEqual("bench: none.csv: No such file or directory\n", self.report([], "--against", "none.csv").stderr)
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


    def test_a_share_is_the_time_at_the_limit_over_the_time_taken(self):
        def rate(name, threads, **rates):
            return result(f"{name}/real_time/threads:{threads}", 1.0, label="AVX2", **rates)

        text = self.report_all({
            "bench_machine": [rate("CopyMemory", 1, bytes_per_second=8e9), rate("CopyMemory", 2, bytes_per_second=1e10),
                              rate("ReadMemory", 1, bytes_per_second=9e9), rate("WriteMemory", 1, bytes_per_second=4e9),
                              rate("SinesAndCosines", 2, items_per_second=1e9),
                              rate("Exponentials", 2, items_per_second=2e9)],
            # 36 bytes at 9 GB/s and 24 at 4 GB/s: 10 ns, of 40 ns a vertex
            "bench_sway": [result("SkinTrees/size:250", 3.0, items_per_second=25e6),
                           result("TurnSamePoses/2/real_time", 2.0), result("TurnSamePoses/1/real_time", 3.0),
                           result("MoveForest/threads:2/in full:1000/real_time", 8.0)],
            # 1 ns and 0.5 ns, of 6 ns a particle and train
            "vtkbench_orbits": [result("MoveParticles<float>/depth:20/size:10/real_time", 1.0, items_per_second=1e9 / 6.0)],
            # 20 times 4 ms of 200 ms
            "vtkbench_seaweed": [result("StepForest/size:10000/real_time", 100.0),
                                 result("StepMemory/size:10000/real_time", 2.0)],
            "vtkbench_others": [result("SkinTrees/size:250", 1.0, items_per_second=25e6)],
            # Its limit, WriteMemory, was not run.
            "vtkbench_scatter": [result("AllInFull/100/real_time", 1.0, bytes_per_second=1e9)]})
        for row in ("| CopyMemory/threads:2 | 10 GB/s | AVX2 |",
                    "| bench_sway | SkinTrees/size:250 | 3 | 25 million/s | 25 % (1) |",
                    "| bench_sway | MoveForest/threads:2/in full:1000/real_time | 16 |  | 25 % (2) |",
                    "| vtkbench_orbits | MoveParticles<float>/depth:20/size:10/real_time | 2 | 167 million/s | 25 % (3) |",
                    "| vtkbench_seaweed | StepForest/size:10000/real_time | 200 |  | 40 % (4) |",
                    "| vtkbench_others | SkinTrees/size:250 | 1 | 25 million/s |  |",
                    "| vtkbench_scatter | AllInFull/100/real_time | 2 | 1 GB/s |  |"):
            self.assertIn(row + "\n", text)
        self.assertIn("1. 36 bytes a vertex", text)

    def test_classes_stand_beside_their_kernels(self):
        text = self.report_all({
            "bench_machine": [result("ReadMemory/real_time/threads:2", 1.0, bytes_per_second=6e9)],
            "vtkbench_classes": [result("ByKernel<Fog>/real_time", 3.0, items_per_second=1e9),
                                 result("ByClass<Fog>/real_time", 4.0, items_per_second=0.75e9),
                                 result("ByKernel<Tide>/real_time", 1.0), result("ByClass<Tide>/real_time", 2.0),
                                 result("ByKernel<Surf>/real_time", 1.0)]})
        self.assertIn("| Fog | 6 | 8 | 75 % |  | 200 % | 150 % |\n", text)
        self.assertIn("| Tide | 2 | 4 | 50 % | below 70 % |  |  |\n", text)
        self.assertNotIn("| Surf |", text)

    def test_exponents_are_slopes_of_logarithms(self):
        # Times of 3, 24 and 96: by least squares, with sizes of 1, 4 and 16, an exponent of 1.25.
        series = [result(f"Swell/mode:1/size:{10 * 4 ** k}", time) for k, time in enumerate((3.0, 24.0, 96.0))]
        line = [result(f"Surf/size:{size}", 0.001 * size) for size in (100, 1000)]
        self.assertEqual(self.report([*series, *line, result("Tide/size:5", 1.0), result("Size:3", 1.0)]).returncode, 0)
        self.assertIn("| bench_waves | Swell/mode:1/size | 10 to 160 | 1.25 | above 1.1 |  |\n", self.text())
        self.assertIn("| bench_waves | Surf/size | 100 to 1000 | 1.00 |  |  |\n", self.text())
        self.assertNotIn("Tide/size |", self.text())
        self.assertIn("![benchmarks-bench_waves.svg](benchmarks-bench_waves.svg)", self.text())
        chart = xml.etree.ElementTree.fromstring(self.text("benchmarks-bench_waves.svg"))
        svg = "{http://www.w3.org/2000/svg}"
        lines = [one.get("points").split() for one in chart.iter(f"{svg}polyline")]
        self.assertEqual([len(points) for points in lines], [3, 2])
        x = [float(point.split(",")[0]) for point in lines[0]]
        self.assertAlmostEqual(x[1] - x[0], x[2] - x[1], delta=0.11)  # a logarithmic axis, rounded to 0.1
        self.assertIn("Surf/size: 1.00", [text.text for text in chart.iter(f"{svg}text")])

    def test_what_sorts_is_told(self):
        text = self.report_all({"bench_drainage": [result(f"Flood/size:{size}", 1e-3 * size) for size in (100, 1000)]})
        self.assertIn("| bench_drainage | Flood/size | 100 to 1000 | 1.00 |  | a queue by height |\n", text)

    def test_classes_run_on_one_thread_and_on_two_in_turn(self):
        import page
        import report
        import threads

        asked = []

        def run(program, arguments, settings):
            count = int(settings["VTK_SMP_MAX_THREADS"])
            asked.append((os.path.basename(program), count))
            time = {1: (12.0, 10.0, 90.0), 2: (5.0, 40.0, 4.0)}[count][(len(asked) - 1) // 2]
            return [report.Result(os.path.basename(program), "Turn", time, 1.0, 0.0, 0.0, "")]

        found = threads.measure(["bin/bench_waves", "bin/vtkbench_classes"], run)
        if (os.cpu_count() or 1) < 2:
            self.assertEqual(found, {})
            return
        self.assertEqual(asked, [("vtkbench_classes", 1), ("vtkbench_classes", 2)] * 3)
        self.assertIn("| vtkbench_classes | Turn | 12 | 5 | 2.40 |", page.of_threads(found))

    def test_kernels_are_measured_with_each_set_of_instructions(self):
        import instruction_sets
        import page
        import report

        here = instruction_sets.sets_here(self.folder)
        names = list(here)
        self.assertIsNone(here[names[-1]])  # the usual library takes the widest
        self.assertEqual([os.path.basename(path) for path in list(here.values())[:-1]],
                         [f"libLittoralCommon-{name.lower().replace('-', '')}.so" for name in names[:-1]])
        libraries = os.path.join(self.folder, "lib", "instruction-sets")
        programs = [os.path.join(self.folder, "bin", name) for name in ("bench_sway", "bench_waves")]
        asked = []

        def run(program, arguments, settings):
            asked.append((os.path.basename(program), settings["LITTORAL_INSTRUCTIONS"], settings.get("LD_PRELOAD")))
            return [report.Result("bench_sway", "Turn", 2.0, float(len(asked)), 0.0, 0.0, "")]

        os.makedirs(os.path.join(self.folder, "bin"))
        if len(names) > 1:
            self.assertEqual(instruction_sets.measure(programs, run), {})  # the libraries are not there
        os.makedirs(libraries)
        for path in list(here.values())[:-1]:
            with open(os.path.join(libraries, os.path.basename(path)), "w"):
                pass
        asked.clear()
        sets = instruction_sets.measure(programs, run)
        self.assertEqual([(name, bool(library)) for _, name, library in asked],
                         [(name, name != names[-1]) for name in names])
        self.assertEqual({program for program, *_ in asked}, {"bench_sway"})
        row = " | ".join(str(number) for number in range(1, len(names) + 1))
        self.assertIn(f"| bench_sway | Turn | {row} |", page.of_sets(sets))
        self.assertIn("Sets of instructions were not compared.", page.of_sets({}))

    def test_the_report_tells_what_is_missing(self):
        self.report([result("Swell", 1.0)])
        for words in ("bench_machine was not run, so shares of its limits are not known.",
                      "No benchmark was run with two sizes.", "No frames were measured: there is no pvpython.",
                      "| processor | ", "| memory | "):
            self.assertIn(words, self.text())
        self.assertIn("without SLEEF", self.report_all({"bench_machine": [
            result("CopyMemory/real_time/threads:1", 1.0, bytes_per_second=1e9)]}))

    def test_frames_of_scenes_are_reported(self):
        self.make("pvpython", PVPYTHON.format(python=sys.executable, code=0))
        self.assertIn("there is no plugin.\n", self.report([result("Swell", 1.0)]).stdout)
        self.environment |= {"PV_PLUGIN_PATH": self.folder}
        self.assertIn("there is no display.\n", self.report([result("Swell", 1.0)]).stdout)
        self.environment |= {"DISPLAY": ":0"}
        self.report([result("Swell", 1.0)], "--quick")
        for row in ("| SwayingForest | update | 200 | 300 |", "| SwayingForest | in Littoral | 50 | 60 |",
                    "| Underwater | render | 4000 | 7000 |", "| Underwater | first picture | 1500 |  |",
                    "| Underwater | 1234 |"):
            self.assertIn(row + "\n", self.text())
        self.report([result("Swell", 1.0)])
        self.assertIn("| forest | render | 12000 | 7000 |\n", self.text())
        self.report([result("Swell", 1.0)], "--benchmark_filter=Swell")
        self.assertIn("No frames were measured: benchmarks were chosen by name.", self.text())
        self.make("pvpython", PVPYTHON.format(python=sys.executable, code=3))
        done = self.report([result("Swell", 1.0)])
        self.assertEqual((done.returncode, done.stderr), (1, "bench: bench_scenes.py, forest: ended with 3\n"))

    def test_work_of_a_rank_is_what_is_whole_and_what_is_shared(self):
        import ranks

        for times, model in (({1: 10.0, 2: 6.0, 4: 4.0}, (2.0, 8.0)), ({1: 5.0, 2: 5.0, 4: 5.0}, (5.0, 0.0)),
                             ({1: 8.0, 2: 4.0, 4: 2.0}, (0.0, 8.0)), ({1: 1.0, 2: 2.0, 4: 3.0}, (2.0, 0.0))):
            for found, wanted in zip(ranks.model_of(times), model):
                self.assertAlmostEqual(found, wanted)
        # More than halved by two ranks, as where less memory is quicker: nothing is whole.
        s, p = ranks.model_of({1: 12.0, 2: 5.0, 4: 3.0})
        self.assertEqual(s, 0.0)
        self.assertGreater(p, 10.0)

    def test_charts_show_strong_and_weak_scaling(self):
        import ranks

        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        # Half on two ranks, a quarter on four: an exponent of -1; four times the work in the same time: 0.
        ranks.write_charts([("tide", [(1, 1.0), (2, 0.5), (4, 0.25)], [(1, 1.0), (4, 1.0)])])
        for kind, exponent in (("strong", "-1.00"), ("weak", "0.00")):
            chart = xml.etree.ElementTree.fromstring(self.text(f"ranks-{kind}.svg"))
            words = [text.text for text in chart.iter("{http://www.w3.org/2000/svg}text")]
            self.assertIn(f"tide: {exponent}", words)
            self.assertIn("ranks", words)

    def test_quick_leaves_out_what_takes_long_unless_asked(self):
        self.make("bench_waves", PROGRAM.format(python=sys.executable).replace("--benchmark_min_time", "--benchmark_filter"))
        self.report([result("Swell", 1.0)], "--quick")
        self.assertRegex(self.table()[0][-1], r"^-Abort\|")
        self.report([result("Swell", 1.0)], "--quick", "--benchmark_filter=Abort")
        self.assertEqual(self.table()[0][-1], "Abort")

    def test_bad_files_and_programs_are_refused_before_anything_runs(self):
        os.mkdir(os.path.join(self.folder, "folder.csv"))
        for words, error in ((["--csv", "none/new.csv"], "none/new.csv: cannot be written: No such file or directory"),
                             (["--csv", "folder.csv"], "folder.csv: is a folder"),
                             (["--csv", "times.txt"], "times.txt: a table ends in .csv")):
            done = self.report([result("Swell", 1.0)], *words)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, f"^bench: {error}\n$")
        for words, error in (([], "there are no programs"), (["build/bin/*bench_*"], "build/bin/*bench_*: no program")):
            done = self.run_report(*words)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertEqual(done.stderr, f"bench: {error}; libbenchmark-dev was missing when Littoral was configured\n")


if __name__ == "__main__":
    unittest.main()
