# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The classes of Littoral, and their setters with the types of their arguments, found by introspection."""

import functools
import re
from typing import NamedTuple

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkAbstractMapper

import littoral

SIGNATURE = re.compile(r"C\+\+:[\w\s:*&]*?\b(\w+)\(([^)]*)\)")
CHANGES = re.compile(r"(Set|Add|Remove|Clear|Insert)[A-Z]")


class Setter(NamedTuple):
    """A method that changes an object."""

    name: str
    types: tuple  # of its arguments: bool, int, double, string, object
    choices: int  # of an enumeration; 0: none
    packed: bool  # the arguments are one sequence


def is_concrete(kind):
    """Whether objects of a class can be made."""
    try:
        kind()
    except TypeError:
        return False
    return True


def all_classes():
    """Names of the classes of sources, filters, readers and writers that can be made."""
    return [name for name in littoral.__all__ for kind in (getattr(littoral, name),)
            if issubclass(kind, vtkAlgorithm) and not issubclass(kind, vtkAbstractMapper) and is_concrete(kind)]


def type_of(argument):
    """The kind of values that a C++ argument takes; objects by the name of their class."""
    if "char" in argument or "string" in argument:
        return "string"
    for name in ("bool", "double", "float", "vtk\\w+(?= *\\*)"):
        found = re.search(rf"\b{name}", argument)
        if found:
            return found.group().replace("float", "double")
    return "int"


def setter_of(kind, name):
    """The setter of that name, by its signature; None if it has none."""
    signatures = SIGNATURE.findall(re.sub(r"\s+", " ", getattr(kind, name).__doc__ or ""))
    if not signatures:
        return None
    arguments = [part for part in signatures[0][1].split(",") if part.strip()]
    length = re.search(r"\[(\d+)\]", arguments[0]) if len(arguments) == 1 else None
    types = tuple(type_of(part) for part in arguments) * (int(length.group(1)) if length else 1)
    choices = sum(other.startswith(name + "To") for other in vars(kind))
    return Setter(name, types, choices, bool(length))


def own_kinds(kind):
    """A class and those bases of it that are Littoral's."""
    return [base for base in kind.__mro__ if base.__module__.startswith("littoral")]


@functools.lru_cache(maxsize=None)
def setters(name):
    """All setters of a class, its own and those of Littoral's bases, by name."""
    found = {}
    for kind in own_kinds(getattr(littoral, name)):
        for method in vars(kind):
            if CHANGES.match(method) and method not in found:
                found[method] = setter_of(kind, method)
    return [found[method] for method in sorted(found) if found[method]]


def ports(made):
    """The types that the input ports require."""
    return [made.GetInputPortInformation(port).Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE())
            for port in range(made.GetNumberOfInputPorts())]


def present(made, setter):
    """The arguments that a setter would need to change nothing; None if its getter does not tell."""
    getter = getattr(made, "Get" + setter.name[3:], None)
    if not setter.name.startswith("Set") or getter is None:
        return None
    try:
        value = getter()
    except TypeError:  # a getter by index
        return None
    value = value if isinstance(value, tuple) else (value,)
    return value if len(value) == len(setter.types) else None
