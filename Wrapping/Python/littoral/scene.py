# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as files, under the name of what they hold: see `glb`."""

from .glb import write_glb  # noqa: F401
