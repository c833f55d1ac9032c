# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs of the package's extension modules, for editors: VTK's, with the documentation that they leave out.

    python3 write_stubs.py FOLDER MODULE...     writes MODULE.pyi into FOLDER, and py.typed
"""

import ast
import importlib
import os
import re
import sys

from vtkmodules import generate_pyi

PACKAGE = "littoral"


def documentation(item):
    """Words of the docstring of a method or property below its signatures."""
    text = item.__doc__ or ""
    return (text.split("\n\n", 1) + [""])[1].strip() if re.match(r"\w+\(", text) else text.strip()


def of_method(owner, name):
    """The documentation of a method; of a Get, Is or switch without any, that of its Set."""
    own = documentation(getattr(owner, name))
    plain = re.sub(r"^(Get|Set)|(On|Off|MinValue|MaxValue)$", "", name)
    return own or documentation(getattr(owner, "Set" + plain, None))


def literal(text):
    """A docstring as a statement."""
    return ast.Expr(ast.Constant(text))


def with_documentation(node, owner):
    """The stub of a class, with docstrings, and the types of properties."""
    gets = {child.name: child.returns for child in node.body if isinstance(child, ast.FunctionDef)}
    body = [literal(owner.__doc__.strip())] if owner.__doc__ else []
    for child in node.body:
        text = ""
        if isinstance(child, ast.FunctionDef) and child.name in vars(owner):
            text = of_method(owner, child.name)
            child.body = [literal(text)] if text else child.body
        elif isinstance(child, ast.ClassDef):
            child = with_documentation(child, getattr(owner, child.name))
        body.append(child)
        if isinstance(child, ast.AnnAssign) and child.target.id in properties(owner):
            get = "Get" + properties(owner)[child.target.id]
            child.annotation = gets.get(get) or ast.Name("Any")
            body += [literal(of_method(owner, get))] if get in gets and of_method(owner, get) else []
    node.body = body or node.body
    return node


def properties(owner):
    """Properties of a class, which VTK has from 9.4 on, with the names that their methods have."""
    methods = {name[3:] for name in vars(owner) if name.startswith(("Get", "Set"))}
    snakes = {re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower(): name for name in methods}
    return {name: snakes.get(name, "") for name, item in vars(owner).items()
            if type(item).__name__ == "getset_descriptor" and not name.startswith("__")}


def main(folder, modules):
    """Write the stubs."""
    generate_pyi.main(["generate_pyi", "-p", PACKAGE, "-o", folder, *modules])
    for name in modules:
        file = os.path.join(folder, name + ".pyi")
        module = importlib.import_module(f"{PACKAGE}.{name}")
        with open(file, encoding="utf-8") as stub:
            tree = ast.parse(stub.read())
        tree.body = [with_documentation(node, getattr(module, node.name)) if isinstance(node, ast.ClassDef) else node
                     for node in tree.body]
        with open(file, "w", encoding="utf-8") as stub:
            stub.write(ast.unparse(ast.fix_missing_locations(tree)) + "\n")
    with open(os.path.join(folder, "py.typed"), "w", encoding="utf-8"):  # before VTK 9.3 the generator makes none
        pass


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
