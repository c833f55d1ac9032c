# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""Undo and redo in the window: a filter with a second input; in TestEachUndo a source, a property, a deletion, a scene.

Each undo brings back the pipeline from before, each redo that from after, and its picture.
A mistake comes first: TestMistakeInWindow, on whose pipeline this goes on. TestRecordedWindow plays it.
"""

import glob
import os
import xml.etree.ElementTree as ElementTree

import TestMistakeInWindow
from player import Session, difference, drawn


class Undo(Session):
    """Edits, each of which is undone and redone."""

    def __init__(self, test):
        super().__init__(test)
        self.checks = []
        for old in glob.glob("*.png"):
            os.remove(old)

    def record(self, name, with_picture=False):
        """Keep the pipeline, and the picture, which takes longer."""
        self.save_state(f"{name}.pvsm")
        if with_picture:
            self.keep_picture(f"{name}.png")
        return name

    def there_and_back(self, name, before, edits, with_picture=False):
        """Record what the last edits made, undo them, redo them; the name of the last record."""
        self.record(f"{name}-done", with_picture)
        for step, action in (("undone", self.undo), ("redone", self.redo)):
            for _ in range(edits):
                action()
            self.record(f"{name}-{step}", with_picture and step == "redone")
        self.checks.append((name, before))
        return f"{name}-redone"

    def check(self):
        for item in self.checks:
            check(*item)


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
                if item.get("name") in ("DetailFactor", "ViewAngle"):
                    continue  # of the latest picture, for filters that follow the camera
                found[proxy.get("type"), proxy.get("id"), item.get("name")] = values
    return found


def check_equal(seen, wanted):
    one, other = pipeline(f"{wanted}.pvsm"), pipeline(f"{seen}.pvsm")
    for key in sorted(one.keys() | other.keys()):
        assert one.get(key) == other.get(key), f"{seen}: {key} is {other.get(key)}, not {one.get(key)}"
    if os.path.exists(f"{seen}.png"):
        part = difference(f"{wanted}.png", f"{seen}.png")
        assert part < 0.002, f"{seen}: {part:.1%} of the picture is another"
        assert drawn(f"{seen}.png") > 0.01, f"{seen}: nothing is drawn"


def check(name, before):
    assert pipeline(f"{before}.pvsm") != pipeline(f"{name}-done.pvsm"), f"{name}: nothing was done"
    check_equal(f"{name}-undone", before)
    check_equal(f"{name}-redone", f"{name}-done")
    print(f"{name}: undone and redone", flush=True)


def edit(session):
    """A filter with the plant and the sea, in two edits: Filters, Apply."""
    session.select(0, 0)
    session.filter("SeaweedDeformation")
    session.connect("SeaState", "SeaState1")
    session.choose("Method", "Procedural")
    session.apply()


def steps(session):
    """In an empty window. Nothing is saved between an edit and its undo: ParaView 5.13 counts that as an edit."""
    TestMistakeInWindow.steps(session)
    session.lap(TestMistakeInWindow.__name__)
    session.record("sea")
    for name, actions in (("undone", [session.undo] * 2), ("redone", [session.undo] * 2 + [session.redo] * 2)):
        edit(session)
        for action in actions:
            action()
        session.record(name)


def check_steps():
    check_equal("undone", "sea")
    before, after = (pipeline(f"{name}.pvsm") for name in ("sea", "redone"))
    new = {key[2]: value for key, value in after.items() if key not in before and key[0] == "SeaweedDeformation"}
    old = {key[2]: value for key, value in after.items() if key in before and key[0] == "SeaweedDeformation"}
    assert new == old and new, f"the filter is back with {new}, not {old}"
    print("a filter: undone and redone", flush=True)
