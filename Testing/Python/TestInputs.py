# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=--every=17
# run-with: python3 tier=all
"""Bad inputs: each array of each input absent, twice, too short, of other components, of texts, with NaN and with ids of
nothing; each input and each of its leaves of another type, empty, null and nested. No filter may crash; each refuses
with one message or works, and afterwards makes of good inputs what a fresh one makes.

Filters and inputs are the small working objects of the fuzzer, one for each class (Testing/Fuzz/recipes.py). Names of
classes as arguments restrict the test to them, and LITTORAL_TEST_CASES to cases whose names match an expression;
--every=N takes each N-th case. To run it under valgrind:

    PYTHONMALLOC=malloc LITTORAL_TEST_CASES="short|empty" valgrind -q --trace-children=yes --error-exitcode=9 \
        python3 TestInputs.py
"""

import concurrent.futures
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"  # there are as many processes as cores
for folder in "Hashes", "Fuzz":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / folder))
# pylint: disable=wrong-import-position
import hash_outputs
import recipes
from hash_outputs import leaves, outputs_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_DOUBLE
from vtkmodules.vtkCommonCore import vtkDataArray, vtkOutputWindow, vtkPoints, vtkStringArray, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection,
    vtkPointSet, vtkPolyData, vtkTable)

import littoral
import numpy



# Inputs and their copies ----------------------------------------------------------------------------------------------
def good_inputs(name):
    """What feeds a class's working object, by ports."""
    return [recipes.results(other)[0] for other in recipes.inputs(name)]


def make(name):
    """A working object without inputs."""
    return hash_outputs.make(name, **recipes.settings(name))


def copy_of(data):
    """A copy whose leaves and arrays can be replaced."""
    copy = data.NewInstance()
    copy.DeepCopy(data)
    return copy


def attributes_of(leaf):
    """Kinds and arrays that a data set or a table has."""
    yield "field", leaf.GetFieldData()
    if isinstance(leaf, vtkDataSet):
        yield "point", leaf.GetPointData()
        yield "cell", leaf.GetCellData()
    elif isinstance(leaf, vtkTable):
        yield "row", leaf.GetRowData()


def all_leaves(data):
    """Paths and leaves, the composite itself among them for its field data."""
    if isinstance(data, vtkCompositeDataSet):
        yield "", data
    yield from leaves(data)


# Faults of arrays -----------------------------------------------------------------------------------------------------
def from_numbers(like, numbers, kind=None):
    """An array with other numbers; of the same type unless told otherwise."""
    array = numpy_to_vtk(numpy.ascontiguousarray(numbers), True, kind or like.GetDataType())
    array.SetName(like.GetName())
    return array


def numbers_of(array):
    return vtk_to_numpy(array).reshape(array.GetNumberOfTuples(), array.GetNumberOfComponents())


def fewer(array, tuples):
    """The first tuples, in an array that has no room for more."""
    if isinstance(array, vtkDataArray):
        return from_numbers(array, numbers_of(array)[:tuples])
    other = array.NewInstance()
    other.SetName(array.GetName())
    other.SetNumberOfComponents(array.GetNumberOfComponents())
    for row in range(tuples):
        other.InsertNextTuple(row, array)
    return other


def with_components(array, change):
    """As many tuples of more or fewer components."""
    numbers = numbers_of(array)
    components = max(1, numbers.shape[1] + change)
    return from_numbers(array, numpy.resize(numbers, (len(numbers), components)))


def texts(array):
    """As many texts."""
    other = vtkStringArray()
    other.SetName(array.GetName())
    other.SetNumberOfComponents(array.GetNumberOfComponents())
    other.SetNumberOfTuples(array.GetNumberOfTuples())
    return other


