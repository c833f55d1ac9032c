# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs cases in a process of their own, with limits of memory and time."""

import atexit
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
DONE = "done"  # a batch


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


def child():
    """What the process does: plays the cases that it reads, up to the first fault, and answers in place of all output."""
    answer = os.dup(1)
    os.dup2(2, 1)
    tell = lambda what: os.write(answer, (json.dumps(what) + "\n").encode())  # noqa: E731
    for line in sys.stdin:
        name, batch, most = json.loads(line)
        prepare(name, batch)
        limit()
        for lines in batch:
            if not play(name, lines, tell, most):
                os._exit(0)
            gc.collect()  # the object of the case
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        tell(DONE)


class Process:
    """A new process and no fork, since libraries have threads."""

    def __init__(self):
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen([sys.executable, "-B", __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=self.errors)

    def ask(self, *what):
        """All that it answers, and whether that was all; it is killed when it is silent for too long."""
        self.process.stdin.write((json.dumps(what) + "\n").encode())
        self.process.stdin.flush()
        text = b""
        while select.select([self.process.stdout], [], [], PATIENCE)[0]:
            part = os.read(self.process.stdout.fileno(), 65536)
            text += part
            answers = text.decode().splitlines()
            if not part or answers[-1:] == [json.dumps(DONE)] and text.endswith(b"\n"):
                break
        else:
            self.process.kill()
        answers = [json.loads(line) for line in text.decode().splitlines()]
        return [one for one in answers if one != DONE], DONE in answers

    def end(self):
        """Its status and the last line of its output."""
        self.process.communicate()
        self.errors.seek(0)
        said = self.errors.read().decode(errors="replace").strip().splitlines()
        self.errors.close()
        if self.process.returncode > 0:
            raise RuntimeError("\n".join(said))
        return self.process.returncode, said[-1] if said else ""


idle = []  # a process without a fault so far goes on with the next batch


@atexit.register
def end_idle():
    while idle:
        idle.pop().end()


def run_batch(name, batch, alone=False):
    """Plays cases one after the other in one process, up to the first fault: for each that was played the kind of fault,
    "" if there is none, and what it was."""
    process = idle.pop() if idle and not alone else Process()
    answers, is_done = process.ask(name, batch, PROCESSOR)
    ends = [tuple(answer) for answer in answers if isinstance(answer, list)]
    if is_done and not alone:
        idle.append(process)
        return ends
    status, said = process.end()
    if status < 0:
        lines = batch[min(len(ends), len(batch) - 1)]
        number = answers[-1] if answers and isinstance(answers[-1], int) else len(lines)
        where = lines[number] if number < len(lines) else "the fresh object"
        which = signal.Signals(-status).name
        kind = "hang" if which in ("SIGPROF", "SIGKILL") else "crash"
        ends.append((kind, f"{which} in {where}" + (f": {said}" if said else "")))
    return ends


def run(name, lines):
    """Plays a case in a process of its own: the kind of fault, "" if there is none, and what it was."""
    return run_batch(name, [lines], alone=True)[-1]


if __name__ == "__main__":
    child()
