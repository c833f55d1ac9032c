# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

include(LittoralCompatibility)

# --- Header-only libraries of Common. Of these only GLM appears in installed headers.
# Eigen from 3.3; no version is named, as 5.0 refuses to stand for 3.
find_package(Eigen3 REQUIRED CONFIG)
find_package(Boost 1.70 REQUIRED)
find_package(glm REQUIRED CONFIG)

# littoral_find_headers(<target> <header>): an imported target for a library that is used by
# its headers alone and has no package file of its own.
function (littoral_find_headers target header)
  string(MAKE_C_IDENTIFIER "${target}_INCLUDE_DIR" variable)
  find_path(${variable} "${header}" REQUIRED)
  mark_as_advanced(${variable})
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${${variable}}")
endfunction ()

littoral_find_headers(Random123::Random123 Random123/philox.h)
littoral_find_headers(kissfft::header kissfft/kissfft.hh)
littoral_find_headers(nanoflann::header nanoflann.hpp)
find_package(Threads REQUIRED)

# --- FFTW in single precision, on request: it is GPL, and so is what is linked with it.
if (LITTORAL_WITH_FFTW)
  find_library(FFTW3F_LIBRARY fftw3f REQUIRED)
  find_path(FFTW3F_INCLUDE_DIR fftw3.h REQUIRED)
  mark_as_advanced(FFTW3F_LIBRARY FFTW3F_INCLUDE_DIR)
  add_library(fftw3f::fftw3f UNKNOWN IMPORTED GLOBAL)
  set_target_properties(fftw3f::fftw3f PROPERTIES
    IMPORTED_LOCATION "${FFTW3F_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${FFTW3F_INCLUDE_DIR}")
endif ()

if (NOT LITTORAL_WITH_VTK)
  set(LITTORAL_WITH_TBB OFF)
  set(LITTORAL_WITH_OPENVDB OFF)
  set(LITTORAL_WITH_TINYGLTF OFF)
  set(LITTORAL_WITH_GDAL OFF)
  set(LITTORAL_WITH_NETCDF OFF)
  set(LITTORAL_WITH_PARAVIEW OFF)
  set(LITTORAL_WITH_PYTHON OFF)
  return ()
endif ()

# --- Python. Debian's VTK modules belong to Debian's interpreter, whatever comes first on PATH.
if (LITTORAL_WITH_PYTHON AND NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python interpreter")
endif ()

# --- TBB.
if (LITTORAL_WITH_TBB OR LITTORAL_WITH_OPENVDB)
  find_package(TBB QUIET CONFIG)
endif ()
if (LITTORAL_WITH_TBB AND NOT TARGET TBB::tbb)
  message(STATUS "TBB was not found: loops run on the threads of vtkSMPTools")
  set(LITTORAL_WITH_TBB OFF)
endif ()

# --- OpenVDB. Its own find module insists on what it was compiled with; a program wants less.
if (LITTORAL_WITH_OPENVDB)
  find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
  find_library(OpenVDB_LIBRARY openvdb)
  mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_LIBRARY)
  find_package(Imath QUIET CONFIG)
  if (OpenVDB_INCLUDE_DIR AND OpenVDB_LIBRARY AND TARGET TBB::tbb AND TARGET Imath::Imath)
    add_library(OpenVDB::openvdb UNKNOWN IMPORTED GLOBAL)
    set_target_properties(OpenVDB::openvdb PROPERTIES
      IMPORTED_LOCATION "${OpenVDB_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${OpenVDB_INCLUDE_DIR}"
      INTERFACE_LINK_LIBRARIES "TBB::tbb;Imath::Imath;Boost::headers;Threads::Threads")
  else ()
    message(STATUS "OpenVDB, or TBB or Imath that it needs, was not found: no vtkVDBVolumeWriter")
    set(LITTORAL_WITH_OPENVDB OFF)
  endif ()
endif ()

# --- tinygltf, as a library: its header alone would compile parsers of images and JSON into Littoral.
if (LITTORAL_WITH_TINYGLTF)
  find_package(TinyGLTF QUIET CONFIG)
  if (TARGET TinyGLTF::TinyGLTF AND NOT TARGET tinygltf::tinygltf)
    add_library(tinygltf::tinygltf INTERFACE IMPORTED GLOBAL) # Debian's name of the target
    target_link_libraries(tinygltf::tinygltf INTERFACE TinyGLTF::TinyGLTF)
  endif ()
  if (NOT TARGET tinygltf::tinygltf)
    message(STATUS "tinygltf was not found: no vtkGLTFSceneWriter")
    set(LITTORAL_WITH_TINYGLTF OFF)
  endif ()
endif ()

