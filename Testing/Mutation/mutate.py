# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Break formulas one by one: do the tests notice?

    ./littoral mutate [--rooms] [WORD...]

builds and tests each mutation of the lists `*.txt` beside this file, or those whose file or text holds one of the words,
in a copy of the tree. A mutation is killed by a build that fails or a test that fails; a survivor shows a formula that
no test looks at. A list names a file and its mutations:

    Common/Sea/WaveNumber.cxx
    - std::tanh(k * depth)
    + std::tanh(2.0 * k * depth)
    ? common.(WaveNumber|SeaState)

`-` is a piece of a line that stands once in the file, or the whole line, and `+` what stands there instead. First the
tests of that room of Common are asked, and those elsewhere that include the file's header; then, unless one of them
fails, all of `ctest -L "common|cxx"`, or those of a line `?` with a regular expression. With `--rooms` these are not
asked, and the copy is built without VTK. A mutation that no test can notice, since the results are the same, has a line
`=` with the reason.
"""

import collections
import glob
import os
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
COPY = os.environ.get("LITTORAL_MUTATION", os.path.join(SOURCE, "build", "mutation"))

#: Time after which a program counts as failed [s].
LONGEST = 1800

#: What is built, and with which options, for the tests of the rooms alone.
ROOMS = ("build-rooms", ["-DLITTORAL_WITH_VTK=OFF", "-DLITTORAL_BUILD_BENCHMARKS=OFF"])
ALL = ("build", [])

Mutation = collections.namedtuple("Mutation", "file old new tests reason")


def read_list(path):
    """The mutations of a list."""
    mutations, file, old = [], None, None
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            kind, text = line[:2], line[2:].rstrip("\n")
            if kind == "- ":
                old = text
            elif kind == "+ ":
                mutations.append(Mutation(file, old, text, "", ""))
            elif kind == "? ":
                mutations[-1] = mutations[-1]._replace(tests=text)
            elif kind == "= ":
                mutations[-1] = mutations[-1]._replace(reason=text)
            elif line.strip() and not line.startswith("#"):
                file = line.strip()
    return mutations


def read_all():
    """The mutations of all lists."""
    return [mutation for path in sorted(glob.glob(os.path.join(HERE, "*.txt"))) for mutation in read_list(path)]


def place(text, old):
    """Where a piece stands: as a whole line if there is one, else anywhere; -1 unless it stands there once."""
    for piece, before in ((f"\n{old}\n", 1), (old, 0)):
        if text.count(piece) == 1:
            return text.index(piece) + before
    return -1


def why_unfit(mutation, source=SOURCE):
    """What is wrong with a mutation; empty if it can be made."""
    try:
        with open(os.path.join(source, mutation.file), encoding="utf-8") as file:
            text = file.read()
    except OSError as error:
        return str(error)
    if mutation.old == mutation.new:
        return f"{mutation.file}: '{mutation.old}' is not changed"
    return "" if place(text, mutation.old) >= 0 else f"{mutation.file}: '{mutation.old}' does not stand there once"


def room_tests(mutation):
    """The programs that test a file in Common: those with its name, those that include it, the others of its room."""
    room, name = os.path.split(mutation.file)
    stem = os.path.splitext(name)[0]
    header = f'#include "{os.path.basename(room)}/{stem}.h"'
    ranks = {}
    for path in sorted(glob.glob(os.path.join(COPY, "Testing", "Common", "*", "Test*.cxx"))):
        with open(path, encoding="utf-8") as file:
            includes = header in file.read()
        own = os.path.relpath(os.path.dirname(path), os.path.join(COPY, "Testing")) == room
        program = os.path.splitext(os.path.basename(path))[0]
        if own or includes:
            ranks[program] = (program != "Test" + stem, not includes, not own)
    return sorted(ranks, key=ranks.get) if room.startswith("Common") else []


def run(command, log):
    """Whether a command succeeds; its output goes into a file."""
    with open(log, "wb") as output:
        try:
            return subprocess.run(command, cwd=COPY, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                  check=False, timeout=LONGEST).returncode == 0
        except subprocess.TimeoutExpired:  # a loop without an end is noticed
            return False


def prepare(mutations, rooms):
    """A copy of the tree as it is, with its own build."""
    folder, options = ROOMS if rooms else ALL
    os.makedirs(COPY, exist_ok=True)
    for entry in os.scandir(COPY):
        if entry.is_dir() and entry.name not in (ROOMS[0], ALL[0]):
            shutil.rmtree(entry)
    for entry in os.scandir(SOURCE):
        if entry.is_file():
            shutil.copy2(entry, COPY)
        elif entry.name != ".git" and not entry.name.startswith("build"):
            shutil.copytree(entry, os.path.join(COPY, entry.name))
    for mutation in read_all():  # as an earlier run may have left them broken, and built
        os.utime(os.path.join(COPY, mutation.file))
    log = os.path.join(COPY, "build-mutation.log")
    # Programs are not linked again when a library changes.
    configure = ["cmake", "--preset", "release", "-B", folder, "-DLITTORAL_BUILD_HELP=OFF",
                 "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON", *options]
    programs = sorted({program for mutation in mutations for program in room_tests(mutation)})
    if not run(configure, log) or not build(log, rooms, programs if rooms else ["all"]):
        sys.exit(f"The tree does not build, see {log}")


def build(log, rooms, targets):
    return run(["cmake", "--build", (ROOMS if rooms else ALL)[0], "--target", *targets], log)


def failing_test(mutation, rooms, log):
    """What fails, the tests of the room first: the build, a program or ctest; empty if nothing does."""
    folder = (ROOMS if rooms else ALL)[0]
    environment = os.path.join(COPY, folder, "bin", "littoral-env")
    programs = room_tests(mutation)
    if programs and not build(log, rooms, programs):
        return "the build"
    for program in programs:
        if not run([environment, os.path.join(folder, "bin", program), "--gtest_fail_fast"], log):
            return program
    if rooms:
        return ""
    if not build(log, rooms, ["all"]):
        return "the build"
    chosen = ["-R", mutation.tests] if mutation.tests else ["-L", "common|cxx"]
    return "" if run(
        [environment, "xvfb-run", "-a", "ctest", "--test-dir", folder, "--stop-on-failure", "--no-tests=error",
         "--parallel", str(os.cpu_count()), *chosen], log) else "ctest"


def killer_of(mutation, rooms):
    """What fails once a mutation is made; empty if nothing does."""
    name, log = os.path.join(COPY, mutation.file), os.path.join(COPY, "build-mutation.log")
    with open(name, encoding="utf-8") as file:
        whole = file.read()
    at = place(whole, mutation.old)
    try:
        with open(name, "w", encoding="utf-8") as file:
            file.write(whole[:at] + mutation.new + whole[at + len(mutation.old):])
        return failing_test(mutation, rooms, log)
    finally:
        with open(name, "w", encoding="utf-8") as file:
            file.write(whole)


def main(words):
    """Try all mutations with one of the words; exit code 1 if one survives that should not."""
    rooms = "--rooms" in words
    words = [word for word in words if word != "--rooms"]
    mutations = [one for one in read_all()
                 if not words or any(word in one.file or word in one.old for word in words)]
    unfit = [reason for reason in map(why_unfit, mutations) if reason]
    if unfit:
        sys.exit("\n".join(unfit))
    prepare(mutations, rooms)
    begin, survivors, killed = time.time(), [], 0
    for number, mutation in enumerate(mutations):
        killer = killer_of(mutation, rooms)
        dead = killer != ""
        killed += dead
        if dead == bool(mutation.reason):
            survivors.append(mutation)
        word = f"killed by {killer}" if dead else "the same" if mutation.reason else "SURVIVED"
        left = (time.time() - begin) / (number + 1) * (len(mutations) - number - 1)
        print(f"[{number + 1} of {len(mutations)}, about {left / 60:.0f} min left] {word}: {mutation.file}: "
              f"{mutation.old.strip()}  ->  {mutation.new.strip()}", flush=True)
    same = sum(bool(one.reason) for one in mutations)
    print(f"{killed} of {len(mutations) - same} mutations killed, {same} change no result")
    for mutation in survivors:
        print(f"  {mutation.file}\n  - {mutation.old}\n  + {mutation.new}")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
