# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the build into a fresh prefix, moves the prefix, and configures, builds and runs the
# C++ examples against it. Moving shows that nothing in the prefix names its first place.

function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "failed (${result}): ${ARGV}")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first")
file(RENAME "${WORK_DIR}/first" "${WORK_DIR}/moved")

run("${CMAKE_COMMAND}"
  -S "${SOURCE_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${WORK_DIR}/moved"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/GrowTerrain" "${WORK_DIR}/terrain.vti" 129 7)
run("${WORK_DIR}/build/GrowThroughData" "${SOURCE_DIR}/../Data/survey.csv" "${WORK_DIR}/field.asc" 7)

foreach (name IN ITEMS terrain.vti field.asc)
  file(SIZE "${WORK_DIR}/${name}" size)
  if (size LESS 10000)
    message(FATAL_ERROR "${name} has only ${size} bytes")
  endif ()
endforeach ()