def spoilt(array, value, kind=None):
    """A copy in which the number in the middle is another one."""
    numbers = numbers_of(array).astype(numpy.float64)
    if numbers.size:
        numbers[len(numbers) // 2, 0] = value
    if kind is None:
        kind = array.GetDataType()
        with numpy.errstate(all="ignore"):
            numbers = numbers.astype(numbers_of(array).dtype)
    return from_numbers(array, numbers, kind)


ARRAY_FAULTS = {
    "absent": lambda array: None,
    "twice": lambda array: array,
    "short": lambda array: fewer(array, max(0, array.GetNumberOfTuples() - 1)),
    "empty": lambda array: fewer(array, 0),
    "wider": lambda array: with_components(array, 1),
    "narrower": lambda array: with_components(array, -1),
    "texts": texts,
    "nan": lambda array: spoilt(array, numpy.nan, VTK_DOUBLE),
    "huge": lambda array: spoilt(array, 1e300, VTK_DOUBLE),
    "large": lambda array: spoilt(array, 2**31 - 1 if "float" not in str(numbers_of(array).dtype) else 1e38),
    "negative": lambda array: spoilt(array, -7.0),
}


# What is needed, and is not there. Field arrays may have any number of tuples.
UNREADABLE = ("twice", "short", "empty", "texts")
#: A NaN among the heights of a terrain is a hole, which stays one in what is derived from it.
HOLES = ("vtkDrainageFilter",)
MUST_REFUSE = {"field": ("empty", "texts"), "point": UNREADABLE, "cell": UNREADABLE, "row": UNREADABLE}


def array_cases(inputs):
    """Each fault of each array: its name, the port and what it does to a copy of the input."""
    for port, data in enumerate(inputs):
        for path, leaf in all_leaves(data) if data else ():
            for kind, attributes in attributes_of(leaf):
                for index in range(attributes.GetNumberOfArrays()):
                    array = attributes.GetAbstractArray(index)
                    for fault in ARRAY_FAULTS:
                        if isinstance(array, vtkDataArray) or fault in ("absent", "twice", "short", "empty"):
                            yield f"port {port} {path} {kind} {array.GetName()} {fault}", port, (
                                spoil_array, path, kind, array.GetName(), fault)


def leaf_at(data, path):
    return next(leaf for own, leaf in all_leaves(data) if own == path)


def spoil_array(data, path, kind, name, fault):
    attributes = dict(attributes_of(leaf_at(data, path)))[kind]
    array = ARRAY_FAULTS[fault](attributes.GetAbstractArray(name))
    if array is None:
        attributes.RemoveArray(name)
    elif fault == "twice":
        second = array.NewInstance()
        second.DeepCopy(array)
        second.SetName("")
        attributes.AddArray(second)
        second.SetName(name)
    else:
        attributes.AddArray(array)
    return data


# Faults of points and cells -------------------------------------------------------------------------------------------
def short_points(leaf):
    points = vtkPoints()
    points.SetData(fewer(leaf.GetPoints().GetData(), leaf.GetNumberOfPoints() - 1))
    leaf.SetPoints(points)


def nan_point(leaf):
    points = vtkPoints()
    points.SetData(spoilt(leaf.GetPoints().GetData(), numpy.nan))
    leaf.SetPoints(points)


def huge_point(leaf):
    points = vtkPoints()
    points.SetData(spoilt(leaf.GetPoints().GetData(), 1e30))
    leaf.SetPoints(points)


def no_points(leaf):
    leaf.SetPoints(None)


def other_precision(leaf):
    array = leaf.GetPoints().GetData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(from_numbers(array, numbers_of(array).astype(numpy.float64), VTK_DOUBLE))
    leaf.SetPoints(points)


POINT_FAULTS = {"short": short_points, "nan": nan_point, "huge": huge_point, "none": no_points,
                "double": other_precision}


def bad_cells(leaf, kind, value):
    """Makes a cell name a point that there is not."""
    cells = getattr(leaf, "Get" + kind)()
    ids = cells.GetConnectivityArray()
    ids.SetComponent(ids.GetNumberOfTuples() // 2, 0, value)  # the type of VTK 9.6 is not wrapped
    ids.Modified()
    cells.Modified()


def geometry_cases(inputs):
    for port, data in enumerate(inputs):
        for path, leaf in leaves(data) if data else ():
            if isinstance(leaf, vtkPointSet) and leaf.GetNumberOfPoints() > 0:
                for fault in POINT_FAULTS:
                    yield f"port {port} {path} points {fault}", port, (spoil_points, path, fault)
            for kind in ("Verts", "Lines", "Polys") if isinstance(leaf, vtkPolyData) else ():
                if getattr(leaf, "Get" + kind)().GetNumberOfCells() > 0:
                    for value in (leaf.GetNumberOfPoints(), 2**30, -1):
                        yield f"port {port} {path} {kind} name point {value}", port, (spoil_cells, path, kind, value)


def spoil_points(data, path, fault):
    POINT_FAULTS[fault](leaf_at(data, path))
    return data


def spoil_cells(data, path, kind, value):
    bad_cells(leaf_at(data, path), kind, value)
    return data


# Faults of leaves and whole inputs ------------------------------------------------------------------------------------
def small_image():
    image = vtkImageData()
    image.SetDimensions(3, 3, 1)
    return image


OTHERS = {"null": lambda: None, "table": vtkTable, "image": small_image, "no points": vtkPolyData,
          "blocks": vtkMultiBlockDataSet, "collection": vtkPartitionedDataSetCollection}


def replaced(blocks, path, other):
    """Replaces a leaf of a multiblock."""
    parts = path.strip("/").split("/")
    for index in range(blocks.GetNumberOfBlocks()):
        name = blocks.GetMetaData(index).Get(vtkCompositeDataSet.NAME()) if blocks.HasMetaData(index) else None
        if (name or str(index)) == parts[0]:
            if len(parts) > 1:
                replaced(blocks.GetBlock(index), "/".join(parts[1:]), other)
            else:
                blocks.SetBlock(index, other)
    return blocks


def block_paths(blocks, path=""):
    """Paths of all blocks, those of blocks included."""
    for index in range(blocks.GetNumberOfBlocks()):
        name = blocks.GetMetaData(index).Get(vtkCompositeDataSet.NAME()) if blocks.HasMetaData(index) else None
        own = f"{path}/{name or index}"
        yield own
        if isinstance(blocks.GetBlock(index), vtkMultiBlockDataSet):
            yield from block_paths(blocks.GetBlock(index), own)


def multiblock(*members):
    blocks = vtkMultiBlockDataSet()
    for index, member in enumerate(members):
        blocks.SetBlock(index, member)
    return blocks


def collection(*members):
    parts = vtkPartitionedDataSetCollection()
    for index, member in enumerate(members):
        parts.SetPartition(index, 0, member)
    return parts


WHOLES = {
    "other leaves": lambda data: multiblock(data, vtkTable(), small_image(), vtkPolyData()),
    "null leaf": lambda data: multiblock(data, None, data),
    "nested": lambda data: multiblock(multiblock(data, None), None, multiblock()),
    "in a collection": lambda data: collection(data) if not isinstance(data, vtkCompositeDataSet) else data,
    "collection of others": lambda data: collection(small_image(), vtkPolyData(), None),
    "collection of nothing": lambda data: vtkPartitionedDataSetCollection(),
    "empty": lambda data: data.NewInstance(),
}


def leaf_cases(inputs):
    for port, data in enumerate(inputs):
        if data is None:
            continue
        for other in OTHERS:
            yield f"port {port} is {other}", port, (whole_other, other)
        for whole in WHOLES:
            yield f"port {port} {whole}", port, (whole_changed, whole)
        for path in block_paths(data) if isinstance(data, vtkMultiBlockDataSet) else ():
            for other in OTHERS:
                yield f"port {port} {path} is {other}", port, (leaf_other, path, other)


def whole_other(_, other):
    return OTHERS[other]()


def whole_changed(data, whole):
    return WHOLES[whole](data)


def leaf_other(data, path, other):
    return replaced(data, path, OTHERS[other]())


# One class, in a process of its own -----------------------------------------------------------------------------------
class Watch:
    """The messages of an algorithm and of all else, but for the executive's echo of a failed request."""

    def __init__(self, algorithm):
        self.own = []
        self.others = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.others)

        def take(_, __, message):
            self.own.append(message.strip())

        def take_executive(_, __, message):
            if "returned failure for request" not in message:
                self.own.append(message.strip())

        take.CallDataType = take_executive.CallDataType = "string0"
        algorithm.AddObserver("ErrorEvent", take)
        algorithm.GetExecutive().AddObserver("ErrorEvent", take_executive)

    def messages(self):
        """What was said since the last time."""
        said, self.own = self.own, []
        others = [part for part in self.others.GetOutput().split("\n\n") if "ERROR" in part]
        self.others = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.others)
        return said, others


