# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Scenes, here a forest: each entry becomes an ordinary pipeline with its parts in the browser, shows a picture and plays where
it should.

TestSwayingScene, TestScenesAtSea and TestUnderwaterScene have others, where a part is changed, TestEachScene the twin and the states of all,
TestLightOfScene views that have a light of their own.
"""

import numpy as np
import quick
from paraview import servermanager, simple
from states import visible
from window import apart, picture, small_view

SIZE = (150, 100)
#: Parts by name, those that are shown, the end of the times [s], and a change of a part.
SCENES = {
    "Forest": (["Hills", "Valleys", "Brooks", "Pine", "Oak", "Birch", "Shrub", "Sites", "Trees", "Ground", "Light"],
               ["Brooks", "Trees", "Ground", "Light"], 1.0, ("Hills", "StandardDeviation", 30.0)),
    "SwayingForest": (["Hill", "Sites", "Birch", "Pine", "Wood", "Trees", "Ground", "Light"],
                      ["Trees", "Ground", "Light"], 59.9,
                      ("Sites", "MeanPerQuadrat", 1.5)),
    "Sea": (["Surface", "Light"], ["Surface", "Light"], 60.0, ("Sea1", "PeakPeriod", 10.0)),
    "Underwater": (["Relief", "Sites", "Sugar Kelp", "Eelgrass", "Giant Kelp", "Plants", "Kelp", "Bed", "Water", "Particles",
                    "Surface", "Light"],
                   ["Kelp", "Bed", "Particles", "Surface", "Light"], 60.0, ("Water", "Density", 20.0)),
    "TwinOfAPlace": (["Valleys", "Rivers", "Ground", "Light"], ["Rivers", "Ground", "Light"], 1.0,
                     ("TwinOfAPlace1", "Seed", 7)),
}


def show(name, parts, shown):
    """The view of a scene, with its parts, which has drawn it; and the picture."""
    view = small_view(SIZE)
    blank = picture(view)
    scene = getattr(simple, name)()
    assert len(simple.GetSources()) == 1, f"{name}: parts before it is shown"
    simple.Show(scene, view)
    names = [key[0] for key in simple.GetSources()]
    assert sorted(names) == sorted([f"{name}1", *parts]), f"{name}: consists of {names}"
    for part in map(simple.FindSource, parts):
        if "Array" in part.ListProperties():
            assert list(part.GetProperty("Array"))[1:] == ["Elevation"], f"{name}: Array is {list(part.GetProperty('Array'))}"
    assert visible(view) == sorted(shown), f"{name}: shows {visible(view)}"
    first = picture(view)
    covered = apart(first, blank)
    assert covered > 0.3, f"{name}: the picture shows {covered:.1%}"
    assert np.unique(first.reshape(-1, 3), axis=0).shape[0] > 200, f"{name}: a flat picture"
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0], f"{name}: no view from the side"
    return view, first


def new_film():
    """What Save Animation offers."""
    film = servermanager.ProxyManager().NewProxy("misc", "SaveAnimation")
    servermanager.vtkSMParaViewPipelineController().InitializeProxy(film)
    return servermanager._getPyProxy(film)  # pylint: disable=protected-access


def check_times(name, view, first, last_time):
    """Play works at once: the animation has the scene's times, and its pictures move."""
    animation = simple.GetAnimationScene()
    animation.UpdateAnimationUsingDataTimeSteps()
    assert abs(animation.EndTime - last_time) < 1e-9, f"{name}: the animation ends at {animation.EndTime}"
    if last_time > 1.0:
        steps = len(simple.GetTimeKeeper().TimestepValues)
        frames, rate = steps or animation.NumberOfFrames, new_film().FrameRate
        assert abs((frames - 1) / rate - last_time) < 0.1, f"{name}: a film of {frames} frames, {rate} a second"
        view.ViewTime = 1.0
        moved = apart(picture(view), first)
        assert moved > 0.002, f"{name}: {moved:.2%} of the picture moves"
        view.ViewTime = 0.0


def check_change(name, view, first, source, prop, value):
    """A part can be changed, and back."""
    part = simple.FindSource(source)
    former = part.GetPropertyValue(prop)
    part.SetPropertyWithName(prop, value)
    changed = apart(picture(view), first)
    assert changed > 0.01, f"{name}: {prop} of {source} changes {changed:.2%}"
    part.SetPropertyWithName(prop, former)
    other = apart(picture(view), first)
    assert other < 0.001, f"{name}: {prop} of {source} cannot be undone, {other:.2%} is another"


def check_again(name):
    """A scene that has its parts does not get them again in another view."""
    number = len(simple.GetSources())
    simple.Show(simple.FindSource(f"{name}1"), small_view(SIZE))
    assert len(simple.GetSources()) == number, f"{name}: parts twice"


def check_defaults(name, prop, value):
    """Restore Defaults brings back what the scene begins with, also to the data."""
    scene, fresh = getattr(simple, name)(), getattr(simple, name)()
    fresh.UpdatePipeline()
    first = fresh.GetPropertyValue(prop)
    scene.SetPropertyWithName(prop, value)
    scene.UpdatePipeline()
    scene.GetProperty(prop).SMProperty.ResetToDefault()
    scene.UpdateVTKObjects()
    scene.UpdatePipeline()
    assert scene.GetPropertyValue(prop) == first != value, f"{name}: {prop} is restored to {scene.GetPropertyValue(prop)}"
    numbers = [proxy.GetDataInformation().GetBounds() for proxy in (scene, fresh)]
    assert numbers[0] == numbers[1], f"{name}: bounds {numbers[0]}, not {numbers[1]}"
    simple.ResetSession()


def check(name, change=True, then=check_again):
    """A scene, and what else is to be checked of it."""
    parts, shown, last_time, part = SCENES[name]
    view, first = show(name, parts, shown)
    check_times(name, view, first, last_time)
    if change:
        check_change(name, view, first, *part)
    then(name)
    simple.ResetSession()
    print(f"{name} consists of {len(parts) + 1} parts", flush=True)


def check_memory(_):
    """The trees stay below 200 MB; TestForestMemory goes around in them."""
    size = simple.FindSource("Trees").GetDataInformation(0).GetMemorySize() / 1024.0
    assert 5.0 < size < 200.0, f"{size:.0f} MB"


def lights(view):
    """Displays of the lights that a view shows."""
    return [one for one in view.Representations if one.SMProxy.GetXMLName() == "LandscapeLightRepresentation" and one.Visibility]


def check_light(view):
    """A scene lights a view by one part, whose eye takes the light away; its terrain is ground, on which grass grows."""
    lit = picture(view)
    assert [one.SunElevation for one in lights(view)] == [40.0], f"lights of a scene: {lights(view)}"
    lights(view)[0].CoverRadius = 0.0
    bare = apart(picture(view), lit)
    assert bare > 0.02, f"grass covers {bare:.1%}"
    simple.Hide(simple.FindSource("Light"), view)
    assert not lights(view), "a hidden light"


def check_wood(name):
    check_memory(name)
    check_light(simple.GetActiveView())


if __name__ == "__main__":
    check("Forest", change=False, then=check_wood)
