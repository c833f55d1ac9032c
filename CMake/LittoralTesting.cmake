# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# What VTK, ParaView and Python write where something is wrong. Tests that provoke an error observe it, which keeps it
# off the output.
set(LITTORAL_COMPLAINTS "ERR\\|;WARN\\|;ERROR:;Warning:;Traceback")

# After this time a test has failed [s]: it ends what hangs, and nothing that is slow on a machine that others load.
set(LITTORAL_TEST_TIMEOUT 1800)

# Adds a ctest entry, or one for each rank count, for a Python script.
#
#   littoral_add_script_test(<label> <script> <runner> [<argument>...])
#
# <runner> (python3, pvpython, pvbatch, or client for ParaView's window) and the arguments hold unless the script's first 1000 characters say
# otherwise in a comment line of its own, all parts of which are optional:
#
#   # run-with: pvbatch mpi=1,2,3 args=--quick args=--seed=7
#   # run-with: none
#
# Each script runs in a folder of its own, Testing/Output/<label>.<name> in the build tree.
# The rank counts of one script share that folder and run one after the other, so that a run
# can compare its result with what the run before it wrote.
# A script that exits with 125 counts as skipped.
function (littoral_add_script_test label script runner)
  set(ranks)
  set(arguments)
  set(default_arguments ${ARGN})
  file(READ "${script}" head LIMIT 1000)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${script}")
  if (head MATCHES "(^|\n)# run-with:([^\n]*)")
    separate_arguments(words UNIX_COMMAND "${CMAKE_MATCH_2}")
    foreach (word IN LISTS words)
      if (word MATCHES "^mpi=(.*)$")
        string(REPLACE "," ";" ranks "${CMAKE_MATCH_1}")
      elseif (word MATCHES "^args=(.*)$")
        list(APPEND arguments "${CMAKE_MATCH_1}")
      elseif (word MATCHES "^(none|python3|pvpython|pvbatch|client)$")
        set(runner "${word}")
      else ()
        message(FATAL_ERROR "${script}: the run-with line has an unknown word '${word}'")
      endif ()
    endforeach ()
  endif ()
  if (runner STREQUAL "none")
    return ()
  endif ()
  if (NOT arguments)
    set(arguments ${default_arguments})
  endif ()
  littoral_find_runner(program "${runner}")
  if (NOT program)
    return ()
  endif ()

  get_filename_component(name "${script}" NAME_WE)
  set(folder "${CMAKE_BINARY_DIR}/Testing/Output/${label}.${name}")
  file(MAKE_DIRECTORY "${folder}")

  set(before)
  foreach (rank IN LISTS ranks ITEMS "")
    if (ranks AND rank STREQUAL "")
      break () # the empty item is for scripts without rank counts
    endif ()
    set(test "${label}.${name}")
    set(launch)
    if (ranks)
      string(APPEND test ".mpi${rank}")
      set(launch mpirun -np "${rank}")
    endif ()
    if (runner STREQUAL "client")
      set(command "${program}" --dr
        "--script=${PROJECT_SOURCE_DIR}/Testing/ParaView/RunInClient.py")
    else ()
      set(command ${launch} "${program}" "${script}" ${arguments})
    endif ()
    add_test(NAME "${test}"
      COMMAND "${LITTORAL_ENV}" --display ${command}
      WORKING_DIRECTORY "${folder}")
    set_tests_properties("${test}" PROPERTIES
      LABELS "${label}"
      TIMEOUT ${LITTORAL_TEST_TIMEOUT}
      SKIP_RETURN_CODE 125
      FAIL_REGULAR_EXPRESSION "${LITTORAL_COMPLAINTS}"
      ENVIRONMENT "LITTORAL_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
    if (runner STREQUAL "client")
      set_property(TEST "${test}" APPEND PROPERTY ENVIRONMENT "LITTORAL_CLIENT_SCRIPT=${script}")
    endif ()
    if (before)
      set_tests_properties("${test}" PROPERTIES DEPENDS "${before}")
    endif ()
    if (ranks)
      set_tests_properties("${test}" PROPERTIES PROCESSORS "${rank}")
    endif ()
    set(before "${test}")
  endforeach ()
endfunction ()

# littoral_find_runner(<variable> <runner>): the program, empty if this build has none.
function (littoral_find_runner variable runner)
  set(program)
  if (runner STREQUAL "python3")
    if (LITTORAL_WITH_PYTHON)
      set(program "${Python3_EXECUTABLE}")
    endif ()
  elseif (LITTORAL_WITH_PARAVIEW)
    string(REPLACE "client" "paraview" name "${runner}")
    find_program(LITTORAL_${runner} "${name}" HINTS "${ParaView_PREFIX_PATH}/bin")
    mark_as_advanced(LITTORAL_${runner})
    if (LITTORAL_${runner})
      set(program "${LITTORAL_${runner}}")
    endif ()
  endif ()
  set(${variable} "${program}" PARENT_SCOPE)
endfunction ()
