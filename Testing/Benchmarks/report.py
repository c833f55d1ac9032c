#!/usr/bin/env python3
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks, and writes their times as a table.

    report.py PROGRAM... [--quick] [--csv FILE] [--against OLD.csv] [ARGUMENT...]

PROGRAM: of Google Benchmark. Each is run with the ARGUMENTs that begin with --benchmark_, and with --quick for a tenth of
the usual time, unless it has a number of iterations of its own. FILE (default: benchmarks.csv) takes the table, OLD.csv is that of an earlier run on the same machine:
what takes over 10 % longer is listed, and the exit code is 1. Benchmarks with several threads are judged by real time,
which a loaded machine spoils, the others by the processor's time.
"""

import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile

COLUMNS = "program", "benchmark", "real time [ms]", "CPU time [ms]", "items per second", "note"
MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
SLOWER = 1.10  # time over that of the earlier run, above which a benchmark is listed


def rows_of(program, results):
    """Rows of the table from what Google Benchmark writes as JSON. Raises ValueError where a benchmark has failed."""
    rows = []
    for result in results["benchmarks"]:
        if result.get("run_type", "iteration") != "iteration":
            continue  # means and the like of repetitions
        if result.get("error_occurred"):
            raise ValueError(f"{program}, {result['name']}: {result.get('error_message', 'failed')}")
        unit = MILLISECONDS[result["time_unit"]]
        rows.append((program, result["name"], result["real_time"] * unit, result["cpu_time"] * unit,
                     result.get("items_per_second", ""), result.get("label", "")))
    return rows


def measure(program, arguments):
    """Runs a program, which prints its progress, and returns its rows. Raises ValueError where it fails."""
    name = os.path.basename(program)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "results.json")
        ran = subprocess.run([program, f"--benchmark_out={out}", "--benchmark_out_format=json", *arguments], check=False)
        if ran.returncode:
            raise ValueError(f"{name}: ended with {ran.returncode}")
        with open(out) as file:
            written = file.read()
        return rows_of(name, json.loads(written)) if written else []  # none fits --benchmark_filter


def write_table(rows, filename):
    """Write rows as CSV, with four figures that mean something."""
    part = f"{filename}.part"
    with open(part, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(COLUMNS)
        for row in rows:
            table.writerow([f"{value:.4g}" if isinstance(value, float) else value for value in row])
    os.replace(part, filename)


def time_of(row):
    """The time [ms] by which a row is judged. CPU time is that of one thread; names tell where real time counts."""
    return float(row[2] if row[1].endswith(("/real_time", "/manual_time")) else row[3])


def read_table(filename):
    """Times [ms] by program and benchmark. Raises ValueError where a file is no such table."""
    with open(filename, newline="") as file:
        rows = list(csv.reader(file))
    if not rows or tuple(rows[0]) != COLUMNS:
        raise ValueError(f"{filename}: no table of benchmarks")
    times = {}
    for line, row in enumerate(rows[1:], 2):
        try:
            times.setdefault((row[0], row[1]), time_of(row))
        except (IndexError, ValueError):
            raise ValueError(f"{filename}, line {line}: no time") from None
    return times


def compare(rows, old):
    """Sentences about what is slower than in an earlier run, and how many benchmarks both have."""
    slower, both = [], 0
    for row in rows:
        program, name, time = row[0], row[1], time_of(row)
        before = old.get((program, name))
        if before:
            both += 1
            if time > SLOWER * before:
                slower.append(f"{program}, {name}: {time:.4g} ms, {time / before:.2f} times {before:.4g} ms")
    return slower, both


def main(words):
    parser = argparse.ArgumentParser(prog="./littoral bench", description="Measures the speed.")
    parser.add_argument("programs", nargs="*", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="a tenth of the usual time")
    parser.add_argument("--csv", metavar="FILE", default="benchmarks.csv", help="of the table (default: %(default)s)")
    parser.add_argument("--against", metavar="OLD.csv", help="an earlier table: what is slower by more than 10 %%?")
    options, arguments = parser.parse_known_args(words)
    unknown = [argument for argument in arguments if not argument.startswith("--benchmark_")]
    if unknown:
        parser.error(f"there is no option {unknown[0]}")
    old = read_table(options.against) if options.against else {}
    if options.quick:
        arguments.append("--benchmark_min_time=0.05")
    rows = []
    for program in options.programs:
        print(f"{os.path.basename(program)}:", flush=True)
        rows += measure(program, arguments)
    if not rows:
        raise ValueError("no benchmark fits")
    write_table(rows, options.csv)
    print(f"{len(rows)} benchmarks: {options.csv}")
    if not options.against:
        return 0
    slower, both = compare(rows, old)
    print(f"{len(slower)} of {both} benchmarks take over 10 % longer than in {options.against}")
    print("\n".join(slower), end="\n" if slower else "")
    return 1 if slower else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (OSError, ValueError) as error:
        sys.exit(f"bench: {error}")
