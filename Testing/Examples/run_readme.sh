#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the commands of README.md word for word, in a folder that looks like the source tree and without make:
#   run_readme.sh SOURCE_DIR BUILD_DIR WORK_DIR
# The heavy ones, which are named below, are left to Testing/matrix/run.
set -euo pipefail
source_dir=$1 build_dir=$2 work=$3
heavy='^\./littoral (demo|test)( |$)|apt-get '

# A tree of links, but for the entry script, which finds its tree by where it is; the build tree is the given one.
rm -rf "$work"
mkdir -p "$work/tree" "$work/home" "$work/programs"
ln -s "$source_dir"/* "$work/tree/"
rm -f "$work/tree/littoral" "$work/tree/build"
cp "$source_dir/littoral" "$work/tree/"
ln -s "$build_dir" "$work/tree/build"

# A search path without make in any name.
IFS=: read -ra folders <<<"$PATH"
for ((k = ${#folders[@]} - 1; k >= 0; k--)); do
  find -L "${folders[k]}" -maxdepth 1 -type f ! -name '*make' -exec ln -sft "$work/programs" {} + 2>/dev/null || true
done
ln -sf "$(command -v cmake)" "$work/programs/"
# cmake needs its modules beside its real place, which a link leads to.
export PATH="$work/programs" HOME="$work/home"
if command -v make || command -v gmake; then
  echo "make is still there"
  exit 1
fi

cd "$work/tree"
block() { awk -v kind="$1" '$0 == "```" { inside = 0 } inside { print } $0 == "```" kind { inside = 1 }' "$source_dir/README.md"; }

# The Python lines, by the command that is named above them.
grep -qF 'Save these lines as `grow.py` and call `./littoral run pvpython grow.py`' "$source_dir/README.md"
block python >grow.py
./littoral run pvpython grow.py

commands=$(block sh | grep -vE "$heavy")
[ "$(wc -l <<<"$commands")" -ge 4 ]
while IFS= read -r command; do
  echo "\$ $command"
  bash -c "$command" </dev/null
done <<<"$commands"
test -s terrain.vti
