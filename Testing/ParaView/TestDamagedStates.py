# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""States that are cut off or noise are refused with a message, and what was there stays; one with a value that is none is
one message of the source. A program that draws without a display says so, and the picture that was there stays."""

import os
import random
import subprocess

import quick
from messages import complaints
from paraview import simple

DRAW = """
import sys
from paraview import simple
from littoral.gallery import views
view = simple.CreateRenderView(ViewSize=[30, 30])
views.save_view(sys.argv[1], view)
"""


def load(content):
    """What ParaView says to a state."""
    with open("damaged.pvsm", "wb") as file:
        file.write(content)

    def update():
        simple.LoadState("damaged.pvsm")
        for source in simple.GetSources().values():
            source.UpdatePipeline()

    return complaints(update)


def points():
    """Points of all sources."""
    return [source.GetDataInformation().GetNumberOfPoints() for source in simple.GetSources().values()]


hills = simple.TurningBandsTerrain(WholeExtent=[0, 20, 0, 20, 0, 0], registrationName="Hills")
hills.UpdatePipeline()
simple.SaveState("whole.pvsm")
with open("whole.pvsm", "rb") as state:
    whole = state.read()
damaged = [whole[:length] for length in (0, 1, 100, 3000, len(whole) // 2, len(whole) - 30)]
for content in damaged + [random.Random(1).randbytes(3000)]:
    text = load(content)
    assert "ERROR" in text, f"{len(content)} bytes: nothing is said"
    assert points() == [441], f"{len(content)} bytes: {points()}"

at = whole.index(b'value="', whole.index(b'name="Spacing"')) + len(b'value="')
for value in b"nan", b"some", b"-1e300", b"":
    simple.ResetSession()
    text = load(whole[:at] + value + whole[whole.index(b'"', at):])
    assert text.count("ERROR") == 1 and "Spacing, x is " in text, f"{value}: {text}"
    assert points() == [0], f"{value}: {points()}"
    simple.FindSource("Hills").Spacing = [2.0, 2.0, 1.0]
    simple.FindSource("Hills").UpdatePipeline()
    assert points() == [441], f"after {value}: {points()}"

simple.ResetSession()
assert load(whole) == "" and points() == [441]
os.remove("damaged.pvsm")

for program in ["pvbatch"]:
    with open("picture.png", "w", encoding="utf-8") as file:
        file.write("old")
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    with open("draw.py", "w", encoding="utf-8") as file:
        file.write(DRAW)
    ran = subprocess.run([program, "draw.py", "picture.png"], env=environment, capture_output=True, text=True)
    # A ParaView that needs no display draws.
    assert ran.returncode in (0, 1), ran
    if ran.returncode == 1:
        assert ran.stderr.splitlines()[-1].startswith("RuntimeError: There is no display to draw on: DISPLAY is not"), ran
        with open("picture.png", encoding="utf-8") as file:
            assert file.read() == "old"
