# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run as Markdown: machine, limits, kernels, other tools, papers, cost over size, frames of the scenes."""

import os
import platform
import re

import limits
import papers
import scaling


def read(filename):
    try:
        with open(filename, errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def machine():
    """Rows about the machine: what, and which."""
    processor = read("/proc/cpuinfo")
    found = {key: (re.search(rf"^{key}\s*:\s*(.*)$", text, re.MULTILINE) or ["", ""])[1] for key, text in
             (("model name", processor), ("flags", processor), ("MemTotal", read("/proc/meminfo")))}
    flags = found["flags"].split()
    levels = [name for flag, name in (("sse2", "SSE2"), ("avx2", "AVX2"), ("avx512f", "AVX-512")) if flag in flags]
    memory = found["MemTotal"].split()
    load = f"{os.getloadavg()[0]:.1f}"
    return [("processor", found["model name"] or platform.processor() or platform.machine()),
            ("cores", str(os.cpu_count())),
            ("memory", f"{int(memory[0]) / 1048576:.1f} GiB" if memory else "unknown"),
            ("instruction sets", ", ".join(levels) or "unknown"),
            ("threads of VTK", os.environ.get("VTK_SMP_MAX_THREADS", "VTK's own choice")),
            ("load at the end (1 min)", load),
            ("system", platform.platform())]


def table(head, rows):
    """Lines of a table."""
    def line(cells):
        return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"

    return [line(head), "|" + "---|" * len(head), *map(line, rows), ""]


def figures(time):
    """A time [ms] with four figures that mean something."""
    return f"{time:.4g}" if time < 1e4 else f"{time:.0f}"


def rate_of(result):
    """Throughput in words."""
    if result.bytes_per_second:
        return f"{1e-9 * result.bytes_per_second:.3g} GB/s"
    return f"{1e-6 * result.items_per_second:.3g} million/s" if result.items_per_second else ""


def of_machine(results):
    rows = [(result.name.replace("/real_time", ""), rate_of(result), result.note)
            for result in results if result.program == "bench_machine"]
    if not rows:
        return ["bench_machine was not run, so shares of its limits are not known.", ""]
    lines = [*table(("limit", "rate", ""), rows),
             "Programs keep the memory that they give back, as those that run for long do, and each benchmark is run before "
             "it is timed: what the first use of memory costs on this machine is NewMemory.", ""]
    if not any(name.startswith("Exponentials") for name, *_ in rows):
        lines += ["Functions of vectors were not measured: the benchmarks were built without SLEEF.", ""]
    return lines


def of_kernels(results):
    rows, reasons = [], []
    for result in results:
        if result.program == "bench_machine":
            continue
        known = limits.share_of(result, results)
        if known and known[1].reason not in reasons:
            reasons.append(known[1].reason)
        share = f"{100.0 * known[0]:.3g} % ({reasons.index(known[1].reason) + 1})" if known else ""
        rows.append((result.program, result.name, figures(result.time), rate_of(result), share))
    notes = [f"{number}. {reason}" for number, reason in enumerate(reasons, 1)]
    return ["Share: the time at the limit over the time taken; the number names the limit below. Times are real times "
            "where the name says so, else those of the processor.", "",
            *table(("program", "benchmark", "time [ms]", "rate", "share of the limit"), rows), *notes, ""]


#: Least rate of a kernel that its class is to have.
LEAST_SHARE = 0.7


def of_classes(results):
    """Kernels beside the classes that call them, at the same work on as many threads (vtkbench_classes)."""
    ran = {result.name: result for result in results if result.program == "vtkbench_classes"}
    rows = []
    for name, kernel in ran.items():
        owner = ran.get(name.replace("ByKernel<", "ByClass<"))
        if not name.startswith("ByKernel<") or not owner:
            continue
        limits_of = [limits.share_of(one, results) for one in (kernel, owner)]
        share = kernel.time / owner.time
        rows.append((re.search("<(.*)>", name)[1], figures(kernel.time), figures(owner.time), f"{100.0 * share:.3g} %",
                     "" if share >= LEAST_SHARE else f"below {100.0 * LEAST_SHARE:.0f} %",
                     *(f"{100.0 * known[0]:.3g} %" if known else "" for known in limits_of)))
    if not rows:
        return ["Classes were not set beside their kernels.", ""]
    return ["A kernel of Common alone, in memory that it has already, and the update of the class that calls it; share: the "
            "kernel's time over the class's. Where a limit is known, the share of it of each.", "",
            *table(("work", "kernel [ms]", "class [ms]", "share", "", "kernel, of its limit", "class, of its limit"), rows)]


def of_threads(threads):
    """threads: medians [ms] on one thread and on two, by program and benchmark."""
    if not threads:
        return ["Two threads were not compared with one.", ""]
    rows = [(*key, figures(one), figures(two), f"{one / two:.2f}") for key, (one, two) in threads.items()]
    return ["Medians of real times [ms] of runs in turn, on one thread of VTK and on two.", "",
            *table(("program", "benchmark", "one", "two", "one over two"), rows)]


def of_sets(sets):
    """sets: results of the same kernels by names of sets of instructions."""
    if not sets:
        return ["Sets of instructions were not compared.", ""]
    names = list(sets)
    times = {name: {(one.program, one.name): one.time for one in results} for name, results in sets.items()}
    rows = [(*key, *(figures(times[name][key]) if key in times[name] else "" for name in names))
            for key in times[names[-1]]]
    return ["Times [ms] on one thread, with the widest instructions and with those that hide wider ones.", "",
            *table(("program", "benchmark", *names), rows)]


def of_sizes(series, charts):
    if not series:
        return ["No benchmark was run with two sizes.", ""]
    rows = []
    for one in series:
        exponent = scaling.exponent_of(one.points)
        rows.append((one.program, one.name, f"{one.points[0][0]} to {one.points[-1][0]}", f"{exponent:.2f}",
                     f"above {scaling.STEEP}" if exponent > scaling.STEEP else "", scaling.logarithm_of(one)))
    return ["Exponent of time over size, by least squares of logarithms.", "",
            *table(("program", "benchmark", "sizes", "exponent", "", "n log n by"), rows),
            *[f"![{name}]({name})" for name in charts], ""]


def of_peers(peers, silence, results):
    """peers: what peers.py has measured; silence: what it has not, if so."""
    rows = []
    for peer, time in peers:
        for result in results:
            if (result.program, result.name) == (peer.program, peer.name):
                rows.append((peer.work, figures(result.real), figures(result.processor), peer.tool, figures(time),
                             f"{result.real / time:.2f}", f"{result.processor / time:.2f}"))
    if not rows:
        return [silence or "No peers were measured.", ""]
    return ["Times of other tools are the least of some runs on one thread. Ratios are Littoral's time over theirs: by real "
            "time, with the threads that the benchmark has, and by the processor's time of all threads.", "",
            *table(("work", "real [ms]", "processor [ms]", "peer", "its time [ms]", "ratio", "ratio by processor"), rows),
            *([silence, ""] if silence else [])]


def of_frames(scenes, silence):
    """scenes: what bench_scenes.py has measured; silence: why it has not, if so."""
    if not scenes:
        return [silence, ""]
    rows = []
    for scene in scenes:
        for part, (wall, processor) in scene["frame"].items():
            rows.append((scene["scene"], part, figures(1e3 * wall), figures(1e3 * processor)))
        rows.append((scene["scene"], "first picture", figures(1e3 * scene["first picture"]), ""))
    return ["Means of a frame. The update makes no picture, and is the sum of the three parts below it; rendering follows, "
            "until the picture is complete. Algorithms are the sources, filters and representations of the scene, with what "
            "runs inside of them.", "",
            "The graphics library does not tell raster and upload apart, so each picture is drawn a second time, of the "
            "same scene, in which nothing is new. *Raster* is that second rendering: it draws all again, and has what VTK "
            "does for each picture. *Upload and building* is the first rendering less the second: buffers, textures and "
            "shaders made anew of what has changed, and sent. It is a difference of two times, so it scatters as both do, "
            "and may come out below 0.", "",
            "*Without light* are further steps with Landscape Light hidden; *light* is what a rendering takes longer with it.",
            "",
            *table(("scene", "part", "wall time [ms]", "processor time [ms]"), rows),
            *table(("scene", "most memory [MB]"), [(scene["scene"], f"{scene['memory']:.0f}") for scene in scenes])]


def page(results, charts, sets, threads, scenes, silence, peers=(), no_peers=""):
    """The whole report."""
    lines = ["# Benchmarks of Littoral", "", "## Machine", "", *table(("what", "which"), machine()),
             "## Limits of the machine", "", *of_machine(results), "## Kernels", "", *of_kernels(results),
             "## Classes beside their kernels", "", *of_classes(results),
             "## Sets of instructions", "", *of_sets(sets), "## Two threads", "", *of_threads(threads),
             "## Beside other tools", "", *of_peers(peers, no_peers, results),
             "## The papers", "", *papers.lines(results, table),
             "## Cost over size", "", *of_sizes(scaling.series_of(results), charts),
             "## Frames of the scenes", "", *of_frames(scenes, silence)]
    return "\n".join(lines)
