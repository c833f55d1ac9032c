# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs cases in a process of their own, with limits of memory and time."""

import functools
import gc
import json
import os
import resource
import select
import signal
import sys
import tempfile
import time

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


def play(name, lines, tell):
    """Plays a case in this process, and tells the numbers of its lines and how it ended; whether it had no fault."""
    signal.setitimer(signal.ITIMER_PROF, PROCESSOR)
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


def child(name, batch, answer, errors):
    """What the child does: plays cases up to the first fault."""
    limit()
    os.dup2(errors, 2)
    os.dup2(errors, 1)
    tell = lambda what: os.write(answer, (json.dumps(what) + "\n").encode())  # noqa: E731
    for lines in batch:
        if not play(name, lines, tell):
            break
        gc.collect()  # the object of the case


def listen(answer, process):
    """All that the child answers; it is killed when it is silent for too long."""
    text = b""
    while select.select([answer], [], [], PATIENCE)[0]:
        part = os.read(answer, 65536)
        if not part:
            return text.decode().splitlines()
        text += part
    os.kill(process, signal.SIGKILL)
    return text.decode().splitlines()


@functools.lru_cache(maxsize=None)
def prepare(name):
    """Plays the shortest case of a class here, so that what it loads and keeps is there in all processes to come."""
    with tempfile.TemporaryDirectory() as folder:
        before = os.getcwd()
        os.chdir(folder)
        try:
            oracle.play(name, cases.opening(name) + ["update()", "finish()"])
        except oracle.Fault:
            pass  # the cases will tell
        finally:
            os.chdir(before)
    gc.collect()
    gc.freeze()


def run_batch(name, batch):
    """Plays cases one after the other in one process, up to the first fault: for each that was played the kind of fault,
    "" if there is none, and what it was."""
    for lines in batch:
        recipes.warm(name, lines)
    prepare(name)
    answer, to_answer = os.pipe()
    with tempfile.TemporaryFile() as errors:
        sys.stdout.flush()
        process = os.fork()
        if process == 0:
            try:
                child(name, batch, to_answer, errors.fileno())
            finally:
                os._exit(0)
        os.close(to_answer)
        answers = [json.loads(line) for line in listen(answer, process)]
        os.close(answer)
        _, status = os.waitpid(process, 0)
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip().splitlines()
    ends = [tuple(answer) for answer in answers if isinstance(answer, list)]
    if os.WIFSIGNALED(status):
        lines = batch[min(len(ends), len(batch) - 1)]
        number = answers[-1] if answers and isinstance(answers[-1], int) else len(lines)
        where = lines[number] if number < len(lines) else "the fresh object"
        which = signal.Signals(os.WTERMSIG(status)).name
        kind = "hang" if which in ("SIGPROF", "SIGKILL") else "crash"
        ends.append((kind, f"{which} in {where}" + (f": {said[-1]}" if said else "")))
    return ends


def run(name, lines):
    """Plays a case in a process of its own: the kind of fault, "" if there is none, and what it was."""
    return run_batch(name, [lines])[-1]
