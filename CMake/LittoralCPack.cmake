# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# An archive that runs from any folder, by CPack (cpack -G TGZ), and what Debian packages (debian/rules) have beside the
# modules. `./littoral package` makes both.

# ParaView's list of plugins. Debian's from 5.13 on reads a file of others, which is free for one package; 5.11 reads what
# is beside its programs, where scripts add a line.
function (littoral_tell_paraview)
  if (NOT LITTORAL_WITH_PARAVIEW)
    return ()
  endif ()
  get_filename_component(folder "${LITTORAL_PLUGIN_SUBDIR}" DIRECTORY)
  set(list "/usr/${CMAKE_INSTALL_LIBDIR}/${folder}/paraview.conf")
  if (EXISTS "${list}")
    file(STRINGS "${list}" slot REGEX "^/usr/share/paraview/plugins$")
  endif ()
  if (slot)
    install(FILES "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${LITTORAL_PLUGIN_SUBDIR}/Littoral.plugins.xml"
      DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/paraview" RENAME plugins COMPONENT runtime)
  else ()
    foreach (script postinst prerm)
      littoral_configure_program("packaging/paraview-list-${script}.in" "packaging/${script}")
    endforeach ()
  endif ()
endfunction ()

function (littoral_configure_program from to)
  configure_file("${PROJECT_SOURCE_DIR}/${from}" "${CMAKE_BINARY_DIR}/${to}" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endfunction ()

# --- What is in no module: the program that shows something at once.
set(LITTORAL_PLUGIN_FOLDER "${CMAKE_INSTALL_LIBDIR}/${LITTORAL_PLUGIN_SUBDIR}/Littoral")
if (LITTORAL_WITH_PARAVIEW AND LITTORAL_WITH_PYTHON)
  littoral_configure_program(packaging/littoral-demo.in packaging/littoral-demo)
  install(PROGRAMS "${CMAKE_BINARY_DIR}/packaging/littoral-demo"
    DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT python)
  install(FILES "${PROJECT_SOURCE_DIR}/Examples/ParaView/scene.py"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/littoral" COMPONENT python)
endif ()

set(CPACK_PACKAGE_NAME littoral)
set(CPACK_PACKAGE_VENDOR "Littoral contributors")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

# --- The archive: one folder, with the note on how to install it.
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
if (LITTORAL_WITH_PARAVIEW)
  set(LITTORAL_PARAVIEW "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  set(CPACK_PACKAGE_FILE_NAME "littoral-${PROJECT_VERSION}-paraview-${LITTORAL_PARAVIEW}-${CMAKE_SYSTEM_PROCESSOR}")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/INSTALL.txt.in" "${CMAKE_BINARY_DIR}/packaging/archive/INSTALL.txt" @ONLY)
else ()
  set(CPACK_PACKAGE_FILE_NAME "littoral-${PROJECT_VERSION}-vtk-${VTK_VERSION}-${CMAKE_SYSTEM_PROCESSOR}")
endif ()

if (LITTORAL_WITH_PARAVIEW AND NOT LITTORAL_FOR_DEBIAN)
  set(CPACK_INSTALLED_DIRECTORIES "${CMAKE_BINARY_DIR}/packaging/archive;.")
endif ()

if (LITTORAL_FOR_DEBIAN)
  littoral_tell_paraview()
endif ()

include(CPack)
