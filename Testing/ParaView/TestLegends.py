# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""Colors that are drawn as they are have no legend, in a window with one view and with several, whatever the eyes show.
"""

import quick
from paraview import simple
from player import PIPELINE, Session


def legends():
    """In the client: titles of the legends that the views show."""
    bars = [bar for view in simple.GetRenderViews() for bar in view.Representations
            if "ScalarBar" in bar.GetXMLName() and bar.Visibility]
    return [f"{bar.Title} {bar.ComponentTitle}" for bar in bars]


def check(step):
    """In the client: all views are drawn, and show no legend."""
    simple.RenderAllViews()
    found = legends()
    assert not found, f"{step}: {found}"


def other_view():
    """In the client: a second view beside the first, which is the active one."""
    layout = simple.GetLayout(simple.GetRenderViews()[0])
    view = simple.CreateView("RenderView")
    simple.AssignViewToLayout(view=view, layout=layout, hint=0)
    simple.SetActiveView(view)


def first_view():
    """In the client: back to the first one."""
    simple.SetActiveView(simple.GetRenderViews()[0])


def color_by_height():
    """In the client: colors of a map, whose legend stays."""
    view = simple.GetActiveView()
    shown = simple.GetDisplayProperties(simple.OutputPort(simple.FindSource("Drainage1"), 0), view)
    simple.ColorBy(shown, ("POINTS", "Elevation"))
    shown.SetScalarBarVisibility(view, True)


def check_legend():
    """In the client: the legend of a color map is there, and nothing else."""
    simple.RenderAllViews()
    found = legends()
    assert len(found) == 1 and found[0].startswith("Elevation"), found


class Eyes(Session):
    """Clicks eyes of the pipeline browser."""

    def eye(self, *rows):
        index = "".join(f"/{row}:0" for row in (0, *rows[:-1])) + f"/{rows[-1]}:1"
        self.event(PIPELINE, "mousePress", f"1,1,0,8,8,{index}")
        self.event(PIPELINE, "mouseRelease", f"1,0,0,8,8,{index}")


def main():
    session = Eyes(__file__)
    session.source("TwinOfAPlace")
    session.apply()
    session.call(check, "a scene")
    session.call(other_view)
    session.call(check, "a second view")
    for again in "shown", "hidden", "shown again":
        session.eye(0, 0, 1)  # Rivers of Valleys
        session.eye(0, 0, 0, 0)  # Ground, of its Terrain
        session.call(check, f"the second view: {again}")
    session.call(first_view)
    for again in "hidden", "shown again":
        session.eye(0, 0, 1)
        session.eye(0, 0, 0, 0)
        session.call(check, f"the first view: {again}")
    session.play()


if __name__ == "__main__":
    main()
