# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Packages by CPack: three for Debian's kind (cpack -G DEB), and an archive that runs from any folder (cpack -G TGZ).
# `./littoral package` configures for them and makes both.
set(LITTORAL_MAINTAINER "Littoral contributors <littoral@users.noreply.github.com>" CACHE STRING
  "Maintainer, as packages name it")

# Copyright and changelog of each Debian package, which Debian's policy asks for.
function (littoral_debian_documents)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${CMAKE_BINARY_DIR}/packaging/changelog"
    "littoral (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md in the sources.\n\n"
    " -- ${LITTORAL_MAINTAINER}  ${date}\n")
  find_program(LITTORAL_GZIP gzip REQUIRED)
  mark_as_advanced(LITTORAL_GZIP)
  execute_process(COMMAND "${LITTORAL_GZIP}" -9nf "${CMAKE_BINARY_DIR}/packaging/changelog" COMMAND_ERROR_IS_FATAL ANY)
  foreach (pair licenses:littoral python:python3-littoral development:liblittoral-dev)
    string(REPLACE ":" ";" pair "${pair}")
    list(GET pair 0 component)
    list(GET pair 1 name)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
      DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}" RENAME copyright COMPONENT ${component})
    install(FILES "${CMAKE_BINARY_DIR}/packaging/changelog.gz"
      DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}" COMPONENT ${component})
  endforeach ()
  foreach (script postinst prerm)
    configure_file("${PROJECT_SOURCE_DIR}/packaging/debian/${script}.in"
      "${CMAKE_BINARY_DIR}/packaging/${script}" @ONLY
      FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endforeach ()
endfunction ()

# --- What is in no module: the program that shows something at once, and the note of the archive.
set(LITTORAL_PLUGIN_PARENT "${LITTORAL_PLUGIN_SUBDIR}")
if (LITTORAL_WITH_PARAVIEW AND LITTORAL_WITH_PYTHON)
  install(PROGRAMS "${PROJECT_SOURCE_DIR}/packaging/littoral-demo"
    DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT python)
  install(FILES "${PROJECT_SOURCE_DIR}/Examples/ParaView/scene.py"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/littoral" COMPONENT python)
endif ()
if (LITTORAL_FOR_DEBIAN)
  littoral_debian_documents()
else ()
  install(FILES "${PROJECT_SOURCE_DIR}/packaging/INSTALL.txt" DESTINATION . COMPONENT programs)
endif ()

set(CPACK_PACKAGE_NAME littoral)
set(CPACK_PACKAGE_VENDOR "Littoral contributors")
set(CPACK_PACKAGE_CONTACT "${LITTORAL_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "living landscapes and seas for VTK and ParaView")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

# --- The archive: one folder, with the note on how to install it.
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
if (LITTORAL_WITH_PARAVIEW)
  set(CPACK_PACKAGE_FILE_NAME
    "littoral-${PROJECT_VERSION}-paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}-${CMAKE_SYSTEM_PROCESSOR}")
else ()
  set(CPACK_PACKAGE_FILE_NAME "littoral-${PROJECT_VERSION}-vtk-${VTK_VERSION}-${CMAKE_SYSTEM_PROCESSOR}")
endif ()

# --- The three packages.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime licenses programs python development)
foreach (component runtime licenses programs)
  string(TOUPPER ${component} name)
  set(CPACK_COMPONENT_${name}_GROUP littoral)
endforeach ()
set(CPACK_COMPONENT_PYTHON_GROUP python)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(text " Terrain grown from measured statistics, plant cover, wind that sways trees,
 waves and currents that carry particles and bend seaweed, as sources and
 filters.")

set(CPACK_DEBIAN_LITTORAL_PACKAGE_NAME littoral)
set(CPACK_DEBIAN_LITTORAL_DESCRIPTION "living landscapes and seas for ParaView\n${text}\n .\n This package holds the plugin and the libraries.")
set(CPACK_DEBIAN_LITTORAL_PACKAGE_RECOMMENDS "python3-littoral")
set(CPACK_DEBIAN_LITTORAL_PACKAGE_CONTROL_EXTRA
  "${CMAKE_BINARY_DIR}/packaging/postinst" "${CMAKE_BINARY_DIR}/packaging/prerm"
  "${PROJECT_SOURCE_DIR}/packaging/debian/triggers")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-littoral)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "living landscapes and seas for VTK - Python package\n${text}\n .\n This package holds the Python package and the command littoral-demo.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblittoral-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "living landscapes and seas for VTK - development files\n${text}\n .\n This package holds the headers and the CMake files.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "littoral (= ${PROJECT_VERSION}), python3, python3-numpy, python-matplotlib-data")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "littoral (= ${PROJECT_VERSION}), libglm-dev")
if (LITTORAL_WITH_PARAVIEW)
  set(CPACK_DEBIAN_LITTORAL_PACKAGE_DEPENDS "paraview")
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS ", python3-paraview")
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", paraview-dev")
endif ()

include(CPack)
