# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""The properties panels: labels, groups and their order, rows for inputs, and what is greyed out."""

import glob
import os
import re
import xml.etree.ElementTree as ElementTree

import quick
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator

# Labels of ParaView's own widget for arrays, and of levels that are not those of the base class.
OTHER_LABELS = {"SelectInputScalars": "Array", "NearDistance": "Middle Distance", "Input": "Sites"}
INVENTORY = ("StandInventory", "Input")  # its label is Inventory


def words_of(name):
    """FooBar2 as Foo Bar 2."""
    return re.sub(r"(?<=[a-z])(?=[A-Z0-9])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def read_proxies():
    """All sources, filters and shared properties by name, and the names of those in a menu."""
    folder = os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "paraview-plugin")
    roots = [ElementTree.parse(path).getroot() for path in sorted(glob.glob(os.path.join(folder, "*.xml")))]
    proxies = {p.get("name"): p for root in roots for group in root.iter("ProxyGroup") for p in group if p.get("name")}
    return proxies, [p.get("name") for root in roots for p in root.iterfind("./*/Category/Proxy")]


def properties_of(proxy, proxies):
    """The properties of a proxy that its panel can show, inherited ones included, by name."""
    base = proxies.get(proxy.get("base_proxyname"))
    properties = properties_of(base, proxies) if base is not None else {}
    for one in proxy:
        if one.tag.endswith("Property") and not one.get("information_only"):
            properties[one.get("name")] = one
    return {name: one for name, one in properties.items() if one.get("panel_visibility") != "never"}


def groups_of(proxy, proxies):
    """The groups of a panel: first those of the proxy that it extends, which for a scene is its first source."""
    base = proxies.get(proxy.get("base_proxyname"))
    return (groups_of(base, proxies) if base is not None else []) + proxy.findall("PropertyGroup")


def text_of(one):
    """The documentation of a property."""
    found = one.find("Documentation")
    return " ".join((found.text or "").split()) if found is not None else ""


#: Names by which ParaView finds the times of a source; the panel does not show them.
TIMES = ("TimeRange", "TimestepValues")


def check_labels(proxy, properties):
    """A label is the name in words, since Python takes its names from labels; units stand elsewhere."""
    for name, one in properties.items():
        label = one.get("label", name)
        if label not in (words_of(name), OTHER_LABELS.get(name)) and (proxy.get("name"), name) != INVENTORY:
            yield f"the label of {name} is '{label}', not '{words_of(name)}'"
    for one in proxy.iterfind("ExposedProperties/Property"):
        label = one.get("exposed_name", one.get("name"))
        if label not in TIMES and label != words_of(label.replace(" ", "")):
            yield f"the label of {one.get('name')} is '{label}', not words"


def check_groups(panel_groups, properties):
    """Each property but inputs belongs to one group; titles are words, with units in brackets."""
    groups = {}
    for group in panel_groups:
        if not re.fullmatch(r"[A-Z][A-Za-z ]+( \([A-Za-z0-9/, ]+\))?", group.get("label", "")):
            yield f"the title of a group is '{group.get('label')}'"
        for member in group.iterfind("Property"):
            name = member.get("name")
            if name in groups:
                yield f"{name} is in two groups"
            if name not in properties:
                yield f"the group {group.get('label')} has {name}, which is no property"
            groups[name] = group
    for name, one in properties.items():
        if one.tag != "InputProperty" and name not in groups:
            yield f"{name} is in no group"


def check_units(properties):
    """A length says its unit in the tooltip."""
    for name, one in properties.items():
        if re.search(r"(Length|Distance|Radius|Height)$", name) and "[" not in text_of(one):
            yield f"{name} has no unit in its documentation"


def check_inputs(properties):
    """A second input has a row in the panel, and says where more than one are connected."""
    for name, one in properties.items():
        if one.tag != "InputProperty" or one.get("port_index", "0") == "0":
            continue
        if one.get("panel_widget") != "input_selector":
            yield f"{name} has no row"
        if one.get("multiple_input") and "Change Input" not in text_of(one):
            yield f"{name} does not say how more than one are connected"


def check_decorators(properties):
    """What is used in one case only is greyed out in the others; decorators name properties that exist."""
    for name, one in properties.items():
        decorators = [d for d in one.iter("PropertyWidgetDecorator")]
        for decorator in decorators:
            for hint in (decorator, *decorator.iter("PropertyWidgetDecorator")):
                if hint.get("property") and hint.get("property") not in properties:
                    yield f"{name} is greyed out by {hint.get('property')}, which is no property"
        is_limited = re.search(r"[Uu]sed only (with|if|by)|[Nn]ot used (by|if|unless)", text_of(one))
        if is_limited and not decorators:
            yield f"{name} is never greyed out, but '{text_of(one)}'"


def panel_order(name):
    """The properties of a proxy in the order of the panel."""
    manager = servermanager.ProxyManager()
    group = "filters" if manager.HasDefinition("filters", name) else "sources"
    iterator = vtkSMOrderedPropertyIterator()
    iterator.SetProxy(manager.GetPrototypeProxy(group, name))
    iterator.Begin()
    names = []
    while not iterator.IsAtEnd():
        names.append(iterator.GetKey())
        iterator.Next()
    return names


def check_order(name, panel_groups):
    """The panel has the groups in the order of the XML: a group stands where its first property does."""
    groups = {p.get("name"): g.get("label") for g in panel_groups for p in g.iterfind("Property")}
    shown = list(dict.fromkeys(groups[one] for one in panel_order(name) if one in groups))
    if shown != list(dict.fromkeys(groups.values())):
        yield f"the groups of the panel are {shown}"


def check(proxy, proxies):
    """All complaints about the panel of a proxy."""
    properties = properties_of(proxy, proxies)
    yield from check_labels(proxy, properties)
    yield from check_groups(groups_of(proxy, proxies), properties)
    yield from check_units(properties)
    yield from check_inputs(properties)
    yield from check_decorators(properties)
    yield from check_order(proxy.get("name"), groups_of(proxy, proxies))


simple.GetActiveViewOrCreate("RenderView")  # which connects
all_proxies, menu = read_proxies()
failures = [f"{name}: {reason}" for name in menu for reason in check(all_proxies[name], all_proxies)]
assert len(menu) >= 22 and not failures, "\n" + "\n".join(failures)
