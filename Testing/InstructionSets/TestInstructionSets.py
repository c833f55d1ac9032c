# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""All classes give the same bytes with SSE2, with AVX2 and with the widest instructions of the processor.

    TestInstructionSets.py FOLDER [CLASS...]

FOLDER: of the libraries of numerics for lower sets (CMakeLists.txt); CLASS: without one, all classes. Compared are the
hashes of Testing/Hashes. Each run also tells which versions of functions the loader has chosen, as read from where it has
written their addresses.
"""

import collections
import ctypes
import glob
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
NAME = "libLittoralCommon"
SETS = "avx2", "avx512f"


def processor_sets():
    """Which of the sets the processor has."""
    with open("/proc/cpuinfo") as file:
        flags = next((line.split(":")[1].split() for line in file if line.startswith("flags")), [])
    return [name for name in SETS if name in flags]


def lines_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def chosen_versions():
    """How many functions of the library of numerics in this process run in a version for each set."""
    with open("/proc/self/maps") as maps:
        line = next(line for line in maps if NAME in line)
    base, library = int(line.split("-")[0], 16), line.split()[-1]
    symbols = {int(words[0], 16): words[2] for words in map(str.split, lines_of("nm", library)) if len(words) == 3}
    slots = [int(line.split()[0], 16) for line in lines_of("readelf", "-rW", library) if "R_X86_64_IRELATIV" in line]
    names = [symbols[ctypes.c_uint64.from_address(base + slot).value - base] for slot in slots]
    endings = (re.search(rf"\.({'|'.join(SETS)})$", name) for name in names)
    return collections.Counter(ending[1] if ending else "any" for ending in endings)


def run_here(names):
    """What each of the runs does."""
    sys.path.insert(0, os.path.join(HERE, "..", "Hashes"))
    import hash_outputs

    print(*(chosen_versions()[name] for name in (*SETS, "any")))
    hash_outputs.main(names or [row.name for row in hash_outputs.CASES])


def start(library, names):
    """A run with a library of numerics in place of the usual one; none: the usual one."""
    environment = {**os.environ, **({"LD_PRELOAD": library} if library else {})}
    return subprocess.Popen([sys.executable, __file__, "--run", *names], env=environment, stdout=subprocess.PIPE, text=True)


def end(run):
    """Numbers of versions by set, and the hashes of a run."""
    text = run.communicate()[0]
    assert run.returncode == 0, text[-300:]
    versions, *hashes = text.splitlines()
    return dict(zip((*SETS, "any"), map(int, versions.split()))), hashes


def main(folder, *names):
    has = processor_sets()
    libraries = {"sse2": glob.glob(os.path.join(folder, f"{NAME}-sse2.so"))[0]}
    if "avx512f" in has:
        libraries["avx2"] = glob.glob(os.path.join(folder, f"{NAME}-avx2.so"))[0]
    runs = {name: start(library, names) for name, library in (("widest", None), *libraries.items())}
    results = {name: end(run) for name, run in runs.items()}
    widest, wanted = results["widest"]
    assert len(wanted) > (50 if names else 1000)
    assert all(widest[name] > 0 for name in has), widest
    for name, (versions, hashes) in results.items():
        print(f"{name}: {versions}, {len(hashes)} arrays")
        assert name != "sse2" or versions["avx2"] == versions["avx512f"] == 0, versions
        assert name != "avx2" or versions["avx512f"] == 0 < versions["avx2"], versions
        different = [(one, other) for one, other in zip(wanted, hashes) if one != other]
        assert len(hashes) == len(wanted) and not different, (name, different[:5])


if sys.argv[1] == "--run":
    run_here(sys.argv[2:])
else:
    main(*sys.argv[1:])
