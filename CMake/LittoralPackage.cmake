# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# The package files that find_package(Littoral) reads, in the build and the install tree.
include(CMakePackageConfigHelpers)

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/CMake/LittoralConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/LittoralConfig.cmake"
  INSTALL_DESTINATION "${LITTORAL_CMAKE_DIR}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/LittoralConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
configure_file("${PROJECT_SOURCE_DIR}/CMake/LittoralCompatibility.cmake"
  "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/LittoralCompatibility.cmake" COPYONLY)
install(
  FILES
    "${PROJECT_SOURCE_DIR}/CMake/LittoralCompatibility.cmake"
    "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/LittoralConfig.cmake"
    "${CMAKE_BINARY_DIR}/${LITTORAL_CMAKE_DIR}/LittoralConfigVersion.cmake"
  DESTINATION "${LITTORAL_CMAKE_DIR}"
  COMPONENT development)
install(
  FILES "${PROJECT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Littoral"
  COMPONENT licenses)
