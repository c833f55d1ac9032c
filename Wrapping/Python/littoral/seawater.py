# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Light in the clearest sea water, for whatever draws it: surfaces, particles, windows and Blender.

At 620, 550 and 480 nm for red, green and blue: the absorption a and scattering b of R. C. Smith and K. S. Baker, Optical
properties of the clearest natural waters (Applied Optics 20, 1981), also in C. D. Mobley, Light and water (1994), and the
least attenuation of downward light that follows from both there, K = a + b / 2 [1/m]. This module imports nothing, as
Blender's Python reads it too.
"""

ABSORPTION, SCATTERING = (0.309, 0.0638, 0.0176), (0.0012, 0.0019, 0.0034)
DOWNWARD = tuple(a + 0.5 * b for a, b in zip(ABSORPTION, SCATTERING))
#: Extinction of a ray, c = a + b.
EXTINCTION = tuple(a + b for a, b in zip(ABSORPTION, SCATTERING))
