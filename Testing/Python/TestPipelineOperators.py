# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's short forms work for all classes: keywords of constructors, properties in snake case, `source >> filter` and
calls, also of sources whose only input is optional."""

import re
import sys

from vtkmodules.vtkCommonCore import vtkFloatArray, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import littoral

if not hasattr(vtkAlgorithm, "__rshift__"):
    print("skipped: VTK has these forms from 9.4 on, ParaView from 5.13; this is VTK", vtkVersion.GetVTKVersion())
    sys.exit(125)

from vtkmodules.util.execution_model import select_ports  # noqa: E402, not there before

#: Methods with another argument: the position in a list, of a connection, or a prop.
NO_PROPERTIES = {"Weight", "SourceKind", "SourceName", "Material", "Transmittance"}
#: Properties that are objects, or None.
OBJECTS = {"Controller"}
ABSTRACT = {"vtkPlantSource", "vtkSingleFileWriter", "vtkRandomFieldAlgorithm", "vtkLeafyTreeSource", "vtkViewDependentAlgorithm"}


def snake(name):
    """The property of the methods SetName and GetName, as VTK calls it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def names_of_properties(cls):
    """What the class itself can both set and get."""
    own = {name for base in cls.__mro__ if base.__module__.startswith("littoral") for name in vars(base)}
    return sorted(name[3:] for name in own if name.startswith("Get") and "Set" + name[3:] in own)


def check_properties(cls):
    """Each property gives what its method gives, and takes it back, also as a keyword."""
    checked, names = 0, names_of_properties(cls)
    for name in names:
        new = cls()
        if not hasattr(new, snake(name)):
            assert name in NO_PROPERTIES, (cls, name)
            continue
        value = getattr(new, "Get" + name)()
        if name not in OBJECTS and not hasattr(value, "GetClassName"):
            assert getattr(new, snake(name)) == value, (cls, name)
            for other in (changed(value, 1), changed(value, -1)):  # one of them is in range
                getattr(new, "Set" + name)(other)
                expected = getattr(new, "Get" + name)()
                if expected != value:
                    break
            made = cls(**{snake(name): other})
            assert getattr(made, "Get" + name)() == expected != value, (cls, name, other, expected)
            setattr(made, snake(name), value)
            assert getattr(made, "Get" + name)() == value, (cls, name)
            checked += 1
    assert checked or not names, cls
    return checked


def changed(value, by):
    """Another value of the same kind."""
    if isinstance(value, tuple):
        return tuple(changed(one, by) for one in value)
    if isinstance(value, bool):
        return not value
    if value is None or isinstance(value, str):
        return "other"
    return 0.5 * value if abs(value) > 1e15 else value + type(value)(by)


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

    fits = vtkTable()
    for name, value in (("ModelId", littoral.vtkTurningBandsTerrainSource.Fractal), ("Mean", 5000.0)):
        column = vtkFloatArray()
        column.SetName(name)
        column.InsertNextValue(value)
        fits.AddColumn(column)
    assert small(fits).GetScalarRange()[0] > 4000.0, "an input that is given counts"
    assert small().GetScalarRange() == plain.GetScalarRange(), "it does not stay"
    producer = vtkTrivialProducer()
    producer.SetOutput(fits)
    chain = small >> vtkElevationFilter()
    small.SetInputConnection(producer.GetOutputPort())
    chain()
    assert small().GetScalarRange()[0] > 4000.0, "an input that is connected stays"
    assert small.GetInputAlgorithm(0, 0) is producer

    plane, orbits = vtkPlaneSource(x_resolution=3), littoral.vtkParticleOrbitFilter()
    plane >> orbits
    riding = sea >> select_ports(1, orbits)
    assert riding().GetNumberOfPoints() == 8
    assert sea.GetNumberOfInputConnections(0) == 0 and orbits.GetInputAlgorithm(1, 0) is sea


classes = [getattr(littoral, name) for name in littoral.__all__ if name not in ABSTRACT]
counts = [check_properties(cls) for cls in classes]
for one in classes:
    if issubclass(one, vtkAlgorithm):
        check_chain(one)
check_calls()
print(len(classes), "classes,", sum(counts), "properties")
assert len(classes) > 15 and sum(counts) > 150
