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
  versions)
    version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
    [ -n "$version" ] || { echo "CMakeLists.txt names no version"; exit 1; }
    {
      grep -qxF "version: $version" CITATION.cff || echo CITATION.cff
      grep -qE "^## ${version//./\\.}(,|$)" CHANGELOG.md || echo CHANGELOG.md
      grep -qxF "{% set version = \"$version\" %}" packaging/conda/meta.yaml || echo packaging/conda/meta.yaml
      [ "$(./littoral --version)" = "Littoral $version" ] || echo "./littoral --version"
    } | fail_if_found "Not the version $version of CMakeLists.txt:"
    ;;
  recipes)
    # Options that the recipes set are Littoral's, and the names of Spack's variants are declared.
    grep -noE 'LITTORAL_[A-Z_]+' packaging/conda/meta.yaml packaging/spack/package.py | while IFS=: read -r _ line option; do
      grep -qE "^(option| *set) ?\($option " CMakeLists.txt || echo "line $line: $option"
    done | fail_if_found "Options that CMakeLists.txt does not have:"
    sed -nE 's/.*define_from_variant\("[A-Z_]+", "([a-z]+)"\).*/\1/p; s/.*when="[+~]([a-z]+)( [+~]([a-z]+))?".*/\1\n\3/p' \
      packaging/spack/package.py | sort -u | while read -r variant; do
      [ -z "$variant" ] || grep -q "variant(\"$variant\"," packaging/spack/package.py || echo "$variant"
    done | fail_if_found "Variants that Spack's recipe does not declare:"
    if command -v python3 >/dev/null; then
      python3 -c 'import ast; ast.parse(open("packaging/spack/package.py").read())' || exit 1
    fi
    ;;
  *)
    echo "usage: check.sh common-without-vtk|common-headers-only-std|headers-without-using|text-files|versions|recipes"
    exit 2
    ;;
esac
