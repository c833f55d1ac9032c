# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make a twin of a terrain: select the opened elevation image in the pipeline browser, then run this macro.

Fits the seven covariance models, generates a terrain of the best one on the same grid, carves valleys into it with the heights
of the place, and shows it with its rivers in the place of the image.
"""
from paraview import simple


def render_view():
    """The active render view, else the first one, else a new one."""
    views = simple.GetRenderViews()
    active = simple.GetActiveView()
    view = active if active in views else views[0] if views else simple.CreateView("RenderView")
    simple.SetActiveView(view)
    return view


def main():
    """A twin of the active image, shown in a render view."""
    place = raster = simple.GetActiveSource()
    if place is None or place.GetDataInformation().GetDataSetTypeAsString() != "vtkImageData":
        print("Select an elevation image in the pipeline browser first.")
        return
    if place.PointData.GetNumberOfArrays() == 0:  # as of the GDAL reader
        place = simple.CellDatatoPointData(registrationName="Elevation", Input=place)
        place.UpdatePipeline()
    fit = simple.CovarianceFit(registrationName="Fit", Input=place)
    fit.Array = ["POINTS", place.PointData.GetArray(0).Name]
    twin = simple.TurningBandsTerrainFromFits(
        registrationName="Twin", Input=simple.OutputPort(fit, 0), UseMeasuredGrid=1)
    twin.UpdatePipeline()  # so that the panels name the array
    valleys = simple.Drainage(registrationName="Valleys", Input=twin, Target=place)
    valleys.UpdatePipeline()
    ground = simple.TerrainLevelOfDetail(registrationName="Ground", Input=simple.OutputPort(valleys, 0))
    view = render_view()
    for one in {place, raster}:
        simple.Hide(one, view)
    simple.Show(simple.OutputPort(valleys, 1), view)
    simple.Show(ground, view)
    simple.ResetCamera(view)
    simple.SetActiveSource(twin)
    simple.Render(view)


main()
