#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Rules that a search through the text can check. Run from the top folder: check.sh RULE [BUILD], a build tree.
# A rule prints the offending lines and fails if there are any.
set -eu # a check that finds something ends the script

fail_if_found() { # MESSAGE, with the offending lines on standard input
  local found
  found=$(cat)
  if [ -n "$found" ]; then
    printf '%s\n%s\n' "$1" "$found"
    exit 1
  fi
}

# Headers of Common that are installed, by their paths below it.
installed_headers() {
  (cd Common && printf '%s\n' */*.h) |
    grep -vxFf <(tr -s '\n ' ' ' <Common/CMakeLists.txt | grep -o 'set(private_headers [^)]*' | tr ' ' '\n')
}

# What sources of Common that a build tree compiles include first, before any other line of code.
first_includes() { # BUILD
  [ -f "$1/compile_commands.json" ] || return 0
  sed -n 's|^ *"file": "'"$PWD"'/\(Common/.*\.cxx\)",*$|\1|p' "$1/compile_commands.json" |
    xargs awk 'FNR == 1 { past = 0 } !past && NF > 0 && !/^\/\// { past = 1; if (/^#include "/) print }' |
    sed 's|^#include "\([^"]*\)".*|\1|'
}

folders=(CMake Common Support Sources Filters IO paraview-plugin Wrapping Examples Testing)

case "${1:-}" in
  common-without-vtk)
    grep -rnEi '#[[:space:]]*include[[:space:]]*[<"][^>"]*vtk' Common |
      fail_if_found "Common must not include VTK:"
    ;;
  common-headers-only-std)
    # <name> is the standard library, <name.h> or <folder/name> is not; GLM alone is allowed beside it.
    installed_headers | sed 's|^|Common/|' | xargs grep -nE '#[[:space:]]*include[[:space:]]*<[^>]*[./]' | grep -v '<glm/' |
      fail_if_found "Installed headers of Common must do with the standard library and GLM:"
    ;;
  common-headers-complete)
    # Each installed header compiles alone. One that a source of the build includes before all else has done so there.
    compiler=${CXX:-c++}
    command -v "$compiler" >/dev/null || { echo "there is no C++ compiler"; exit 1; }
    installed=$(installed_headers)
    { grep -vxFf <(first_includes "${2:-build}") <<<"$installed" || true; } | xargs -P "$(nproc)" -I{} sh -c '
      printf "#include \"%s\"\n" "{}" | "$1" -std=c++17 -fsyntax-only -ICommon -x c++ - >/dev/null 2>&1 || echo "{}"
      ' sh "$compiler" | fail_if_found "Installed headers of Common that do not compile alone:"
    ;;
  common-headers-installed)
    # Installed headers include no header that is not installed.
    installed=$(installed_headers)
    # shellcheck disable=SC2086 # one word a header
    (cd Common && grep -HE '^#include "' $installed) | sed 's|^\([^:]*\):#include "\([^"]*\)".*|\1 \2|' |
      awk 'NR == FNR { known[$1]; next } !($2 in known) { print $1 ": " $2 }' <(printf '%s\n' "$installed") - |
      fail_if_found "Installed headers of Common that include one that is not installed:"
    ;;
  rooms)
    # What the rooms of Common may include beside themselves, Numerics and Geometry.
    for room in Common/*/; do
      room=$(basename "$room")
      case "$room" in
        Numerics) lower= ;;
        Geometry) lower=Numerics ;;
        Terrain | Plants | Wind | Sea | Light) lower='Numerics|Geometry' ;;
        Kriging | Patterns) lower='Numerics|Geometry|Terrain' ;;
        Sway) lower='Numerics|Geometry|Plants|Wind' ;;
        Currents) lower='Numerics|Geometry' ;;
        Particles) lower='Numerics|Geometry|Sea' ;;
        Drainage) lower='Numerics|Geometry|Terrain' ;;
        Landscapes) lower='Numerics|Geometry|Terrain|Drainage' ;;
        Seaweed) lower='Numerics|Geometry|Plants|Sea|Currents' ;;
        *) echo "Common/$room: no room of this name is known here"; continue ;;
      esac
      grep -rnE '^#include "' "Common/$room" | grep -vE "#include \"($room${lower:+|$lower})/" |
        sed 's/$/   (not from a lower floor)/'
    done | fail_if_found "Rooms of Common include themselves, Numerics, Geometry and lower floors only:"
    # Numerics know no VTK, and nothing private of the VTK classes.
    find Common -maxdepth 1 -name '*.[hc]*' | fail_if_found "Files of Common that are in no room:"
    ;;
  names)
    # Two types of one name in a namespace break each other's templates, and no compiler need say so.
    grep -HE '^(struct|class|enum class) ' Common/*/*.h Support/*/*.h | grep -v ';$' |
      sed -E 's/^([^:]*):(struct|class|enum class) (alignas\([0-9]+\) )?([A-Za-z0-9_:]+).*/\4 \1/' | sort |
      awk '$1 == last { print place; print $0 } { last = $1; place = $0 }' |
      fail_if_found "Types of one name in several headers of Common and Support:"
    ;;
  comments)
    # A comment begins with the thing that it describes, as "Area of a cell [m^2]" and not "Of one cell": comments of
    # documentation, and those above declarations and functions, not the ones within functions.
    weak_beginnings='Of|By|From|To|In|On|At|With|Without|For|Between|Within|Those|These|That|This|What|Which|Whose'
    weak_beginnings+='|Where|When|How|Its|Their'
    find Common Support Sources Filters IO paraview-plugin -name '*.h' -o -name '*.cxx' | sort |
      xargs awk -v weak="$weak_beginnings" '
        FNR == 1 { inside = 0; opened = 0 }
        {
          indent = match($0, /[^ ]/) - 1
          line = substr($0, indent + 1)
          isDoc = line ~ /^\/\/\/( |$)|^\/\*\* /
          isPlain = line ~ /^\/\/( |$)/ && indent <= (FILENAME ~ /h$/ ? 2 : 0)
          text = line
          sub(/^(\/\/\/?|\/\*\*|\*) /, "", text)
          if ((opened || (isDoc || isPlain) && !inside) &&
            text ~ ("^(" weak ") ")) print FILENAME ":" FNR ": " line
          inside = isDoc || isPlain
          opened = line == "/**"
        }' |
      fail_if_found "Comments that do not begin with the thing that they describe:"
    grep -rnE "(\"\"\"|^ *#: )($weak_beginnings) " --include='*.py' Wrapping Examples Documentation paraview-plugin |
      fail_if_found "Docstrings that do not begin with the thing that they describe:"
    ;;
  stray-files)
    git ls-files 2>/dev/null | grep -E '\.(orig|rej|bak|swp|log|tmp|pvsm|vdb)$|~$|(^|/)\.DS_Store$|(^|/)core$' |
      fail_if_found "Files that do not belong into the tree:"
    find "${folders[@]}" Documentation packaging -name '*.orig' -o -name '*.rej' -o -name '*.bak' -o -name '*~' |
      fail_if_found "Files that do not belong into the tree:"
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
      grep -qE "^littoral \(${version//./\\.}\)" debian/changelog || echo debian/changelog
      [ "$(./littoral --version)" = "Littoral $version" ] || echo "./littoral --version"
    } | fail_if_found "Not the version $version of CMakeLists.txt:"
    ;;
  recipes)
    # Options that the recipes set are Littoral's, and the names of Spack's variants are declared.
    grep -noE 'LITTORAL_[A-Z_]+' packaging/conda/meta.yaml packaging/spack/package.py debian/rules pyproject.toml | while IFS=: read -r _ line option; do
      grep -qE "^(option| *set) ?\($option " CMakeLists.txt || echo "line $line: $option"
    done | fail_if_found "Options that CMakeLists.txt does not have:"
    sed -nE 's/.*define_from_variant\("[A-Z_]+", "([a-z]+)"\).*/\1/p; s/.*when="[+~]([a-z]+)( [+~]([a-z]+))?".*/\1\n\3/p' \
      packaging/spack/package.py | sort -u | while read -r variant; do
      [ -z "$variant" ] || grep -q "variant(\"$variant\"," packaging/spack/package.py || echo "$variant"
    done | fail_if_found "Variants that Spack's recipe does not declare:"
    # What the lists of Debian 13 and later build with, but for the compiler, which every build of Debian has.
    for release in 13 forky; do
      awk '/^\[/ { wanted = /^\[(run|build|help)\]$/ } wanted && /^[a-z0-9]/' CMake/packages/debian-$release.txt |
        grep -vxE 'g\+\+|libgl1-mesa-dri|python-matplotlib-data|qt6-svg-plugins|xauth|xvfb' | while read -r name; do
        grep -qE "^ .*\b${name//+/\\+}( |,|\$)" debian/control || echo "debian-$release: $name"
      done
    done | fail_if_found "Packages that debian/control does not ask for:"
    if command -v python3 >/dev/null; then
      python3 -c 'import ast; ast.parse(open("packaging/spack/package.py").read())' || exit 1
    fi
    ;;
  memory)
    # Whatever takes memory by what a file, an input or a property says asks first, by RequireMemory, which alone knows
    # what is free. Room for arrays is made by SetTuples, which asks.
    grep -rnE '\b(AvailableMemory|HostMemory|GetAvailablePhysicalMemory)\(' --include='*.cxx' --include='*.h' \
      Common Support Filters Sources IO paraview-plugin | grep -vE '^Support/Pipeline/Memory\.|CacheShare' |
      fail_if_found "Memory that is not asked for by RequireMemory:"
    grep -rnE '(->|\.)(SetNumberOfTuples|SetNumberOfValues|SetNumberOfPoints|AllocateScalars)\(' --include='*.cxx' \
      --include='*.h' Support Filters Sources IO | grep -v '^Support/Data/Arrays\.cxx' |
      fail_if_found "Arrays whose room is not made by SetTuples or NewArray:"
    # Copies and vectors as long as an input are made by WithType, ListOf and SetSize, which ask too.
    grep -rnE --include='*.cxx' --include='*.h' -e '->DeepCopy\(|>CopyAllocate\([^)]*, *[a-z]' -e \
      '(\.(resize|reserve|assign)|^ *std::vector<.*> [a-zA-Z]+)\(.*[>.]GetNumberOf(Tuples|Points|Values|Cells|Rows)\(\)' \
      Support Filters Sources IO | grep -v '^Support/Data/Arrays\.' |
      fail_if_found "Copies and vectors that are not made by WithType, ListOf and SetSize:"
    # Classes that put out no more than a table or a few primitives, and pass on what they get; a base class.
    small='vtkFlowPrimitiveSource|vtkSeaStateSource|vtkFlowArrowFilter|vtkPlantWakeFilter|vtkSeaStatisticsFilter'
    small="$small|vtkSingleFileWriter"
    # Functions that ask for the class that calls them.
    asks='RequireMemory|BytesOfFile|ReadHeights|WhyTooLarge|ReadSeaweeds|ReadWind|SwayBlocks'
    grep -lE '::(RequestData|WriteData)\(' Filters/*.cxx Sources/*.cxx IO/vtk*.cxx | grep -vE "($small)\.cxx" |
      xargs grep -LE "\b($asks)\b" | fail_if_found "Classes that do not ask for the memory that they take:"
    ;;
  readers)
    # Inputs, arrays and table columns come from Support/Data/Inputs.h and ArrayReader.h, which check them. Arrays by index
    # are an algorithm's own, or carried along.
    grep -rnE 'GetColumnByName|GetValueByName|GetVariantValue|GetTuple1\(|[>.]Get(Abstract)?Array\(([a-z]+::)*["A-Za-z]' \
      --include='*.cxx' --include='*.h' Support Filters Sources |
      grep -vE 'Support/Data/ArrayReader\.cxx|Get(Abstract)?Array\((i|index|k)\)' |
      fail_if_found "Arrays that come not from an ArrayReader:"
    grep -rnE 'vtk(ImageData|PointSet|PolyData|Table|MultiBlockDataSet)::GetData\(inputs?(Vector)?\b' Filters Sources |
      fail_if_found "Inputs that are not fetched by InputOf, PointSetsOf or BlocksOf:"
    # What fails throws InvalidInput; no reason is handed on.
    grep -rnE 'reason\.empty\(\) +\?|(^|[(,]) *std::string& (reason|why)\b' \
      --include='*.cxx' --include='*.h' Common Support Filters Sources IO |
      fail_if_found "Reasons that are handed on in place of InvalidInput:"
    ;;
  *)
    echo "usage: check.sh common-without-vtk|common-headers-only-std|common-headers-complete|common-headers-installed|rooms|names|comments|stray-files|headers-without-using|text-files|versions|recipes|memory|readers"
    exit 2
    ;;
esac
