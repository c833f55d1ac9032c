# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""A plugin that was built for another ParaView, or a second one, is refused with one message, and ParaView goes on."""

import os
import shutil
import subprocess

import quick
from messages import complaints
from paraview import servermanager, simple

version = servermanager.vtkSMProxyManager
running = f"{version.GetVersionMajor()}.{version.GetVersionMinor()}.{version.GetVersionPatch()}"
other = os.environ["LITTORAL_OTHER_VERSION"]  # the loader, built as if for ParaView 4.0


text = complaints(lambda: simple.LoadPlugin(other, remote=False))
assert text.count("Littoral") == 1, text
assert "built for ParaView 4.0, and this is ParaView " + running in text, text

# The plugin that fits is loaded already, by PV_PLUGIN_PATH; a copy of it elsewhere is refused.
assert hasattr(simple, "TurningBandsTerrain")
here = os.path.join(os.environ["PV_PLUGIN_PATH"].split(":")[0], "Littoral.so")
os.makedirs("copy", exist_ok=True)
for name in (here, here + ".pv" + ".".join(running.split(".")[:2])):
    shutil.copy(name, "copy")
text = complaints(lambda: simple.LoadPlugin(os.path.abspath("copy/Littoral.so"), remote=False))
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
