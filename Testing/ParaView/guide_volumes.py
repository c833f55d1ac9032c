# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from particles to a fog volume in a file, in the window; its steps in Blender are not done here."""

import filecmp

import quick
from paraview import simple

from guide import compare

PAGE = "volumes"


def fog(view):
    volume = simple.ParticleFog(Input=simple.SuspendedParticles())
    simple.Show(volume, view)
    simple.SaveData("script.vdb", proxy=volume)


def walk(walk):
    walk.next()
    walk.entry("Sources > Littoral > Suspended Particles")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Particle Fog")
    walk.apply()
    walk.next()
    walk.save("fog.vdb")
    walk.look("fog")
    walk.next("Add > Volume > Import OpenVDB")
    walk.next("Material", "Principled Volume", "Volume", "Density Attribute", "Extinction", "Density")
    walk.next("Sun")


def check():
    compare("fog", fog, 0.5)
    assert filecmp.cmp("fog.vdb", "script.vdb", shallow=False), "the file is another than the script's"
