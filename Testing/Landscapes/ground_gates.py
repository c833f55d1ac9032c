# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Gates of twins: how far a twin is from its place in each measure, and how far it may be."""

import numpy as np
from ground_measures import CURVATURE_SCALES, SEARCHES, distance, form_shares, halves


def steepness_ratio(twin, place):
    """Geometric mean over the bins of area of S A^c, with the place's concavity c, over the place's."""
    means = []
    for areas, slopes in (twin["profile"], place["profile"]):
        good = slopes > 0.0
        means.append(np.mean(np.log(slopes[good]) + place["concavity"] * np.log(areas[good])))
    return np.exp(means[0] - means[1])


def most_apart(ratios):
    """The largest |r - 1|."""
    return np.nanmax(np.abs(ratios - 1.0))


def gates(heights, spacing, place, gaussians):
    """Rows (name, number of a ground's measures, how far from the place, how far it may be).

    place, gaussians: measures of the place and of its Gaussian twins.
    """
    def number(key):
        return lambda ground: ground[key]

    def apart(key):
        return lambda ground: abs(ground[key] - place[key])

    def ratio(key):
        return lambda ground: ground[key] / place[key]

    def off(key):
        return lambda ground: abs(ground[key] / place[key] - 1.0)

    def far(ground):
        return distance(ground["slopes"], place["slopes"])

    rows = [(f"aspects {name}-fold", number(name), number(name), 1.5 * place[name] + 0.01)
            for name in ("four", "eight")]
    rows.append(("Kolmogorov of slopes", far, far, 0.5 * np.median([far(ground) for ground in gaussians])))
    rows.append(("gentle slopes", number("gentle"), apart("gentle"), 0.05))
    rows.append(("variation of blocks", ratio("blocks"), off("blocks"), 0.3))
    for cells in CURVATURE_SCALES:
        rows.append((f"curvature {cells}, deviation", ratio(f"curved{cells}"), off(f"curved{cells}"), 0.2))
        rows.append((f"curvature {cells}, skew", number(f"bent{cells}"), apart(f"bent{cells}"), 0.3))

    def relief(ground):
        return most_apart(ground["relief"] / place["relief"])

    rows.append(("relief off streams", relief, relief, 0.2))
    for search in SEARCHES:
        def forms(ground, key=f"forms{search}"):
            return np.abs(ground[key] - place[key]).sum()

        parts = [form_shares(half, spacing, search) for half in halves(heights)]
        rows.append((f"geomorphons {search}", forms, forms, max(0.15, np.abs(parts[0] - parts[1]).sum())))
    rows.append(("concavity, filled", number("concavity"), apart("concavity"), 0.1))
    rows.append(("steepness, filled", lambda ground: steepness_ratio(ground, place),
                 lambda ground: abs(steepness_ratio(ground, place) - 1.0), 0.15))
    rows.append(("drainage density", ratio("density"), off("density"), 0.2))

    def horton(ground):
        return most_apart(ground["horton"] / place["horton"])

    rows.append(("Horton's ratios", horton, horton, 0.15))
    rows.append(("trunk valleys", number("trunks"), apart("trunks"), max(0.25 * place["trunks"], 0.1)))
    rows.append(("straight streams", number("straight"), number("straight"), place["straight"] + 0.01))
    rows.append(("Hack's exponent", number("hack"), apart("hack"), 0.05))
    rows.append(("sunk cells", number("sunk"), number("sunk"), max(0.05, place["sunk"])))
    rows.append(("hypsometric integral", number("integral"), apart("integral"), 0.03))
    rows.append(("skew of heights", number("skew"), apart("skew"), 0.15))

    def variogram(ground):
        return most_apart(ground["semivariance"] / place["semivariance"])

    rows.append(("semivariance", variogram, variogram, 0.1))
    return rows
