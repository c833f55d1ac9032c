# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An installed wheel has what it should and nothing else: the package with stubs and table, the version of the tree, each
library once, and no path of the machine that built it.

    check_contents.py WHEEL SOURCE
"""

import functools
import importlib.metadata
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

import littoral

wheel, source = sys.argv[1:]
folder = os.path.dirname(littoral.__file__)
assert folder.startswith(sys.prefix), f"{folder} is not in the environment {sys.prefix}"
assert littoral.vtkElevationReader and littoral.vtkVDBVolumeWriter and littoral.vtkGLTFSceneWriter
assert littoral.vtkOceanCurrentReader

# The version has one place.
with open(os.path.join(source, "CMakeLists.txt"), encoding="utf-8") as file:
    version = re.search(r"^  VERSION ([0-9.]+)$", file.read(), re.MULTILINE).group(1)
assert importlib.metadata.version("littoral") == littoral.__version__ == version

with zipfile.ZipFile(wheel) as archive:
    names = archive.namelist()
tops = {name.partition("/")[0] for name in names}
assert tops <= {"littoral", "littoral.libs", f"littoral-{version}.dist-info"}, tops
assert not [name for name in names if name.endswith((".h", ".cmake"))]
modules = ["LittoralSources", "LittoralFilters", "LittoralRendering", "LittoralIO"]
wanted = ["__init__.py", "_version.py", "py.typed", "StandSpecies.csv", "gallery/__init__.py", "in_blender/__init__.py"]
wanted += [part for name in modules for part in (f"{name}.so", f"{name}.pyi", f"lib{name}.so")]
missing = {f"littoral/{name}" for name in wanted + ["libLittoralCommon.so"]} - set(names)
assert not missing, missing
ours = [name for name in names if "Littoral" in name and ".so" in name]
assert len(ours) == 2 * len(modules) + 1, ours

# Libraries are looked for beside the package and in that of VTK, and nowhere else.
for name in ours:
    path = os.path.join(folder, "..", name)
    found = subprocess.run(["patchelf", "--print-rpath", path], capture_output=True, text=True, check=True).stdout
    places = [place.rstrip("/") for place in found.strip().split(":")]
    assert {"$ORIGIN", "$ORIGIN/../vtkmodules"} <= set(places), (name, places)
    assert all(place.startswith("$ORIGIN") for place in places), (name, places)

# VTK's own wheel has its libraries in the package vtkmodules, Debian in a folder of the system: such a package is made.
with tempfile.TemporaryDirectory() as site:
    library = os.path.join(site, "littoral", "libLittoralSources.so")
    os.makedirs(os.path.join(site, "vtkmodules"))
    os.mkdir(os.path.dirname(library))
    shutil.copy(os.path.join(folder, os.path.basename(library)), library)
    ask = functools.partial(subprocess.run, ["ldd", library], capture_output=True, text=True, check=True)
    core = re.search(r"(libvtkCommonCore-\S+) => (\S+)", ask().stdout)
    place = os.path.join(site, "vtkmodules", core.group(1))
    os.symlink(core.group(2), place)
    taken = re.search(r"libvtkCommonCore-\S+ => (\S+)", ask().stdout).group(1)
    assert os.path.normpath(taken) == place, taken
print(len(names), "files")
