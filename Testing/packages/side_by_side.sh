#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Two versions of Littoral that were installed below two prefixes, the older first, do not disturb each other:
#   side_by_side.sh PREFIX_A PREFIX_B FOLDER
# Also with B installed over a copy of A in one prefix, as below /usr/local, where programs built with A must run on.
set -euo pipefail
a=$(readlink -f "$1") b=$(readlink -f "$2")
here=$(dirname "$(readlink -f "$0")")
mkdir -p "$3"
cd "$3"
version() { sed -n 's/__version__ = "\(.*\)"/\1/p' "$(find "$1" -name _version.py)"; }
python_of() { dirname "$(dirname "$(find "$1" -name _version.py)")"; }
plugin_of() { dirname "$(find "$1" -name Littoral.so)"; }
expect() { # WHAT TEXT: a line of the text
  grep -qxF -- "$1" <<<"$2" || { printf 'expected: %s\nfound: %s\n' "$1" "$2"; exit 1; }
}
[ "$(version "$a")" != "$(version "$b")" ]

echo "--- programs: A's runs on where B is found first, and where B was installed over A"
rm -rf both build-*
cp -r "$a" both
for prefix in "$a" "$b" "$PWD/both"; do
  name=build-$(basename "$prefix")
  cmake -G Ninja -S "$here/../../Examples/Cxx" -B "$name" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
  cmake --build "$name" >/dev/null
done
cp -rf "$b"/. both/
for name in "$(basename "$a")" "$(basename "$b")" both; do
  LD_LIBRARY_PATH=$b/lib:$a/lib "./build-$name/GrowTerrain" "$name.vti" >/dev/null
  cmp "$name.vti" "$(basename "$a").vti"
  ldd "build-$name/GrowTerrain" | grep -o 'libLittoral[A-Za-z]*\.so\.[0-9.]* => .*\.so\.[0-9.]*'
done
ldd build-both/GrowTerrain | grep -q "libLittoralSources.so.$(version "$a" | cut -d. -f1-2) => $PWD/both"

echo "--- Python: the first on the search path"
show='import littoral; s = littoral.vtkTurningBandsTerrainSource(); s.Update(); print(littoral.__version__)'
for pair in "$a $b" "$b $a"; do
  read -r first second <<<"$pair"
  expect "$(version "$first")" "$(PYTHONPATH=$(python_of "$first"):$(python_of "$second") /usr/bin/python3 -c "$show")"
done

echo "--- plugin: the first on the search path, the second is refused in one line"
terrain='from paraview import simple; t = simple.TurningBandsTerrain(); t.UpdatePipeline(); print("terrain")'
for pair in "$a $b" "$b $a"; do
  read -r first second <<<"$pair"
  said=$(PV_PLUGIN_PATH=$(plugin_of "$first"):$(plugin_of "$second") pvpython -c "$terrain" 2>&1)
  expect terrain "$said"
  [ "$(grep -c "Littoral $(version "$second") was not loaded: there is another one, $(plugin_of "$first")" <<<"$said")" = 1 ]
  # The plugin of one and the Python package of the other, in one process.
  said=$(PV_PLUGIN_PATH=$(plugin_of "$first") PYTHONPATH=$(python_of "$second") pvpython -c "$terrain
$show" 2>&1)
  expect terrain "$said"
  expect "$(version "$second")" "$said"
done
echo "--- all done"
