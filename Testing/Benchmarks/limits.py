# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Limits of kernels: what no code can go below on this machine, as measured in the same run.

A limit counts what the result itself asks for, not what the code happens to do: bytes of arrays that must be read or
written once, functions that must be evaluated, or the whole of another benchmark.
"""

import collections
import os
import re

#: Of benchmarks (regular expressions of program and name), whose items or bytes each take `work`: rates of
#: bench_machine on some threads (0: as many as VTK's filters use), with the amount of each.
Rates = collections.namedtuple("Rates", "program name threads work reason")
#: The time of another benchmark of the same program, so many times. \1 stands for the first group of the name.
Twin = collections.namedtuple("Twin", "program name other times reason")

FUNCTIONS = {"SinesAndCosines": 1, "Exponentials": 1}
ORBITS = "a sine with its cosine and an exponential for each particle and train (WaveOrbits), by SLEEF"
LIMITS = (
    Rates("bench_sway", r"SkinTrees/size:250", 1, {"ReadMemory": 36, "WriteMemory": 24},
          "36 bytes a vertex are read (point and normal of floats, and its share of a run of SkinBinding) and 24 written"),
    Rates("vtkbench_orbits", r"MoveParticles<float>/.*", 2, FUNCTIONS, ORBITS),
    Rates("vtkbench_classes", r"By(Kernel|Class)<Orbits>/.*", 0, FUNCTIONS, ORBITS),
    Rates("vtkbench_(particles|classes)", r"(FogOfAll|By(Kernel|Class)<Fog>)/.*", 0, {"ReadMemory": 12},
          "12 bytes a particle: its point is read once (vtkPoints of floats); the grid is small beside it"),
    Rates("vtkbench_scatter", r"AllInFull/.*", 0, {"WriteMemory": 1},
          "each byte of the output is written once; the prototypes stay in the cache"),
    Rates("vtkbench_(quadrats|classes)", r"(ScatterPoints|By(Kernel|Class)<Quadrats>)/.*", 0, {"WriteMemory": 56},
          "56 bytes a point are written: its place as doubles, two ids, and its cell of two ids (vtkQuadratPointSource)"),
    Twin("bench_terrain", r"FillPoints/threads:1/size:1048576/real_time", "AddSameBytes/real_time", 1.0,
         "one addition for each line and point, in the cache"),
    Twin("bench_terrain", r"FillPoints/threads:2/size:1048576/real_time", "AddSameBytes/real_time", 0.5,
         "one addition for each line and point, in the cache, on two threads"),
    Twin("bench_wind", r"LargeField/.*", "TransformsAlone/iterations:1", 1.0, "its Fourier transforms"),
    Twin("bench_sway", r"MoveForest/threads:(\d)/in full:1000/.*", r"TurnSamePoses/\1/real_time", 1.0,
         "each pose is turned once, read and written"),
    Twin("vtkbench_seaweed", r"StepForest/size:10000/.*", "StepMemory/size:10000/real_time", 20.0,
         "20 steps, each of which reads the segments and reads and writes states and poses"),
    Twin("vtkbench_drift", r"StepInPrimitives/walls:0/.*", "FunctionsAlone/real_time", 1.0,
         "its roots, divisions and exponentials by the standard library"),
    Twin("vtkbench_volumes", r"(Cloud|Wind)ByWriter/.*", r"\1ByOpenVDB/process_time/real_time", 1.0,
         "OpenVDB's own dense copy and write"),
)


def machine_rate(results, name, threads):
    """Bytes or items a second of a benchmark of bench_machine; None if it was not run."""
    threads = threads or int(os.environ.get("VTK_SMP_MAX_THREADS") or os.cpu_count())
    for result in results:
        if result.program == "bench_machine" and result.name == f"{name}/real_time/threads:{threads}":
            return result.rate
    return None


def share_by_rates(limit, result, results):
    rates = [machine_rate(results, name, limit.threads) for name in limit.work]
    if not result.rate or not all(rates):
        return None
    return result.rate * sum(amount / rate for amount, rate in zip(limit.work.values(), rates))


def share_by_twin(limit, result, results):
    twin = re.fullmatch(limit.name, result.name).expand(limit.other)
    for other in results:
        if (other.program, other.name) == (result.program, twin):
            return limit.times * other.time / result.time
    return None


def share_of(result, results):
    """Time at the limit over time of a result, and the limit; None where none is known or was measured."""
    for limit in LIMITS:
        if re.fullmatch(limit.program, result.program) and re.fullmatch(limit.name, result.name):
            share = (share_by_rates if isinstance(limit, Rates) else share_by_twin)(limit, result, results)
            return (share, limit) if share else None
    return None
