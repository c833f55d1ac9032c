# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Code for Blender's own Python, without VTK: scene files become scenes of Blender. See `littoral.blender`."""