def has_new_nan(algorithm, names):
    """Names of output arrays with numbers that are not finite, beside those of the spoilt array."""
    found = []
    for port in range(algorithm.GetNumberOfOutputPorts()):
        data = algorithm.GetOutputDataObject(port)
        for path, leaf in leaves(data) if data else ():
            arrays = [leaf.GetPoints().GetData()] if isinstance(leaf, vtkPointSet) and leaf.GetPoints() else []
            for _, attributes in attributes_of(leaf):
                arrays += [attributes.GetArray(index) for index in range(attributes.GetNumberOfArrays())
                           if attributes.GetArrayName(index) not in names]
            found += [f"{path} {array.GetName()}" for array in arrays
                      if array and not numpy.isfinite(vtk_to_numpy(array)).all()]
    return found


def lines_without(name, lines):
    """Lines of outputs but for those of an array, and of the list of columns that nothing is made of."""
    return [line for line in lines if f" {name} " not in line and " UnusedColumns " not in line]


def set_inputs(algorithm, inputs):
    for port, data in enumerate(inputs):
        if data is not None:
            algorithm.SetInputDataObject(port, data)


def run(name, log, first, every):
    """The cases from one on; each is announced in the log before it runs, and its findings after it."""
    inputs = good_inputs(name)
    fresh = make(name)
    set_inputs(fresh, inputs)
    good = outputs_of(fresh)
    usual = has_new_nan(fresh, ())
    only = os.environ.get("LITTORAL_TEST_CASES", "")
    cases = [*array_cases(inputs), *geometry_cases(inputs), *leaf_cases(inputs)]
    with open(log, "a", encoding="utf-8") as file:
        def write(**entry):
            file.write(json.dumps(entry) + "\n")
            file.flush()

        matters = {}  # whether an output depends on an array
        for number, (label, port, (change, *arguments)) in enumerate(cases):
            if number < first or number % every or not re.search(only, label):
                continue
            carried = change is spoil_array and not matters.get((port, tuple(arguments[:3])), True)
            if carried and arguments[3] not in ("twice", "short", "texts", "huge"):
                continue  # no output depends on it: it can only be copied
            write(begin=number, label=label)
            filter_ = make(name)
            watch = Watch(filter_)
            set_inputs(filter_, inputs)
            filter_.SetInputDataObject(port, change(copy_of(inputs[port]), *arguments))
            succeeded = filter_.GetExecutive().Update()
            said, others = watch.messages()
            findings = []
            by_leaf = change in (whole_changed, whole_other)  # then VTK may hand over leaves one by one
            if len(set(said)) < len(said) if by_leaf else len(said + others) > 1:
                findings.append(f"{len(said + others)} messages: {said + others}")
            # Without a connection VTK's executive says what it wants, which is not heard here.
            if not succeeded and not said and not label.endswith("is null"):
                findings.append("failed without a message")
            if change is spoil_array:
                array, fault = tuple(arguments[:3]), arguments[3]
                if fault == "absent":
                    other = lines_without(array[2], outputs_of(filter_) if succeeded else ())
                    matters[port, array] = bool(said) or other != lines_without(array[2], good)
                elif fault in MUST_REFUSE[array[1]] and matters.get((port, array)) and not said:
                    findings.append("works with an array that it needs and cannot read")
            spoilt_names = arguments[2:3] if change is spoil_array else ()
            nans = [one for one in has_new_nan(filter_, spoilt_names) if one not in usual]
            if nans and not said and "nan" in label and name not in HOLES:
                findings.append(f"puts out {nans} without a message")
            filter_.SetInputDataObject(port, inputs[port])
            again = outputs_of(filter_) if said or number % 10 == 0 else good
            if again != good:
                findings.append(f"is not fresh afterwards: {[a for a in again if a not in good][:3]}")
            if any(watch.messages()):
                findings.append("complains of good inputs afterwards")
            write(end=number, said=said, findings=findings)
        write(done=len(cases))


