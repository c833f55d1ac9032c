# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Random cases for the classes of Littoral.

    fuzz.py N [CLASS...] [--seed S]     N cases a class, from number 0 on; prints each kind of fault once, as a short script
"""

import argparse
import collections
import os
import subprocess
import sys

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"  # there are as many processes as cores
sys.dont_write_bytecode = True

import cases  # noqa: E402
import introspection  # noqa: E402
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


def confirmed(name, played, fault):
    """A fault of the last case when it is played alone, with that case; else the fault, with all cases before it. Silence
    counts alone: what gives the inputs may have told why in a case before."""
    alone = runner.run(name, played[-1])
    if fault[0] == "silence" or minimise.signature(alone) == minimise.signature(fault):
        return alone, played[-1:]
    return (fault[0], f"{fault[1]} (after other cases)"), played


def is_new(alike, calls):
    """Whether a fault is worth a script: it calls other methods than those before, which are not too many yet."""
    if len(alike) >= MOST_ALIKE or calls in alike:
        return False
    alike.add(calls)
    return True


def show(name, number, played, fault):
    """Prints the shortest script with a fault that is found; of several cases, all their lines."""
    if len(played) == 1:
        played = [minimise.minimised(name, played[0], fault)]
        fault = runner.run(name, played[0])
    print(f"# {name}, case {number}, {fault[0]}: {fault[1][:600]}", minimise.script(name, played), "", sep="\n", flush=True)


def fuzz(name, count, seed, first=0):
    """Plays cases of a class; the number of faults."""
    ends, shown = collections.Counter(), collections.defaultdict(set)
    for number, (played, kind, what) in enumerate(ends_of(name, count, seed, first), first):
        if kind:
            (kind, what), played = confirmed(name, played, (kind, what))
        ends[kind or what] += 1
        if kind and is_new(shown[minimise.signature((kind, what))], minimise.calls(played[-1])):
            show(name, number, played, (kind, what))
    print(f"{name}: {count} cases,", ", ".join(f"{times} {end}" for end, times in ends.most_common()), flush=True)
    # Cases that nearly all end in a refusal would show nothing.
    return sum(times for end, times in ends.items() if end not in ("good", "refused", "stopped")) + (ends["good"] < count // 2)


def shared(names, count, seed):
    """Plays cases of classes in as many processes as there are cores."""
    cores = os.cpu_count() or 1
    running = [subprocess.Popen([sys.executable, __file__, str(count), *names[core::cores], f"--seed={seed}"])
               for core in range(cores)]
    return sum(process.wait() != 0 for process in running)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, help="cases a class")
    parser.add_argument("names", nargs="*", help="of classes; without them, all")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--part", default="1/1", help="of the classes, such as 2/3 for the second third")
    given = parser.parse_args()
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    part, parts = map(int, given.part.split("/"))
    if not given.names:
        return shared(introspection.all_classes()[part - 1::parts], given.count, given.seed)
    for name in given.names:
        if name not in introspection.all_classes():
            parser.error(f"there is no class {name}")
    return sum(fuzz(name, given.count, given.seed, given.first) for name in given.names)


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
