# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""On a full disk the demo ends at once, and a picture ends in one sentence."""

import contextlib
import errno
import os
import subprocess
import sys
import tempfile

import quick
from paraview import simple

from littoral.gallery import views

SOURCE = os.environ["LITTORAL_SOURCE_DIR"]

with tempfile.TemporaryDirectory() as folder:
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", folder], check=False).returncode != 0:
        print("skipped: only root can mount a small disk")
        sys.exit(125)
    try:
        demo = os.path.join(SOURCE, "Examples", "ParaView", "demo.py")
        ran = subprocess.run(["pvbatch", demo, folder], capture_output=True, text=True, check=False)
        assert ran.returncode == 1, ran
        assert ran.stdout == "", ran.stdout  # before anything is computed
        lines = [line for line in ran.stderr.splitlines() if folder in line]
        assert len(lines) == 1 and "MB are free" in lines[0], ran.stderr

        view = simple.CreateRenderView(ViewSize=[300, 300])
        simple.Show(simple.Wavelet(), view).SetRepresentationType("Outline")
        picture = os.path.join(folder, "picture.png")
        views.save_view(picture, view)
        with open(picture, "rb") as file:
            before = file.read()
        with open(os.path.join(folder, "rest"), "wb", buffering=0) as file, contextlib.suppress(OSError):
            while True:
                file.write(bytes(4096))
        try:
            views.save_view(picture, view)
        except OSError as error:
            assert (error.errno, error.filename) == (errno.ENOSPC, picture), error
        else:
            raise AssertionError("a picture on a full disk")
        with open(picture, "rb") as file:
            assert file.read() == before
        assert sorted(os.listdir(folder)) == ["picture.png", "rest"]
    finally:
        subprocess.run(["umount", folder], check=True)
