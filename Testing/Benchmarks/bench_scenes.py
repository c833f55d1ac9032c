# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a scene in ParaView, and where their time goes.

    build/bin/littoral-env --display pvpython Testing/Benchmarks/bench_scenes.py SCENE [FRAMES [FILE.json]]

SCENE: forest or underwater, the examples of Examples/ParaView; forest-unlit or forest-plain, the forest without Landscape
Light, and that shown by ParaView's own Surface; or an entry of Sources > Littoral, such as SwayingForest.
Each of the FRAMES (default: 12) is a step of 1/12 s, or, where nothing moves, a turn of the camera by 1 degree: first the
pipeline is updated, then the picture is drawn, then drawn again, of the same scene. Printed, or written as JSON, are means
of wall and processor time [s] of update and first drawing ("render"); what of the update is spent in Littoral's algorithms,
in other ones, and outside of any; and of the rendering, "raster", which is the second drawing, and "upload and building",
the first less the second; the wall time until the first picture [s], the most memory of the process [MB], and what of its
memory are files, nearly all of them libraries [MB].

Where Landscape Light is shown, it is then hidden, a picture is drawn that does not count, and as many steps follow, each
updated and drawn once: update and render "without light", and "light", what the rendering takes longer with it.
"""

import json
import os
import resource
import runpy
import sys
import tempfile
import time

import numpy as np
from paraview import simple

import littoral

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "ParaView")
#: Entries of the menu, and whether each moves.
ENTRIES = {"Forest": False, "SwayingForest": True, "Sea": True, "Underwater": True, "TwinOfAPlace": False}
ENTRY_SIZE, EXAMPLE_SIZE = [640, 400], [960, 540]  # of the view [pixels]
RATE = 12.0  # frames a second of the scene's own time


def now():
    """Wall and processor time [s]."""
    return np.array((time.perf_counter(), time.process_time()))


def spent(work):
    """Time of some work [s]."""
    begin = now()
    work()
    return now() - begin


class Stopwatch:
    """Time in algorithms while it is on, by kind: each counts what it does itself, without the algorithms that it runs."""

    def __init__(self, watched):
        self.spent = {"in Littoral": np.zeros(2), "in other algorithms": np.zeros(2)}
        self.running = []
        self.is_on = False
        self.since = now()
        for algorithm in watched:
            kind = "in Littoral" if hasattr(littoral, algorithm.GetClassName()) else "in other algorithms"
            algorithm.AddObserver("StartEvent", lambda *_, kind=kind: self.turn(lambda: self.running.append(kind)))
            algorithm.AddObserver("EndEvent", lambda *_: self.turn(self.running.pop))

    def turn(self, change):
        """Give the time since the last turn to the algorithm that was running."""
        if self.running and self.is_on:
            self.spent[self.running[-1]] += now() - self.since
        change()
        self.since = now()


def algorithms(view):
    """All sources and filters, and what shows them."""
    found = set()
    for proxy in [*simple.GetSources().values(), *view.Representations]:
        made = proxy.SMProxy.GetClientSideObject()
        found.add(made)
        if hasattr(made, "GetActiveRepresentation"):
            found.add(made.GetActiveRepresentation())
    return [made for made in found if made and made.IsA("vtkAlgorithm")]


def of_entry(name):
    """Shows an entry; returns its view and what makes a step."""
    view = simple.CreateView("RenderView")
    view.ViewSize = ENTRY_SIZE
    simple.SetActiveView(view)
    simple.Show(getattr(simple, name)(), view)

    def step(number):
        if ENTRIES[name]:
            view.ViewTime = number / RATE
        else:
            view.GetActiveCamera().Azimuth(1.0)

    return view, step


def of_forest(functions, folder):
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = EXAMPLE_SIZE
    country = functions["build"](folder, view)
    functions["plan_walk"](country, view, 120)

    def step(number):
        functions["look"](country, view, number / 120.0)
        view.ViewTime = number / RATE

    return view, step


def of_unlit_forest(functions, folder):
    view, step = of_forest(functions, folder)
    hide_light(view)
    return view, step


def of_plain_forest(functions, folder):
    view, step = of_unlit_forest(functions, folder)
    for shown in view.Representations:
        if shown.Visibility and "Surface" in shown.GetProperty("Representation").Available:
            shown.Representation = "Surface"
    return view, step


def of_underwater(functions, folder):
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = EXAMPLE_SIZE
    functions["build"](folder, view)

    def step(number):
        view.ViewTime = functions["TIME"] + number / RATE

    return view, step


#: Each scene of an example: the example, and what shows it: returns its view and what makes a step.
EXAMPLES = {"forest": ("forest", of_forest), "forest-unlit": ("forest", of_unlit_forest),
            "forest-plain": ("forest", of_plain_forest), "underwater": ("underwater", of_underwater)}


def of_example(name, folder):
    """Builds a scene of an example, with files in a folder."""
    simple._DisableFirstRenderCameraReset()
    example, show = EXAMPLES[name]
    return show(runpy.run_path(os.path.join(FOLDER, f"{example}.py"), run_name=example), folder)


def update(view):
    """What a picture does before it is drawn: cameras are followed, and all that is shown is brought up to date."""
    view.SMProxy.InvokeEvent("StartEvent")
    view.SMProxy.Update()


def draw(view):
    """Draws what is up to date, until the picture is complete."""
    view.SMProxy.StillRender()
    view.GetRenderWindow().WaitForCompletion()


def hide_light(view):
    """Hide Landscape Light; tells whether it was shown."""
    lights = [shown for shown in view.Representations
              if shown.SMProxy.GetXMLName() == "LandscapeLightRepresentation" and shown.Visibility]
    for shown in lights:
        shown.Visibility = 0
    return bool(lights)


def measure_unlit(view, step, numbers):
    """Times of update and render of some steps without light, summed."""
    simple.Render(view)  # shaders are built anew
    updates, renders = np.zeros(2), np.zeros(2)
    for number in numbers:
        step(number)
        updates += spent(lambda: update(view))
        renders += spent(lambda: draw(view))
    return updates, renders


def memory_of_files():
    """Memory of files that the process has mapped [MB]."""
    with open("/proc/self/status", encoding="utf-8") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("RssFile")) / 1024.0


def measure(name, frames, folder):
    """Times and memory of a scene, whose files go into a folder."""
    begin = now()
    view, step = of_entry(name) if name in ENTRIES else of_example(name, folder)
    simple.Render(view)
    first = now() - begin
    watch = Stopwatch(algorithms(view))
    updates, renders, again = np.zeros(2), np.zeros(2), np.zeros(2)
    for number in range(1, frames + 1):
        step(number)
        watch.is_on = True
        updates += spent(lambda: update(view))
        watch.is_on = False
        renders += spent(lambda: draw(view))
        again += spent(lambda: draw(view))
    parts = {"update": updates, **watch.spent, "outside of any": updates - sum(watch.spent.values()), "render": renders,
             "upload and building": renders - again, "raster": again}
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    if hide_light(view):
        unlit = measure_unlit(view, step, range(frames + 1, 2 * frames + 1))
        parts.update({"update without light": unlit[0], "render without light": unlit[1], "light": renders - unlit[1]})
    return {"scene": name, "first picture": first[0], "frame": {part: list(all / frames) for part, all in parts.items()},
            "memory": memory, "memory of files": memory_of_files()}


def main(name, frames="12", filename=None):
    if name not in ENTRIES and name not in EXAMPLES:
        sys.exit(f"bench_scenes: there is no scene {name}; there are {', '.join([*EXAMPLES, *ENTRIES])}")
    with tempfile.TemporaryDirectory() as folder:
        text = json.dumps(measure(name, int(frames), folder), indent=1)
    if filename:
        with open(filename, "w") as file:
            file.write(text)
    else:
        print(text)


main(*sys.argv[1:])
