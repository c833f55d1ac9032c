# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether pictures can be drawn here."""

import ctypes
import os

from vtkmodules.vtkRenderingCore import vtkRenderWindow


def require(window):
    """Raise RuntimeError where a render window needs an X server and there is none, which for VTK is a reason to abort."""
    kind = window.GetClassName()
    if kind == "vtkOffscreenOpenGLRenderWindow":  # ParaView's, which draws by one of the usual kind
        kind = vtkRenderWindow().GetClassName()
    if kind != "vtkXOpenGLRenderWindow" or window.GetMapped():
        return
    library = ctypes.CDLL("libX11.so.6")
    library.XOpenDisplay.restype = ctypes.c_void_p
    connection = library.XOpenDisplay(None)
    if not connection:
        named = os.environ.get("DISPLAY")
        reason = f"DISPLAY is {named}, where none answers" if named else "DISPLAY is not set"
        raise RuntimeError(f"There is no display to draw on: {reason}. Start the program by xvfb-run.")
    library.XCloseDisplay(ctypes.c_void_p(connection))
