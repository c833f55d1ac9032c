# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files are whole or not there: full disks, kills, links, names, garbage."""

import contextlib
import errno
import fcntl
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import littoral
from littoral import files
from littoral.elevation import JACKSBORO, array_from_image, image_from_array, read_elevation, write_vti
from littoral.film import save_film
from littoral.glb import write_glb
from littoral.tables import table_of, write_csv

RANDOM = np.random.default_rng(7)

#: A process that writes two files in turn under one name and tells so, until it is killed.
WRITER = """
import sys
from TestFiles import KILLED
while True:
    for content in (1, 2):
        KILLED[sys.argv[1]](content, sys.argv[2])
        print("written", flush=True)
"""


def heights(count=300):
    return image_from_array(RANDOM.normal(size=(count, count)), (1.0, 1.0))


def picture(size=64):
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    pixels = RANDOM.integers(0, 256, (size * size, 3)).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    return image


def save_png(image, filename):
    from vtkmodules.vtkIOImage import vtkPNGWriter

    writer = vtkPNGWriter()
    writer.SetInputData(image)
    files.write(writer, filename)


def bytes_of(filename):
    with open(filename, "rb") as file:
        return file.read()


@contextlib.contextmanager
def full_disk(bytes_free):
    """A folder on a small file system of its own; skips where it cannot be mounted."""
    with tempfile.TemporaryDirectory() as folder:
        size = f"size={-(-bytes_free // 4096) * 4096}"
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", size, "tmpfs", folder], capture_output=True, check=False)
        if mounted.returncode != 0:
            raise unittest.SkipTest("only root can mount a small disk")
        try:
            yield folder
        finally:
            subprocess.run(["umount", folder], check=True)


def write_volume(content, filename):
    writer = littoral.vtkVDBVolumeWriter()
    writer.SetInputData(image_from_array(np.full((300, 300), content), (1.0, 1.0)))
    writer.SetFileName(filename)
    writer.Write()


def write_scene(content, filename):
    write_glb(filename, {"Land": image_from_array(np.full((200, 200), content), (1.0, 1.0))})


#: How to write content 1 or 2, by extension.
KILLED = {".vti": lambda content, name: write_vti(image_from_array(np.full((300, 300), content), (1.0, 1.0)), name)}
if hasattr(littoral, "vtkVDBVolumeWriter"):
    KILLED[".vdb"] = write_volume
if hasattr(littoral, "vtkGLTFSceneWriter"):
    KILLED[".glb"] = write_scene


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, name):
        return os.path.join(self.folder, name)


