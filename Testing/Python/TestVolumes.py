# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The writer of volumes in Python: properties, a file, an error. Skipped without OpenVDB."""
import os
import sys

import littoral

if not hasattr(littoral, "vtkVDBVolumeWriter"):
    print("built without OpenVDB")
    sys.exit(125)

wind = littoral.vtkWindFieldSource()
wind.SetDimensions(20, 6, 4)
writer = littoral.vtkVDBVolumeWriter()
assert writer.GetCompression() == littoral.vtkVDBVolumeWriter.Blosc
assert writer.GetFileNameSuffix() == "_%04d"
assert not writer.GetHalfFloat() and writer.GetTolerance() == 0.0
writer.SetInputConnection(wind.GetOutputPort())
writer.SetFileName("wind.vdb")
assert writer.Write() == 1
single = os.path.getsize("wind.vdb")
with open("wind.vdb", "rb") as file:
    head = file.read()
assert head[:4] == b" BDV", "not an OpenVDB file"
for word in (b"Velocity", b"contravariant relative", b"m/s", b"ConvectionSpeed"):
    assert word in head, f"{word} is not in the file"

writer.HalfFloatOn()
assert writer.Write() == 1
assert os.path.getsize("wind.vdb") < single

writer.SetFileName("nowhere/wind.vdb")
messages = []
writer.AddObserver("ErrorEvent", lambda *_: messages.append(1))
writer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
assert writer.Write() == 0 and len(messages) == 1
assert "Tolerance" in str(writer)
os.remove("wind.vdb")
