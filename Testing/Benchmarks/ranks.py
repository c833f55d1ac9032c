# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Work and memory of a rank on 1, 2 and 3 ranks, over the classes whose output comes in pieces.

A rank asks for its piece of the output of a pipeline and for nothing else, as in ParaView's servers. So each piece is
made by a process of its own, one after the other: what ranks take from each other, cores and memory's bandwidth, is not
in these numbers, and neither is the sending of data. Those that exchange numbers (TOGETHER) are made side by side
by MPI, with all of that. A rank that waits for another does so busily, which is no work: where there is mpicc,
mpi_waiting.c tells it apart, and a row of what is left follows that of the whole. Strong scaling divides the same work;
weak scaling gives n ranks n times the work. T(n) = s + p / n is fitted to the processor time of the rank that takes
longest. Charts of both, ranks-strong.svg and ranks-weak.svg in the current folder, have that time over the time of one
rank.
"""

import ctypes
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import scaling  # noqa: E402

RANKS = (1, 2, 3)
PROJECTED = (64, 1024)


def terrain(pv, scale):
    return pv.TurningBandsTerrain(WholeExtent=[0, 3000, 0, 3000 * scale, 0, 0])


def wind(pv, scale):
    return pv.WindField(Dimensions=[8192, 32 * scale, 32])


def sections(pv, scale):
    return pv.ImageSections(Input=wind(pv, scale), CrossSections=100)


def sites(pv, scale):
    return pv.QuadratPoints(Size=[4000.0 * scale, 4000.0], Quadrats=[400 * scale, 400], MeanPerQuadrat=10.0)


def shrub(pv, _):
    return pv.ReevesTree(Preset="Shrub")


def instances(pv, scale):
    return pv.PlantScatter(Sites=sites(pv, scale), Prototypes=shrub(pv, scale), OutputForm="Instances", UseCulling=0)


def sea_surface(pv, scale):
    return pv.SeaSurface(Input=pv.SeaState(NumberOfTrains=100 * scale), Sectors=1000)


def particles(pv, scale):
    return pv.SuspendedParticles(Bounds=[-200.0, 200.0 * (2 * scale - 1), -200.0, 200.0, -50.0, 0.0], Density=0.1)


def orbits(pv, scale):
    return pv.ParticleOrbits(Input=particles(pv, scale), SeaState=pv.SeaState(NumberOfTrains=30))


def fog(pv, scale):
    return pv.ParticleFog(Input=particles(pv, scale), Dimensions=[200, 200, 50])


def statistics(pv, scale):
    return pv.PointPatternStatistics(Input=pv.QuadratPoints(Size=[1000.0 * scale, 1000.0],
                                                            Quadrats=[40 * scale, 40], MeanPerQuadrat=10.0))


def kriging(pv, scale):
    survey = pv.QuadratPoints(Size=[1000.0, 1000.0], Quadrats=[20, 20], MeanPerQuadrat=1.0)
    heights = pv.SitePreference(Sites=survey, Terrain=pv.TurningBandsTerrain(WholeExtent=[0, 250, 0, 250, 0, 0],
                                                                             Spacing=[4.0, 4.0, 1.0]))
    return pv.ConditionalTerrain(Input=heights, Dimensions=[800, 800 * scale])


def canopy(pv, scale):
    return pv.ForestDensity(Input=instances(pv, scale), CellSize=[4.0, 4.0, 1.0])


def drainage(pv, scale):
    return pv.Drainage(Input=pv.TurningBandsTerrain(WholeExtent=[0, 500, 0, 500 * scale, 0, 0]), Carve=0)


CASES = {"terrain": terrain, "wind": wind, "sections of a wind": sections, "points of quadrats": sites,
         "scatter to instances": instances, "its prototype": shrub, "sea surface": sea_surface,
         "suspended particles": particles, "orbits": orbits, "fog": fog, "K and g": statistics, "kriging": kriging,
         "leaf area in cells": canopy, "drainage": drainage}
TOGETHER = ("wind", "sections of a wind", "K and g", "scatter to instances", "leaf area in cells")


def build_preloaded(folder, name="mpi_waiting"):
    """The library that tells waiting apart, or counts what is received; None where no compiler makes it."""
    library = os.path.join(folder, f"lib{name}.so")
    source = Path(__file__).resolve().parent / f"{name}.c"
    if not shutil.which("mpicc"):
        return None
    made = subprocess.run(["mpicc", "-O2", "-shared", "-fPIC", "-o", library, source], capture_output=True, check=False)
    return library if made.returncode == 0 else None


def seconds_waited():
    """Processor time of this thread that went into waiting so far; 0 where nothing tells it apart."""
    try:
        waited = ctypes.CDLL(None).SecondsWaited
    except AttributeError:
        return 0.0
    waited.restype = ctypes.c_double
    return waited()


def on_ranks(ranks, preloaded, *command):
    """Command line that starts a command on some ranks, with such a library, if any."""
    return ["mpirun", "-np", str(ranks), *(["env", f"LD_PRELOAD={preloaded}"] if preloaded else []), *command]


def update(name, scale, piece, pieces):
    """Makes a piece in this process: processor time [s], that without waiting, and memory [MB] that it took."""
    from vtk_proxies import VtkProxies

    made = []  # so that nothing is given back before it is measured
    pv = VtkProxies(made.append)
    output = CASES[name](pv, scale)
    before, waited = resource.getrusage(resource.RUSAGE_SELF), seconds_waited()
    output.UpdatePiece(piece, pieces, 0)
    after, waited = resource.getrusage(resource.RUSAGE_SELF), seconds_waited() - waited
    if output.GetErrorCode():
        raise SystemExit(f"{name}: piece {piece} of {pieces} failed")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"seconds": seconds, "work": seconds - waited,
            "megabytes": (after.ru_maxrss - before.ru_maxrss) / 1024}


def update_together(name, scale, folder):
    """Makes the piece of this rank, and writes what it took."""
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    ranks = vtkMPIController()
    ranks.Initialize()
    vtkMultiProcessController.SetGlobalController(ranks)
    took = update(name, scale, ranks.GetLocalProcessId(), ranks.GetNumberOfProcesses())
    Path(folder, str(ranks.GetLocalProcessId())).write_text(json.dumps(took))


def measured_together(name, scale, ranks):
    """What each rank takes."""
    with tempfile.TemporaryDirectory() as folder:
        ranks_yield = {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"}  # else one that waits takes a whole core
        waiting = build_preloaded(folder) if ranks > 1 else None
        subprocess.run(on_ranks(ranks, waiting, sys.executable, __file__, name, str(scale), folder), check=True,
                       env=ranks_yield)
        return [json.loads(Path(folder, str(rank)).read_text()) for rank in range(ranks)]


def measured_in_turn(name, scale, pieces):
    """What each piece takes, made by a process of its own, one after the other."""
    found = []
    for piece in range(pieces):
        done = subprocess.run([sys.executable, __file__, name, str(scale), str(piece), str(pieces)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(done.stderr)
        found.append(json.loads(done.stdout.splitlines()[-1]))
    return found


def measured(name, scale, pieces):
    """The most that a rank takes: processor time and memory."""
    found = (measured_together if name in TOGETHER else measured_in_turn)(name, scale, pieces)
    return {key: max(one[key] for one in found) for key in found[0]}


def model_of(times):
    """s and p of T(n) = s + p / n, by least squares, neither below 0."""
    x = [1.0 / n for n in times]
    mean_x, mean_t = sum(x) / len(x), sum(times.values()) / len(x)
    p = sum((a - mean_x) * (t - mean_t) for a, t in zip(x, times.values())) / sum((a - mean_x) ** 2 for a in x)
    if p <= 0.0:
        return mean_t, 0.0
    s = mean_t - p * mean_x
    return (s, p) if s >= 0.0 else (0.0, sum(t * a for a, t in zip(x, times.values())) / sum(a * a for a in x))


def line_of(name, strong, weak, seconds):
    """A row of the table, of the processor time by a key."""
    s, p = model_of({n: one[seconds] for n, one in strong.items()})
    gains = [(s + p) / (s + p / n) for n in PROJECTED]
    alone = strong[1]
    cells = [name, f"{alone[seconds]:.2f}", *(f"{strong[n][seconds] / alone[seconds]:.2f}" for n in RANKS[1:]),
             f"{alone['megabytes']:.0f}", *(f"{strong[n]['megabytes'] / max(1.0, alone['megabytes']):.2f}"
                                            for n in RANKS[1:]),
             f"{weak[seconds] / alone[seconds]:.2f}", f"{s / (s + p):.2f}", *(f"{gain:.1f}" for gain in gains)]
    return "| " + " | ".join(cells) + " |"


def print_lines(name):
    """Rows of a case: of all processor time, and without waiting where it is told apart. Returns its scaling: names, and
    times over that of one rank by ranks, strong and weak."""
    strong = {n: measured(name, 1, n) for n in RANKS}
    weak = measured(name, RANKS[-1], RANKS[-1])
    kinds = {"seconds": name}
    if any(one["work"] < one["seconds"] for one in strong.values()):
        kinds["work"] = f"{name}, without waiting"
    found = []
    for key, words in kinds.items():
        print(line_of(words, strong, weak, key), flush=True)
        alone = strong[1][key]
        found.append((words, [(n, strong[n][key] / alone) for n in RANKS], [(1, 1.0), (RANKS[-1], weak[key] / alone)]))
    return found


def write_charts(found):
    """Charts of strong and of weak scaling."""
    for kind, index, what in (("strong", 1, "the same work"), ("weak", 2, "n times the work")):
        series = [scaling.Series("ranks", one[0], one[index]) for one in found]
        Path(f"ranks-{kind}.svg").write_text(
            scaling.chart(f"A rank of n, {what}: time over that of one rank alone", series, "ranks"))


def main(names):
    """The table of the cases, as text of Markdown, and the charts."""
    head = ["what", "CPU [s]", *(f"{n} ranks" for n in RANKS[1:]), "memory [MB]", *(f"{n} ranks" for n in RANKS[1:]),
            "thrice the work on 3", "s / (s + p)", *(f"gain on {n}" for n in PROJECTED)]
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head), flush=True)
    write_charts([one for name in names or CASES for one in print_lines(name)])


if __name__ == "__main__":
    if len(sys.argv) == 5 and sys.argv[2].isdigit():
        print(json.dumps(update(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]))))
    elif len(sys.argv) == 4 and os.path.isdir(sys.argv[3]):
        update_together(sys.argv[1], int(sys.argv[2]), sys.argv[3])
    else:
        main(sys.argv[1:])