def entries_of(log):
    """What a log has, one of its entries at least."""
    if not os.path.exists(log):
        return [{}]
    with open(log, encoding="utf-8") as file:
        return [json.loads(line) for line in file] or [{}]


def end_of(errors, *arguments):
    """How a new process ends that makes the cases, and the end of what it wrote into a file of errors: 0, 1 after an
    exception, or less the number of the signal. It is no fork, since libraries have threads."""
    with open(errors, "w+", encoding="utf-8", errors="replace") as file:
        end = subprocess.run([sys.executable, __file__, "--run", *map(str, arguments)], stderr=file, check=False).returncode
        file.seek(0)
        return end, file.read()[-500:]


def crashes(names, every, folder):
    """Runs classes in one process, and in a new one after each crash, with a log for each class. Findings by class."""
    found = {name: [] for name in names}
    left, first = list(names), 0
    while left:
        end, wrote = end_of(os.path.join(folder, "errors"), folder, first, every, *left)
        while left and "done" in entries_of(os.path.join(folder, left[0]))[-1]:
            name = left.pop(0)
        last = {}
        if left:
            name = left[0]
            last = entries_of(os.path.join(folder, name))[-1]
        if "begin" in last:
            found[name].append(f"{name}: {last['label']}: crashed with {end} {wrote}")
            first = last["begin"] + 1
        elif left or end:
            found[name].append(f"{name}: the process ended with {end}: {wrote}")
            left, first = left[1:], 0
    return found


