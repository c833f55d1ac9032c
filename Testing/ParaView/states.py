# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a session shows, and what brings it back: a .pvsm after a reset, a .py in a new process."""

import os
import subprocess
import sys

import numpy as np
import quick
from paraview import simple, smstate
from server import without_rank
from window import apart, picture


def parts():
    """Names and types of what is in the pipeline browser."""
    return sorted(f"{key[0]} {source.GetXMLName()}" for key, source in simple.GetSources().items())


def visible(view):
    """Names of what a view shows."""
    shown = [display for display in view.Representations if hasattr(display, "Input") and display.Visibility]
    names = {source.GetGlobalIDAsString(): key[0] for key, source in simple.GetSources().items()}
    return sorted(names[display.Input.GetGlobalIDAsString()] for display in shown)


def snapshot(size, time):
    """The parts, and of each view what it shows and its picture at a time."""
    views, pictures = simple.GetRenderViews(), []
    for view in views:
        view.ViewSize, view.ViewTime = list(size), time
        simple.SetActiveView(view)  # whose camera filters follow
        simple.Render(view)  # after a Python state the first picture has the levels of detail of another place
        pictures.append(picture(view))
    return {"parts": np.array(parts()), "shown": np.array([" ".join(visible(view)) for view in views]),
            "pictures": np.array(pictures)}


def compare(back, wanted, what):
    """Nothing is missing or new; views may have another order."""
    assert list(back["parts"]) == list(wanted["parts"]), f"{what}: parts {back['parts']}, not {wanted['parts']}"
    assert len(back["shown"]) == len(wanted["shown"]), f"{what}: {len(back['shown'])} views"
    for shown, one in zip(wanted["shown"], wanted["pictures"]):
        others = [apart(one, other) for other in back["pictures"]]
        nearest = int(np.argmin(others))
        assert others[nearest] < 0.002, f"{what}: {others[nearest]:.2%} of the picture of {shown} is another"
        assert back["shown"][nearest] == shown, f"{what}: {back['shown'][nearest]} is shown, not {shown}"


def check(size, time, what):
    """Both kinds of state bring back the session, which is then that of the .pvsm."""
    wanted = snapshot(size, time)
    simple.SaveState("state.pvsm")
    with open("state.py", "w", encoding="utf-8") as script:
        script.write(smstate.get_state())
    simple.ResetSession()
    simple.LoadState("state.pvsm")
    times = {view.ViewTime for view in simple.GetRenderViews()}
    assert times == {time}, f"{what}, .pvsm: the times are {times}, not {time}"
    compare(snapshot(size, time), wanted, f"{what}, .pvsm")
    compare(in_new_process("state.py", size, time), wanted, f"{what}, .py")
    print(f"{what}: {len(wanted['parts'])} parts and {len(wanted['shown'])} pictures are back", flush=True)


def in_new_process(script, size, time):
    """What a script shows, run as users do; ParaView 6.1 draws no blocks that it shows after a reset."""
    subprocess.run(["pvpython", os.path.abspath(__file__), script, *map(str, size), str(time)], check=True,
                   env=without_rank())
    with np.load("back.npz") as back:
        return dict(back)


if __name__ == "__main__":
    file, width, height, at = sys.argv[1:]
    with open(file, encoding="utf-8") as source:
        exec(compile(source.read(), file, "exec"), {"__name__": "__main__"})
    np.savez("back.npz", **snapshot((int(width), int(height)), float(at)))  # ParaView's Python states have no time
