# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Kernels with lower sets of instructions: the library of numerics that hides the others (Testing/InstructionSets)."""

import os

#: Programs and benchmarks on one thread, each of another kernel with several versions.
KERNELS = {
    "bench_machine": r"^(SinesAndCosines|Exponentials)/.*threads:1$",
    "bench_sway": r"^SkinTrees/size:1$|^MoveForest/threads:1/in full:100/",
    "bench_terrain": r"^FillPoints/threads:1/size:1048576/",
    "bench_wind": r"^BetweenSteps$",
    "vtkbench_orbits": r"^MoveParticles<float>/depth:20/size:10000/",
    "vtkbench_seaweed": r"^StepLinks$",
}
#: Sets by names: of their library, and in /proc/cpuinfo.
SETS = {"SSE2": ("sse2", "sse2"), "AVX2": ("avx2", "avx2"), "AVX-512": (None, "avx512f")}


def sets_here(folder):
    """Names of the sets of this processor and the libraries for them; the widest is what the usual one takes."""
    with open("/proc/cpuinfo") as file:
        flags = next((line.split(":")[1].split() for line in file if line.startswith("flags")), [])
    names = [name for name, (_, flag) in SETS.items() if flag in flags]
    return {name: os.path.join(folder, f"libLittoralCommon-{SETS[name][0]}.so") if name != names[-1] else None
            for name in names}


def measure(programs, run, seconds=0.2):
    """Results of run(program, arguments, settings) by names of sets, each benchmark for some seconds at least; none where
    there are no such libraries."""
    found = {}
    for name, library in sets_here(os.path.join(os.path.dirname(programs[0]), "..", "lib", "instruction-sets")).items():
        if library and not os.path.exists(library):
            return {}
        # bench_machine itself calls SLEEF, by the name of the set.
        settings = {"LITTORAL_INSTRUCTIONS": name, **({"LD_PRELOAD": library} if library else {})}
        found[name] = []
        for program in programs:
            kernels = KERNELS.get(os.path.basename(program))
            if kernels:
                print(f"{os.path.basename(program)}, {name}:", flush=True)
                arguments = [f"--benchmark_filter={kernels}", f"--benchmark_min_time={seconds}"]
                found[name] += run(program, arguments, settings)
    return found
