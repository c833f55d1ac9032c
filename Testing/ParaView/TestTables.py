# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2 tier=all
"""Each table has its rows once on any number of ranks, whichever output is asked for first."""

import quick
from paraview import simple
from paraview.servermanager import vtkProcessModule

ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
terrain = simple.TurningBandsTerrain(WholeExtent=[0, 60, 0, 60, 0, 0])
points = simple.QuadratPoints(Quadrats=[30, 20])
wind = simple.WindField(Dimensions=[60, 8, 5])


def rows(table, port):
    """Rows on all ranks."""
    port = simple.OutputPort(table, port)
    simple.UpdatePipeline(proxy=port)
    return port.GetDataInformation().GetNumberOfRows()


def rows_shown(table):
    """Rows of the first output in a spreadsheet."""
    view = simple.CreateView("SpreadSheetView")
    simple.Show(table, view)
    simple.Render(view)
    count = view.GetClientSideObject().GetNumberOfRows()
    simple.Delete(view)
    return count


for order in (1, -1):
    simple.SetActiveSource(terrain)  # ParaView takes the default of an array from the active source
    fit = simple.CovarianceFit(Input=terrain, NumberOfLags=20)
    analysis = simple.QuadratAnalysis(Input=points)
    sea = simple.SeaState(NumberOfTrains=17)
    spectra = simple.WindStatistics(Input=wind)
    waves = simple.SeaStatistics(Input=simple.SeaState(NumberOfTrains=17), NumberOfSectors=24)
    # Bins of 256 / 17 steps, rounded up, with points at both edges; sectors of 10 steps.
    wanted = [(fit, 0, 7), (analysis, 0, 6), (sea, 0, 17), (spectra, 2, 5), (waves, 0, 17 * 17), (waves, 1, 24 * 11)]
    for table, port, count in wanted[::order]:
        found = rows(table, port)
        assert found == count, f"{table.GetXMLName()}: {found} rows in output {port} on {ranks} ranks"
    assert 0 < rows(fit, 1) <= 20, f"{rows(fit, 1)} lags on {ranks} ranks"
    assert 0 < rows(analysis, 1) < 12, f"{rows(analysis, 1)} frequencies on {ranks} ranks"
    for port in (0, 1):
        assert 0 < rows(spectra, port) <= 29, f"{rows(spectra, port)} bands on {ranks} ranks"
    # A filter reads the whole table on each rank; shown, it still has its rows once.
    for table, count, reader in ((fit, 7, simple.TurningBandsTerrainFromFits(Input=fit)),
                                 (analysis, 6, simple.QuadratPointsFromFits(Input=analysis)),
                                 (sea, 17, simple.ParticleOrbits(Input=points, SeaState=sea))):
        reader.UpdatePipeline()
        assert reader.GetDataInformation().GetNumberOfPoints() > 0, "no rank has read its table"
        assert rows_shown(table) == count, f"{table.GetXMLName()}: more rows shown on {ranks} ranks"
