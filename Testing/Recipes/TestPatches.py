# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes fit the tree, and Documentation/adding-things.md tells how many places, files and lines they take."""
# run-with: python3 tier=quick

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import recipes  # noqa: E402

PAGE = recipes.TOP / "Documentation" / "adding-things.md"


class Recipes(unittest.TestCase):
    """The patches, without a build."""

    def test_each_patch_is_listed(self):
        self.assertEqual(sorted(path.stem for path in recipes.HERE.glob("*.patch")), sorted(recipes.TESTS))

    def test_they_fit_together(self):
        with tempfile.TemporaryDirectory() as folder:
            recipes.copy_files(Path(folder))
            self.assertEqual(recipes.apply_all(folder), [])

    def test_the_page_counts(self):
        rows = re.findall(r"^\| .*?\(Testing/Recipes/([\w-]+)\.patch\).*? \| (\d+) \| (\d+) \| (\d+) \|$",
                          PAGE.read_text(encoding="utf-8").replace("(../Testing", "(Testing"), re.M)
        told = {name: tuple(map(int, numbers)) for name, *numbers in rows}
        true = {name: (len(recipes.places_of(name)), len(recipes.files_of(name)), sum(recipes.files_of(name).values()))
                for name in recipes.TESTS}
        self.assertEqual(told, true)


if __name__ == "__main__":
    if not shutil.which("git"):
        sys.exit(125)
    unittest.main()
