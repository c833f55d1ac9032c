# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Compiler options of hand-written code; generated wrapping code stays without them.
# Contraction into fused multiply-adds is off: the same source must give the same bytes on
# every machine and at every vector width.
function (littoral_compile_options target)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # Clang counts changes of sign to conversions, GCC does not; here neither does.
    target_compile_options("${target}" PRIVATE -Wall -Wextra -Wconversion -Wno-sign-conversion -Wshadow -ffp-contract=off)
    if (LITTORAL_WARNINGS_AS_ERRORS)
      target_compile_options("${target}" PRIVATE -Werror)
    endif ()
  endif ()
endfunction ()

# For code that is not hot, such as tests and generated wrapping: -O1 compiles it in two thirds of the time.
function (littoral_optimize_little)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    foreach (target IN LISTS ARGN)
      target_compile_options("${target}" PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
    endforeach ()
  endif ()
endfunction ()

# littoral_build_wrapping(<target> <header>...): generated wrapping of classes, several to a piece; their headers are
# compiled once for all where there is more than one piece.
function (littoral_build_wrapping target)
  set_target_properties("${target}" PROPERTIES UNITY_BUILD ON)
  littoral_optimize_little("${target}")
  get_target_property(sources "${target}" SOURCES)
  list(LENGTH sources count)
  if (count GREATER 8)
    target_precompile_headers("${target}" PRIVATE ${ARGN})
  endif ()
endfunction ()

# Headers that most sources of a target include are compiled once for all: half of the time of a class of VTK goes into
# reading them. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows what a source forgets to include.
set(LITTORAL_STANDARD_HEADERS <algorithm> <array> <cmath> <functional> <limits> <string> <vector>)
set(LITTORAL_VTK_HEADERS ${LITTORAL_STANDARD_HEADERS}
  <vtkCellArray.h> <vtkDoubleArray.h> <vtkFieldData.h> <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h>
  <vtkInformationVector.h> <vtkIntArray.h> <vtkMultiBlockDataSet.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h>
  <vtkPoints.h> <vtkPolyData.h> <vtkSmartPointer.h> <vtkStreamingDemandDrivenPipeline.h> <vtkStringArray.h> <vtkTable.h>
  <vtkUnsignedCharArray.h>)

# The functions of OpenGL, as VTK finds them: before VTK 9.4 and since then.
function (littoral_link_opengl module)
  foreach (functions IN ITEMS VTK::glew VTK::glad)
    if (TARGET ${functions})
      vtk_module_link(${module} PRIVATE ${functions})
    endif ()
  endforeach ()
endfunction ()

# Installs the export set when there is no VTK module build that would do it.
function (littoral_install_export)
  install(EXPORT Littoral
    NAMESPACE Littoral::
    FILE Littoral-targets.cmake
    DESTINATION "${LITTORAL_CMAKE_DIR}"
    COMPONENT development)
  export(EXPORT Littoral
    NAMESPACE Littoral::
    FILE "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/Littoral-targets.cmake")
endfunction ()

# Writes `littoral-env`, the script that runs a command with this build tree's libraries,
# Python package and plugin. The tests and the entry script use it.
function (littoral_configure_environment)
  set(LITTORAL_ENV_PYTHON "${CMAKE_BINARY_DIR}/${LITTORAL_PYTHON_DIR}")
  set(LITTORAL_ENV_LIBRARY "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
  set(LITTORAL_ENV_PLUGIN "${LITTORAL_PLUGIN_BUILD_DIR}")
  configure_file("${PROJECT_SOURCE_DIR}/CMake/littoral-env.in"
    "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/littoral-env" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
      WORLD_READ WORLD_EXECUTE)
  set(LITTORAL_ENV "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/littoral-env" PARENT_SCOPE)
endfunction ()