# --- GDAL.
if (LITTORAL_WITH_GDAL)
  find_package(GDAL 3.4 QUIET)
  if (NOT TARGET GDAL::GDAL)
    message(STATUS "GDAL 3.4 or newer (Debian: libgdal-dev) was not found: no vtkElevationReader, no vtkElevationWriter")
    set(LITTORAL_WITH_GDAL OFF)
  endif ()
endif ()

# --- netCDF, with GDAL for maps. Debian's package file of netCDF looks for an HDF5 that a program does not want.
if (LITTORAL_WITH_NETCDF)
  find_path(NETCDF_C_INCLUDE_DIR netcdf.h)
  find_library(NETCDF_C_LIBRARY netcdf)
  mark_as_advanced(NETCDF_C_INCLUDE_DIR NETCDF_C_LIBRARY)
  if (NETCDF_C_INCLUDE_DIR AND NETCDF_C_LIBRARY AND LITTORAL_WITH_GDAL)
    if (NOT TARGET Netcdf::Netcdf)
      add_library(Netcdf::Netcdf UNKNOWN IMPORTED GLOBAL)
      set_target_properties(Netcdf::Netcdf PROPERTIES
        IMPORTED_LOCATION "${NETCDF_C_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${NETCDF_C_INCLUDE_DIR}")
    endif ()
  else ()
    message(STATUS "netCDF (Debian: libnetcdf-dev), or GDAL that maps need, was not found: no vtkOceanCurrentReader, no files in netCDF")
    set(LITTORAL_WITH_NETCDF OFF)
  endif ()
endif ()

# --- VTK, through ParaView if it is there.
# Components are named so that only their dependencies are looked up. What the tests add is
# optional: VTK would otherwise insist on the development files of every image format.
set(littoral_vtk_components
  CommonCore CommonDataModel CommonExecutionModel RenderingCore RenderingOpenGL2)
set(littoral_vtk_test_components)
if (LITTORAL_WITH_OPENVDB OR LITTORAL_WITH_TINYGLTF OR LITTORAL_WITH_GDAL)
  list(APPEND littoral_vtk_components FiltersCore IOCore IOImage ParallelCore utf8)
endif ()
if (LITTORAL_WITH_PYTHON)
  list(APPEND littoral_vtk_components WrappingPythonCore)
endif ()
if (LITTORAL_BUILD_TESTING)
  set(littoral_vtk_test_components
    FiltersCore FiltersGeneral FiltersGeometry FiltersHybrid FiltersSources ImagingCore InteractionStyle IOXML
    TestingCore TestingRendering)
endif ()
list(REMOVE_ITEM littoral_vtk_test_components ${littoral_vtk_components})
set(littoral_find_vtk_arguments REQUIRED
  COMPONENTS ${littoral_vtk_components}
  OPTIONAL_COMPONENTS ${littoral_vtk_test_components})

if (LITTORAL_WITH_PARAVIEW)
  find_package(ParaView COMPONENTS RemotingCore RemotingServerManager RemotingViews)
  if (ParaView_FOUND)
    # No VTK but ParaView's may be mixed in: the one that it brings, or the system's that it was built against.
    if (EXISTS "${ParaView_DIR}/vtk")
      find_package(VTK ${littoral_find_vtk_arguments}
        PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
    else ()
      find_package(VTK ${littoral_find_vtk_arguments})
    endif ()
  elseif (ParaView_DIR)
    message(FATAL_ERROR
      "ParaView is in ${ParaView_DIR}, but something that its SDK needs is missing (see above). "
      "Install the packages in CMake/packages, or build without the plugin: "
      "-DLITTORAL_WITH_PARAVIEW=OFF.")
  else ()
    message(STATUS "ParaView was not found: building against plain VTK, without the plugin")
    set(LITTORAL_WITH_PARAVIEW OFF)
  endif ()
endif ()
if (NOT LITTORAL_WITH_PARAVIEW)
  find_package(VTK 9.1 ${littoral_find_vtk_arguments})
endif ()
message(STATUS "VTK ${VTK_VERSION} in ${VTK_DIR}")
if (LITTORAL_FOR_WHEEL)
  # What the wheel says that it needs is what it is built with.
  file(STRINGS "${PROJECT_SOURCE_DIR}/pyproject.toml" littoral_wish
    REGEX "\"vtk==${VTK_MAJOR_VERSION}\\.${VTK_MINOR_VERSION}\\.\\*\"")
  if (NOT littoral_wish)
    message(FATAL_ERROR "VTK ${VTK_VERSION} was found, and pyproject.toml asks for another one")
  endif ()
endif ()

# --- Help pages are for ParaView's window.
if (NOT LITTORAL_WITH_PARAVIEW OR NOT PARAVIEW_USE_QT)
  set(LITTORAL_BUILD_HELP OFF)
endif ()
