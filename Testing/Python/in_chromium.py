# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of a folder in Chromium, without a display and a graphics card."""

import contextlib
import functools
import http.server
import os
import subprocess
import threading

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

CHROMIUM = ("chromium", "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader", "--window-size=320,240")


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    """Address of a folder's files."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()


def open_page(folder, page, milliseconds, *options):
    """What Chromium writes about a page after so much time of its own."""
    own = f"--user-data-dir={os.path.join(folder, 'browser')}"
    with served(folder) as address:
        return subprocess.run([*CHROMIUM, own, f"--virtual-time-budget={milliseconds}", *options, address + page],
                              capture_output=True, text=True, check=True).stdout


def picture(folder, page, milliseconds):
    """What a page shows: numbers [row, column, part]."""
    name = os.path.join(folder, "page.png")
    open_page(folder, page, milliseconds, f"--screenshot={name}")
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, -1).astype(float)
