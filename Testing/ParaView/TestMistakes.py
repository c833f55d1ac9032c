# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""Each mistake is one message: with the filter shown, drawn five times from other places, at another time, and clipped.

A missing second input leaves the first one as it is where the filter moves it; else there is no output.
"""

import glob
import os
import xml.etree.ElementTree as ElementTree

import quick
from mistakes import EMPTY, MISTAKES, UNMOVED, Messages
from paraview import simple
from window import apart, picture, small_view


def shown(data):
    """Number of points and bounds."""
    information = data.GetDataInformation()
    elements = information.GetNumberOfPoints() or information.GetNumberOfRows()
    return elements, information.GetBounds() if elements else None


def make(view, name, arguments):
    """The filter, shown, drawn, at another time, and clipped; what it made of it."""
    proxy = getattr(simple, name)(**arguments)
    proxy.UpdatePipeline()
    is_table = "Table" in proxy.GetDataInformation().GetDataSetTypeAsString()
    if not is_table:
        simple.Show(proxy, view)
    for k in range(5):
        view.CameraPosition = [0.0, -30.0 - k, 3.0]
        simple.Render(view)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = 1.0
    simple.Render(view)
    if not is_table:
        simple.Show(simple.ExtractSurface(Input=proxy), view)
        simple.Render(view)
    return proxy


def clear():
    """Delete all sources and filters, and go back to the first time."""
    for source in reversed(list(simple.GetSources().values())):
        simple.Delete(source)
    simple.GetAnimationScene().AnimationTime = 0.0


def check(view, name, arguments, word, result):
    """Why the mistake is not one message with this result, or nothing."""
    with Messages() as messages:
        given = arguments()
        proxy = make(view, name, given)
    lines = messages.lines
    reason = ""
    if len(lines) != 1 or word not in lines[0]:
        about = [line.split("|", 1)[-1].strip()[:160] for line in lines]
        reason = f"{len(lines)} messages, not one with '{word}': {about}"
    elif result == EMPTY and shown(proxy)[0] > 0:
        reason = f"{shown(proxy)[0]} points, not none"
    elif result == UNMOVED and shown(proxy) != shown(given["Input"]):
        reason = f"{shown(proxy)}, not the input, {shown(given['Input'])}"
    clear()
    return reason


def proxies_of_plugin():
    """Names of all sources and filters in the plugin's menus, without the ready-made landscapes and the light, which has
    its properties in its display (TestLandscapeLight)."""
    folder = os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "paraview-plugin")
    roots = [ElementTree.parse(path).getroot() for path in glob.glob(os.path.join(folder, "*.xml"))]
    scenes = {p.get("name") for root in roots for p in root.iterfind(".//Scene/..")}
    return {p.get("name") for root in roots for p in root.iterfind("./*/Category/Proxy")} - scenes - {"LandscapeLight"}


def check_scene():
    """Giant kelp, which is higher than the sea of Underwater is deep, and sugar kelp again: the picture comes back."""
    view = small_view([300, 200])
    simple.Show(simple.Underwater(), view)
    plant, kelp = simple.FindSource("Sugar Kelp"), simple.FindSource("Kelp")
    pictures, points = [], []
    for preset in ("Sugar Kelp", "Giant Kelp", "Sugar Kelp"):
        plant.Preset = preset
        with Messages():
            pictures.append(picture(view))
        points.append(kelp.GetDataInformation().GetNumberOfPoints())
    assert points[1] == 0 and points[2] == points[0] > 0, f"Underwater: kelp has {points} points"
    without, other = [apart(one, pictures[0]) for one in pictures[1:]]
    assert without > 0.02, f"Underwater: {without:.2%} of the picture is another without kelp"
    assert other < 0.001, f"Underwater: {other:.2%} of the picture is another after a refusal"


missing = proxies_of_plugin() - {mistake[0] for mistake in MISTAKES}
assert not missing, f"no mistake is made with {missing}"
failures = []
view = simple.CreateView("RenderView")
view.ViewSize = [200, 150]
simple.SetActiveView(view)
# In the window, where each new panel costs a second, the first mistake of each source and filter.
in_window = "LITTORAL_CLIENT_SCRIPT" in os.environ
for mistake in ({made[0]: made for made in reversed(MISTAKES)}.values() if in_window else MISTAKES):
    reason = check(view, *mistake)
    if reason:
        failures.append(f"{mistake[0]}, {mistake[2]}: {reason}")
assert not failures, "\n" + "\n".join(failures)
if not in_window:
    clear()
    check_scene()
