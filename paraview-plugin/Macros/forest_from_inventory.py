# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plant a forest inventory: select a Stand Inventory, or the opened CSV file, in the pipeline browser, then run this macro.

Adds up to three trees of different size for each kind of the stand (Pine, Oak, Birch or Shrub; other kinds are Oaks), and
Plant Scatter.
"""
from paraview import servermanager, simple

PRESETS = ("Pine", "Oak", "Birch", "Shrub")


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


def ground_under(stand, view):
    """A level meadow below the plants, a little wider than they stand."""
    x0, x1, y0, y1, z0, _ = stand.GetDataInformation().GetBounds()
    margin = 0.03 * (x1 - x0 + y1 - y0)
    ground = simple.Plane(registrationName="Ground", Origin=[x0 - margin, y0 - margin, z0],
                          Point1=[x1 + margin, y0 - margin, z0], Point2=[x0 - margin, y1 + margin, z0])
    shown = simple.Show(ground, view)
    shown.AmbientColor = shown.DiffuseColor = [0.42, 0.40, 0.22]


def main():
    """A forest of the active stand, shown in a render view."""
    stand = simple.GetActiveSource()
    if stand is not None and stand.GetDataInformation().GetDataSetTypeAsString() == "vtkTable":
        stand = simple.StandInventory(registrationName="Stand", Inventory=stand)
    if stand is not None and stand.GetXMLName() == "StandInventory":
        stand.DiameterClasses = max(3, stand.DiameterClasses)
        stand.UpdatePipeline()
    data = servermanager.Fetch(stand).GetFieldData() if stand is not None else None
    if data is None or not data.HasArray("PlantHeight"):
        print("Select the table of an inventory, or a Stand Inventory, in the pipeline browser first.")
        return
    trees = []
    for k in range(data.GetAbstractArray("Kinds").GetNumberOfValues()):
        kind = data.GetAbstractArray("Kinds").GetValue(k)
        height, diameter, crown = (data.GetArray(f"Plant{name}").GetValue(k) for name in ("Height", "DBH", "CrownDiameter"))
        trees.append(simple.ReevesTree(registrationName=f"{kind} of {height:.0f} m", SpeciesHeight=height,
                                       Preset=kind if kind in PRESETS else "Oak", SpeciesDiameter=diameter,
                                       SpeciesCrown=crown))
    forest = simple.PlantScatter(registrationName="Forest", Sites=stand, Prototypes=trees)
    view = render_view()
    simple.Hide(stand, view)
    simple.Show(forest, view)
    look_from_south(view)
    ground_under(stand, view)
    simple.SetActiveSource(forest)
    simple.Render(view)


main()
