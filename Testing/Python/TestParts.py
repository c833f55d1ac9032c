# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package with a part missing, or beside another VTK, says so when it is asked."""

import os
import subprocess
import sys
import tempfile

import littoral
from vtkmodules.vtkCommonCore import vtkVersion

package = os.path.dirname(littoral.__file__)
vtk = vtkVersion.GetVTKVersion()


def run(script, without="", version=None):
    """What a script prints with a copy of the package: without a file, or built for another VTK."""
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "littoral")
        os.mkdir(copy)
        for name in os.listdir(package):
            if name not in (without, "__pycache__"):
                os.symlink(os.path.join(package, name), os.path.join(copy, name))
        if version:
            os.remove(os.path.join(copy, "_version.py"))
            with open(os.path.join(copy, "_version.py"), "w") as file:
                file.write(f'__version__ = "7.8.9"\n_vtk_version = "{version}"\n')
        path = folder + os.pathsep + os.environ.get("PYTHONPATH", "")
        return subprocess.run(
            [sys.executable, "-c", script], env={**os.environ, "PYTHONPATH": path},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


ask = """
import littoral
print(littoral.vtkTurningBandsTerrainSource().GetClassName())
try:
    from littoral import vtkVDBVolumeWriter
    print("there")
except ImportError as error:
    print(error)
try:
    littoral.vtkNoSuchClass
except AttributeError as error:
    print(error)
"""
terrain = "vtkTurningBandsTerrainSource\n"
unknown = "module 'littoral' has no attribute 'vtkNoSuchClass'\n"
absent = "There is no vtkVDBVolumeWriter: this Littoral was built without OpenVDB\n"
whole = "there\n" if hasattr(littoral, "LittoralIO") else absent
assert run(ask) == terrain + whole + unknown, run(ask)
assert run(ask, without="LittoralIO.so") == terrain + absent + unknown, run(ask, without="LittoralIO.so")

# A release of VTK serves all of its patches, a copy of VTK with a date as patch is like no other.
major, minor, patch = vtk.split(".")[:3]
load = """
try:
    import littoral
    print("loads")
except ImportError as error:
    print(error)
"""
other = [f"{major}.{int(minor) + 1}.0", f"{major}.1{minor}.{patch}", f"{int(major) + 1}.{minor}.{patch}"]
other.append(f"{major}.{minor}.20000101" if len(patch) < 8 else f"{major}.{minor}.0")
for version in other:
    text = run(load, version=version)
    assert text == f"Littoral 7.8.9 was built for VTK {version}, and this Python has VTK {vtk}\n", text
assert run(load, version=vtk) == "loads\n"
if len(patch) < 8:
    assert run(load, version=f"{major}.{minor}.{int(patch) + 1}") == "loads\n"
