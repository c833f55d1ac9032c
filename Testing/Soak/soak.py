# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A long session: random steps through a land and a sea.

    ./littoral soak [STEPS] [--samples N] [--seed S]

A step changes the time, the camera or a setting, and shows all. At samples, objects that are made anew with the same
settings must put out the same bytes. At ten rests all settings are as at the beginning, and the memory of the process
must be that of the first rest within 2 %. Each scene runs on one thread and on two, in processes of their own, and must
put out the same at all samples.
"""

import argparse
import ctypes
import gc
import hashlib
import os
import random
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(HERE), "Fuzz"), os.path.join(os.path.dirname(HERE), "Hashes")]

#: Growth of the memory between the first rest and any later one that counts as a leak.
GROWTH = 0.02
RESTS = 10
#: Steps before the first, in which libraries are loaded and buffers grow.
WARM_UP = 30
TIMES = [0.1 * k for k in range(41)]  # [s]


class Settings:
    """What a session has set so far: the values of the parts, the camera and the time."""

    def __init__(self, parts):
        self.parts = parts
        self.values = {(name, method): values[0] for name, part in parts.items() for method, values in part.changes.items()}
        self.place = (20.0, -10.0, 6.0)
        self.time = 0.0

    def step(self, rng):
        """Change one thing."""
        what = rng.random()
        if what < 0.4:
            self.time = rng.choice(TIMES)
        elif what < 0.65:
            self.place = (rng.uniform(-30.0, 60.0), rng.uniform(-30.0, 60.0), rng.uniform(-8.0, 30.0))
        else:
            name, method = rng.choice(sorted(self.values))
            self.values[name, method] = rng.choice(self.parts[name].changes[method])

    def show(self, scene):
        """Show the scene with these settings: setting what is set already changes nothing."""
        for (name, method), values in self.values.items():
            scene.change(name, method, values)
        scene.look_from(self.place)
        scene.show(self.time)


def memory():
    """What the process itself has written to [bytes], without what its allocator could hand back.

    Pages of libraries do not count: how many of them are mapped depends on what else the machine reads.
    """
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/status", encoding="ascii") as status:
        kilobytes = next(line.split()[1] for line in status if line.startswith("RssAnon:"))
    return 1024 * int(kilobytes)


def outputs(scene):
    from oracle import bytes_of

    return [line for made in scene.shown() for line in bytes_of(made)]


def soak(name, steps, samples, seed):
    """A session of one scene; prints a line for each sample and rest."""
    from scenes import SCENES, Scene

    parts = SCENES[name]
    rng = random.Random(f"{name} {seed}")
    scene, settings = Scene(parts), Settings(parts)
    for _ in range(WARM_UP):
        settings.step(rng)
        settings.show(scene)
    outputs(scene)
    first, most = 0, 0
    for number in range(1, steps + 1):
        settings.step(rng)
        settings.show(scene)
        if number % max(1, steps // samples) == 0:
            fresh = Scene(parts)
            settings.show(fresh)
            found, wanted = outputs(scene), outputs(fresh)
            if found != wanted:
                other = sorted(set(found) ^ set(wanted))
                sys.exit(f"{name}, step {number}: other bytes than fresh objects': {other[:4]}")
            print(f"sample {number} {hashlib.sha256(repr(found).encode()).hexdigest()}", flush=True)
            del fresh
        if number % max(1, steps // RESTS) == 0:
            Settings(parts).show(scene)
            now = memory()
            first = first or now
            most = max(most, now)
            if now > (1.0 + GROWTH) * first:
                sys.exit(f"{name}, step {number}: {now / 1e6:.1f} MB after {first / 1e6:.1f} MB")
            settings.show(scene)
    print(f"memory {first} {most}")


def run(name, steps, samples, seed, threads):
    """The samples of a session in a process of its own, and its memory at the first rest and at most [bytes]."""
    command = [sys.executable, os.path.abspath(__file__), str(steps), "--samples", str(samples), "--seed", str(seed),
               "--scene", name]
    # One heap for all threads: the allocator hands back the end of the main one alone.
    environment = {**os.environ, "VTK_SMP_MAX_THREADS": str(threads), "MALLOC_ARENA_MAX": "1"}
    ran = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        sys.exit(f"{threads} threads: {ran.stderr.strip() or ran.returncode}")
    lines = [line.split() for line in ran.stdout.splitlines()]
    if ran.stderr.strip():
        sys.exit(f"{name}: a message: {ran.stderr.strip()[:300]}")
    first, most = next(map(int, line[1:]) for line in lines if line[0] == "memory")
    return [line for line in lines if line[0] == "sample"], first, most


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("steps", type=int, nargs="?", default=10000)
    parser.add_argument("--samples", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scene", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.scene:
        soak(given.scene, given.steps, given.samples, given.seed)
        return
    for name in ("land", "sea"):
        former = None
        for threads in (1, 2):
            samples, first, most = run(name, given.steps, given.samples, given.seed, threads)
            print(f"{name}, {threads} thread(s): {given.steps} steps, {len(samples)} samples as fresh objects, "
                  f"{first / 1e6:.1f} MB, at most {most / first - 1.0:+.2%}", flush=True)
            if former not in (None, samples):
                sys.exit(f"{name}: other bytes with {threads} threads")
            former = samples


if __name__ == "__main__":
    main()
