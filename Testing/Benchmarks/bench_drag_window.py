# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures a second of an entry that the mouse drags in ParaView's window, and the processor time of one.

    build/bin/littoral-env xvfb-run -a -s "-screen 0 1280x1024x24" python3 Testing/Benchmarks/bench_drag_window.py [ENTRY...]

ENTRY: of Sources > Littoral, default Forest. It is shown as a user shows it, and dragged around by xdotool for some
seconds, once without its light and once with it. Printed are the size of the view, pictures a second by the clock, the
median processor time of the client for a picture and for the still one after the drag [s], and the load of the machine;
other programs that run lower the first and hardly the others. With a folder in LITTORAL_DRAG_PICTURES the last picture of
the drag and the one at rest are kept there. Needs xdotool.
"""

import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time

SECONDS = 8.0  # of a drag
TURN = 6.0  # in which the mouse goes around once [s]
PATIENCE = 300.0  # with a window that opens [s]


# --- in the window --------------------------------------------------------------------------------


def picture_of(window):
    """What a window shows."""
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    return grab.GetOutput()


def keep(picture, folder, name):
    from vtkmodules.vtkIOImage import vtkPNGWriter
    writer = vtkPNGWriter()
    writer.SetInputData(picture)
    writer.SetFileName(os.path.join(folder, f"{name}.png"))
    writer.Write()


def show(entry, has_light, log):
    """Shows an entry and writes a line for each picture from then on."""
    from paraview import simple
    view = simple.GetActiveView()
    simple.Show(getattr(simple, entry)(), view)
    simple.Render(view)
    light = simple.FindSource("Light")
    if light and not has_light:
        simple.Hide(light, view)
        simple.Render(view)
    window, last = view.GetRenderWindow(), []

    def end(*_):
        is_drag = window.GetDesiredUpdateRate() > 1.0
        with open(log, "a", encoding="utf-8") as out:
            out.write(json.dumps([time.time(), time.process_time(), is_drag]) + "\n")
        folder, name = os.environ.get("LITTORAL_DRAG_PICTURES"), f"{entry}-{'light' if has_light else 'plain'}"
        if folder and not is_drag and last:
            keep(last.pop(), folder, f"{name}-drag")
            keep(picture_of(window), folder, f"{name}-rest")
        elif folder:
            last[:] = [picture_of(window)] if is_drag else []

    window.AddObserver("EndEvent", end)
    with open(log, "w", encoding="utf-8") as out:
        out.write(json.dumps(list(view.ViewSize)) + "\n")


# --- the mouse ------------------------------------------------------------------------------------


def mouse(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def lines_of(log):
    with open(log, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def wait_for(log):
    """Waits until the entry is shown."""
    end = time.time() + PATIENCE
    while not os.path.exists(log):
        if time.time() > end:
            raise TimeoutError("the window shows nothing")
        time.sleep(0.5)
    time.sleep(3.0)  # pictures of a window that has just opened


def drag():
    """Drags around in the lower right part of the window, where the view is; the time of its begin and end."""
    x, y, wide, high = 900, 620, 120, 15
    mouse("mousemove", x + wide, y, "mousedown", 1)
    begin = time.time()
    while (since := time.time() - begin) < SECONDS:
        angle = 2.0 * math.pi * since / TURN
        mouse("mousemove", int(x + wide * math.cos(angle)), int(y + high * math.sin(angle)))
        time.sleep(0.02)
    mouse("mouseup", 1)
    return begin, begin + SECONDS


def measure(entry, has_light):
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "pictures")
        environment = {**os.environ, "LITTORAL_DRAG": json.dumps([entry, has_light, log])}
        with subprocess.Popen(["paraview", "--dr", f"--script={os.path.abspath(__file__)}"], env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as client:
            try:
                wait_for(log)
                begin, end = drag()
                time.sleep(6.0)
            finally:
                client.kill()
        size, *pictures = lines_of(log)
    dragged = [one for one in pictures if begin < one[0] < end and one[2]]
    apart = [after[1] - before[1] for before, after in zip(dragged, dragged[1:])]
    last = next(one for one in pictures if one[0] > end and not one[2])
    print(f"{entry} {'with' if has_light else 'without'} light, {size[0]} x {size[1]}: {len(dragged) / SECONDS:.1f} a second, "
          f"{statistics.median(apart):.2f} s, longest {max(apart):.2f} s; at rest again "
          f"after {last[0] - end:.1f} s; load {os.getloadavg()[0]:.1f}", flush=True)


if "LITTORAL_DRAG" in os.environ:
    show(*json.loads(os.environ["LITTORAL_DRAG"]))
else:
    for name in sys.argv[1:] or ["Forest"]:
        for is_lit in (False, True):
            measure(name, is_lit)
