# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of Documentation/adding-things.md as patches, one a file beside this one, each with the tests that read what
it adds. They fit the tree together, in any order."""

import functools
import os
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]

#: Recipes, and programs with arguments that test them. Those of GoogleTest are given what they run: the new row.
TESTS = {
    "covariance-model": [("TestCovarianceModels", "*/Matern32"), ("TestVariogramFit", "*/Matern32")],
    "quadrat-law": [("TestQuadratLaws", "*/Geometric")],
    "point-process": [("TestPointProcesses", "*/VarianceGamma")],
    "wind-spectrum": [("TestWindSpectrum", "*/VonKarman")],
    "flow-primitive": [("TestCurrents", "*/Doublet")],
    "wood": [("TestPlantSway", "PlantSway.WoodOfSpecies")],
    "plant-preset": [("TestReevesTree", "*/Spruce"), ("TestPlantMeshes", "*")],
    "tree-model": [("TestDaVinciTree", "*"), ("LittoralCxxTests", "TestDaVinciTreeSource")],
    "filter": [("LittoralCxxTests", "TestSlopeAspectFilter")],
}


def patch_of(name):
    return HERE / (name + ".patch")


def git(*words, folder):
    """Output of git in a folder that it takes for no part of a repository; None if it fails."""
    environment = dict(os.environ, GIT_CEILING_DIRECTORIES=str(Path(folder).resolve().parent))
    done = subprocess.run(["git", *map(str, words)], cwd=folder, env=environment, stdout=subprocess.PIPE, text=True)
    return done.stdout if done.returncode == 0 else None


@functools.lru_cache(maxsize=None)
def files_of(name):
    """Files that a recipe touches, and the lines that it adds to each."""
    lines = (git("apply", "--numstat", patch_of(name), folder=TOP) or "").splitlines()
    return {path: int(added) for added, _, path in (line.split("\t") for line in lines)}


def places_of(name):
    """Places that a recipe touches: a header and its source are one."""
    return {os.path.splitext(path)[0] if path.endswith((".h", ".cxx")) else path for path in files_of(name)}


def apply_all(folder):
    """Applies all recipes to a copy of the tree; the names of those that do not fit."""
    return [name for name in TESTS if git("apply", patch_of(name), folder=folder) is None]


def copy_files(folder):
    """Copies the files that recipes touch."""
    for path in {path for name in TESTS for path in files_of(name)}:
        if (TOP / path).exists():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(TOP / path, folder / path)
