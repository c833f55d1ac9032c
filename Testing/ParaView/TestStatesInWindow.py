# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""A state saved and loaded by the menus of the window, and a trace of the same steps: the picture is that of the steps.

The trace is run by a new process without a window.
"""

import os
import subprocess
import sys

from player import Session, difference, drawn
from server import without_rank

SIZE = [300, 300]


def keep_trace(file):
    """In the client: end the trace as Stop Trace does, and write it; the window's editor would wait for an answer."""
    from paraview import smtrace

    with open(file, "w") as script:
        script.write(smtrace.stop_trace())


def run_trace(file):
    """In pvpython: run a trace and keep its picture."""
    from paraview import simple

    with open(file) as script:
        exec(compile(script.read(), file, "exec"), {"__name__": "__main__"})
    view = simple.GetActiveView()
    view.ViewSize = SIZE
    simple.SaveScreenshot("traced.png", view, ImageResolution=SIZE)


def record():
    """Eelgrass, with a trace; the state into an empty session."""
    session = Session(__file__)
    session.menu("menuTools", "actionToolsStartStopTrace")
    session.event("TraceOptionsDialog/widget/OKButton")
    session.source("Seaweed")
    session.choose("Preset", "Eelgrass")
    session.apply()
    session.call(keep_trace, "trace.py")
    session.look("wanted")
    session.save_state("window.pvsm")
    session.reset()
    session.load_state("window.pvsm")
    session.small_view()  # for the old view: off
    session.small_view()
    session.look("loaded")
    session.play()


def compare(what, file):
    part = difference(file, "wanted.png")
    print(f"{what}: {part:.2%} of the picture is another", flush=True)
    assert part < 0.002, f"{what}: {part:.2%} of the picture is another"


if len(sys.argv) == 2:
    run_trace(sys.argv[1])
elif __name__ == "__main__":
    record()
    assert drawn("wanted.png") > 0.01, "nothing is drawn"
    compare("state", "loaded.png")
    subprocess.run(["pvpython", os.path.abspath(__file__), "trace.py"], check=True, env=without_rank())
    compare("trace", "traced.png")
