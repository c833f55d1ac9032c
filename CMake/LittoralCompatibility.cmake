# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What single versions of VTK and ParaView need; drop each part with its version. Also read by LittoralConfig.cmake.

# Debian's VTK 9.3 and 9.6 and ParaView 5.13 and 6.1: their lists of Python modules name files without the suffix of the
# interpreter (vtkCommonCore.so), which do not exist, and find_package stops at the first. Nothing here links with
# them. CMake from 3.28 does not look for the file of a module for which this variable names a folder.
file(GLOB littoral_lists
  "${VTK_DIR}/*Python*-targets.cmake"
  "${ParaView_DIR}/*Python*-targets.cmake"
  "${ParaView_DIR}/vtk/*Python*-targets.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/vtk-*/*Python*-targets.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/*Python*-targets.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk/*Python*-targets.cmake")
foreach (littoral_list IN LISTS littoral_lists)
  file(STRINGS "${littoral_list}" littoral_lines REGEX "^add_library\\([^ ]+ MODULE IMPORTED\\)")
  foreach (littoral_line IN LISTS littoral_lines)
    string(REGEX REPLACE "^add_library\\(([^ ]+) .*" "\\1" littoral_target "${littoral_line}")
    set("_cmake_import_check_xcframework_for_${littoral_target}" "${CMAKE_CURRENT_LIST_DIR}")
  endforeach ()
endforeach ()
unset(littoral_lists)
unset(littoral_lines)
unset(littoral_target)

# VTK 9.6 with CMake from 3.31: its functions that build modules pass empty keywords and set no policy for them.
if (PROJECT_NAME STREQUAL "Littoral")
  set(CMAKE_POLICY_DEFAULT_CMP0174 NEW)
endif ()
