# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""In ParaView's own window a chart that Apply opens leaves the render view active, for what comes next."""

import quick
from paraview import servermanager, simple

scene = simple.GetActiveViewOrCreate("RenderView")
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0])
simple.Show(terrain, scene)
simple.Render(scene)
fit = simple.CovarianceFit(Input=terrain)
controller = servermanager.ParaViewPipelineController()
opened = []
for port, kind in ((0, "SpreadSheetView"), (1, "XYChartView")):  # as Apply does
    view = controller.ShowInPreferredView(fit.SMProxy, port, scene.SMProxy)
    assert view.GetXMLName() == kind, view.GetXMLName()
    controller.AssignViewToLayout(view)
    opened.append(view)
for view in opened:
    view.StillRender()
assert simple.GetActiveView().GetXMLName() == "RenderView", "the next output would go to the chart"
twin = simple.TurningBandsTerrainFromFits(Input=fit, WholeExtent=[0, 50, 0, 50, 0, 0])
view = controller.ShowInPreferredView(twin.SMProxy, 0, simple.GetActiveView().SMProxy)
assert view == scene.SMProxy, "the twin is not shown in the view of the terrain"
view = controller.ShowInPreferredView(
    simple.TurningBandsTerrainFromFits(Input=fit).SMProxy, 0, opened[1])
assert view.GetXMLName() == "RenderView", "the twin is not shown from a chart"
