# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays what a user does in ParaView's window: clicks by the names of the widgets, with ParaView's own test player.

A test adds steps to a Session and plays them. Checks between the steps are functions of the test's own file, called in
the client by name. A call clears what can be undone, as all of Python does in ParaView. No step may print a message that
is not expected.
"""

import html
import importlib
import json
import os
import signal
import subprocess
import sys
import traceback

import numpy as np
from paraview.simple import GetParaViewVersion
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

WINDOW = "pqClientMainWindow"
PIPELINE = f"{WINDOW}/pipelineBrowserDock/pipelineBrowser"
SHELL = f"{WINDOW}/pythonShellDock/pythonShell/consoleWidget"
PROPERTIES = f"{WINDOW}/propertiesDock/propertiesPanel"
PANEL = f"{PROPERTIES}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
NUMBER = "DoubleRangeWidget/DoubleLineEdit"  # the field of a number with a slider
CAMERA = ("InteractionMode", "CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraViewAngle",
          "CameraParallelProjection", "CameraParallelScale")
ASKS = GetParaViewVersion() < (5, 13)  # whether a reset is meant
SIZE = [300, 300]  # of a view [pixels]
PATIENCE = 1500  # with a client that may wait for somebody to close a dialog; CTest waits longer [s]
MESSAGES = ("ERR|", "WARN|", "ERROR:", "Warning:", "critical:", "fatal:", "Traceback")


class Session:
    """A session of ParaView, from an empty window with a view of 300 by 300 pixels."""

    def __init__(self, test):
        self.module = os.path.splitext(os.path.basename(test))[0]
        self.folder = os.path.dirname(os.path.abspath(test))
        self.events = []
        self.small_view()

    def event(self, widget, command="activate", arguments=""):
        self.events.append((widget, command, str(arguments)))

    def call(self, function, *arguments):
        """Call a function of the test, or of a module beside it, in the client."""
        module = self.module if function.__module__ == "__main__" else function.__module__
        self.event(SHELL, "executeCommand",
                   f"import player; player.call({module!r}, {function.__name__!r}, {arguments!r})")

    def small_view(self):
        """Make the views 300 by 300 pixels, or not again."""
        self.menu("menuTools", "actionTesting_Window_Size")

    def menu(self, *names):
        self.event("/".join((WINDOW, "menubar", *names)))

    def source(self, name):
        self.menu("menuSources", "pqProxyGroupMenuManager0", name)

    def filter(self, name):
        """In the open menu: ParaView 5.13 fills it and enables its entries only then."""
        self.event(f"{WINDOW}/menubar", "activate", "menuFilters")
        self.event(f"{WINDOW}/menubar/menuFilters/LittoralFilters", "activate", name)

    def apply(self):
        self.event(f"{PROPERTIES}/Accept")

    def delete(self):
        self.event(f"{PROPERTIES}/Delete")

    def undo(self):
        self.menu("menu_Edit", "actionEditUndo")

    def redo(self):
        self.menu("menu_Edit", "actionEditRedo")

    def reset(self):
        """Edit > Reset Session."""
        self.menu("menu_Edit", "actionDelete_All")
        if ASKS:
            self.event(f"{WINDOW}/CoreUtilitiesPromptUser/qt_msgbox_buttonbox/1QPushButton0")  # Yes

    def select(self, *rows):
        """Select an entry of the pipeline browser by its row below each other: 0, 1 is the second output of the first."""
        self.event(PIPELINE, "currentChanged", "".join(f"/{row}" for row in (0, *rows)) + "|0")

    def eye(self, *rows):
        """Click the eye of an entry of the pipeline browser."""
        index = "".join(f"/{row}:0" for row in (0, *rows[:-1])) + f"/{rows[-1]}:1"
        self.event(PIPELINE, "mousePress", f"1,1,0,8,8,{index}")
        self.event(PIPELINE, "mouseRelease", f"1,0,0,8,8,{index}")

    def field(self, name, value, widget=NUMBER):
        """Type a value into the row of a property."""
        self.event(f"{PANEL}/{name}/{widget}", "set_string", value)

    def choose(self, name, value):
        """Choose in the list of a property."""
        self.field(name, value, "ComboBox")

    def connect(self, name, source):
        """Choose in the list of an input."""
        self.field(name, source, "1QComboBox0")

    def keep_picture(self, file):
        """File > Save Screenshot."""
        self.menu("menu_File", "actionFileSaveScreenshot")
        self.event(f"{WINDOW}/SaveScreenshotFileDialog", "filesSelected", os.path.abspath(file))
        self.event(f"{WINDOW}/SaveScreenshotDialog/widget/OKButton")

    def look(self, name):
        """Keep the picture of the scene, its camera and its time, which is quicker than the menu."""
        self.call(keep_look, name)

    def save_state(self, file):
        """File > Save State."""
        self.menu("menu_File", "actionFileSaveServerState")
        self.event(f"{WINDOW}/FileSaveServerStateDialog", "filesSelected", os.path.abspath(file))

    def load_state(self, file):
        """File > Load State."""
        self.menu("menu_File", "actionFileLoadServerState")
        self.event(f"{WINDOW}/FileLoadServerStateDialog", "filesSelected", os.path.abspath(file))

    def join(self, other):
        """Go on with the steps of another session, from an empty window."""
        self.lap()
        self.reset()
        self.small_view()  # for the old view: off
        self.events += other.events
        self.module = other.module

    def lap(self, name=""):
        """The processor time since the last lap, for Testing/Tiers/check.py."""
        self.call(lap, name or self.module)

    def play(self, *mistakes):
        """Play all steps in a client of its own; each mistake is one message with these words."""
        write_events("steps.xml", self.events)
        paths = os.pathsep.join((self.folder, os.environ.get("PYTHONPATH", "")))
        with subprocess.Popen(["paraview", "--dr", "--test-script=steps.xml", "--test-directory=.", "--exit"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, text=True,
                              errors="replace", env={**os.environ, "PYTHONPATH": paths}) as client:
            try:
                output, _ = client.communicate(timeout=PATIENCE)
            except subprocess.TimeoutExpired:  # such as a dialog that nobody closes
                os.killpg(client.pid, signal.SIGKILL)
                output, _ = client.communicate()
        lines = output.splitlines()
        print("\n".join(line for line in lines if not any(words in line for words in mistakes)), flush=True)
        messages = [line for line in lines if any(word in line for word in MESSAGES)]
        for words in mistakes:
            about = [line for line in messages if words in line]
            assert len(about) == 1, f"{len(about)} messages with {words!r}"
            messages.remove(about[0])
        assert not messages, f"{len(messages)} messages, the first: {messages[0]}"
        assert client.returncode == 0, f"the client ended with {client.returncode}"


def time_since(begin, name):
    """A line for Testing/Tiers/check.py: the processor time of a part of a process and its children."""
    spent = [end - start for start, end in zip(begin, os.times())]
    return f"CPU time of {name}: {spent[0] + spent[2]:.3f} user, {spent[1] + spent[3]:.3f} system"


laps = [os.times()]  # in the client


def lap(name):
    print(time_since(laps[-1], name), file=sys.__stdout__, flush=True)
    laps.append(os.times())


def write_events(file, events):
    """Write events as the test player reads them."""
    with open(file, "w") as script:
        script.write("<pqevents>\n")
        for widget, command, arguments in events:
            script.write(f'<pqevent object="{html.escape(widget)}" command="{command}"'
                         f' arguments="{html.escape(arguments)}"/>\n')
        script.write("</pqevents>\n")


def keep_look(name):
    """In the client: the picture of the view in three dimensions, its camera, its time, and the types of all views."""
    from paraview import simple

    view = simple.GetRenderViews()[0]
    simple.SaveScreenshot(f"{name}.png", view, ImageResolution=SIZE)
    kept = {"camera": {key: view.GetPropertyValue(key) for key in CAMERA}, "time": view.ViewTime,
            "views": sorted(one.GetXMLName() for one in simple.GetViews())}
    with open(f"{name}.json", "w") as out:
        json.dump(kept, out, default=list)


def kept_with(name):
    """Camera, time and types of views that were kept with a picture."""
    with open(f"{name}.json", encoding="utf-8") as file:
        return json.load(file)


def call(module, function, arguments):
    """In the client: call a function of a test; an error ends the client."""
    try:
        getattr(importlib.import_module(module), function)(*arguments)
    except BaseException:
        traceback.print_exc(file=sys.__stderr__)
        sys.__stderr__.flush()
        os._exit(1)


def picture(file):
    """The colors of a picture by row, from the bottom."""
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def drawn(file):
    """The part of a picture that is not of its most frequent color; the cross of the axes in its corner aside."""
    pixels = picture(file)
    pixels[:len(pixels) * 3 // 10, :pixels.shape[1] * 3 // 10] = pixels[-1, -1]
    return (np.abs(pixels - np.median(pixels, axis=(0, 1))).max(axis=2) > 12).mean()


def difference(one, other):
    """The part of two pictures that differs by more than rounding."""
    one, other = picture(one), picture(other)
    assert one.shape == other.shape, f"the pictures have the sizes {one.shape} and {other.shape}"
    return (np.abs(one - other).max(axis=2) > 8).mean()