def test(names, every):
    """Runs classes. Of each the name, numbers of cases and of refused ones, and findings."""
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for name, findings in crashes(names, every, folder).items():
            entries = entries_of(os.path.join(folder, name))
            labels = {entry["begin"]: entry["label"] for entry in entries if "begin" in entry}
            said = 0
            for entry in entries:
                if "end" in entry:
                    findings += [f"{name}: {labels[entry['end']]}: {one}" for one in entry["findings"]]
                    said += bool(entry["said"])
                    if os.environ.get("LITTORAL_TEST_TALKS"):
                        findings_text = entry["said"][0].split("\n")[-1] if entry["said"] else "works"
                        print("   ", name, labels[entry["end"]], "->", findings_text)
            results.append((name, len(labels), said, findings))
    return results


def main(arguments):
    if arguments[:1] == ["--run"]:
        folder, first, every, *names = arguments[1:]
        for name in names:
            run(name, os.path.join(folder, name), int(first) if name == names[0] else 0, int(every))
        return 0
    every = next((int(one[8:]) for one in arguments if one.startswith("--every=")), 1)
    wanted = [one for one in arguments if not one.startswith("--")]
    names = wanted or [name for name in recipes.NAMES if recipes.inputs(name) and hasattr(littoral, name)
                       and getattr(littoral, name)().GetNumberOfOutputPorts()]
    assert wanted or len(names) > 12, names
    cores = os.cpu_count()
    with concurrent.futures.ThreadPoolExecutor(cores) as pool:
        shares = pool.map(lambda core: test(names[core::cores], every), range(cores))
        results = [one for share in shares for one in share]
    for name, cases, said, findings in results:
        print(f"{name}: {cases} cases, {said} refused, {len(findings)} findings")
    findings = [one for result in results for one in result[3]]
    print(*findings, sep="\n")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
