#!/usr/bin/env bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Faults that tools find by reading C++. Run from the top folder:
#
#   Testing/Hygiene/lint.sh cppcheck                     all code but the tests
#   Testing/Hygiene/lint.sh clang-tidy BUILD             lines of the latest work, in the two sources that changed most
#   Testing/Hygiene/lint.sh clang-tidy BUILD FILE...     whole files
#   Testing/Hygiene/lint.sh clang++ BUILD                the numerics in plain C++17, as another compiler and library see it
#
# BUILD is a build tree. The latest work is what differs from where the branch left main; on main itself, from the commit
# before the last; and what is not committed. clang-tidy takes some 10 s for a source, which is why it reads two. Ends
# with 125 (skipped) where the tool, the build or the history is missing.
set -euo pipefail

skip() {
  echo "skipped: $1" >&2
  exit 125
}

# The commit where the latest work begins.
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

# line_filter COMMIT: the lines that are new since then, as clang-tidy wants to be told.
line_filter() {
  git diff -U0 --diff-filter=d --no-color --no-ext-diff "$1" -- '*.cxx' '*.h' | awk '
    /^\+\+\+ b\// { name = substr($0, 7); next }
    /^@@ / {
      split(substr($3, 2), range, ",")
      count = range[2] == "" ? 1 : range[2]
      if (count > 0)
        lines[name] = lines[name] (lines[name] ? "," : "") "[" range[1] "," range[1] + count - 1 "]"
    }
    END {
      printf "["
      for (name in lines)
        printf "%s{\"name\":\"%s\",\"lines\":[%s]}", many++ ? "," : "", name, lines[name]
      print "]"
    }'
}

# Sources that a build tree compiles, alone or together with others; for the latter clang-tidy takes a neighbour's
# command.
known_to() { # BUILD, names on standard input
  while read -r name; do
    grep -qsF "\"$PWD/$name\"" "$1/compile_commands.json" "$1"/Common/CMakeFiles/LittoralCommon.dir/Unity/*.cxx &&
      echo "$name"
  done || true
}

# The commands of a build tree in a folder of their own, without headers that GCC has compiled: clang reads sources.
plain_commands() { # BUILD
  commands=$(mktemp -d)
  trap 'rm -rf "$commands"' EXIT
  sed 's/ -Winvalid-pch -include [^ ]*cmake_pch\.hxx//' "$1/compile_commands.json" >"$commands/compile_commands.json"
}

run_clang_tidy() { # BUILD [FILE...]
  local build=${1:?a build tree} from filter files
  shift
  [ -f "$build/compile_commands.json" ] || skip "there is no $build/compile_commands.json"
  plain_commands "$build"
  if [ $# -gt 0 ]; then
    printf '%s\n' "$@" | xargs -P "$(nproc)" -n 1 clang-tidy -p "$commands" --quiet
    return
  fi
  git rev-parse -q --verify HEAD >/dev/null 2>&1 || skip "this is no git repository"
  from=$(base)
  filter=$(line_filter "$from")
  files=$(git diff --numstat --diff-filter=d "$from" -- '*.cxx' | sort -k1,1nr -k3 | cut -f3 | known_to "$build" |
    sed -n 1,2p)
  echo "since $(git log -1 --format='%h, %s' "$from"):" ${files:-no sources}
  [ -z "$files" ] || xargs -P "$(nproc)" -n 1 clang-tidy -p "$commands" --quiet --line-filter="$filter" <<<"$files"
}

run_cppcheck() {
  # Headers of libraries are not read: their macros are unknown, their functions may do anything.
  git ls-files -- '*.cxx' ':!Testing' | xargs cppcheck --quiet --std=c++17 --language=c++ -j "$(nproc)" \
    --enable=warning,performance,portability --suppressions-list=Testing/Hygiene/cppcheck.txt --error-exitcode=1 \
    -ICommon -ISupport -ISources -IFilters -IIO -Iparaview-plugin/ClientProxies -Iparaview-plugin/Representations
}

# Common without extensions of GCC, and with the standard library of LLVM, which macOS has.
run_clang() { # BUILD
  local build=${1:?a build tree}
  [ -d "$build/Common/Tables" ] || skip "there is no $build/Common/Tables"
  clang++ -stdlib=libc++ -fsyntax-only -x c++ - <<<'#include <vector>' 2>/dev/null || skip "libc++ is not installed"
  git ls-files -- 'Common/*.cxx' ':!*/FftwLines.cxx' | xargs -P "$(nproc)" -n 8 clang++ -std=c++17 -pedantic-errors -Wall -Wextra -Werror \
    -stdlib=libc++ -fsyntax-only -DGLM_FORCE_INLINE -I"$build/Common/Tables" -ICommon -isystem /usr/include/eigen3
}

tool=${1:?cppcheck, clang-tidy or clang++}
shift
command -v "$tool" >/dev/null || skip "$tool is not installed"
case "$tool" in
  cppcheck) run_cppcheck ;;
  clang-tidy) run_clang_tidy "$@" ;;
  clang++) run_clang "$@" ;;
  *) skip "there is no tool '$tool' here" ;;
esac
