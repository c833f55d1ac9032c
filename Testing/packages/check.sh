#!/bin/bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Uses an installed Littoral as its users do, without a display: check.sh FOLDER [ARCHIVE]
# With an archive that is unpacked below FOLDER and used as its INSTALL.txt says, else with what is in the system.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
mkdir -p "$1"
cd "$1"
demo=littoral-demo
if [ $# -gt 1 ]; then
  mkdir -p "some where"
  tar -C "some where" -xzf "$2"
  prefix=$(readlink -f "some where"/littoral-*)
  demo=$prefix/bin/littoral-demo
  # The variables are those that INSTALL.txt names.
  variable() { sed -n "s|.*$1=<this folder>\(/[^ ,]*\)\{0,1\}[ ,.]*.*|$prefix\1|p" "$prefix/INSTALL.txt"; }
fi

echo "--- littoral-demo"
begin=$(date +%s)
"$demo" demo.png
echo "littoral-demo: $(($(date +%s) - begin)) s"
[ "$(identify -format '%[fx:standard_deviation > 0.05]' demo.png)" = 1 ]

if [ $# -gt 1 ]; then
  PV_PLUGIN_PATH=$(variable PV_PLUGIN_PATH)
  PYTHONPATH=$(variable PYTHONPATH)
  CMAKE_PREFIX_PATH=$(variable CMAKE_PREFIX_PATH)
  CMAKE_PREFIX_PATH=${CMAKE_PREFIX_PATH%.}
  export PV_PLUGIN_PATH PYTHONPATH CMAKE_PREFIX_PATH
fi

echo "--- the plugin in pvpython, pvbatch and a server with its client"
pvpython "$here/check_plugin.py"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvbatch "$here/check_plugin.py"
port=$((20000 + $$ % 10000))
pvserver --server-port=$port >server.log 2>&1 &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
sleep 5
pvpython "$here/check_plugin.py" $port
wait $server || true

echo "--- the Python package"
for python in /usr/bin/python3 pvpython; do
  $python -c '
import littoral
from littoral import vtkTurningBandsTerrainSource
source = vtkTurningBandsTerrainSource()
source.Update()
low, high = source.GetOutput().GetPointData().GetScalars().GetRange()
assert high - low > 50.0
print(littoral.__version__, littoral.__file__)'
done

echo "--- a program"
cmake -G Ninja -S "$here/../../Examples/Cxx" -B example-build >cmake.log || { cat cmake.log; exit 1; }
cmake --build example-build
./example-build/GrowTerrain terrain.vti
test -s terrain.vti

echo "--- the window"
xvfb-run -a -s "-screen 0 1400x900x24 -noreset" "$here/window.sh"
echo "--- all done"
