# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""A plugin that was built for another ParaView, or a second one, is refused with one message, and ParaView goes on."""

import os
import shutil
import subprocess

import quick
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

version = servermanager.vtkSMProxyManager
running = f"{version.GetVersionMajor()}.{version.GetVersionMinor()}.{version.GetVersionPatch()}"
other = os.environ["LITTORAL_OTHER_VERSION"]  # the loader, built as if for ParaView 4.0


def load(path):
    """What ParaView says to a plugin."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        simple.LoadPlugin(path, remote=False)
    except RuntimeError:
        pass
    finally:
        vtkOutputWindow.SetInstance(before)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
    return window.GetOutput()


text = load(other)
assert text.count("Littoral") == 1, text
assert "built for ParaView 4.0, and this is ParaView " + running in text, text

# The plugin that fits is loaded already, by PV_PLUGIN_PATH; a copy of it elsewhere is refused.
assert hasattr(simple, "TurningBandsTerrain")
here = os.path.join(os.environ["PV_PLUGIN_PATH"].split(":")[0], "Littoral.so")
os.makedirs("copy", exist_ok=True)
for name in (here, here + ".pv" + ".".join(running.split(".")[:2])):
    shutil.copy(name, "copy")
text = load(os.path.abspath("copy/Littoral.so"))
assert text.count("was not loaded: there is another one, " + here) == 1, text
terrain = simple.TurningBandsTerrain()
terrain.UpdatePipeline()

# At the start, where ParaView itself is silent about a plugin that it cannot load.
start = subprocess.run(
    ["pvpython", "-c", "from paraview import simple; print(hasattr(simple, 'TurningBandsTerrain'))"],
    env={**os.environ, "PV_PLUGIN_PATH": os.path.dirname(other)}, capture_output=True, text=True)
assert start.returncode == 0, start
assert start.stdout.split()[-1] == "False", start  # MPI may have something to say before
assert (start.stdout + start.stderr).count("built for ParaView 4.0") == 1, start
