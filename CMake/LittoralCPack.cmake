# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Packages by CPack: three for Debian's kind (cpack -G DEB), and an archive that runs from any folder (cpack -G TGZ).
# `./littoral package` configures for them and makes both.
set(LITTORAL_MAINTAINER "Littoral contributors <littoral@users.noreply.github.com>" CACHE STRING
  "Maintainer, as packages name it")

# What Debian's policy asks of each package: copyright and changelog, and a page for a program.
function (littoral_debian_documents)
  set(folder "${CMAKE_BINARY_DIR}/packaging")
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${folder}/changelog"
    "littoral (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md in the sources.\n\n"
    " -- ${LITTORAL_MAINTAINER}  ${date}\n")
  file(COPY "${PROJECT_SOURCE_DIR}/packaging/debian/littoral-demo.1" DESTINATION "${folder}")
  find_program(LITTORAL_GZIP gzip REQUIRED)
  mark_as_advanced(LITTORAL_GZIP)
  execute_process(COMMAND "${LITTORAL_GZIP}" -9nf changelog littoral-demo.1
    WORKING_DIRECTORY "${folder}" COMMAND_ERROR_IS_FATAL ANY)
  foreach (pair licenses:littoral python:python3-littoral development:liblittoral-dev)
    string(REPLACE ":" ";" pair "${pair}")
    list(GET pair 0 component)
    list(GET pair 1 name)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
      DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}" RENAME copyright COMPONENT ${component})
    install(FILES "${folder}/changelog.gz"
      DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}" COMPONENT ${component})
  endforeach ()
  install(FILES "${folder}/littoral-demo.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT python)
endfunction ()

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
      littoral_configure_program("packaging/debian/${script}.in" "packaging/${script}")
      list(APPEND scripts "${CMAKE_BINARY_DIR}/packaging/${script}")
    endforeach ()
    set(LITTORAL_DEBIAN_SCRIPTS "${scripts}" PARENT_SCOPE)
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
set(CPACK_PACKAGE_CONTACT "${LITTORAL_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own, the first line of its description
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

# --- The three packages.
if (LITTORAL_FOR_DEBIAN)
  littoral_debian_documents()
  littoral_tell_paraview() # LITTORAL_DEBIAN_SCRIPTS
endif ()
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
# The Python modules' libraries are in another package, which dpkg-shlibdeps does not see.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Description of a group's package: its first line, and what it holds.
function (littoral_describe group summary content)
  set(CPACK_DEBIAN_${group}_DESCRIPTION "living landscapes and seas for ${summary}
Terrain grown from measured statistics, plant cover, wind that sways trees,
waves and currents that carry particles and bend seaweed, as sources and
filters.

This package holds ${content}." PARENT_SCOPE)
endfunction ()

set(CPACK_DEBIAN_LITTORAL_PACKAGE_NAME littoral)
littoral_describe(LITTORAL "ParaView" "the plugin and the libraries")
set(CPACK_DEBIAN_LITTORAL_PACKAGE_RECOMMENDS "python3-littoral")
set(CPACK_DEBIAN_LITTORAL_PACKAGE_CONTROL_EXTRA
  ${LITTORAL_DEBIAN_SCRIPTS} "${PROJECT_SOURCE_DIR}/packaging/debian/triggers")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-littoral)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
littoral_describe(PYTHON "VTK - Python package" "the Python package and the command littoral-demo")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblittoral-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
littoral_describe(DEVELOPMENT "VTK - development files" "the headers and the CMake files")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "littoral (= ${PROJECT_VERSION}), python3, python3-numpy, python-matplotlib-data")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst" "${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm")
# A system without a display draws on a virtual one.
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "xvfb, xauth")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "littoral (= ${PROJECT_VERSION}), libglm-dev")
if (LITTORAL_WITH_PARAVIEW)
  set(CPACK_DEBIAN_LITTORAL_PACKAGE_DEPENDS "paraview")
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS ", python3-paraview")
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", paraview-dev")
endif ()
if (VTK_DIR MATCHES "paraview")
  # What CMake files of ParaView's own VTK ask for where a program draws, without a dependency of their package
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libglew-dev, libx11-dev")
else ()
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libvtk9-dev")
endif ()

include(CPack)
