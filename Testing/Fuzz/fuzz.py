# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Random cases for the classes of Littoral.

    fuzz.py N [CLASS] [--seed S]     N cases a class, from number 0 on; prints each kind of fault once, as a short script
"""

import argparse
import collections
import os
import subprocess
import sys

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"  # processes with threads cannot be forked safely
sys.dont_write_bytecode = True

import cases  # noqa: E402
import classes  # noqa: E402
import minimise  # noqa: E402
import runner  # noqa: E402

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow  # noqa: E402


MOST_ALIKE = 3  # scripts for one fault
BATCH = 50  # cases in a process


def ends_of(name, count, seed, first):
    """Plays cases of a class in batches: the cases of the batch up to each, the kind of its fault, and what it was."""
    at = first
    while at < first + count:
        batch = [cases.lines_of(name, seed, number) for number in range(at, min(at + BATCH, first + count))]
        ends = runner.run_batch(name, batch)
        for index, (kind, what) in enumerate(ends):
            yield batch[:index + 1], kind, what
        at += len(ends)


def reproducer(name, played, fault):
    """The shortest script with a fault that is found: of the last case, or of all if it has the fault only after others."""
    kind, what = runner.run(name, played[-1])
    if minimise.signature((kind, what)) != minimise.signature(fault):
        return f"{fault[1]} (after other cases)", played
    short = minimise.minimised(name, played[-1], fault)
    return runner.run(name, short)[1], [short]


def fuzz(name, count, seed, first=0):
    """Plays cases of a class; the number of faults."""
    ends, scripts = collections.Counter(), {}
    for number, (played, kind, what) in enumerate(ends_of(name, count, seed, first), first):
        ends[kind or what] += 1
        alike = scripts.setdefault(minimise.signature((kind, what)), set()) if kind else None
        if kind and len(alike) < MOST_ALIKE:
            said, short = reproducer(name, played, (kind, what))
            calls = minimise.calls(short[-1])
            if calls not in alike:
                alike.add(calls)
                print(f"# {name}, case {number}, {kind}: {said[:600]}", minimise.script(name, short), "", sep="\n",
                      flush=True)
    print(f"{name}: {count} cases,", ", ".join(f"{times} {end}" for end, times in ends.most_common()), flush=True)
    # Cases that nearly all end in a refusal would show nothing.
    return sum(times for end, times in ends.items() if end not in ("good", "refused", "stopped")) + (ends["good"] < count // 2)


def fuzz_all(count, seed):
    """Plays cases of all classes, each in a process of its own, as many at once as there are cores."""
    waiting, running, failed = classes.all_classes(), [], 0
    while waiting or running:
        while waiting and len(running) < (os.cpu_count() or 1):
            running.append(subprocess.Popen([sys.executable, __file__, str(count), waiting.pop(0), f"--seed={seed}"]))
        failed += running.pop(0).wait() != 0
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, help="cases a class")
    parser.add_argument("name", nargs="?", help="of a class; without it, all")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    given = parser.parse_args()
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    if given.name is None:
        return fuzz_all(given.count, given.seed)
    if given.name not in classes.all_classes():
        parser.error(f"there is no class {given.name}")
    return fuzz(given.name, given.count, given.seed, given.first)


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
