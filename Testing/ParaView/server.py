# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A server of one or more ranks for tests that run in pvpython."""

import contextlib
import os
import subprocess

import quick
from paraview import simple

#: What MPI leaves in the environment of pvpython would make the ranks of the server its own.
OWN_RANK = ("PMIX_", "OMPI_APP", "OMPI_ARGV", "OMPI_COMMAND", "OMPI_MCA_ess", "OMPI_MCA_orte", "OMPI_MCA_pmix")


def without_rank():
    """The environment for a process that is no rank of this one."""
    return {name: value for name, value in os.environ.items() if not name.startswith(OWN_RANK)}


@contextlib.contextmanager
def connected(port, ranks=1):
    """Connect to a new server; end with the client alone again."""
    launcher = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    server = subprocess.Popen([*launcher, "pvserver", f"--server-port={port}"], stdout=subprocess.PIPE,
                              stdin=subprocess.DEVNULL, env=without_rank())
    try:
        for line in server.stdout:
            if b"Accepting connection" in line:
                break
        simple.Connect("127.0.0.1", port)
        yield
        simple.Disconnect()
        simple.Connect()  # else the end of pvpython writes to the closed socket
    finally:
        end(server)


def end(server):
    """A server ends when its client leaves. SIGTERM on its way out can find it within malloc, where the handler that
    ParaView sets waits for ever; so what does not end is killed, the ranks of mpirun by mpirun."""
    try:
        server.wait(timeout=30)
    except subprocess.TimeoutExpired:
        server.terminate()
        try:
            server.wait(timeout=10)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()
