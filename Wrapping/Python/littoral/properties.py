# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of VTK objects by their names."""

import numpy as np


def set_properties(made, settings):
    """Set properties, as of {"Seed": 2, "Origin": (0.0, 1.0)}, and return the object.

    Raises ValueError for a name that it lacks.
    """
    for name, value in settings.items():
        setter = getattr(made, "Set" + name, None)
        if setter is None:
            raise ValueError(f"{made.GetClassName()} has no property {name}")
        setter(*value) if np.ndim(value) else setter(value)
    return made
