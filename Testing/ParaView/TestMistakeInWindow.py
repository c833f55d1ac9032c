# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""A mistake in a panel is one message, however often it is drawn, and leaves the plant as it is; put right, the plant moves.

TestRecordedWindow plays it. TestMistakes has one mistake and more with each entry of the menus.
"""


def moves():
    """In the client: whether the moving plant has other bounds than the one at rest, at the last of some times."""
    from paraview import simple

    for time in (1.0, 2.0, 0.0):
        simple.GetAnimationScene().AnimationTime = time
        simple.Render()
    names = ("Seaweed1", "SeaweedDeformation1")
    rest, moved = (simple.FindSource(name).GetDataInformation().GetBounds() for name in names)
    return rest != moved


def check_mistake():
    """In the client: without a sea the plant stays as it is."""
    assert not moves(), "the plant moves without a sea"


def check_motion():
    """In the client: with it, it moves."""
    assert moves(), "the plant does not move once the mistake is put right"


MESSAGE = "There is no sea state and no current"


def steps(session):
    """In an empty window."""
    session.source("Seaweed")
    session.apply()
    session.select(0, 0)
    session.filter("SeaweedDeformation")
    session.choose("Method", "Procedural")
    session.apply()
    session.call(check_mistake)
    session.source("SeaState")
    session.field("SeaLevel", 8, "DoubleLineEdit0")
    session.apply()
    session.select(0, 0, 0)
    session.connect("SeaState", "SeaState1")
    session.apply()
    session.call(check_motion)
