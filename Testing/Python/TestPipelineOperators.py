# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's short forms work for all classes: keywords of constructors, properties in snake case, `source >> filter` and
calls, also of sources whose only input is optional."""

import re
import sys

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

import littoral

if vtkVersion().GetVTKMajorVersion() * 100 + vtkVersion().GetVTKMinorVersion() < 903:
    print("skipped: VTK has these forms from 9.3 on, this is", vtkVersion.GetVTKVersion())
    sys.exit(125)

from vtkmodules.util.execution_model import select_ports  # noqa: E402, not there before
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkElevationFilter  # noqa: E402

ABSTRACT = {"vtkPlantSource", "vtkLeafyTreeSource", "vtkViewDependentAlgorithm"}


def snake(name):
    """The property of the methods SetName and GetName, as VTK calls it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def names_of_properties(cls):
    """What the class itself can both set and get."""
    own = {name for base in cls.__mro__ if base.__module__.startswith("littoral") for name in vars(base)}
    return sorted(name[3:] for name in own if name.startswith("Get") and "Set" + name[3:] in own)


def check_properties(cls):
    """Each property gives what its method gives, and takes it back, also as a keyword."""
    checked = 0
    for name in names_of_properties(cls):
        new = cls()
        value = getattr(new, "Get" + name)()
        if hasattr(new, snake(name)) and not hasattr(value, "GetClassName"):
            assert getattr(new, snake(name)) == value, (cls, name)
            other = changed(value)
            getattr(new, "Set" + name)(other)
            expected = getattr(new, "Get" + name)()  # clamped where the method clamps
            made = cls(**{snake(name): other})
            assert getattr(made, "Get" + name)() == expected, (cls, name, other, expected)
            assert expected != value or other == value, (cls, name, "does not change")
            checked += 1
    return checked


def changed(value):
    """Another value of the same kind."""
    if isinstance(value, tuple):
        return tuple(changed(one) for one in value)
    if isinstance(value, bool):
        return not value
    return "other" if value is None or isinstance(value, str) else value + type(value)(1)


def check_chain(cls):
    """The output of an algorithm goes to another, and an input comes from one."""
    algorithm = cls()
    for port in range(algorithm.GetNumberOfInputPorts()):
        source = vtkTrivialProducer()
        source.SetOutput(vtkTable())
        source >> select_ports(port, algorithm)
        assert algorithm.GetInputAlgorithm(port, 0) is source, (cls, port)
    if algorithm.GetNumberOfOutputPorts():
        target = vtkElevationFilter()
        algorithm >> target
        assert target.GetInputAlgorithm(0, 0) is algorithm, cls


def check_calls():
    """Sources with an optional input can be called, with and without it, and keep it."""
    small = littoral.vtkTurningBandsTerrainSource(whole_extent=(0, 20, 0, 20, 0, 0))
    elevation = (small >> vtkElevationFilter())()
    plain = small()
    assert elevation.GetNumberOfPoints() == plain.GetNumberOfPoints() == 441
    assert plain.GetScalarRange() == small.update().output.GetScalarRange()
    sea = littoral.vtkSeaStateSource(number_of_trains=7)
    assert sea().GetNumberOfRows() == 7
    points = littoral.vtkQuadratPointSource()
    assert (points >> vtkElevationFilter())().GetNumberOfPoints() == points().GetNumberOfPoints() > 0

    two = littoral.vtkSeaStateSource(number_of_trains=2)().GetColumnByName("AngularFrequency")
    table = vtkTable()
    table.AddColumn(two)
    for name in ("Amplitude", "Direction", "Phase"):
        table.AddColumn(littoral.vtkSeaStateSource(number_of_trains=2)().GetColumnByName(name))
    assert sea(table).GetNumberOfRows() == 2, "an input that is given counts"
    producer = vtkTrivialProducer()
    producer.SetOutput(table)
    sea.SetInputConnection(producer.GetOutputPort())
    assert sea().GetNumberOfRows() == 2, "an input that is connected stays"
    plane = vtkPolyData()
    orbits = littoral.vtkParticleOrbitFilter()
    plane >> orbits
    riding = sea >> select_ports(1, orbits)
    assert riding().GetNumberOfPoints() == 0
    assert sea.GetInputAlgorithm(0, 0) is producer and orbits.GetInputAlgorithm(1, 0) is sea


classes = [getattr(littoral, name) for name in littoral.__all__ if name not in ABSTRACT]
counts = [check_properties(cls) for cls in classes]
for one in classes:
    check_chain(one)
check_calls()
print(len(classes), "classes,", sum(counts), "properties")
assert len(classes) > 15 and sum(counts) > 150 and min(counts) > 0
