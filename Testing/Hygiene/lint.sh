#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Faults that a tool finds by reading C++. Run from the top folder:
#
#   Testing/Hygiene/lint.sh clang-tidy|cppcheck BUILD          files of the latest work
#   Testing/Hygiene/lint.sh clang-tidy|cppcheck BUILD all      all files, which takes long
#   Testing/Hygiene/lint.sh clang-tidy|cppcheck BUILD FILE...
#
# BUILD is a build tree with compile_commands.json. The latest work is what differs from where the branch left main; on
# main itself, from the commit before the last; and what is not committed. Of that, the sources that changed most are
# read: two by clang-tidy, which takes some 10 s for each, ten by cppcheck. Headers are read with the sources that
# include them. Ends with 125 (skipped) where the tool, the build or the history is missing.
set -euo pipefail

skip() {
  echo "skipped: $1"
  exit 125
}

tool=${1:?a tool}
build=${2:?a build tree}
shift 2
case "$tool" in
  clang-tidy) most=2 ;;
  cppcheck) most=10 ;;
  *) skip "there is no tool '$tool' here" ;;
esac
command -v "$tool" >/dev/null || skip "$tool is not installed"
[ -f "$build/compile_commands.json" ] || skip "there is no $build/compile_commands.json"

# Where the latest work begins.
base() {
  local main
  for main in origin/main main; do
    git rev-parse -q --verify "$main^{commit}" >/dev/null || continue
    if ! git merge-base --is-ancestor HEAD "$main"; then
      git merge-base HEAD "$main"
      return
    fi
  done
  git rev-parse -q --verify 'HEAD^' || skip "there is no commit before the last one here"
}

if [ "${1:-}" = all ]; then
  mapfile -t files < <(git ls-files '*.cxx')
elif [ $# -gt 0 ]; then
  files=("$@")
else
  git rev-parse -q --verify HEAD >/dev/null || skip "this is no git repository"
  from=$(base) || { echo "$from"; exit 125; }
  mapfile -t files < <(git diff --numstat --diff-filter=d "$from" -- '*.cxx' | sort -k1,1nr -k3 | head -n "$most" | cut -f3)
  echo "latest work: since $(git log -1 --format='%h, %s' "$from")"
fi
# Sources that this build leaves out have no command there.
known=()
for file in "${files[@]}"; do
  if grep -qF "\"$PWD/$file\"" "$build/compile_commands.json"; then
    known+=("$file")
  fi
done
echo "$tool: ${#known[@]} files"
[ "${#known[@]}" -gt 0 ] || exit 0

case "$tool" in
  clang-tidy)
    # Checks and reasons are in .clang-tidy.
    printf '%s\n' "${known[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p "$build" --quiet 2>/dev/null
    ;;
  cppcheck)
    # Headers of libraries are not read: their macros are unknown, their functions may do anything.
    cppcheck --quiet --std=c++17 --language=c++ --inline-suppr --error-exitcode=1 -j "$(nproc)" \
      --enable=warning,performance,portability --suppressions-list=Testing/Hygiene/cppcheck.txt \
      -ICommon -ISupport -ISources -IFilters -IIO --library=googletest "${known[@]}"
    ;;
esac
