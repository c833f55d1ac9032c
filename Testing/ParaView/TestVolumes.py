# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2,3 tier=all
"""SaveData writes volumes: an image, a series, blocks, and the same bytes on any number of ranks; or says what it lacks."""
import os
import resource
import sys
from glob import glob

import quick
from messages import complaints
from paraview import servermanager, simple

from littoral.versions import series_suffix

if not hasattr(servermanager.writers, "VDBVolumeWriter"):
    print("built without OpenVDB")
    sys.exit(125)
ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def content(path):
    """The bytes of a file."""
    with open(path, "rb") as file:
        return file.read()


def compare_with_one_rank(name, proxy, **options):
    """Saves; on several ranks, compares with what one has written before."""
    path = f"{name}-{ranks}.vdb"
    if os.path.exists(path):
        os.remove(path)
    simple.SaveData(path, proxy=proxy, **options)
    assert content(path) == content(f"{name}-1.vdb"), f"{name} differs on {ranks} ranks"
    return content(path)


def check_shortage(megabytes=64):
    """Rank 0 asks for memory before the parts of the others come: it refuses, leaves no file, and no rank waits for it."""
    large = simple.Wavelet(WholeExtent=[0, 399, 0, 199, 0, 199])  # 64 MB, half of them of each of two ranks
    large.UpdatePipeline()
    before = resource.getrlimit(resource.RLIMIT_AS)
    with open("/proc/self/statm", encoding="ascii") as statm:
        used = int(statm.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + (megabytes << 20), before[1]))
    said = complaints(lambda: simple.SaveData("large.vdb", proxy=large))
    resource.setrlimit(resource.RLIMIT_AS, before)
    # The grids, 1.1 times 64 MB and the layers that ranks share, and at most 16 MiB of another rank
    needs = {1: 67, 2: 82.6, 3: 82.8}[ranks]
    assert f"a file of its volumes needs {needs}" in said and "MiB are free: take a smaller" in said, said
    assert not glob("*large.vdb*"), "a file is left"


wind = simple.WindField(Dimensions=[40, 12, 10], TimeStep=0.25, WindDirection=30.0)
wind.UpdatePipeline(0.0)
factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
factory.UpdateAvailableWriters()
assert "OpenVDB volumes(*.vdb" in factory.GetSupportedFileTypes(wind.SMProxy, 0)
whole = compare_with_one_rank("wind", wind)
half = compare_with_one_rank("half", wind, HalfFloat=1)
sparse = compare_with_one_rank("sparse", wind, Tolerance=8.0, Compression="Zip")
assert b"Velocity" in whole and b"m/s" in whole and b"contravariant relative" in whole
assert len(half) < 0.7 * len(whole), "half precision is not smaller"
assert len(sparse) < len(whole), "the tolerance has no effect"

cells = simple.PointDatatoCellData(Input=simple.Wavelet(WholeExtent=[-10, 10, -6, 6, -4, 4]))
compare_with_one_rank("cells", cells)
blocks = simple.GroupDatasets(Input=[wind, cells])
assert b"RTData" in compare_with_one_rank("blocks", blocks)

check_shortage()

for old in glob("series_*.vdb"):
    os.remove(old)
wind.Dimensions = [10, 4, 3]
simple.SaveData("series.vdb", proxy=wind, Writetimestepsasfileseries=1, Filenamesuffix=series_suffix())
files = sorted(glob("series_*.vdb"))
assert files == [f"series_{step:04d}.vdb" for step in range(10)], files
assert len({content(file) for file in files}) == 10, "the wind stands still"
assert not glob(".*.part"), "a temporary file is left"
print(f"volumes: {ranks} rank(s)")
