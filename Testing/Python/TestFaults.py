# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs in trouble end with one clear message, and lose nothing: no room, rights or module, and tables that are
garbage. TestShortages.py takes memory, display and network away; TestFiles.py has the files themselves, killed writers and
damaged elevation models."""

import os
import random
import shutil
import subprocess
import sys
import unittest

import numpy as np

import littoral
from TestFiles import InFolder, full_disk, picture, save_png
from littoral.tables import table_of, write_csv

HERE = os.path.dirname(os.path.abspath(__file__))
HAS_VDB = hasattr(littoral, "vtkVDBVolumeWriter")
HAS_GLTF = hasattr(littoral, "vtkGLTFSceneWriter")

#: A program that writes a file of more than 100 kB to its first argument; the pictures of films are in its second.
WRITE = """
import sys
import numpy as np
import TestFiles
from littoral.elevation import image_from_array, write_vti
from littoral.film import save_film
from littoral.tables import table_of, write_csv

def write_vdb(name):
    writer = TestFiles.littoral.vtkVDBVolumeWriter()
    writer.SetInputData(TestFiles.heights())
    writer.SetFileName(name)
    if not writer.Write():
        sys.exit(1)

def write_glb(name):
    TestFiles.write_scene(1.0, name)

def write(name):
    {".vti": lambda: write_vti(TestFiles.heights(), name),
     ".csv": lambda: write_csv(table_of({"x": np.random.default_rng(1).normal(size=20000)}), name),
     ".png": lambda: TestFiles.save_png(TestFiles.picture(256), name),
     ".ogv": lambda: save_film(name, [f"{sys.argv[2]}/{k}.png" for k in range(6)]),
     ".vdb": lambda: write_vdb(name),
     ".glb": lambda: write_glb(name)}[name[-4:]]()
"""
KINDS = [".vti", ".csv", ".png", ".ogv"] + ([".vdb"] if HAS_VDB else []) + ([".glb"] if HAS_GLTF else [])


def run(script, *arguments, **environment):
    """Runs a program beside this file; a variable that is None is taken away."""
    variables = {**os.environ, **environment}
    return subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True, check=False, cwd=HERE,
                          env={name: value for name, value in variables.items() if value is not None})


class Program(InFolder):
    """Small programs, as users write them."""

    def pictures(self):
        """A folder with pictures for a film."""
        for k in range(6):
            save_png(picture(160), self.path(f"{k}.png"))
        return self.folder

    def ends(self, ran, *words):
        """The program has failed, and one line at the end of what it said has the words."""
        self.assertEqual(ran.returncode, 1, ran)
        names = [os.path.basename(word) for word in words]  # of files, without their folders
        lines = [line for line in ran.stderr.splitlines() if all(name in line for name in names)]
        self.assertEqual(len(lines), 1, ran.stderr)
        self.assertIn(lines[0], ran.stderr.splitlines()[-1:] if "ERR|" not in lines[0] else lines)


class Programs(Program):
    def test_a_full_disk(self):
        pictures = self.pictures()
        for kind in KINDS:
            with self.subTest(kind), full_disk(65536) as folder:
                name = os.path.join(folder, "file" + kind)
                with open(name, "w", encoding="utf-8") as file:
                    file.write("old")
                self.ends(run(WRITE + "write(sys.argv[1])", name, pictures), name, "No space left on device")
                self.assertEqual(os.listdir(folder), ["file" + kind])
                with open(name, encoding="utf-8") as file:
                    self.assertEqual(file.read(), "old")

    def test_a_folder_of_another_user(self):
        if os.getuid() != 0:
            self.skipTest("only root can be another user")
        pictures, locked = self.pictures(), self.path("locked")
        os.mkdir(locked, 0o755)
        os.chmod(self.folder, 0o777)
        script = "import os\nos.setuid(65534)\nwrite(sys.argv[1])"
        for kind in KINDS:
            with self.subTest(kind):
                name = os.path.join(locked, "file" + kind)
                with open(name, "w", encoding="utf-8") as file:
                    file.write("old")
                # What is loaded late is loaded first: the other user may have no right to read it.
                warm = WRITE + f"write({self.path('warm' + kind)!r})\n"
                self.ends(run(warm + script, name, pictures), name, "Permission denied")
                with open(name, encoding="utf-8") as file:
                    self.assertEqual(file.read(), "old")
                os.unlink(name)
        self.assertEqual(os.listdir(locked), [])

    def test_no_window_without_a_display(self):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        ran = subprocess.run([os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "littoral"), "gui"], capture_output=True,
                             text=True, check=False, env=environment, cwd=self.folder)
        self.assertEqual((ran.returncode, ran.stdout), (1, ""))
        self.assertEqual(ran.stderr, "[littoral] gui: ParaView needs a display, and DISPLAY is not set.\n")

    def test_a_missing_module(self):
        with open(self.path("hills.tif"), "wb") as file:
            file.write(b"II*")
        script = ("import sys; sys.modules['littoral.LittoralIO'] = None; from littoral.elevation import read_elevation\n"
                  "read_elevation(sys.argv[1])")
        self.ends(run(script, self.path("hills.tif")), "ImportError: ", "vtkElevationReader", "without GDAL")

    def test_tables_that_are_garbage(self):
        from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader

        pause = random.Random(3)
        write_csv(table_of({"Frequency": np.arange(1.0, 40.0) * 0.02, "Density": pause.choices(range(1, 9), k=39)}),
                  self.path("whole.csv"))
        with open(self.path("whole.csv"), "rb") as file:
            whole = file.read()
        rows = whole.index(b"\n", 200) + 1
        good = 0
        for content in [whole[:length] for length in (0, 1, 10, 19, 25, 40, rows - 3, rows, len(whole))] + [
                pause.randbytes(3000) for _ in range(5)]:
            with open(self.path("cut.csv"), "wb") as file:
                file.write(content)
            reader, sea, said = vtkDelimitedTextReader(), littoral.vtkSeaStateSource(), []
            reader.SetFileName(self.path("cut.csv"))
            reader.SetHaveHeaders(True)
            reader.DetectNumericColumnsOn()
            sea.SetInputConnection(reader.GetOutputPort())
            sea.SetSpectrumToTable()
            sea.AddObserver("ErrorEvent", lambda *_, said=said: said.append(1))
            sea.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
            sea.Update()
            trains = sea.GetOutput().GetNumberOfRows()
            self.assertEqual(len(said), 0 if trains else 1, content[:40])
            good += trains > 0
        self.assertIn(good, (2, 3))  # the whole one and those that end with a row


if __name__ == "__main__":
    unittest.main()
