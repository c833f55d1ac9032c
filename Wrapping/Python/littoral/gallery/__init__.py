# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the demo and the examples: places, palettes, meshes, shaders, views."""
