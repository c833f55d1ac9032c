# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs lie beside the modules, parse, and list all classes and methods, with units in their docstrings."""

import ast
import os
import sys

import littoral
from littoral import LittoralFilters, LittoralRendering, LittoralSources

try:
    import vtkmodules.generate_pyi  # noqa: F401
except ImportError:
    print("skipped: this VTK has no generator of stubs")
    sys.exit(125)


def methods(body):
    """Functions of a class or file by name."""
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


folder = os.path.dirname(littoral.__file__)
assert os.path.exists(os.path.join(folder, "py.typed"))
listed = {}
for module in (LittoralSources, LittoralFilters, LittoralRendering, sys.modules.get("littoral.LittoralIO")):
    if module is None:
        continue
    with open(os.path.join(folder, module.__name__.rpartition(".")[2] + ".pyi"), encoding="utf-8") as file:
        tree = ast.parse(file.read())
    listed.update((node.name, node) for node in tree.body if isinstance(node, ast.ClassDef))
assert set(littoral.__all__) <= set(listed), set(littoral.__all__) - set(listed)

for name in littoral.__all__:
    cls, stub = getattr(littoral, name), listed[name]
    assert ast.get_docstring(stub).startswith(name + " - "), name
    own = {m for m, item in vars(cls).items() if m.startswith(("Set", "Get")) and callable(item)}
    assert own <= set(methods(stub.body)), (name, own - set(methods(stub.body)))

wind = methods(listed["vtkSeaStateSource"].body)
assert ast.unparse(wind["GetWindSpeed"].returns) == "float"
for accessor in ("SetWindSpeed", "GetWindSpeed"):
    assert "[m/s], 0.1 to 200" in ast.get_docstring(wind[accessor]), accessor
if hasattr(littoral.vtkSeaStateSource, "wind_speed"):  # VTK from 9.4 on
    body = listed["vtkSeaStateSource"].body
    place = next(k for k, node in enumerate(body)
                 if isinstance(node, ast.AnnAssign) and node.target.id == "wind_speed")
    assert ast.unparse(body[place].annotation) == "float"
    assert "[m/s]" in body[place + 1].value.value, "editors show no unit of the property"
print(len(listed), "classes in stubs")
