# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Light in clear sea water, for whatever draws it: surfaces, particles, fog, windows and Blender.

Jerlov's oceanic type IB at 625, 550 and 475 nm for red, green and blue: absorption a, scattering b and attenuation of
downward light K [1/m], by M. G. Solonenko and C. D. Mobley, Inherent optical properties of Jerlov water types (Applied
Optics 54, 2015). This module imports nothing, as Blender's Python reads it too.
"""

ABSORPTION, SCATTERING, DOWNWARD = (0.296, 0.0623, 0.0225), (0.0468, 0.0536, 0.0635), (0.310, 0.0726, 0.0325)
#: Extinction of a ray, c = a + b.
EXTINCTION = tuple(a + b for a, b in zip(ABSORPTION, SCATTERING))
#: Where one number stands for all colors: that of green, which the eye sees best.
GREY_EXTINCTION = EXTINCTION[1]
