# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Break formulas one by one: do the tests notice?

    ./littoral mutate [--rooms] [WORD...]

builds and tests each mutation of the lists `*.txt` beside this file, or those whose file or text holds one of the words,
in a copy of the tree. A mutation is killed by a test that fails; a survivor shows a formula that no test looks at. One
that does not build shows nothing, and is a fault of its list. A list names a file and its mutations:

    Common/Sea/WaveNumber.cxx
    - std::tanh(k * depth)
    + std::tanh(2.0 * k * depth)
    ? Common/Currents/TestCurrents Cxx/TestSeaSurface

`-` is a piece of a line that stands once in the file, or the whole line, and `+` what stands there instead. First the
tests of that room of Common are asked, and those elsewhere that include the file's header; then, unless one of them
fails, those of a line `?`, or all of Testing/Cxx if there is none. With `--rooms` those of Testing/Cxx are not asked,
the copy is built without VTK, and the lists of files outside of Common are left out. Mutations of the plugin ask tests
of Testing/ParaView alone, as `ParaView/TestTextures`, in a build of their own, unless they name one of Testing/Cxx; so
do those that name tests of Testing/Python. A mutation that no test can notice, since the results are the same, has a
line `=` with the reason; it must survive. Tests of the tier `all` are asked where a list names them: a script that shares
a process with others in the standard tier has an entry of its own there.

