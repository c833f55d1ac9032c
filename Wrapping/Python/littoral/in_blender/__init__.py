# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What runs in Blender's own Python, without VTK: scene files become scenes of Blender. See `littoral.blender`."""
