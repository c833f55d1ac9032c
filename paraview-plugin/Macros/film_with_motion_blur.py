# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Film the animation with motion blur: click into a view in three dimensions, then run this macro.

Writes the frames from start to end time as film.ogv into your home folder, in the size of the view; what is there already
stays, and the next one is film-2.ogv. Each frame is the mean of the light of several pictures while the shutter is open.
"""
import os

from paraview import simple

BLUR = 0.5  # share of the time to the next frame that the shutter is open, 0 to 1
EXPOSURES = 8  # pictures a frame


def free_name(folder):
    """A file that is not there yet."""
    names = (f"film-{number}.ogv" if number > 1 else "film.ogv" for number in range(1, 10000))
    return next(file for file in (os.path.join(folder, name) for name in names) if not os.path.exists(file))


def main():
    """A film of the active view."""
    view, scene = simple.GetActiveView(), simple.GetAnimationScene()
    if view not in simple.GetRenderViews():
        print("Select a view in three dimensions by a click into it first.")
        return
    if int(scene.NumberOfFrames) < 2 or scene.EndTime <= scene.StartTime:
        print("Set an end time and a number of frames in View > Animation View first.")
        return
    try:
        from littoral import film
    except ImportError:
        print("Install the Python package littoral first: it writes films.")
        return
    file = free_name(os.path.expanduser("~"))
    film.save_animation(file, view, BLUR, EXPOSURES)
    print(f"{file} has {int(scene.NumberOfFrames)} frames of {EXPOSURES} pictures each.")


main()
