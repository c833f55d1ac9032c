# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin is known and loaded, here and on a server whose port is given."""

import sys

from paraview import servermanager, simple

remote = len(sys.argv) > 1
if remote:
    simple.Connect("127.0.0.1", int(sys.argv[1]))
manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
session = servermanager.ActiveConnection.Session
information = [manager.GetLocalInformation()]
if remote:
    information.append(manager.GetRemoteInformation(session))
for plugins in information:
    loaded = {plugins.GetPluginName(k): plugins.GetPluginLoaded(k) for k in range(plugins.GetNumberOfPlugins())}
    assert loaded.get("Littoral"), f"the plugin was not loaded at the start: {loaded}"

terrain = simple.TurningBandsTerrain()
terrain.UpdatePipeline()
low, high = terrain.PointData["Elevation"].GetRange()
assert high - low > 50.0, (low, high)
print("ParaView", simple.GetParaViewVersion(), "remote" if remote else "local", low, high)
if remote:
    simple.Disconnect()
