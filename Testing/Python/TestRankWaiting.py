# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for other ranks is told apart from work: of a rank that waits nearly all processor time, of one that another
waits for none; the moving of data is work.

The file starts itself on two ranks; each writes what it has seen."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Benchmarks"))
import ranks  # noqa: E402

LATE = 1.0  # [s] that the first rank comes late
NUMBERS = 8_000_000
TAG = 7
FASTEST = 2e10  # [bytes/s] at which memory is copied


def array(numbers):
    from vtkmodules.vtkCommonCore import vtkDoubleArray

    made = vtkDoubleArray()
    made.SetNumberOfValues(numbers)
    made.Fill(1.0)
    return made


def waits(controller, rank):
    """Names of ways to wait for the first rank, and what each rank does."""
    own, all_of_them, message = array(1), array(2), array(1)
    yield "barrier", controller.Barrier
    yield "gather", lambda: controller.AllGather(own, all_of_them)
    yield "broadcast", lambda: controller.Broadcast(message, 0)
    yield "message", lambda: (controller.Receive if rank else controller.Send)(message, 1 - rank, TAG)


def took(task):
    """Processor time of a task: that of waiting, and the rest [s]."""
    begin, waited = time.process_time(), ranks.seconds_waited()
    task()
    waited = ranks.seconds_waited() - waited
    return waited, time.process_time() - begin - waited


def run(folder):
    from mpi4py import MPI  # noqa: F401, begins and ends MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController

    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    rank = controller.GetLocalProcessId()
    seen = {}
    for name, task in waits(controller, rank):
        controller.Barrier()
        if rank == 0:
            time.sleep(LATE)
        seen[name] = took(task)
    large = array(NUMBERS)
    controller.Barrier()
    seen["large"] = took(lambda: (controller.Receive if rank else controller.Send)(large, 1 - rank, TAG))
    Path(folder, str(rank)).write_text(json.dumps(seen))


def main():
    try:
        import mpi4py  # noqa: F401
        import vtkmodules.vtkParallelMPI  # noqa: F401
    except ImportError:
        print("there is no MPI in this VTK or Python")
        sys.exit(125)
    with tempfile.TemporaryDirectory() as folder:
        waiting = ranks.build_preloaded(folder)
        if not waiting or not shutil.which("mpirun"):
            print("there is no mpirun or no compiler for MPI")
            sys.exit(125)
        command = ranks.on_ranks(2, waiting, sys.executable, os.path.abspath(__file__), folder)
        # A rank that waits does so busily, also on cores that others want.
        subprocess.run(command, check=True, timeout=100, env={**os.environ, "OMPI_MCA_mpi_yield_when_idle": "0"})
        first, second = (json.loads(Path(folder, str(rank)).read_text()) for rank in range(2))
    for name, (waited, worked) in second.items():
        print(f"{name}: waited {waited:.3f} s, worked {worked:.3f} s; the first {first[name]}")
    for name in ("barrier", "gather", "broadcast", "message"):
        waited, worked = second[name]
        assert 0.1 * LATE < waited < 1.5 * LATE and worked < 0.05 * waited, f"{name}: {second[name]}"
        assert first[name][0] < 0.05 * LATE, f"{name}: the first rank, which is late, has waited {first[name][0]} s"
    assert second["large"][1] > 8 * NUMBERS / FASTEST, f"the moving of data is no work: {second['large']}"


if __name__ == "__main__":
    run(sys.argv[1]) if len(sys.argv) > 1 else main()
