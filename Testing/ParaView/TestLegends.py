# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all args=export
"""Colors that are drawn as they are have no legend, in a window with one view and with several, whatever the eyes show.
With `export`, what a view shows is exported by the menu too.

TestRecordedWindow plays it without.
"""

import os
import sys

import numpy as np
import quick
from paraview import servermanager, simple
from player import WINDOW, Session
from scene_files import below_root, scene_of


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


def check_side():
    """In the client: a terrain, which a light is shown beside, is seen from the side, and all of it."""
    view, (x0, x1, *_) = simple.GetRenderViews()[0], simple.GetActiveSource().GetDataInformation().GetBounds()
    away = np.array(view.CameraPosition) - np.array(view.CameraFocalPoint)
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0] and away[2] > 0.0, f"an eye at {away}"
    assert x1 - x0 < np.linalg.norm(away) < 5.0 * (x1 - x0), f"an eye {np.linalg.norm(away)} m away"


def other_view():
    """In the client: a second view beside the first, which is the active one."""
    layout = simple.GetLayout(simple.GetRenderViews()[0])
    view = simple.CreateView("RenderView")
    simple.AssignViewToLayout(view=view, layout=layout, hint=0)
    simple.SetActiveView(view)


def first_view():
    """In the client: back to the first one."""
    simple.SetActiveView(simple.GetRenderViews()[0])


def check_twin():
    """In the client: the macro has made a twin of the terrain."""
    assert simple.FindSource("Twin") and simple.FindSource("Ground"), "no twin"


def check_export(scene):
    """File > Export Scene: what is shown, by the names of the pipeline browser, with camera and sun."""
    assert below_root(scene) == ["Camera", "Drainage1", "Sun"], below_root(scene)
    kinds = {material["extras"]["kind"] for material in scene["materials"]}
    assert kinds == {"ground"}, kinds  # rivers, which are lines, are hidden


def steps(session):
    """In an empty window."""
    session.source("TurningBandsTerrain")
    for end in 1, 3:
        session.field("WholeExtent", 40, f"LineEdit{end}")
    session.apply()
    session.call(check_side)
    session.filter("Drainage")
    session.apply()
    session.call(check, "valleys")
    session.call(other_view)
    for port in 0, 1:  # Terrain and Rivers
        session.eye(0, 0, port)
    session.call(check, "a second view: shown")
    session.call(first_view)
    session.eye(0, 0, 1)
    session.call(check, "the first view: hidden")


def macros(session):
    """After the steps: the macros of the plugin, which are in the menu without import."""
    session.event(f"{WINDOW}/menubar/menu_Macros", "activate", "forest_from_inventory")  # which asks for a table
    session.select(0)
    session.event(f"{WINDOW}/menubar/menu_Macros", "activate", "twin_from_raster")
    session.call(check_twin)


def main():
    session = Session(__file__)
    steps(session)
    exports = "export" in sys.argv[1:] and hasattr(servermanager.writers, "GLTFSceneWriter")
    if exports:
        session.menu("menu_File", "actionExport")
        session.event(f"{WINDOW}/FileExportDialog", "filesSelected", os.path.abspath("window.glb"))
        session.event(f"{WINDOW}/ProxyWidgetDialog/widget/OKButton")
    session.play()
    if exports:
        check_export(scene_of("window.glb"))


if __name__ == "__main__":
    main()
