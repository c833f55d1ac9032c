# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each Set method in the headers of the VTK classes has a doc that begins with a noun and names the true default.

So have the properties of ParaView's panels, which show defaults and other names than those of the classes.
"""

import glob
import math
import os
import re
import sys
import xml.etree.ElementTree

import littoral

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = ("Sources", "Filters", "Rendering", "IO")

# A sentence that begins so says nothing where it stands alone: in Doxygen's lists and in Python's help().
WEAK = {"of", "by", "from", "to", "in", "on", "at", "with", "for", "that", "what", "which", "where", "when", "how",
        "it", "its", "they", "their", "this", "these", "same"}

# Methods that set no property.
WITHOUT_DEFAULT = {"vtkSuspendedParticleSource::SetBoxName", "vtkViewDependentAlgorithm::SetCamera"}
# Defaults that are no value of a Get method, or that subclasses have.
IN_WORDS = {"vtkVDBVolumeWriter::SetController", "vtkLandscapePass::SetController",
            "vtkSingleFileWriter::SetController",
            "vtkGLTFSceneWriter::SetSourceName", "vtkGLTFSceneWriter::SetSourceKind",
            "vtkPlantScatterFilter::SetWeight", "vtkRandomFieldAlgorithm::SetModel",
            "vtkConditionalTerrainFilter::SetModelToFittedToData",
            "vtkViewDependentAlgorithm::SetNearDistance", "vtkViewDependentAlgorithm::SetFarDistance",
            "vtkLeafyTreeSource::SetVariation", "vtkLeafyTreeSource::SetTrunkRadius",
            "vtkLeafyTreeSource::SetNumberOfLeaves", "vtkLeafyTreeSource::SetLeafSize",
            "vtkLeafyTreeSource::SetLeafWidth"}

COMMENT = re.compile(r"^\s*(?:///(?![@<])|/\*\*|\*/|\*(?!/))\s?(.*?)(?:\*/)?$")
SETTER = re.compile(r"^\s*(?:virtual )?(?:vtkSet\w*Macro\((\w+)|void Set(\w+)\()")


def public_part(text):
    """What a header says before its first protected or private part, without what stands before the class."""
    text = re.sub(r"^.*?\npublic:\n", "", text, flags=re.DOTALL)
    return re.split(r"\n(?:protected|private):", text)[0]


def setters(text):
    """Names and docs of the Set methods of a header. A doc holds for the next declaration, or for a group of them."""
    doc, is_open, in_group = [], False, False
    for line in public_part(text).split("\n"):
        if line.strip() in ("///@{", "///@}"):
            in_group, doc, is_open = line.strip() == "///@{", [], False
            continue
        comment = COMMENT.match(line)
        if comment:
            doc = doc + [comment.group(1).strip()] if is_open else [comment.group(1).strip()]
            is_open = True
            continue
        is_open = False
        name = SETTER.match(line)
        if name:
            yield "Set" + (name.group(1) or name.group(2)), " ".join(" ".join(doc).split())
        if line.strip() and not in_group:
            doc = []


def complaint(doc):
    """What is wrong with the words of a doc, or nothing."""
    if not doc:
        return "has no doc"
    first = doc.split()[0]
    if first.lower().strip(",:;.") in WEAK or not first[0].isalpha():
        return f"begins with '{first}'"
    if not doc.endswith((".", ")")):
        return "does not end as a sentence"
    return ""


def no_default(method, doc):
    """Whether a doc wants a default, in words."""
    if method not in WITHOUT_DEFAULT and not method.endswith("Connection") and not re.search(r"\bdefault", doc, re.I):
        return "names no default"
    return ""


def number(word):
    """A number of a doc, also as a fraction."""
    over, _, under = word.partition("/")
    return float(over) / float(under or 1.0)


def is_default(text, value, owner):
    """Whether words of a doc mean a value: on, off, null, an enumerator, a text, numbers."""
    if text in ("on", "off"):
        return isinstance(value, (bool, int)) and bool(value) == (text == "on")
    if text == "null":
        return value is None
    if isinstance(value, str):
        return text.strip("`") == value
    if re.fullmatch(r"[A-Za-z]\w*", text):
        return getattr(owner, text, None) == value
    values = value if isinstance(value, (tuple, list)) else (value,)
    try:
        words = [number(word) for word in re.sub(r" ?/ ?", "/", text).split()]
    except ValueError:
        return False
    return len(words) == len(values) and all(math.isclose(w, v, rel_tol=1e-12) for w, v in zip(words, values))


def instance(name):
    """A fresh object of a class, of a subclass where it is abstract; None where this build has none."""
    base = getattr(littoral, name) if name in littoral.__all__ else None
    family = [base] + [getattr(littoral, other) for other in littoral.__all__] if base else []
    for cls in family:
        if isinstance(cls, type) and issubclass(cls, base):
            try:
                return cls()
            except TypeError:  # abstract
                pass
    return None


def wrong_default(method, doc, made):
    """In which way the default of a doc is not that of a fresh object, or nothing."""
    get = getattr(made, method.replace("Set", "Get", 1), None)
    if get is None:
        return "has no Get method to compare its default with"
    said = re.search(r"\bdefault:? (.+?)(?=[.,;:](?:\s|$)|\s\()", doc, re.I)
    if not said:
        return "names no default in the form 'default VALUE'"
    if not is_default(said.group(1), get(), type(made)):
        return f"says '{said.group(0)}', and a fresh object has {get()}"
    return ""


def inherited_defaults(text):
    """Names and values that the doc of a class gives for the properties of its base."""
    doc = " ".join(re.sub(r"^ \*", "", text, flags=re.MULTILINE).split())
    said = re.search(r"Defaults of inherited properties: (.+?)\.(?: |$)", doc)
    return re.findall(r"(\w+) ([-+.\de]*\d)", said.group(1)) if said else []


problems, checked, compared = [], 0, 0
for path in sorted(path for folder in FOLDERS for path in glob.glob(os.path.join(TOP, folder, "vtk*.h"))):
    name = os.path.basename(path)[:-2]
    with open(path, encoding="utf-8") as header:
        text = header.read()
    found = list(setters(text))
    made = instance(name)
    for inherited, value in inherited_defaults(text) if made else []:
        true = getattr(made, "Get" + inherited)()
        compared += 1
        if float(value) != true:
            problems.append(f"{name} says {inherited} {value}, and a fresh object has {true}")
    names = {method for method, _ in found}
    for method, doc in found:
        choice = re.match(r"(Set\w+?)To[A-Z]", method)
        if choice and choice.group(1) in names:
            continue  # SetModelToFractal() stands with SetModel()
        key = f"{name}::{method}"
        checked += 1
        reason = complaint(doc) or no_default(key, doc)
        if not reason and made and key not in WITHOUT_DEFAULT | IN_WORDS and not method.endswith("Connection"):
            compared += 1
            reason = wrong_default(method, doc, made)
        if reason:
            problems.append(f"{key} {reason}: {doc}")

panels = 0
for path in sorted(glob.glob(os.path.join(TOP, "paraview-plugin", "*.xml"))):
    for proxy in xml.etree.ElementTree.parse(path).getroot().iter():
        for item in proxy if proxy.tag.endswith("Proxy") else ():
            if not item.tag.endswith("Property") or item.tag == "Property":  # the latter only sets a value
                continue
            panels += 1
            doc = " ".join(item.findtext("Documentation", "").split())
            reason = complaint(doc) or ("names a class" if re.search(r"\bvtk[A-Z]", doc) else "")
            if reason:
                problems.append(f"{proxy.get('name')}.{item.get('name')} {reason}: {doc}")

print(checked, "Set methods,", compared, "defaults compared,", panels, "properties of panels")
for problem in problems:
    print(problem)
assert checked > 250, "the headers are not read any more"
assert panels > 200, "the panels are not read any more"
assert compared > 200, "the classes are not there to compare defaults with"
sys.exit(1 if problems else 0)
