# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two threads over one: classes whose bound is not memory, on one thread of VTK and on two in turn."""

import os
import statistics

#: Programs and benchmarks, each of another class.
CLASSES = {
    "vtkbench_classes": r"^ByClass<",
    "vtkbench_quadrats": r"^DrawProcess/process:1/size:1048576/|^JudgePattern/size:560/",
}
ROUNDS = 3


def measure(programs, run, seconds=0.2):
    """Medians of real times [ms] on one thread and on two, by program and benchmark; none with a single core."""
    times = {}
    if (os.cpu_count() or 1) < 2:
        return times
    for _ in range(ROUNDS):
        for count in (1, 2):
            for program in programs:
                name = os.path.basename(program)
                if name not in CLASSES:
                    continue
                print(f"{name}, {count} threads:", flush=True)
                arguments = [f"--benchmark_filter={CLASSES[name]}", f"--benchmark_min_time={seconds}"]
                for one in run(program, arguments, {"VTK_SMP_MAX_THREADS": str(count)}):
                    times.setdefault((one.program, one.name), {}).setdefault(count, []).append(one.real)
    return {key: tuple(statistics.median(of[count]) for count in (1, 2)) for key, of in times.items() if len(of) == 2}
