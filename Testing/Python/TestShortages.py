# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs without memory, display or network end with one clear message, and lose nothing."""

import os
import re
import shutil
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import littoral
import numpy
from littoral import errors
from TestFaults import Program, run
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData

PLUGIN = Path(__file__).resolve().parents[2] / "paraview-plugin"

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
echo 300000000 >{folder}/x/{limit}
echo 25000000 >{folder}/x/{usage}
mount --bind {groups} /proc/$$/cgroup
exec {python} -c "$1" "$2"
"""

def scattered(count):
    """Places with heights."""
    data = vtkPolyData()
    points = numpy.random.default_rng(1).uniform(0.0, 100.0, (count, 3))
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk(points[:, 2], deep=True))
    return data


#: Classes that make points by what a property says: property, other settings, and values that are too many.
BOUNDED = {
    "vtkQuadratPointSource": ("MeanPerQuadrat", {"SetQuadrats": (40, 40)}, (1e5,)),
    "vtkPointProcessSource": ("Intensity", {"SetSize": (1000, 1000)}, (100,)),
    "vtkSuspendedParticleSource": ("Density", {"SetMode": (1,)}, (1e4,)),
    "vtkTurningBandsTerrainSource": ("WholeExtent", {"SetNumberOfLines": (1,)}, (60001, 60001)),
    "vtkWindFieldSource": ("Dimensions", {}, (20000, 100, 100)),
    "vtkConditionalTerrainFilter": ("Dimensions", {"SetInputData": (scattered(400),)}, (20000, 20000)),
}


class Bounds(unittest.TestCase):
    def update(self, name, values):
        """Message and points of a class by values of its property; the settings are those of its row."""
        made = getattr(littoral, name)()
        bounded, settings, _ = BOUNDED[name]
        for setter, arguments in settings.items():
            getattr(made, setter)(*arguments)
        if bounded == "WholeExtent":
            values = [number for side in values for number in (0, int(side) - 1)] + [0, 0]
        getattr(made, "Set" + bounded)(*(map(int, values) if bounded in ("WholeExtent", "Dimensions") else values))
        said, begin = errors.kept(made), time.process_time()
        made.UpdateWholeExtent()
        self.assertLess(time.process_time() - begin, 1.0)
        return " ".join(said), made.GetOutputDataObject(0).GetNumberOfElements(0)

    def test_numbers_that_do(self):
        """What makes too many points says so at once, and how many do: as many do, and more do not."""
        for bound in 5e7, 2e5:
            os.environ.update({} if bound == 5e7 else {"LITTORAL_MAXIMUM_POINTS": str(int(bound))})
            for name, (bounded, _, values) in BOUNDED.items():
                with self.subTest(name, bound=bound):
                    said, points = self.update(name, values)
                    asked = " x ".join(f"{value:g}" for value in values)
                    self.assertRegex(said, rf"{bounded}( of)? {asked} (gives|takes the time of) [0-9.]+ million points, "
                                           rf"more than the bound of {bound / 1e6:g} million: at most .* do\.$")
                    self.assertEqual(points, 0)
                    most = [float(number) for number in re.search("at most (.*) do", said)[1].split(" x ")]
                    if bound == 2e5:
                        said, points = self.update(name, most)
                        self.assertEqual(said, "")
                        self.assertLess(points, 1.1 * bound)  # numbers of random points vary
                        self.assertGreater(points, 0.1 * bound)
                        factor = 2.0 if name == "vtkWindFieldSource" else 1.02  # lengths that a wind can have
                        more = [factor * value if value == max(most) else value for value in most]
                        self.assertRegex(self.update(name, more)[0], "more than the bound")
        del os.environ["LITTORAL_MAXIMUM_POINTS"]

    def test_sentence(self):
        """The sentence of a slider that was moved to 100 000 points a quadrat."""
        said, _ = self.update("vtkQuadratPointSource", (1e5,))
        self.assertIn("MeanPerQuadrat of 100000 gives 160 million points, more than the bound of 50 million: "
                      "at most 31250 do.", said)

    def test_sliders(self):
        """Sliders end where there is no need to wait."""
        proxies = [one for path in sorted(PLUGIN.glob("*.xml")) for one in ElementTree.parse(path).iter() if one.get("class")]
        for name in "vtkQuadratPointSource", "vtkPointProcessSource", "vtkSuspendedParticleSource":
            with self.subTest(name):
                ranges = f"*[@name='{BOUNDED[name][0]}']/DoubleRangeDomain"
                end = next(one.get("max") for proxy in proxies if proxy.get("class") == name for one in proxy.iterfind(ranges))
                said, points = self.update(name, (float(end),))
                self.assertEqual(said, "")
                self.assertGreater(points, 1000)

    def test_bar(self):
        """Progress never goes back, and 100 % is the end of the work."""
        for name, values in (("vtkQuadratPointSource", (600,)), ("vtkPointProcessSource", (0.7,)),
                             ("vtkWindFieldSource", (4096, 16, 16)), ("vtkSuspendedParticleSource", (4,))):
            with self.subTest(name):
                made = getattr(littoral, name)()
                for setter, arguments in BOUNDED[name][1].items():
                    getattr(made, setter)(*arguments)
                getattr(made, "Set" + BOUNDED[name][0])(*values)
                at = []
                made.AddObserver("ProgressEvent", lambda source, _: at.append((source.GetProgress(), time.perf_counter())))
                begin = time.perf_counter()
                made.Update()
                end = time.perf_counter()
                self.assertEqual([progress for progress, _ in at], sorted(progress for progress, _ in at))
                done = next(moment for progress, moment in at if progress > 0.995)
                self.assertLess(end - done, 0.05 * (end - begin))


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
        """A control group of 0.3 GB, by its files: a raster of 0.5 GB is refused, one of 0.15 GB stays within what is asked."""
        if os.geteuid() or subprocess.run(["unshare", "-m", "true"], capture_output=True, check=False).returncode:
            self.skipTest("only root can show other control groups")
        raster = self.path("sparse.vrt")
        for kind, limit, usage, line in (("/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "4:memory:/x"),
                                         ("", "memory.max", "memory.current", "0::/x")):
            with open(self.path("cgroup"), "w", encoding="ascii") as file:
                file.write(line + "\n")
            for side in (10000, 5000) if kind else (10000,):
                with self.subTest(limit, side=side):
                    with open(raster, "w", encoding="ascii") as file:
                        file.write(GROUND.format(side=side))
                    ran = subprocess.run(["unshare", "-m", "sh", "-ec", GROUP.format(
                        folder="/sys/fs/cgroup" + kind, limit=limit, usage=usage, groups=self.path("cgroup"),
                        python=sys.executable), "sh", READ, raster], capture_output=True, text=True, check=False)
                    self.assertEqual((ran.returncode, ran.stderr), (0, ""))
                    said, points, grown = ran.stdout.splitlines()
                    if side == 10000:
                        self.assertRegex(said, "10000 x 10000 heights needs [0-9]+ MiB of memory, and 236 MiB are free")
                    self.assertEqual((bool(said), int(points)), (side == 10000, 0 if side == 10000 else side**2))
                    self.assertLess(float(grown), 60 + 5.3e-6 * int(points))

    def test_no_display(self):
        name = self.path("picture.png")
        script = ("import sys; import numpy; from littoral.elevation import image_from_array\n"
                  "from littoral.gallery.pictures import save_blocks\n"
                  "save_blocks(sys.argv[1], [image_from_array(numpy.eye(9), (1.0, 1.0))])")
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
