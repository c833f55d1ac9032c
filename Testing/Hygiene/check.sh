#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Rules that a search through the text can check. Run from the top folder: check.sh RULE
# A rule prints the offending lines and fails if there are any.
set -u

fail_if_found() { # MESSAGE, with the offending lines on standard input
  local found
  found=$(cat)
  if [ -n "$found" ]; then
    printf '%s\n%s\n' "$1" "$found"
    exit 1
  fi
}

folders=(CMake Common Support Sources Filters IO paraview-plugin Wrapping Examples Testing)

case "${1:-}" in
  common-without-vtk)
    grep -rnEi '#[[:space:]]*include[[:space:]]*[<"][^>"]*vtk' Common |
      fail_if_found "Common must not include VTK:"
    ;;
  common-headers-only-std)
    # <name> is the standard library, <name.h> or <folder/name> is not; GLM alone is allowed beside it.
    grep -nE '#[[:space:]]*include[[:space:]]*<[^>]*[./]' Common/*.h | grep -v '<glm/' |
      fail_if_found "Installed headers of Common must do with the standard library and GLM:"
    ;;
  headers-without-using)
    grep -rnE '^[[:space:]]*using[[:space:]]+namespace' --include='*.h' "${folders[@]}" |
      fail_if_found "A header must not open a namespace for those who include it:"
    ;;
  text-files)
    grep -rnIE $'\r$|[ \t]+$|^\t' --include='*.h' --include='*.cxx' --include='*.py' \
      --include='*.cmake' --include='CMakeLists.txt' --include='*.xml' "${folders[@]}" |
      fail_if_found "Carriage returns, tabs or spaces at a line's end:"
    ;;
  *)
    echo "usage: check.sh common-without-vtk|common-headers-only-std|headers-without-using|text-files"
    exit 2
    ;;
esac
