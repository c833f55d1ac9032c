# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Which lines of the C++ code did the tests run?

    coverage.py BUILD measure          # runs the tests, and shows the two tables below
    coverage.py BUILD show [WORD...]   # what ran since the counters were cleared, of folders whose path holds a word
    coverage.py BUILD missing WORD...  # the lines that did not run, of files whose path holds one of the words
    coverage.py BUILD clear

BUILD is the folder of the preset `coverage`. `./littoral coverage` builds it and measures. The numerics, `Common`, are
measured by their own tests alone, the VTK classes by all of them; tests of the tier `all` do not count. A line counts as
run if any of the code that the compiler made of it ran, as an instance of a template or in another file that includes it.
The numbers are gcov's.
"""

import collections
import glob
import gzip
import itertools
import json
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

#: Folders, and the tests (labels of ctest) that they are measured by, in this order, without clearing between.
TABLES = [(["Common"], "common"), (["Support", "Sources", "Filters", "Rendering", "IO"], "cxx|python")]

#: Tests of programs that must be silent: the counters complain where another user or a full disk cannot write them.
SILENT = "^python.Test(Faults|Files)$"

#: Objects whose counters are read: those of the code and of the tests, which instantiate templates.
OBJECTS = ["Common", "Support", "Sources", "Filters", "Rendering", "IO", os.path.join("Testing", "Common"),
           os.path.join("Testing", "Cxx")]


def clear(build):
    """Forget what ran."""
    for path in glob.glob(os.path.join(build, "**", "*.gcda"), recursive=True):
        os.remove(path)


def read_counts(build):
    """Counts of the runs of each line of each file: {file: {line: count}}, by paths from the top folder."""
    counts = collections.defaultdict(collections.Counter)
    notes = [path for folder in OBJECTS
             for path in glob.glob(os.path.join(build, folder, "**", "*.gcno"), recursive=True)]
    if not notes:
        sys.exit(f"{build} was not built with the preset `coverage`.")
    with tempfile.TemporaryDirectory() as folder:
        for start in range(0, len(notes), 16):
            part = [os.path.abspath(path) for path in notes[start:start + 16]]
            subprocess.run(["gcov", "--json-format", "--hash-filenames", "--preserve-paths", *part], cwd=folder,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
            for path in glob.glob(os.path.join(folder, "*.gcov.json.gz")):
                add_counts(counts, path)
                os.remove(path)
    return counts


def add_counts(counts, path):
    """Add what gcov says of one object."""
    with gzip.open(path, "rt", encoding="utf-8") as file:
        told = json.load(file)
    for source in told["files"]:
        name = os.path.relpath(os.path.join(told["current_working_directory"], source["file"]), SOURCE)
        if any(name.startswith(folder + os.sep) for folders, _ in TABLES for folder in folders):
            lines = counts[name]
            for line in source["lines"]:
                lines[line["line_number"]] += line["count"]


def share(lines):
    """(lines that ran, lines, percent)."""
    ran = sum(1 for count in lines if count > 0)
    return ran, len(lines), 100.0 * ran / max(1, len(lines))


def show(counts, words):
    """Tables of folders and of their files, the least covered first."""
    rooms = collections.defaultdict(list)
    for name in counts:
        rooms[os.path.dirname(name)].append(name)
    rooms = {room: names for room, names in rooms.items() if any(word in room for word in words)}
    for room, names in sorted(rooms.items()):
        print("{2:6.1f} %  {0:6d} of {1:6d}  {3}".format(
            *share([count for name in names for count in counts[name].values()]), room))
    names = [name for names in rooms.values() for name in names]
    print("{2:6.1f} %  {0:6d} of {1:6d}  together".format(
        *share([count for name in names for count in counts[name].values()])))
    print("Files with the most lines that did not run:")
    for name in sorted(names, key=lambda name: share(counts[name].values())[0] - len(counts[name]))[:20]:
        print("{2:6.1f} %  {0:6d} of {1:6d}  {3}".format(*share(counts[name].values()), name))


def show_missing(counts, words):
    """The text of the lines that did not run."""
    for name in sorted(name for name in counts if any(word in name for word in words)):
        missing = sorted(line for line, count in counts[name].items() if count == 0)
        if not missing:
            continue
        print("{3}  {2:.1f} %, {0} of {1}".format(*share(counts[name].values()), name))
        with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
            text = file.read().splitlines()
        for _, group in itertools.groupby(enumerate(missing), lambda pair: pair[1] - pair[0]):
            for _, line in group:
                print(f"  {line:5d}  {text[line - 1]}")


def run_tests(build, labels):
    """Run the tests with these labels; all must pass."""
    subprocess.run([os.path.join(build, "bin", "littoral-env"), "xvfb-run", "-a", "-s",
                    "-screen 0 1280x1024x24 -noreset", "ctest", "--test-dir", build, "--no-tests=error",
                    "--output-on-failure", "--parallel", str(os.cpu_count()), "-L", labels, "-LE", "^all$",
                    "--exclude-regex", SILENT], check=True)


def measure(build):
    """Run the tests of each table, and show it."""
    clear(build)
    for folders, labels in TABLES:
        run_tests(build, labels)
        show(read_counts(build), folders)


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in ("measure", "show", "missing", "clear"):
        sys.exit(__doc__)
    build, task, words = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
    if task == "measure":
        measure(build)
    elif task == "clear":
        clear(build)
    elif task == "show":
        show(read_counts(build), words or [""])
    else:
        show_missing(read_counts(build), words or [""])


if __name__ == "__main__":
    main()
