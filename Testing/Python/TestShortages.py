# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs without memory, display or network end with one clear message, and lose nothing."""

import os
import shutil
import subprocess
import sys
import unittest

from TestFaults import Program, run
from vtkmodules.vtkCommonCore import vtkVersion

#: From VTK 9.4 on a render window that finds no X server draws by EGL or OSMesa.
DRAWS_ALONE = (vtkVersion().GetVTKMajorVersion(), vtkVersion().GetVTKMinorVersion()) >= (9, 4)

#: Settings that take more memory than the limits below leave, each in less than a second.
LARGE = {
    "vtkTurningBandsTerrainSource": "made.SetWholeExtent(0, 3999, 0, 3999, 0, 0); made.SetNumberOfLines(1)",
    "vtkWindFieldSource": "made.SetDimensions(256, 64, 64)",
    "vtkSeaweedSource": "made.SetTextureSize(2048, 2048)",
    "vtkSuspendedParticleSource": "made.SetDensity(100.0)",
    "vtkQuadratPointSource": "made.SetQuadrats(1000, 1000)",
    "vtkParticleFogFilter": "source = littoral.vtkSuspendedParticleSource(); made.SetDimensions(200, 200, 200)\n"
                            "made.SetInputConnection(source.GetOutputPort())",
}

#: Updates with so many megabytes left, and at last with no limit: prints messages and sizes.
LIMITED = """
import resource
import littoral
from vtkmodules.vtkCommonCore import vtkLogger
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
made = littoral.{name}()
{settings}
said = []
made.AddObserver("ErrorEvent", lambda *_: said.append(1))
made.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
made.UpdateInformation()
before = resource.getrlimit(resource.RLIMIT_AS)
for megabytes in 4, 60, 0:
    with open("/proc/self/statm", encoding="ascii") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    limit = used + (megabytes << 20) if megabytes else before[0]
    resource.setrlimit(resource.RLIMIT_AS, (limit, before[1]))
    said.clear()
    made.Modified()
    made.Update()
    outputs = [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]
    sizes = [data.GetNumberOfElements(kind) for data in outputs for kind in (0, 1)]
    print(len(said), sum(sizes), flush=True)
    for data in outputs:
        data.Initialize()
"""


class Shortages(Program):
    def test_short_memory(self):
        for name, settings in LARGE.items():
            with self.subTest(name):
                ran = run(LIMITED.format(name=name, settings=settings), VTK_SMP_BACKEND_IN_USE="Sequential")
                self.assertEqual((ran.returncode, ran.stderr), (0, ""))
                ends = [tuple(map(int, line.split())) for line in ran.stdout.splitlines()]
                self.assertEqual(ends[0], (1, 0))  # one message, nothing put out
                self.assertEqual(ends[-1][0], 0)  # and no trace of it where there is memory
                self.assertGreater(ends[-1][1], 100000)
                for end in ends:
                    self.assertIn(end, (ends[0], ends[-1]))

    def test_no_display(self):
        name = self.path("picture.png")
        script = ("import sys; import numpy; from littoral.elevation import image_from_array\n"
                  "from littoral.gallery import relief; from littoral.gallery.pictures import save_block; relief.CELLS = 0\n"
                  "save_block(sys.argv[1], image_from_array(numpy.eye(9), (1.0, 1.0)))")
        absent = next(k for k in range(77, 10000) if not os.path.exists(f"/tmp/.X11-unix/X{k}"))
        for display in (None, f":{absent}"):
            with self.subTest(display):
                with open(name, "w", encoding="utf-8") as file:
                    file.write("old")
                ran = run(script, name, DISPLAY=display, WAYLAND_DISPLAY=None)
                with open(name, "rb") as file:
                    content = file.read()
                if DRAWS_ALONE:
                    self.assertEqual((ran.returncode, content[:4]), (0, b"\x89PNG"), ran)
                else:
                    self.ends(ran, "RuntimeError: There is no display to", display or "DISPLAY is not set")
                    self.assertEqual(content, b"old")

    def test_no_network(self):
        alone = ["unshare", "--net"]
        if not shutil.which("unshare") or subprocess.run([*alone, "true"], capture_output=True, check=False).returncode:
            self.skipTest("only root can take the network away")
        script = ("import sys; import littoral; from littoral.elevation import read_elevation, write_vti\n"
                  "fit, twin = littoral.vtkCovarianceFitFilter(), littoral.vtkTurningBandsTerrainSource()\n"
                  "fit.SetInputData(read_elevation()); twin.SetInputConnection(fit.GetOutputPort())\n"
                  "twin.SetWholeExtent(0, 30, 0, 30, 0, 0); twin.Update(); write_vti(twin.GetOutput(), sys.argv[1])\n")
        ran = subprocess.run([*alone, sys.executable, "-c", script, self.path("twin.vti")], capture_output=True, text=True,
                             check=False)
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, "", ""))
        self.assertGreater(os.path.getsize(self.path("twin.vti")), 1000)


if __name__ == "__main__":
    unittest.main()