class Replaced(InFolder):
    """Each file that Littoral's Python package writes."""

    def writers(self):
        """Extension, and how to write a file of more than 100 kB."""
        frames = [self.path(f"{k}.png") for k in range(6)]
        for frame in frames:
            save_png(picture(160), frame)
        return {
            ".vti": lambda name: write_vti(heights(), name),
            ".csv": lambda name: write_csv(table_of({"x": RANDOM.normal(size=20000)}), name),
            ".png": lambda name: save_png(picture(256), name),
            ".ogv": lambda name: save_film(name, frames),
        }

    def test_a_full_disk_keeps_the_old_file(self):
        for extension, write in self.writers().items():
            with self.subTest(extension), full_disk(65536) as folder:
                name = os.path.join(folder, "file" + extension)
                with open(name, "w", encoding="utf-8") as file:
                    file.write("old")
                with self.assertRaises(OSError) as caught:
                    write(name)
                self.assertEqual(caught.exception.errno, errno.ENOSPC)
                self.assertEqual(caught.exception.filename, name)
                self.assertEqual(bytes_of(name), b"old")
                self.assertEqual(os.listdir(folder), [os.path.basename(name)])

    def test_a_kill_leaves_a_whole_file_and_no_other(self):
        """A process that is stopped has left what it leaves when it is killed there."""
        pause = random.Random(5)
        for extension, write in KILLED.items():
            name = self.path("killed" + extension)
            whole = []
            for content in (1, 2):
                write(content, name)
                whole.append(bytes_of(name))
            seen, left = set(), 0
            with subprocess.Popen([sys.executable, "-c", WRITER, extension, name], stdout=subprocess.PIPE, text=True,
                                  cwd=os.path.dirname(os.path.abspath(__file__))) as process:
                for number in range(16):
                    for _ in range(pause.randrange(1, 4)):
                        self.assertEqual(process.stdout.readline(), "written\n")
                    time.sleep(pause.uniform(0.0, 0.05))
                    process.send_signal(signal.SIGSTOP)
                    os.waitid(os.P_PID, process.pid, os.WSTOPPED)
                    seen.add(whole.index(bytes_of(name)))
                    left += len(os.listdir(self.folder)) - 1
                    process.send_signal(signal.SIGCONT if number < 15 else signal.SIGKILL)
            self.assertEqual(process.returncode, -signal.SIGKILL)
            seen.add(whole.index(bytes_of(name)))
            self.assertEqual(seen, {0, 1})
            self.assertLess(left, 4)  # only when stopped between two system calls
            write(1, name)  # and what was left goes with the next file
            self.assertEqual(os.listdir(self.folder), [os.path.basename(name)])
            os.unlink(name)

    def test_what_a_killed_process_has_left_goes(self):
        left, held = self.path(".littoral-1-1.part"), self.path(".littoral-1-2.part")
        for write in KILLED.values():
            with open(left, "wb"), open(held, "wb") as file:
                fcntl.flock(file, fcntl.LOCK_EX)
                write(1, self.path("new"))
                self.assertEqual(sorted(os.listdir(self.folder)), [os.path.basename(held), "new"])

    def test_links_lead_to_the_file(self):
        os.symlink("led-to.csv", self.path("link.csv"))
        for length in (3, 4):  # nothing is there yet; something is there
            write_csv(table_of({"x": np.arange(length)}), self.path("link.csv"))
            self.assertTrue(os.path.islink(self.path("link.csv")))
            self.assertEqual(len(bytes_of(self.path("led-to.csv")).splitlines()), length + 1)

    def test_what_is_no_file_stays(self):
        os.symlink("b.csv", self.path("a.csv"))
        os.symlink("a.csv", self.path("b.csv"))
        os.mkdir(self.path("folder.csv"))
        os.mkfifo(self.path("pipe.csv"))
        before = sorted(os.listdir(self.folder))
        for name, error in (("a.csv", errno.ELOOP), ("folder.csv", errno.EISDIR), ("pipe.csv", errno.EINVAL),
                            ("missing/x.csv", errno.ENOENT)):
            with self.subTest(name), self.assertRaises(OSError) as caught:
                write_csv(table_of({"x": [1.0]}), self.path(name))
            self.assertEqual(caught.exception.errno, error)
            self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertTrue(os.path.islink(self.path("a.csv")))

    def test_long_names(self):
        for length in (250, 255):
            name = self.path("x" * (length - 4) + ".csv")
            write_csv(table_of({"x": [1.0]}), name)
            self.assertEqual(bytes_of(name).split(), [b'"x"', b"1"])
        with self.assertRaises(OSError) as caught:
            write_csv(table_of({"x": [1.0]}), self.path("x" * 256))
        self.assertEqual(caught.exception.errno, errno.ENAMETOOLONG)

    def test_a_folder_without_rights(self):
        if os.getuid() != 0:
            os.chmod(self.folder, 0o500)
            self.addCleanup(os.chmod, self.folder, 0o700)
            with self.assertRaises(PermissionError):
                write_csv(table_of({"x": [1.0]}), self.path("x.csv"))
            return
        os.chmod(self.folder, 0o755)  # root writes everywhere: as another user
        script = ("import os, sys; import numpy; from littoral.tables import table_of, write_csv; os.setuid(65534)\n"
                  "try: write_csv(table_of({'x': [1.0]}), sys.argv[1])\nexcept PermissionError: print('refused')")
        ran = subprocess.run([sys.executable, "-c", script, self.path("x.csv")], capture_output=True, text=True, check=True)
        self.assertEqual((ran.stdout, ran.stderr), ("refused\n", ""))
        self.assertEqual(os.listdir(self.folder), [])

    def test_without_files_that_have_no_name(self):
        """As on a file system of a network: by a name of its own, which goes in the end."""
        real = os.open

        def refusing(path, flags, *arguments, **named):
            if flags & os.O_TMPFILE == os.O_TMPFILE:
                raise OSError(errno.EOPNOTSUPP, "")
            return real(path, flags, *arguments, **named)

        with mock.patch("os.open", refusing):
            write_csv(table_of({"x": [1.0]}), self.path("x.csv"))
            self.assertEqual(os.listdir(self.folder), ["x.csv"])
            with full_disk(65536) as folder:
                with self.assertRaises(OSError):
                    write_vti(heights(), os.path.join(folder, "x.vti"))
                self.assertEqual(os.listdir(folder), [])

    def test_an_exception_writes_nothing(self):
        with self.assertRaises(KeyError), files.replaced(self.path("x.txt")) as path:
            with open(path, "w", encoding="utf-8") as file:
                file.write("half")
            raise KeyError
        self.assertEqual(os.listdir(self.folder), [])


