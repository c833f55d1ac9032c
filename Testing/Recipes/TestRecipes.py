# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""All recipes applied to a copy of the tree, built there, and tested: the rows that they add, the entries in ParaView, the
classes and their outputs. A second run builds what has changed since the first."""
# run-with: python3 tier=all

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import recipes  # noqa: E402

sys.path.insert(0, str(recipes.TOP / "Testing" / "Mutation"))
import mutate  # noqa: E402

TREE = Path.cwd() / "tree"
BUILD = TREE / "build"
PYTHON = ("LittoralSourcesPython", "LittoralFiltersPython", "LittoralRenderingPython", "littoral_python_files")
NEW = ("vtkSlopeAspectFilter", "vtkDaVinciTreeSource")


def run(*command, **options):
    """Output of a program; the test ends where it fails."""
    done = subprocess.run([str(word) for word in command], cwd=TREE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))} ends with {done.returncode}:\n{done.stdout[-6000:]}")
    return done.stdout


def make_tree():
    """The tree with all recipes, of whose tests in Testing/Cxx only the new ones are left."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "tree"
        mutate.mirror(str(recipes.TOP), str(fresh))
        for test in (fresh / "Testing" / "Cxx").glob("Test*.cxx"):
            test.unlink()
        failed = recipes.apply_all(fresh)
        if failed:
            sys.exit(f"do not fit the tree: {failed}")
        mutate.mirror(str(fresh), str(TREE), ["build"])


def options_of_build():
    """Options of the build that this test belongs to, without what is not needed here."""
    cache = (Path(os.environ["LITTORAL_BUILD_DIR"]) / "CMakeCache.txt").read_text(encoding="utf-8", errors="replace")
    kept = re.findall(r"^((?:LITTORAL_WITH_PARAVIEW|CMAKE_BUILD_TYPE|CMAKE_CXX_COMPILER|CMAKE_CXX_FLAGS|CMAKE_PREFIX_PATH"
                      r"|ParaView_DIR|VTK_DIR|Python3_EXECUTABLE):\w+=.*)$", cache, re.M)
    without = [f"LITTORAL_WITH_{name}=OFF" for name in ("GDAL", "OPENVDB", "TINYGLTF")]  # no recipe touches IO
    return [f"-D{option}" for option in kept + without] + mutate.USUAL


def build():
    """The programs that test recipes, and the package."""
    run("cmake", "-G", "Ninja", "-B", BUILD, *options_of_build())
    programs = {program for tests in recipes.TESTS.values() for program, _ in tests}
    run("ninja", "-C", BUILD, f"-j{os.environ.get('LITTORAL_RECIPE_JOBS', os.cpu_count())}", *sorted(programs), *PYTHON)


def in_build(*command):
    """Output of a program that finds the libraries and the package of the copy."""
    return run(BUILD / "bin" / "littoral-env", "--display", *command)


def test(name):
    """The tests of a recipe, which run at least one case each."""
    for program, what in recipes.TESTS[name]:
        path = BUILD / "bin" / program
        if program == mutate.CLASSES:
            in_build(path, what, "-T", TREE)
            continue
        passed = re.search(r"\[  PASSED  \] (\d+) tests?", in_build(path, f"--gtest_filter={what}"))
        if not passed or int(passed[1]) == 0:
            sys.exit(f"{name}: {program} has no test {what}")
        print(f"{name}: {program} {what}, {passed[1]} cases")


def main():
    make_tree()
    build()
    for name in recipes.TESTS:
        test(name)
    python = (sys.executable, "-B")
    for generator in TREE.glob("Documentation/make_classes.py"):
        in_build(*python, generator)  # the page of classes
    for script in ("TestProxies", "TestClasses", "TestPropertyDocs"):
        in_build(*python, TREE / "Testing" / "Python" / (script + ".py"))
    printed = in_build(*python, TREE / "Testing" / "Hashes" / "hash_outputs.py", *NEW)
    for name in NEW:
        assert f"{name} default" in printed and f"{name} 1" in printed, printed[-2000:]


if __name__ == "__main__":
    if not shutil.which("git") or not shutil.which("ninja"):
        sys.exit(125)
    main()
