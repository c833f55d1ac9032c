# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A ParaView scene: a measured place and a twin that grows from its statistics.

    ./littoral gui                    opens it in ParaView
    pvbatch scene.py [FOLDER]         writes scene.png and scene.pvsm into FOLDER

Change `Seed` of the twin and press Apply: another terrain with the same statistics appears, with
its shadows. The chart shows the variogram of the place and the models that were fitted to it.
"""

import os
import sys
import tempfile

from paraview import simple

from littoral.elevation import read_elevation, write_vti
from littoral.scene import prepare_view, row_centres, show_lit, width_of

EXAGGERATION = 3.0

RELIEF = """
from littoral.scene import relief_block
image = self.GetInputDataObject(0, 0)
block = relief_block(image, exaggeration={exaggeration}, centre={centre})
self.GetPolyDataOutput().ShallowCopy(block)
"""

FLOOR = """
from littoral.scene import floor_shadow
blocks = [self.GetInputDataObject(0, k) for k in range(self.GetNumberOfInputConnections(0))]
shadow = floor_shadow([block.GetBounds() for block in blocks])
self.GetPolyDataOutput().ShallowCopy(shadow)
"""


def polydata_filter(name, inputs, script):
    """A filter in Python that gives polydata."""
    return simple.ProgrammableFilter(
        registrationName=name, Input=inputs, OutputDataSetType="vtkPolyData", Script=script)


def relief(name, terrain, centre):
    """A terrain as a block with light and shadows."""
    script = RELIEF.format(exaggeration=EXAGGERATION, centre=tuple(float(c) for c in centre[:2]))
    return polydata_filter(name, terrain, script)


def grown_like(fits, place):
    """The twin: a terrain on the grid of a place, from the table of fits."""
    return simple.TurningBandsTerrainFromFits(
        registrationName="Twin", Input=fits, WholeExtent=place.GetExtent(),
        Origin=place.GetOrigin(), Spacing=place.GetSpacing())


def show_variogram(fit, view):
    """The second output of the fit as a chart."""
    shown = simple.Show(simple.OutputPort(fit, 1), view, "XYChartRepresentation")
    names = [name for name in shown.SeriesVisibility[::2]]
    shown.UseIndexForXAxis = 0
    shown.XArrayName = "Lag"
    shown.SeriesVisibility = [name for name in names if name not in ("Lag", "Pairs")]
    shown.SeriesMarkerStyle = ["Semivariance", "4"]
    shown.SeriesLineStyle = ["Semivariance", "0"]
    view.BottomAxisTitle = "Lag (m)"
    view.LeftAxisTitle = "Semivariance (m\u00b2)"
    view.ShowLegend = 1


def build(folder):
    """The pipeline and its views; gives the render view and the layout."""
    place = read_elevation()
    filename = os.path.join(folder, "jacksboro.vti")
    write_vti(place, filename)
    reader = simple.XMLImageDataReader(
        registrationName="Jacksboro fault", FileName=[filename], TimeArray="None")
    fit = simple.CovarianceFit(registrationName="Fits", Input=reader)
    twin = grown_like(fit, place)

    layout = simple.CreateLayout(name="Littoral")
    view = simple.CreateRenderView(ViewSize=[1600, 760])
    layout.AssignView(0, view)
    width = width_of(place)
    centres = row_centres(width, 2)
    blocks = [
        relief("Relief of the place", reader, centres[0]),
        relief("Relief of the twin", twin, centres[1])]
    for block in blocks:
        show_lit(block, view)
    show_lit(polydata_filter("Floor", blocks, FLOOR), view)
    prepare_view(view, width, 2)

    chart = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(chart, layout, layout.SplitVertical(0, 0.65))
    show_variogram(fit, chart)
    simple.SetActiveView(view)
    simple.SetActiveSource(twin)
    simple.Render(view)
    return view


def main():
    """Build the scene; in batch, write picture and state as well."""
    simple._DisableFirstRenderCameraReset()
    folder = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-")
    os.makedirs(folder, exist_ok=True)
    view = build(folder)
    if __name__ == "__main__" and len(sys.argv) > 1:
        simple.SaveScreenshot(os.path.join(folder, "scene.png"), view)
        simple.SaveState(os.path.join(folder, "scene.pvsm"))


main()
