# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What an object may do, whatever is done to it: the faults are raised as Fault.

Its outputs hold numbers only, or there is a message; a message is one clear sentence; and after valid settings the
outputs are those of a fresh object, byte by byte. That it does not crash or hang, the parent process sees.
"""

import functools
import re
import sys
import time
import typing
from math import inf
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import introspection
import inputs
import littoral
import recipes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Hashes"))
import hash_outputs  # noqa: E402

MESSAGE = re.compile(r"^(ERROR|Warning|Generic Warning): In ([^\n]*), line \d+\n(?:(\w+) \(0x([0-9a-f]+)\): )?(.*?)\n\n",
                     re.S | re.M)
FAILURE = re.compile(r"Algorithm vtk\w+ \(0x[0-9a-f]+\) returned failure for request")
ABOUT_INPUTS = re.compile(r"\b(inputs?|array|table|column|image|points?|blocks?|plants?|sites|prototypes?|wind|"
                          r"sea state|currents?|flow primitives?|terrain|leaf|leaves|cells?|skeleton|file|folder|"
                          r"memory|time|data|datum|grid|reference|window|sources?)\b", re.I)


PATIENCE = 3.0  # before a request is stopped, which large ones must allow [s of the processor]


class Message(typing.NamedTuple):
    """The class that speaks, what it says, and the address of the object."""
    kind: str
    said: str
    speaker: int


class Fault(Exception):
    """Something that an object must not do: the kind, and what it was."""


def messages():
    """What VTK has written since the last call, but for columns that a table has besides. What executives say is not ours."""
    window = vtkOutputWindow.GetInstance()
    text = window.GetOutput() if isinstance(window, vtkStringOutputWindow) else ""
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    found = MESSAGE.findall(text + "\n\n")
    return [Message(kind or file.rsplit("/", 1)[-1], " ".join(said.split()), int(address or "0", 16))
            for _, file, kind, address, said in found if not said.startswith("Columns not used: ")]


def is_executive(kind):
    """Whether a message is of VTK's pipeline, which repeats ours, or refuses a wrong type of input or an extent that data
    do not have."""
    return kind.endswith("Pipeline") or kind.startswith(("vtkExecutive", "vtkAlgorithm", "vtkTrivialProducer"))


def is_of_loop(said):
    """Whether a message is of VTK's loop over leaves, which does not make another output when the type of the composite
    changes."""
    return "CopyStructure" in said


def numbers_of(leaf):
    """The arrays of a leaf of floating-point numbers, by name, a row a tuple."""
    return [(name, vtk_to_numpy(array).reshape(array.GetNumberOfTuples(), array.GetNumberOfComponents()))
            for name, array in hash_outputs.arrays(leaf)
            if isinstance(array, vtkDataArray) and array.GetDataType() in (10, 11)]


def missing_points(data):
    """For each image of data, by its number of points, whether a number of a point is not finite."""
    missing = {}
    for leaf in inputs.leaves(data):
        if isinstance(leaf, vtkImageData):
            for _, numbers in numbers_of(leaf):
                if len(numbers) == leaf.GetNumberOfPoints():
                    bad = ~numpy.isfinite(numbers).all(axis=1)
                    missing[len(numbers)] = missing.get(len(numbers), False) | bad
    return missing


def odd_names(data, gaps=False, missing={}):
    """Names of arrays, points among them, that are not finite; with gaps, NaN stands for no value in a table, and in an
    image at missing points."""
    odd = set()
    for leaf in inputs.leaves(data):
        for name, numbers in numbers_of(leaf):
            is_gap = gaps and (isinstance(leaf, vtkTable) or (
                isinstance(leaf, vtkImageData) and numpy.reshape(missing.get(len(numbers), False), (-1, 1))))
            if len(numbers):
                fine = numpy.isfinite(numbers) | (numpy.isnan(numbers) & is_gap)
                if not fine.all():
                    odd.add(name)
        frame = []
        if isinstance(leaf, vtkImageData):
            frame = [*leaf.GetOrigin(), *leaf.GetSpacing()]
        if isinstance(leaf, vtkDataSet) and leaf.GetNumberOfPoints() and "points" not in odd:
            frame += leaf.GetBounds()
        if not numpy.isfinite(frame).all():
            odd.add("frame")
    return odd


def outputs(made):
    """The data of all output ports."""
    return [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]


def bytes_of(made):
    """Names and hashes of all that an object puts out."""
    found = []
    for port, data in enumerate(outputs(made)):
        for path, leaf in hash_outputs.leaves(data):
            if isinstance(leaf, vtkImageData):
                found.append(f"{port} {path} grid {leaf.GetExtent()} {leaf.GetOrigin()} {leaf.GetSpacing()}")
            if leaf:
                found += [f"{port} {path} {name} {hash_outputs.digest(array)}"
                          for name, array in hash_outputs.arrays(leaf)]
    return sorted(found)


@functools.lru_cache(maxsize=None)
def working_bytes(name):
    """Names and hashes of what the working object of a class puts out."""
    recipes.results(name)
    return bytes_of(recipes.source(name))


@functools.lru_cache(maxsize=None)
def odd_by_nature(name):
    """Names of the arrays of the working object that are not finite."""
    return set().union(*map(odd_names, recipes.results(name)))


class Player:
    """Runs the lines of a case, with what they call. A rehearsal leaves out all updates but the last."""

    def __init__(self, name, rehearsal=False):
        self.rehearsal = rehearsal
        self.properties = {setter.name[3:].lower() for setter in introspection.setters(name)}
        self.gaps = "NaN" in (getattr(littoral, name).__doc__ or "")
        self.may_be_odd = odd_by_nature(name)
        self.said = []  # since the last change
        self.heard = []  # at the last update
        self.kept = []
        self.refused = ""  # the last update, and why
        self.stopped = False  # the last update
        self.told = 0  # when the object was changed before it last spoke
        self.asked = None  # when it was changed before the last request; to stop it changes it too
        self.excused = False  # from telling why an update failed
        self.scope = {**vars(inputs), "littoral": littoral, "nan": numpy.nan, "inf": numpy.inf, "data": recipes.data,
                      "source": recipes.source, "update": self.update, "keep": self.keep, "finish": self.finish}

    @property
    def made(self):
        """The object of the case."""
        return self.scope["made"]

    def play(self, lines, before=lambda number: None):
        """Runs the lines; `before` is called with the number of each."""
        for number, line in enumerate(lines):
            before(number)
            if line.startswith("made."):
                self.said = []
            try:
                exec(line, self.scope)  # pylint: disable=exec-used
            except (TypeError, ValueError, OverflowError):
                pass  # Python refuses the value

    def update(self, time=None, piece=None, extent=None, stop=inf):  # pylint: disable=redefined-outer-name
        """Asks for the outputs, and looks at them; the request is stopped when its progress is above `stop`."""
        if self.rehearsal:
            return
        messages()
        self.watch(stop)
        self.ask(time, piece, extent)
        self.listen()
        self.look()

    def watch(self, share=inf):
        """Stops the object's next request when it takes long, or when its progress is above a share but not at its end."""
        end = time.process_time() + PATIENCE

        def stop(made, _):
            if made.GetProgress() < 1.0 and (time.process_time() > end or made.GetProgress() > share):
                self.stopped = True
                made.SetAbortExecute(1)

        self.stopped = False
        self.made.SetAbortExecute(0)  # VTK leaves that to the one who stopped
        self.asked = self.made.GetMTime()
        self.made.RemoveObservers("ProgressEvent")
        self.made.AddObserver("ProgressEvent", stop)

    def ask(self, moment, piece, extent):
        """The request itself."""
        made = self.made
        if hasattr(made, "Write"):
            made.Write()
        elif moment is not None:
            made.UpdateTimeStep(moment, *(piece or (-1, 1, 0)), *([extent] if extent else []))
        elif piece is not None:
            made.UpdatePiece(*piece, *([extent] if extent else []))
        elif extent is not None:
            made.UpdateExtent(extent)
        else:
            made.Update()

    def listen(self):
        """Looks at the messages of an update."""
        self.heard = all_said = messages()
        foreign = [message for message in all_said if message.kind not in littoral.__all__
                   and not is_executive(message.kind) and not is_of_loop(message.said)]
        if foreign:
            raise Fault("foreign message", f"{foreign[0].kind}: {foreign[0].said}")
        ours = [message.said for message in all_said if message.kind in littoral.__all__]
        self.said += all_said
        if len(ours) > 1:
            raise Fault("messages", " | ".join(ours))
        # Changes of the view do not repeat a message, and who gets nothing from an input that told why is silent.
        own = int(self.made.GetAddressAsString("").split("=")[-1], 16)
        self.excused = self.excused or hasattr(self.made, "SetViewPoint") or any(
            message.kind in littoral.__all__ and message.speaker != own for message in all_said)
        if ours:
            self.told = self.made.GetMTime()
        elif not self.excused and self.told != self.asked and any(FAILURE.match(message.said) for message in all_said):
            raise Fault("silence", all_said[0].said)
        for said in ours:
            words = set(re.findall(r"\w+", said.lower()))
            named = words & (self.properties | {name.lower() for data in self.given() for name in inputs.names(data)})
            if not said.endswith(".") or not (named or ABOUT_INPUTS.search(said)):
                raise Fault("unclear message", said)

    def given(self):
        """The data at the input ports."""
        made = self.made
        return [made.GetInputDataObject(port, index) for port in range(made.GetNumberOfInputPorts())
                for index in range(made.GetNumberOfInputConnections(port))]

    def look(self):
        """Looks at the numbers in the outputs."""
        if self.said:
            return
        missing = {}
        for data in self.given():
            missing.update(missing_points(data))
        odd = set().union(*(odd_names(data, self.gaps, missing) for data in outputs(self.made))) - self.may_be_odd
        odd -= set().union(*map(odd_names, self.given()))
        if odd:
            raise Fault("not a number", ", ".join(sorted(odd)))

    def keep(self):
        """An update whose outputs are handed on; nothing may write into them later."""
        if self.rehearsal:
            return
        self.update()
        for data in filter(None, outputs(self.made)):  # without an input that it follows from there is none
            copy = data.NewInstance()
            copy.ShallowCopy(data)
            self.kept.append((copy, [hash_outputs.digest(array) for leaf in inputs.leaves(copy)
                                     for _, array in hash_outputs.arrays(leaf)]))

    def finish(self):
        """The last update, of all there is at time 0."""
        messages()
        self.watch()
        made = self.made
        if hasattr(made, "Write"):
            made.Write()
        else:
            made.UpdateInformation()
            info = made.GetOutputInformation(0)
            pipeline = vtkStreamingDemandDrivenPipeline
            whole = info.Get(pipeline.WHOLE_EXTENT()) if info.Has(pipeline.WHOLE_EXTENT()) else None
            made.UpdateTimeStep(0.0, 0, 1, 0, *([whole] if whole else []))
        self.listen()
        self.look()
        self.refused = self.heard[0].said if self.heard else ""
        for copy, before in self.kept:
            if before != [hash_outputs.digest(array) for leaf in inputs.leaves(copy)
                          for _, array in hash_outputs.arrays(leaf)]:
                raise Fault("kept output", "outputs that were handed on have changed")