Built are only the programs that are asked. A second run builds what has changed since the first.
"""

import collections
import filecmp
import glob
import os
import re
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
COPY = os.environ.get("LITTORAL_MUTATION", os.path.join(SOURCE, "build", "mutation"))

#: Time after which a program counts as failed [s].
LONGEST = 600

#: Build folders and their options: the rooms alone, or also the classes.
USUAL = ["-DLITTORAL_BUILD_BENCHMARKS=OFF", "-DLITTORAL_BUILD_HELP=OFF"]
ROOMS = ("build-rooms", ["-DLITTORAL_WITH_VTK=OFF", *USUAL])
ALL = ("build", ["-DLITTORAL_WITH_PYTHON=OFF", *USUAL])
PLUGIN = ("build-plugin", USUAL)

#: Folders of tests that are scripts.
SCRIPTS = ("ParaView", "Python")

#: What stands in place of a test that fails where nothing was shown: a mutation is no code, or a list names no test.
NO_CODE, NO_TEST = SHOWS_NOTHING = "NO CODE", "NO TEST"

#: The program of the tests in Testing/Cxx.
CLASSES = "LittoralCxxTests"

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
                mutations.append(Mutation(file, old, text, [], ""))
            elif kind == "? ":
                mutations[-1] = mutations[-1]._replace(tests=text.split())
            elif kind == "= ":
                mutations[-1] = mutations[-1]._replace(reason=text)
            elif line.strip() and not line.startswith("#"):
                file = line.strip()
    return mutations


def read_all():
    """The mutations of all lists."""
    return [mutation for path in sorted(glob.glob(os.path.join(HERE, "*.txt"))) for mutation in read_list(path)]


def place(text, old):
    """Place of a piece: as a whole line if there is one, else anywhere; -1 unless it stands there once."""
    for piece, before in ((f"\n{old}\n", 1), (old, 0)):
        if text.count(piece) == 1:
            return text.index(piece) + before
    return -1


def why_unfit(mutation, source=SOURCE):
    """Fault of a mutation; empty if it can be made."""
    try:
        with open(os.path.join(source, mutation.file), encoding="utf-8") as file:
            text = file.read()
    except OSError as error:
        return str(error)
    if mutation.old == mutation.new:
        return f"{mutation.file}: '{mutation.old}' is not changed"
    for test in mutation.tests:
        path = os.path.join(source, "Testing", test)
        if not os.path.isfile(path + (".py" if test.startswith(SCRIPTS) else ".cxx")):
            return f"{mutation.file}: there is no test {test}"
    return "" if place(text, mutation.old) >= 0 else f"{mutation.file}: '{mutation.old}' does not stand there once"


def room_tests(mutation):
    """The programs that test a file in Common: those with its name, those that include it, the others of its room, and
    those of its list."""
    room, name = os.path.split(mutation.file)
    stem = os.path.splitext(name)[0]
    header = f'#include "{os.path.basename(room)}/{stem}.h"'
    ranks = {}
    for path in sorted(glob.glob(os.path.join(SOURCE, "Testing", "Common", "*", "Test*.cxx"))):
        with open(path, encoding="utf-8") as file:
            includes = header in file.read()
        test = os.path.splitext(os.path.relpath(path, os.path.join(SOURCE, "Testing")))[0]
        own = os.path.dirname(test) == room
        program = os.path.basename(test)
        if test in mutation.tests or (room.startswith("Common") and (own or includes)):
            ranks[program] = (program != "Test" + stem, test not in mutation.tests, not includes, not own)
    return sorted(ranks, key=ranks.get)


def class_tests(mutation):
    """The arguments of ctest for the tests of classes that are asked; empty if none are."""
    if not mutation.tests:
        return ["-L", "cxx"]
    names = [os.path.basename(test) for test in mutation.tests if test.startswith("Cxx/")]
    return ["-R", f"Cxx-({'|'.join(names)})$"] if names else []


def plugin_tests(mutation):
    """The arguments of ctest for the scripts that are asked: those of the list."""
    names = [test.lower().split("/")[0] + "." + os.path.basename(test) for test in mutation.tests if test.startswith(SCRIPTS)]
    return ["-R", f"^({'|'.join(names)})$"] if names else ["-L", "paraview"]


def kind_of(mutation, rooms):
    """Build that shows a mutation."""
    of_plugin = mutation.file.startswith("paraview-plugin/") and not any(test.startswith("Cxx/") for test in mutation.tests)
    asks_python = any(test.startswith("Python/") for test in mutation.tests)
    return ROOMS if rooms else PLUGIN if of_plugin or asks_python else ALL


def run(command, log):
    """Whether a command succeeds; its output goes into a file."""
    with open(log, "wb") as output:
        try:
            return subprocess.run(command, cwd=COPY, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                  check=False, timeout=LONGEST).returncode == 0
        except subprocess.TimeoutExpired:  # a loop without an end is noticed
            return False


def mirror(source, copy, left=()):
    """Makes a folder like another one. Files that differ are written, and so built anew; the others stay as they are."""
    os.makedirs(copy, exist_ok=True)
    entries = {entry.name: entry for entry in os.scandir(source)
               if entry.name not in (".git", "__pycache__") and not entry.name.startswith(("build", "demo-output"))}
    for entry in os.scandir(copy):
        if entry.name not in entries and entry.name not in left:
            shutil.rmtree(entry) if entry.is_dir(follow_symlinks=False) else os.remove(entry)
    for name, entry in entries.items():
        to = os.path.join(copy, name)
        if entry.is_dir():
            mirror(entry.path, to)
        elif not os.path.exists(to) or not filecmp.cmp(entry.path, to, shallow=False):
            shutil.copy(entry.path, to)


def prepare(mutations, rooms):
    """A copy of the tree as it is, with its own builds."""
    mirror(SOURCE, COPY, [ROOMS[0], ALL[0], PLUGIN[0], "build-mutation.log"])
    log = os.path.join(COPY, "build-mutation.log")
    targets = collections.defaultdict(set)
    for mutation in mutations:
        folder, options = kind = kind_of(mutation, rooms)
        targets[folder, tuple(options)].update(targets_of(mutation, kind))
    for (folder, options), names in targets.items():
        configure = ["cmake", "--preset", "release", "-B", folder, *options]
        if not run(configure, log) or not build(log, folder, sorted(names)):
            sys.exit(f"The tree does not build, see {log}")


def targets_of(mutation, kind):
    """Targets that the tests of a mutation need."""
    if kind is PLUGIN:
        return ["all"]
    return [*room_tests(mutation), *([CLASSES] if kind is ALL and class_tests(mutation) else [])]


def build(log, folder, targets):
    return run(["cmake", "--build", folder, "--target", *targets], log)


def ctest(folder, *chosen):
    """The chosen tests of a build; of those chosen by a label, the ones that the standard tier has."""
    tier = ["-LE", "^all$"] if "-L" in chosen else []
    return ["ctest", "--test-dir", folder, "--stop-on-failure", "--no-tests=error", "--timeout", str(LONGEST), *tier, *chosen]


def failing_test(mutation, rooms, log):
    """First failure, those of the room before others: the build, a program or a test of a class; empty if there is none."""
    kind = kind_of(mutation, rooms)
    folder = kind[0]
    environment = os.path.join(COPY, folder, "bin", "littoral-env")
    programs = [] if kind is PLUGIN else room_tests(mutation)
    if programs and not build(log, folder, programs):
        return NO_CODE
    for program in programs:
        if not run([environment, *ctest(folder, "-R", rf"^common\.{program}(\.standard)?$")], log):
            return program
    chosen = {ROOMS[0]: [], PLUGIN[0]: plugin_tests(mutation)}.get(folder, class_tests(mutation))
    if not chosen:
        return ""
    if not build(log, folder, ["all"] if kind is PLUGIN else [CLASSES]):
        return NO_CODE
    if run([environment, "xvfb-run", "-a", *ctest(folder, "--parallel", str(os.cpu_count()), *chosen)], log):
        return ""
    with open(log, encoding="utf-8", errors="replace") as output:
        text = output.read()
    failed = re.findall(r"(?:Cxx-|paraview\.|python\.)(\w+) .*\*\*\*", text)
    return NO_TEST if "No tests were found" in text else " ".join(failed) or "ctest"


def killer_of(mutation, rooms):
    """First failure once a mutation is made; empty if nothing does."""
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
    mutations = [one for one in read_all() if not words or any(word in one.file or word in one.old for word in words)]
    mutations = [one for one in mutations if not rooms or one.file.startswith("Common/")]
    unfit = [reason for reason in map(why_unfit, mutations) if reason]
    if unfit:
        sys.exit("\n".join(unfit))
    prepare(mutations, rooms)
    begin, wrong = time.time(), []
    killed, tried, same = collections.Counter(), collections.Counter(), 0
    for number, mutation in enumerate(mutations):
        killer = killer_of(mutation, rooms)
        field = os.path.dirname(mutation.file)
        if mutation.reason:
            same += 1
        else:
            tried[field] += 1
            killed[field] += killer not in ("", *SHOWS_NOTHING)
        if bool(killer) == bool(mutation.reason) or killer in SHOWS_NOTHING:
            wrong.append(mutation)
        word = killer if killer in SHOWS_NOTHING else f"killed by {killer}" if killer else ""
        word = word or ("the same" if mutation.reason else "SURVIVED")
        left = (time.time() - begin) / (number + 1) * (len(mutations) - number - 1)
        print(f"[{number + 1} of {len(mutations)}, about {left / 60:.0f} min left] {word}: {mutation.file}: "
              f"{mutation.old.strip()}  ->  {mutation.new.strip()}", flush=True)
    for field in sorted(tried):
        print(f"  {field}: {killed[field]} of {tried[field]}")
    print(f"{sum(killed.values())} of {sum(tried.values())} mutations killed, {same} change no result")
    for mutation in wrong:
        print(f"  {mutation.file}\n  - {mutation.old}\n  + {mutation.new}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
