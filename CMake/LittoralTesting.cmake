# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# What VTK, ParaView and Python write where something is wrong. Tests that provoke an error observe it, which keeps it
# off the output.
set(LITTORAL_COMPLAINTS "ERR\\|;WARN\\|;ERROR:;Warning:;Traceback")

# After this time a test has failed [s]: it ends what hangs, and nothing that is slow on a machine that others load.
set(LITTORAL_TEST_TIMEOUT 1800)

# Each test has one tier, a label beside its field's:
#   quick     at most 1 s of processor time; runs in each tier
#   standard  at most 10 s; runs in standard and all
#   all       what repeats or soaks
# Testing/Tiers/check.py holds the tests to that by ctest's record, into which `measured` writes the processor time.
set(LITTORAL_MEASURED "${PROJECT_SOURCE_DIR}/Testing/Tiers/measured")

# littoral_add_test(<name> <label> <tier> <command> [<argument>...])
function (littoral_add_test name label tier)
  add_test(NAME "${name}" COMMAND "${LITTORAL_MEASURED}" ${ARGN})
  set_tests_properties("${name}" PROPERTIES LABELS "${label};${tier}" TIMEOUT ${LITTORAL_TEST_TIMEOUT})
endfunction ()

# Adds ctest entries for a Python script.
#
#   littoral_add_script_test(<label> <script> <runner> [<argument>...])
#
# <runner> (python3, pvpython, pvbatch, or client for ParaView's window) and the arguments hold unless the script's first
# 1000 characters say otherwise in a comment line of its own, all parts of which are optional:
#
#   # run-with: pvbatch mpi=1,2,3 tier=all args=--size=9 args=--seed=7
#   # run-with: none
#
# Those with together=GROUP share a process in the entry <label>.GROUP (littoral_add_groups); their own entries are of the
# tier all. The tier of others is standard unless it is named. Each further such line is an entry of its own, named after
# its tier, <label>.<name>.all, or by a word name=WORD. Each entry runs in a folder of its own, Testing/Output/<entry> in
# the build tree. Rank counts are entries that share that folder and run one after the other, so that a run can compare its
# result with what the run before it wrote. A script that exits with 125 counts as skipped.
function (littoral_add_script_test label script runner)
  file(READ "${script}" head LIMIT 1000)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${script}")
  string(REGEX MATCHALL "\n# run-with:[^\n]*" lines "\n${head}")
  if (NOT lines)
    set(lines "\n# run-with:")
  endif ()
  get_filename_component(name "${script}" NAME_WE)
  set(names)
  foreach (line IN LISTS lines)
    string(REGEX REPLACE "^.# run-with:" "" line "${line}")
    littoral_add_script_entry("${label}.${name}" "${label}" "${script}" "${runner}" "${line}" "${names}" ${ARGN})
    list(APPEND names "${label}.${name}")
  endforeach ()
endfunction ()

