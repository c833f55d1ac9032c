# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Break formulas one by one: do the tests notice?

    ./littoral mutate [WORD...]

builds and tests each mutation of the lists `*.txt` beside this file, or those whose file or text holds one of the words,
in a copy of the tree. A mutation is killed by a build that fails or a test that fails; a survivor shows a formula that
no test looks at. A list names a file and its mutations:

    Common/Sea/WaveNumber.cxx
    - std::tanh(k * depth)
    + std::tanh(2.0 * k * depth)
    ? common.(WaveNumber|SeaState)

`-` is a piece of a line that stands once in the file, or the whole line, and `+` what stands there instead. First the
tests of that room of Common are asked, and then, unless one of them fails, all of `ctest -L "common|cxx"`, or those of a
line `?` with a regular expression. A mutation that no test can notice, since the results are the same, has a line `=`
with the reason.
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
    """The programs that test the room of a file in Common; none elsewhere."""
    room = os.path.join(COPY, "Testing", os.path.dirname(mutation.file))
    return [os.path.splitext(os.path.basename(name))[0] for name in sorted(glob.glob(os.path.join(room, "Test*.cxx")))]


def run(command, log):
    """Whether a command succeeds; its output goes into a file."""
    with open(log, "wb") as output:
        try:
            return subprocess.run(command, cwd=COPY, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                  check=False, timeout=LONGEST).returncode == 0
        except subprocess.TimeoutExpired:  # a loop without an end is noticed
            return False


def prepare():
    """A copy of the tree as it is, with its own build."""
    os.makedirs(COPY, exist_ok=True)
    for entry in os.scandir(COPY):
        if entry.is_dir() and entry.name != "build":
            shutil.rmtree(entry)
    for entry in os.scandir(SOURCE):
        if entry.is_file():
            shutil.copy2(entry, COPY)
        elif entry.name not in (".git", "build"):
            shutil.copytree(entry, os.path.join(COPY, entry.name))
    log = os.path.join(COPY, "build-mutation.log")
    if not run(["cmake", "--preset", "release", "-DLITTORAL_BUILD_HELP=OFF"], log) or not build(log):
        sys.exit(f"The tree does not build, see {log}")


def build(log, targets=("all",)):
    return run(["cmake", "--build", "build", "--target", *targets], log)


def fails_a_test(mutation, log):
    """Whether one of the tests fails, those of the room first."""
    environment = os.path.join(COPY, "build", "bin", "littoral-env")
    programs = room_tests(mutation)
    if programs and (not build(log, programs) or any(
            not run([environment, os.path.join("build", "bin", program), "--gtest_fail_fast"], log)
            for program in programs)):
        return True
    chosen = ["-R", mutation.tests] if mutation.tests else ["-L", "common|cxx"]
    return not build(log) or not run(
        [environment, "xvfb-run", "-a", "ctest", "--test-dir", "build", "--stop-on-failure", "--no-tests=error",
         "--parallel", str(os.cpu_count()), *chosen], log)


def is_killed(mutation):
    """Whether the build or a test fails once a mutation is made."""
    name, log = os.path.join(COPY, mutation.file), os.path.join(COPY, "build-mutation.log")
    with open(name, encoding="utf-8") as file:
        whole = file.read()
    at = place(whole, mutation.old)
    try:
        with open(name, "w", encoding="utf-8") as file:
            file.write(whole[:at] + mutation.new + whole[at + len(mutation.old):])
        return fails_a_test(mutation, log)
    finally:
        with open(name, "w", encoding="utf-8") as file:
            file.write(whole)


def main(words):
    """Try all mutations with one of the words; exit code 1 if one survives that should not."""
    mutations = [one for one in read_all()
                 if not words or any(word in one.file or word in one.old for word in words)]
    unfit = [reason for reason in map(why_unfit, mutations) if reason]
    if unfit:
        sys.exit("\n".join(unfit))
    prepare()
    begin, survivors, killed = time.time(), [], 0
    for number, mutation in enumerate(mutations):
        dead = is_killed(mutation)
        killed += dead
        if dead == bool(mutation.reason):
            survivors.append(mutation)
        word = "killed" if dead else "the same" if mutation.reason else "SURVIVED"
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
