# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of sea water is possible and as published."""

import numpy as np
from littoral import seawater

WAVELENGTHS = np.array((620.0, 550.0, 480.0))  # [nm]
#: Absorption of pure water there [1/m]: R. M. Pope and E. S. Fry (Applied Optics 36, 1997).
PURE = np.array((0.2755, 0.0565, 0.0127))

a, b, K, c = (np.array(values) for values in (
    seawater.ABSORPTION, seawater.SCATTERING, seawater.DOWNWARD, seawater.EXTINCTION))
assert (PURE < a).all() and (a < K).all() and (K < c).all(), (PURE, a, K, c)
# Morel's scattering of sea water: 16.06 beta at a right angle, which falls with the power 4.32 of the wavelength.
np.testing.assert_allclose(b, 16.06 * 4.72e-4 * (400.0 / WAVELENGTHS) ** 4.32, atol=6e-5)
# The K of Smith and Baker's clearest sea, to their digits: molecules send half of what they scatter backwards.
np.testing.assert_allclose(K, (0.310, 0.0648, 0.0194), rtol=0.006)