class Damaged(InFolder):
    """Readers of elevation models: a file cut at any place, and noise."""

    def models(self):
        """Whole files of each kind."""
        from osgeo import gdal

        gdal.UseExceptions()
        place = read_elevation()
        vti, tif = os.path.join(self.folder, "a.vti"), os.path.join(self.folder, "a.tif")
        write_vti(place, vti)
        grid = array_from_image(place)[::-1]
        raster = gdal.GetDriverByName("GTiff").Create(tif, grid.shape[1], grid.shape[0], 1, gdal.GDT_Float32)
        raster.SetGeoTransform((500000.0, 30.0, 0.0, 4000000.0, 0.0, -30.0))
        raster.GetRasterBand(1).WriteArray(grid)
        raster = None
        return vti, tif, JACKSBORO

    def test_cut_files_are_refused_in_one_sentence(self):
        contents = []
        for model in self.models():
            whole = bytes_of(model)
            contents += [(model, whole[:length]) for length in (
                0, 1, 10, 100, 300, 1000, len(whole) // 2, len(whole) - 20, len(whole) - 4)]
        self.refused(contents)

    def test_noise_is_refused_in_one_sentence(self):
        self.refused([(model, RANDOM.bytes(5000)) for model in self.models()])

    def refused(self, contents):
        """Files like a model with these contents: each is refused in one sentence, by one process for all."""
        names = []
        for k, (model, content) in enumerate(contents):
            names.append(os.path.join(self.folder, f"damaged{k}" + os.path.splitext(model)[1]))
            with open(names[-1], "wb") as file:
                file.write(content)
        script = ("import sys; from littoral.elevation import read_elevation\n"
                  "for name in sys.argv[1:]:\n"
                  "    try: read_elevation(name)\n    except ValueError as error: print(error)\n")
        ran = subprocess.run([sys.executable, "-c", script, *names], capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        lines = ran.stdout.splitlines()
        self.assertEqual([os.path.basename(line.partition(": ")[0].split()[-1]) for line in lines],
                         [os.path.basename(name) for name in names], ran.stdout)

    def test_rasters_have_their_place(self):
        _, tif, _ = self.models()
        image, place = read_elevation(tif), read_elevation()
        self.assertEqual(image.GetSpacing()[:2], (30.0, 30.0))
        self.assertEqual(image.GetOrigin()[:2], (500015.0, 4000000.0 - 30.0 * 343.5))
        self.assertTrue(np.array_equal(array_from_image(image), array_from_image(place)))

    def test_degrees_are_not_taken_for_metres(self):
        from osgeo import gdal, osr

        gdal.UseExceptions()
        name = os.path.join(self.folder, "degrees.tif")
        raster = gdal.GetDriverByName("GTiff").Create(name, 4, 3, 1, gdal.GDT_Float32)
        world = osr.SpatialReference()
        world.ImportFromEPSG(4326)
        raster.SetProjection(world.ExportToWkt())
        raster.SetGeoTransform((7.0, 0.001, 0.0, 46.0, 0.0, -0.001))
        raster = None
        with self.assertRaisesRegex(ValueError, "coordinates are degrees"):
            read_elevation(name)

    def test_missing_values_are_holes(self):
        name = os.path.join(self.folder, "holes.asc")
        with open(name, "w", encoding="utf-8") as file:
            file.write("ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9\n1 2 3\n4 -9 6\n")
        image = read_elevation(name)
        self.assertEqual(image.GetOrigin()[:2], (105.0, 205.0))
        self.assertTrue(np.array_equal(array_from_image(image), [[4.0, np.nan, 6.0], [1.0, 2.0, 3.0]], equal_nan=True))


if __name__ == "__main__":
    unittest.main()
