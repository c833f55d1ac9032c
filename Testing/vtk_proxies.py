# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions of paraview.simple without ParaView: each makes the object of a proxy and sets what the entries of the plugin
name, `WindField(ReferenceSpeed=9.0)`."""

import functools
import xml.etree.ElementTree as ElementTree

from vtkmodules.vtkFiltersGeneral import vtkMultiBlockDataGroupFilter
from vtkmodules.vtkFiltersSources import vtkPointSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader

import classes
import littoral


def group(Input):
    """A composite of one data set."""
    made = vtkMultiBlockDataGroupFilter()
    made.AddInputConnection(Input.GetOutputPort())
    return made


def csv_reader(FileName):
    """A table with numbers where there are some."""
    made = vtkDelimitedTextReader()
    made.SetFileName(FileName[0])
    made.SetHaveHeaders(True)
    made.SetDetectNumericColumns(True)
    return made


def point_source():
    """One point, as by ParaView's default."""
    made = vtkPointSource()
    made.SetNumberOfPoints(1)
    return made


OTHERS = {"Wavelet": vtkRTAnalyticSource, "Sphere": vtkSphereSource, "PointSource": point_source,
          "GroupDatasets": group, "CSVReader": csv_reader}


@functools.lru_cache(maxsize=None)
def proxies():
    """Definitions of the plugin's proxies by name."""
    return {one.get("name"): one for path in classes.PLUGIN.glob("*.xml")
            for group in ElementTree.parse(path).getroot().iter("ProxyGroup") for one in group}


def properties(proxy):
    """A proxy's own and those of its bases, by the name that Python gives them."""
    base = proxies().get(proxy.get("base_proxyname", ""))
    own = {(one.get("label") or one.get("name")).replace(" ", ""): one for one in proxy if one.get("command")}
    return {**({} if base is None else properties(base)), **own}


def set_input(made, element, values):
    """Connects one output or several."""
    values = values if isinstance(values, list) else [values]
    port = [int(element.get("port_index", 0))] if element.get("command").endswith("InputConnection") else []
    command = element.get("command") if len(values) == 1 else element.get("command").replace("Set", "Add")
    for value in values:
        getattr(made, command)(*port, value.GetOutputPort())


def set_default(made, element):
    """Sets the default of the entry, which is not that of its class where one class has several entries."""
    kind = {"IntVectorProperty": int, "DoubleVectorProperty": float}.get(element.tag)
    getter = getattr(made, "Get" + element.get("command")[3:], None)
    if kind and getter and element.get("default_values") and not element.get("use_index"):
        values = [kind(word) for word in element.get("default_values").split()]
        if values != list(getter() if len(values) > 1 else [getter()]):
            getattr(made, element.get("command"))(*values)


def set_value(made, element, value):
    """Sets a number, several, a text, or a choice by its name."""
    choices = {entry.get("text"): int(entry.get("value")) for entry in element.iter("Entry")}
    value = choices.get(value, value) if isinstance(value, str) else value
    getattr(made, element.get("command"))(*(value if isinstance(value, list) else [value]))


class VtkProxies:
    """The functions; `seen` is called with each object that is made."""

    def __init__(self, seen=lambda made: None):
        self.seen = seen

    def __getattr__(self, name):
        def make(**given):
            if name in OTHERS:
                return OTHERS[name](**given)
            proxy = proxies()[name]
            made = getattr(littoral, proxy.get("class"))()
            self.seen(made)
            known = properties(proxy)
            for element in known.values():
                set_default(made, element)
            for key, value in given.items():
                (set_input if known[key].tag == "InputProperty" else set_value)(made, known[key], value)
            return made

        return make
