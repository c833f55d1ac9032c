# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Undo and redo in the window: a source, a filter with a second input, a property, a deletion, a scene.

Each undo brings back the pipeline and the picture from before, each redo those from after.
"""

import xml.etree.ElementTree as ElementTree

from player import Session, difference, drawn


def record(name):
    """Keep the picture and the pipeline."""
    session.keep_picture(f"{name}.png")
    session.save_state(f"{name}.pvsm")


def there_and_back(name, before, edits):
    """Record what the last edits made, undo them, redo them; the name of the last record."""
    record(f"{name}-done")
    for step, action in (("undone", session.undo), ("redone", session.redo)):
        for _ in range(edits):
            action()
        record(f"{name}-{step}")
    CHECKS.append((name, before))
    return f"{name}-redone"


def pipeline(file):
    """All properties of sources, filters and their displays, by the proxy's number."""
    found = {}
    for proxy in ElementTree.parse(file).getroot().iter("Proxy"):
        display = proxy.get("type") == "GeometryRepresentation"
        if display or proxy.get("group") in ("sources", "filters"):
            # ParaView does not bring back the helpers of a display, such as its axes, of a stock sphere either.
            kept = ("Element",) if display else ("Element", "Proxy")
            for item in proxy.findall("Property"):
                values = [child.get("value") for child in item if child.tag in kept]
                if item.get("name") == "DetailFactor":
                    continue  # of the latest picture: coarser while the camera moves
                found[proxy.get("type"), proxy.get("id"), item.get("name")] = values
    return found


def check_equal(seen, wanted):
    one, other = pipeline(f"{wanted}.pvsm"), pipeline(f"{seen}.pvsm")
    for key in sorted(one.keys() | other.keys()):
        assert one.get(key) == other.get(key), f"{seen}: {key} is {other.get(key)}, not {one.get(key)}"
    if one:
        part = difference(f"{wanted}.png", f"{seen}.png")
        assert part < 0.002, f"{seen}: {part:.1%} of the picture is another"
    else:
        assert drawn(f"{seen}.png") == 0.0, f"{seen}: something is drawn without a pipeline"


def check(name, before):
    assert pipeline(f"{before}.pvsm") != pipeline(f"{name}-done.pvsm"), f"{name}: nothing was done"
    check_equal(f"{name}-undone", before)
    check_equal(f"{name}-redone", f"{name}-done")
    print(f"{name}: undone and redone; drawn {drawn(f'{before}.png'):.1%}, {drawn(f'{name}-done.png'):.1%}", flush=True)


CHECKS = []
session = Session(__file__)
record("empty")
session.source("Seaweed")
session.apply()
at = there_and_back("source", "empty", 2)
session.select(0)
session.choose("Preset", "Eelgrass")
session.apply()
there_and_back("property", at, 1)
session.source("SeaState")
session.field("WindSpeed", 5)
session.field("SeaLevel", 8, "DoubleLineEdit0")
session.apply()
session.select(0, 0)
record("sea")
session.filter("SeaweedDeformation")
session.connect("SeaState", "SeaState1")
session.apply()
at = there_and_back("filter", "sea", 2)
session.select(0, 0, 0)
session.delete()
there_and_back("deletion", at, 1)
session.source("Forest")
record("unapplied")
session.apply()
there_and_back("parts", "unapplied", 1)
there_and_back("scene", "deletion-redone", 2)
session.play()
for item in CHECKS:
    check(*item)
