# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list to an inflow for a turbine code, in the window: a file with what was asked for."""

import quick
import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from guide_drainage import close_tables
from player import PROPERTIES, drawn

PAGE = "wind"


def check_inflow():
    """In the client: the wind of the file has the deviation of the class at the hub, the power law and the veer."""
    image = simple.FindSource("inflow.bts").GetClientSideObject().GetOutputDataObject(0)
    velocities = vtk_to_numpy(image.GetPointData().GetArray("Velocity")).reshape(15, 15, 1200, 3).astype(float)
    deviation = (velocities[7, :, :, 0] - velocities[7, :, :, 0].mean(axis=1, keepdims=True)).std()
    means = velocities.mean(axis=(1, 2))
    turns, speeds = np.degrees(np.arctan2(means[:, 1], means[:, 0])), np.hypot(means[:, 0], means[:, 1])
    heights = 20.0 + 10.0 * np.arange(15)
    print(f"deviation at the hub {deviation:.4f} m/s; from the lowest to the highest point {speeds[0]:.2f} to {speeds[-1]:.2f} m/s"
          f" and {turns[0]:.2f} to {turns[-1]:.2f} degrees")
    assert abs(deviation / 2.336 - 1.0) < 1e-3
    assert abs(turns + 0.1 * (heights - 90.0)).max() < 0.02
    assert abs(speeds / (12.0 * (heights / 90.0) ** 0.2) - 1.0).max() < 1e-3


def walk(walk):
    walk.next()
    walk.entry("Sources > Littoral > Wind Field")
    walk.set("Dimensions", [1200, 15, 15], widget="LineEdit", said="Dimensions 1200 15 15")
    walk.set("Time Step", [0.25], said="Time Step 0.25 s")
    walk.set("Lateral Spacing", [10], said="Lateral Spacing and Vertical Spacing 10 m")
    walk.set("Vertical Spacing", [10], said="Vertical Spacing 10 m")
    walk.set("Bottom Height", [20], said="Bottom Height 20 m")
    walk.slide("Reference Speed", 12, "Reference Speed 12 m/s")
    walk.set("Reference Height", [90], said="Reference Height 90 m")
    for label, entry in (("Spectrum", "IEC Kaimal"), ("Coherence", "IEC")):
        walk.say(label)
        walk.say(entry)
        walk.choose(label, entry)
    walk.next()
    walk.say("advanced properties")
    walk.event(f"{PROPERTIES}/SearchBox/AdvancedButton", "set_boolean", "true")
    walk.slide("Shear Exponent", 0.2, "Shear Exponent 0.2")
    walk.slide("Veer", 0.1, "Veer 0.1 degrees/m")
    walk.say("IEC Class")
    walk.say("A")
    walk.choose("IECClass", "A")
    walk.tick("Normalize Variance")
    walk.apply()
    walk.event(f"{PROPERTIES}/SearchBox/AdvancedButton", "set_boolean", "false")
    walk.look("wind")
    walk.next()
    walk.entry("Filters > Littoral > Wind Statistics")
    walk.set("Height", [90], said="Height 90 m")
    walk.set("Separation", [10, 0], said="Separation 10 0 [m]")
    walk.apply()
    walk.call(close_tables)
    walk.next()
    walk.say("WindField1")
    walk.select(0)
    walk.save("inflow.bts")
    walk.next()
    walk.say("inflow.bts")
    walk.open("inflow.bts")
    walk.apply()
    walk.call(check_inflow)


def check():
    assert drawn("wind.png") > 0.05
