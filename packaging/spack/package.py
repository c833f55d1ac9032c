# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A recipe for Spack. Untried: no Spack was at hand. It builds a tree of yours: `spack dev-build littoral@main`.

Spack's index had no kissfft when this was written. It is headers alone: a recipe of your own, or -Dkissfft__header_INCLUDE_DIR.
"""

from spack.package import *


class Littoral(CMakePackage):
    """Living landscapes and seas for VTK and ParaView."""

    license("BSD-3-Clause")
    version("main")

    variant("paraview", default=True, description="Build the ParaView plugin, against ParaView's VTK")
    variant("openvdb", default=True, description="Build the writer of OpenVDB volumes")
    variant("tinygltf", default=True, description="Build the writer of glTF scenes")
    variant("gdal", default=True, description="Build the reader and the writer of rasters of heights")
    variant("netcdf", default=True, description="Build the reader of ocean models' currents")
    variant("python", default=True, description="Build the Python package")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.21:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.3:")
    depends_on("boost@1.70:")
    depends_on("glm")
    depends_on("kissfft")
    depends_on("nanoflann")
    depends_on("random123")
    depends_on("paraview@5.11: +python +development_files", when="+paraview +python")
    depends_on("paraview@5.11: +development_files", when="+paraview")
    depends_on("vtk@9.1: +python", when="~paraview +python")
    depends_on("vtk@9.1:", when="~paraview")
    depends_on("tbb")
    depends_on("openvdb", when="+openvdb")
    depends_on("tinygltf", when="+tinygltf")
    depends_on("gdal@3.4:", when="+gdal")
    depends_on("netcdf-c", when="+netcdf")
    extends("python", when="+python")
    depends_on("py-numpy", type="run", when="+python")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("LITTORAL_WITH_PARAVIEW", "paraview"),
            self.define_from_variant("LITTORAL_WITH_OPENVDB", "openvdb"),
            self.define_from_variant("LITTORAL_WITH_TINYGLTF", "tinygltf"),
            self.define_from_variant("LITTORAL_WITH_GDAL", "gdal"),
            self.define_from_variant("LITTORAL_WITH_NETCDF", "netcdf"),
            self.define_from_variant("LITTORAL_WITH_PYTHON", "python"),
            self.define("LITTORAL_BUILD_TESTING", self.run_tests),
            self.define("LITTORAL_BUILD_BENCHMARKS", False),
        ]
