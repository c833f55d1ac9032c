# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: each entry becomes an ordinary pipeline with its parts in the browser, shows a picture, plays where it should,
and comes back from state files of both kinds; each part can be changed. Underwater fades into its background; the sea
has foam."""
import os
import subprocess
import sys
import tempfile

import numpy as np
import quick
from paraview import simple, smstate
from server import OWN_RANK
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SIZE = (300, 200)


def picture(view):
    """The view as an array of rows, columns and colors."""
    simple.Render(view)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "picture.png")
        simple.SaveScreenshot(file, view)
        reader = vtkPNGReader()
        reader.SetFileName(file)
        reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(float)


def empty_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    simple.SetActiveView(view)
    return view


def sources():
    """Names and types of what is in the pipeline browser."""
    return sorted((key[0], source.GetXMLName()) for key, source in simple.GetSources().items())


def visible(view):
    """Names of what the view shows."""
    shown = [display for display in view.Representations if hasattr(display, "Input") and display.Visibility]
    names = {source.GetGlobalIDAsString(): key[0] for key, source in simple.GetSources().items()}
    return sorted(names[display.Input.GetGlobalIDAsString()] for display in shown)


def difference(first, second):
    """Part of the pixels that differ."""
    return (np.abs(first - second).max(axis=2) > 12.0).mean()


def state(view, time):
    """What is in the browser, what of it is shown, and the picture."""
    view.ViewSize = SIZE
    view.ViewTime = time
    return {"parts": np.array(sources()), "shown": np.array(visible(view)), "picture": picture(view)}


def compare_states(name, kind, back, wanted):
    for key in ("parts", "shown"):
        assert np.array_equal(back[key], wanted[key]), f"{name}: {key} {back[key]} from {kind}, not {wanted[key]}"
    other = difference(back["picture"], wanted["picture"])
    assert other < 0.002, f"{name}: {other:.2%} of the picture is another from {kind}"


def check_states(name, view):
    """State files of both kinds bring back the pipeline, no part twice, and the picture."""
    time = view.ViewTime
    wanted = state(view, time)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "scene.pvsm")
        simple.SaveState(file)
        script = os.path.join(folder, "scene.py")
        with open(script, "w") as stream:
            stream.write(smstate.get_state())
        simple.ResetSession()
        simple.LoadState(file)
        view = simple.GetActiveViewOrCreate("RenderView")
        compare_states(name, ".pvsm", state(view, time), wanted)
        # In a process of its own, as users run it; ParaView 6.1 draws no blocks that such a script shows after a reset.
        numbers = os.path.join(folder, "state.npz")
        environment = {name: value for name, value in os.environ.items() if not name.startswith(OWN_RANK)}
        subprocess.run(["pvbatch", os.path.abspath(__file__), script, str(time), numbers], check=True,
                       env=environment)
        with np.load(numbers) as back:
            compare_states(name, ".py", back, wanted)
    return view


def check(name, parts, shown, last_time, change):
    """A scene with its parts by name, what of them is shown, the end of its time, and a change of a part."""
    view = empty_view()
    blank = picture(view)
    simple.Delete(view)
    view = empty_view()
    scene = getattr(simple, name)()
    assert len(simple.GetSources()) == 1, f"{name}: parts before it is shown"
    simple.Show(scene, view)
    names = [key[0] for key in simple.GetSources()]
    assert sorted(names) == sorted([f"{name}1", *parts]), f"{name}: consists of {names}"
    assert visible(view) == sorted(shown), f"{name}: shows {visible(view)}"
    first = picture(view)
    covered = difference(first, blank)
    assert covered > 0.3, f"{name}: the picture shows {covered:.1%}"
    assert np.unique(first.reshape(-1, 3), axis=0).shape[0] > 200, f"{name}: a flat picture"
    assert list(view.CameraViewUp) == [0.0, 0.0, 1.0], f"{name}: no view from the side"

    # Play works at once: the animation has the scene's times.
    animation = simple.GetAnimationScene()
    animation.UpdateAnimationUsingDataTimeSteps()
    end = animation.EndTime
    assert abs(end - last_time) < 1e-9, f"{name}: the animation ends at {end}"
    if last_time > 1.0:
        view.ViewTime = 1.0
        moved = difference(picture(view), first)
        assert moved > 0.002, f"{name}: {moved:.2%} of the picture moves"
        view.ViewTime = 0.0
        again = difference(picture(view), first)
        assert again < 0.001, f"{name}: {again:.2%} of the picture is another at the same time"
    else:
        moved = 0.0

    # The source and each other part can be changed.
    source, prop, value = change
    part = simple.FindSource(source)
    former = part.GetPropertyValue(prop)
    part.SetPropertyWithName(prop, value)
    changed = difference(picture(view), first)
    assert changed > 0.01, f"{name}: {prop} of {source} changes {changed:.2%}"
    part.SetPropertyWithName(prop, former)
    assert difference(picture(view), first) < 0.001, f"{name}: {prop} of {source} cannot be undone"

    view = check_states(name, view)
    # A scene that has its parts does not get them again in another view.
    number = len(simple.GetSources())
    simple.Show(simple.FindSource(f"{name}1"), empty_view())
    assert len(simple.GetSources()) == number, f"{name}: parts twice"
    print(f"{name}: {covered:.0%} covered, {moved:.1%} moves in a second, {changed:.0%} changes with {prop} of {source}")
    simple.ResetSession()


def depths(view):
    """The depth of each pixel in the view [m], from the z-buffer."""
    capture = vtkWindowToImageFilter()
    capture.SetInput(view.GetRenderWindow())
    capture.SetInputBufferTypeToZBuffer()
    capture.ShouldRerenderOff()
    capture.Update()
    image = capture.GetOutput()
    width, height, _ = image.GetDimensions()
    z = 2.0 * vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width).astype(float) - 1.0
    near, far = view.GetActiveCamera().GetClippingRange()
    return 2.0 * near * far / (far + near - z * (far - near))


def check_murk(part, extinction):
    """A part of Underwater fades into the background by exp(-k d), d from the z-buffer."""
    view = empty_view()
    simple.Show(simple.Underwater(), view)
    for name in visible(view):
        if name != part:
            simple.Hide(simple.FindSource(name), view)
    display = simple.GetDisplayProperties(simple.FindSource(part), view)
    if part == "Particles":
        # Few, so that they do not touch, and large enough to be measured.
        simple.FindSource("Water").Density = 0.1
        display.GaussianRadius = 20.0 * display.GaussianRadius
    murky = picture(view)
    display.UseShaderReplacements = 0
    display.ShaderPreset = "Sphere"
    clear = picture(view)
    depth = depths(view)
    background = 255.0 * np.array(view.Background)
    expected = background + (clear - background) * np.exp(-extinction * depth)[..., None]
    # Edges are mixtures of what is near and far.
    steps = np.max([np.abs(depth - np.roll(depth, step, axis)) for step in (-2, -1, 1, 2) for axis in (0, 1)], axis=0)
    shown = (depth < 0.9 * depth.max()) & (steps < 0.05 * depth)
    shown &= clear.max(axis=2) < 250.0  # what is brighter than white is cut off in the clear picture alone
    shown[[0, 1, -2, -1], :] = shown[:, [0, 1, -2, -1]] = False
    error = np.abs(expected - murky).max(axis=2)[shown]
    assert shown.mean() > 0.005 and difference(murky, clear) > 0.01, f"Underwater: {part} does not fade"
    print(f"Underwater: {part} fades with an error of {np.quantile(error, 0.9):.1f} in {shown.mean():.1%}")
    assert np.quantile(error, 0.9) < 3.0, f"Underwater: {part} fades with an error"
    simple.ResetSession()


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


def check_foam():
    """There is some foam on the sea, but not much."""
    view = empty_view()
    simple.Show(simple.Sea(), view)
    white = (picture(view)[: SIZE[1] // 2].min(axis=2) > 200.0).mean()  # the lower half; rows from below
    assert 0.001 < white < 0.1, f"Sea: foam on {white:.2%}"
    simple.ResetSession()


if len(sys.argv) == 4:
    with open(sys.argv[1]) as script:
        exec(compile(script.read(), sys.argv[1], "exec"), {"__name__": "__main__"})
    np.savez(sys.argv[3], **state(simple.GetActiveView(), float(sys.argv[2])))
else:
    check("Forest", ["Hills", "Valleys", "Pine", "Oak", "Birch", "Shrub", "Sites", "Trees", "Ground"], ["Valleys", "Trees", "Ground"], 1.0,
          ("Hills", "StandardDeviation", 30.0))
    check("SwayingForest", ["Hill", "Sites", "Birch", "Pine", "Wood", "Trees", "Ground"], ["Trees", "Ground"], 59.9,
          ("Sites", "MeanPerQuadrat", 1.5))
    check("Sea", ["Surface"], ["Surface"], 60.0, ("Sea1", "PeakPeriod", 10.0))
    check("Underwater", ["Relief", "Sites", "Sugar Kelp", "Eelgrass", "Plants", "Kelp", "Bed", "Water", "Particles", "Surface"],
          ["Kelp", "Bed", "Particles", "Surface"], 60.0, ("Water", "Density", 20.0))
    check("TwinOfAPlace", ["Valleys", "Ground"], ["Valleys", "Ground"], 1.0, ("TwinOfAPlace1", "Seed", 7))
    check_murk("Kelp", 0.085)
    check_murk("Bed", 0.085)
    # VTK 9.6 hands on no depth to the shaders of points.
    if vtkVersion().GetVTKMajorVersion() * 100 + vtkVersion().GetVTKMinorVersion() < 906:
        check_murk("Particles", 0.085)
    check_foam()
    check_defaults("SwayingForest", "Dimensions", [200, 16, 8])
    check_defaults("Sea", "PeakPeriod", 10.0)
    check_defaults("TwinOfAPlace", "Spacing", [50.0, 50.0, 1.0])
