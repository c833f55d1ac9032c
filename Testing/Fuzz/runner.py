# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs cases in a process of their own, with limits of memory and time."""

import gc
import json
import os
import resource
import select
import signal
import subprocess
import sys
import tempfile

import cases
import oracle
import recipes

MEMORY = 3 << 30  # of addresses [bytes]
PROCESSOR = 20.0  # time of the processor, which does not depend on other programs [s]
PATIENCE = 300.0  # time on the wall [s]


def limit():
    """The limits of the process."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    signal.signal(signal.SIGPROF, signal.SIG_DFL)


def play(name, lines, tell, most):
    """Plays a case in this process, and tells the numbers of its lines and how it ended; whether it had no fault."""
    signal.setitimer(signal.ITIMER_PROF, most)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            tell(["", oracle.play(name, lines, tell)])
            return True
        except oracle.Fault as fault:
            tell(list(fault.args))
        except BaseException as error:  # pylint: disable=broad-except
            tell(["exception", f"{type(error).__name__}: {error}"])
        return False


def prepare(name, batch):
    """Plays the shortest case of a class, so that what it loads and keeps is there in all cases to come."""
    oracle.messages()  # VTK's from now on
    for lines in batch:
        recipes.warm(name, lines)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            oracle.play(name, cases.opening(name) + ["update()", "finish()"])
        except oracle.Fault:
            pass  # the cases will tell
    gc.collect()
    gc.freeze()


def child(name, most):
    """What the process does: plays the cases that it reads, up to the first fault, and answers in place of all output."""
    batch = json.load(sys.stdin)
    answer = os.dup(1)
    os.dup2(2, 1)
    prepare(name, batch)
    limit()
    tell = lambda what: os.write(answer, (json.dumps(what) + "\n").encode())  # noqa: E731
    for lines in batch:
        if not play(name, lines, tell, most):
            break
        gc.collect()  # the object of the case
    os._exit(0)


def listen(process):
    """All that the process answers; it is killed when it is silent for too long."""
    text = b""
    while select.select([process.stdout], [], [], PATIENCE)[0]:
        part = os.read(process.stdout.fileno(), 65536)
        if not part:
            return text.decode().splitlines()
        text += part
    process.kill()
    return text.decode().splitlines()


def run_batch(name, batch):
    """Plays cases one after the other in one process, up to the first fault: for each that was played the kind of fault,
    "" if there is none, and what it was. The process is a new one and no fork, since libraries have threads."""
    with tempfile.TemporaryFile("w+") as played, tempfile.TemporaryFile() as errors:
        json.dump(batch, played)
        played.seek(0)
        with subprocess.Popen([sys.executable, "-B", __file__, name, str(PROCESSOR)], stdin=played, stdout=subprocess.PIPE,
                              stderr=errors) as process:
            answers = [json.loads(line) for line in listen(process)]
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip().splitlines()
    ends = [tuple(answer) for answer in answers if isinstance(answer, list)]
    if process.returncode > 0:
        raise RuntimeError("\n".join(said))
    if process.returncode < 0:
        lines = batch[min(len(ends), len(batch) - 1)]
        number = answers[-1] if answers and isinstance(answers[-1], int) else len(lines)
        where = lines[number] if number < len(lines) else "the fresh object"
        which = signal.Signals(-process.returncode).name
        kind = "hang" if which in ("SIGPROF", "SIGKILL") else "crash"
        ends.append((kind, f"{which} in {where}" + (f": {said[-1]}" if said else "")))
    return ends


def run(name, lines):
    """Plays a case in a process of its own: the kind of fault, "" if there is none, and what it was."""
    return run_batch(name, [lines])[-1]


if __name__ == "__main__":
    child(sys.argv[1], float(sys.argv[2]))
