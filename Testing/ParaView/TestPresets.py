# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
# run-with: pvpython tier=all args=each
"""The properties say what the preset grows: with Custom and these numbers the plant is the same.

The last preset of each kind; with the argument `each`, all.
"""

import os
import sys

import quick
from mistakes import classes
from paraview import servermanager, simple

KINDS = [entry.proxy for _, entry in classes.all_entries() if entry.kind == "PresetProxy"]


def plant_of(source):
    """Points and colors of the whole plant."""
    data = servermanager.Fetch(source)
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        if leaf.GetNumberOfPoints():
            arrays = [leaf.GetPoints().GetData(), leaf.GetPointData().GetArray("RGB")]
            found += [bytes(memoryview(array)) for array in arrays if array]
        iterator.GoToNextItem()
    iterator.UnRegister(None)
    assert found
    return found


def numbers_of(source):
    """All properties that a preset sets."""
    names = [name for name in source.ListProperties() if name not in ("Preset", "Seed")]
    return {name: str(source.GetPropertyValue(name)) for name in names}


def check(kind):
    """Each preset of a kind, its numbers as a Custom plant, and both from a state file."""
    presets = getattr(simple, kind)().GetProperty("Preset").GetAvailable()
    seen = []
    for preset in presets[1:] if "each" in sys.argv else presets[-1:]:
        source = getattr(simple, kind)(registrationName="Plant", Preset=preset)
        grown, numbers = plant_of(source), numbers_of(source)
        assert numbers not in seen, f"{kind}: the numbers of {preset} are those of another preset"
        seen.append(numbers)
        source.Preset = "Custom"
        assert numbers_of(source) == numbers
        assert plant_of(source) == grown, f"{kind}: Custom with the numbers of {preset} is another plant"
        source.Preset = presets[1]
        source.Preset = preset
        assert numbers_of(source) == numbers, f"{kind}: {preset} chosen later has other numbers"
        simple.Delete(source)


for kind in KINDS:
    check(kind)

# A size makes another tree, whose numbers are shown; keywords of a Custom tree stay.
tree = simple.ReevesTree(Preset="Pine", SpeciesHeight=9.0)
assert abs(tree.Height - 9.0) < 1e-12, tree.Height
own = simple.ReevesTree(registrationName="Own", Preset="Custom", Height=7.0, Orders=2)
assert (own.Height, own.Orders) == (7.0, 2)

# A state file keeps the numbers of a Custom plant and shows those of a preset.
state = os.path.abspath("presets.pvsm")
birch = simple.ReevesTree(registrationName="Birch", Preset="Birch")
numbers = numbers_of(birch)
simple.SaveState(state)
simple.ResetSession()
simple.LoadState(state)
own, birch = simple.FindSource("Own"), simple.FindSource("Birch")
assert own.Preset == "Custom" and (own.Height, own.Orders) == (7.0, 2)
assert birch.Preset == "Birch" and numbers_of(birch) == numbers
birch.Preset = "Shrub"
assert birch.Height < 3.0, birch.Height
