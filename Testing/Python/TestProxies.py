# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the proxies of the plugin say of a class is what a fresh object of the class says: defaults, choices, ranges."""

import math
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import littoral

PLUGIN = Path(__file__).resolve().parents[2] / "paraview-plugin"
NUMBERS = {"IntVectorProperty": int, "DoubleVectorProperty": float}

# Where a proxy differs from its class on purpose, with the reason.
OTHER_DEFAULTS = {
    **{(name, key): "at 2 m, slopes that soil stays on" for name in ("TurningBandsTerrain", "TwinOfAPlace")
       for key in ("StandardDeviation", "FractalDimension")},
    ("MeasuredSeaState", "Spectrum"): "the table of a measured spectrum, which this proxy has as its input",
    ("GLTFSceneViewWriter", "WriteCamera"): "a view has a camera",
    ("GLTFSceneViewWriter", "WriteSun"): "a view has lights",
}
# Choices of a class that a proxy leaves out on purpose, with the reason.
LEFT_OUT = {
    (name, "Spectrum"): {"table": "MeasuredSeaState has it"} for name in ("SeaState", "Sea", "Underwater")
}
# Choices whose enumeration has another name than that of the property with Type.
OTHER_ENUMERATION = {"FlowType": "PrimitiveType", "KrigingType": "KrigingKind", "ReflectanceModel": "ModelType",
                     "CoordinateUnit": "UnitType", "DiameterUnit": "UnitType", ("StandInventory", "HeightUnit"): "UnitType"}
# Numbers that are chosen from a list, and choices of VTK's own.
NOT_NAMED = {("GardnerPlant", "Frequency"), ("SuspendedParticles", "OutputPointsPrecision"),
             ("LandscapePass", "MapSize")}
# Defaults that no method gives back.
NO_GETTER = {("SuspendedParticles", "Boxes"), ("SuspendedParticles", "BoxNames")}

problems = []
counts = {"proxies": 0, "defaults": 0, "choices": 0, "domains": 0}


def expect(good, text):
    """Notes a problem, so that one run shows all."""
    if not good:
        problems.append(text)


def proxies():
    """Proxies of all files by group and name."""
    found = {}
    models = ElementTree.parse(PLUGIN / "CovarianceModels.xml").getroot()
    for file in sorted(PLUGIN.glob("*.xml")):
        root = ElementTree.parse(file).getroot()
        for domain in root.iterfind(".//CovarianceModels/.."):
            domain.extend(models)
        for group in root.iter("ProxyGroup"):
            for proxy in group:
                if proxy.tag.endswith("Proxy") and "class" in proxy.attrib:
                    found[group.get("name"), proxy.get("name")] = proxy
    return found


def properties(proxy, all_proxies):
    """The properties of a proxy and of its bases, each as the most derived has it."""
    found = {}
    base = all_proxies.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")))
    if base is not None:
        found.update(properties(base, all_proxies))
    for element in proxy:
        if element.tag.endswith("VectorProperty"):
            found[element.get("name")] = element
    return found


def plain(text):
    """A name without spaces and case."""
    return re.sub(r"[^a-z0-9]", "", text.lower())


def values_of(element):
    """Default values in the XML."""
    text = element.get("default_values")
    if text is None or element.tag == "StringVectorProperty":
        return text
    return [NUMBERS[element.tag](value) for value in text.split()]


def value_of(source, element):
    """What the object has for a property, as a list, or the text."""
    getter = getattr(source, "Get" + element.get("command")[3:])
    if element.get("use_index"):
        each = int(element.get("number_of_elements_per_command"))
        assert each == 1
        return [getter(index) for index in range(int(element.get("number_of_elements")))]
    value = getter()
    if element.tag == "StringVectorProperty":
        return value or ""
    return list(value) if isinstance(value, (tuple, list)) else [value]


def check_default(where, name, source, element):
    """The default of a property."""
    if (where, name) in NO_GETTER:
        return
    wanted = values_of(element)
    if wanted is None:
        return
    counts["defaults"] += 1
    has = value_of(source, element)
    if (where, name) in OTHER_DEFAULTS:
        expect(has != wanted, f"{where}.{name} has the default of its class: no exception is needed")
        return
    expect(has == wanted, f"{where}.{name}: default {wanted} in XML, {has} in {type(source).__name__}")


def enumerations(kind):
    """The enumerations of a class, as name: {member: value}."""
    found = {}
    for name in dir(kind):
        member = getattr(kind, name)
        if isinstance(member, int) and not isinstance(member, bool) and type(member) is not int:
            found.setdefault(type(member).__name__.split(".")[-1], {})[name] = int(member)
    return found


def same_name(text, member):
    """Whether an entry is named as an enumerator, which may need more words to be unique in its class."""
    return member.startswith("no") if text == "none" else member.startswith(text) or member == "by" + text


def check_names(where, name, source, command, entries):
    """The entries against what the class itself calls its values."""
    setter, named = getattr(source, "Set" + command), getattr(source, f"Get{command}AsString")
    for value, text in entries.items():
        setter(value)
        expect(plain(named()) == plain(text), f"{where}.{name}: {value} is {text} in XML, {named()} in the class")
    setter(max(entries) + 1)
    expect(named() == "Unknown" or plain(named()) in LEFT_OUT.get((where, name), {}),
           f"{where}.{name}: the XML ends before {named()}")


