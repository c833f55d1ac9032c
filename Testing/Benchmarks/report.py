#!/usr/bin/env python3
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks, and reports their times.

    report.py PROGRAM... [--quick] [--peers] [--csv FILE] [--against OLD.csv] [ARGUMENT...]

PROGRAM: of Google Benchmark. Each is run with the ARGUMENTs that begin with --benchmark_; before, frames of two scenes are
measured in ParaView, and after, other tools at the same work (peers.py). FILE (default: benchmarks.csv) takes the table of
times. Beside it, with other endings, are the report (.md: machine, limits and shares of them, other tools, papers, cost
over size, frames) and a chart for each program with sizes (-PROGRAM.svg). With --quick what takes long is left out, and
each benchmark has a tenth of the usual time, unless it has a number of iterations of its own; --peers times other tools
then, too. OLD.csv is the table of an
earlier run on the same machine: what takes over 10 % longer is listed, and the exit code is 1. Benchmarks without a
counterpart there, as those with a new name, are listed too; and so are, after a run of all, those of OLD.csv that were not
run. Benchmarks with several threads are judged by real time, which a loaded machine spoils, the others by the processor's
time.
"""

import argparse
import csv
import dataclasses
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

import instruction_sets
import page
import peers
import scaling
import threads

COLUMNS = "program", "benchmark", "real time [ms]", "CPU time [ms]", "items per second", "note"
MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
SLOWER = 1.10  # time over that of the earlier run, above which a benchmark is listed
SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bench_scenes.py")

#: With --quick: what is left out, the scenes, and the frames of each. The examples take a minute to build.
SLOW = ("Abort", "Hear", "SwayForest", "AllInFull", "FirstViewOfForest", "in full:1000",
        "Carve.*/size:(262144|1048576)", "size:4194304", "size:16777216", "size:10000000", "Nodes/size:1000000",
        "JudgePattern/size:2250", "trees:100000")
QUICK_SCENES, ALL_SCENES = ("SwayingForest", "Underwater"), ("forest", "underwater")
QUICK_FRAMES, ALL_FRAMES = 4, 12
QUICK_TIME = 0.05  # that each benchmark has at least, unless it has a number of iterations [s]
#: A heap that keeps what is given back, as that of a program that runs for long: bench_machine, NewMemory, tells what the
#: first use of a page costs, which would be most of the time of a filter that takes arrays anew where a page is dear.
KEPT_HEAP = {"GLIBC_TUNABLES": "glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=17179869184"}
WARM_UP = "--benchmark_min_warmup_time=0.001"  # once, at least, before it is timed [s]


@dataclasses.dataclass
class Result:
    """A benchmark that was run."""
    program: str
    name: str
    real: float  # [ms]
    processor: float  # [ms]
    items_per_second: float  # 0: unknown
    bytes_per_second: float
    note: str
    counters: dict = dataclasses.field(default_factory=dict)  # and all else that was written about it

    @property
    def time(self):
        """The time [ms] by which it is judged."""
        return judged(self.name, self.real, self.processor)

    @property
    def rate(self):
        """Items a second, else bytes; 0 if unknown."""
        return self.items_per_second or self.bytes_per_second

    def cells(self):
        """Row of the table, with four figures that mean something."""
        figures = (f"{value:.4g}" for value in (self.real, self.processor))
        items = f"{self.items_per_second:.4g}" if self.items_per_second else ""
        return [self.program, self.name, *figures, items, self.note]


def judged(name, real, processor):
    """CPU time is that of one thread; names tell where real time counts."""
    return real if re.search("/(real|manual)_time", name) else processor


def results_of(program, written):
    """Results of Google Benchmark from its JSON. Raises ValueError where a benchmark has failed."""
    results = []
    for result in written["benchmarks"]:
        if result.get("run_type", "iteration") != "iteration":
            continue  # means and the like of repetitions
        if result.get("error_occurred"):
            raise ValueError(f"{program}, {result['name']}: {result.get('error_message', 'failed')}")
        unit = MILLISECONDS[result["time_unit"]]
        results.append(Result(program, result["name"], result["real_time"] * unit, result["cpu_time"] * unit,
                              result.get("items_per_second", 0.0), result.get("bytes_per_second", 0.0),
                              result.get("label", ""), result))
    return results


def measure(program, arguments, settings=()):
    """Runs a program, which prints its progress, with some variables of its environment set, and returns its results.
    Raises ValueError where it fails."""
    name = os.path.basename(program)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "results.json")
        ran = subprocess.run([program, f"--benchmark_out={out}", "--benchmark_out_format=json", WARM_UP, *arguments],
                             check=False, env={**os.environ, **KEPT_HEAP, **dict(settings)})
        if ran.returncode:
            raise ValueError(f"{name}: ended with {ran.returncode}")
        with open(out) as file:
            written = file.read()
        return results_of(name, json.loads(written)) if written else []  # none fits --benchmark_filter


def measure_scenes(scenes, frames):
    """Frames of scenes in ParaView, a process each; or a sentence why there are none."""
    for thing, is_there in (("pvpython", shutil.which("pvpython")), ("plugin", os.environ.get("PV_PLUGIN_PATH")),
                            ("display", os.environ.get("DISPLAY"))):
        if not is_there:
            return [], f"No frames were measured: there is no {thing}."
    measured = []
    for scene in scenes:
        print(f"{scene}, {frames} frames", flush=True)
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "frames.json")
            ran = subprocess.run(["pvpython", SCENES, scene, str(frames), out], check=False)
            if ran.returncode:
                raise ValueError(f"bench_scenes.py, {scene}: ended with {ran.returncode}")
            with open(out) as file:
                measured.append(json.load(file))
    return measured, ""


def write(filename, text):
    """Write a whole file, or leave the one that is there."""
    part = f"{filename}.part"
    with open(part, "w", newline="") as file:
        file.write(text)
    os.replace(part, filename)


def table_of(results):
    """Results as CSV."""
    text = io.StringIO()
    csv.writer(text).writerows([COLUMNS, *(result.cells() for result in results)])
    return text.getvalue()


def write_report(results, sets, both, scenes, silence, others, filename):
    """Write the table, the charts and the report; returns the name of the report."""
    stem = os.path.splitext(filename)[0]
    charts = []
    series = scaling.series_of(results)
    for program in dict.fromkeys(one.program for one in series):
        charts.append(f"{stem}-{program}.svg")
        write(charts[-1], scaling.chart(f"{program}: time [ms]", [one for one in series if one.program == program]))
    write(f"{stem}.md", page.page(results, [os.path.basename(name) for name in charts], sets, both, scenes, silence,
                                    *others))
    write(filename, table_of(results))
    return f"{stem}.md"


def read_table(filename):
    """Times [ms] by program and benchmark. Raises ValueError where a file is no such table."""
    with open(filename, newline="") as file:
        rows = list(csv.reader(file))
    if not rows or tuple(rows[0]) != COLUMNS:
        raise ValueError(f"{filename}: no table of benchmarks")
    times = {}
    for line, row in enumerate(rows[1:], 2):
        try:
            times.setdefault((row[0], row[1]), judged(row[1], float(row[2]), float(row[3])))
        except (IndexError, ValueError):
            raise ValueError(f"{filename}, line {line}: no time") from None
    return times


def compare(results, old):
    """Sentences about what is slower than in an earlier run, how many benchmarks both have, and names of those that only
    this and only that run has, as "program, benchmark"."""
    slower, now = [], {(result.program, result.name): result for result in results}
    both = [key for key in now if key in old]
    for key in both:
        time, before = now[key].time, old[key]
        if time > SLOWER * before:
            times = f"{time / before:.2f} times" if before else "after"
            slower.append(f"{', '.join(key)}: {time:.4g} ms, {times} {before:.4g} ms")
    return slower, len(both), *([", ".join(key) for key in some if key not in others]
                                for some, others in ((now, old), (old, now)))


def check_writable(filename):
    """Raises ValueError before anything runs where a file, or what comes beside it, could not be written."""
    if os.path.isdir(filename):
        raise ValueError(f"{filename}: is a folder")
    if not filename.endswith(".csv"):
        raise ValueError(f"{filename}: a table ends in .csv")
    try:
        with tempfile.TemporaryFile(dir=os.path.dirname(os.path.abspath(filename))):
            pass
    except OSError as error:
        raise ValueError(f"{filename}: cannot be written: {error.strerror}") from None


def main(words):
    parser = argparse.ArgumentParser(prog="./littoral bench", description="Measures the speed.", allow_abbrev=False)
    parser.add_argument("programs", nargs="*", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="about two minutes: without what takes long")
    parser.add_argument("--peers", action="store_true", help="with --quick, too: other tools at the same work")
    parser.add_argument("--csv", metavar="FILE", default="benchmarks.csv",
                        help="of the table; the report is beside it (default: %(default)s)")
    parser.add_argument("--against", metavar="OLD.csv", help="an earlier table: what is slower by more than 10 %%?")
    options, arguments = parser.parse_known_args(words)
    unknown = [argument for argument in arguments if not argument.startswith("--benchmark_")]
    if unknown:
        parser.error(f"there is no option {unknown[0]}")
    if not options.programs:
        raise ValueError("there are no programs; libbenchmark-dev was missing when Littoral was configured")
    missing = [program for program in options.programs if not os.access(program, os.X_OK)]
    if missing:
        raise ValueError(f"{missing[0]}: no program; libbenchmark-dev was missing when Littoral was configured")
    old = read_table(options.against) if options.against else {}
    check_writable(options.csv)
    is_filtered = any(argument.startswith("--benchmark_filter") for argument in arguments)
    if options.quick:
        arguments.append(f"--benchmark_min_time={QUICK_TIME}")
        arguments += [] if is_filtered else [f"--benchmark_filter=-{'|'.join(SLOW)}"]
    scenes, silence = [], "No frames were measured: benchmarks were chosen by name."
    if not is_filtered:
        scenes, silence = measure_scenes(*((QUICK_SCENES, QUICK_FRAMES) if options.quick else (ALL_SCENES, ALL_FRAMES)))
    results = []
    for program in options.programs:
        print(f"{os.path.basename(program)}:", flush=True)
        results += measure(program, arguments)
    if not results:
        raise ValueError("no benchmark fits")
    wants_peers = options.peers or not options.quick
    others = peers.measure(results) if wants_peers else ([], "Other tools were not timed: add --peers.")
    seconds = [QUICK_TIME] if options.quick else []
    sets = {} if is_filtered else instruction_sets.measure(options.programs, measure, *seconds)
    both = {} if is_filtered else threads.measure(options.programs, measure, *seconds)
    report = write_report(results, sets, both, scenes, silence, others, options.csv)
    print(f"{len(results)} benchmarks: {options.csv}, {report}")
    if silence:
        print(silence)
    if not options.against:
        return 0
    slower, both, new, gone = compare(results, old)
    if new:
        print("\n".join([f"{len(new)} benchmarks are new, or have another name than in {options.against}:", *new]))
    if gone:
        is_part = options.quick or is_filtered
        print(f"{len(gone)} benchmarks of {options.against} were not run{'' if is_part else ':'}")
        print("\n".join([] if is_part else gone), end="" if is_part else "\n")
    print(f"{len(slower)} of {both} benchmarks take over 10 % longer than in {options.against}")
    print("\n".join(slower), end="\n" if slower else "")
    return 1 if slower else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except OSError as error:
        sys.exit(f"bench: {error.filename}: {error.strerror}")
    except ValueError as error:
        sys.exit(f"bench: {error}")
