# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Places of the pictures."""

from ..elevation import read_elevation
from .country import Country

#: Lower left corner and size of the part of `jacksboro` with trees [m].
WOODS = (2500.0, 2500.0), (5600.0, 6200.0)


def jacksboro(refinements=3):
    """The country of the forests: a part of the Jacksboro fault, Tennessee, in which brooks gather."""
    return Country(read_elevation(), (10500.0, 6500.0), 10000.0, refinements)
