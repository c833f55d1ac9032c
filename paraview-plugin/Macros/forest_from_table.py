# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plant the trees of a table: select the opened CSV file in the pipeline browser, then run this macro.

Columns: x, y [m], species (pine, oak or birch; others count as oak), height [m]. Species and height may be missing.
"""
from paraview import simple

SPECIES = ("Pine", "Oak", "Birch")

SCRIPT = """
from vtkmodules.numpy_interface import dataset_adapter
import numpy as np
rows = dataset_adapter.WrapDataObject(self.GetInput())
raw = self.GetInput().GetRowData()
columns = {raw.GetArrayName(k).strip().lower(): raw.GetAbstractArray(k) for k in range(raw.GetNumberOfArrays())}
count = self.GetInput().GetNumberOfRows()
numbers = lambda name: np.array([columns[name].GetVariantValue(k).ToDouble() for k in range(count)])
places = np.zeros((count, 3))
places[:, 0], places[:, 1] = numbers("x"), numbers("y")
words = [columns["species"].GetVariantValue(k).ToString().strip().lower() for k in range(count)] \\
    if "species" in columns else ["oak"] * count
species = np.array([SPECIES.index(word) if word in SPECIES else 1 for word in words])
heights = numbers("height") if "height" in columns else HEIGHTS[species]
output = dataset_adapter.WrapDataObject(self.GetOutput())
output.Points = places
output.PointData.append(species.astype("int32"), "Species")
output.PointData.append(heights / HEIGHTS[species], "Scale")
output.PointData.append(np.arange(count, dtype="int32"), "SiteId")
"""


def render_view():
    """The active render view, else the first one, else a new one."""
    views = simple.GetRenderViews()
    active = simple.GetActiveView()
    view = active if active in views else views[0] if views else simple.CreateView("RenderView")
    simple.SetActiveView(view)
    return view


def look_from_south(view):
    """The whole scene from the south, from a little above."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.0, -3.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.4)


def ground_under(plants, view):
    """A level meadow below the plants, a little wider than they stand."""
    x0, x1, y0, y1, z0, _ = plants.GetDataInformation().GetBounds()
    margin = 0.03 * (x1 - x0 + y1 - y0)
    ground = simple.Plane(registrationName="Ground", Origin=[x0 - margin, y0 - margin, z0],
                          Point1=[x1 + margin, y0 - margin, z0], Point2=[x0 - margin, y1 + margin, z0])
    shown = simple.Show(ground, view)
    shown.AmbientColor = shown.DiffuseColor = [0.42, 0.40, 0.22]


def main():
    """A forest of the active table, shown in a render view."""
    table = simple.GetActiveSource()
    if table is None or table.GetDataInformation().GetDataSetTypeAsString() != "vtkTable":
        print("Select a table with the columns x, y, species and height in the pipeline browser first.")
        return
    trees = [simple.ReevesTree(registrationName=name, Preset=name) for name in SPECIES]
    heights = []
    for tree in trees:
        tree.UpdatePipeline()
        heights.append(tree.GetDataInformation().GetBounds()[5])
    names = [name.lower() for name in SPECIES]
    head = f"import numpy as np\nSPECIES = {names}\nHEIGHTS = np.array({heights})\n"
    sites = simple.ProgrammableFilter(registrationName="Sites", Input=table, OutputDataSetType="vtkPolyData",
                                      Script=head + SCRIPT)
    forest = simple.PlantScatter(registrationName="Forest", Sites=sites, Prototypes=trees, ScaleVariation=0)
    view = render_view()
    simple.Show(forest, view)
    look_from_south(view)
    ground_under(forest, view)
    simple.SetActiveSource(forest)
    simple.Render(view)


main()
