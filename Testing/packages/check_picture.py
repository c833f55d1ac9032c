# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A tree is drawn, into picture.png: its crown is green, more than its ground."""

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

view = simple.GetActiveViewOrCreate("RenderView")
view.ViewSize = [400, 300]
simple.Show(simple.ReevesTree(), view)
simple.ResetCamera(view)
simple.SaveScreenshot("picture.png", view)
reader = vtkPNGReader()
reader.SetFileName("picture.png")
reader.Update()
red, green, blue = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).T[:3].astype(int)
share = (green > 1.1 * red.clip(blue)).mean()
assert 0.01 < share < 0.5, f"{share:.3f} of the picture are green"
print(f"{share:.3f} of the picture are green")