# littoral_add_script_entry(<entry> <label> <script> <runner> <words of a run-with line> <entries before> [<argument>...])
function (littoral_add_script_entry entry label script runner line others)
  set(ranks)
  set(tier standard)
  set(suffix)
  set(arguments)
  set(group)
  separate_arguments(words UNIX_COMMAND "${line}")
  foreach (word IN LISTS words)
    if (word MATCHES "^mpi=(.*)$")
      string(REPLACE "," ";" ranks "${CMAKE_MATCH_1}")
    elseif (word MATCHES "^args=(.*)$")
      list(APPEND arguments "${CMAKE_MATCH_1}")
    elseif (word MATCHES "^tier=(quick|standard|all)$")
      set(tier "${CMAKE_MATCH_1}")
    elseif (word MATCHES "^name=(.*)$")
      set(suffix "${CMAKE_MATCH_1}")
    elseif (word MATCHES "^together=(.*)$")
      set(group "${CMAKE_MATCH_1}")
    elseif (word MATCHES "^(none|python3|pvpython|pvbatch|client)$")
      set(runner "${word}")
    else ()
      message(FATAL_ERROR "${script}: the run-with line has an unknown word '${word}'")
    endif ()
  endforeach ()
  if (runner STREQUAL "none")
    return ()
  endif ()
  if (group)
    set_property(DIRECTORY APPEND PROPERTY LITTORAL_GROUPS "${group}")
    set_property(DIRECTORY APPEND PROPERTY "LITTORAL_GROUP_${group}" "${script}")
    set(tier all)
  endif ()
  if ("${arguments}" STREQUAL "")
    set(arguments ${ARGN})
  endif ()
  littoral_find_runner(program "${runner}")
  if (NOT program)
    return ()
  endif ()

  if (suffix)
    string(APPEND entry ".${suffix}")
  elseif (others)
    string(APPEND entry ".${tier}")
  endif ()
  set(folder "${CMAKE_BINARY_DIR}/Testing/Output/${entry}")
  file(MAKE_DIRECTORY "${folder}")
  if (runner STREQUAL "client")
    set(command "${program}" --dr "--script=${PROJECT_SOURCE_DIR}/Testing/ParaView/RunInClient.py")
  else ()
    set(command "${program}" "${script}" ${arguments})
  endif ()
  if (NOT ranks)
    littoral_add_script_run("${entry}" "${label}" "${tier}" "${folder}" "${script}" ${command})
  endif ()
  set(before)
  foreach (rank IN LISTS ranks)
    set(test "${entry}.mpi${rank}")
    littoral_add_script_run("${test}" "${label}" "${tier}" "${folder}" "${script}" mpirun -np "${rank}" ${command})
    set_tests_properties("${test}" PROPERTIES PROCESSORS "${rank}" DEPENDS "${before}")
    set(before "${test}")
  endforeach ()
endfunction ()

# littoral_add_groups(<label> <runner>): an entry for each group of the scripts that this directory adds. They begin first,
# being the longest.
function (littoral_add_groups label runner)
  littoral_find_runner(program "${runner}")
  get_property(groups DIRECTORY PROPERTY LITTORAL_GROUPS)
  list(REMOVE_DUPLICATES groups)
  foreach (group IN LISTS groups)
    if (NOT program)
      return ()
    endif ()
    get_property(scripts DIRECTORY PROPERTY "LITTORAL_GROUP_${group}")
    list(TRANSFORM scripts REPLACE "[.]py$" "" OUTPUT_VARIABLE names)
    set(folder "${CMAKE_BINARY_DIR}/Testing/Output/${label}.${group}")
    file(MAKE_DIRECTORY "${folder}")
    littoral_add_script_run("${label}.${group}" "${label}" standard "${folder}" "${scripts}"
      "${program}" "${PROJECT_SOURCE_DIR}/Testing/ParaView/together.py" ${names})
    set_tests_properties("${label}.${group}" PROPERTIES COST 100)
  endforeach ()
endfunction ()

# littoral_add_script_run(<test> <label> <tier> <folder> <script> <command> [<argument>...])
function (littoral_add_script_run test label tier folder script)
  littoral_add_test("${test}" "${label}" "${tier}" "${LITTORAL_ENV}" --display ${ARGN})
  set_tests_properties("${test}" PROPERTIES
    WORKING_DIRECTORY "${folder}"
    SKIP_RETURN_CODE 125
    FAIL_REGULAR_EXPRESSION "${LITTORAL_COMPLAINTS}"
    ENVIRONMENT "LITTORAL_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
  if (ARGN MATCHES "--script=")
    set_property(TEST "${test}" APPEND PROPERTY ENVIRONMENT "LITTORAL_CLIENT_SCRIPT=${script}")
  endif ()
  # What measures the memory of its process gives back what it frees (run_ctest of ./littoral).
  foreach (one IN LISTS script)
    file(STRINGS "${one}" measured REGEX "RLIMIT_AS|ru_maxrss|VmHWM" LIMIT_COUNT 1)
    if (measured)
      set_tests_properties("${test}" PROPERTIES ENVIRONMENT_MODIFICATION
        "MALLOC_TOP_PAD_=unset:;MALLOC_TRIM_THRESHOLD_=unset:;MALLOC_MMAP_THRESHOLD_=unset:")
    endif ()
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