def check_enumerators(where, name, mine, members):
    """The entries against the enumerators of the class, in both directions."""
    left = dict(members)
    for text, value in mine.items():
        member = next((each for each in left if same_name(text, plain(each)) and left[each] == value), None)
        expect(member, f"{where}.{name}: no enumerator for {text} = {value}")
        left.pop(member, None)
    left = {member for member in left if plain(member) not in LEFT_OUT.get((where, name), {})}
    expect(not left, f"{where}.{name}: no entry for {sorted(left)}")


def check_choice(where, name, source, element, domain):
    """The entries of a list against the enumerators that the class has for its values, and the methods that set them."""
    if (where, name) in NOT_NAMED:
        return
    counts["choices"] += 1
    entries = {int(entry.get("value")): entry.get("text") for entry in domain.iter("Entry")}
    command = element.get("command")[3:]
    kind = OTHER_ENUMERATION.get(command, OTHER_ENUMERATION.get((where, command), command + "Type"))
    members = enumerations(type(source)).get(kind)
    expect(members, f"{where}.{name}: no {kind} in {type(source).__name__}")
    if not members:
        return
    check_enumerators(where, name, {plain(text): value for value, text in entries.items()}, members)
    before = value_of(source, element)
    if hasattr(source, f"Get{command}AsString"):
        check_names(where, name, source, command, entries)
    for member, value in members.items():
        method = f"Set{command}To{member.removesuffix('Rule')}"
        expect(hasattr(source, method), f"{where}.{name}: {type(source).__name__} has no {method}")
        getattr(source, method, lambda: None)()
        expect(value_of(source, element) == [value], f"{where}.{name}: {method} sets {value_of(source, element)}")
    getattr(source, "Set" + command)(*before)


def check_range(where, name, element, domain):
    """A default lies in its range, which is not empty."""
    counts["domains"] += 1
    lows = [float(value) for value in (domain.get("min") or "").split()]
    highs = [float(value) for value in (domain.get("max") or "").split()]
    for low, high in zip(lows, highs):
        expect(low < high, f"{where}.{name}: range {low} to {high}")
    for index, value in enumerate(values_of(element) or []):
        for ends, sign in ((lows, 1.0), (highs, -1.0)):
            end = ends[min(index, len(ends) - 1)] if ends else math.nan
            expect(not sign * value < sign * end, f"{where}.{name}: default {value} is beyond {end}")


def check_held(where, name, source, element, domain):
    """The class takes both ends of the range as they are."""
    kind = NUMBERS[element.tag]
    for end in (domain.get("min"), domain.get("max")):
        if end is None or element.get("use_index") or (where, name) in NO_GETTER:
            continue
        before = value_of(source, element)
        count = len(before)
        value = [kind(float(end.split()[min(index, len(end.split()) - 1)])) for index in range(count)]
        setter = getattr(source, element.get("command"))
        setter(*value)
        expect(value_of(source, element) == value, f"{where}.{name}: {value} becomes {value_of(source, element)}")
        setter(*before)


def check(where, proxy, all_proxies):
    """All properties of a proxy."""
    source = getattr(littoral, proxy.get("class"))()
    counts["proxies"] += 1
    for name, element in properties(proxy, all_proxies).items():
        if element.get("information_only") or not element.get("command"):
            continue
        if element.tag == "StringVectorProperty":
            if element.get("default_values") is not None:
                check_default(where, name, source, element)
            continue
        check_default(where, name, source, element)
        domains = [child for child in element if child.tag.endswith("Domain")]
        expect(domains, f"{where}.{name} has no domain")
        for domain in domains:
            if domain.tag == "EnumerationDomain":
                check_choice(where, name, source, element, domain)
            elif domain.tag.endswith("RangeDomain"):
                check_range(where, name, element, domain)
                check_held(where, name, source, element, domain)
            elif domain.tag == "BooleanDomain":
                expect(values_of(element) in ([0], [1]), f"{where}.{name}: default of a switch")


everything = proxies()
for (group, name), proxy in everything.items():
    derived = any(other.get("base_proxyname") == name for other in everything.values())
    if not derived and proxy.get("class") in littoral.__all__:
        check(name, proxy, everything)

# ParaView has no icon for some views, and says so in its window of messages.
for (group, name), proxy in everything.items():
    views = {view.get("type") for view in proxy.iter("View")}
    expect("RenderView" not in views or proxy.find("Hints/PipelineIcon") is not None,
           f"{name} opens a render view and has no PipelineIcon")
    # Charts have titles and are of outputs that exist.
    kind = getattr(littoral, proxy.get("class")) if proxy.get("class") in littoral.__all__ else None
    for chart in proxy.iter("ChartDisplay"):
        expect(chart.get("x") and chart.get("x-title") and chart.get("y-title"), f"{name}: a chart without titles")
        expect(kind and int(chart.get("port")) < kind().GetNumberOfOutputPorts(), f"{name}: a chart of no output")

print(counts)
for problem in problems:
    print(problem)
assert counts["proxies"] > 20 and counts["defaults"] > 250, counts
sys.exit(1 if problems else 0)
