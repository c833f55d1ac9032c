# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list to moving kelp, in the window: two seconds are played, with the surface shown again."""

import quick
from paraview import simple

from guide import WINDOW, compare
from player import difference

PAGE = "seaweed"

FRAMES = 48


def pause_after(frames):
    """In the client: press Pause after some frames."""
    view, scene = simple.GetRenderViews()[0], simple.GetAnimationScene()
    drawn = []

    def count(*_):
        drawn.append(view.ViewTime)
        if len(drawn) == frames:
            scene.SMProxy.InvokeCommand("Stop")

    view.SMProxy.AddObserver("EndEvent", count)


def moving_kelp(view):
    plant = simple.Seaweed()
    simple.Show(plant, view)
    sea = simple.SeaState(WindSpeed=5.0, SeaLevel=6.0, WaterDepth=6.0)
    simple.Show(sea, view)
    simple.Hide(plant, view)
    simple.Show(simple.SeaweedDeformation(Input=plant, SeaState=sea), view)


def walk(walk):
    walk.next()
    walk.entry("Sources > Littoral > Seaweed")
    walk.apply()
    walk.next()
    walk.entry("Sources > Littoral > Sea State")
    walk.next()
    walk.slide("Wind Speed", 5, "Wind Speed to 5 m/s")
    walk.set("Sea Level", [6], said="Sea Level to 6 m")
    walk.slide("Water Depth", 6, "Water Depth to 6 m")
    walk.next()
    walk.apply()
    walk.next()
    walk.say("Plant")
    walk.say("Seaweed1")
    walk.select(0, 0)
    walk.entry("Filters > Littoral > Seaweed Deformation")
    walk.next("Currents", "Edit > Change Input")
    walk.say("Sea State")
    walk.connect("SeaState", "SeaState1")
    walk.next()
    walk.apply()
    walk.look("still")
    walk.say("SeaState1")
    walk.eye(1)
    walk.next()
    walk.entry("View > Animation View")
    walk.say("No. Frames")
    walk.say("1440")
    frames = f"{WINDOW}/animationViewDock/animationView/Duration"
    walk.event(frames, "set_string", 1440)
    walk.event(frames, "keyEvent", "6,16777220,0,,0,1")  # Return
    walk.call(pause_after, FRAMES)
    walk.say("Play")
    walk.event(f"{WINDOW}/VCRToolbar/actionVCRPlay")
    walk.look("moving")


def check():
    kept = compare("moving", moving_kelp, 0.3)
    assert 1.5 < kept["time"] < 2.5, f"the film paused at {kept['time']} s"
    assert difference("still.png", "moving.png") > 0.01, "nothing moves"
