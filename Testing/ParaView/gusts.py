# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of a programmable source: a wind along x that is weak for 50 m and strong for 50 m, carried at 10 m/s."""

WIND = """
import vtk
output.SetDimensions(200, 3, 3)
output.SetSpacing(0.5, 40.0, 10.0)
output.SetOrigin(0.0, -40.0, 2.0)
velocity = vtk.vtkFloatArray()
velocity.SetName("Velocity")
velocity.SetNumberOfComponents(3)
for i in range(1800):
    velocity.InsertNextTuple3(6.0 + 4.0 * ((i % 200) < 100), 0.0, 0.0)
output.GetPointData().AddArray(velocity)
speed = vtk.vtkDoubleArray()
speed.SetName("ConvectionSpeed")
speed.InsertNextValue(10.0)
output.GetFieldData().AddArray(speed)
"""
INFORMATION = """
from paraview import util
util.SetOutputWholeExtent(self, [0, 199, 0, 2, 0, 2])
"""
