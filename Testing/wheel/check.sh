#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs a wheel in a new virtual environment, draws a first image, and runs the tests in Python from there:
#
#   check.sh WHEEL FOLDER [ARGUMENT...]      further arguments go to ctest; FOLDER must be new
#
# The environment sees the VTK and NumPy of the system. Figures go into FOLDER/figures.txt.
set -euo pipefail
wheel=$(readlink -f "$1")
top=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
mkdir "$2"
cd "$2"
shift 2
python=$PWD/venv/bin/python

echo "--- from nothing to an image"
begin=$(date +%s%N)
python3 -m venv --system-site-packages venv
venv/bin/pip install --no-index "$wheel"
"$python" "$top/Examples/Python/sea_surface.py" .
end=$(date +%s%N)

echo "--- what is installed"
"$python" "$top/Testing/wheel/check_contents.py" "$wheel" "$top"

echo "--- tests"
cmake -G Ninja -S "$top/Testing/wheel" -B tests "-DPython3_EXECUTABLE=$python"
status=0
ctest --test-dir tests -LE '^all$' --output-on-failure --parallel "$(nproc)" "$@" | tee tests.txt || status=$?
{
  echo "environment, installation and first image: $(((end - begin) / 100000000))e-1 s"
  sed -n 's/.*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\).*/tests: \2, \1 failed/p' tests.txt
  sed -n '/did not run/,$ p' tests.txt
  echo "load of the machine meanwhile: $(cut -d' ' -f1-3 /proc/loadavg), of $(nproc) cores"
} | tee figures.txt
exit $status
