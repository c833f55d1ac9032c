# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Steps of make_entries.py inside ParaView's window: the inputs of the entry LITTORAL_ENTRY, or a mistake with it."""

import os
import sys

from paraview import servermanager, simple

sys.path.insert(0, os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Testing", "ParaView"))
import mistakes


def say_ready(word="ready"):
    with open(os.environ["LITTORAL_READY"], "w", encoding="utf-8") as file:
        file.write(word + "\n")


def stays(proxy):
    """Whether the inputs of a filter stay when it is shown."""
    hints = proxy.SMProxy.GetHints()
    visibility = hints.FindNestedElementByName("Visibility") if hints else None
    return visibility is not None and visibility.GetAttribute("replace_input") == "0"


def show(proxy, inputs=()):
    """As Apply does: each output in the view that it prefers, there in the place of the inputs."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    active = simple.GetActiveView()
    for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
        view = controller.ShowInPreferredView(proxy.SMProxy, port, active.SMProxy)
        if not view:
            continue
        controller.AssignViewToLayout(view)
        visible = [one for one in active.Representations if hasattr(one, "Input") and one.Visibility]
        if view != active.SMProxy or len(visible) == 1:
            simple.ResetCamera(servermanager._getPyProxy(view))  # pylint: disable=protected-access
        for one in inputs if view == active.SMProxy and not stays(proxy) else ():
            simple.Hide(one, active)
    simple.SetActiveSource(proxy)


def prepare(name):
    """A filter with its usual inputs, shown after them, in whose place it is; a source is made in the window."""
    simple.SetActiveView(simple.GetActiveViewOrCreate("RenderView"))
    if name == "LandscapeLight":
        show(simple.Forest())
        simple.RenderAllViews()
    given = mistakes.pv.shown_inputs(name)
    if not given:
        say_ready()
        return
    for one in [] if name.endswith("FromFits") else given.values():
        show(one)
        simple.RenderAllViews()
    show(getattr(simple, name)(**given), given.values())
    simple.RenderAllViews()
    say_ready("made")


def make_mistake(name):
    """The first mistake of an entry, shown as the window does it; a light has its properties in its display."""
    given = {"Forest": {"MeanPerQuadrat": -1.0}, "SwayingForest": {"ReferenceSpeed": -1.0},
             "Sea": {"SignificantWaveHeight": -1.0}, "Underwater": {"WindSpeed": -1.0},
             "TwinOfAPlace": {"Range": -1.0}, "LandscapeLight": {}}
    displayed = {"LandscapeLight": {"Turbidity": 0.0}}
    arguments = given[name] if name in given else next(
        mistake[1] for mistake in mistakes.MISTAKES if mistake[0] == name)()
    simple.SetActiveView(simple.GetActiveViewOrCreate("RenderView"))
    proxy = getattr(simple, name)(**arguments)
    show(proxy)
    for one, value in displayed.get(name, {}).items():
        setattr(simple.GetRepresentation(proxy, simple.GetActiveView()), one, value)
    say_ready()


simple._DisableFirstRenderCameraReset()  # pylint: disable=protected-access
{"first look": prepare, "mistake": make_mistake}[os.environ["LITTORAL_ROLE"]](os.environ["LITTORAL_ENTRY"])
