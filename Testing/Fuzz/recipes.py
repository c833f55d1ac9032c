# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A small working object of each class, by its row in Testing/classes.py: what the cases vary, and what they hand to
other classes as inputs."""

import re
import sys
from pathlib import Path

import littoral
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import classes  # noqa: E402

NAMES = list(classes.BY_NAME)
MADE = {}


def inputs(name):
    """Names of the classes, or of other outputs, that feed the ports."""
    return [] if name in classes.OTHER_OUTPUTS else classes.BY_NAME[name].fed_by


def settings(name):
    """Methods and arguments of the working object."""
    return classes.BY_NAME[name].small


def source(name):
    """The working object of a class, or what hands on another output, one for all of a process."""
    if name in classes.OTHER_OUTPUTS and name not in MADE:
        other, port, changes = classes.OTHER_OUTPUTS[name]
        made = working(other, changes) if changes else source(other)
        made.Update()
        MADE[name] = vtkTrivialProducer()
        MADE[name].SetOutput(made.GetOutputDataObject(port))
    if name not in MADE:
        MADE[name] = working(name)
    return MADE[name]


def working(name, changes=None):
    """A working object of a class, with changes of its settings."""
    made = getattr(littoral, name)()
    for port, other in enumerate(inputs(name)):
        made.SetInputConnection(port, source(other).GetOutputPort())
    for method, values in {**settings(name), **(changes or {})}.items():
        getattr(made, method)(*values)
    return made


def results(name):
    """What the working object of a class puts out."""
    made = source(name)
    made.Update()
    return [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]


def warm(name, lines):
    """Updates the objects that a case needs."""
    for other in {name, *inputs(name), *re.findall(r"(?:data|source)\('(\w+)'\)", " ".join(lines))}:
        if source(other).GetNumberOfOutputPorts():
            source(other).Update()


def data(name):
    """A copy of what the working object of a class puts out."""
    output = results(name)[0]
    copy = output.NewInstance()
    copy.DeepCopy(output)
    return copy