def connections(made):
    """What is connected to each input port."""
    return [[made.GetInputConnection(port, index) for index in range(made.GetNumberOfInputConnections(port))]
            for port in range(made.GetNumberOfInputPorts())]


def is_as_working(made, name, lines):
    """Whether a case has left an object with the settings and inputs of the working object, as far as can be seen, and
    with its outputs."""
    working = recipes.source(name)
    for setter in introspection.setters(name):
        now = introspection.present(made, setter)
        if now != introspection.present(working, setter) or now is None and any(f"made.{setter.name}(" in line for line in lines):
            return False
    return (working.GetNumberOfOutputPorts() > 0 and connections(made) == connections(working)
            and bytes_of(made) == working_bytes(name))


def play(name, lines, before=lambda number: None):
    """Runs a case and compares its end with the working object, which is fresh, or with one that gets the same settings
    if these differ from the working object's; how it ended."""
    player = Player(name)
    player.play(lines, before)
    if player.stopped:
        return "stopped"
    if not player.refused and is_as_working(player.made, name, lines):
        return "good"
    before(len(lines))
    fresh = Player(name, rehearsal=True)
    fresh.play(lines)
    if fresh.refused or fresh.stopped:
        return "refused" if fresh.refused else "stopped"
    if player.refused:
        raise Fault("no recovery", player.refused)
    differ = set(bytes_of(player.made)) ^ set(bytes_of(fresh.made))
    if differ:
        raise Fault("other bytes", ", ".join(sorted({line.rsplit(" ", 1)[0] for line in differ})[:3]))
    return "good"
