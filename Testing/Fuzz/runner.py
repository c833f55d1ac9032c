# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a case in a process of its own, with limits of memory and time."""

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
    signal.setitimer(signal.ITIMER_PROF, PROCESSOR)


def child(name, lines, answer, errors):
    """What the child does: plays the case, and answers with the numbers of its lines and with the fault."""
    limit()
    os.dup2(errors, 2)
    os.dup2(errors, 1)
    tell = lambda what: os.write(answer, (json.dumps(what) + "\n").encode())  # noqa: E731
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            tell(["", oracle.play(name, lines, tell)])
        except oracle.Fault as fault:
            tell(list(fault.args))
        except BaseException as error:  # pylint: disable=broad-except
            tell(["exception", f"{type(error).__name__}: {error}"])


def listen(answer, process):
    """All that the child answers; it is killed when it takes too long."""
    text, end = b"", time.monotonic() + PATIENCE
    while select.select([answer], [], [], max(0.0, end - time.monotonic()))[0]:
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


def run(name, lines):
    """Plays a case: the kind of fault, "" if there is none, and what it was."""
    recipes.warm(name, lines)
    prepare(name)
    answer, to_answer = os.pipe()
    with tempfile.TemporaryFile() as errors:
        sys.stdout.flush()
        process = os.fork()
        if process == 0:
            try:
                child(name, lines, to_answer, errors.fileno())
            finally:
                os._exit(0)
        os.close(to_answer)
        answers = [json.loads(line) for line in listen(answer, process)]
        os.close(answer)
        _, status = os.waitpid(process, 0)
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip().splitlines()
    if os.WIFSIGNALED(status):
        number = answers[-1] if answers and isinstance(answers[-1], int) else len(lines)
        where = lines[number] if number < len(lines) else "the fresh object"
        which = signal.Signals(os.WTERMSIG(status)).name
        kind = "hang" if which in ("SIGPROF", "SIGKILL") else "crash"
        return kind, f"{which} in {where}" + (f": {said[-1]}" if said else "")
    return tuple(answers[-1])
