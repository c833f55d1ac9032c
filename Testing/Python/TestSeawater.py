# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of sea water is possible and as published, and all that draws water has its numbers."""

import re
from pathlib import Path

import numpy as np
from littoral import seawater
from littoral.gallery import water

PLUGIN = Path(__file__).resolve().parents[2] / "paraview-plugin"
#: Absorption of pure water at 625, 550 and 475 nm [1/m]: R. M. Pope and E. S. Fry (Applied Optics 36, 1997).
PURE = np.array((0.2834, 0.0565, 0.0114))

a, b, K, c = (np.array(values) for values in (
    seawater.ABSORPTION, seawater.SCATTERING, seawater.DOWNWARD, seawater.EXTINCTION))
assert (PURE < a).all() and (a < K).all() and (K < c).all(), (PURE, a, K, c)
np.testing.assert_allclose(c, a + b, rtol=1e-15)

# Equation 3 of Solonenko and Mobley with the backscattering share and the mean cosine of type IB.
share, cosine = 0.06, 0.98
downward = a / cosine * np.sqrt(1.0 + b / a * ((0.451 + 2.584 * share) * cosine - (0.205 + 0.521 * share)))
np.testing.assert_allclose(K, downward, rtol=3e-3)

shader = water.water_shader(water.THROUGH)
for values in (c, K):
    text = "vec3({:.5f}, {:.5f}, {:.5f})".format(*values)
    assert text in shader, text

murks = [float(murk) for murk in re.findall(r'light="murk" murk="([^"]+)"', (PLUGIN / "LittoralLandscapes.xml").read_text())]
assert len(murks) == 4 and np.allclose(murks, seawater.GREY_EXTINCTION, rtol=1e-9), murks
