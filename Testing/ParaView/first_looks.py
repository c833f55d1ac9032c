# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What an output shows first, with its defaults, in an empty view: way of drawing, colors, background, lights, camera, and a
picture with enough of it."""

import numpy as np
import quick
from paraview import simple
from window import picture, small_view

SIZE = (160, 100)
# Colors of the background at the bottom and at the top, as the look of a mood demands: paler below a sky, darker below
# the surface of water.
SKIES = {"land": np.less, "sea": np.less, "water": np.greater}


def look(name, source, port=0):
    """Shows an output in a view of its own, as a user's script would."""
    view = small_view(SIZE)
    shown = simple.Show(simple.OutputPort(source, port), view)
    simple.ResetCamera(view)
    with_it = picture(view)
    simple.Hide(simple.OutputPort(source, port), view)
    without = picture(view)
    drawn = np.abs(with_it - without).sum(axis=2) > 20
    colors = with_it[drawn]
    print(f"{name}: {drawn.mean():.3f} drawn, mean color {colors.mean(axis=0).round()}, spread "
          f"{colors.sum(axis=1).std():.0f}", flush=True)
    return view, shown, drawn.mean(), colors


def check(name, source, how, array, mood, share, spread=15.0, port=0, seen_from=None,
          display=lambda shown: None):
    """Checks the first look of an output, and its display by another function."""
    view, shown, drawn, colors = look(name, source, port)
    assert shown.Representation == how, (name, shown.Representation)
    display(shown)
    if array:
        assert shown.ColorArrayName[1] == array, (name, list(shown.ColorArrayName))
        assert shown.MapScalars == (array != "RGB"), name
    assert view.UseColorPaletteForBackground == 0 and view.BackgroundColorMode == "Gradient", name
    if mood in SKIES:
        assert SKIES[mood](sum(view.Background2), sum(view.Background)), name
        assert len(view.AdditionalLights) == 1 and view.AdditionalLights[0].Coords == "Scene", name
        sun = np.array(view.AdditionalLights[0].Position)
        side = np.hypot(sun[0], sun[1]) / sun[2]
        assert sun[2] > 0.0 and side > 0.5, f"{name}: the light is not from the side"
    assert drawn > share, f"{name}: {drawn:.4f} of the picture is drawn"
    assert colors.sum(axis=1).std() > spread, f"{name}: one flat patch"
    eye = np.array(view.CameraPosition) - np.array(view.CameraFocalPoint)
    if seen_from == "above":
        assert np.allclose(eye[:2], 0.0, atol=1e-6 * eye[2]), name
    else:
        assert list(view.CameraViewUp) == [0.0, 0.0, 1.0] and eye[2] > 0.0, name
        assert np.hypot(eye[0], eye[1]) > eye[2], f"{name} is seen from above"
    simple.Delete(view)
    return colors
