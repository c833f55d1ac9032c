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


#: A raster without pixels of its own, and a program that reads it: message, points, growth of its memory [MB].
GROUND = ('<VRTDataset rasterXSize="{side}" rasterYSize="{side}"><GeoTransform>0,1,0,0,0,-1</GeoTransform>'
          '<VRTRasterBand dataType="Float32" band="1"/></VRTDataset>')
READ = """
import resource, sys
import littoral
from littoral import errors
most = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
reader = littoral.vtkElevationReader()
reader.SetFileName(sys.argv[1])
said, before = errors.kept(reader), most()
reader.Update()
print(" ".join(said), reader.GetOutput().GetNumberOfPoints(), most() - before, sep="\\n")
"""
#: Other control groups than there are.
GROUP = """
mount -t tmpfs none /sys/fs/cgroup
mkdir -p {folder}/x
echo 1200000000 >{folder}/x/{limit}
echo 100000000 >{folder}/x/{usage}
mount --bind {groups} /proc/$$/cgroup
exec {python} -c "$1" "$2"
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

    def test_group_of_processes(self):
        """A control group of 1.2 GB, by its files: a raster of 2 GB is refused, one of 0.6 GB stays within what is asked."""
        if os.geteuid() or subprocess.run(["unshare", "-m", "true"], capture_output=True, check=False).returncode:
            self.skipTest("only root can show other control groups")
        raster = self.path("sparse.vrt")
        for kind, limit, usage, line in (("/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "4:memory:/x"),
                                         ("", "memory.max", "memory.current", "0::/x")):
            with open(self.path("cgroup"), "w", encoding="ascii") as file:
                file.write(line + "\n")
            for side in 20000, 10000:
                with self.subTest(limit, side=side):
                    with open(raster, "w", encoding="ascii") as file:
                        file.write(GROUND.format(side=side))
                    ran = subprocess.run(["unshare", "-m", "sh", "-ec", GROUP.format(
                        folder="/sys/fs/cgroup" + kind, limit=limit, usage=usage, groups=self.path("cgroup"),
                        python=sys.executable), "sh", READ, raster], capture_output=True, text=True, check=False)
                    self.assertEqual((ran.returncode, ran.stderr), (0, ""))
                    said, points, grown = ran.stdout.splitlines()
                    if side == 20000:
                        self.assertRegex(said, "20000 x 20000 heights needs 1.[0-9]+ GiB of memory, and 944 MiB are free")
                    self.assertEqual((bool(said), int(points)), (side == 20000, 0 if side == 20000 else side**2))
                    self.assertLess(float(grown), 60 + 5.3e-6 * int(points))

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
