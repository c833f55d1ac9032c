# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# The VTK modules, their Python wrapping and the ParaView plugin, in the order that VTK's and
# ParaView's build functions ask for.

set(littoral_want_tests OFF)
if (LITTORAL_BUILD_TESTING)
  set(littoral_want_tests WANT) # makes TEST_DEPENDS known to Testing/Cxx
endif ()

set(littoral_client_file)
set(littoral_client_module)
if (LITTORAL_WITH_PARAVIEW)
  set(littoral_client_file
    "${PROJECT_SOURCE_DIR}/paraview-plugin/ClientProxies/vtk.module"
    "${PROJECT_SOURCE_DIR}/paraview-plugin/Representations/vtk.module")
  set(littoral_client_module Littoral::LittoralClientProxies Littoral::LittoralRepresentations)
endif ()

set(littoral_io_file)
set(littoral_io_module)
if (LITTORAL_WITH_OPENVDB OR LITTORAL_WITH_TINYGLTF OR LITTORAL_WITH_GDAL)
  set(littoral_io_file "${PROJECT_SOURCE_DIR}/IO/vtk.module")
  set(littoral_io_module Littoral::LittoralIO)
endif ()

add_subdirectory(Support)

vtk_module_scan(
  MODULE_FILES
    "${PROJECT_SOURCE_DIR}/Sources/vtk.module"
    "${PROJECT_SOURCE_DIR}/Filters/vtk.module"
    "${PROJECT_SOURCE_DIR}/Rendering/vtk.module"
    ${littoral_io_file}
    ${littoral_client_file}
  REQUEST_MODULES
    Littoral::LittoralSources
    Littoral::LittoralFilters
    Littoral::LittoralRendering
    ${littoral_io_module}
    ${littoral_client_module}
  PROVIDES_MODULES littoral_modules
  ENABLE_TESTS ${littoral_want_tests})

vtk_module_build(
  MODULES ${littoral_modules}
  PACKAGE Littoral
  INSTALL_EXPORT Littoral
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  HEADERS_DESTINATION "${LITTORAL_HEADERS_DIR}"
  CMAKE_DESTINATION "${LITTORAL_CMAKE_DIR}"
  LICENSE_DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Littoral"
  TEST_DIRECTORY_NAME NONE)

if (LITTORAL_WITH_PYTHON)
  add_subdirectory(Wrapping/Python)
  foreach (module IN ITEMS Sources Filters Rendering IO)
    if (TARGET Littoral${module}Python)
      littoral_build_wrapping(Littoral${module}Python <vtkPythonArgs.h> <vtkPythonOverload.h> <sstream>)
    endif ()
  endforeach ()
endif ()

set(LITTORAL_PLUGIN_BUILD_DIR "")
if (LITTORAL_WITH_PARAVIEW)
  set(LITTORAL_PLUGIN_SUBDIR "${PARAVIEW_PLUGIN_SUBDIR}")
  set(LITTORAL_PLUGIN_BUILD_DIR
    "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${LITTORAL_PLUGIN_SUBDIR}/Littoral")

  paraview_plugin_scan(
    PLUGIN_FILES "${PROJECT_SOURCE_DIR}/paraview-plugin/paraview.plugin"
    PROVIDES_PLUGINS littoral_plugins
    ENABLE_BY_DEFAULT ON)
  set(littoral_autoload)
  if (LITTORAL_PLUGIN_AUTOLOAD)
    set(littoral_autoload ${littoral_plugins})
  endif ()
  paraview_plugin_build(
    PLUGINS ${littoral_plugins}
    AUTOLOAD ${littoral_autoload}
    LIBRARY_SUBDIRECTORY "${LITTORAL_PLUGIN_SUBDIR}"
    PLUGINS_COMPONENT runtime
    TARGET_COMPONENT runtime
    PLUGINS_FILE_NAME Littoral.plugins.xml)
  foreach (module IN ITEMS Sources Filters IO ClientProxies Representations)
    if (TARGET Littoral${module}CS)
      littoral_build_wrapping(Littoral${module}CS
        <vtkObject.h> <vtkClientServerInterpreter.h> <vtkClientServerStream.h>)
    endif ()
  endforeach ()
endif ()
